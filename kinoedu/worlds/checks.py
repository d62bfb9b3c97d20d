"""What every world has, and the check that an argument is a world."""

from typing import Protocol

import numpy as np

from ..errors import InvalidWorld
from ..geometry.checks import Array
from ..support.text import shortened
from .moving import MovingWorldRecord

LEAST = 1e-150  # squares of shorter lengths vanish


class World(Protocol):
    """A world: everything outside the box from lo to hi, shapes (2,), is solid."""

    @property
    def lo(self) -> Array:
        """The lower left corner."""

    @property
    def hi(self) -> Array:
        """The upper right corner."""


def check_world(world: object) -> None:
    """Raise InvalidWorld for what is no world, such as a list of vertices, or has moving obstacles.

    A world of a reader's own is known by its `lo` and `hi`.
    """
    if not (hasattr(world, "lo") and hasattr(world, "hi")):
        raise InvalidWorld(
            f"expected a world such as PolygonWorld(boundary, obstacles), got {shortened(world)}"
        )
    if isinstance(world, MovingWorldRecord):
        raise InvalidWorld(
            "in a MovingWorld a configuration is free at some times only; give the world to "
            "TimedProblem, or its `still` here"
        )


def check_size(world: World) -> None:
    """Raise InvalidWorld for a world smaller than 1e-150: distances would be rounded to 0."""
    if (size := float(np.max(world.hi - world.lo))) < LEAST:
        raise InvalidWorld(
            f"a world must be at least 1e-150 in size, got {size:g}; choose a smaller unit of "
            "length"
        )
