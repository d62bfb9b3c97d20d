"""The check that an argument is a world."""

from typing import Any

from ..errors import InvalidWorld
from ..support.text import shortened


def check_world(world: Any) -> None:
    """Raise InvalidWorld for an argument without `lo` and `hi`, such as a list of vertices."""
    if not (hasattr(world, "lo") and hasattr(world, "hi")):
        raise InvalidWorld(
            f"expected a world such as PolygonWorld(boundary, obstacles), got {shortened(world)}"
        )
