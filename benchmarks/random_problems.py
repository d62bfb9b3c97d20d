"""Problems at random: every kind of robot in worlds of polygons and discs and on terrains, each
drawn from a seed.
"""

from typing import NamedTuple

import numpy as np

import kinoedu as ke
from kinoedu.errors import InvalidGoal, InvalidStart
from kinoedu.problems import ProblemRecord

SIDE = 10.0
SQUARE = [(0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE)]
NOTCHED = [(0, 0), (SIDE, 0), (SIDE, SIDE), (6, SIDE), (5, 6.5), (4, SIDE), (0, SIDE)]
L_SHAPE = np.array([(-0.5, -0.2), (0.6, -0.2), (0.6, 0.1), (-0.2, 0.1), (-0.2, 0.7), (-0.5, 0.7)])
ROBOTS = ("point", "disk", "sliding polygon", "turning polygon", "arm", "car")
WORLDS = ("polygons", "discs too", "terrain")


class Drawn(NamedTuple):
    """A problem, what kind of robot and of world it has, and the seed it was drawn from."""

    problem: ProblemRecord
    robot: str
    world: str
    seed: int


def drawn(seed: int) -> Drawn:
    """The problem of a seed; all robots in all worlds come in turn. A world without two free
    configurations is drawn again.
    """
    rng = np.random.default_rng([seed, 145])
    robot, world = ROBOTS[seed % len(ROBOTS)], WORLDS[seed // len(ROBOTS) % len(WORLDS)]
    while True:
        place, body = world_at_random(world, rng), robot_at_random(robot, rng)
        for _ in range(200):
            try:
                problem = ke.Problem(body, place, *ends_at_random(robot, place, rng))
            except (InvalidStart, InvalidGoal):
                continue
            return Drawn(problem, robot, world, seed)


def robot_at_random(kind: str, rng: np.random.Generator) -> object:
    """A robot, of a size that gets through most gaps; some polygons are needles."""
    if kind == "point":
        return ke.Point()
    if kind == "disk":
        return ke.Disk(rng.uniform(0.05, 0.5))
    if kind == "car":
        length, speeds = rng.uniform(0.6, 1.6), (-1.0, 1.0) if rng.random() < 0.7 else (1.0,)
        return ke.Car(
            length,
            rng.uniform(0.3, 0.5) * length,
            0.6 * length,
            max_steering=rng.uniform(0.4, 0.9),
            speeds=speeds,
        )
    if kind == "arm":
        return ke.TwoLinkArm(
            *rng.uniform(1.0, 2.5, 2), rng.uniform(0.0, 0.3), base=rng.uniform(3.0, 7.0, 2)
        )
    outline = rng.uniform(0.4, 1.2) * L_SHAPE if rng.random() < 0.7 else L_SHAPE * (1.5, 0.05)
    return ke.TranslatingPolygon(outline) if kind == "sliding polygon" else ke.RigidPolygon(outline)


def world_at_random(kind: str, rng: np.random.Generator) -> object:
    """A world of 10 x 10: up to 20 obstacles, which may lie over each other, walls a hair thin
    among them; or a bitmap.
    """
    if kind == "terrain":
        cells = int(rng.integers(8, 40))
        return ke.Terrain(
            rng.random((cells, cells)) > rng.uniform(0.02, 0.25), resolution=SIDE / cells
        )
    obstacles: list[object] = [star(rng) for _ in range(rng.integers(1, 12))]
    for _ in range(rng.integers(0, 5)):
        x, y, thickness = rng.uniform(0, 8), rng.uniform(0, 8), 10.0 ** rng.uniform(-8, -1)
        obstacles.append([(x, y), (x + thickness, y), (x + thickness, y + 3), (x, y + 3)])
    if kind == "discs too":
        obstacles += [
            (rng.uniform(0, SIDE, 2), rng.uniform(0.1, 1.0)) for _ in range(rng.integers(1, 6))
        ]
    return ke.PolygonWorld(SQUARE if rng.random() < 0.6 else NOTCHED, obstacles)


def star(rng: np.random.Generator) -> np.ndarray:
    """A polygon of 3 to 9 corners at random distances round a centre, convex or not, shape (k,
    2).
    """
    k = rng.integers(3, 10)
    angles = 2 * np.pi * (np.arange(k) + rng.uniform(0.05, 0.95, k)) / k
    return rng.uniform(0, SIDE, 2) + rng.uniform(0.3, 1.6, (k, 1)) * np.stack(
        [np.cos(angles), np.sin(angles)], axis=1
    )


def ends_at_random(robot: str, world: object, rng: np.random.Generator) -> np.ndarray:
    """Two configurations, free or not, shape (2, d)."""
    if robot == "arm":
        return rng.uniform(-np.pi, np.pi, (2, 2))
    places = rng.uniform(0, SIDE, (2, 2))
    return (
        np.column_stack([places, rng.uniform(-np.pi, np.pi, 2)])
        if robot in ("turning polygon", "car")
        else places
    )
