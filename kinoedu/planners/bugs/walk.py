"""Build the plan that a Bug algorithm returns from the walk of its robot."""

import math
from collections.abc import Callable, Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...compiled import compiled
from ...errors import InvalidGoal, InvalidParameter, InvalidStart
from ...geometry.checks import Array, as_point
from ...messages import get_message
from ...problems import Plan, Walk
from ...robots import Disk, Point
from ...robots.kinds import Robot
from ...worlds.open_world import OpenWorld
from ..tuning import nonnegative, one_of, positive
from .robot import BugRobot, corners_of, new_robot
from .trail import HITS, LEAVES, SIZE
from .walls import check_obstacles, contact, contact_with_rings, make_walls, rings_of

MOST_POINTS = 10_000_000  # that memory can hold


class BugProblem(NamedTuple):
    """The problem of a Bug plan: a point, or a disk of radius `clearance`, among obstacles."""

    robot: Robot
    world: OpenWorld
    start: Array
    goal: Array
    clearance: float


def plan_walk(
    planner: str,
    algorithm: Callable[[BugRobot], int],
    reasons: Sequence[str],
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    turn: str,
    clearance: float,
) -> Plan:
    """Check the arguments, run a Bug algorithm on a robot, and make a plan of its walk.

    The algorithm returns the number of the reason why it failed, of which the first is empty. The
    other parameters and the errors are those of `bug0`.
    """
    q_start, q_goal = as_point(start, "start"), as_point(goal, "goal")
    longest, margin = positive(step, "step"), nonnegative(clearance, "clearance")
    heading = -1 if one_of(turn, "turn", ("left", "right")) == "left" else 1
    rings = check_obstacles(obstacles)
    walls = make_walls(rings, margin)
    given = [] if margin else rings
    if max(contact(walls, q_start), contact_with_rings(given, q_start)) >= 0:
        near = get_message("bug.near", clearance=f"{margin:g}") if margin else ""
        raise InvalidStart(get_message("bug.start", q=tuple(q_start.tolist()), near=near))
    if contact(walls, q_goal) == 0 or contact_with_rings(given, q_goal) == 0:
        raise InvalidGoal(get_message("bug.goal", q=tuple(q_goal.tolist())))
    robot = new_robot(walls, q_start, q_goal, heading)
    reason = reasons[algorithm(robot)]
    walk = walk_of(robot, longest)
    world = open_world(rings, rings_of(walls), walk.points, q_goal, margin)
    problem = BugProblem(Disk(margin) if margin else Point(), world, q_start, q_goal, margin)
    path, cost = (None, math.inf) if reason else (walk.points, float(walk.travelled[-1]))
    stats = {"hits": len(walk.hit), "points": len(walk.points)}
    return Plan(path, cost, walk=walk, stats=stats, reason=reason, problem=problem, planner=planner)


def walk_of(robot: BugRobot, step: float) -> Walk:
    """The walk of a robot, with points inserted so that no two are more than `step` apart."""
    trail, goal = robot.trail, robot.goal
    corners, following = corners_of(robot), trail.following[: trail.counts[SIZE]]
    with np.errstate(over="ignore"):  # refused below
        lengths, pieces = measure_moves(corners, step)
    if not pieces.sum() < MOST_POINTS:
        needed = f"{pieces.sum():g} points for a walk of length {lengths.sum():g}"
        raise InvalidParameter(
            f"a step of {step:g} is too short: it takes {needed}; choose a longer one"
        )
    points, along, travelled, number = divide_moves(corners, following, lengths, pieces)
    return Walk(
        points,
        along,
        travelled,
        np.hypot(points[:, 0] - goal[0], points[:, 1] - goal[1]),
        number[trail.hits[: trail.counts[HITS]]],
        number[trail.leaves[: trail.counts[LEAVES]]],
    )


@compiled
def measure_moves(corners: Array, step: float) -> tuple[Array, Array]:
    """The length of each move between corners, and into how many pieces it is to be divided."""
    lengths, pieces = np.empty(len(corners) - 1), np.empty(len(corners) - 1)
    for i in range(len(lengths)):
        dx, dy = corners[i + 1, 0] - corners[i, 0], corners[i + 1, 1] - corners[i, 1]
        size = max(abs(dx), abs(dy))
        # scaled, because squares of huge and tiny numbers overflow and underflow
        unit = size if size > 0.0 else 1.0
        x, y = dx / unit, dy / unit
        lengths[i] = size * math.sqrt(x * x + y * y)
        pieces[i] = max(np.ceil(lengths[i] / step * (1.0 - 1e-15)), 1.0)
    return lengths, pieces


@compiled
def divide_moves(
    corners: Array, following: NDArray[np.bool_], lengths: Array, pieces: Array
) -> tuple[Array, NDArray[np.bool_], Array, NDArray[np.int64]]:
    """The points of a walk whose moves are divided into pieces.

    Returns
    -------
    points, following, travelled
        As in `Walk`.
    number
        The number of the point that each corner became.
    """
    size = 1
    for i in range(len(pieces)):
        size += int(pieces[i])
    points, travelled, along = np.empty((size, 2)), np.zeros(size), np.zeros(size, np.bool_)
    number, begun, k = np.zeros(len(corners), np.int64), 0.0, 1
    points[0] = corners[0]
    for i in range(len(pieces)):
        ended = begun + lengths[i]
        for piece in range(1, int(pieces[i])):
            part = piece / pieces[i]
            for axis in range(2):
                move = corners[i + 1, axis] - corners[i, axis]
                points[k, axis] = corners[i, axis] + part * move
            travelled[k], along[k] = begun + part * lengths[i], following[i + 1]
            k += 1
        points[k], travelled[k], along[k] = corners[i + 1], ended, following[i + 1]
        number[i + 1], begun, k = k, ended, k + 1
    return points, along, travelled, number


def open_world(
    rings: list[Array], walls: list[Array], points: Array, goal: Array, clearance: float
) -> OpenWorld:
    """The obstacles in a frame that also holds the walk."""
    shown = np.concatenate([*walls, points, goal[None]])
    lo, hi = shown.min(axis=0), shown.max(axis=0)
    margin = 0.05 * float((hi - lo).max()) + clearance or 1.0
    return OpenWorld(rings, walls, lo - margin, hi + margin)
