"""Whether a path is free, judged anew: bodies placed by numpy, distances by shapely, nothing of kinoedu's own tests.

A stretch of a motion is certified where the gap at its middle is more than any point of the body can move in half of it; what is
not is halved. A stretch still uncertain after `HALVINGS` is taken to be free: its ends and its middle are.
"""

from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely

from kinoedu import Plan
from kinoedu.problems import ProblemRecord
from kinoedu.robots.arm import ArmRobot
from kinoedu.robots.polygon import RigidPolygonRobot
from kinoedu.robots.round import RoundRobot
from kinoedu.worlds.polygon_world import discs_of, rings_of
from kinoedu.worlds.terrain import TerrainRecord

HALVINGS = 24
CONTACT = 1e-9  # how far into each other round shapes may seem to be, by rounding


class Scenery(NamedTuple):
    """What is solid but for the discs, piece by piece; the discs as rows x, y, radius; and the room within the walls."""

    pieces: list[shapely.Geometry]
    discs: np.ndarray
    room: shapely.Geometry


def scenery_of(world: object) -> Scenery:
    """A world as shapely sees it."""
    if isinstance(world, TerrainRecord):
        low = world.lo + world.resolution * np.argwhere(~world.free)[:, ::-1]
        pieces = shapely.box(*low.T, *(low + world.resolution).T)
        solid = shapely.get_parts(shapely.union_all(pieces))
        return Scenery(list(solid), np.empty((0, 3)), shapely.box(*world.lo, *world.hi))
    (outline,), *solids = rings_of(world)
    pieces = [shapely.Polygon(ring, rooms) for ring, *rooms in solids]
    return Scenery(pieces, discs_of(world), shapely.Polygon(outline))


def bodies(robot: object, qs: np.ndarray) -> tuple[np.ndarray, float]:
    """The robot at each configuration (n, d) as a shapely geometry, and the radius that widens it."""
    if isinstance(robot, RoundRobot):
        return shapely.points(qs), robot.radius
    if isinstance(robot, ArmRobot):
        angles = np.cumsum(qs, axis=1)
        links = robot.lengths[:, None] * np.stack([np.cos(angles), np.sin(angles)], -1)
        joints = robot.base + np.concatenate([np.zeros((len(qs), 1, 2)), np.cumsum(links, axis=1)], axis=1)
        return shapely.linestrings(joints), float(robot.shape.radius[0])
    theta = qs[:, 2:3] if isinstance(robot, RigidPolygonRobot) else np.zeros((len(qs), 1))
    (x, y), cos, sin = robot.outline.T, np.cos(theta), np.sin(theta)
    return shapely.polygons(np.stack([cos * x - sin * y + qs[:, :1], sin * x + cos * y + qs[:, 1:2]], -1)), 0.0


def gaps(robot: object, scenery: Scenery, qs: np.ndarray) -> np.ndarray:
    """How far the robot is from what is solid, (n,): zero or less in contact, -1 for one that reaches out of the room."""
    shapes, radius = bodies(robot, qs)
    apart = shapely.distance(shapes, scenery.room.exterior)
    apart[~shapely.contains_properly(scenery.room, shapes)] = -1.0
    for piece in scenery.pieces:
        apart = np.minimum(apart, shapely.distance(shapes, piece))
    apart[apart == 0.0] = -1.0  # where bodies lie over each other shapely's distance is zero, however deep
    for x, y, r in scenery.discs:
        apart = np.minimum(apart, shapely.distance(shapes, shapely.Point(x, y)) - r)
    return apart - radius + (CONTACT if radius > 0.0 or len(scenery.discs) else 0.0)


def change(robot: object, a: np.ndarray, b: np.ndarray) -> tuple[np.ndarray, float]:
    """What a motion adds to a, angles the short way round, and how far any point of the body moves at most."""
    way = b - a
    if isinstance(robot, ArmRobot):
        way = (way + np.pi) % (2 * np.pi) - np.pi
        return way, float(np.abs(np.cumsum(way)) @ robot.lengths)
    if isinstance(robot, RigidPolygonRobot):
        way[2] = (way[2] + np.pi) % (2 * np.pi) - np.pi
        return way, float(np.hypot(way[0], way[1]) + abs(way[2]) * np.hypot(*robot.outline.T).max())
    return way, float(np.hypot(way[0], way[1]))


def is_free_motion(robot: object, scenery: Scenery, a: np.ndarray, b: np.ndarray) -> bool:
    """Whether the whole motion from a to b is free."""
    way, farthest = change(robot, a, b)
    if (gaps(robot, scenery, a + np.outer([0.0, 0.5, 1.0], way)) <= 0.0).any():
        return False
    middles, half = np.array([0.5]), 0.5
    for _ in range(HALVINGS):
        apart = gaps(robot, scenery, a + np.outer(middles, way))
        if (apart <= 0.0).any():
            return False
        uncertain = middles[apart <= half * farthest]
        if len(uncertain) == 0:
            return True
        half /= 2.0
        middles = np.concatenate([uncertain - half, uncertain + half])
    return True


def is_semi_free_motion(scenery: Scenery, a: np.ndarray, b: np.ndarray) -> bool:
    """Whether a point's straight motion enters nothing; contact is allowed. By shapely's exact predicates, piece by piece."""
    line = shapely.LineString([a, b]) if (a != b).any() else shapely.Point(a)
    inside = [shapely.relate_pattern(line, piece, "T********") for piece in scenery.pieces]
    return not any(inside) and bool(shapely.covers(scenery.room, line))


def is_valid(plan: Plan, *, semi_free: bool = False) -> bool:
    """Whether a plan's path goes from the start to the goal, is as long as it says, and free (semi-free) all the way."""
    problem, path = plan.problem, plan.path
    assert isinstance(problem, ProblemRecord) and path is not None
    if not (np.array_equal(path[0], problem.start) and np.array_equal(path[-1], problem.goal)):
        return False
    length = sum(problem.distance(a, b) for a, b in pairwise(path))
    scenery = scenery_of(problem.world)
    if semi_free:
        free = all(is_semi_free_motion(scenery, a, b) for a, b in pairwise(path))
    else:
        free = all(is_free_motion(problem.robot, scenery, a, b) for a, b in pairwise(path))
    return free and bool(np.isclose(length, plan.cost, rtol=1e-9))
