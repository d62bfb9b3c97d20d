"""Departure times at which a straight motion, or a wait, collides with a moving obstacle.

A motion at constant speed that departs at time t is, after s units of time, at time t + s. In the
plane of s and that time, the set where it collides with one convex piece in straight motion is
convex: relative to the piece the robot is a point among grown obstacles, and its position depends
linearly on both. So each piece, in each of its straight stretches, forbids one interval of
departure times.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled
from ..geometry.checks import Array
from ..geometry.grown import grow_piece, hull_of_sums
from ..geometry.parts import Parts, make_parts
from ..robots.kinds import Robot
from ..robots.round import RoundRobot
from ..worlds.moving import MovingWorldRecord, position_at

PAUSE = 1e-9  # of the horizon: intervals of contact are extended by this at both ends


def relative_obstacles(
    robot: Robot, world: MovingWorldRecord, clearance: float
) -> tuple[Parts, NDArray[np.int64]]:
    """The C-obstacles of the robot in the frame of each moving piece.

    Returns
    -------
    Parts, convex polygons; round shapes are replaced by slightly larger polygons. And the `knots`
    of each, (k, 2).
    """
    shapes = world.shapes
    pieces: list[Any] = []
    own: list[int] = []
    if isinstance(robot, RoundRobot):
        bodies, radius = [np.zeros((1, 2))], robot.radius
    else:
        body = robot.shape
        bodies, radius = [body.points[a:b] for a, b in zip(body.first[:-1], body.first[1:])], 0.0
    for i in range(len(shapes.radius)):
        piece = shapes.points[shapes.first[i] : shapes.first[i + 1]]
        for body_piece in bodies:
            pieces.append(
                grow_piece(
                    sum_pieces(piece, -body_piece), float(shapes.radius[i]) + radius + clearance
                )
            )
            own.append(i)
    return make_parts(pieces, [0.0] * len(pieces)), world.knots[own].reshape(-1, 2)


def sum_pieces(piece: Array, other: Array) -> Array:
    """The convex hull of the sums of two convex pieces; a single point is a translation."""
    if len(other) == 1:
        return piece + other[0]
    return other + piece[0] if len(piece) == 1 else hull_of_sums(piece, other)


@compiled
def collision_intervals(
    hulls: Parts, knots: NDArray[np.int64], times: Array, places: Array, horizon: float,
    a: Array, vx: float, vy: float, duration: float,
) -> Array:  # fmt: skip
    """The closed intervals of departure times from a that collide; (k, 2), unsorted.

    The motion has the velocity (vx, vy) for `duration`.
    """
    contacts, size = np.empty((stretches(knots), 2)), 0
    for i in range(len(knots)):
        begin, end = knots[i, 0], knots[i, 1]
        for k in range(begin, end + 1):  # the stretch before knot k; for k = end, after all knots
            first = times[k - 1] if k > begin and times[k - 1] > 0.0 else 0.0
            last = times[k] if k < end and times[k] < horizon else horizon
            if first > last:
                continue
            x, y = position_at(times, places, begin, end, first)
            wx, wy = 0.0, 0.0
            if begin < k < end:
                wx = (places[k, 0] - places[k - 1, 0]) / (times[k] - times[k - 1])
                wy = (places[k, 1] - places[k - 1, 1]) / (times[k] - times[k - 1])
            low, high = collision_interval(
                hulls, i, a[0] - x, a[1] - y, vx, vy, wx, wy, duration, first, last
            )
            if low <= high:
                contacts[size, 0], contacts[size, 1] = low - PAUSE * horizon, high + PAUSE * horizon
                size += 1
    return contacts[:size].copy()


@compiled
def stretches(knots: NDArray[np.int64]) -> int:
    """The number of straight motions of all pieces, with the rests before and after."""
    return int((knots[:, 1] - knots[:, 0] + 1).sum())


@compiled
def collision_interval(
    hulls: Parts,
    i: int,
    x: float,
    y: float,
    vx: float,
    vy: float,
    wx: float,
    wy: float,
    duration: float,
    first: float,
    last: float,
) -> tuple[float, float]:
    """The interval of departure times t - s that collide with hull i in one straight stretch.

    A collision means that (x, y) + s v - (t - first) w lies in hull i for some 0 <= s <= duration
    and first <= t <= last: the rectangle of s and t, clipped by the edges of the hull. Without a
    collision the first number is larger than the second.
    """
    begin, end = hulls.first[i], hulls.first[i + 1]
    if is_out_of_range(
        hulls.points[begin:end, 0], x, duration * vx, (last - first) * wx
    ) or is_out_of_range(hulls.points[begin:end, 1], y, duration * vy, (last - first) * wy):
        return np.inf, -np.inf
    region, size = np.empty((4 + 2 * (end - begin), 2)), 4
    region[0, 0], region[0, 1], region[1, 0], region[1, 1] = 0.0, first, duration, first
    region[2, 0], region[2, 1], region[3, 0], region[3, 1] = duration, last, 0.0, last
    px, py = hulls.points[end - 1, 0], hulls.points[end - 1, 1]
    for k in range(begin, end):
        qx, qy = hulls.points[k, 0], hulls.points[k, 1]
        ex, ey = qx - px, qy - py
        at_corner = ex * (y - py) - ey * (x - px)
        by_s, by_t = ex * vy - ey * vx, ey * wx - ex * wy
        region, size = clip_by_half_plane(region, size, at_corner - first * by_t, by_s, by_t)
        if size == 0:
            break
        px, py = qx, qy
    low, high = np.inf, -np.inf
    for k in range(size):
        low, high = min(low, region[k, 1] - region[k, 0]), max(high, region[k, 1] - region[k, 0])
    return low, high


@compiled
def is_out_of_range(points: Array, x: float, by_s: float, by_t: float) -> bool:
    """Whether one coordinate never comes within the range of the points, so that nothing collides.

    The coordinate begins at x and changes by up to by_s and -by_t.
    """
    low, high = x + min(by_s, 0.0) - max(by_t, 0.0), x + max(by_s, 0.0) - min(by_t, 0.0)
    return bool(high < points.min() or low > points.max())


@compiled
def clip_by_half_plane(region: Array, size: int, c: float, a: float, b: float) -> tuple[Array, int]:
    """The part of a convex region where c + a s + b t >= 0 (Sutherland and Hodgman, 1974).

    The region is the first `size` rows.
    """
    clipped, n = np.empty_like(region), 0
    for k in range(size):
        s0, t0 = region[k - 1 if k > 0 else size - 1, 0], region[k - 1 if k > 0 else size - 1, 1]
        s1, t1 = region[k, 0], region[k, 1]
        before, here = c + a * s0 + b * t0, c + a * s1 + b * t1
        if (before < 0.0) != (here < 0.0):
            fraction = before / (before - here)
            clipped[n, 0], clipped[n, 1] = s0 + fraction * (s1 - s0), t0 + fraction * (t1 - t0)
            n += 1
        if here >= 0.0:
            clipped[n, 0], clipped[n, 1] = s1, t1
            n += 1
    return clipped, n


@compiled
def first_free_time(contacts: Array, t: float) -> float:
    """The first time from t on that lies in none of the closed intervals (k, 2)."""
    waiting = True
    while waiting:
        waiting = False
        for i in range(len(contacts)):
            if contacts[i, 0] <= t <= contacts[i, 1]:
                t, waiting = np.nextafter(contacts[i, 1], np.inf), True
    return t


@compiled
def complement_intervals(contacts: Array, horizon: float) -> Array:
    """The intervals of [0, horizon] outside the closed intervals (k, 2), in order; shape (m, 2)."""
    order, free, size, t = np.argsort(contacts[:, 0]), np.empty((len(contacts) + 1, 2)), 0, 0.0
    for i in order:
        if contacts[i, 0] > t:
            free[size, 0], free[size, 1] = t, min(contacts[i, 0], horizon)
            size += 1
        t = max(t, np.nextafter(contacts[i, 1], np.inf))
        if t > horizon:
            break
    if t <= horizon:
        free[size, 0], free[size, 1] = t, horizon
        size += 1
    return free[:size].copy()


@algorithm
def find_safe_intervals(
    hulls: Parts,
    knots: NDArray[np.int64],
    times: Array,
    places: Array,
    horizon: float,
    nodes: Array,
) -> tuple[Array, NDArray[np.int64]]:
    """The safe intervals (k, 2) of all nodes; those of node i are rows first[i]:first[i + 1]."""
    safe = np.empty((len(nodes) * (stretches(knots) + 1), 2))
    first = np.zeros(len(nodes) + 1, np.int64)
    for i in range(len(nodes)):
        contacts = collision_intervals(
            hulls, knots, times, places, horizon, nodes[i], 0.0, 0.0, 0.0
        )
        own = complement_intervals(contacts, horizon)
        safe[first[i] : first[i] + len(own)] = own
        first[i + 1] = first[i] + len(own)
    return safe[: first[-1]].copy(), first
