"""The contact sensor along walls, and where a straight motion is stopped; every decision is exact.

Obstacles are closed sets and the motion of a bug is semi-free: it may touch a wall, pass a corner
and slide along an edge. It is stopped where it would enter an obstacle, or pass between two
obstacles that touch.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import compiled
from ...geometry.checks import Array
from ...geometry.exact import dot_sign, height, length, orientation_sign
from ...geometry.segments import closest_on_segment, is_between, proper_crossing

BLOCKED, OPEN, ALONG_BEFORE, ALONG_AFTER = 0, 1, 2, 3  # where a direction leads from a corner
REACHED, AT_CORNER, ON_EDGE = 0, 1, 2  # where a straight motion ends


class WallReadings(NamedTuple):
    """What the contact sensor measures along the walls, for each of n points and its edge.

    Edge i leaves point i.

    opens : where the direction to the goal leads from the point: BLOCKED, OPEN, ALONG_BEFORE or
        ALONG_AFTER, along the edge before the point or after it.
    faces : whether the goal lies on the free side of the edge.
    on_line : whether the point lies on the start-goal line.
    foot, foot_at : the point inside the edge nearest to the goal, as a fraction of the edge and as
        (x, y); nan where there is none.
    crossing, crossing_at : the same for the point inside the edge on the start-goal line.
    """

    opens: NDArray[np.int64]
    faces: NDArray[np.bool_]
    on_line: NDArray[np.bool_]
    foot: Array
    foot_at: Array
    crossing: Array
    crossing_at: Array


@compiled
def classify_direction(
    ux: float,
    uy: float,
    vx: float,
    vy: float,
    wx: float,
    wy: float,
    dx: float,
    dy: float,
    sense: int,
) -> int:
    """Where a direction leads at the corner u, v, w, with the obstacle on its left.

    The direction is that from v to d (sense 1), or the opposite one (sense -1). The free directions
    are those counter-clockwise from the direction of u to that of w.
    """
    u_side, w_side = (
        sense * orientation_sign(vx, vy, dx, dy, ux, uy),
        sense * orientation_sign(vx, vy, dx, dy, wx, wy),
    )
    if u_side == 0 and sense * dot_sign(vx, vy, dx, dy, ux, uy) > 0:
        return ALONG_BEFORE
    if w_side == 0 and sense * dot_sign(vx, vy, dx, dy, wx, wy) > 0:
        return ALONG_AFTER
    corner = orientation_sign(ux, uy, vx, vy, wx, wy)
    if corner > 0:
        return BLOCKED if w_side < 0 and u_side > 0 else OPEN
    if corner < 0:
        return OPEN if u_side < 0 and w_side > 0 else BLOCKED
    return OPEN if w_side > 0 else BLOCKED


@compiled
def sense_walls(
    points: Array, before: NDArray[np.int64], after: NDArray[np.int64], start: Array, goal: Array
) -> WallReadings:
    """What the contact sensor measures along the walls from start to goal. O(n)."""
    n = len(points)
    opens, faces, on_line = np.empty(n, np.int64), np.empty(n, np.bool_), np.empty(n, np.bool_)
    foot, crossing = np.full(n, np.nan), np.full(n, np.nan)
    foot_at, crossing_at = np.empty((n, 2)), np.empty((n, 2))
    (sx, sy), (gx, gy) = start, goal
    for i in range(n):
        (ux, uy), (ax, ay), (bx, by) = points[before[i]], points[i], points[after[i]]
        opens[i] = classify_direction(ux, uy, ax, ay, bx, by, gx, gy, 1)
        to_goal, to_start = (
            orientation_sign(ax, ay, bx, by, gx, gy),
            orientation_sign(ax, ay, bx, by, sx, sy),
        )
        faces[i] = to_goal < 0
        a_side, b_side = (
            orientation_sign(sx, sy, gx, gy, ax, ay),
            orientation_sign(sx, sy, gx, gy, bx, by),
        )
        on_line[i] = a_side == 0 and is_between(sx, sy, gx, gy, ax, ay)
        x, y, region = closest_on_segment(gx, gy, ax, ay, bx, by)
        if region == 0:
            foot[i] = clamp_inside(length(x - ax, y - ay) / length(bx - ax, by - ay))
            foot_at[i, 0], foot_at[i, 1] = x, y
        if a_side * b_side < 0 and to_goal * to_start < 0:
            crossing[i] = crossing_fraction(ax, ay, bx, by, sx, sy, gx, gy)
            crossing_at[i] = proper_crossing(points[i], points[after[i]], start, goal)
    return WallReadings(opens, faces, on_line, foot, foot_at, crossing, crossing_at)


@compiled
def clamp_inside(along: float) -> float:
    """A fraction of an edge, kept strictly between 0 and 1."""
    return min(max(along, 1e-300), 1.0 - 2.0**-53)


@compiled
def crossing_fraction(
    ax: float, ay: float, bx: float, by: float, cx: float, cy: float, dx: float, dy: float
) -> float:
    """The fraction of a-b at which the line c-d crosses it."""
    from_a, from_b = abs(height(cx, cy, dx, dy, ax, ay)), abs(height(cx, cy, dx, dy, bx, by))
    return clamp_inside(from_a / (from_a + from_b))


@compiled
def first_contact(
    points: Array,
    before: NDArray[np.int64],
    after: NDArray[np.int64],
    origin: Array,
    goal: Array,
    left: int,
) -> tuple[int, int]:
    """Where a motion on the line from origin to goal ends.

    No position is rounded in these decisions: walls do not cross each other, so orientations alone
    decide which comes first. O(n).

    Parameters
    ----------
    left : the edge that the robot leaves, or -1. The line crosses it from its solid to its free
        side, and anything before that crossing is ignored.

    Returns
    -------
    REACHED, AT_CORNER or ON_EDGE, and the number of the corner or edge.
    """
    (ox, oy), (gx, gy) = origin, goal
    how, which = REACHED, -1
    for i in range(len(points)):
        (ax, ay), (bx, by) = points[i], points[after[i]]
        a_side = orientation_sign(ox, oy, gx, gy, ax, ay)
        if a_side == 0 and is_between(ox, oy, gx, gy, ax, ay) and not (ax == ox and ay == oy):
            if left >= 0 and side_of(points, after, left, ax, ay) >= 0:
                continue
            ux, uy = points[before[i]]
            came_from_here = classify_direction(ux, uy, ax, ay, bx, by, ox, oy, 1) != BLOCKED
            if (
                not came_from_here
                or classify_direction(ux, uy, ax, ay, bx, by, ox, oy, -1) != BLOCKED
            ):
                continue
            if (
                how == REACHED
                or (how == ON_EDGE and side_of(points, after, which, ax, ay) < 0)
                or (
                    how == AT_CORNER
                    and is_between(ox, oy, points[which, 0], points[which, 1], ax, ay)
                )
            ):
                how, which = AT_CORNER, i
        elif a_side > 0 and i != left and orientation_sign(ox, oy, gx, gy, bx, by) < 0:
            if (
                orientation_sign(ax, ay, bx, by, ox, oy) >= 0
                or orientation_sign(ax, ay, bx, by, gx, gy) <= 0
            ):
                continue
            if left >= 0 and crossed_before(points, after, i, left, 1):
                continue
            if (
                how == REACHED
                or (how == ON_EDGE and crossed_before(points, after, i, which, -1))
                or (
                    how == AT_CORNER
                    and side_of(points, after, i, points[which, 0], points[which, 1]) > 0
                )
            ):
                how, which = ON_EDGE, i
    return how, which


@compiled
def side_of(points: Array, after: NDArray[np.int64], edge: int, x: float, y: float) -> int:
    """The side of an edge that a point is on: 1 solid, -1 free, 0 in line with it."""
    a, b = points[edge], points[after[edge]]
    return orientation_sign(a[0], a[1], b[0], b[1], x, y)


@compiled
def crossed_before(
    points: Array, after: NDArray[np.int64], edge: int, other: int, behind: int
) -> bool:
    """Whether a line that enters an obstacle at `edge` does so before it crosses `other`.

    The line crosses `other` from the side `behind`. The two edges do not cross, so one of them lies
    entirely on one side of the line through the other.
    """
    a, b = points[other], points[after[other]]
    a_side = side_of(points, after, edge, a[0], a[1])
    b_side = side_of(points, after, edge, b[0], b[1])
    if a_side * b_side >= 0 and a_side + b_side != 0:
        return a_side + b_side > 0
    c, d = points[edge], points[after[edge]]
    c_side = side_of(points, after, other, c[0], c[1])
    d_side = side_of(points, after, other, d[0], d[1])
    return (c_side + d_side) * behind > 0
