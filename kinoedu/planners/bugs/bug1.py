"""Bug 1: walk round each obstacle, then leave it from the point nearest to the goal.

     1  while the goal is not reached:
     2      move towards the goal
     3      if an obstacle is hit:
     4          walk once round it, and remember the point nearest to the goal
     5          follow the wall back to that point
     6          if the robot cannot move towards the goal there: return failure

Bullo & Smith, chapter 1; V. J. Lumelsky, A. A. Stepanov, "Path-planning strategies for a point
mobile automaton moving amidst unknown obstacles of arbitrary shape", Algorithmica 2 (1987).
"""

from __future__ import annotations

from collections.abc import Iterable

from numpy.typing import ArrayLike

from ...compiled import algorithm
from ...problems import Plan
from ..tuning import one_of
from . import BugRobot
from .walk import plan_walk

REASONS = ("", "no path reaches the goal: the wall blocks it even at its nearest point")
REACHED, NO_PATH = range(2)


@algorithm
def bug1_walk(robot: BugRobot, takes_shorter: bool) -> int:
    """Walk by Bug 1; returns the number of the reason why it failed, 0 at the goal."""
    while not robot.move_to_goal():
        hit = nearest = robot.place
        begin = at_nearest = robot.travelled
        robot.follow_wall()
        while robot.place != hit:  # line 4
            if robot.place.is_nearer_than(nearest):
                nearest, at_nearest = robot.place, robot.travelled
            robot.follow_wall()
        if takes_shorter and robot.travelled - at_nearest < at_nearest - begin:
            robot.turn_round()
        while robot.place != nearest:
            robot.follow_wall()
        if not robot.can_move_to_goal():
            return NO_PATH
    return REACHED


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
    """Plan by Bug 1: walk round each obstacle, and leave it from the point nearest to the goal.

    Complete: it reaches the goal, or finds that no path does. The walk is at most D + 3/2 of the
    perimeters of the obstacles that are hit, where D is the distance from start to goal; with
    way_back="same" at most D + 2 of the perimeters.

    The other parameters, the result and the errors are those of `bug0`.

    Parameters
    ----------
    way_back : "shorter" to return to the nearest point along the shorter way, without turning round
        where both are equally long; or "same" to go on in the same direction.

    Examples
    --------
    >>> box = [(1, -1), (2, -1), (2, 2), (1, 2)]
    >>> bug1((0, 0), (4, 0), [box], step=0.1).cost
    14.0
    >>> bug1((0, 0), (4, 0), [box], step=0.1, way_back="same").cost
    16.0
    """
    shorter = one_of(way_back, "way_back", ("shorter", "same")) == "shorter"
    return plan_walk(
        "Bug 1",
        lambda robot: bug1_walk(robot, shorter),
        REASONS,
        start,
        goal,
        obstacles,
        step,
        turn,
        clearance,
    )
