"""Random worlds of polygons in general position.

No two vertices have the same x, and no two polygons touch.
"""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ....geometry.checks import Array
from ...exercise import Given
from .random_shapes import star_polygon

if TYPE_CHECKING:
    from shapely import Polygon


def general_world(
    rng: np.random.Generator, obstacles: int, size: float, *, convex: bool = False
) -> Given:
    """Boundary and obstacles as arguments of an exercise, counter-clockwise, with two decimals."""
    while True:
        n = int(rng.integers(4, 9))
        boundary = round_polygon(rng, n, size) if convex else star_polygon(rng, n, size)
        room, holes = room_in(boundary), list[Array]()
        for _ in range(60 * obstacles):
            if len(holes) < obstacles:
                star = star_polygon(rng, int(rng.integers(3, 6)), 0.28 * size)
                obstacle = np.round(star + np.round(rng.uniform(-0.6, 0.6, 2) * size, 2), 2)
                holes += [obstacle] if room.fits(obstacle, holes) else []
        if len(holes) == obstacles and is_general([boundary, *holes]):
            return {"boundary": boundary, "obstacles": holes}


def round_polygon(rng: np.random.Generator, n: int, size: float) -> Array:
    """Convex polygon of n vertices, close to an ellipse."""
    angles = 2.0 * np.pi * (np.arange(n) + rng.uniform(-0.3, 0.3, n)) / n
    drawn: Array = np.column_stack([size * np.cos(angles), 0.7 * size * np.sin(angles)]).astype(
        float
    )
    return drawn.round(2) + 0.0


class Room(NamedTuple):
    """What is inside a boundary, but for a gap along it; obstacles keep the same gap."""

    inside: "Polygon"
    gap: float

    def fits(self, polygon: Array, others: list[Array]) -> bool:
        """Whether a simple polygon is inside, and apart from others."""
        import shapely

        left, below, right, above = self.inside.bounds
        (x0, y0), (x1, y1) = polygon.min(axis=0), polygon.max(axis=0)
        if x0 < left or y0 < below or x1 > right or y1 > above:
            return False
        shape = shapely.Polygon(polygon)
        return bool(
            shape.is_valid
            and self.inside.contains(shape)
            and all(shapely.Polygon(other).distance(shape) > self.gap for other in others)
        )


def room_in(boundary: Array) -> Room:
    """The room for obstacles inside a boundary (n, 2)."""
    import shapely

    gap = 0.02 * float(np.ptp(boundary[:, 0]))
    inside = shapely.Polygon(boundary).buffer(-gap)
    shapely.prepare(inside)
    return Room(inside, gap)


def is_general(rings: list[Array]) -> bool:
    """Whether no two vertices have the same x."""
    x = np.concatenate(rings)[:, 0]
    return len(np.unique(x)) == len(x)


def edges_round(boundary: Array, obstacles: list[Array]) -> Array:
    """All edges of a world, (n, 4): x, y of the first vertex and x, y of the second."""
    rings = (boundary, *obstacles)
    return np.vstack([np.hstack([ring, np.roll(ring, -1, axis=0)]) for ring in rings])


def between_vertices(rng: np.random.Generator, edges: Array) -> float:
    """Random x between the leftmost and rightmost vertex, clearly off every vertex, rounded."""
    x = np.unique(edges[:, 0])
    gaps = np.flatnonzero(np.diff(x) > 0.015)
    i = int(rng.choice(gaps))
    return float(round((x[i] + x[i + 1]) / 2, 3))


def beside_vertex(rng: np.random.Generator, edges: Array) -> float:
    """Random x just right of a vertex that has two decimals, where edges lie close together."""
    x = np.unique(edges[:, 0])
    i = int(rng.choice(np.flatnonzero(np.diff(x) > 0.015)))
    return float(round(x[i] + 0.003, 3))
