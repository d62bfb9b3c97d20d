"""The configuration space of a disk among polygons: obstacles grow, the workspace shrinks.

Bullo & Smith, chapter 4. Each convex part of an obstacle grows by the disk's radius into a shape
with an exact outline (`Rounded`). Where these shapes overlap, and where the workspace is not
convex, the free regions are polygons to within a tolerance. They are conservative: never larger
than the exact free space.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter, InvalidRobot, InvalidWorld
from ..geometry.checks import Array, as_array
from ..geometry.convex import convex_hull
from ..geometry.exact import length
from ..geometry.minkowski import clip_to_shifted_edges
from ..geometry.rings import leftmost_corner
from ..support.text import shortened
from ..worlds.checks import World
from ..worlds.polygon_world import PolygonWorld, PolygonWorldRecord
from .rounded import Rounded

# of the radius: the default tolerance, and the least; an arc has about 1 / sqrt(tolerance) tangents
FINE, FINEST = 1e-4, 1e-9


def grown_obstacles(radius: float, world: PolygonWorldRecord) -> list[Rounded]:
    """The C-obstacles of a disk: every convex part of an obstacle, grown by the disk's radius.

    Round obstacles are included, and so are the parts between the boundary and its convex hull. The
    shapes may overlap; their union is the C-obstacle inside the hull of the boundary. Each of them
    is exact.

    Returns
    -------
    list of Rounded

    Raises
    ------
    InvalidRobot
        Where the radius is not positive.
    InvalidWorld
        Where the world is not a PolygonWorld.

    Examples
    --------
    >>> square, disc = [(3, 2), (5, 2), (5, 4), (3, 4)], ((7, 4), 0.5)
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [square, disc])
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
    """The positions of a disk's centre inside a boundary.

    Edges move inward by the radius. A vertex with an interior angle above pi becomes an arc, which
    is replaced by a polyline within the tolerance, so that the polygon is a little smaller than the
    exact region. Where the boundary is convex there are no arcs, and the polygon is exact to
    rounding.

    Parameters
    ----------
    tolerance : the largest distance of a polyline from its arc; by default 1e-4 of the radius.

    Returns
    -------
    list of polygons (k, 2): none, one or several. On their outlines the disk is in contact.

    Raises
    ------
    InvalidRobot, InvalidPolygon, InvalidPoint, InvalidParameter
        Where an argument is not valid.

    Examples
    --------
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
    """The free configuration space of a disk, as polygons with holes.

    A polygon lies within the tolerance of the exact region and is never larger: the disk is free at
    every point inside it. Regions narrower than the tolerance are lost. The unions are shapely's.

    Parameters
    ----------
    tolerance : a length, at least 1e-9 of the radius; by default 1e-4 of it.

    Returns
    -------
    list with one entry for each connected region: its outline, counter-clockwise, and then its
    holes.

    Raises
    ------
    InvalidRobot, InvalidWorld, InvalidParameter
        Where an argument is not valid.
    """
    import shapely

    size = as_radius(radius)
    fine = as_array(FINE * size if tolerance is None else tolerance, "tolerance")
    if fine.ndim or fine < FINEST * size or fine <= 0.0:
        raise InvalidParameter(
            f"tolerance must be one length of at least {FINEST:g} of the radius, got "
            f"{shortened(tolerance)}"
        )
    solids = [
        shapely.Polygon(shape.polyline(float(fine))) for shape in grown_obstacles(size, world)
    ]
    along = np.roll(world.hull, -1, axis=0) - world.hull
    across = np.column_stack([-along[:, 1], along[:, 0]]) * [
        [size / length(x, y)] for x, y in along
    ]
    inner = clip_to_shifted_edges(world.hull, world.hull, across)
    if not len(inner):
        return []
    free = shapely.orient_polygons(
        shapely.difference(shapely.Polygon(inner), shapely.union_all(solids))
    )
    regions: list[Any] = [
        part
        for part in shapely.get_parts(free)
        if part.geom_type == "Polygon" and not part.is_empty
    ]
    rings = [
        [shapely.get_coordinates(ring)[:-1] for ring in (part.exterior, *part.interiors)]
        for part in regions
    ]
    return [[np.roll(ring, -leftmost_corner(ring), axis=0) for ring in region] for region in rings]


def as_radius(radius: float) -> float:
    """Check a radius; raise InvalidRobot otherwise."""
    size = as_array(radius, "radius")
    if size.ndim or size <= 0.0:
        raise InvalidRobot(f"a disk's radius must be one positive length, got {shortened(radius)}")
    return float(size)


def as_world(world: World) -> PolygonWorldRecord:
    """Check that a world is a PolygonWorld; raise InvalidWorld otherwise."""
    if not isinstance(world, PolygonWorldRecord):
        raise InvalidWorld(
            f"expected a PolygonWorld, got {type(world).__name__}; give polygons and discs"
        )
    return world
