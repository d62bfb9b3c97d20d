"""Bug 2.prelim: Bug 2 without the rule that it leaves a wall closer to the goal.

It leaves a wall wherever it meets the start-goal line again, and may walk in a circle for ever.
Bullo & Smith, chapter 1.
"""

from __future__ import annotations

from collections.abc import Iterable

from numpy.typing import ArrayLike

from ...compiled import algorithm
from ...problems import Plan
from . import BugRobot
from .walk import plan_walk

REASONS = (
    "",
    "Bug 2.prelim walks in a circle for ever: it hit the same wall at the same point again",
    "Bug 2.prelim walked round the obstacle and could not leave along the start-goal line anywhere",
)
REACHED, IN_A_CIRCLE, SHUT_IN = range(3)


@algorithm
def bug2_prelim_walk(robot: BugRobot) -> int:
    """Walk by Bug 2.prelim; returns the number of the reason why it failed, 0 at the goal."""
    while not robot.move_to_goal():
        if robot.was_hit_before():  # the rest of the walk depends on the hit point alone
            return IN_A_CIRCLE
        hit = robot.place
        robot.follow_wall()
        while not (robot.place.on_line and robot.can_move_to_goal()):
            if robot.place == hit:
                return SHUT_IN
            robot.follow_wall()
    return REACHED


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
        "Bug 2.prelim", bug2_prelim_walk, REASONS, start, goal, obstacles, step, turn, clearance
    )
