"""The open plane with polygons in it: a world without a rim, as the Bug family walks it."""

from typing import NamedTuple

from ..geometry.checks import Array


class OpenWorld(NamedTuple):
    """Obstacles in the open plane, rings of shape (n, 2); what is no obstacle is free.

    walls : the rings that a robot follows: those of the united obstacles, grown by its clearance;
        holes clockwise.
    lo, hi : the corners of a frame for pictures.
    """

    obstacles: list[Array]
    walls: list[Array]
    lo: Array
    hi: Array
