"""Convex polygons: membership, intersection, hulls, and polygons as unions of convex parts."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled, inlined
from ..errors import InvalidPolygon
from .checks import Array, as_points, one_or_many
from .ear_clipping import cut_into_convex_parts
from .exact import orientation_sign
from .rings import as_convex_ring, ring_orientation

Corner = tuple[float, float]
T = TypeVar("T")  # a point, or its number


def point_in_convex_polygon(q: ArrayLike, P: ArrayLike) -> bool:
    """Whether points lie in a convex polygon or on its boundary. Exact.

    A point lies in P if it is not to the right of any edge. O(n) for each point, after an O(n^2)
    check that the polygon is simple.

    Parameters
    ----------
    q : (2,) point or (m, 2) points.
    P : (n, 2) vertices of a convex polygon.

    Returns
    -------
    bool, or (m,) array for many points.

    Raises
    ------
    InvalidPolygon
        Where P is not convex.
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
    >>> triangle = [(0, 0), (4, 0), (0, 4)]
    >>> point_in_convex_polygon((1, 1), triangle), point_in_convex_polygon((3, 2), triangle)
    (True, False)
    """
    points, ring = as_points(q, "q"), as_convex_ring(P, "P")
    return one_or_many(q, points_in_convex(points, ring))


def convex_polygons_intersect(P: ArrayLike, Q: ArrayLike) -> bool:
    """Whether two convex polygons share a point; touching counts. Exact.

    They are disjoint exactly when one lies strictly to the right of an edge of the other
    (separating axis theorem). O(n m), after an O(n^2 + m^2) check that both are simple.

    Parameters
    ----------
    P, Q : (n, 2) and (m, 2) vertices of convex polygons.

    Raises
    ------
    InvalidPolygon
        Where P or Q is not convex.
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> convex_polygons_intersect(square, [(1, 1), (2, 1), (2, 2)])
    True
    >>> convex_polygons_intersect(square, [(2, 0), (3, 0), (3, 1)])
    False
    """
    P, Q = as_convex_ring(P, "P"), as_convex_ring(Q, "Q")
    return not (has_separating_edge(P, Q) or has_separating_edge(Q, P))


def convex_hull(points: ArrayLike) -> Array:
    """The corners of the convex hull of points, counter-clockwise from the leftmost.

    O(n log n), exact. Source: A. M. Andrew, "Another efficient algorithm for convex hulls in two
    dimensions" (1979).

    Parameters
    ----------
    points : (m, 2) points.

    Returns
    -------
    (k, 2) array
        Points inside an edge of the hull are left out. Collinear points give the two ends, and
        equal points give one point.

    Raises
    ------
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
    >>> convex_hull([(0, 0), (1, 0), (2, 0), (1, 1), (2, 2), (0, 2)])
    array([[0., 0.],
           [2., 0.],
           [2., 2.],
           [0., 2.]])
    """
    return hull_of(as_points(points))


@compiled
def hull_of(points: Array) -> Array:
    """The convex hull of points, shape (k, 2)."""
    ordered = sorted_without_repeats(points)
    if len(ordered) < 3:
        return ordered
    below, above = half_hull(ordered)[:-1], half_hull(ordered[::-1].copy())[:-1]
    return np.concatenate((below, above))


@compiled
def sorted_without_repeats(points: Array) -> Array:
    """The points from left to right, of those below each other from below, each once."""
    by_height = points[np.argsort(points[:, 1], kind="mergesort")]
    ordered, size = by_height[np.argsort(by_height[:, 0], kind="mergesort")], 0
    for p in ordered:
        if size == 0 or p[0] != ordered[size - 1, 0] or p[1] != ordered[size - 1, 1]:
            ordered[size] = p
            size += 1
    return ordered[:size].copy()


@compiled
def half_hull(points: Array) -> Array:
    """One half of the hull: the points, in their order, at which the path turns left."""
    hull = np.empty_like(points)
    size = 0
    for p in points:
        while size > 1:
            a, b = hull[size - 2], hull[size - 1]
            if orientation_sign(a[0], a[1], b[0], b[1], p[0], p[1]) > 0:
                break
            size -= 1
        hull[size] = p
        size += 1
    return hull[:size]


@compiled
def in_convex(x: float, y: float, ring: Array) -> bool:
    """Whether a point lies in a convex ring."""
    for i in range(len(ring)):
        if orientation_sign(ring[i - 1, 0], ring[i - 1, 1], ring[i, 0], ring[i, 1], x, y) < 0:
            return False
    return True


@compiled
def is_on_convex(p: Array, ring: Array) -> bool:
    """Whether a point of a convex ring lies on its boundary."""
    for i in range(len(ring)):
        a, b = ring[i - 1], ring[i]
        if orientation_sign(a[0], a[1], b[0], b[1], p[0], p[1]) == 0:
            return True
    return False


@compiled
def points_in_convex(points: Array, ring: Array) -> NDArray[np.bool_]:
    """Whether each point lies in a convex ring, shape (m,)."""
    inside = np.empty(len(points), np.bool_)
    for i in range(len(points)):
        inside[i] = in_convex(points[i, 0], points[i, 1], ring)
    return inside


@inlined
def has_separating_edge(P: Array, Q: Array) -> bool:
    """Whether all of Q lies strictly to the right of one edge of P."""
    n, m = len(P), len(Q)
    ax, ay = P[n - 1, 0], P[n - 1, 1]
    witness = 0  # a corner of Q that is not beyond one edge often is not beyond the next either
    for i in range(n):
        bx, by = P[i, 0], P[i, 1]
        beyond = 0
        while beyond < m and orientation_sign(ax, ay, bx, by, Q[witness, 0], Q[witness, 1]) < 0:
            beyond += 1
            witness = witness + 1 if witness + 1 < m else 0
        if beyond == m:
            return True
        ax, ay = bx, by
    return False


def convex_parts(ring: Array, holes: Sequence[Array] = ()) -> list[Array]:
    """Convex polygons whose union is exactly the ring without its holes.

    The parts use the vertices of the ring and the holes only. A triangulation, by ears or, where
    there are holes, a constrained Delaunay triangulation, is merged pairwise as long as the union
    stays convex (after Hertel and Mehlhorn, 1983: for a ring without holes, at most four times as
    many parts as needed). The ring and each hole are as `as_ring` returns them.
    """
    if holes:
        return merge_convex_parts(triangulate_ring(ring, holes))
    parts = cut_into_convex_parts(ring)
    return [parts.points[i:j] for i, j in pairwise(parts.first)]


def triangulate_ring(ring: Array, holes: Sequence[Array]) -> list[Array]:
    """A constrained Delaunay triangulation of a ring with holes, as counter-clockwise rings."""
    import shapely

    polygon = shapely.Polygon(ring, holes)
    if not polygon.is_valid:
        raise InvalidPolygon(
            "a room must lie inside its polygon, apart from other rooms: "
            f"{shapely.is_valid_reason(polygon)}"
        )
    corners = [
        np.array(t.exterior.coords)[:3]
        for t in shapely.constrained_delaunay_triangles(polygon).geoms
    ]
    oriented = [(t, ring_orientation(t)) for t in corners]
    return [t if sign > 0 else t[::-1].copy() for t, sign in oriented if sign]


def merge_convex_parts(parts: list[Array]) -> list[Array]:
    """Merge convex parts that share an edge, as long as their union is convex."""
    merged = {number: corner_tuples(part) for number, part in enumerate(parts)}
    part_of = {edge: number for number, part in merged.items() for edge in directed_edges(part)}
    for number in range(len(parts)):
        open_edges = directed_edges(merged[number]) if number in merged else []
        while open_edges:
            a, b = open_edges.pop()
            other = part_of.get((b, a))  # the neighbour has the same edge reversed
            if other is None or other == number:
                continue
            union = merge_at_edge(merged[number], merged[other], a, b)
            # only the angles at b and a change
            if turns_right(union, 0) or turns_right(union, len(merged[number]) - 1):
                continue
            part_of.update(dict.fromkeys(directed_edges(merged.pop(other)), number))
            merged[number] = union
            open_edges = directed_edges(union)
    return [np.array(part) for part in merged.values()]


def corner_tuples(ring: Array) -> list[Corner]:
    """The points of a ring as tuples, which can be compared and looked up."""
    return [(x, y) for x, y in ring.tolist()]


def directed_edges(ring: list[T]) -> list[tuple[T, T]]:
    """The edges of a ring as pairs of points, or of the numbers of points."""
    return list(zip(ring, ring[1:] + ring[:1], strict=True))


def merge_at_edge(P: list[Corner], Q: list[Corner], a: Corner, b: Corner) -> list[Corner]:
    """The union of two parts: P has the edge a-b and Q the edge b-a.

    The ring goes from b along P to a, and back along Q.
    """
    i, j = P.index(b), Q.index(a)
    return P[i:] + P[:i] + (Q[j:] + Q[:j])[1:-1]


def turns_right(ring: list[Corner], i: int) -> bool:
    """Whether a ring turns right at its point i."""
    return bool(orientation_sign(*ring[i - 1], *ring[i], *ring[(i + 1) % len(ring)]) < 0)
