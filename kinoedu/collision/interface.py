"""Generic functions for collision queries, dispatched on the kinds of robot and world.

Each pair of a robot and a world registers its own functions, in a file of its own.
"""

from __future__ import annotations

from ..compiled import generic
from ..errors import InvalidParameter
from ..geometry.checks import Array
from ..robots.kinds import Robot
from ..support.text import shortened
from ..worlds.checks import World


@generic(2)
def is_free_path(robot: Robot, world: World, a: Array, b: Array, clearance: float) -> bool:
    """Whether the robot keeps more than `clearance` from obstacles on the motion from a to b.

    Raises
    ------
    TypeError
        Where this kind of robot has no motions in this kind of world.
    """
    raise TypeError("no motions are defined for this robot in this world")


@generic(2)
def is_free(robot: Robot, world: World, q: Array, clearance: float) -> bool:
    """Whether the robot at q is more than `clearance` away from every obstacle.

    By default this is a motion of length zero.
    """
    return is_free_path(robot, world, q, q, clearance)


@generic(2)
def is_semi_free_path(robot: Robot, world: World, a: Array, b: Array, clearance: float) -> bool:
    """Whether the robot keeps at least `clearance` on the motion from a to b; contact is allowed.

    The robot never enters the interior of an obstacle.

    Raises
    ------
    TypeError
        Where this kind of robot has no sliding motions in this kind of world.
    """
    raise TypeError("no sliding motions are defined for this robot in this world")


@generic(2)
def is_free_drive(
    robot: Robot, world: World, pose: Array, distance: float, curvature: float, clearance: float
) -> bool:
    """Whether a car keeps more than `clearance` from obstacles while it drives along an arc.

    Raises
    ------
    TypeError
        Where this kind of robot is not driven.
    """
    raise TypeError("no drives are defined for this robot in this world")


@generic(1)
def coordinates(robot: Robot) -> int:
    """The number of coordinates of a configuration of this robot.

    Raises
    ------
    InvalidParameter
        Where `robot` is not a robot.
    """
    raise InvalidParameter(f"expected a robot such as Point() or Disk(1), got {shortened(robot)}")
