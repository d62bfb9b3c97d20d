"""Bug 0: follow the wall until the way to the goal is open. Bullo & Smith, chapter 1; it may walk
in a circle for ever.
"""

from collections.abc import Iterable

from numpy.typing import ArrayLike

from ...problems import Plan
from . import BugRobot
from .walk import plan_walk


def bug0_walk(robot: BugRobot) -> str:
    """Bug 0, step by step; says why it failed, or nothing."""
    hits = set()
    while not robot.move_to_goal():
        hit = robot.place
        if hit in hits:  # what follows depends on the hit point alone
            return (
                "Bug 0 walks in a circle for ever: it came upon the same wall at the same point "
                "again"
            )
        hits.add(hit)
        while not robot.can_move_to_goal():
            robot.follow_wall()
            if robot.place == hit:
                return (
                    "Bug 0 went round the obstacle, and nowhere did the wall let it move towards "
                    "the goal"
                )
    return ""


def bug0(
    start: ArrayLike,
    goal: ArrayLike,
    obstacles: Iterable[ArrayLike],
    step: float,
    *,
    turn: str = "left",
    clearance: float = 0.0,
) -> Plan:
    """Move towards the goal; where a wall is in the way follow it until it no longer is; and so on.

    Parameters
    ---------- start, goal : (x, y). The start must be free. A goal that no path reaches is found
    out by walking.
    obstacles : simple polygons, (n, 2) each, convex or not, in either sense. Those that meet or
    overlap are one obstacle.
    step : the longest distance between two points of the path; it changes nothing else, the walk is
    exact.
    turn : "left", at a wall the robot turns left and has it on its right; or "right".
    clearance : the robot keeps so far off: it follows the obstacles grown by that much. Their edges
    are moved out by just so much,
        and their corners are rounded by short edges that stand off at most a thousandth more.

    Returns a Plan whose `walk` holds all that the robot did: points, hit and leave points, where it
    followed walls, how far it had come and how far the goal was. `cost` is the walk's exact length.
    Without a path `reason` says why; a walk in a circle is shown once round. Raises InvalidStart,
    InvalidGoal (where it lies on a wall), InvalidPolygon, InvalidPoint, InvalidParameter.

    >>> plan = bug0((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], step=9)
    >>> plan.path.tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [2.0, 2.0], [4.0, 0.0]]
    """
    return plan_walk("Bug 0", bug0_walk, start, goal, obstacles, step, turn, clearance)
