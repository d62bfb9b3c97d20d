"""Bug 1: go all the way round, then leave from where the goal was nearest. Bullo & Smith, chapter
1.

V. J. Lumelsky, A. A. Stepanov, "Path-planning strategies for a point mobile automaton moving amidst
unknown obstacles of arbitrary shape", Algorithmica 2 (1987).
"""

from collections.abc import Iterable

from numpy.typing import ArrayLike

from ...problems import Plan
from ..tuning import one_of
from . import BugRobot
from .walk import plan_walk


def bug1_walk(robot: BugRobot, way_back: str) -> str:
    """Bug 1, step by step; says why it failed, or nothing."""
    while not robot.move_to_goal():
        hit = nearest = robot.place
        begin = at_nearest = robot.travelled
        robot.follow_wall()
        while robot.place != hit:  # all the way round, remembering where the goal was nearest
            if robot.place.is_nearer_than(nearest):
                nearest, at_nearest = robot.place, robot.travelled
            robot.follow_wall()
        if way_back == "shorter" and robot.travelled - at_nearest < at_nearest - begin:
            robot.turn_round()
        while robot.place != nearest:
            robot.follow_wall()
        if not robot.can_move_to_goal():
            return (
                "no path reaches the goal: even where the wall comes nearest to it, the wall is "
                "in the way"
            )
    return ""


def bug1(
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    *,
    turn: str = "left",
    way_back: str = "shorter",
    clearance: float = 0.0,
) -> Plan:
    """Move towards the goal; go once round each obstacle met, back to where the goal was nearest,
    and on from there.

    way_back : "shorter", the shorter way along the wall back to the nearest point, the same
        direction where both are equally long; or "same", the direction in which it went round. The
        other arguments, the answer and the errors are those of `bug0`.

    Complete: it reaches the goal, or finds that no path does. The walk is at most D + 3/2 of the
    perimeters of the obstacles met, where D is the distance from start to goal (with the way back
    in the same direction, at most twice the perimeters).

    >>> box = [(1, -1), (2, -1), (2, 2), (1, 2)]
    >>> bug1((0, 0), (4, 0), [box], step=0.1).cost, bug1((0, 0), (4, 0), [box], step=0.1, way_back="same").cost
    (14.0, 16.0)
    """
    back = one_of(way_back, "way_back", ("shorter", "same"))
    return plan_walk(
        "Bug 1", lambda robot: bug1_walk(robot, back), start, goal, obstacles, step, turn, clearance
    )
