"""Random worlds of polygons in general position: no two vertices share an x, nothing touches
anything.
"""

from typing import Any

import numpy as np

from ....geometry.checks import Array
from .random_shapes import star_polygon


def general_world(
    rng: np.random.Generator, obstacles: int, size: float, *, convex: bool = False
) -> dict[str, Any]:
    """A boundary and obstacles as an exercise gives them, counter-clockwise, two decimals."""
    while True:
        n = int(rng.integers(4, 9))
        boundary = round_polygon(rng, n, size) if convex else star_polygon(rng, n, size)
        holes: list[Array] = []
        for _ in range(60 * obstacles):
            if len(holes) < obstacles:
                small = star_polygon(rng, int(rng.integers(3, 6)), 0.28 * size) + np.round(
                    rng.uniform(-0.6, 0.6, 2) * size, 2
                )
                holes += (
                    [np.round(small, 2)] if has_room(np.round(small, 2), boundary, holes) else []
                )
        if len(holes) == obstacles and is_general([boundary, *holes]):
            return {"boundary": boundary, "obstacles": holes}


def round_polygon(rng: np.random.Generator, n: int, size: float) -> Array:
    """A convex polygon of n vertices, near an ellipse."""
    angles = 2.0 * np.pi * (np.arange(n) + rng.uniform(-0.3, 0.3, n)) / n
    drawn: Array = np.column_stack([size * np.cos(angles), 0.7 * size * np.sin(angles)]).astype(
        float
    )
    return drawn.round(2) + 0.0


def has_room(polygon: Array, boundary: Array, others: list[Array]) -> bool:
    """Whether a simple polygon lies inside the boundary, some way off it and off the others."""
    import shapely

    room, body = 0.02 * float(np.ptp(boundary[:, 0])), shapely.Polygon(polygon)
    return bool(
        body.is_valid
        and shapely.Polygon(boundary).buffer(-room).contains(body)
        and all(shapely.Polygon(other).distance(body) > room for other in others)
    )


def is_general(rings: list[Array]) -> bool:
    """Whether no two vertices share an x."""
    x = np.concatenate(rings)[:, 0]
    return len(np.unique(x)) == len(x)


def edges_round(boundary: Array, obstacles: list[Array]) -> Array:
    """All edges of a world, (n, 4): rows x, y of the first vertex, x, y of the second, ring after
    ring.
    """
    return np.vstack(
        [np.hstack([ring, np.roll(ring, -1, axis=0)]) for ring in (boundary, *obstacles)]
    )


def between_vertices(rng: np.random.Generator, edges: Array) -> float:
    """A random x between the leftmost and the rightmost vertex, clearly off every vertex, short in
    writing.
    """
    x = np.unique(edges[:, 0])
    gaps = np.flatnonzero(np.diff(x) > 0.015)
    i = int(rng.choice(gaps))
    return float(round((x[i] + x[i + 1]) / 2, 3))
