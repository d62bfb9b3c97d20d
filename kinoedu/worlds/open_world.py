"""The unbounded plane with polygonal obstacles, for bug algorithms."""

from typing import NamedTuple

from ..geometry.checks import Array


class OpenWorld(NamedTuple):
    """Obstacles in the unbounded plane, rings of shape (n, 2); everything else is free.

    walls : the rings that a robot follows: the union of the obstacles, grown by the robot's
        clearance; holes are clockwise.
    lo, hi : the corners of a frame for pictures.
    """

    obstacles: list[Array]
    walls: list[Array]
    lo: Array
    hi: Array
