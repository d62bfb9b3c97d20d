"""What a problem asks of a robot in a world. Each pair of a robot's and a world's kind answers in
its own file.
"""

from typing import Any

from ..compiled import generic
from ..errors import InvalidParameter
from ..geometry.checks import Array
from ..support.text import shortened


@generic(2)
def is_free_path(robot: Any, world: Any, a: Array, b: Array, clearance: float) -> bool:
    """Whether the whole straight motion from a to b stays more than `clearance` away from every
    obstacle: no contact.
    """
    raise TypeError("this robot cannot be moved in this world")


@generic(2)
def is_free(robot: Any, world: Any, q: Array, clearance: float) -> bool:
    """Whether the robot at q is more than `clearance` away from every obstacle: a motion that stays
    where it is.
    """
    return is_free_path(robot, world, q, q, clearance)


@generic(2)
def is_semi_free_path(robot: Any, world: Any, a: Array, b: Array, clearance: float) -> bool:
    """Whether the motion from a to b keeps `clearance`, contact allowed: it never enters the inside
    of what is solid.
    """
    raise TypeError("this robot cannot slide in this world")


@generic(2)
def is_free_drive(
    robot: Any, world: Any, pose: Array, distance: float, curvature: float, clearance: float
) -> bool:
    """Whether a car, driven a distance along an arc, stays more than `clearance` away from every
    obstacle all the way.
    """
    raise TypeError("this robot cannot be driven in this world")


@generic(1)
def coordinates(robot: Any) -> int:
    """How many numbers a configuration of this robot has."""
    raise InvalidParameter(f"expected a robot such as Point() or Disk(1), got {shortened(robot)}")
