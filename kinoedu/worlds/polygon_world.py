"""A world of polygons and discs: exact, with rooms inside holes."""

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidPolygon, InvalidWorld
from ..geometry.checks import Array, as_array, as_point, as_things
from ..geometry.convex import convex_hull, convex_parts
from ..geometry.parts import Parts, make_parts
from ..geometry.polygons import places
from ..geometry.rings import as_ring
from .known_cells import KnownCells, known_cells, nothing_known
from .parts_index import PartsIndex, index_parts


class PolygonWorldRecord(NamedTuple):
    """What `PolygonWorld` makes; planners and figures read it, nothing writes it.

    Row i of `edges` is x, y, next x, next y, solid: an edge with what is solid to its left, ring
    after ring. Solid 0 is the outside: the first ring is the boundary, clockwise. The others are
    the polygonal obstacles in their order, each counter-clockwise, followed by its rooms,
    clockwise.

    For collision the same is held as convex parts: `hull` (k, 2) is the convex hull of the
    boundary, outside of which all is solid; `obstacles` has the convex parts of every obstacle and
    of the pockets between boundary and hull, and last the round obstacles. lo and hi are the
    corners of the bounding box.
    """

    edges: Array
    hull: Array
    obstacles: Parts
    cells: PartsIndex
    known: KnownCells
    lo: Array
    hi: Array


def PolygonWorld(boundary: ArrayLike, obstacles: Iterable[Any] = ()) -> PolygonWorldRecord:
    """A workspace bounded by a simple polygon, with obstacles in it.

    Parameters
    ----------
    boundary : (n, 2), a simple polygon, convex or not. Outside it nothing is free, and it is itself
    a wall.
    obstacles : each a simple polygon (m, 2); or a pair (centre, radius) for a round one; or a pair
    (polygon, rooms), where each
        room is a simple polygon inside, free within: rooms may hold further obstacles. Obstacles
        are closed: touching is contact. They may overlap each other and the boundary.

    Raises InvalidWorld, InvalidPolygon or InvalidPoint; the message names the obstacle by its
    number.

    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(2, 2), (4, 2), (3, 4)], ((7, 7), 1.5)])
    >>> len(world.obstacles.radius)
    2
    """
    outline = as_ring(boundary, "boundary")
    hull = convex_hull(outline)
    solids, pieces, discs = [[outline[::-1]]], pockets(outline, hull), []
    for number, obstacle in enumerate(as_things(obstacles, "obstacles")):
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
    parts, lo, hi = (
        make_parts(pieces + centres, [0.0] * len(pieces) + radii),
        hull.min(axis=0),
        hull.max(axis=0),
    )
    cells = index_parts(parts, lo, hi)
    return PolygonWorldRecord(
        edges, hull, parts, cells, known_cells(hull, parts, cells, lo, hi), lo, hi
    )


def world_of_triangles(lo: Array, hi: Array, triangles: Array) -> PolygonWorldRecord:
    """A box with triangles (k, 3, 2) in it, each counter-clockwise with an area: a `PolygonWorld`,
    unchecked and made at once.

    For a few motions: what would make many questions quick takes longer to prepare than they do.
    """
    box = np.array([(lo[0], lo[1]), (hi[0], lo[1]), (hi[0], hi[1]), (lo[0], hi[1])])
    numbers = np.repeat(np.arange(1.0, len(triangles) + 1.0), 3)
    sides = np.concatenate([triangles, np.roll(triangles, -1, axis=1)], axis=2).reshape(-1, 4)
    edges = np.concatenate([edges_of(box[::-1], 0), np.column_stack([sides, numbers])])
    parts = Parts(
        triangles.reshape(-1, 2), 3 * np.arange(len(triangles) + 1), np.zeros(len(triangles))
    )
    return PolygonWorldRecord(
        edges, box, parts, index_parts(parts, lo, hi), nothing_known(), lo, hi
    )


def edges_of(ring: Array, solid: int) -> Array:
    """A ring's edges as rows of `PolygonWorldRecord.edges`, shape (n, 5)."""
    return np.hstack([ring, np.roll(ring, -1, axis=0), np.full((len(ring), 1), float(solid))])


def rings_of(world: PolygonWorldRecord) -> list[list[Array]]:
    """The rings of each solid: the boundary's first, clockwise; then each polygonal obstacle's own
    and its rooms'.
    """
    solids: list[list[Array]] = [[] for _ in range(int(world.edges[-1, 4]) + 1)]
    begin = 0
    for end, (x, y, solid) in enumerate(world.edges[:, 2:].tolist(), start=1):
        if (
            x == world.edges[begin, 0] and y == world.edges[begin, 1]
        ):  # the ring is closed; the next may begin at the same point
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


def is_pair_with_radius(obstacle: Any) -> bool:
    """Whether an obstacle is written (centre, radius)."""
    return (
        isinstance(obstacle, Sequence | np.ndarray)
        and len(obstacle) == 2
        and np.isscalar(obstacle[1])
    )


def as_disc(centre: ArrayLike, radius: float, name: str) -> Array:
    """A round obstacle as (x, y, radius), or InvalidWorld."""
    size = as_array(radius, f"{name}: its radius")
    if size <= 0.0:
        raise InvalidWorld(
            f"{name}: a round obstacle's radius must be positive, got {float(size):g}"
        )
    return np.append(as_point(centre, f"{name}: its centre"), size)


def as_polygon_with_rooms(obstacle: Any, name: str) -> tuple[Array, list[Array]]:
    """An obstacle's outer ring and the rings of its rooms."""
    try:
        polygon, rooms = obstacle
        has_rooms = len(polygon) > 2
    except (TypeError, ValueError):
        has_rooms = False
    if not has_rooms:
        return as_ring(obstacle, name), []
    found = enumerate(as_things(rooms, f"{name}: its rooms"))
    return as_ring(polygon, name), [as_ring(room, f"{name}, room {i}") for i, room in found]


def pockets(outline: Array, hull: Array) -> list[Array]:
    """Convex parts of what lies between a boundary and its convex hull."""
    on_hull = np.flatnonzero(places(outline, hull) == 0)
    parts: list[Array] = []
    for i, j in zip(on_hull, [*on_hull[1:], on_hull[0] + len(outline)], strict=True):
        if j > i + 1:
            parts += convex_parts(as_ring(outline[np.arange(i, j + 1) % len(outline)]))
    return parts
