"""A problem whose obstacles move: configurations are (x, y, t), the robot has a greatest speed, its
goal no time.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..collision import in_time, is_free, is_free_path
from ..compiled import record
from ..errors import InvalidGoal, InvalidParameter, InvalidStart
from ..geometry.checks import Array, none_or_more, positive
from ..support.text import shortened
from ..worlds.moving import MovingWorldRecord
from .configurations import as_configuration, space_of

__all__ = ["TimedProblem", "TimedProblemRecord", "in_time"]

ROUNDING = 1e-9  # the share by which a motion may be faster than the greatest speed


@record
class TimedProblemRecord(NamedTuple):
    """What `TimedProblem` makes. start and goal are places, shape (2,); configurations have shape
    (3,), float64.
    """

    robot: Any
    world: MovingWorldRecord
    start: Array
    goal: Array
    speed: float
    horizon: float
    clearance: float

    def is_free(self, q: Array) -> bool:
        """Whether the robot at the place (x, y) touches nothing at the time t."""
        return is_free(self.robot, self.world, q, self.clearance)

    def is_free_path(self, a: Array, b: Array) -> bool:
        """Whether the motion from a to b goes forward in time, is no faster than the robot, and
        touches nothing at any moment.
        """
        far = math.sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]))
        return far <= self.speed * (b[2] - a[2]) * (1.0 + ROUNDING) and is_free_path(
            self.robot, self.world, a, b, self.clearance
        )


def TimedProblem(
    robot: Any,
    world: MovingWorldRecord,
    start: ArrayLike,
    goal: ArrayLike,
    *,
    speed: float = 1.0,
    horizon: float | None = None,
    clearance: float = 0.0,
) -> TimedProblemRecord:
    """The task: from start, at time 0, to goal, at any time up to the horizon, among obstacles that
    move.

    Parameters
    ----------
    robot : Point(), Disk(radius) or TranslatingPolygon(vertices). world : a MovingWorld.
    start, goal : places (x, y). The start must be free at time 0, the goal of what stands still.
    speed : the robot's greatest, in lengths a unit of time. clearance : as of a Problem.
    horizon : the last moment that is planned for; by default everything has come to rest then, for
    as long as the robot needs for
        four diagonals of the world.

    Raises InvalidStart, InvalidGoal, InvalidPoint, InvalidParameter.

    >>> from kinoedu import Disk, PolygonWorld
    >>> from kinoedu.worlds import Moving, MovingWorld
    >>> hall = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    >>> world = MovingWorld(hall, [Moving(1.0, [0, 10], [(9, 3), (-1, 3)])])
    >>> problem = TimedProblem(Disk(0.5), world, start=(1, 3), goal=(9, 3))
    >>> problem.is_free(np.array([1.0, 3.0, 0.0])), problem.is_free(np.array([1.0, 3.0, 7.0]))
    (True, False)
    """
    if not isinstance(world, MovingWorldRecord):
        raise InvalidParameter(
            f"expected a MovingWorld(PolygonWorld(...), movers), got {shortened(world)}; else use "
            "Problem"
        )
    space, margin, fastest = (
        space_of(robot, world.still),
        none_or_more(clearance, "clearance"),
        positive(speed, "speed"),
    )
    if len(space.lo) != 2:
        raise InvalidParameter(
            "among moving obstacles a robot does not turn; expected Point, Disk, ..., got "
            f"{shortened(robot)}"
        )
    begin, end = as_configuration(start, space, "start"), as_configuration(goal, space, "goal")
    rest = max(float(world.times.max()), 0.0) if len(world.times) else 0.0
    last = rest + 4.0 * float(np.sqrt(np.square(world.hi - world.lo).sum())) / fastest
    problem = TimedProblemRecord(
        robot,
        world,
        begin,
        end,
        fastest,
        last if horizon is None else positive(horizon, "horizon"),
        margin,
    )
    if not problem.is_free(np.append(begin, 0.0)):
        raise InvalidStart(
            f"the start {tuple(begin.tolist())} is not free at time 0: something stands or comes "
            "there"
        )
    if not is_free(robot, world.still, end, margin):
        raise InvalidGoal(f"the goal {tuple(end.tolist())} is not free: something stands there")
    return problem
