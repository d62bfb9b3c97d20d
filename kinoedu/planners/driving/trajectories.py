"""Controls that drive a car along a path of curves."""

import numpy as np

from ...curves.space import pieces_between
from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...problems import Plan, ProblemRecord
from ...problems.recorder import unwrap_recorder
from ...robots.car import CarRobot
from ...robots.trajectory import Trajectory, TrajectoryRecord
from ...support.text import shortened


def trajectory_along(plan: Plan) -> TrajectoryRecord:
    """The controls that drive a car along a plan's path of Dubins' or Reeds and Shepp's curves.

    The car steers fully or not at all. It drives forward at its highest forward speed and backward
    at its highest reverse speed. The trajectory of a plan that has one is returned.

    Returns
    -------
    TrajectoryRecord

    Raises
    ------
    InvalidParameter
        Where the plan has no path, or its robot is not a car.

    Examples
    --------
    >>> from kinoedu import Car, PolygonWorld, Problem, rrt
    >>> wall = [(9, 0), (11, 0), (11, 10), (9, 10)]
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], [wall])
    >>> plan = rrt(Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0)), rng=0)
    >>> drive = trajectory_along(plan)
    >>> np.allclose(drive.poses[-1], plan.path[-1]), abs(drive.length - plan.cost) < 1e-9
    (True, True)
    """
    if not isinstance(plan, Plan) or plan.path is None:
        raise InvalidParameter(f"expected a plan with a path, got {shortened(plan)}")
    if plan.trajectory is not None:
        return plan.trajectory
    inner = unwrap_recorder(plan.problem)
    if not isinstance(inner, ProblemRecord) or not isinstance(inner.robot, CarRobot):
        raise InvalidParameter(
            "only a car is driven along a path; plan for a Problem(Car(...), world, start, goal)"
        )
    car = inner.robot
    pieces = [controls_along(car, a, b) for a, b in zip(plan.path, plan.path[1:])]
    controls = np.concatenate([np.empty((0, 2)), *(controls for controls, _ in pieces)])
    durations = np.concatenate([np.empty(0), *(durations for _, durations in pieces)])
    return Trajectory(car, plan.path[0], controls, durations)


def controls_along(car: CarRobot, a: Array, b: Array) -> tuple[Array, Array]:
    """The controls (n, 2) along the shortest curve from pose a to pose b, and their durations."""
    turns, lengths = pieces_between(a, b, car.radius, car.both_ways)
    turns, lengths = turns[lengths != 0.0], lengths[lengths != 0.0]
    speeds = np.where(lengths > 0.0, car.speeds.max(), car.speeds.min())
    return np.stack([speeds, turns * car.max_steering], axis=1), lengths / speeds
