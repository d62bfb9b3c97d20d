"""The configuration space of a polygon that translates: obstacles grow, the robot becomes a point.

Bullo & Smith, chapter 4; LaValle, section 4.3.2. The configuration of the robot is the position of
its reference point, the origin of the coordinates of its vertices.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidWorld
from ..geometry.checks import Array, as_list, as_number
from ..geometry.convex import convex_hull, convex_parts
from ..geometry.minkowski import erosion, minkowski_difference
from ..geometry.rings import as_ring
from ..worlds.checks import World
from ..worlds.polygon_world import PolygonWorld, PolygonWorldRecord, discs_of


def translating_obstacles(robot_vertices: ArrayLike, obstacles: Sequence[ArrayLike]) -> list[Array]:
    """The C-obstacles of a translating polygon: convex polygons whose union is the C-obstacle.

    Each is the `minkowski_difference` of a convex part of an obstacle and a convex part of the
    robot. Where all polygons are convex there is one for each obstacle, in their order.

    Parameters
    ----------
    robot_vertices : (n, 2), a simple polygon, convex or not, its reference point at the origin.
    obstacles : simple polygons (m, 2).

    Returns
    -------
    list of convex polygons (k, 2), counter-clockwise.

    Raises
    ------
    InvalidPolygon, InvalidPoint
        Where a polygon is not valid.
    InvalidWorld
        Where the obstacles are no list.

    Examples
    --------
    >>> translating_obstacles([(0, 0), (1, 0), (0, 1)], [[(2, 2), (4, 2), (4, 3), (2, 3)]])
    [array([[1., 2.],
           [2., 1.],
           [4., 1.],
           [4., 3.],
           [1., 3.]])]
    """
    rings = [
        as_ring(obstacle, f"obstacle {number}")
        for number, obstacle in enumerate(as_list(obstacles, "obstacles"))
    ]
    return pairwise_differences(
        [part for ring in rings for part in convex_parts(ring)],
        convex_parts(as_ring(robot_vertices, "robot")),
    )


def c_space_world(robot_vertices: ArrayLike, world: PolygonWorldRecord) -> PolygonWorldRecord:
    """The free configuration space of a translating polygon, as a world for a point robot.

    A point at q touches nothing in it exactly when the polygon, moved to q, touches nothing in
    `world`. Coordinates are rounded once; there is no rounding where all are integers and the hull
    of the boundary is a rectangle. The boundary is the `erosion` of the convex hull of the old
    boundary; the parts between the hull and the boundary grow as obstacles do. The obstacles are
    convex and may overlap.

    Parameters
    ----------
    robot_vertices : (n, 2), a simple polygon, convex or not, its reference point at the origin.
    world : a PolygonWorld without round obstacles.

    Returns
    -------
    PolygonWorldRecord

    Raises
    ------
    InvalidWorld
        Where `world` is not a PolygonWorld, has round obstacles, or has no room for the robot.
    InvalidPolygon, InvalidPoint
        Where the robot is not a simple polygon.

    Examples
    --------
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(4, 2), (5, 2), (5, 4), (4, 4)]])
    >>> free = c_space_world([(0, 0), (1, 0), (1, 1), (0, 1)], world)
    >>> free.hi, free.obstacles.points
    (array([8., 5.]), array([[3., 1.],
           [5., 1.],
           [5., 4.],
           [3., 4.]]))
    """
    robot = as_ring(robot_vertices, "robot")
    solids = convex_solids(world)
    boundary = erosion(world.hull, convex_hull(robot))
    if not len(boundary):
        raise InvalidWorld(
            "the robot fits nowhere into the boundary, not even without obstacles; make it "
            "smaller than the world"
        )
    return PolygonWorld(boundary, pairwise_differences(solids, convex_parts(robot)))


def turned(vertices: ArrayLike, theta: float) -> Array:
    """A polygon rotated about the origin by theta radians, counter-clockwise.

    It is the body of a robot at the configuration (0, 0, theta).

    Returns
    -------
    (n, 2) array

    Raises
    ------
    InvalidPolygon, InvalidPoint
        Where the polygon is not valid, or theta is not one finite number.

    Examples
    --------
    >>> turned([(2, 0), (0, 1), (0, 0)], np.pi / 2).round(12) + 0.0
    array([[ 0.,  2.],
           [-1.,  0.],
           [ 0.,  0.]])
    """
    return rotate_corners(as_ring(vertices), as_number(theta, "theta"))


def rotate_corners(ring: Array, theta: float) -> Array:
    """A ring rotated about the origin by theta radians."""
    c, s = np.cos(theta), np.sin(theta)
    return ring @ np.array([[c, s], [-s, c]])


def pairwise_differences(obstacles: Sequence[Array], robots: Sequence[Array]) -> list[Array]:
    """The C-obstacle of every pair of a convex obstacle and a convex robot."""
    return [minkowski_difference(obstacle, robot) for obstacle in obstacles for robot in robots]


def convex_solids(world: World) -> list[Array]:
    """The convex parts of all obstacles inside the boundary's hull; InvalidWorld for round ones."""
    if not isinstance(world, PolygonWorldRecord):
        raise InvalidWorld(
            f"expected a PolygonWorld, got {type(world).__name__}; the free space of a polygon is "
            "computed among polygons"
        )
    if n := len(discs_of(world)):
        raise InvalidWorld(
            f"the world has round obstacles, {n}, and the C-obstacle of a round obstacle is not a "
            "polygon; replace each by a polygon around it"
        )
    parts = world.obstacles
    return [parts.points[a:b] for a, b in zip(parts.first[:-1], parts.first[1:])]
