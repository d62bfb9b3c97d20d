"""Sums and differences of convex sets of points: what a robot's shape does to the obstacles that
its reference point must avoid.

Two convex polygons are added by walking round both at once and taking, at each step, the edge that
turns left the least: every edge of either occurs in the sum, and nothing else. Source: de Berg et
al., Computational Geometry, section 13.3; LaValle, section 4.3.2.

Which edge comes next, and which two are parallel, is decided exactly. A corner of the sum is a
corner of P plus one of Q, each coordinate rounded once; of the rounded corners the hull is
returned, so that the answer is strictly convex whatever was rounded.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..errors import InvalidPoint
from .checks import Array, as_points
from .convex import convex_hull
from .exact import bend, turn
from .rings import as_convex_ring
from .segments import before, proper_crossing


def minkowski_sum(P: ArrayLike, Q: ArrayLike) -> Array:
    """P ⊕ Q, all sums p + q: the corners of a convex polygon, counter-clockwise from the leftmost,
    shape (k, 2), k <= n + m.

    P and Q are convex polygons, shapes (n, 2) and (m, 2); two points stand for a segment, one for
    itself, and a sum of such is a segment or a point where it has no area. Parallel edges become
    one. O((n + m) log(n + m)), after a check that both are simple. Raises InvalidPolygon where one
    is not convex, InvalidPoint.

    >>> minkowski_sum([(0, 0), (2, 0), (2, 1), (0, 1)], [(0, 0), (1, 0), (0, 1)])
    array([[0., 0.],
           [3., 0.],
           [3., 1.],
           [2., 2.],
           [0., 2.]])
    """
    P, Q = as_convex_corners(P, "P"), as_convex_corners(Q, "Q")
    i, j = corner_pairs(P, Q).T
    return convex_hull(P[i] + Q[j])


def minkowski_difference(P: ArrayLike, Q: ArrayLike) -> Array:
    """P ⊖ Q, all differences p - q: where Q's reference point, the origin, may not be if Q is not
    to touch P. Shape (k, 2).

    This is the difference of Bullo & Smith and of LaValle (section 4.3.2), P ⊕ (-Q): the C-obstacle
    of a robot Q that is moved without turning. Where other books write the same sign for all places
    at which Q fits into P, see `erosion`. As `minkowski_sum`.

    >>> minkowski_difference([(0, 0), (2, 0), (2, 1), (0, 1)], [(0, 0), (1, 0), (0, 1)])
    array([[-1.,  0.],
           [ 0., -1.],
           [ 2., -1.],
           [ 2.,  1.],
           [-1.,  1.]])
    """
    return minkowski_sum(P, -as_convex_corners(Q, "Q"))


def erosion(P: ArrayLike, Q: ArrayLike) -> Array:
    """Where Q's reference point, the origin, may be for Q to lie in the convex polygon P, contact
    included: all p with p + Q in P.

    The corners of a convex polygon, counter-clockwise from the leftmost, shape (k, 2); (0, 2) where
    Q does not fit, or fits only with contact on two sides at once, so that there is no area. Each
    edge of P moves inward until Q's outermost corner is inside; which corners remain is decided
    exactly on the rounded ones. O(n (n + m)). Raises InvalidPolygon, InvalidPoint.

    >>> erosion([(0, 0), (9, 0), (9, 6), (0, 6)], [(0, 0), (1, 0), (0, 1)])
    array([[0., 0.],
           [8., 0.],
           [8., 5.],
           [0., 5.]])
    """
    P, Q = convex_hull(as_convex_ring(P, "P")), as_convex_corners(Q, "Q")
    outermost = [Q[farthest_right(a, b, Q)] for a, b in zip(P, np.roll(P, -1, axis=0))]
    return moved_inward(P, P - Q[0], -np.array(outermost))


def moved_inward(ring: Array, start: Array, shifts: Array) -> Array:
    """What the edges of a convex ring, each moved by its shift, (n, 2), leave of a convex polygon;
    (0, 2) where it has no area.
    """
    for a, b, shift in zip(ring, np.roll(ring, -1, axis=0), shifts):
        start = left_of(start, a + shift, b + shift)
    corners = convex_hull(start) if len(start) else start
    return corners if len(corners) > 2 else np.empty((0, 2))


def leftmost(ring: Array) -> int:
    """The number of a ring's leftmost vertex, the lower of two."""
    return int(np.lexsort(ring.T[::-1])[0])


def as_convex_corners(value: ArrayLike, name: str) -> Array:
    """A convex polygon's corners, straight angles left out, counter-clockwise from the leftmost; a
    segment's ends; a point.
    """
    points = as_points(value, name)
    if len(points) == 0:
        raise InvalidPoint(f"{name} must have at least one point, got none")
    return convex_hull(points if len(points) < 3 else as_convex_ring(points, name))


@compiled
def corner_pairs(P: Array, Q: Array) -> NDArray[np.int64]:
    """The corners of P ⊕ Q as rows i, j: corner P[i] + Q[j], shape (k, 2), for corners as
    `as_convex_corners` returns them.

    From one row to the next i or j goes on by one, along that edge; or both, where two edges are
    parallel.
    """
    n, m = len(P), len(Q)
    ends = n - (n == 1), m - (m == 1)  # a point has no edge, a segment has one there and one back
    pairs = np.zeros((ends[0] + ends[1] + 1, 2), np.int64)
    i, j, size = 0, 0, 1
    while i < ends[0] or j < ends[1]:
        side = (
            1
            if j == ends[1]
            else -1
            if i == ends[0]
            else first_to_turn(P[i], P[(i + 1) % n], Q[j], Q[(j + 1) % m])
        )
        i += side >= 0
        j += side <= 0
        pairs[size, 0], pairs[size, 1] = i % n, j % m
        size += 1
    return pairs[: max(size - 1, 1)]  # the last row is the first again


@compiled
def first_to_turn(a: Array, b: Array, c: Array, d: Array) -> int:
    """Which of the edges a-b and c-d comes first on the way round from the leftmost corner: 1, -1,
    or 0 for both at once.
    """
    out, back = before(a, b), before(c, d)
    if out != back:
        return 1 if out else -1
    return bend(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1])


@compiled
def farthest_right(a: Array, b: Array, points: Array) -> int:
    """The point that lies farthest to the right of the direction a-b; exact."""
    best = 0
    for k in range(1, len(points)):
        p, q = points[best], points[k]
        if bend(a[0], a[1], b[0], b[1], p[0], p[1], q[0], q[1]) < 0:
            best = k
    return best


@compiled
def left_of(ring: Array, a: Array, b: Array) -> Array:
    """The part of a convex ring that does not lie to the right of the line a-b, (k, 2); where they
    cross is rounded.
    """
    n = len(ring)
    kept, size = np.empty((n + 2, 2)), 0
    for i in range(n):
        p, q = ring[i], ring[(i + 1) % n]
        here, there = (
            turn(a[0], a[1], b[0], b[1], p[0], p[1]),
            turn(a[0], a[1], b[0], b[1], q[0], q[1]),
        )
        if here >= 0:
            kept[size] = p
            size += 1
        if here * there < 0:
            kept[size] = proper_crossing(p, q, a, b)
            size += 1
    return kept[:size]
