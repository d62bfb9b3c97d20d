"""What every world has, and the check that an argument is a world."""

from typing import Protocol

from ..errors import InvalidWorld
from ..geometry.checks import Array
from ..support.text import shortened


class World(Protocol):
    """A world: everything outside the box from lo to hi, shapes (2,), is solid."""

    @property
    def lo(self) -> Array:
        """The lower left corner."""

    @property
    def hi(self) -> Array:
        """The upper right corner."""


def check_world(world: object) -> None:
    """Raise InvalidWorld for an argument without `lo` and `hi`, such as a list of vertices."""
    if not (hasattr(world, "lo") and hasattr(world, "hi")):
        raise InvalidWorld(
            f"expected a world such as PolygonWorld(boundary, obstacles), got {shortened(world)}"
        )
