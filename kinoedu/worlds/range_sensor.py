"""A range sensor: the distance to the first wall in each direction.

LaValle, section 11.1.1.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..errors import InvalidPoint, InvalidWorld
from ..geometry.checks import Array, as_point, integer, is_real, positive
from ..geometry.exact import length
from ..geometry.polygons import locate_points
from ..geometry.segments import shared_points
from ..support.constructors import with_type_names
from .checks import World
from .polygon_world import PolygonWorldRecord, discs_of, rings_of


@with_type_names
class Scan(NamedTuple):
    """The measurement of a range sensor at `origin`.

    angles : (n,), the directions of the rays.
    distances : (n,), to the first wall; the sensor's reach where no wall is hit.
    hit : (n,), whether the ray hits a wall.
    points : (n, 2), the end points of the rays.
    """

    origin: Array
    angles: Array
    distances: Array
    hit: NDArray[np.bool_]
    points: Array


def scan(world: World, q: ArrayLike, *, rays: int = 180, reach: float = math.inf) -> Scan:
    """Measure the distances to walls from q, along evenly spaced rays; the first along the x-axis.

    Whether a ray hits a wall is decided exactly, for the segment from q to its rounded end point;
    distances are accurate to 1e-12. O(rays * edges).

    Parameters
    ----------
    world : a PolygonWorld.
    q : (x, y), inside the boundary.
    rays : their number, at most 1,000,000.
    reach : the range of the sensor, in the world's unit of length; infinite by default.

    Returns
    -------
    Scan

    Raises
    ------
    InvalidWorld
        Where `world` is not a PolygonWorld.
    InvalidPoint
        Where q is not a point inside the boundary.
    InvalidParameter
        Where `rays` or `reach` is not valid.

    Examples
    --------
    >>> from kinoedu.worlds import PolygonWorld
    >>> world = PolygonWorld([(0, 0), (4, 0), (4, 4), (0, 4)], [((3, 2), 0.5)])
    >>> scan(world, (1, 2), rays=4, reach=1.75).distances
    array([1.5 , 1.75, 1.  , 1.75])
    """
    if not isinstance(world, PolygonWorldRecord):
        raise InvalidWorld(f"the range sensor works in a PolygonWorld, got {type(world).__name__}")
    place, count = as_point(q, "q"), integer(rays, "rays", least=1, most=1_000_000)
    farthest = 2.0 * float(np.sqrt(((world.hi - world.lo) ** 2).sum()))
    is_unlimited = is_real(reach) and reach == math.inf
    most = farthest if is_unlimited else positive(reach, "reach")
    if locate_points(place[None], rings_of(world)[0][0])[0] <= 0:
        raise InvalidPoint(f"q must lie inside the world's boundary, got {tuple(place.tolist())}")
    angles = 2.0 * math.pi * np.arange(count) / count
    distances = cast_rays(world.edges, discs_of(world), place, angles, min(most, farthest))
    hit = distances < np.inf
    distances = np.where(hit, distances, most)
    directions = np.column_stack([np.cos(angles), np.sin(angles)])
    return Scan(place, angles, distances, hit, place + distances[:, None] * directions)


@compiled
def cast_rays(edges: Array, discs: Array, q: Array, angles: Array, reach: float) -> Array:
    """The distance from q to the first wall in each direction, (n,); infinite beyond reach."""
    distances, points = np.empty(len(angles)), np.empty((2, 2))
    for i in range(len(angles)):
        ux, uy = math.cos(angles[i]), math.sin(angles[i])
        end = np.array([q[0] + reach * ux, q[1] + reach * uy])
        nearest = np.inf
        for k in range(len(edges)):
            for j in range(shared_points(q, end, edges[k, 0:2], edges[k, 2:4], points)):
                nearest = min(nearest, length(points[j, 0] - q[0], points[j, 1] - q[1]))
        for k in range(len(discs)):
            nearest = min(
                nearest, distance_to_disc(q[0], q[1], ux, uy, discs[k, 0], discs[k, 1], discs[k, 2])
            )
        distances[i] = nearest if nearest <= reach else np.inf
    return distances


@compiled
def distance_to_disc(
    x: float, y: float, ux: float, uy: float, cx: float, cy: float, radius: float
) -> float:
    """The distance from (x, y) along the unit vector u to a disc's rim; infinite for a miss."""
    along, across = (cx - x) * ux + (cy - y) * uy, (cx - x) * uy - (cy - y) * ux
    if length(cx - x, cy - y) < radius:  # from inside
        return along + math.sqrt(max((radius - across) * (radius + across), 0.0))
    if along < 0.0 or abs(across) > radius:
        return math.inf
    return max(along - math.sqrt((radius - across) * (radius + across)), 0.0)
