"""Bug 0: follow the wall until a motion towards the goal is free. Bullo & Smith, chapter 1.

     1  while the goal is not reached:
     2      move towards the goal
     3      if an obstacle is hit:
     4          follow its wall until the robot can move towards the goal

Not complete: the robot may walk in a circle for ever.
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
    "Bug 0 walks in a circle for ever: it hit the same wall at the same point again",
    "Bug 0 walked round the obstacle and could not move towards the goal anywhere",
)
REACHED, IN_A_CIRCLE, SHUT_IN = range(3)


@algorithm
def bug0_walk(robot: BugRobot) -> int:
    """Walk by Bug 0; returns the number of the reason why it failed, 0 at the goal."""
    while not robot.move_to_goal():
        if robot.was_hit_before():  # the rest of the walk depends on the hit point alone
            return IN_A_CIRCLE
        hit = robot.place
        while not robot.can_move_to_goal():
            robot.follow_wall()
            if robot.place == hit:
                return SHUT_IN
    return REACHED


def bug0(
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    *,
    turn: str = "left",
    clearance: float = 0.0,
) -> Plan:
    """Plan by Bug 0: follow each wall until a motion towards the goal is free.

    Parameters
    ----------
    start, goal : (x, y). The start must be free. The goal need not be reachable; the
        walk ends with a reason where it is not.
    obstacles : simple polygons, (n, 2) each, convex or not, clockwise or counter-clockwise.
        Obstacles that touch or overlap count as one.
    step : the longest distance between two points of the path. The walk itself is exact and does
        not depend on it.
    turn : "left" to turn left at a wall, which is then on the robot's right; or "right".
    clearance : the distance kept from obstacles. The robot follows the obstacles grown by it: their
        edges are moved out by exactly that much, and their corners are rounded by short edges that
        stand off at most a thousandth more.

    Returns
    -------
    Plan whose `walk` records what the robot did: points, hit and leave points, where it followed
    walls, the distance walked and the distance to the goal. `cost` is the exact length of the walk.
    Without a path `reason` says why; a walk in a circle is recorded for one round.

    Raises
    ------
    InvalidStart
        Where the start is in contact with an obstacle.
    InvalidGoal
        Where the goal lies on a wall.
    InvalidPolygon
        Where an obstacle is not a simple polygon.
    InvalidPoint
        Where a coordinate is not a finite number.
    InvalidParameter
        Where another parameter is out of its range.

    Examples
    --------
    >>> plan = bug0((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], step=9)
    >>> plan.path.tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [2.0, 2.0], [4.0, 0.0]]
    """
    return plan_walk("Bug 0", bug0_walk, REASONS, start, goal, obstacles, step, turn, clearance)
