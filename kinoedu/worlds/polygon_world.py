"""A world of polygons and discs: exact, with rooms inside holes."""

from collections.abc import Iterable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidWorld
from ..geometry.checks import Array, as_array, as_point
from ..geometry.convex import convex_hull, convex_parts
from ..geometry.parts import Parts, make_parts
from ..geometry.polygons import places
from ..geometry.rings import as_ring
from .parts_index import PartsIndex, index_parts


class PolygonWorldRecord(NamedTuple):
    """What `PolygonWorld` makes; planners and figures read it, nothing writes it.

    Ring i is rings[first[i]:first[i + 1]] and belongs to solid owner[i]; what is solid lies to the left of every edge. Solid 0 is
    the outside: ring 0 is the boundary, clockwise. The others are the polygonal obstacles in their order, each counter-clockwise,
    with its rooms clockwise. `discs` holds the round obstacles as rows x, y, radius.

    For collision the same is held as convex parts: `hull` is the convex hull of the boundary, outside of which all is solid;
    `obstacles` has the convex parts of every obstacle and of the pockets between boundary and hull.
    """

    boundary: Array
    rings: Array
    first: NDArray[np.int64]
    owner: NDArray[np.int64]
    discs: Array
    hull: Array
    obstacles: Parts
    index: PartsIndex
    lo: Array
    hi: Array


def PolygonWorld(boundary: ArrayLike, obstacles: Iterable[Any] = ()) -> PolygonWorldRecord:
    """A workspace bounded by a simple polygon, with obstacles in it.

    Parameters
    ----------
    boundary : (n, 2), a simple polygon, convex or not. Outside it nothing is free, and it is itself a wall.
    obstacles : each a simple polygon (m, 2); or a pair (centre, radius) for a round one; or a pair (polygon, rooms), where each
        room is a simple polygon inside, free within: rooms may hold further obstacles. Obstacles are closed: touching is contact.
        They may overlap each other and the boundary.

    Raises InvalidWorld, InvalidPolygon or InvalidPoint; the message names the obstacle by its number.

    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(2, 2), (4, 2), (3, 4)], ((7, 7), 1.5)])
    >>> len(world.obstacles.radius)
    2
    """
    outline = as_ring(boundary, "boundary")
    hull = convex_hull(outline)
    rings, owner, pieces = [outline[::-1]], [0], pockets(outline, hull)
    discs: list[Array] = []
    for number, obstacle in enumerate(obstacles):
        name = f"obstacle {number}"
        if is_pair_with_radius(obstacle):
            discs.append(as_disc(*obstacle, name))
            continue
        ring, rooms = as_polygon_with_rooms(obstacle, name)
        pieces += convex_parts(ring, rooms)
        owner += [max(owner) + 1] * (1 + len(rooms))
        rings += [ring, *(room[::-1] for room in rooms)]
    centres = [disc[None, :2] for disc in discs]
    parts = make_parts(pieces + centres, [0.0] * len(pieces) + [float(disc[2]) for disc in discs])
    lo, hi = outline.min(axis=0), outline.max(axis=0)
    return PolygonWorldRecord(
        outline,
        np.concatenate(rings),
        np.cumsum([0, *map(len, rings)], dtype=np.int64),
        np.array(owner, np.int64),
        np.array(discs).reshape(-1, 3),
        hull,
        parts,
        index_parts(parts, lo, hi),
        lo,
        hi,
    )


def is_pair_with_radius(obstacle: Any) -> bool:
    """Whether an obstacle is written (centre, radius)."""
    return isinstance(obstacle, Sequence | np.ndarray) and len(obstacle) == 2 and np.ndim(obstacle[1]) == 0


def as_disc(centre: ArrayLike, radius: float, name: str) -> Array:
    """A round obstacle as (x, y, radius), or InvalidWorld."""
    size = as_array(radius, f"{name}: its radius")
    if size <= 0.0:
        raise InvalidWorld(f"{name}: a round obstacle's radius must be positive, got {float(size):g}")
    return np.append(as_point(centre, f"{name}: its centre"), size)


def as_polygon_with_rooms(obstacle: Any, name: str) -> tuple[Array, list[Array]]:
    """An obstacle's outer ring and the rings of its rooms."""
    try:
        polygon, rooms = obstacle
        has_rooms = len(polygon) > 2 and len(rooms[0]) > 2
    except (TypeError, ValueError, IndexError, KeyError):
        has_rooms = False
    if not has_rooms:
        return as_ring(obstacle, name), []
    return as_ring(polygon, name), [as_ring(room, f"{name}, room {i}") for i, room in enumerate(rooms)]


def pockets(outline: Array, hull: Array) -> list[Array]:
    """Convex parts of what lies between a boundary and its convex hull."""
    on_hull = np.flatnonzero(places(outline, hull) == 0)
    parts: list[Array] = []
    for i, j in zip(on_hull, [*on_hull[1:], on_hull[0] + len(outline)], strict=True):
        if j > i + 1:
            parts += convex_parts(as_ring(outline[np.arange(i, j + 1) % len(outline)]))
    return parts
