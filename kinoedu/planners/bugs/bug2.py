"""Bug 2: follow each wall back to the start-goal line, closer to the goal.

     1  while the goal is not reached:
     2      move towards the goal along the start-goal line
     3      if an obstacle is hit:
     4          follow its wall until the robot is on the start-goal line, closer to the goal than
     5              the hit point, and can move towards the goal
     6          if it returns to the hit point first: return failure

Bullo & Smith, chapter 1; V. J. Lumelsky, A. A. Stepanov, "Path-planning strategies for a point
mobile automaton moving amidst unknown obstacles of arbitrary shape", Algorithmica 2 (1987).
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
    "no path reaches the goal: nowhere round the obstacle can the robot leave it on the start-goal "
    "line closer to the goal",
)
REACHED, NO_PATH = range(2)


@algorithm
def bug2_walk(robot: BugRobot) -> int:
    """Walk by Bug 2; returns the number of the reason why it failed, 0 at the goal."""
    while not robot.move_to_goal():
        hit = robot.place
        robot.follow_wall()
        while not (
            robot.place.on_line and robot.place.is_nearer_than(hit) and robot.can_move_to_goal()
        ):
            if robot.place == hit:
                return NO_PATH
            robot.follow_wall()
    return REACHED


def bug2(
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    *,
    turn: str = "left",
    clearance: float = 0.0,
) -> Plan:
    """Plan by Bug 2: follow each wall until the start-goal line is met closer to the goal.

    The start-goal line is the segment between the two. Complete: it reaches the goal, or finds that
    no path does. The walk is at most D plus, for each obstacle that is hit, half its perimeter
    times the number of its crossings with the start-goal line; D is the distance from start to
    goal.

    Parameters, result and errors are those of `bug0`.

    Examples
    --------
    >>> plan = bug2((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], step=9)
    >>> plan.path.tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [2.0, 2.0], [2.0, 0.0], [4.0, 0.0]]
    """
    return plan_walk("Bug 2", bug2_walk, REASONS, start, goal, obstacles, step, turn, clearance)
