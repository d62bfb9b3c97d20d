"""Problems and nodes for cases on roadmaps: a point in halls, and an arm whose angles wrap."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ....geometry.checks import Array
from ....problems import Problem
from ....problems.protocols import PlanningProblem, ProblemLike
from ....robots import Point, TwoLinkArm
from ....robots.arm import ArmRobot
from ....worlds import PolygonWorld
from ...shapes import Value
from ...tasks import StudentProblem
from ..shared.random_shapes import star_polygon
from ..shared.random_worlds import room_in, round_polygon

FULL = 2.0 * np.pi
HALL = np.array([(0, 0), (16, 0), (16, 10), (0, 10)], float)
WALL = np.array([(7, 0.5), (9, 0.5), (9, 6), (7, 6)], float)
# a wall so thin that it fits between sampled points of a motion
SHEET = np.array([(8, 0.5), (8.001, 0.5), (8.001, 9), (8, 9)], float)
# two points whose motion touches a corner of the wall
GRAZING = (5.5, 4.5), (8.0, 7.0)
# two points on both sides of the sheet; no simple fraction of their motion lies in it
ASTRIDE = (5.1, 3.0), (11.37, 4.0)
START, GOAL = (1.0, 1.0), (15.0, 1.0)
DISCS = [((0, 2.9), 0.6)]  # beside the arm


def make_hall(
    *obstacles: Value, start: ArrayLike = START, goal: ArrayLike = GOAL, room: Array = HALL
) -> StudentProblem:
    """Return a problem in the hall, or in another room, with the given obstacles."""
    return StudentProblem(Problem(Point(), PolygonWorld(room, obstacles), start, goal))


def make_arm(
    discs: Value = DISCS, start: ArrayLike = (0, 0), goal: ArrayLike = (3, 0)
) -> StudentProblem:
    """Return the problem of an arm among discs; its configurations are two angles."""
    room = np.array([(-6, -6), (6, -6), (6, 6), (-6, 6)], float)
    return StudentProblem(Problem(TwoLinkArm(2, 1.5, 0.3), PolygonWorld(room, discs), start, goal))


def is_arm(problem: Any) -> bool:
    """Whether the problem is that of the arm."""
    return isinstance(problem.robot, ArmRobot)


def draw_obstacles(rng: np.random.Generator, n: int, *, convex: bool = True) -> list[Array]:
    """Draw n polygons in the hall that keep its start and goal free.

    They are counter-clockwise, do not touch each other, and have coordinates with two decimals.
    """
    room, rings = room_in(HALL), list[Array]()
    while len(rings) < n:
        corners, middle = int(rng.integers(3, 7)), rng.uniform((3.5, 2.5), (12.5, 7.5))
        shape = round_polygon(rng, corners, 2.2) if convex else star_polygon(rng, corners + 2, 2.6)
        ring = np.round(0.6 * shape + middle, 2)
        if room.fits(ring, rings) and is_clear(ring):
            rings.append(ring)
    return rings


def is_clear(ring: Array) -> bool:
    """Whether no three consecutive vertices of a ring are nearly in line."""
    return bool((np.abs(measure_turns(ring)) > 1e-3).all())


def measure_turns(ring: Array) -> Array:
    """Return twice the signed area of each vertex with its neighbours, (n,).

    It is positive at a left turn.
    """
    a, b = ring - np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0) - ring
    turned: Array = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return turned


def draw_free_nodes(rng: np.random.Generator, problem: PlanningProblem, n: int) -> Array:
    """Draw n free configurations with two decimals, shape (n, 2).

    All distances between them are different.
    """
    lo, hi = ((0.0, 0.0), (FULL - 0.01, FULL - 0.01)) if is_arm(problem) else (HALL[0], HALL[2])
    while True:
        nodes: list[Array] = []
        while len(nodes) < n:
            q = np.round(rng.uniform(lo, hi), 2)
            nodes += [q] if problem.is_free(q) else []
        apart = np.sort(measure_distances(problem, np.array(nodes))[np.triu_indices(n, 1)])
        if (np.diff(apart) > 1e-7).all():
            return np.array(nodes)


def measure_distances(problem: ProblemLike, nodes: Array) -> Array:
    """Return the distance between any two of n nodes, (n, n)."""
    apart = np.zeros((len(nodes), len(nodes)))
    for j in range(len(nodes)):
        for i in range(j):
            apart[i, j] = apart[j, i] = problem.distance(nodes[i], nodes[j])
    return apart
