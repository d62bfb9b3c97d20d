"""Generated problems in a square: a diagonal query among polygons, or a wall with a passage."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from ..errors import InvalidParameter
from ..geometry.checks import Array, as_generator, integer, positive
from ..problems import Problem, ProblemRecord
from ..robots import Point
from ..worlds import PolygonWorld

CORNER = 0.05  # distance of start and goal from the corner, as a fraction of the side


def scattered_polygons(
    obstacles: int = 20, *, fill: float = 0.8, size: float = 100.0, rng: int | np.random.Generator
) -> ProblemRecord:
    """Problem in a square with disjoint convex polygons of 3 to 7 vertices.

    The query leads from corner to corner.

    Parameters
    ----------
    obstacles : the number of polygons.
    fill : the size of a polygon relative to its room, between 0 and 1; the rest is free.
    size : the side of the square.
    rng : a seed or a generator.

    Returns
    -------
    ProblemRecord

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> scattered_polygons(5, rng=0).world.hi.tolist()
    [100.0, 100.0]
    """
    n, side = integer(obstacles, "obstacles", least=0), positive(size, "size")
    generator = as_generator(rng)
    if not 0.0 < positive(fill, "fill") < 1.0:
        raise InvalidParameter(f"fill must be above 0 and below 1, got {fill!r}")
    k = max(1, math.ceil(math.sqrt(n)))
    room = (1.0 - 4.0 * CORNER) * side / k
    cells = np.column_stack(np.divmod(generator.permutation(k * k)[:n], k))
    polygons = [
        (2.0 * CORNER * side + room * (cell + 0.5)) + random_convex(fill * room / 2.0, generator)
        for cell in cells
    ]
    world = PolygonWorld(square(side), polygons)
    return Problem(Point(), world, [CORNER * side] * 2, [(1.0 - CORNER) * side] * 2)


def random_convex(radius: float, rng: np.random.Generator) -> Array:
    """Random polygon of 3 to 7 vertices on a circle about the origin, with its centre inside.

    Shape (k, 2).
    """
    k = int(rng.integers(3, 8))
    angles = 2.0 * np.pi * (np.arange(k) + rng.uniform(-0.2, 0.2, k) + rng.random()) / k
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def narrow_passage(
    width: float = 2.0, *, thickness: float = 10.0, size: float = 100.0
) -> ProblemRecord:
    """Problem in a square that a wall with one passage divides into two halves.

    The query leads from the left half to the right one.

    Parameters
    ----------
    width : the width of the passage.
    thickness : the thickness of the wall.
    size : the side of the square.

    Returns
    -------
    ProblemRecord

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> narrow_passage(1.0).start.tolist()
    [25.0, 50.0]
    """
    side, gap = positive(size, "size"), positive(width, "width")
    wall = positive(thickness, "thickness")
    if gap >= side or wall >= side / 2.0:
        raise InvalidParameter(
            f"width must be below {side:g} and thickness below {side / 2.0:g}, got {width!r} and "
            f"{thickness!r}"
        )
    left, right = (side - wall) / 2.0, (side + wall) / 2.0
    low, high = (side - gap) / 2.0, (side + gap) / 2.0
    walls = [[(left, a), (right, a), (right, b), (left, b)] for a, b in ((0.0, low), (high, side))]
    start, goal = [side / 4.0, side / 2.0], [3.0 * side / 4.0, side / 2.0]
    return Problem(Point(), PolygonWorld(square(side), walls), start, goal)


def square(side: float) -> list[tuple[float, float]]:
    """Vertices of the boundary."""
    return [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]


GENERATORS: dict[str, Callable[..., Any]] = {
    "scattered polygons": scattered_polygons,
    "narrow passage": narrow_passage,
}
