"""Shared parts of the exercises on trapezoids and their neighbours. Bullo & Smith, chapter 2."""

from ....decomposition import trapezoidation
from ....geometry.checks import Array
from ....worlds import PolygonWorld
from ...shapes import Numbers

CELLS = Numbers(("n", 6))


def cells_of(boundary: Array, obstacles: list[Array]) -> Array:
    """Trapezoids of a world, (n, 6)."""
    return trapezoidation(PolygonWorld(boundary, obstacles)).trapezoids
