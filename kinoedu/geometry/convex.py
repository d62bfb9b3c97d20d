"""Convex polygons: membership, intersection, hulls, and any polygon as a union of them."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled, inlined
from ..errors import InvalidPolygon
from .checks import Array, as_points, one_or_many
from .exact import turn
from .rings import as_convex_ring, first_reflex, ring_turn

Corner = tuple[float, float]


def point_in_convex_polygon(q: ArrayLike, P: ArrayLike) -> bool:
    """Whether q lies in the convex polygon P, shape (n, 2), or on its boundary: never to the right
    of an edge. Exact. O(n) a point, after an O(n^2) check that the polygon is simple.

    q may be many points, shape (m, 2): then the answer has shape (m,). Raises InvalidPolygon where
    P is not convex, InvalidPoint.

    >>> point_in_convex_polygon((1, 1), [(0, 0), (4, 0), (0, 4)]), point_in_convex_polygon((3, 2), [(0, 0), (4, 0), (0, 4)])
    (True, False)
    """
    points, ring = as_points(q, "q"), as_convex_ring(P, "P")
    return one_or_many(q, points_in_convex(points, ring))


def convex_polygons_intersect(P1: ArrayLike, P2: ArrayLike) -> bool:
    """Whether two convex polygons, shapes (n, 2) and (m, 2), share a point; touching counts. Exact.
    O(n m), after an O(n^2 + m^2) check that both are simple.

    They are apart exactly when all of one lies strictly to the right of an edge of the other
    (separating axis theorem). Raises InvalidPolygon where one is not convex, InvalidPoint.

    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> convex_polygons_intersect(square, [(1, 1), (2, 1), (2, 2)]), convex_polygons_intersect(square, [(2, 0), (3, 0), (3, 1)])
    (True, False)
    """
    P, Q = as_convex_ring(P1, "P1"), as_convex_ring(P2, "P2")
    return not (has_separating_edge(P, Q) or has_separating_edge(Q, P))


def convex_hull(points: ArrayLike) -> Array:
    """The corners of the smallest convex set that holds the points, counter-clockwise from the
    leftmost; shape (k, 2).

    Points on an edge of the hull are left out; points of one line give its two ends, equal points
    give one. O(n log n), exact. Source: A. M. Andrew, "Another efficient algorithm for convex hulls
    in two dimensions" (1979). Raises InvalidPoint.

    >>> convex_hull([(0, 0), (1, 0), (2, 0), (1, 1), (2, 2), (0, 2)])
    array([[0., 0.],
           [2., 0.],
           [2., 2.],
           [0., 2.]])
    """
    ordered = np.unique(as_points(points), axis=0)
    if len(ordered) < 3:
        return ordered
    return np.concatenate([chain(ordered)[:-1], chain(ordered[::-1].copy())[:-1]])


@compiled
def chain(points: Array) -> Array:
    """The points, in their order, without those at which the way does not turn left."""
    kept = np.empty_like(points)
    size = 0
    for p in points:
        while (
            size > 1
            and turn(
                kept[size - 2, 0],
                kept[size - 2, 1],
                kept[size - 1, 0],
                kept[size - 1, 1],
                p[0],
                p[1],
            )
            <= 0
        ):
            size -= 1
        kept[size] = p
        size += 1
    return kept[:size]


@compiled
def in_convex(x: float, y: float, ring: Array) -> bool:
    """Whether a point lies in a convex ring."""
    for i in range(len(ring)):
        if turn(ring[i - 1, 0], ring[i - 1, 1], ring[i, 0], ring[i, 1], x, y) < 0:
            return False
    return True


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
    # a corner of Q that is not to the right of one edge often is not to the right of the next
    witness = 0
    for i in range(n):
        bx, by = P[i, 0], P[i, 1]
        beyond = 0
        while beyond < m and turn(ax, ay, bx, by, Q[witness, 0], Q[witness, 1]) < 0:
            beyond += 1
            witness = witness + 1 if witness + 1 < m else 0
        if beyond == m:
            return True
        ax, ay = bx, by
    return False


def convex_parts(ring: Array, holes: Sequence[Array] = ()) -> list[Array]:
    """Convex polygons, made of the ring's own vertices, that together are exactly the ring without
    its holes.

    A constrained Delaunay triangulation whose triangles are joined, one after another, while they
    stay convex (after Hertel and Mehlhorn, 1983: at most four times as many parts as needed). The
    ring is as `as_ring` returns it; so is each hole.
    """
    if not holes and first_reflex(ring) < 0:
        return [ring]
    return joined(triangles(ring, holes))


def triangles(ring: Array, holes: Sequence[Array]) -> list[Array]:
    """A constrained Delaunay triangulation of a ring with holes: counter-clockwise triangles, shape
    (3, 2) each.
    """
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
    turns = [ring_turn(t) for t in corners]
    return [
        t if sign > 0 else t[::-1].copy() for t, sign in zip(corners, turns, strict=True) if sign
    ]


def joined(parts: list[Array]) -> list[Array]:
    """The same region in fewer convex parts: two that share an edge become one where the result is
    convex.
    """
    whole = {number: corners(part) for number, part in enumerate(parts)}
    beyond = {
        edge: number for number, part in whole.items() for edge in sides(part)
    }  # an edge is shared by its reverse
    for number in range(len(parts)):
        open_edges = sides(whole[number]) if number in whole else []
        while open_edges:
            a, b = open_edges.pop()
            other = beyond.get((b, a))
            if other is None or other == number:
                continue
            union = joined_at_edge(whole[number], whole[other], a, b)
            if not (
                turns_right(union, 0) or turns_right(union, len(whole[number]) - 1)
            ):  # at b and a; the rest stays as it was
                beyond.update(dict.fromkeys(sides(whole.pop(other)), number))
                whole[number] = union
                open_edges = sides(union)
    return [np.array(part) for part in whole.values()]


def corners(ring: Array) -> list[Corner]:
    """A ring's points, to be compared and looked up."""
    return [(x, y) for x, y in ring.tolist()]


def sides(ring: list[Corner]) -> list[tuple[Corner, Corner]]:
    """A ring's edges as pairs of points."""
    return list(zip(ring, ring[1:] + ring[:1], strict=True))


def joined_at_edge(P: list[Corner], Q: list[Corner], a: Corner, b: Corner) -> list[Corner]:
    """The ring round two parts of which P has the edge a-b and Q the edge b-a: from b along P to a,
    and back along Q.
    """
    i, j = P.index(b), Q.index(a)
    return P[i:] + P[:i] + (Q[j:] + Q[:j])[1:-1]


def turns_right(ring: list[Corner], i: int) -> bool:
    """Whether a ring turns right at its point i."""
    return bool(turn(*ring[i - 1], *ring[i], *ring[(i + 1) % len(ring)]) < 0)
