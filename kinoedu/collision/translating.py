"""Exact collision detection for translating polygons, by the convex hull that each piece sweeps."""

import numpy as np

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..geometry.convex import half_hull
from ..geometry.exact import height, orientation_sign
from ..geometry.parts import TOUCHING, Parts
from ..geometry.separation import insides_meet, pieces_distance, pieces_meet
from ..robots.polygon import TranslatingPolygonRobot
from ..worlds.checks import World
from ..worlds.nearby import obstacles_near, rim
from ..worlds.polygon_world import PolygonWorldRecord
from ..worlds.terrain import TerrainRecord
from .interface import is_free_path, is_semi_free_path

ROUND = 1e-12  # of a distance: a robot that slides may be nearer by this fraction


@is_free_path.register(TranslatingPolygonRobot, PolygonWorldRecord)
@is_free_path.register(TranslatingPolygonRobot, TerrainRecord)
def is_free_translation(
    robot: TranslatingPolygonRobot, world: World, a: Array, b: Array, clearance: float
) -> bool:
    """The hull of each piece at both ends lies inside the boundary's hull and touches nothing."""
    ring = rim(world)
    for i in range(len(robot.shape.radius)):
        hull = swept_hull(robot.shape, i, a, b)
        if not hull_within(hull, clearance, ring):
            return False
        parts, near = obstacles_near(world, *bounding_box(hull, clearance))
        for j in near:
            if hull_touches(hull, parts, j, clearance):
                return False
    return True


@is_semi_free_path.register(TranslatingPolygonRobot, PolygonWorldRecord)
@is_semi_free_path.register(TranslatingPolygonRobot, TerrainRecord)
def is_semi_free_translation(
    robot: TranslatingPolygonRobot, world: World, a: Array, b: Array, clearance: float
) -> bool:
    """The interior of the hull of each piece does not meet the interior of an obstacle."""
    ring = rim(world)
    for i in range(len(robot.shape.radius)):
        hull = swept_hull(robot.shape, i, a, b)
        if not hull_slides_within(hull, clearance, ring):
            return False
        parts, near = obstacles_near(world, *bounding_box(hull, clearance))
        for j in near:
            if hull_enters(hull, parts, j, clearance):
                return False
    return True


@inlined
def swept_hull(shape: Parts, i: int, a: Array, b: Array) -> Array:
    """The corners of the hull of a convex piece at a and at b, counter-clockwise."""
    begin, n = shape.first[i], shape.first[i + 1] - shape.first[i]
    points = np.empty((2 * n, 2))
    for k in range(n):
        for axis in range(2):
            points[k, axis] = shape.points[begin + k, axis] + a[axis]
            points[n + k, axis] = shape.points[begin + k, axis] + b[axis]
    return hull_of_few(points)


@compiled
def hull_of_few(points: Array) -> Array:
    """The convex hull of a few points, which are sorted in place; at least two rows."""
    for i in range(1, len(points)):
        x, y, k = points[i, 0], points[i, 1], i
        while k > 0 and (points[k - 1, 0] > x or (points[k - 1, 0] == x and points[k - 1, 1] > y)):
            points[k, 0], points[k, 1] = points[k - 1, 0], points[k - 1, 1]
            k -= 1
        points[k, 0], points[k, 1] = x, y
    lower, upper = half_hull(points), half_hull(points[::-1].copy())
    return np.concatenate((lower[:-1], upper[:-1]))


@compiled
def bounding_box(hull: Array, margin: float) -> tuple[float, float, float, float]:
    """The bounding box of points, grown by a margin."""
    return (
        hull[:, 0].min() - margin,
        hull[:, 1].min() - margin,
        hull[:, 0].max() + margin,
        hull[:, 1].max() + margin,
    )


@compiled
def hull_within(hull: Array, margin: float, ring: Array) -> bool:
    """Whether corners lie inside a convex ring and more than a margin away from its edges."""
    for i in range(len(ring)):
        px, py, qx, qy = ring[i - 1, 0], ring[i - 1, 1], ring[i, 0], ring[i, 1]
        for x, y in hull:
            if orientation_sign(px, py, qx, qy, x, y) <= 0 or (
                margin > 0.0 and height(px, py, qx, qy, x, y) <= margin
            ):
                return False
    return True


@compiled
def hull_slides_within(hull: Array, margin: float, ring: Array) -> bool:
    """Whether corners lie in or on a convex ring and at least a margin away from its edges."""
    for i in range(len(ring)):
        px, py, qx, qy = ring[i - 1, 0], ring[i - 1, 1], ring[i, 0], ring[i, 1]
        for x, y in hull:
            if orientation_sign(px, py, qx, qy, x, y) < 0 or (
                margin > 0.0 and height(px, py, qx, qy, x, y) < margin * (1.0 - ROUND)
            ):
                return False
    return True


@inlined
def hull_touches(hull: Array, parts: Parts, j: int, margin: float) -> bool:
    """Whether a hull comes within `margin` of part j.

    Exact for polygons without a margin, to 1e-12 where something is round.
    """
    begin, end, reach = parts.first[j], parts.first[j + 1], margin + parts.radius[j]
    if reach == 0.0:
        return pieces_meet(hull, 0, len(hull), parts.points, begin, end)
    return pieces_distance(hull, 0, len(hull), parts.points, begin, end) <= reach * TOUCHING


@inlined
def hull_enters(hull: Array, parts: Parts, j: int, margin: float) -> bool:
    """Whether a hull comes nearer to part j than a margin, or enters its interior."""
    begin, end, reach = parts.first[j], parts.first[j + 1], margin + parts.radius[j]
    if reach == 0.0:
        return insides_meet(hull, 0, len(hull), parts.points, begin, end)
    return pieces_distance(hull, 0, len(hull), parts.points, begin, end) < reach * (1.0 - ROUND)
