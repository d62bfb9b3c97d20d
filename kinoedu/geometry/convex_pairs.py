"""Many pairs of convex polygons at once: which of them meet."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm, inlined
from ..errors import InvalidPolygon
from .checks import Array, as_array
from .convex import has_separating_edge
from .exact import turn
from .rings import as_convex_ring


class ConvexPolygonsRecord(NamedTuple):
    """What `ConvexPolygons` makes; nothing writes it.

    rings : (m, n, 2), counter-clockwise. boxes : (m, 4), round each: least x, least y, greatest x,
        greatest y.
    """

    rings: Array
    boxes: Array


def ConvexPolygons(vertices: ArrayLike) -> ConvexPolygonsRecord:
    """Convex polygons of n vertices each, shape (m, n, 2), checked once to be asked about many
    times.

    Exact, O(n) for each. Raises InvalidPolygon, which names the polygon by its number, where one is
    not convex; InvalidPoint.

    >>> ConvexPolygons([[(0, 0), (2, 0), (0, 2)]]).boxes
    array([[0., 0., 2., 2.]])
    """
    return as_convex_polygons(vertices, "vertices")


def convex_pairs_intersect(
    P: ArrayLike | ConvexPolygonsRecord, Q: ArrayLike | ConvexPolygonsRecord
) -> NDArray[np.bool_]:
    """Whether P[i] and Q[i], convex polygons, share a point, for every i; touching counts, and so
    does one inside the other.

    P has shape (m, n, 2) and Q (m, k, 2), or they are `ConvexPolygons`, which are not checked
    again: m pairs, the answer has shape (m,). Exact, and the same as `convex_polygons_intersect` of
    each pair. O(1) for pairs whose boxes are apart, O(n k) at worst for others. Raises
    InvalidPolygon, which names the polygon by its number, where one is not convex or the shapes do
    not match; InvalidPoint.

    >>> triangle, square = [(0, 0), (2, 0), (0, 2)], [(1, 1), (2, 1), (2, 2), (1, 2)]
    >>> convex_pairs_intersect([triangle, triangle], [square, [(3, 3), (4, 3), (4, 4), (3, 4)]])
    array([ True, False])
    """
    first, second = as_convex_polygons(P, "P"), as_convex_polygons(Q, "Q")
    if len(first.rings) != len(second.rings):
        raise InvalidPolygon(
            f"P and Q must hold equally many polygons, got {len(first.rings)} and "
            f"{len(second.rings)}"
        )
    return pairs_intersect(first, second)


def as_convex_polygons(
    polygons: ArrayLike | ConvexPolygonsRecord, name: str
) -> ConvexPolygonsRecord:
    """Polygons of shape (m, n, 2), each checked as by `as_convex_ring`; what has been checked stays
    as it is.
    """
    if isinstance(polygons, ConvexPolygonsRecord):
        return polygons
    rings = as_array(polygons, name)
    if rings.ndim != 3 or rings.shape[1] < 3 or rings.shape[2] != 2:
        raise InvalidPolygon(
            f"{name} must be polygons of shape (m, n, 2), each of n >= 3 vertices, got shape "
            f"{rings.shape}"
        )
    turns = convex_turns(rings)
    for i in np.flatnonzero(turns == 0)[:1]:
        as_convex_ring(rings[i], f"{name}[{i}]")  # says what is wrong with it
    clockwise = turns < 0
    rings[clockwise] = rings[clockwise, ::-1]
    return ConvexPolygonsRecord(rings, boxes_round(rings))


@algorithm
def convex_turns(rings: Array) -> NDArray[np.int64]:
    """For each ring 1 where it is convex and counter-clockwise, -1 where convex and clockwise, else
    0; shape (m,).
    """
    turns = np.empty(len(rings), np.int64)
    for i in range(len(rings)):
        turns[i] = convex_turn(rings[i])
    return turns


@inlined
def convex_turn(ring: Array) -> int:
    """The one direction in which a ring turns while its edges go once rightwards and once
    leftwards, or 0. O(n), exact.

    Upwards counts as rightwards, downwards as leftwards. A ring that keeps turning one way meets
    itself only if it goes round more than once, or folds back.
    """
    n = len(ring)
    direction, reversals = 0, 0
    ax, ay, bx, by = ring[n - 2, 0], ring[n - 2, 1], ring[n - 1, 0], ring[n - 1, 1]
    was_rightwards = (bx > ax) | (
        (bx == ax) & (by > ay)
    )  # without branches, which a computer would guess wrong half the time
    for i in range(n):
        cx, cy = ring[i, 0], ring[i, 1]
        side = turn(ax, ay, bx, by, cx, cy)
        is_rightwards = (cx > bx) | ((cx == bx) & (cy > by))
        if (
            side * direction < 0
            or (bx == cx and by == cy)
            or (side == 0 and is_rightwards != was_rightwards)
        ):
            return 0
        reversals += is_rightwards != was_rightwards
        direction = side if side != 0 else direction
        ax, ay, bx, by, was_rightwards = bx, by, cx, cy, is_rightwards
    return direction if reversals == 2 else 0


@algorithm
def boxes_round(rings: Array) -> Array:
    """The bounding box of each ring, shape (m, 4)."""
    boxes = np.empty((len(rings), 4))
    for i in range(len(rings)):
        boxes[i, 0], boxes[i, 2] = span(rings[i], 0)
        boxes[i, 1], boxes[i, 3] = span(rings[i], 1)
    return boxes


@algorithm
def pairs_intersect(P: ConvexPolygonsRecord, Q: ConvexPolygonsRecord) -> NDArray[np.bool_]:
    """Whether the convex rings P[i] and Q[i] share a point, shape (m,)."""
    meet = np.empty(len(P.rings), np.bool_)
    for i in range(len(P.rings)):
        p, q = P.rings[i], Q.rings[i]
        meet[i] = boxes_meet(P.boxes[i], Q.boxes[i]) and not (
            has_separating_edge(p, q) or has_separating_edge(q, p)
        )
    return meet


@inlined
def boxes_meet(a: Array, b: Array) -> bool:
    """Whether two boxes, each least x, least y, greatest x, greatest y, share a point."""
    return a[0] <= b[2] and b[0] <= a[2] and a[1] <= b[3] and b[1] <= a[3]


@inlined
def span(points: Array, axis: int) -> tuple[float, float]:
    """The least and the greatest coordinate of a set of points along an axis."""
    low = high = points[0, axis]
    for i in range(1, len(points)):
        value = points[i, axis]
        low = value if value < low else low
        high = value if value > high else high
    return low, high
