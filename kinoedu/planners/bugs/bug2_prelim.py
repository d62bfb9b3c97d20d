"""Bug 2.prelim: Bug 2 without the rule that it leaves a wall closer to the goal.

It leaves a wall wherever it meets the start-goal line again, and may walk in a circle for ever.
Bullo & Smith, chapter 1.
"""

from __future__ import annotations

from collections.abc import Iterable

from numpy.typing import ArrayLike

from ...problems import Plan
from . import BugRobot
from .walk import plan_walk


def bug2_prelim_walk(robot: BugRobot) -> str:
    """Walk by Bug 2.prelim; returns why it failed, or an empty string."""
    hits = set()
    while not robot.move_to_goal():
        hit = robot.place
        if hit in hits:  # the rest of the walk depends on the hit point alone
            return (
                "Bug 2.prelim walks in a circle for ever: it hit the same wall at the same point "
                "again"
            )
        hits.add(hit)
        robot.follow_wall()
        while not (robot.place.on_line and robot.can_move_to_goal()):
            if robot.place == hit:
                return (
                    "Bug 2.prelim walked round the obstacle and could not leave along the "
                    "start-goal line anywhere"
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
    """Plan by Bug 2.prelim: follow each wall until the start-goal line is met again.

    Not complete: the robot may walk in a circle for ever, which is detected and shown.

    Parameters, result and errors are those of `bug0`.

    Examples
    --------
    >>> bug2_prelim((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], step=9).cost
    8.0
    """
    return plan_walk(
        "Bug 2.prelim", bug2_prelim_walk, start, goal, obstacles, step, turn, clearance
    )
