"""The edges of a polygonal world's free space; overlapping obstacles are united if needed."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..errors import InvalidWorld
from ..geometry.checks import Array
from ..worlds.polygon_world import PolygonWorldRecord, discs_of, edges_of, rings_of

GRIDS = (None, 2.0**-48, 2.0**-44, 2.0**-40)  # as fractions of the size of the coordinates


def candidate_edges(world: PolygonWorldRecord) -> Iterator[Array]:
    """The edges of the free space, (n, 5) as `PolygonWorldRecord.edges`: as given, then united.

    The given edges are exact, but obstacles may overlap. shapely unites them and rounds the points
    where edges cross. If rounding pushes an edge across another one, the union is repeated on grids
    that are far finer than the world but coarser than floats.
    """
    yield as_polygons(world).edges
    for grid in GRIDS:
        polygons, unit = free_polygons(world, grid)
        yield edges_around(polygons) * [unit, unit, unit, unit, 1.0]


def as_polygons(world: object) -> PolygonWorldRecord:
    """Check that a world is a PolygonWorld without round obstacles.

    Returns
    -------
    PolygonWorldRecord, the world itself.

    Raises
    ------
    InvalidWorld
        Otherwise.
    """
    if not isinstance(world, PolygonWorldRecord):
        raise InvalidWorld(
            f"only a PolygonWorld can be decomposed into cells, got {type(world).__name__}; give "
            "its obstacles as polygons"
        )
    if n := len(discs_of(world)):
        raise InvalidWorld(
            f"the world has round obstacles, {n}, but the edges of cells are straight; replace "
            "each by a polygon around it"
        )
    return world


def free_polygons(world: PolygonWorldRecord, grid: float | None = None) -> tuple[list[Any], float]:
    """The free space as shapely polygons with holes, and the unit in which they are measured.

    The polygons are disjoint except for single points. The unit is a power of two near the largest
    coordinate, so that shapely's products neither overflow nor vanish. With a grid, all corners are
    integer multiples of it.
    """
    import shapely

    unit = 2.0 ** np.frexp(max(np.abs(world.lo).max(), np.abs(world.hi).max()))[1]
    (outline,), *solids = [[ring / unit for ring in rings] for rings in rings_of(world)]
    obstacles = shapely.union_all(
        [shapely.Polygon(ring, rooms) for ring, *rooms in solids], grid_size=grid
    )
    free = shapely.difference(shapely.Polygon(outline), obstacles, grid_size=grid)
    parts = shapely.get_parts(free)
    polygons = [part for part in parts if part.geom_type == "Polygon" and not part.is_empty]
    return polygons, float(unit)


def edges_around(polygons: list[Any]) -> Array:
    """The edges of shapely polygons, (n, 5), each with the solid side to its left."""
    import shapely

    turned = shapely.orient_polygons(polygons, exterior_cw=True)
    rings = [
        shapely.get_coordinates(ring)[:-1]
        for polygon in turned
        for ring in (polygon.exterior, *polygon.interiors)
    ]
    return np.concatenate([np.empty((0, 5)), *(edges_of(ring, 0) for ring in rings)])
