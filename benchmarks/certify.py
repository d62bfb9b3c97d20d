"""Whether a path is free, judged anew: bodies placed by numpy, distances by shapely, nothing of
kinoedu's own tests.

A stretch of a motion is certified where the gap at its middle is more than any point of the body
can move in half of it; what is not is halved. A stretch still uncertain after `HALVINGS` is taken
to be free: its ends and its middle are.
"""

from collections.abc import Callable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely

from kinoedu import Plan, trajectory_along
from kinoedu.problems import ProblemRecord
from kinoedu.robots.arm import ArmRobot
from kinoedu.robots.car import CarRobot
from kinoedu.robots.polygon import RigidPolygonRobot
from kinoedu.robots.round import RoundRobot
from kinoedu.worlds.polygon_world import discs_of, rings_of
from kinoedu.worlds.terrain import TerrainRecord

HALVINGS = 24
CONTACT = 1e-9  # how far into each other round shapes may seem to be, by rounding


class Scenery(NamedTuple):
    """What is solid but for the discs, piece by piece; the discs as rows x, y, radius; and the room
    within the walls.
    """

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
    """The robot at each configuration (n, d) as a shapely geometry, and the radius that widens
    it.
    """
    if isinstance(robot, RoundRobot):
        return shapely.points(qs), robot.radius
    if isinstance(robot, ArmRobot):
        angles = np.cumsum(qs, axis=1)
        links = robot.lengths[:, None] * np.stack([np.cos(angles), np.sin(angles)], -1)
        joints = robot.base + np.concatenate(
            [np.zeros((len(qs), 1, 2)), np.cumsum(links, axis=1)], axis=1
        )
        return shapely.linestrings(joints), float(robot.shape.radius[0])
    theta = (
        qs[:, 2:3] if isinstance(robot, RigidPolygonRobot | CarRobot) else np.zeros((len(qs), 1))
    )
    (x, y), cos, sin = robot.outline.T, np.cos(theta), np.sin(theta)
    return shapely.polygons(
        np.stack([cos * x - sin * y + qs[:, :1], sin * x + cos * y + qs[:, 1:2]], -1)
    ), 0.0


def gaps(robot: object, scenery: Scenery, qs: np.ndarray) -> np.ndarray:
    """How far the robot is from what is solid, (n,): zero or less in contact, -1 for one that
    reaches out of the room.
    """
    shapes, radius = bodies(robot, qs)
    apart = shapely.distance(shapes, scenery.room.exterior)
    apart[~shapely.contains_properly(scenery.room, shapes)] = -1.0
    for piece in scenery.pieces:
        apart = np.minimum(apart, shapely.distance(shapes, piece))
    apart[
        apart == 0.0
    ] = -1.0  # where bodies lie over each other shapely's distance is zero, however deep
    for x, y, r in scenery.discs:
        apart = np.minimum(apart, shapely.distance(shapes, shapely.Point(x, y)) - r)
    return apart - radius + (CONTACT if radius > 0.0 or len(scenery.discs) else 0.0)


class Motion(NamedTuple):
    """Where the robot is after any shares (m,) of a motion, (m, d), and how far any point of its
    body moves at most.
    """

    at: Callable[[np.ndarray], np.ndarray]
    farthest: float


def straight(robot: object, a: np.ndarray, b: np.ndarray) -> Motion:
    """The motion from a to b, angles the short way round."""
    way = b - a
    if isinstance(robot, ArmRobot):
        way = (way + np.pi) % (2 * np.pi) - np.pi
        farthest = float(np.abs(np.cumsum(way)) @ robot.lengths)
    elif isinstance(robot, RigidPolygonRobot):
        way[2] = (way[2] + np.pi) % (2 * np.pi) - np.pi
        farthest = float(np.hypot(way[0], way[1]) + abs(way[2]) * np.hypot(*robot.outline.T).max())
    else:
        farthest = float(np.hypot(way[0], way[1]))
    return Motion(lambda shares: a + np.outer(shares, way), farthest)


def arc(car: CarRobot, pose: np.ndarray, length: float, steering: float) -> Motion:
    """The drive from a pose for a signed length, the steering held: the chord's heading is the mean
    of the two headings.
    """
    turned = length * np.tan(steering) / car.wheelbase

    def at(shares: np.ndarray) -> np.ndarray:
        half = 0.5 * turned * shares
        chord, heading = length * shares * np.sinc(half / np.pi), pose[2] + half
        return np.column_stack(
            [
                pose[0] + chord * np.cos(heading),
                pose[1] + chord * np.sin(heading),
                pose[2] + 2.0 * half,
            ]
        )

    return Motion(at, float(abs(length) + abs(turned) * np.hypot(*car.outline.T).max()))


def is_free_motion(robot: object, scenery: Scenery, motion: Motion) -> bool:
    """Whether the whole motion is free."""
    if (gaps(robot, scenery, motion.at(np.array([0.0, 0.5, 1.0]))) <= 0.0).any():
        return False
    middles, half = np.array([0.5]), 0.5
    for _ in range(HALVINGS):
        apart = gaps(robot, scenery, motion.at(middles))
        if (apart <= 0.0).any():
            return False
        uncertain = middles[apart <= half * motion.farthest]
        if len(uncertain) == 0:
            return True
        half /= 2.0
        middles = np.concatenate([uncertain - half, uncertain + half])
    return True


def is_semi_free_motion(scenery: Scenery, a: np.ndarray, b: np.ndarray) -> bool:
    """Whether a point's straight motion enters nothing; contact is allowed. By shapely's exact
    predicates, piece by piece.
    """
    line = shapely.LineString([a, b]) if (a != b).any() else shapely.Point(a)
    inside = [shapely.relate_pattern(line, piece, "T********") for piece in scenery.pieces]
    return not any(inside) and bool(shapely.covers(scenery.room, line))


def is_valid(plan: Plan, *, semi_free: bool = False) -> bool:
    """Whether a plan's path goes from the start to the goal, is as long as it says, and free
    (semi-free) all the way.
    """
    problem, path = plan.problem, plan.path
    assert isinstance(problem, ProblemRecord) and path is not None
    if isinstance(problem.robot, CarRobot):
        return is_valid_drive(plan, problem)
    if not (np.array_equal(path[0], problem.start) and np.array_equal(path[-1], problem.goal)):
        return False
    length = sum(problem.distance(a, b) for a, b in pairwise(path))
    scenery = scenery_of(problem.world)
    if semi_free:
        free = all(is_semi_free_motion(scenery, a, b) for a, b in pairwise(path))
    else:
        free = all(
            is_free_motion(problem.robot, scenery, straight(problem.robot, a, b))
            for a, b in pairwise(path)
        )
    return free and bool(np.isclose(length, plan.cost, rtol=1e-9))


def is_valid_drive(plan: Plan, problem: ProblemRecord) -> bool:
    """The same for a car, whose controls are replayed: from the start along the path's poses, each
    arc free, to the goal or, for planners that drive at random, to what counts as the goal."""
    car, there, path = problem.robot, trajectory_along(plan), plan.path
    scenery, passed = scenery_of(problem.world), [np.array(there.start)]
    for (v, phi), t in zip(there.controls, there.durations):
        if abs(phi) > car.max_steering * (1.0 + 1e-12) or not np.isin(v, car.speeds) or t < 0.0:
            return False
        drive = arc(car, passed[-1], v * t, phi)
        if not is_free_motion(car, scenery, drive):
            return False
        passed.append(drive.at(np.array([1.0]))[0])
    off = [min(pose_difference(q, pose) for pose in passed) for q in path]
    near = plan.planner.startswith(("kinodynamic", "SST"))
    tolerance = np.array([0.25 * car.wheelbase, np.radians(15.0)]) if near else np.full(2, 1e-6)
    return (
        np.array_equal(there.start, problem.start)
        and max(off) < 1e-6
        and pose_difference(path[-1], passed[-1]) < 1e-6
        and bool((np.abs(pose_offset(path[-1], problem.goal)) <= tolerance).all())
        and bool(np.isclose(there.length, plan.cost, rtol=1e-9))
    )


def pose_offset(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """How far two poses are apart, and by what angle, shape (2,)."""
    return np.array([np.hypot(*(p - q)[:2]), (p[2] - q[2] + np.pi) % (2 * np.pi) - np.pi])


def pose_difference(p: np.ndarray, q: np.ndarray) -> float:
    """The larger of the two."""
    return float(np.abs(pose_offset(p, q)).max())
