"""What a decomposition is made of: the edges round a world's free space, overlapping obstacles
united where they need be.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ..errors import InvalidWorld
from ..geometry.checks import Array
from ..worlds.polygon_world import PolygonWorldRecord, discs_of, edges_of, rings_of

GRIDS = (None, 2.0**-48, 2.0**-44, 2.0**-40)  # of the size of the coordinates


def edges_to_try(world: Any) -> Iterator[Array]:
    """Edges round the free space, (n, 5) as `PolygonWorldRecord.edges`: as given, then united, then
    united on a grid.

    What is given is exact, but obstacles may overlap. shapely unites them, and rounds the points
    where edges cross; should rounding have pushed an edge over another, a grid far finer than the
    world, but coarser than floats, puts them apart.
    """
    yield as_polygons(world).edges
    for grid in GRIDS:
        polygons, unit = free_polygons(world, grid)
        yield edges_round(polygons) * [unit, unit, unit, unit, 1.0]


def as_polygons(world: Any) -> PolygonWorldRecord:
    """The world itself, refused with InvalidWorld unless it is made of polygons alone."""
    if not isinstance(world, PolygonWorldRecord):
        raise InvalidWorld(
            f"only a PolygonWorld can be cut into cells, got {type(world).__name__}; give its "
            "obstacles as polygons"
        )
    if n := len(discs_of(world)):
        raise InvalidWorld(
            f"{n} of the obstacles are round, and a trapezoid's floor and ceiling are straight; "
            "put a polygon round each instead"
        )
    return world


def free_polygons(world: PolygonWorldRecord, grid: float | None = None) -> tuple[list[Any], float]:
    """The free space as shapely polygons with holes, disjoint but for single points, and the unit
    that they are measured in.

    The unit is a power of two near the largest coordinate, so that shapely's products neither
    overflow nor vanish. With a grid, all corners are whole multiples of it.
    """
    import shapely

    unit = 2.0 ** np.frexp(max(np.abs(world.lo).max(), np.abs(world.hi).max()))[1]
    (outline,), *solids = [[ring / unit for ring in rings] for rings in rings_of(world)]
    obstacles = shapely.union_all(
        [shapely.Polygon(ring, rooms) for ring, *rooms in solids], grid_size=grid
    )
    free = shapely.difference(shapely.Polygon(outline), obstacles, grid_size=grid)
    return [
        part
        for part in shapely.get_parts(free)
        if part.geom_type == "Polygon" and not part.is_empty
    ], float(unit)


def edges_round(polygons: list[Any]) -> Array:
    """The edges of shapely polygons, (n, 5), each with what is solid to its left."""
    import shapely

    turned = shapely.orient_polygons(polygons, exterior_cw=True)
    rings = [
        shapely.get_coordinates(ring)[:-1]
        for polygon in turned
        for ring in (polygon.exterior, *polygon.interiors)
    ]
    return np.concatenate([np.empty((0, 5)), *(edges_of(ring, 0) for ring in rings)])
