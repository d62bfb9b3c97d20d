"""Build the plan that a Bug algorithm returns from the walk of its robot."""

import math
from collections.abc import Callable, Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ...errors import InvalidGoal, InvalidParameter, InvalidStart
from ...geometry.checks import Array, as_point
from ...problems import Plan, Walk
from ...robots import Disk, Point
from ...robots.kinds import Robot
from ...worlds.open_world import OpenWorld
from ..tuning import nonnegative, one_of, positive
from .robot import BugRobot, Trail
from .walls import check_obstacles, contact, make_walls

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
    algorithm: Callable[[BugRobot], str],
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    turn: str,
    clearance: float,
) -> Plan:
    """Check the arguments, run a Bug algorithm on a robot, and make a plan of its walk.

    The algorithm returns why it failed, or an empty string. The other parameters and the errors are
    those of `bug0`.
    """
    q_start, q_goal = as_point(start, "start"), as_point(goal, "goal")
    longest, margin = positive(step, "step"), nonnegative(clearance, "clearance")
    heading = -1 if one_of(turn, "turn", ("left", "right")) == "left" else 1
    rings = check_obstacles(obstacles)
    walls = make_walls(rings, margin)
    near = f" or closer than {margin:g} to one" if margin else ""
    if contact(walls, q_start) >= 0:
        raise InvalidStart(
            f"the start {tuple(q_start.tolist())} lies in or on an obstacle{near}; move it into "
            "the open"
        )
    if contact(walls, q_goal) == 0:
        raise InvalidGoal(f"the goal {tuple(q_goal.tolist())} lies on a wall; move it off")
    robot = BugRobot(walls, q_start, q_goal, heading)
    reason = algorithm(robot)
    walk = walk_of(robot.trail, q_goal, longest)
    world = open_world(rings, walls.rings, walk.points, q_goal, margin)
    problem = BugProblem(Disk(margin) if margin else Point(), world, q_start, q_goal, margin)
    path, cost = (None, math.inf) if reason else (walk.points, float(walk.travelled[-1]))
    stats = {"hits": len(walk.hit), "points": len(walk.points)}
    return Plan(path, cost, walk=walk, stats=stats, reason=reason, problem=problem, planner=planner)


def walk_of(trail: Trail, goal: Array, step: float) -> Walk:
    """The walk along a trail, with points inserted so that no two are more than `step` apart."""
    corners = np.array([(place.x, place.y) for place in trail.places])
    moves = np.diff(corners, axis=0)
    size = np.abs(moves).max(axis=1, initial=0.0)
    unit = np.where(size > 0.0, size, 1.0)
    # scaled, because squares of huge and tiny numbers overflow and underflow
    lengths = size * np.sqrt((moves[:, 0] / unit) ** 2 + (moves[:, 1] / unit) ** 2)
    with np.errstate(over="ignore"):  # refused below
        pieces = np.maximum(np.ceil(lengths / step * (1.0 - 1e-15)), 1.0)
    if not pieces.sum() < MOST_POINTS:
        needed = f"{pieces.sum():g} points for a walk of length {lengths.sum():g}"
        raise InvalidParameter(
            f"a step of {step:g} is too short: it takes {needed}; choose a longer one"
        )
    count = pieces.astype(np.int64)
    move = np.repeat(np.arange(len(moves)), count)
    part = (np.arange(len(move)) - np.repeat(np.cumsum(count) - count, count) + 1.0) / count[move]
    points = np.where(
        (part < 1.0)[:, None], corners[move] + part[:, None] * moves[move], corners[move + 1]
    )
    begun = np.concatenate([[0.0], np.cumsum(lengths)])
    travelled = np.where(part < 1.0, begun[move] + part * lengths[move], begun[move + 1])
    points = np.concatenate([corners[:1], points])
    number = np.concatenate([[0], np.cumsum(count)])  # of the point that each corner became
    return Walk(
        points,
        np.concatenate([[False], np.array(trail.following, dtype=bool)[move + 1]]),
        np.concatenate([[0.0], travelled]),
        np.hypot(points[:, 0] - goal[0], points[:, 1] - goal[1]),
        number[trail.hits],
        number[trail.leaves],
    )


def open_world(
    rings: list[Array], walls: list[Array], points: Array, goal: Array, clearance: float
) -> OpenWorld:
    """The obstacles in a frame that also holds the walk."""
    shown = np.concatenate([*walls, points, goal[None]])
    lo, hi = shown.min(axis=0), shown.max(axis=0)
    margin = 0.05 * float((hi - lo).max()) + clearance or 1.0
    return OpenWorld(rings, walls, lo - margin, hi + margin)
