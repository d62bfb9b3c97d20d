"""Minkowski sums and differences, and erosion, of convex polygons.

They describe which positions of a robot's reference point put its shape in contact with an
obstacle. The boundary of the sum of two convex polygons consists of the edges of both, sorted by
direction; one walk around both polygons merges them. Sources: de Berg et al., Computational
Geometry, section 13.3; LaValle, section 4.3.2.

The order of the edges is decided exactly, and so is whether two are parallel. A corner of the sum
is a corner of P plus a corner of Q, each coordinate rounded once. The convex hull of the rounded
corners is returned, so the result is strictly convex.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..errors import InvalidPolygon
from .checks import Array, as_array
from .convex import convex_hull
from .exact import cross_sign, orientation_sign
from .rings import as_convex_ring
from .segments import precedes, proper_crossing


def minkowski_sum(P: ArrayLike, Q: ArrayLike) -> Array:
    """P ⊕ Q, the set of all sums p + q of points of two convex polygons.

    O((n + m) log(n + m)), after a check that both polygons are simple.

    Parameters
    ----------
    P, Q : (n, 2) and (m, 2) vertices of convex polygons. Two points are a segment, one is a
        point.

    Returns
    -------
    (k, 2) array
        The corners, counter-clockwise from the leftmost, k <= n + m. Parallel edges become one. The
        sum of two parallel segments is a segment, and the sum of two points is a point.

    Raises
    ------
    InvalidPolygon
        Where P or Q is not convex or has no vertices.
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
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
    """P ⊖ Q = P ⊕ (-Q), the set of all differences p - q of points of two convex polygons.

    It is the C-obstacle of an obstacle P for a robot Q that translates: the positions of Q's
    reference point, the origin, at which Q touches P. Bullo & Smith and LaValle (section 4.3.2) use
    the sign ⊖ in this sense. Other books use it for the positions at which Q fits into P, see
    `erosion`.

    Parameters, result and errors are those of `minkowski_sum`.

    Examples
    --------
    >>> minkowski_difference([(0, 0), (2, 0), (2, 1), (0, 1)], [(0, 0), (1, 0), (0, 1)])
    array([[-1.,  0.],
           [ 0., -1.],
           [ 2., -1.],
           [ 2.,  1.],
           [-1.,  1.]])
    """
    return minkowski_sum(P, -as_convex_corners(Q, "Q"))


def erosion(P: ArrayLike, Q: ArrayLike) -> Array:
    """The positions of Q's reference point, the origin, at which Q lies in the convex polygon P.

    These are all p with p + Q in P, contact included. Each edge of P is moved inward until Q's
    outermost corner is inside. New corners are rounded; whether a corner lies inside the next edge
    is then decided exactly. O(n (n + m)), after a check that both polygons are simple.

    Parameters
    ----------
    P, Q : (n, 2) and (m, 2) vertices of convex polygons. Of Q, two points are a segment, one is a
        point.

    Returns
    -------
    (k, 2) array
        The corners of a convex polygon, counter-clockwise from the leftmost. Shape (0, 2) where the
        set has no area: Q does not fit, or fits only with contact on two opposite sides.

    Raises
    ------
    InvalidPolygon
        Where P or Q is not convex or has no vertices.
    InvalidPoint
        Where a coordinate is not finite.

    Examples
    --------
    >>> erosion([(0, 0), (9, 0), (9, 6), (0, 6)], [(0, 0), (1, 0), (0, 1)])
    array([[0., 0.],
           [8., 0.],
           [8., 5.],
           [0., 5.]])
    """
    P, Q = convex_hull(as_convex_ring(P, "P")), as_convex_corners(Q, "Q")
    outermost = [Q[find_farthest_right(a, b, Q)] for a, b in zip(P, np.roll(P, -1, axis=0))]
    return clip_to_shifted_edges(P, P - Q[0], -np.array(outermost))


def clip_to_shifted_edges(ring: Array, start: Array, shifts: Array) -> Array:
    """The part of the convex polygon `start` inside all edges of a ring, each moved by its shift.

    Shifts have shape (n, 2). The result is (0, 2) where it has no area.
    """
    for a, b, shift in zip(ring, np.roll(ring, -1, axis=0), shifts):
        start = clip_to_left_of(start, a + shift, b + shift)
    corners = convex_hull(start)
    return corners if len(corners) > 2 else np.empty((0, 2))


def as_convex_corners(value: ArrayLike, name: str) -> Array:
    """The corners of a convex polygon, counter-clockwise from the leftmost.

    Straight angles are left out. Two points stand for a segment, one point for itself.

    Raises
    ------
    InvalidPolygon
        Where there are no vertices, or the polygon is not simple or not convex.
    InvalidPoint
        Where a coordinate is not finite or is larger than 1e150.
    """
    points = as_array(value, name)
    if points.size == 0:
        raise InvalidPolygon(f"{name} must have at least one vertex, got none")
    is_polygon = points.shape not in ((2,), (1, 2), (2, 2))
    return convex_hull(as_convex_ring(points, name) if is_polygon else points)


@compiled
def corner_pairs(P: Array, Q: Array) -> NDArray[np.int64]:
    """The corners of P ⊕ Q as rows (i, j), each for the corner P[i] + Q[j]; shape (k, 2).

    P and Q are as `as_convex_corners` returns them. From one row to the next, i or j advances by
    one along its edge, or both do where the two edges are parallel.
    """
    n, m = len(P), len(Q)
    p_edges, q_edges = n - (n == 1), m - (m == 1)  # a point has no edge, a segment has two
    pairs = np.zeros((p_edges + q_edges + 1, 2), np.int64)
    i, j, size = 0, 0, 1
    while i < p_edges or j < q_edges:
        if j == q_edges:
            order = 1
        elif i == p_edges:
            order = -1
        else:
            order = compare_edges(P[i], P[(i + 1) % n], Q[j], Q[(j + 1) % m])
        i += order >= 0
        j += order <= 0
        pairs[size, 0], pairs[size, 1] = i % n, j % m
        size += 1
    return pairs[: max(size - 1, 1)]  # the last row repeats the first


@compiled
def compare_edges(a: Array, b: Array, c: Array, d: Array) -> int:
    """Compare two edges in the walk from the leftmost corner.

    1 if a-b comes before c-d, -1 if it comes after, 0 if they have the same direction.
    """
    ab_goes_right, cd_goes_right = precedes(a, b), precedes(c, d)
    if ab_goes_right != cd_goes_right:
        return 1 if ab_goes_right else -1
    return cross_sign(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1])


@compiled
def find_farthest_right(a: Array, b: Array, points: Array) -> int:
    """The index of the point farthest to the right of the direction a-b; exact."""
    best = 0
    for k in range(1, len(points)):
        p, q = points[best], points[k]
        if cross_sign(a[0], a[1], b[0], b[1], p[0], p[1], q[0], q[1]) < 0:
            best = k
    return best


@compiled
def clip_to_left_of(ring: Array, a: Array, b: Array) -> Array:
    """The part of a convex ring that is not to the right of the line a-b, (k, 2).

    Crossing points are rounded.
    """
    n = len(ring)
    clipped, size = np.empty((n + 2, 2)), 0
    for i in range(n):
        p, q = ring[i], ring[(i + 1) % n]
        p_side = orientation_sign(a[0], a[1], b[0], b[1], p[0], p[1])
        q_side = orientation_sign(a[0], a[1], b[0], b[1], q[0], q[1])
        if p_side >= 0:
            clipped[size] = p
            size += 1
        if p_side * q_side < 0:
            clipped[size] = proper_crossing(p, q, a, b)
            size += 1
    return clipped[:size]
