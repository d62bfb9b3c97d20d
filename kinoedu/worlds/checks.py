"""Whether something is a world."""

from typing import Any

from ..errors import InvalidWorld
from ..support.text import shortened


def check_world(world: Any) -> None:
    """Raise InvalidWorld for what has no corners `lo` and `hi`, such as a list of vertices."""
    if not (hasattr(world, "lo") and hasattr(world, "hi")):
        raise InvalidWorld(
            f"expected a world such as PolygonWorld(boundary, obstacles), got {shortened(world)}"
        )
