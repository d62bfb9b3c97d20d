"""Random points and polygons for cases.

Coordinates have few decimals, so that a failing case is easy to read and to copy.
"""

from collections.abc import Iterator

import numpy as np

from ....errors import InvalidPolygon
from ....geometry import convex_hull
from ....geometry.checks import Array
from ....geometry.rings import as_ring

SIZES = (3.0, 10.0, 10.0, 100.0, 1000.0)  # of the cases, from small to large


def points(rng: np.random.Generator, n: int, size: float) -> Array:
    """Random distinct points between -size and size, with at most two decimals; shape (n, 2)."""
    while True:
        drawn = np.round(rng.uniform(-size, size, (n, 2)), 0 if size < 5.0 else 2) + 0.0
        if len(np.unique(drawn, axis=0)) == n:
            return drawn


def star_polygon(rng: np.random.Generator, n: int, size: float) -> Array:
    """Random simple polygon of n vertices, counter-clockwise, rarely convex; shape (n, 2)."""
    while True:
        angles = np.sort(rng.uniform(0.0, 2.0 * np.pi, n))
        radii = size * rng.uniform(0.3, 1.0, n)
        drawn = np.round(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]), 2) + 0.0
        try:
            ring = as_ring(drawn)
        except InvalidPolygon:
            continue
        if np.array_equal(ring, drawn):  # otherwise it was clockwise
            return ring


def sizes(each: int) -> Iterator[float]:
    """Yield the sizes from small to large, each several times."""
    for size in SIZES:
        for _ in range(each):
            yield size


def convex_polygon(rng: np.random.Generator, n: int, size: float) -> Array:
    """Random convex polygon with integer vertices, at most n of them, between -size and size.

    The vertices are counter-clockwise and begin anywhere.
    """
    while True:
        corners = convex_hull(rng.integers(-int(size), int(size) + 1, (n, 2)).astype(float))
        if len(corners) > 2:
            return np.roll(corners, int(rng.integers(len(corners))), axis=0)
