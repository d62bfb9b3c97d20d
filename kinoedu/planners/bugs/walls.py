"""Walls: closed loops of edges round the obstacles, with the obstacle on their left."""

import math
from collections import defaultdict
from collections.abc import Iterable
from functools import cmp_to_key, partial
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...compiled import compiled
from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...geometry.convex import convex_parts
from ...geometry.exact import dot_sign, orientation_sign
from ...geometry.frames import frame_of, into_frame, out_of_frame
from ...geometry.polygons import locate_point
from ...geometry.rings import as_ring, ring_orientation
from ...geometry.segments import is_between, segments_meet
from ...support.text import shortened

# The largest turn at a corner of a grown ring: such a corner stands off by at most
# 1 / cos(CORNER / 2) < 1.001 times the clearance.
CORNER = math.radians(5.0)

# The union of obstacles is rounded to a grid of this fraction of their extent, or to that of their
# coordinates where it is coarser, so that rounding leaves no gaps between obstacles that meet.
GRID = 2.0**-44


class Walls(NamedTuple):
    """Edges that a robot can follow, with the obstacle on their left and free space on their right.

    Edge i leads from points[i] to points[after[i]]; `before` is the inverse of `after`. Where two
    loops touch at a corner, each has a point of its own there, and the passage between them is
    closed. Ring k, an obstacle or a hole, is points[first[k]:first[k + 1]].
    """

    points: Array
    before: NDArray[np.int64]
    after: NDArray[np.int64]
    first: NDArray[np.int64]


def check_obstacles(obstacles: Iterable[ArrayLike]) -> list[Array]:
    """Obstacles as checked rings, counter-clockwise.

    Raises
    ------
    InvalidPolygon
        Where an obstacle is not a simple polygon.
    InvalidPoint
        Where a coordinate is not a finite number.
    InvalidParameter
        Where `obstacles` is not a list.
    """
    is_list = isinstance(obstacles, Iterable) and not isinstance(obstacles, str)
    if not is_list or getattr(obstacles, "ndim", 1) == 0:
        raise InvalidParameter(
            "obstacles must be a list of polygons, each of shape (n, 2), got "
            f"{shortened(obstacles)}"
        )
    return [as_ring(obstacle, f"obstacle {number}") for number, obstacle in enumerate(obstacles)]


def make_walls(rings: list[Array], clearance: float) -> Walls:
    """The walls round checked rings that are grown by `clearance`.

    Obstacles that touch, overlap or contain one another are united first.
    """
    if clearance > 0.0:
        rings = [grow_ring(part, clearance) for ring in rings for part in convex_parts(ring)]
    return link_rings(unite_rings(rings) if any_meet(rings) else rings)


def rings_of(walls: Walls) -> list[Array]:
    """The obstacles and holes as rings."""
    return np.split(walls.points, walls.first[1:-1]) if len(walls.points) else []


@compiled
def contact(walls: Walls, q: Array) -> int:
    """Where a point is: 1 inside an obstacle, 0 on a wall, -1 in free space; exact."""
    inside = -1
    for k in range(len(walls.first) - 1):
        side = locate_point(q[0], q[1], walls.points[walls.first[k] : walls.first[k + 1]])
        if side == 0:
            return 0
        if side > 0:  # inside an obstacle, or in a hole of it, and so on
            inside = -inside
    return inside


def contact_with_rings(rings: list[Array], q: Array) -> int:
    """Where a point is among rings that are given: as `contact`, but 1 on an edge that two share.

    Exact also where obstacles meet, while the walls round them are rounded.
    """
    sides = [int(locate_point(q[0], q[1], ring)) for ring in rings]
    if 1 in sides:
        return 1
    sectors = [sector_at(ring, q) for ring, side in zip(rings, sides) if side == 0]
    if not sectors:
        return -1
    # the sectors leave no free direction where another one goes on at the end of each
    return int(all(any(holds(q, *other, end) for other in sectors) for _, end in sectors))


def sector_at(ring: Array, q: Array) -> tuple[Array, Array]:
    """The directions between which the inside is, seen from a point q of a ring.

    They are given by points of the ring; the inside is counter-clockwise from the first.
    """
    corner = np.flatnonzero((ring == q).all(axis=1))
    if len(corner):
        return ring[(corner[0] + 1) % len(ring)], ring[corner[0] - 1]
    edges = zip(np.roll(ring, 1, axis=0), ring)
    return next(
        (b, a) for a, b in edges if orientation_sign(*a, *b, *q) == 0 and is_between(*a, *b, *q)
    )


def holds(q: Array, begin: Array, end: Array, p: Array) -> bool:
    """Whether a ray that turns counter-clockwise round q from p is at once in a sector; exact."""
    turn, whole = half_turns(q, begin, p), half_turns(q, begin, end)
    return turn < whole or (turn == whole and orientation_sign(*q, *p, *end) > 0)


def half_turns(q: Array, a: Array, b: Array) -> int:
    """The turn counter-clockwise round q from a to b: 0, 1 below a half, 2 for a half, 3 above."""
    side = int(orientation_sign(*q, *a, *b))
    return 2 - side if side else 0 if dot_sign(*q, *a, *b) > 0 else 2


@compiled
def grow_ring(ring: Array, clearance: float) -> Array:
    """A convex ring grown by `clearance`; the edges are exact, the corners are short tangents."""
    n, size = len(ring), 0
    most = n + int(2.0 * math.pi / CORNER) + 1  # one piece for each corner, and a full turn
    outline = np.empty((most, 2))
    for i in range(n):
        (ux, uy), (vx, vy), (wx, wy) = ring[i - 1], ring[i], ring[(i + 1) % n]
        arrives = math.atan2(vy - uy, vx - ux)
        turning = (math.atan2(wy - vy, wx - vx) - arrives) % (2.0 * math.pi)
        if turning > math.pi:  # a straight corner, rounded to the wrong side
            continue
        pieces = max(1, math.ceil(turning / CORNER))
        half = 0.5 * turning / pieces
        reach = clearance / math.cos(half)
        for k in range(pieces):
            outward = arrives - 0.5 * math.pi + half * (2.0 * k + 1.0)
            x, y = vx + reach * math.cos(outward), vy + reach * math.sin(outward)
            if size == 0 or x != outline[size - 1, 0] or y != outline[size - 1, 1]:
                outline[size, 0], outline[size, 1] = x, y
                size += 1
    if size > 1 and outline[0, 0] == outline[size - 1, 0] and outline[0, 1] == outline[size - 1, 1]:
        size -= 1
    return outline[:size]


def any_meet(rings: list[Array]) -> bool:
    """Whether any two rings, taken as solid, share a point; exact."""
    boxes = [(ring.min(axis=0).tolist(), ring.max(axis=0).tolist()) for ring in rings]
    for (ring_a, (a_lo, a_hi)), (ring_b, (b_lo, b_hi)) in combinations(zip(rings, boxes), 2):
        apart = a_lo[0] > b_hi[0] or b_lo[0] > a_hi[0] or a_lo[1] > b_hi[1] or b_lo[1] > a_hi[1]
        if not apart and rings_meet(ring_a, ring_b):
            return True
    return False


@compiled
def rings_meet(P: Array, Q: Array) -> bool:
    """Whether two solid rings share a point."""
    if locate_point(P[0, 0], P[0, 1], Q) >= 0 or locate_point(Q[0, 0], Q[0, 1], P) >= 0:
        return True
    for i in range(len(P)):
        for j in range(len(Q)):
            a, b, c, d = P[i - 1], P[i], Q[j - 1], Q[j]
            if segments_meet(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]):
                return True
    return False


def unite_rings(rings: list[Array]) -> list[Array]:
    """The outlines of the union: obstacles counter-clockwise, holes clockwise."""
    import shapely

    frame = frame_of(np.concatenate(rings), GRID)
    solids = [shapely.Polygon(into_frame(frame, ring)) for ring in rings]
    union = shapely.set_precision(shapely.union_all(solids), frame.grid)
    outlines = []
    for part in shapely.get_parts(union):
        for i, outline in enumerate((part.exterior, *part.interiors) if not part.is_empty else ()):
            ring = out_of_frame(frame, shapely.get_coordinates(outline)[:-1])
            outlines.append(ring if (ring_orientation(ring) > 0) == (i == 0) else ring[::-1].copy())
    return outlines


def link_rings(rings: list[Array]) -> Walls:
    """The walls of rings; where several touch at a corner, each loop borders one free region."""
    points = np.concatenate([np.empty((0, 2)), *rings])
    walls = walls_of_rings(points, np.cumsum([0, *map(len, rings)], dtype=np.int64))
    if len(np.unique(points, axis=0)) < len(points):
        join_at_touching_corners(points, walls.before, walls.after)
    return walls


@compiled
def walls_of_rings(points: Array, first: NDArray[np.int64]) -> Walls:
    """The walls of rings that do not touch; ring k is points[first[k]:first[k + 1]]."""
    before, after = np.empty(len(points), np.int64), np.empty(len(points), np.int64)
    for k in range(len(first) - 1):
        for i in range(first[k], first[k + 1]):
            after[i] = i + 1 if i + 1 < first[k + 1] else first[k]
            before[after[i]] = i
    return Walls(points, before, after, first)


def join_at_touching_corners(
    points: Array, before: NDArray[np.int64], after: NDArray[np.int64]
) -> None:
    """Link each edge that arrives at a shared corner to the first edge met across free space."""
    at: defaultdict[Any, list[int]] = defaultdict(list)
    for i, point in enumerate(points.tolist()):
        at[tuple(point)].append(i)
    for shared in at.values():
        leading = [int(after[i]) for i in shared]
        for i in shared if len(shared) > 1 else ():
            order = partial(compare_by_turn, points, points[i], points[before[i]])
            after[i] = min(leading, key=cmp_to_key(order))
    before[after] = np.arange(len(points))


def compare_by_turn(points: Array, v: Array, u: Array, i: int, j: int) -> int:
    """-1 where a ray that turns counter-clockwise round v from u meets i before j, 1 if after.

    The comparison is exact.
    """
    a, b = points[i], points[j]
    a_after_half_turn, b_after_half_turn = (
        orientation_sign(*v, *u, *a) < 0,
        orientation_sign(*v, *u, *b) < 0,
    )  # in the second half of the turn
    if a_after_half_turn != b_after_half_turn:
        return 1 if a_after_half_turn else -1
    return -int(orientation_sign(*v, *a, *b))
