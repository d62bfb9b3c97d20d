"""The corners of a polygonal world, linked into chains, for a rotating sweep.

Obstacles may touch and overlap. Every edge is cut at the corners that lie on it, so rings meet at
corners or cross. Rings that meet or cross are put into different *families*. Within a family only
neighbouring edges meet, so its edges have an order along every ray, which a sweep can maintain
(rotating_sweep.py). Every decision is exact, and no new point is computed.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import compiled
from ...decomposition.free_space import as_polygons
from ...geometry.checks import Array
from ...geometry.convex import directed_edges
from ...geometry.exact import orientation_sign
from ...geometry.polygons import locate_points
from ...geometry.segments import is_between, segments_meet
from ...worlds.checks import World
from ...worlds.polygon_world import rings_of


class Corners(NamedTuple):
    """The corners of a world.

    points : (n, 2), each corner once, then further places.
    nodes : (m,), the points round which shortest paths may turn.
    before, after : (k, n), the neighbours of each point on the ring of family k through it, with
        the obstacle to the left of before-point-after; -1 where there is no such ring.
    """

    points: Array
    nodes: NDArray[np.int64]
    before: NDArray[np.int64]
    after: NDArray[np.int64]


def corners_of(world: World, *further_places: Array) -> tuple[Corners, list[int]]:
    """The corners of a PolygonWorld, and the numbers of further places, which become nodes too.

    O(n^2) for n corners.

    Raises
    ------
    InvalidWorld
        Where the world has round obstacles.
    """
    solids = rings_of(as_polygons(world))
    numbers: dict[tuple[float, float], int] = {}
    rings = [
        [numbers.setdefault(corner, len(numbers)) for corner in map(tuple, ring.tolist())]
        for solid in solids
        for ring in solid
    ]
    corners = len(numbers)
    further = [numbers.setdefault(tuple(place.tolist()), len(numbers)) for place in further_places]
    points = np.array(list(numbers))
    rings = cut_at_corners(rings, points[:corners])
    before, after = link_rings(rings, assign_families(rings, points), len(points))
    nodes = turning_points(points[:corners], before, after) & ~find_swallowed(
        points[:corners], solids
    )
    numbered = np.append(np.flatnonzero(nodes), sorted(set(further))).astype(np.int64)
    return Corners(points, numbered, before, after), further


def cut_at_corners(rings: list[list[int]], points: Array) -> list[list[int]]:
    """The rings, cut at every corner that lies on one of their edges."""
    ends = np.array([edge for ring in rings for edge in directed_edges(ring)])
    on_edge: dict[int, list[int]] = {}
    for edge, point in points_on_edges(points, ends).reshape(-1, 2).tolist():
        on_edge.setdefault(edge, []).append(point)
    cut, edge = [], 0
    for ring in rings:
        corners: list[int] = []
        for p in ring:
            begin, end = points[ends[edge]]
            ahead = np.where(end >= begin, 1.0, -1.0)
            inner = sorted(on_edge.get(edge, ()), key=lambda i: tuple((points[i] * ahead).tolist()))
            corners += [p, *inner]
            edge += 1
        cut.append(corners)
    return cut


@compiled
def points_on_edges(points: Array, ends: NDArray[np.int64]) -> NDArray[np.int64]:
    """Pairs of an edge and a point strictly inside it, as one flat array."""
    found = [0 for _ in range(0)]  # empty, but a compiler sees that its items are integers
    for edge in range(len(ends)):
        a, b = points[ends[edge, 0]], points[ends[edge, 1]]
        for i in range(len(points)):
            if (
                i == ends[edge, 0]
                or i == ends[edge, 1]
                or not is_between(a[0], a[1], b[0], b[1], points[i, 0], points[i, 1])
            ):
                continue
            if orientation_sign(a[0], a[1], b[0], b[1], points[i, 0], points[i, 1]) == 0:
                found.append(edge)
                found.append(i)
    return np.array(found, dtype=np.int64)


def assign_families(rings: list[list[int]], points: Array) -> list[int]:
    """A family for each ring, chosen greedily: the first family in which it meets no other ring."""
    ends = np.array([(p, q, i) for i, ring in enumerate(rings) for p, q in directed_edges(ring)])
    meeting = rings_that_meet(points, ends, len(rings))
    families: list[int] = []
    for i in range(len(rings)):
        used = {families[j] for j in range(i) if meeting[i, j]}
        families.append(next(family for family in range(i + 1) if family not in used))
    return families


@compiled
def rings_that_meet(points: Array, ends: NDArray[np.int64], rings: int) -> NDArray[np.bool_]:
    """Whether ring i and ring j share a point, (rings, rings).

    The rows of `ends` are an edge's two points and its ring.
    """
    meets = np.zeros((rings, rings), np.bool_)
    for i in range(len(ends)):
        a, b = points[ends[i, 0]], points[ends[i, 1]]
        for j in range(i):
            if ends[i, 2] == ends[j, 2] or meets[ends[i, 2], ends[j, 2]]:
                continue
            c, d = points[ends[j, 0]], points[ends[j, 1]]
            if segments_meet(a[0], a[1], b[0], b[1], c[0], c[1], d[0], d[1]):
                meets[ends[i, 2], ends[j, 2]] = meets[ends[j, 2], ends[i, 2]] = True
    return meets


def link_rings(
    rings: list[list[int]], families: list[int], size: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The points before and after each point on the rings of each family, both (k, n)."""
    before, after = (np.full((max(families) + 1, size), -1) for _ in range(2))
    for ring, family in zip(rings, families, strict=True):
        after[family, ring] = np.roll(ring, -1)
        before[family, ring] = np.roll(ring, 1)
    return before, after


def find_swallowed(points: Array, solids: list[list[Array]]) -> NDArray[np.bool_]:
    """Whether each point (n, 2) lies strictly inside some obstacle."""
    inside = np.zeros(len(points), np.bool_)
    for number, (outer, *rooms) in enumerate(solids):
        solid_side = 1 if number > 0 else -1  # the first ring is the boundary, solid outside
        within = locate_points(points, outer) == solid_side
        for room in rooms:
            within &= locate_points(points, room) < 0
        inside |= within
    return inside


@compiled
def turning_points(
    points: Array, before: NDArray[np.int64], after: NDArray[np.int64]
) -> NDArray[np.bool_]:
    """Whether a shortest path may turn at each corner, (n,).

    It may where the free space round the corner takes more than half a turn, or consists of pieces
    that meet only there.
    """
    turning = np.zeros(len(points), np.bool_)
    for v in range(len(points)):
        gaps, has_wide_gap = 0, False
        for i in range(len(before)):
            if before[i, v] >= 0 and begins_gap(points, before, after, v, i):
                gaps += 1
                has_wide_gap = has_wide_gap or opens_wide(points, before[i, v], after, v)
        turning[v] = has_wide_gap or gaps > 1
    return turning


@compiled
def begins_gap(
    points: Array, before: NDArray[np.int64], after: NDArray[np.int64], v: int, i: int
) -> bool:
    """Whether free space begins where family i's obstacle ends, counter-clockwise round v.

    Where several obstacles end in one direction, it is counted once.
    """
    end = before[i, v]
    for j in range(len(before)):
        if j == i or before[j, v] < 0:
            continue
        if is_same_direction(points, v, after[j, v], end) or enters(
            points, before[j, v], v, after[j, v], end
        ):
            return False
        if j < i and is_same_direction(points, v, before[j, v], end):
            return False
    return True


@compiled
def opens_wide(points: Array, end: int, after: NDArray[np.int64], v: int) -> bool:
    """Whether no obstacle begins within half a turn counter-clockwise of where one ended at v."""
    x, y, ex, ey = points[v, 0], points[v, 1], points[end, 0], points[end, 1]
    for begin in after[:, v]:
        if begin >= 0 and orientation_sign(x, y, ex, ey, points[begin, 0], points[begin, 1]) >= 0:
            return False
    return True


@compiled
def is_same_direction(points: Array, v: int, a: int, b: int) -> bool:
    """Whether a and b lie in the same direction from v."""
    x, y = points[v, 0], points[v, 1]
    ax, ay, bx, by = points[a, 0], points[a, 1], points[b, 0], points[b, 1]
    return (
        orientation_sign(x, y, ax, ay, bx, by) == 0
        and (ax > x) == (bx > x)
        and (ay > y) == (by > y)
        and (ax < x) == (bx < x)
    )


@compiled
def enters(points: Array, before: int, v: int, after: int, ahead: int) -> bool:
    """Whether a motion from v towards a point ahead enters the obstacle left of before-v-after."""
    b, x, a, q = points[before], points[v], points[after], points[ahead]
    left_of_first = orientation_sign(b[0], b[1], x[0], x[1], q[0], q[1]) > 0
    left_of_second = orientation_sign(x[0], x[1], a[0], a[1], q[0], q[1]) > 0
    if orientation_sign(b[0], b[1], x[0], x[1], a[0], a[1]) > 0:
        return left_of_first and left_of_second
    return left_of_first or left_of_second
