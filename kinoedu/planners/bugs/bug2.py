"""Bug 2: follow the wall back to the start-goal line, closer to the goal. Bullo & Smith, chapter 1.

V. J. Lumelsky, A. A. Stepanov, "Path-planning strategies for a point mobile automaton moving amidst
unknown obstacles of arbitrary shape", Algorithmica 2 (1987).
"""

from collections.abc import Iterable

from numpy.typing import ArrayLike

from ...problems import Plan
from . import BugRobot
from .walk import plan_walk


def bug2_walk(robot: BugRobot) -> str:
    """Bug 2, step by step; says why it failed, or nothing."""
    while not robot.move_to_goal():
        hit = robot.place
        robot.follow_wall()
        while not (
            robot.place.on_line and robot.place.is_nearer_than(hit) and robot.can_move_to_goal()
        ):
            if robot.place == hit:
                return (
                    "no path reaches the goal: round the obstacle the start-goal line was not met "
                    "closer to the goal"
                )
            robot.follow_wall()
    return ""


def bug2(
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    *,
    turn: str = "left",
    clearance: float = 0.0,
) -> Plan:
    """Move towards the goal; follow each wall met until the start-goal line is met again, closer to
    the goal; and so on.

    Arguments, answer and errors are those of `bug0`. The start-goal line is the segment between the
    two.

    Complete: it reaches the goal, or finds that no path does. The walk is at most D plus, for each
    obstacle met, half its perimeter times the number of its crossings with the start-goal line; D
    is the distance from start to goal.

    >>> plan = bug2((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], step=9)
    >>> plan.path.tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [2.0, 2.0], [2.0, 0.0], [4.0, 0.0]]
    """
    return plan_walk("Bug 2", bug2_walk, start, goal, obstacles, step, turn, clearance)
