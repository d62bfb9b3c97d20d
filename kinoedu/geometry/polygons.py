"""Simple polygons: membership, distance and tangents.

A polygon is a closed set: its boundary belongs to it. Source: Bullo & Smith, Lectures on Robotic
Planning and Kinematics, chapter 1.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from .checks import Array, as_point, as_points, one_or_many
from .exact import orientation_sign, unit_vector
from .rings import as_ring
from .segments import closest_on_segment, is_between, segment_distance


def point_in_polygon(q: ArrayLike, polygon: ArrayLike) -> bool:
    """Whether points lie in a simple polygon or on its boundary. Exact.

    O(n) for each point, after an O(n^2) check that the polygon is simple.

    Parameters
    ----------
    q : (2,) point or (m, 2) points.
    polygon : (n, 2) vertices.

    Returns
    -------
    bool, or (m,) array for many points.

    Raises
    ------
    InvalidPolygon
        Where the polygon is not simple.
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
    >>> corner = [(0, 0), (4, 0), (4, 4), (2, 4), (2, 2), (0, 2)]
    >>> point_in_polygon((1, 1), corner), point_in_polygon((1, 3), corner)
    (True, False)
    >>> point_in_polygon([(1, 2), (1, 3)], corner).tolist()
    [True, False]
    """
    return one_or_many(q, locate_points(as_points(q, "q"), as_ring(polygon)) >= 0)


def point_polygon_distance(q: ArrayLike, polygon: ArrayLike) -> float:
    """Distance from points to a simple polygon; 0 inside and on the boundary.

    O(n) for each point, after an O(n^2) check that the polygon is simple.

    Parameters
    ----------
    q : (2,) point or (m, 2) points.
    polygon : (n, 2) vertices.

    Returns
    -------
    float, or (m,) array for many points.

    Raises
    ------
    InvalidPolygon
        Where the polygon is not simple.
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
    >>> point_polygon_distance((7, 8), [(0, 0), (4, 0), (4, 4), (0, 4)])
    5.0
    """
    return one_or_many(q, distances_to_ring(as_points(q, "q"), as_ring(polygon)))


def polygon_tangent(q: ArrayLike, polygon: ArrayLike) -> Array:
    """The direction in which a robot at q starts to circle a polygon counter-clockwise.

    If the boundary point nearest to q is inside an edge, the result is the direction of that edge.
    If it is a vertex, the result is the tangent at q to the circle around that vertex, in the sense
    of the edges. If q is the vertex itself, the result is the direction of the edge that starts
    there. Among equally near edges the first counts.

    Parameters
    ----------
    q : (2,) point.
    polygon : (n, 2) vertices.

    Returns
    -------
    (2,) array
        A unit vector.

    Raises
    ------
    InvalidPolygon
        Where the polygon is not simple.
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
    >>> polygon_tangent((2, -1), [(0, 0), (4, 0), (4, 4), (0, 4)])
    array([1., 0.])
    """
    q, ring = as_point(q, "q"), as_ring(polygon)
    return np.array(tangent_to_ring(q[0], q[1], ring))


@compiled
def tangent_to_ring(x: float, y: float, ring: Array) -> tuple[float, float]:
    """The direction of `polygon_tangent`, for a counter-clockwise ring."""
    edge, near_x, near_y, region = nearest_on_ring(x, y, ring)
    start = (edge + 1) % len(ring) if region == 2 else edge
    before, vertex, after = ring[start - 1], ring[start], ring[(start + 1) % len(ring)]
    dx, dy = near_y - y, x - near_x
    turn = orientation_sign(before[0], before[1], vertex[0], vertex[1], after[0], after[1])
    if region == 0 or turn == 0 or (dx == 0.0 and dy == 0.0):
        dx, dy = after[0] - vertex[0], after[1] - vertex[1]
    elif turn < 0:
        dx, dy = -dx, -dy  # a reflex vertex is nearest only to points inside the polygon
    ux, uy = unit_vector(dx, dy)
    return ux + 0.0, uy + 0.0


@compiled
def locate_point(x: float, y: float, ring: Array) -> int:
    """Locate a point: 1 inside the ring, 0 on it, -1 outside. Exact.

    Counts the edges that a ray to the right crosses.
    """
    inside = False
    j = len(ring) - 1
    for i in range(len(ring)):
        ax, ay, bx, by = ring[j, 0], ring[j, 1], ring[i, 0], ring[i, 1]
        j = i
        if max(ay, by) < y or min(ay, by) > y or max(ax, bx) < x:
            continue
        side = orientation_sign(ax, ay, bx, by, x, y)
        if side == 0 and is_between(ax, ay, bx, by, x, y):
            return 0
        if (ay > y) != (by > y) and (side > 0) == (by > ay):
            inside = not inside
    return 1 if inside else -1


@compiled
def locate_points(points: Array, ring: Array) -> NDArray[np.int64]:
    """Locate each point: 1 inside the ring, 0 on it, -1 outside; shape (m,)."""
    answers = np.empty(len(points), np.int64)
    for i in range(len(points)):
        answers[i] = locate_point(points[i, 0], points[i, 1], ring)
    return answers


@compiled
def distances_to_ring(points: Array, ring: Array) -> Array:
    """The distance of each point to the polygon, shape (m,)."""
    distances = np.zeros(len(points))
    for k in range(len(points)):
        x, y = points[k, 0], points[k, 1]
        if locate_point(x, y, ring) >= 0:
            continue
        distances[k] = np.inf
        for i in range(len(ring)):
            a, b = ring[i - 1], ring[i]
            distances[k] = min(distances[k], segment_distance(x, y, a[0], a[1], b[0], b[1]))
    return distances


@compiled
def nearest_on_ring(x: float, y: float, ring: Array) -> tuple[int, float, float, int]:
    """The boundary point nearest to (x, y), as edge, x, y and region on that edge.

    Edge i starts at vertex i. Regions are those of `closest_point_on_segment`.
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
