"""Segments: nearest points, distances and intersections.

Source: Bullo & Smith, Lectures on Robotic Planning and Kinematics, chapter 1.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..errors import InvalidPoint
from .checks import Array, as_point, as_points, one_or_many
from .exact import dot_sign, height, length, orientation_sign


def closest_point_on_segment(q: ArrayLike, p1: ArrayLike, p2: ArrayLike) -> tuple[Array, int]:
    """The point of the segment p1-p2 nearest to q, and the region in which q lies.

    Parameters
    ----------
    q, p1, p2 : (2,) points; p1 and p2 may coincide.

    Returns
    -------
    point
        Shape (2,).
    region
        0 if the nearest point is inside the segment, 1 if it is p1, 2 if it is p2. The region is 1
        where p1 = p2.

    Raises
    ------
    InvalidPoint
        Where a point is not two finite numbers.

    Examples
    --------
    >>> closest_point_on_segment((1, 2), (0, 0), (4, 0))
    (array([1., 0.]), 0)
    >>> closest_point_on_segment((7, 4), (0, 0), (4, 0))
    (array([4., 0.]), 2)
    """
    q, p1, p2 = as_point(q, "q"), as_point(p1, "p1"), as_point(p2, "p2")
    x, y, region = closest_on_segment(q[0], q[1], p1[0], p1[1], p2[0], p2[1])
    return np.array([x, y]), int(region)


def point_segment_distance(q: ArrayLike, p1: ArrayLike, p2: ArrayLike) -> float:
    """Distance from one or many points to a segment, with relative error at most 1e-12.

    Parameters
    ----------
    q : (2,) point or (m, 2) points.
    p1, p2 : (2,) points; they may coincide.

    Returns
    -------
    float, or (m,) array for many points.

    Raises
    ------
    InvalidPoint
        Where a point is not two finite numbers.

    Examples
    --------
    >>> point_segment_distance((7, 4), (0, 0), (4, 0))
    5.0
    """
    points, p1, p2 = as_points(q, "q"), as_point(p1, "p1"), as_point(p2, "p2")
    return one_or_many(q, distances_to_segment(points, p1, p2))


def segments_intersect(p1: ArrayLike, p2: ArrayLike, p3: ArrayLike, p4: ArrayLike) -> bool:
    """Whether the closed segments p1-p2 and p3-p4 share a point. Exact.

    Parameters
    ----------
    p1, p2, p3, p4 : (2,) points, or (m, 2) points for m pairs of segments. A segment may be a
        single point.

    Returns
    -------
    bool, or (m,) array for many pairs.

    Raises
    ------
    InvalidPoint
        Where a point is not two finite numbers, or there are different numbers of points.

    Examples
    --------
    >>> segments_intersect((0, 0), (2, 0), (1, 0), (1, 5))
    True
    >>> segments_intersect((0, 0), (2, 0), (3, 0), (5, 0))
    False
    """
    names = ("p1", "p2", "p3", "p4")
    ends = [as_points(p, name) for p, name in zip((p1, p2, p3, p4), names, strict=True)]
    try:
        shape = np.broadcast_shapes(*(end.shape for end in ends))
    except ValueError:
        raise InvalidPoint(
            f"p1, p2, p3 and p4 must be one point each, or as many, got {[*map(len, ends)]}"
        ) from None
    answers = pairs_meet(*(np.broadcast_to(end, shape) for end in ends))
    return one_or_many(max((p1, p2, p3, p4), key=np.ndim), answers)


def segment_intersection(p1: ArrayLike, p2: ArrayLike, p3: ArrayLike, p4: ArrayLike) -> Array:
    """The points that the closed segments p1-p2 and p3-p4 share.

    Parameters
    ----------
    p1, p2, p3, p4 : (2,) points.

    Returns
    -------
    (k, 2) array
        k = 0 for no point, 1 for one point, 2 for the ends of an overlap, in the order from p1 to
        p2. The number k is exact. A shared point that is an end of a segment is returned unrounded.

    Raises
    ------
    InvalidPoint
        Where a point is not two finite numbers.

    Examples
    --------
    >>> segment_intersection((0, 0), (4, 4), (0, 4), (4, 0))
    array([[2., 2.]])
    >>> segment_intersection((0, 0), (4, 0), (1, 0), (9, 0))
    array([[1., 0.],
           [4., 0.]])
    """
    a, b, c, d = as_point(p1, "p1"), as_point(p2, "p2"), as_point(p3, "p3"), as_point(p4, "p4")
    points = np.empty((2, 2))
    return points[: shared_points(a, b, c, d, points)]


@compiled
def closest_on_segment(
    px: float, py: float, ax: float, ay: float, bx: float, by: float
) -> tuple[float, float, int]:
    """The point (x, y) of a-b nearest to p, and the region of p: 0 inside, 1 at a, 2 at b."""
    if dot_sign(ax, ay, bx, by, px, py) <= 0:
        return ax, ay, 1
    if dot_sign(bx, by, ax, ay, px, py) <= 0:
        return bx, by, 2
    ux, uy = bx - ax, by - ay
    size = length(ux, uy)
    along = ((px - ax) * (ux / size) + (py - ay) * (uy / size)) / size
    if along > 0.5:  # measured from the nearer end the error is smaller
        along = ((px - bx) * (ux / size) + (py - by) * (uy / size)) / size
        return bx + along * ux, by + along * uy, 0
    return ax + along * ux, ay + along * uy, 0


@compiled
def is_between(ax: float, ay: float, bx: float, by: float, px: float, py: float) -> bool:
    """Whether p, which must lie on the line through a and b, lies on the segment a-b."""
    return min(ax, bx) <= px <= max(ax, bx) and min(ay, by) <= py <= max(ay, by)


@compiled
def segments_meet(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, dx: float, dy: float
) -> bool:
    """Whether the closed segments a-b and c-d share a point; either may be one point. Exact."""
    if (
        max(ax, bx) < min(cx, dx)
        or max(cx, dx) < min(ax, bx)
        or max(ay, by) < min(cy, dy)
        or max(cy, dy) < min(ay, by)
    ):
        return False
    a_side, b_side = (
        orientation_sign(cx, cy, dx, dy, ax, ay),
        orientation_sign(cx, cy, dx, dy, bx, by),
    )
    c_side, d_side = (
        orientation_sign(ax, ay, bx, by, cx, cy),
        orientation_sign(ax, ay, bx, by, dx, dy),
    )
    if a_side * b_side < 0 and c_side * d_side < 0:
        return True
    return (
        (a_side == 0 and is_between(cx, cy, dx, dy, ax, ay))
        or (b_side == 0 and is_between(cx, cy, dx, dy, bx, by))
        or (c_side == 0 and is_between(ax, ay, bx, by, cx, cy))
        or (d_side == 0 and is_between(ax, ay, bx, by, dx, dy))
    )


@compiled
def segment_distance(px: float, py: float, ax: float, ay: float, bx: float, by: float) -> float:
    """The distance from p to the segment a-b."""
    if dot_sign(ax, ay, bx, by, px, py) <= 0:
        return length(px - ax, py - ay)
    if dot_sign(bx, by, ax, ay, px, py) <= 0:
        return length(px - bx, py - by)
    return abs(height(ax, ay, bx, by, px, py))


@compiled
def segments_distance(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, dx: float, dy: float
) -> float:
    """The distance between the segments a-b and c-d, 0 where they intersect."""
    if segments_meet(ax, ay, bx, by, cx, cy, dx, dy):
        return 0.0
    return min(
        min(segment_distance(ax, ay, cx, cy, dx, dy), segment_distance(bx, by, cx, cy, dx, dy)),
        min(segment_distance(cx, cy, ax, ay, bx, by), segment_distance(dx, dy, ax, ay, bx, by)),
    )


@compiled
def distances_to_segment(points: Array, a: Array, b: Array) -> Array:
    """The distance of each point to one segment, shape (m,)."""
    distances = np.empty(len(points))
    for i in range(len(points)):
        distances[i] = segment_distance(points[i, 0], points[i, 1], a[0], a[1], b[0], b[1])
    return distances


@compiled
def pairs_meet(a: Array, b: Array, c: Array, d: Array) -> NDArray[np.bool_]:
    """Whether the segments a[i]-b[i] and c[i]-d[i] share a point, shape (m,)."""
    intersects = np.empty(len(a), np.bool_)
    for i in range(len(a)):
        intersects[i] = segments_meet(
            a[i, 0], a[i, 1], b[i, 0], b[i, 1], c[i, 0], c[i, 1], d[i, 0], d[i, 1]
        )
    return intersects


@compiled
def shared_points(a: Array, b: Array, c: Array, d: Array, out: Array) -> int:
    """Write the points that two segments share into `out`, shape (2, 2); returns their number."""
    if not segments_meet(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]):
        return 0
    a_side = orientation_sign(c[0], c[1], d[0], d[1], a[0], a[1])
    b_side = orientation_sign(c[0], c[1], d[0], d[1], b[0], b[1])
    c_side = orientation_sign(a[0], a[1], b[0], b[1], c[0], c[1])
    d_side = orientation_sign(a[0], a[1], b[0], b[1], d[0], d[1])
    if a_side == 0 and b_side == 0 and c_side == 0 and d_side == 0:
        return write_overlap(a, b, c, d, out)
    if a_side == 0:
        out[0] = a
    elif b_side == 0:
        out[0] = b
    elif c_side == 0:
        out[0] = c
    elif d_side == 0:
        out[0] = d
    else:
        out[0] = proper_crossing(a, b, c, d)
    return 1


@compiled
def proper_crossing(a: Array, b: Array, c: Array, d: Array) -> Array:
    """The point where a-b and c-d cross, if both cross in their interiors.

    It divides a-b in the ratio of the distances of a and b from the line c-d.
    """
    from_a = abs(height(c[0], c[1], d[0], d[1], a[0], a[1]))
    from_b = abs(height(c[0], c[1], d[0], d[1], b[0], b[1]))
    if from_a <= from_b:
        return a + from_a / (from_a + from_b) * (b - a)
    return b + from_b / (from_a + from_b) * (a - b)


@compiled
def precedes(p: Array, q: Array) -> bool:
    """Whether p is smaller than q in lexicographic order: by x, then by y."""
    return p[0] < q[0] or (p[0] == q[0] and p[1] < q[1])


@compiled
def write_overlap(a: Array, b: Array, c: Array, d: Array, out: Array) -> int:
    """`shared_points` of two intersecting segments on one line; the end nearer a comes first."""
    if precedes(b, a) != precedes(d, c):
        c, d = d, c
    forward = precedes(a, b) or ((a == b).all() and precedes(c, d))
    out[0] = c if precedes(a, c) == forward else a
    out[1] = b if precedes(b, d) == forward else d
    return 2 if precedes(out[0], out[1]) or precedes(out[1], out[0]) else 1
