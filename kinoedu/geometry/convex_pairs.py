"""Intersection tests for many pairs of convex polygons at once."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm, inlined
from ..errors import InvalidPolygon
from ..support.constructors import Constructor, with_type_names
from .checks import Array, as_array
from .convex import has_separating_edge, in_convex
from .exact import orientation_sign
from .rings import as_convex_ring


@with_type_names
class ConvexPolygonsRecord(NamedTuple):
    """The result of `ConvexPolygons`; treat it as read-only.

    rings : (m, n, 2), counter-clockwise.
    boxes : (m, 4), their bounding boxes as least x, least y, greatest x, greatest y.
    """

    rings: Array
    boxes: Array


class ConvexPolygons(ConvexPolygonsRecord, metaclass=Constructor):
    """Convex polygons of n vertices each, checked once for many intersection tests.

    The check is exact and O(n) for each polygon.

    Parameters
    ----------
    P : (m, n, 2) vertices of m convex polygons.

    Raises
    ------
    InvalidPolygon
        Where a polygon of P is not convex; the message gives its number.
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
    >>> ConvexPolygons([[(0, 0), (2, 0), (0, 2)]]).boxes
    array([[0., 0., 2., 2.]])
    """

    def __new__(cls, P: ArrayLike) -> ConvexPolygonsRecord:  # type: ignore[misc]  # returns the record
        return as_convex_polygons(P, "P")


def convex_pairs_intersect(
    P: ArrayLike | ConvexPolygonsRecord, Q: ArrayLike | ConvexPolygonsRecord
) -> NDArray[np.bool_]:
    """Whether the convex polygons P[i] and Q[i] share a point, for every i. Exact.

    Touching counts, and so does containment. The answers are those of `convex_polygons_intersect`.
    O(1) for a pair with disjoint bounding boxes, O(n k) at worst for others.

    Parameters
    ----------
    P, Q : (m, n, 2) and (m, k, 2) vertices of convex polygons, or `ConvexPolygons`, which are not
        checked again.

    Returns
    -------
    (m,) array of bool.

    Raises
    ------
    InvalidPolygon
        Where a polygon of P or Q is not convex (the message gives its number), or the shapes do not
        match.
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
    >>> triangle, square = [(0, 0), (2, 0), (0, 2)], [(1, 1), (2, 1), (2, 2), (1, 2)]
    >>> convex_pairs_intersect([triangle, triangle], [square, [(3, 3), (4, 3), (4, 4), (3, 4)]])
    array([ True, False])
    """
    P, Q = as_convex_polygons(P, "P"), as_convex_polygons(Q, "Q")
    if len(P.rings) != len(Q.rings):
        raise InvalidPolygon(
            f"P and Q must hold equally many polygons, got {len(P.rings)} and {len(Q.rings)}"
        )
    return pairs_intersect(P, Q)


def as_convex_polygons(
    polygons: ArrayLike | ConvexPolygonsRecord, name: str
) -> ConvexPolygonsRecord:
    """Polygons (m, n, 2), checked as by `as_convex_ring`; a record is returned unchanged."""
    if isinstance(polygons, ConvexPolygonsRecord):
        return polygons
    rings = as_array(polygons, name)
    if rings.ndim != 3 or rings.shape[1] < 3 or rings.shape[2] != 2:
        raise InvalidPolygon(
            f"{name} must be polygons of shape (m, n, 2), each of n >= 3 vertices, got shape "
            f"{rings.shape}"
        )
    orientations = convex_orientations(rings)
    for i in np.flatnonzero(orientations == 0)[:1]:
        as_convex_ring(rings[i], f"{name}[{i}]")  # raises the error that explains it
    clockwise = orientations < 0
    if clockwise.any():
        rings[clockwise] = rings[clockwise, ::-1]
    return ConvexPolygonsRecord(rings, bounding_boxes(rings))


@algorithm
def convex_orientations(rings: Array) -> NDArray[np.int64]:
    """`convex_orientation` of each ring, shape (m,)."""
    orientations = np.empty(len(rings), np.int64)
    for i in range(len(rings)):
        orientations[i] = convex_orientation(rings[i])
    return orientations


@inlined
def convex_orientation(ring: Array) -> int:
    """1 for a convex counter-clockwise ring, -1 for a convex clockwise ring, else 0. O(n), exact.

    A ring that always turns the same way is simple if its edges go once rightwards and once
    leftwards. Otherwise it winds around more than once or folds back. Vertical edges count as
    rightwards if they go up and as leftwards if they go down.
    """
    n = len(ring)
    direction, reversals = 0, 0
    ax, ay, bx, by = ring[n - 2, 0], ring[n - 2, 1], ring[n - 1, 0], ring[n - 1, 1]
    # bitwise operators avoid branches, which would be mispredicted half the time
    was_rightwards = (bx > ax) | ((bx == ax) & (by > ay))
    for i in range(n):
        cx, cy = ring[i, 0], ring[i, 1]
        side = orientation_sign(ax, ay, bx, by, cx, cy)
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
def bounding_boxes(rings: Array) -> Array:
    """The bounding box of each ring, shape (m, 4)."""
    boxes = np.empty((len(rings), 4))
    for i in range(len(rings)):
        boxes[i, 0], boxes[i, 2] = coordinate_range(rings[i], 0)
        boxes[i, 1], boxes[i, 3] = coordinate_range(rings[i], 1)
    return boxes


@algorithm
def pairs_intersect(P: ConvexPolygonsRecord, Q: ConvexPolygonsRecord) -> NDArray[np.bool_]:
    """Whether the convex rings P[i] and Q[i] share a point, shape (m,)."""
    intersects = np.zeros(len(P.rings), np.bool_)
    for i in range(len(P.rings)):
        if boxes_meet(P.boxes, Q.boxes, i):
            p, q = P.rings[i], Q.rings[i]
            k = corner_near_middle(q, P.boxes, i)
            intersects[i] = in_convex(q[k, 0], q[k, 1], p) or not (
                has_separating_edge(p, q) or has_separating_edge(q, p)
            )
    return intersects


@inlined
def boxes_meet(a: Array, b: Array, i: int) -> bool:
    """Whether the boxes a[i] and b[i] (least x, least y, greatest x, greatest y) share a point."""
    # bitwise, because branches would be mispredicted
    return (a[i, 0] <= b[i, 2]) & (b[i, 0] <= a[i, 2]) & (a[i, 1] <= b[i, 3]) & (b[i, 1] <= a[i, 3])


@inlined
def corner_near_middle(ring: Array, boxes: Array, i: int) -> int:
    """The corner nearest to the middle of a box; of polygons that meet, it is often in both."""
    x, y = 0.5 * boxes[i, 0] + 0.5 * boxes[i, 2], 0.5 * boxes[i, 1] + 0.5 * boxes[i, 3]
    nearest, least = 0, np.inf
    for k in range(len(ring)):
        dx, dy = ring[k, 0] - x, ring[k, 1] - y
        apart = dx * dx + dy * dy
        nearest = k if apart < least else nearest
        least = apart if apart < least else least
    return nearest


@inlined
def coordinate_range(points: Array, axis: int) -> tuple[float, float]:
    """The least and the greatest coordinate of points along an axis."""
    low = high = points[0, axis]
    for i in range(1, len(points)):
        value = points[i, axis]
        low = value if value < low else low
        high = value if value > high else high
    return low, high
