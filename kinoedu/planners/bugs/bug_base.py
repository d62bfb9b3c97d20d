"""BugBase: move straight to the goal, and fail at the first obstacle. Bullo & Smith, chapter 1."""

from __future__ import annotations

from collections.abc import Iterable

from numpy.typing import ArrayLike

from ...compiled import algorithm
from ...problems import Plan
from . import BugRobot
from .walk import plan_walk

REASONS = ("", "there is an obstacle between the start and the goal")
REACHED, OBSTACLE = range(2)


@algorithm
def bug_base_walk(robot: BugRobot) -> int:
    """Walk by BugBase; returns the number of the reason why it failed, 0 at the goal."""
    if not robot.move_to_goal():
        return OBSTACLE
    return REACHED


def bug_base(
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    *,
    turn: str = "left",
    clearance: float = 0.0,
) -> Plan:
    """Plan by BugBase: move straight from start to goal, and stop at the first wall.

    Parameters, result and errors are those of `bug0`. No wall is followed, so `turn` has no effect.

    Examples
    --------
    >>> plan = bug_base((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], step=0.5)
    >>> plan.reason, plan.walk.hits
    ('there is an obstacle between the start and the goal', array([[1., 0.]]))
    """
    return plan_walk(
        "BugBase", bug_base_walk, REASONS, start, goal, obstacles, step, turn, clearance
    )
