"""Simple polygons: which points they hold, how far a point is from one, and the way round it. Bullo
& Smith, chapter 1.

A polygon is a closed set: its boundary belongs to it.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from .checks import Array, as_point, as_points, one_or_many
from .exact import length, turn
from .rings import as_ring
from .segments import between, closest_on_segment, segment_distance


def point_in_polygon(q: ArrayLike, polygon: ArrayLike) -> bool:
    """Whether q lies in a simple polygon, shape (n, 2), or on its boundary. Exact. O(n) a point,
    after an O(n^2) check that the polygon is simple.

    q may be many points, shape (m, 2): then the answer has shape (m,). Raises InvalidPolygon,
    InvalidPoint.

    >>> corner = [(0, 0), (4, 0), (4, 4), (2, 4), (2, 2), (0, 2)]
    >>> point_in_polygon((1, 1), corner), point_in_polygon((1, 3), corner), point_in_polygon((1, 2), corner)
    (True, False, True)
    """
    return one_or_many(q, places(as_points(q, "q"), as_ring(polygon)) >= 0)


def point_polygon_distance(q: ArrayLike, polygon: ArrayLike) -> float:
    """The distance from q to a simple polygon, shape (n, 2); 0 inside and on the boundary. O(n) a
    point, after an O(n^2) check that the polygon is simple.

    q may be many points, shape (m, 2): then the answer has shape (m,). Raises InvalidPolygon,
    InvalidPoint.

    >>> point_polygon_distance((7, 8), [(0, 0), (4, 0), (4, 4), (0, 4)])
    5.0
    """
    return one_or_many(q, distances_to_ring(as_points(q, "q"), as_ring(polygon)))


def polygon_tangent(q: ArrayLike, polygon: ArrayLike) -> Array:
    """The unit vector in which a robot at q starts to circle a polygon counter-clockwise, shape
    (2,).

    Where the nearest boundary point is inside an edge, it is the direction of that edge; where it
    is a vertex, the tangent to the circle round that vertex through q, in the sense in which the
    edges go on there; at the vertex itself, the direction of the edge that leaves it. Among equally
    near edges the first counts. Raises InvalidPolygon, InvalidPoint.

    >>> polygon_tangent((2, -1), [(0, 0), (4, 0), (4, 4), (0, 4)])
    array([1., 0.])
    """
    q, ring = as_point(q, "q"), as_ring(polygon)
    edge, x, y, region = nearest_on_ring(q[0], q[1], ring)
    start = (edge + 1) % len(ring) if region == 2 else edge
    before, vertex, after = ring[start - 1], ring[start], ring[(start + 1) % len(ring)]
    direction = np.array([y - q[1], q[0] - x])
    if region == 0 or not direction.any():
        direction = after - vertex
    elif turn(before[0], before[1], vertex[0], vertex[1], after[0], after[1]) < 0:
        direction = -direction  # a vertex that turns inward is nearest only to what is inside
    return direction / length(direction[0], direction[1]) + 0.0


@compiled
def place(x: float, y: float, ring: Array) -> int:
    """Where a point is: 1 inside the ring, 0 on it, -1 outside. Counts the edges that a ray to the
    right crosses; exact.
    """
    inside = False
    j = len(ring) - 1
    for i in range(len(ring)):
        ax, ay, bx, by = ring[j, 0], ring[j, 1], ring[i, 0], ring[i, 1]
        j = i
        if max(ay, by) < y or min(ay, by) > y or max(ax, bx) < x:
            continue
        side = turn(ax, ay, bx, by, x, y)
        if side == 0 and between(ax, ay, bx, by, x, y):
            return 0
        if (ay > y) != (by > y) and (side > 0) == (by > ay):
            inside = not inside
    return 1 if inside else -1


@compiled
def places(points: Array, ring: Array) -> NDArray[np.int64]:
    """Where each point is, shape (m,): 1 inside the ring, 0 on it, -1 outside."""
    answers = np.empty(len(points), np.int64)
    for i in range(len(points)):
        answers[i] = place(points[i, 0], points[i, 1], ring)
    return answers


@compiled
def distances_to_ring(points: Array, ring: Array) -> Array:
    """The distance of each point to the polygon, shape (m,)."""
    distances = np.zeros(len(points))
    for k in range(len(points)):
        x, y = points[k, 0], points[k, 1]
        if place(x, y, ring) >= 0:
            continue
        distances[k] = np.inf
        for i in range(len(ring)):
            a, b = ring[i - 1], ring[i]
            distances[k] = min(distances[k], segment_distance(x, y, a[0], a[1], b[0], b[1]))
    return distances


@compiled
def nearest_on_ring(x: float, y: float, ring: Array) -> tuple[int, float, float, int]:
    """The boundary point nearest to (x, y): its edge (i leaves vertex i), itself, and its region on
    that edge as in segments.
    """
    n = len(ring)
    nearest, best = 0, np.inf
    for i in range(n):
        a, b = ring[i], ring[(i + 1) % n]
        distance = segment_distance(x, y, a[0], a[1], b[0], b[1])
        if distance < best:
            nearest, best = i, distance
    a, b = ring[nearest], ring[(nearest + 1) % n]
    cx, cy, region = closest_on_segment(x, y, a[0], a[1], b[0], b[1])
    return nearest, cx, cy, region
