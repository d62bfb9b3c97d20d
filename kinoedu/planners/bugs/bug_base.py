"""BugBase: straight to the goal, or not at all. Bullo & Smith, chapter 1, and its exercises."""

from collections.abc import Iterable

from numpy.typing import ArrayLike

from ...problems import Plan
from . import BugRobot
from .walk import plan_walk


def bug_base_walk(robot: BugRobot) -> str:
    """Move towards the goal until a wall is in the way; says why it failed, or nothing."""
    if not robot.move_to_goal():
        return "there is an obstacle between the start and the goal"
    return ""


def bug_base(
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    *,
    turn: str = "left",
    clearance: float = 0.0,
) -> Plan:
    """Move in a straight line from start to goal, and give up at the first wall.

    Arguments, answer and errors are those of `bug0`; no wall is followed, so turn changes nothing.

    >>> plan = bug_base((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], step=0.5)
    >>> plan.reason, plan.walk.hits
    ('there is an obstacle between the start and the goal', array([[1., 0.]]))
    """
    return plan_walk("BugBase", bug_base_walk, start, goal, obstacles, step, turn, clearance)
