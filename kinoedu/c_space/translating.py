"""A polygon that is moved without turning: its obstacles grow, its workspace shrinks, and it
becomes a point.

Bullo & Smith, chapter 4; LaValle, section 4.3.2. The robot's configuration is the position of its
reference point, the origin of the coordinates in which its vertices are given.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidWorld
from ..geometry.checks import Array
from ..geometry.convex import convex_hull, convex_parts
from ..geometry.minkowski import erosion, minkowski_difference
from ..geometry.rings import as_ring
from ..worlds.polygon_world import PolygonWorld, PolygonWorldRecord, discs_of


def translating_obstacles(robot_vertices: ArrayLike, obstacles: Sequence[ArrayLike]) -> list[Array]:
    """Where the reference point may not be: convex polygons that together are the C-obstacle of all
    obstacles.

    Parameters
    ----------
    robot_vertices : (n, 2), a simple polygon, convex or not, its reference point at the origin.
    obstacles : simple polygons (m, 2).

    Each convex part of the robot is subtracted from each convex part of an obstacle
    (`minkowski_difference`): one polygon for each obstacle where both are convex, in the obstacles'
    order. Raises InvalidPolygon, InvalidPoint.

    >>> translating_obstacles([(0, 0), (1, 0), (0, 1)], [[(2, 2), (4, 2), (4, 3), (2, 3)]])
    [array([[1., 2.],
           [2., 1.],
           [4., 1.],
           [4., 3.],
           [1., 3.]])]
    """
    rings = [as_ring(obstacle, f"obstacle {number}") for number, obstacle in enumerate(obstacles)]
    return differences(
        [part for ring in rings for part in convex_parts(ring)],
        convex_parts(as_ring(robot_vertices, "robot")),
    )


def c_space_world(robot_vertices: ArrayLike, world: PolygonWorldRecord) -> PolygonWorldRecord:
    """The free configuration space of a translating polygon as a world in which a point is as free
    as the polygon was in `world`.

    A point at q touches nothing in it exactly when the polygon, moved to q, touches nothing;
    contact stays contact. To one rounding of the coordinates: none where all are whole numbers and
    the boundary's hull is a rectangle.

    Parameters
    ----------
    robot_vertices : (n, 2), a simple polygon, convex or not, its reference point at the origin.
    world : a PolygonWorld without
        round obstacles.

    The boundary is where the robot fits into the convex hull of the old one (`erosion`); what lies
    between hull and boundary grows as obstacles do. The obstacles are convex and overlap. Raises
    InvalidWorld where the world is no PolygonWorld, has round obstacles, or leaves the robot
    nowhere to be; InvalidPolygon, InvalidPoint.

    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(4, 2), (5, 2), (5, 4), (4, 4)]])
    >>> free = c_space_world([(0, 0), (1, 0), (1, 1), (0, 1)], world)
    >>> free.hi, free.obstacles.points
    (array([8., 5.]), array([[3., 1.],
           [5., 1.],
           [5., 4.],
           [3., 4.]]))
    """
    robot = as_ring(robot_vertices, "robot")
    solids = solids_of(world)
    boundary = erosion(world.hull, convex_hull(robot))
    if not len(boundary):
        raise InvalidWorld(
            "the robot fits nowhere into the boundary, not even without obstacles; make it "
            "smaller than the world"
        )
    return PolygonWorld(boundary, differences(solids, convex_parts(robot)))


def turned(vertices: ArrayLike, theta: float) -> Array:
    """A polygon turned about the origin by theta radians, counter-clockwise: a robot's body at the
    configuration (0, 0, theta).

    >>> turned([(2, 0), (0, 1), (0, 0)], np.pi / 2).round(12) + 0.0
    array([[ 0.,  2.],
           [-1.,  0.],
           [ 0.,  0.]])
    """
    return turned_corners(as_ring(vertices), theta)


def turned_corners(ring: Array, theta: float) -> Array:
    """A ring turned about the origin."""
    c, s = np.cos(theta), np.sin(theta)
    return ring @ np.array([[c, s], [-s, c]])


def differences(obstacles: Sequence[Array], robots: Sequence[Array]) -> list[Array]:
    """The C-obstacle of every convex robot and every convex obstacle."""
    return [minkowski_difference(obstacle, robot) for obstacle in obstacles for robot in robots]


def solids_of(world: Any) -> list[Array]:
    """The convex parts of what is solid inside the hull of a world's boundary; InvalidWorld unless
    all are polygons.
    """
    if not isinstance(world, PolygonWorldRecord):
        raise InvalidWorld(
            f"a polygon's free space is found in a PolygonWorld, got {type(world).__name__}; give "
            "polygons"
        )
    if n := len(discs_of(world)):
        raise InvalidWorld(
            f"{n} of the obstacles are round, and what a polygon makes of them is not a polygon; "
            "put one round each"
        )
    parts = world.obstacles
    return [parts.points[a:b] for a, b in zip(parts.first[:-1], parts.first[1:])]
