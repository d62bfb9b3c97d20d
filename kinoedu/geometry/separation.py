"""Two convex pieces: whether they meet, their distance, and a line that separates them.

A piece is given by rows begin..end of an array of points, whose first two columns are x and y. It
is a point, the ends of a segment, or a convex polygon, counter-clockwise. Radii are ignored.
"""

import numpy as np

from ..compiled import compiled
from .checks import Array
from .exact import height, length, orientation_sign
from .segments import closest_on_segment, segment_distance, segments_meet


@compiled
def pieces_meet(P: Array, p: int, p_end: int, Q: Array, q: int, q_end: int) -> bool:
    """Whether two pieces share a point; touching counts. Exact (separating axis theorem)."""
    if p_end - p <= 2 and q_end - q <= 2:
        a, b, c, d = P[p], P[p_end - 1], Q[q], Q[q_end - 1]
        return segments_meet(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1])
    return not (
        lies_beyond_edge(P, p, p_end, Q, q, q_end, 0)
        or lies_beyond_edge(Q, q, q_end, P, p, p_end, 0)
    )


@compiled
def insides_meet(P: Array, p: int, p_end: int, Q: Array, q: int, q_end: int) -> bool:
    """Whether the interiors of two polygons share a point; touching does not count. Exact."""
    return not (
        lies_beyond_edge(P, p, p_end, Q, q, q_end, 1)
        or lies_beyond_edge(Q, q, q_end, P, p, p_end, 1)
    )


@compiled
def lies_beyond_edge(
    P: Array, p: int, p_end: int, Q: Array, q: int, q_end: int, least: int
) -> bool:
    """Whether, at one edge of P, the orientation sign of every vertex of Q is less than `least`.

    With 0, Q lies strictly to the right of the edge. With 1, it may touch the edge's line.
    """
    last = p_end - 1
    for i in range(p, p_end):
        beyond = True
        for j in range(q, q_end):
            if (
                orientation_sign(P[last, 0], P[last, 1], P[i, 0], P[i, 1], Q[j, 0], Q[j, 1])
                >= least
            ):
                beyond = False
                break
        if beyond:
            return True
        last = i
    return False


@compiled
def pieces_distance(P: Array, p: int, p_end: int, Q: Array, q: int, q_end: int) -> float:
    """The distance between two pieces, 0 where they meet."""
    if pieces_meet(P, p, p_end, Q, q, q_end):
        return 0.0
    _, _, _, one = nearest_corner(P, p, p_end, Q, q, q_end)
    _, _, _, other = nearest_corner(Q, q, q_end, P, p, p_end)
    return min(one, other)


@compiled
def nearest_corner(
    P: Array, p: int, p_end: int, Q: Array, q: int, q_end: int
) -> tuple[int, int, int, float]:
    """The corner of P nearest to an edge of Q, as corner, the edge's two ends, and distance."""
    corner, tail, head, best = p, q, q, np.inf
    for i in range(p, p_end):
        last = q_end - 1
        for j in range(q, q_end):
            d = segment_distance(P[i, 0], P[i, 1], Q[last, 0], Q[last, 1], Q[j, 0], Q[j, 1])
            if d < best:
                corner, tail, head, best = i, last, j, d
            last = j
    return corner, tail, head, best


@compiled
def dividing_line(
    P: Array, p: int, p_end: int, Q: Array, q: int, q_end: int
) -> tuple[float, float, float, float]:
    """A line that bounds Q, from which P is as far away as possible, as x, y, nx, ny.

    The line passes through (x, y) with the unit normal (nx, ny), and Q lies behind it. For disjoint
    pieces, the distance of P from the line is the distance of the pieces. For pieces that meet, P
    reaches behind the line by the least penetration depth over all edges, 0 where they only touch.
    """
    if pieces_meet(P, p, p_end, Q, q, q_end):
        return shallowest_line(P, p, p_end, Q, q, q_end)
    i, a, b, one = nearest_corner(P, p, p_end, Q, q, q_end)
    j, c, d, other = nearest_corner(Q, q, q_end, P, p, p_end)
    if one <= other:
        x, y, nx, ny = line_towards(P[i, 0], P[i, 1], Q[a, 0], Q[a, 1], Q[b, 0], Q[b, 1])
        return x, y, nx, ny
    _, _, nx, ny = line_towards(Q[j, 0], Q[j, 1], P[c, 0], P[c, 1], P[d, 0], P[d, 1])
    return Q[j, 0], Q[j, 1], -nx, -ny


@compiled
def line_towards(
    px: float, py: float, ax: float, ay: float, bx: float, by: float
) -> tuple[float, float, float, float]:
    """The point of the segment a-b nearest to p, and the unit vector from it to p (not on a-b)."""
    x, y, region = closest_on_segment(px, py, ax, ay, bx, by)
    if region > 0:
        size = length(px - x, py - y)
        return x, y, (px - x) / size, (py - y) / size
    side, size = orientation_sign(ax, ay, bx, by, px, py), length(bx - ax, by - ay)
    return ax, ay, side * ((ay - by) / size), side * ((bx - ax) / size)


@compiled
def shallowest_line(
    P: Array, p: int, p_end: int, Q: Array, q: int, q_end: int
) -> tuple[float, float, float, float]:
    """Among the lines along the edges of two meeting pieces, the one with the least penetration."""
    best, x, y, nx, ny = -np.inf, Q[q, 0], Q[q, 1], 1.0, 0.0
    for swapped in (False, True):
        if swapped:
            R, r, r_end, S, s, s_end = P, p, p_end, Q, q, q_end
        else:
            R, r, r_end, S, s, s_end = Q, q, q_end, P, p, p_end
        last = r_end - 1
        for i in range(r, r_end):
            ax, ay, bx, by = R[last, 0], R[last, 1], R[i, 0], R[i, 1]
            last = i
            size = length(bx - ax, by - ay)
            if size == 0.0:
                continue
            deepest, depth = s, -np.inf
            for k in range(s, s_end):
                inwards = height(ax, ay, bx, by, S[k, 0], S[k, 1])
                if inwards > depth:
                    deepest, depth = k, inwards
            if -depth > best:
                best, nx, ny = -depth, (by - ay) / size, (ax - bx) / size
                x, y = ax, ay
                if swapped:
                    x, y, nx, ny = S[deepest, 0], S[deepest, 1], -nx, -ny
    return x, y, nx, ny
