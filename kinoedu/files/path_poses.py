"""The poses along a plan's path, as other programs want them: (x, y, theta), close together."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..errors import InvalidParameter
from ..geometry.checks import Array, positive
from ..problems import Plan
from ..problems.recorder import unwrap_recorder
from ..spaces import RealSpace, WrappingSpace
from ..support.text import shortened

MOST_STEPS = 1e6  # on a motion


def poses_along(plan: Plan, spacing: float | None = None) -> Array:
    """The poses along a path, from the start to the goal.

    A robot that does not turn looks where it goes. A drive follows its controls.

    Parameters
    ----------
    plan : a plan with a path of a robot in the plane.
    spacing : the greatest distance between poses, in the world's unit. By default a drive has poses
        a twentieth of the wheelbase apart, a car's path of curves a twentieth of the turning
        radius; other paths have their own points.

    Returns
    -------
    (n, 3)

    Raises
    ------
    InvalidParameter
        Where there is no path, the robot is an arm, or the spacing is much too small.

    Examples
    --------
    >>> from kinoedu import Point, Problem, Terrain
    >>> problem = Problem(Point(), Terrain([[1] * 9] * 9), (1, 1), (5, 1))
    >>> poses_along(Plan(np.array([(1.0, 1.0), (5.0, 1.0)]), 4.0, problem=problem), 2.0)
    array([[1., 1., 0.],
           [3., 1., 0.],
           [5., 1., 0.]])
    """
    if not isinstance(plan, Plan) or plan.path is None:
        raise InvalidParameter(f"a path is written of a plan that has one, got {shortened(plan)}")
    problem: Any = unwrap_recorder(plan.problem)
    space = getattr(problem, "space", None)
    is_arm = isinstance(space, WrappingSpace) and bool(space.wraps[0])
    if is_arm or plan.path.shape[1] not in (2, 3):
        raise InvalidParameter("poses are of a robot in the plane, not of an arm")
    step = None if spacing is None else positive(spacing, "spacing")
    if plan.trajectory is not None:
        drive: Any = plan.trajectory
        return np.asarray(drive.at(even_times(drive, step or drive.wheelbase / 20.0)))
    points = plan.path
    if plan.path.shape[1] == 3 and not isinstance(space, RealSpace | WrappingSpace | None):
        step = step or float(problem.robot.radius) / 20.0  # a car's path between poses is curved
    if step is not None and problem is not None:
        points = spread(problem, points, step)
    return points if points.shape[1] == 3 else with_headings(points)


def even_times(drive: Any, step: float) -> Array:
    """The times at which a drive is looked at, so that no two poses are farther apart."""
    begins = np.concatenate([[0.0], np.cumsum(drive.durations)])
    times = [begins[:1]]
    for k, (v, _) in enumerate(drive.controls):
        n = count_steps(abs(v) * drive.durations[k], step)
        times.append(np.linspace(begins[k], begins[k + 1], n + 1)[1:])
    return np.concatenate(times)


def count_steps(length: float, step: float) -> int:
    """How many steps a length has, at least one; raises InvalidParameter for too many."""
    if length > MOST_STEPS * step:
        raise InvalidParameter(f"a spacing of {step:g} makes too many poses; choose a larger one")
    return max(1, math.ceil(length / step))


def spread(problem: Any, points: Array, step: float) -> Array:
    """A path with further configurations on its motions."""
    spread_points = [points[0]]
    for a, b in zip(points[:-1], points[1:], strict=True):
        length = problem.distance(a, b)
        n = count_steps(length, step)
        spread_points += [problem.steer(a, b, k * length / n) for k in range(1, n)] + [b]
    return np.array(spread_points)


def with_headings(points: Array) -> Array:
    """Positions with the direction of the next motion; after the last motion, with its direction.

    A position that repeats the one before is no motion. Without any motion the direction is 0.
    """
    steps = np.diff(points, axis=0)
    moving = np.flatnonzero(steps.any(axis=1))
    if len(moving) == 0:
        return np.column_stack([points, np.zeros(len(points))])
    headings = np.array([math.atan2(dy, dx) for dx, dy in steps[moving]])
    following = np.searchsorted(moving, np.arange(len(points))).clip(max=len(moving) - 1)
    return np.column_stack([points, headings[following]])
