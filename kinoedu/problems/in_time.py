"""Problems with moving obstacles: configurations are (x, y, t) and the robot's speed is limited.

The goal is a place; it may be reached at any time up to the horizon.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..collision import in_time, is_free, is_free_path
from ..compiled import record
from ..errors import InvalidGoal, InvalidParameter, InvalidStart
from ..geometry.checks import Array, nonnegative, positive
from ..robots.kinds import Robot
from ..support.constructors import Constructor, with_type_names
from ..support.text import shortened
from ..worlds.moving import MovingWorldRecord
from .configurations import as_configuration, space_of

__all__ = ["TimedProblem", "TimedProblemRecord", "in_time"]

ROUNDING = 1e-9  # a motion may exceed the greatest speed by this fraction


@with_type_names
@record
class TimedProblemRecord(NamedTuple):
    """The record that `TimedProblem` returns.

    start and goal are places, shape (2,). Configurations have shape (3,), float64.
    """

    robot: Robot
    world: MovingWorldRecord
    start: Array
    goal: Array
    speed: float
    horizon: float
    clearance: float

    def is_free(self, q: Array) -> bool:
        """Whether the robot at (x, y) touches nothing at time t, for q = (x, y, t)."""
        return is_free(self.robot, self.world, q, self.clearance)

    def is_free_path(self, a: Array, b: Array) -> bool:
        """Whether the motion from a to b is possible and free of contact at every moment.

        It must go forward in time and must not exceed the robot's greatest speed.
        """
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = math.sqrt(dx * dx + dy * dy)
        return length <= self.speed * (b[2] - a[2]) * (1.0 + ROUNDING) and is_free_path(
            self.robot, self.world, a, b, self.clearance
        )


class TimedProblem(TimedProblemRecord, metaclass=Constructor):
    """Define a problem among moving obstacles: from start at time 0 to goal, within the horizon.

    Parameters
    ----------
    robot : Point(), Disk(radius) or TranslatingPolygon(vertices).
    world : a MovingWorld.
    start, goal : places (x, y). The start must be free at time 0; the goal must be free of the
        obstacles that stand still.
    speed : the robot's greatest speed, in lengths per unit of time.
    horizon : the latest time to plan for. By default: the time at which the last obstacle stops,
        plus the time that the robot needs for four diagonals of the world.
    clearance : as in `Problem`.

    Returns
    -------
    TimedProblemRecord

    Raises
    ------
    InvalidStart, InvalidGoal
        Where the start or the goal is not free.
    InvalidPoint, InvalidParameter
        Where another argument is not valid.

    Examples
    --------
    >>> from kinoedu import Disk, PolygonWorld
    >>> from kinoedu.worlds import Moving, MovingWorld
    >>> hall = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    >>> world = MovingWorld(hall, [Moving(1.0, [0, 10], [(9, 3), (-1, 3)])])
    >>> problem = TimedProblem(Disk(0.5), world, start=(1, 3), goal=(9, 3))
    >>> problem.is_free(np.array([1.0, 3.0, 0.0])), problem.is_free(np.array([1.0, 3.0, 7.0]))
    (True, False)
    """

    def __new__(  # type: ignore[misc]  # returns the record
        cls,
        robot: Robot,
        world: MovingWorldRecord,
        start: ArrayLike,
        goal: ArrayLike,
        *,
        speed: float = 1.0,
        horizon: float | None = None,
        clearance: float = 0.0,
    ) -> TimedProblemRecord:
        if not isinstance(world, MovingWorldRecord):
            raise InvalidParameter(
                f"expected a MovingWorld(PolygonWorld(...), movers), got {shortened(world)}; use "
                "Problem for worlds without moving obstacles"
            )
        space, margin = space_of(robot, world.still), nonnegative(clearance, "clearance")
        fastest = positive(speed, "speed")
        if len(space.lo) != 2:
            raise InvalidParameter(
                "among moving obstacles the robot must not rotate; expected Point(), Disk(radius) "
                f"or TranslatingPolygon(vertices), got {shortened(robot)}"
            )
        begin, end = as_configuration(start, space, "start"), as_configuration(goal, space, "goal")
        rest = max(float(world.times.max()), 0.0) if len(world.times) else 0.0
        last = rest + 4.0 * float(np.sqrt(np.square(world.hi - world.lo).sum())) / fastest
        latest = last if horizon is None else positive(horizon, "horizon")
        problem = TimedProblemRecord(robot, world, begin, end, fastest, latest, margin)
        if not problem.is_free(np.append(begin, 0.0)):
            raise InvalidStart(
                f"the start {tuple(begin.tolist())} is not free at time 0: the robot touches an "
                "obstacle or the boundary there; move it into the free space"
            )
        if not is_free(robot, world.still, end, margin):
            raise InvalidGoal(
                f"the goal {tuple(end.tolist())} is not free: the robot touches a fixed obstacle "
                "or the boundary there; move it into the free space"
            )
        return problem
