"""A disk among polygons: its obstacles grow by its radius, its workspace shrinks by it. Bullo &
Smith, chapter 4.

Each convex part of an obstacle grows into a shape whose outline is known exactly (`Rounded`). Where
such shapes overlap, and where the workspace is not convex, the free regions are polygons, to a
tolerance, and on the safe side: never larger than the truth.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter, InvalidRobot, InvalidWorld
from ..geometry.checks import Array, as_array
from ..geometry.convex import convex_hull
from ..geometry.exact import length
from ..geometry.minkowski import leftmost, moved_inward
from ..worlds.polygon_world import PolygonWorld, PolygonWorldRecord
from .rounded import Rounded

FINE = 1e-4  # of the radius: the tolerance where none is given


def grown_obstacles(radius: float, world: PolygonWorldRecord) -> list[Rounded]:
    """Where a disk's centre may not be: every convex part of what is solid in the world, round
    obstacles too, grown by the radius.

    They overlap, and together are the C-obstacle inside the hull of the boundary: with the
    obstacles' parts come those of what lies between the boundary and its convex hull. Each is
    exact. Raises InvalidRobot, InvalidWorld.

    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 2), (5, 2), (5, 4), (3, 4)], ((7, 4), 0.5)])
    >>> [round(shape.area, 3) for shape in grown_obstacles(1.0, world)]
    [15.142, 7.069]
    """
    size, parts = as_radius(radius), as_world(world).obstacles
    pieces = [parts.points[a:b] for a, b in zip(parts.first[:-1], parts.first[1:])]
    return [
        Rounded(convex_hull(piece), size + own) for piece, own in zip(pieces, parts.radius.tolist())
    ]


def shrunk_workspace(
    radius: float, boundary: ArrayLike, *, tolerance: float | None = None
) -> list[Array]:
    """Where a disk's centre may be inside a boundary: polygons (k, 2), one, several or none;
    contact on their outline.

    Edges move inward by the radius; round a vertex that turns inward stands an arc, drawn to the
    tolerance (default: 1e-4 of the radius), the polygon a little smaller than the truth. Where the
    boundary is convex there are no arcs, and the polygon is exact to rounding. Raises InvalidRobot,
    InvalidPolygon, InvalidPoint, InvalidParameter.

    >>> shrunk_workspace(1, [(0, 0), (9, 0), (9, 6), (0, 6)])
    [array([[1., 1.],
           [8., 1.],
           [8., 5.],
           [1., 5.]])]
    """
    return [ring for ring, *_ in free_regions(radius, PolygonWorld(boundary), tolerance=tolerance)]


def free_regions(
    radius: float, world: PolygonWorldRecord, *, tolerance: float | None = None
) -> list[list[Array]]:
    """The free configuration space of a disk: for each connected piece its outline,
    counter-clockwise, and those of its holes.

    Polygons within the tolerance of the truth (default: a ten-thousandth of the radius), and never
    larger: where a point is inside one, the disk is free. Pieces narrower than the tolerance are
    lost. The unions are shapely's. Raises InvalidRobot, InvalidWorld, InvalidParameter.
    """
    import shapely

    size = as_radius(radius)
    fine = as_array(FINE * size if tolerance is None else tolerance, "tolerance")
    if fine.ndim or fine <= 0.0:
        raise InvalidParameter(f"tolerance must be one positive length, got {tolerance!r}")
    solids = [
        shapely.Polygon(shape.polyline(float(fine))) for shape in grown_obstacles(size, world)
    ]
    along = np.roll(world.hull, -1, axis=0) - world.hull
    across = np.column_stack([-along[:, 1], along[:, 0]]) * [
        [size / length(x, y)] for x, y in along
    ]
    inner = moved_inward(world.hull, world.hull, across)
    if not len(inner):
        return []
    free = shapely.orient_polygons(
        shapely.difference(shapely.Polygon(inner), shapely.union_all(solids))
    )
    pieces: list[Any] = [
        part
        for part in shapely.get_parts(free)
        if part.geom_type == "Polygon" and not part.is_empty
    ]
    rings = [
        [shapely.get_coordinates(ring)[:-1] for ring in (part.exterior, *part.interiors)]
        for part in pieces
    ]
    return [[np.roll(ring, -leftmost(ring), axis=0) for ring in piece] for piece in rings]


def as_radius(radius: float) -> float:
    """A radius, or InvalidRobot."""
    size = as_array(radius, "radius")
    if size.ndim or size <= 0.0:
        raise InvalidRobot(f"a disk's radius must be one positive length, got {radius!r}")
    return float(size)


def as_world(world: Any) -> PolygonWorldRecord:
    """A polygonal world, or InvalidWorld."""
    if not isinstance(world, PolygonWorldRecord):
        raise InvalidWorld(
            f"obstacles grow in a PolygonWorld, got {type(world).__name__}; give polygons and discs"
        )
    return world
