"""Shared parts of the exercises on polygons. Bullo & Smith, chapter 1."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....geometry.polygons import locate_point, nearest_on_ring
from ....geometry.segments import closest_on_segment
from ...shapes import Numbers
from ..shared.random_shapes import star_polygon
from .point_line_distance import turn_left

POLYGON = Numbers(("n", 2))
SQUARE = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)])
CORNER = np.array([(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (2.0, 2.0), (2.0, 6.0), (0.0, 6.0)])
WEDGE = np.array([(0.0, 0.0), (4.0, -0.004), (4.0, 0.004)])
TRIES = 1000


def kind_of(q: Array, polygon: Array) -> str:
    """Kind of a point: inside, on the boundary, or outside and nearest to an edge or a vertex.

    The edge from the last vertex to the first is a kind of its own.
    """
    where = locate_point(q[0], q[1], polygon)
    if where >= 0:
        return "inside" if where else "boundary"
    edge, _, _, region = nearest_on_ring(q[0], q[1], polygon)
    if region != 0:
        return "vertex"
    return "closing" if edge == len(polygon) - 1 else "edge"


def round_polygon(n: int) -> Array:
    """Regular polygon of n vertices, at the distance 10 from the origin, rounded to 2 digits."""
    angles = 2.0 * np.pi * np.arange(n) / n
    return np.round(10.0 * np.column_stack([np.cos(angles), np.sin(angles)]), 2) + 0.0


def points_around(rng: np.random.Generator, polygon: Array) -> Iterator[Array]:
    """Yield twelve random points around a round polygon, each with a unique nearest point."""
    for angle, far in zip(rng.uniform(0.0, 2.0 * np.pi, 12), rng.uniform(10.5, 12.0, 12)):
        q = np.round(far * np.array([np.cos(angle), np.sin(angle)]), 2)
        if not is_tied(q, polygon):
            yield q


def star_and_queries(
    rng: np.random.Generator, n: int, size: float, kinds: tuple[str, ...]
) -> tuple[Array, list[Array]]:
    """Random star-shaped polygon of n vertices, and a point of every kind.

    Another polygon is drawn where there is no room for one of the kinds.
    """
    while True:
        polygon = star_polygon(rng, n, size)
        queries = [random_query(rng, polygon, kind) for kind in kinds]
        found = [q for q in queries if q is not None]
        if len(found) == len(queries):
            return polygon, found


def random_query(rng: np.random.Generator, polygon: Array, kind: str) -> Array | None:
    """Random point of a kind whose nearest boundary point is clearly unique, or None."""
    lo, hi = polygon.min(axis=0), polygon.max(axis=0)
    for _ in range(TRIES):
        if kind == "boundary":
            i, share = rng.integers(len(polygon)), rng.choice([0.0, 0.25, 0.5])
            q = polygon[i - 1] + share * (polygon[i] - polygon[i - 1])
            if kind_of(q, polygon) == kind:  # otherwise rounding moved it off the edge
                return q
            continue
        side = polygon[-1] - polygon[0]
        beside = (
            polygon[0] + rng.uniform(0.1, 0.9) * side + rng.uniform(0.05, 1.0) * turn_left(side)
        )
        anywhere = (lo + hi) / 2 + rng.uniform(-1.0, 1.0, 2) * (hi - lo)
        q = np.round(beside if kind == "closing" else anywhere, 2) + 0.0
        if kind in ("inside", "vertex") and rng.random() < 0.5:
            # exactly as high as a vertex, so that a ray to the right passes through it
            q[1] = polygon[rng.integers(len(polygon)), 1]
        if kind_of(q, polygon) == kind and not is_tied(q, polygon):
            return q
    return None


def is_tied(q: Array, polygon: Array) -> bool:
    """Whether two boundary points are nearly equally near to q, or q is nearly on the boundary."""
    feet = nearest_on_edges(q, polygon)
    distances = np.sqrt(((feet - q) * (feet - q)).sum(axis=1))
    near = distances.argmin()
    gaps = np.abs(feet - feet[near]).max(axis=1)
    return bool(
        distances[near] < 0.01 or ((distances < 1.01 * distances[near]) & (gaps > 1e-9)).any()
    )


def nearest_on_edges(q: Array, polygon: Array) -> Array:
    """Point of each edge that is nearest to q, shape (n, 2)."""
    ends = zip(polygon, np.roll(polygon, -1, axis=0))
    return np.array([closest_on_segment(q[0], q[1], a[0], a[1], b[0], b[1])[:2] for a, b in ends])
