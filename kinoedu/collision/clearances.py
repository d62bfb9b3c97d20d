"""The distance from a robot to the nearest obstacle."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..compiled import compiled
from ..errors import InvalidPoint
from ..geometry.checks import Array, as_row
from ..geometry.exact import height
from ..geometry.parts import Parts
from ..geometry.separation import pieces_distance
from ..robots.kinds import Robot
from ..robots.moving import place_body
from ..support.text import shortened
from ..worlds.checks import World, check_world
from ..worlds.nearby import obstacles_near, rim
from .interface import coordinates


def clearance_of(robot: Robot, world: World, q: ArrayLike) -> float:
    """The distance from the robot at q to the nearest obstacle or to the world's boundary.

    It is 0 in contact, inside an obstacle and outside the world. The relative error is 1e-12, plus
    the rounding of the position of a body that rotates.

    Returns
    -------
    float

    Raises
    ------
    InvalidPoint
        Where q is not a configuration of this robot.
    InvalidWorld
        Where `world` is not a world.

    Examples
    --------
    >>> from kinoedu import PolygonWorld, RigidPolygon
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [((7, 5), 1)])
    >>> clearance_of(RigidPolygon([(-1, -1), (1, -1), (1, 1), (-1, 1)]), world, (3, 5, 0))
    2.0
    """
    check_world(world)
    at, count = as_row(q, "q"), coordinates(robot)
    if at.shape != (count,):
        raise InvalidPoint(f"q must be {count} numbers for this robot, got {shortened(q)}")
    return float(least_distance(place_body(robot, at), world))


@compiled
def least_distance(body: Parts, world: World) -> float:
    """The least distance of any piece of a body.

    Only obstacles in a box as wide as the least distance so far are examined.
    """
    best = np.inf
    for i in range(len(body.radius)):
        begin, end = body.first[i], body.first[i + 1]
        best = min(best, rim_distance(body.points[begin:end], rim(world)) - body.radius[i])
        if best <= 0.0:
            return 0.0
        reach = best + body.radius[i]
        x, y = body.points[begin:end, 0], body.points[begin:end, 1]
        parts, near = obstacles_near(
            world, x.min() - reach, y.min() - reach, x.max() + reach, y.max() + reach
        )
        for j in near:
            apart = pieces_distance(
                body.points, begin, end, parts.points, parts.first[j], parts.first[j + 1]
            )
            best = min(best, apart - body.radius[i] - parts.radius[j])
    return max(best, 0.0)


@compiled
def rim_distance(points: Array, ring: Array) -> float:
    """The least distance of points inside a convex ring from its edges; negative outside."""
    least = np.inf
    for i in range(len(ring)):
        for x, y in points:
            least = min(least, height(ring[i - 1, 0], ring[i - 1, 1], ring[i, 0], ring[i, 1], x, y))
    return least
