"""Bug 2 without its rule: it leaves wherever the start-goal line is met again, and may circle.
Bullo & Smith, chapter 1.
"""

from collections.abc import Iterable

from numpy.typing import ArrayLike

from ...problems import Plan
from . import BugRobot
from .walk import plan_walk


def bug2_prelim_walk(robot: BugRobot) -> str:
    """Bug 2.prelim, step by step; says why it failed, or nothing."""
    hits = set()
    while not robot.move_to_goal():
        hit = robot.place
        if hit in hits:  # what follows depends on the hit point alone
            return (
                "Bug 2.prelim walks in a circle for ever: it came upon the same wall at the same "
                "point again"
            )
        hits.add(hit)
        robot.follow_wall()
        while not (robot.place.on_line and robot.can_move_to_goal()):
            if robot.place == hit:
                return (
                    "Bug 2.prelim went round the obstacle, and nowhere could it leave along the "
                    "start-goal line"
                )
            robot.follow_wall()
    return ""


def bug2_prelim(
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    *,
    turn: str = "left",
    clearance: float = 0.0,
) -> Plan:
    """Move towards the goal; follow each wall met until the start-goal line is met again, wherever
    that is; and so on.

    Arguments, answer and errors are those of `bug0`. Not complete: it may walk in a circle for
    ever, which is recognised and shown.

    >>> bug2_prelim((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], step=9).cost
    8.0
    """
    return plan_walk(
        "Bug 2.prelim", bug2_prelim_walk, start, goal, obstacles, step, turn, clearance
    )
