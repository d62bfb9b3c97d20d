"""Worlds that are made, not read: each a square, with its way from the lower left corner to the
upper right one or across.
"""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from ..errors import InvalidParameter
from ..geometry.checks import Array, as_generator, positive, whole
from ..problems import Problem, ProblemRecord
from ..robots import Point
from ..worlds import PolygonWorld

CORNER = 0.05  # of the side: where the ways begin and end


def scattered_polygons(
    obstacles: int = 20, *, fill: float = 0.8, size: float = 100.0, rng: int | np.random.Generator
) -> ProblemRecord:
    """A square of side `size` with convex polygons of 3 to 7 corners that never meet, and a way
    from corner to corner.

    fill : how much of its room a polygon takes, below 1; the gaps are what is left. Raises
        InvalidParameter.

    >>> scattered_polygons(5, rng=0).world.hi.tolist()
    [100.0, 100.0]
    """
    n, side, generator = (
        whole(obstacles, "obstacles", least=0),
        positive(size, "size"),
        as_generator(rng),
    )
    if not 0.0 < positive(fill, "fill") < 1.0:
        raise InvalidParameter(f"fill must be above 0 and below 1, got {fill!r}")
    k = max(1, math.ceil(math.sqrt(n)))
    room = (1.0 - 4.0 * CORNER) * side / k
    cells = np.column_stack(np.divmod(generator.permutation(k * k)[:n], k))
    polygons = [
        (2.0 * CORNER * side + room * (cell + 0.5)) + convex(fill * room / 2.0, generator)
        for cell in cells
    ]
    return Problem(
        Point(),
        PolygonWorld(square(side), polygons),
        [CORNER * side] * 2,
        [(1.0 - CORNER) * side] * 2,
    )


def convex(radius: float, rng: np.random.Generator) -> Array:
    """A polygon of 3 to 7 corners on a circle about the origin, the centre inside; shape (k, 2)."""
    k = int(rng.integers(3, 8))
    angles = 2.0 * np.pi * (np.arange(k) + rng.uniform(-0.2, 0.2, k) + rng.random()) / k
    return radius * np.column_stack([np.cos(angles), np.sin(angles)])


def narrow_passage(
    width: float = 2.0, *, thickness: float = 10.0, size: float = 100.0
) -> ProblemRecord:
    """A square of side `size`, halved by a wall with one passage in its middle, and a way from the
    left half to the right one.

    Raises InvalidParameter.

    >>> narrow_passage(1.0).start.tolist()
    [25.0, 50.0]
    """
    side, gap, wall = (
        positive(size, "size"),
        positive(width, "width"),
        positive(thickness, "thickness"),
    )
    if gap >= side or wall >= side / 2.0:
        raise InvalidParameter(
            f"width must be below {side:g} and thickness below {side / 2.0:g}, got {width!r} and "
            f"{thickness!r}"
        )
    left, right, low, high = (
        (side - wall) / 2.0,
        (side + wall) / 2.0,
        (side - gap) / 2.0,
        (side + gap) / 2.0,
    )
    walls = [[(left, a), (right, a), (right, b), (left, b)] for a, b in ((0.0, low), (high, side))]
    return Problem(
        Point(),
        PolygonWorld(square(side), walls),
        [side / 4.0, side / 2.0],
        [3.0 * side / 4.0, side / 2.0],
    )


def square(side: float) -> list[tuple[float, float]]:
    """The boundary."""
    return [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]


MADE: dict[str, Callable[..., Any]] = {
    "scattered polygons": scattered_polygons,
    "narrow passage": narrow_passage,
}
