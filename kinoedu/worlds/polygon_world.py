"""Worlds of polygons, with rooms in their holes, and discs; geometry is exact."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidPolygon, InvalidWorld
from ..geometry.checks import Array, as_array, as_list, as_point
from ..geometry.convex import convex_hull, convex_parts
from ..geometry.parts import Parts, make_parts
from ..geometry.polygons import locate_points
from ..geometry.rings import as_ring
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
        outline = as_ring(boundary, "boundary")
        hull = convex_hull(outline)
        solids, pieces, discs = [[outline[::-1]]], pockets(outline, hull), []
        for number, obstacle in enumerate(as_list(obstacles, "obstacles")):
            name = f"obstacle {number}"
            if is_pair_with_radius(obstacle):
                discs.append(as_disc(obstacle[0], obstacle[1], name))
            else:
                ring, rooms = as_polygon_with_rooms(obstacle, name)
                try:
                    pieces += convex_parts(ring, rooms)
                except InvalidPolygon as error:
                    raise InvalidPolygon(f"{name}: {error}") from error
                solids.append([ring, *(room[::-1] for room in rooms)])
        centres, radii = [disc[None, :2] for disc in discs], [float(disc[2]) for disc in discs]
        edges = np.concatenate(
            [edges_of(ring, solid) for solid, rings in enumerate(solids) for ring in rings]
        )
        parts = make_parts(pieces + centres, [0.0] * len(pieces) + radii)
        lo, hi = hull.min(axis=0), hull.max(axis=0)
        cells = index_parts(parts, lo, hi)
        occupancy = make_occupancy(hull, parts, cells, lo, hi)
        return PolygonWorldRecord(edges, hull, parts, cells, occupancy, lo, hi)


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
    return (
        isinstance(obstacle, Sequence | np.ndarray)
        and len(obstacle) == 2
        and np.isscalar(obstacle[1])
    )


def as_disc(centre: ArrayLike, radius: float, name: str) -> Array:
    """Check a round obstacle (x, y, radius); raise InvalidWorld otherwise."""
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


def pockets(outline: Array, hull: Array) -> list[Array]:
    """The convex parts of the region between a boundary and its convex hull."""
    on_hull = np.flatnonzero(locate_points(outline, hull) == 0)
    parts: list[Array] = []
    for i, j in zip(on_hull, [*on_hull[1:], on_hull[0] + len(outline)], strict=True):
        if j > i + 1:
            parts += convex_parts(as_ring(outline[np.arange(i, j + 1) % len(outline)]))
    return parts
