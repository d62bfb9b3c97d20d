"""Worlds of polygons, with rooms in their holes, and discs; geometry is exact."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..errors import InvalidPolygon, InvalidWorld
from ..geometry.checks import Array, as_array, as_list, as_point
from ..geometry.convex import convex_parts, hull_of, is_on_convex
from ..geometry.ear_clipping import cut_into_convex_parts
from ..geometry.parts import Parts, box_of, join_parts, make_parts
from ..geometry.rings import as_ring, leftmost_corner
from ..support.constructors import Constructor, with_type_names
from .occupancy import Occupancy, make_occupancy, no_occupancy
from .parts_index import PartsIndex, index_parts


@with_type_names
class PolygonWorldRecord(NamedTuple):
    """The record that `PolygonWorld` returns; nothing writes to it.

    edges : (n, 5), rows x, y, next x, next y, solid: edges with the solid side to their left, ring
        after ring. Solid 0 is the outside: the first ring is the boundary, clockwise. The others
        are the polygonal obstacles in their order: each outline counter-clockwise, followed by its
        rooms, clockwise.
    hull : (k, 2), the convex hull of the boundary, outside of which everything is solid.
    obstacles : the convex parts of the obstacles and of the pockets between boundary and hull, and
        then the round obstacles.
    cells, occupancy : the index of the parts, and the occupancy cells.
    lo, hi : the corners of the bounding box.
    """

    edges: Array
    hull: Array
    obstacles: Parts
    cells: PartsIndex
    occupancy: Occupancy
    lo: Array
    hi: Array


class PolygonWorld(PolygonWorldRecord, metaclass=Constructor):
    """A workspace bounded by a simple polygon, with obstacles.

    Parameters
    ----------
    boundary : (n, 2), a simple polygon, convex or not. Nothing outside it is free, and it is itself
        a wall.
    obstacles : each a simple polygon (m, 2); or a pair (centre, radius) for a round obstacle; or a
        pair (polygon, rooms), where each room is a simple polygon inside, with free interior; rooms
        may contain further obstacles. Obstacles are closed sets: touching is contact. They may
        overlap each other and the boundary.

    Returns
    -------
    PolygonWorldRecord

    Raises
    ------
    InvalidWorld, InvalidPolygon, InvalidPoint
        Where a polygon or a disc is not valid; the message gives the number of the obstacle.

    Examples
    --------
    >>> triangle, disc = [(2, 2), (4, 2), (3, 4)], ((7, 7), 1.5)
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [triangle, disc])
    >>> len(world.obstacles.radius)
    2
    """

    def __new__(cls, boundary: ArrayLike, obstacles: Iterable[Any] = ()) -> PolygonWorldRecord:  # type: ignore[misc]  # returns the record
        rings, solids, discs = [as_ring(boundary, "boundary")[::-1]], [0], np.empty((0, 3))
        pieces: list[Array] = []
        for number, obstacle in enumerate(as_list(obstacles, "obstacles")):
            name = f"obstacle {number}"
            if is_pair_with_radius(obstacle):
                discs = np.vstack([discs, as_disc(obstacle[0], obstacle[1], name)])
                continue
            ring, rooms = as_polygon_with_rooms(obstacle, name)
            try:
                pieces += convex_parts(ring, rooms) if rooms else []
            except InvalidPolygon as error:
                raise InvalidPolygon(f"{name}: {error}") from error
            solids += [solids[-1] + 1] * (1 + len(rooms))
            rings += [ring, *(room[::-1] for room in rooms)]
        first = np.cumsum([0, *map(len, rings)])
        world = world_of_rings(
            Rings(np.concatenate(rings), first, np.array(solids)),
            make_parts(pieces, [0.0] * len(pieces)),
            discs,
        )
        hull, parts, cells = world.hull, world.obstacles, world.cells
        return world._replace(occupancy=make_occupancy(hull, parts, cells, world.lo, world.hi))


class Rings(NamedTuple):
    """The rings of a world: ring k is points[first[k]:first[k + 1]] and bounds solid[k].

    Solid 0 is the outside of ring 0, which is clockwise. The solids come in order; the outline of
    each is counter-clockwise and followed by its rooms, clockwise.
    """

    points: Array
    first: NDArray[np.int64]
    solid: NDArray[np.int64]


@compiled
def world_of_rings(rings: Rings, more: Parts, discs: Array) -> PolygonWorldRecord:
    """The record of a world whose rings are valid, without occupancy cells.

    more : the convex parts of the solids that have rooms.
    discs : (k, 3), rows x, y, radius.
    """
    outline = rings.points[: rings.first[1]][::-1].copy()
    hull = hull_of(outline)
    parts = cut_pockets(outline, hull)
    for k in range(1, len(rings.solid)):
        if is_alone(rings.solid, k):
            ring = rings.points[rings.first[k] : rings.first[k + 1]]
            parts = join_parts(parts, cut_into_convex_parts(ring))
    round_parts = Parts(discs[:, :2].copy(), np.arange(len(discs) + 1), discs[:, 2].copy())
    parts = join_parts(join_parts(parts, more), round_parts)
    lo, hi = box_of(hull)
    cells = index_parts(parts, lo, hi)
    return PolygonWorldRecord(edges_of_rings(rings), hull, parts, cells, no_occupancy(), lo, hi)


@compiled
def is_alone(solid: NDArray[np.int64], k: int) -> bool:
    """Whether ring k is the only one of its solid."""
    after = solid[k + 1] if k + 1 < len(solid) else -1
    return solid[k - 1] != solid[k] and solid[k] != after


@compiled
def edges_of_rings(rings: Rings) -> Array:
    """The edges of all rings as rows of `PolygonWorldRecord.edges`."""
    edges = np.empty((len(rings.points), 5))
    for k in range(len(rings.solid)):
        begin, end = rings.first[k], rings.first[k + 1]
        for i in range(begin, end):
            j = i + 1 if i + 1 < end else begin
            for axis in range(2):
                edges[i, axis], edges[i, 2 + axis] = rings.points[i, axis], rings.points[j, axis]
            edges[i, 4] = rings.solid[k]
    return edges


@compiled
def cut_pockets(outline: Array, hull: Array) -> Parts:
    """The convex parts of the region between a boundary, counter-clockwise, and its convex hull.

    A pocket begins and ends at corners of the boundary that lie on the hull.
    """
    n, parts = len(outline), Parts(np.empty((0, 2)), np.zeros(1, np.int64), np.empty(0))
    corner = begin = leftmost_corner(outline)
    for step in range(1, n + 1):
        end = begin + step
        if is_on_convex(outline[end % n], hull):
            if end > corner + 1:
                pocket = np.empty((end - corner + 1, 2))
                for i in range(len(pocket)):
                    pocket[i] = outline[(end - i) % n]
                parts = join_parts(parts, cut_into_convex_parts(pocket))
            corner = end
    return parts


def world_of_triangles(lo: Array, hi: Array, triangles: Array) -> PolygonWorldRecord:
    """A box with triangular obstacles (k, 3, 2): an unchecked `PolygonWorld`.

    The triangles are counter-clockwise and have a positive area. There are no occupancy cells,
    because it is for a few motions only: occupancy cells would make each query faster, but take
    longer to build.
    """
    box = np.array([(lo[0], lo[1]), (hi[0], lo[1]), (hi[0], hi[1]), (lo[0], hi[1])])
    numbers = np.repeat(np.arange(1.0, len(triangles) + 1.0), 3)
    sides = np.concatenate([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 4)
    edges = np.concatenate([edges_of(box[::-1], 0), np.column_stack([sides, numbers])])
    first, radius = 3 * np.arange(len(triangles) + 1), np.zeros(len(triangles))
    parts = Parts(triangles.reshape(-1, 2), first, radius)
    cells = index_parts(parts, lo, hi)
    return PolygonWorldRecord(edges, box, parts, cells, no_occupancy(), lo, hi)


def edges_of(ring: Array, solid: int) -> Array:
    """The edges of a ring as rows of `PolygonWorldRecord.edges`, shape (n, 5)."""
    return np.hstack([ring, np.roll(ring, -1, axis=0), np.full((len(ring), 1), float(solid))])


def rings_of(world: PolygonWorldRecord) -> list[list[Array]]:
    """The rings of each solid: the boundary; then each obstacle's outline and its rooms."""
    solids: list[list[Array]] = [[] for _ in range(int(world.edges[-1, 4]) + 1)]
    begin = 0
    for end, (x, y, solid) in enumerate(world.edges[:, 2:].tolist(), start=1):
        # the ring ends where it closes, even if the next ring begins at the same point
        if x == world.edges[begin, 0] and y == world.edges[begin, 1]:
            solids[int(solid)].append(world.edges[begin:end, :2])
            begin = end
    return solids


def discs_of(world: PolygonWorldRecord) -> Array:
    """The round obstacles as rows x, y, radius, shape (k, 3)."""
    parts = world.obstacles
    k = int((parts.radius > 0.0).sum())
    return np.hstack(
        [parts.points[len(parts.points) - k :], parts.radius[len(parts.radius) - k :, None]]
    )


def is_pair_with_radius(obstacle: object) -> bool:
    """Whether an obstacle is a pair (centre, radius)."""
    if not isinstance(obstacle, Sequence | np.ndarray) or is_scalar(obstacle):
        return False
    return len(obstacle) == 2 and is_scalar(obstacle[1])


def is_scalar(value: object) -> bool:
    """Whether a value is a number or a text, also as an array of shape ()."""
    return bool(np.isscalar(value)) or (isinstance(value, np.ndarray) and value.ndim == 0)


def as_disc(centre: ArrayLike, radius: float, name: str) -> Array:
    """Check a round obstacle (x, y, radius); raise InvalidWorld otherwise."""
    if is_scalar(centre):
        raise InvalidWorld(
            f"{name} must be a polygon or (centre, radius), got two numbers; put a single polygon "
            "into a list"
        )
    size = as_array(radius, f"{name}: its radius")
    if size <= 0.0:
        raise InvalidWorld(
            f"{name}: a round obstacle's radius must be positive, got {float(size):g}"
        )
    return np.append(as_point(centre, f"{name}: its centre"), size)


def as_polygon_with_rooms(obstacle: Any, name: str) -> tuple[Array, list[Array]]:
    """The outer ring of an obstacle and the rings of its rooms."""
    try:
        polygon, rooms = obstacle
        has_rooms = len(polygon) > 2
    except (TypeError, ValueError):
        has_rooms = False
    if not has_rooms:
        return as_ring(obstacle, name), []
    found = enumerate(as_list(rooms, f"{name}: its rooms"))
    return as_ring(polygon, name), [as_ring(room, f"{name}, room {i}") for i, room in found]
