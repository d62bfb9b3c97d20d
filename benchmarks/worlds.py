"""The problems that are timed, each drawn from a seed."""

from typing import NamedTuple

import numpy as np

import kinoedu as ke
from kinoedu.problems import ProblemRecord

SIDE = 100.0
SQUARE = [(0, 0), (SIDE, 0), (SIDE, SIDE), (0, SIDE)]
WALLED_IN = (96.5, 96.5)  # what `walls` encloses


class Case(NamedTuple):
    """A problem, the seed it was drawn from, and its obstacles in the form other libraries want
    them.
    """

    problem: ProblemRecord
    seed: int
    obstacles: np.ndarray


def among_polygons(seed: int) -> Case:
    """20 convex polygons of 4 to 8 corners, and 4 round a goal that cannot be reached. Rows x, y,
    radius: the polygons' circles.
    """
    polygons, circles = discs(20, seed)
    world = ke.PolygonWorld(SQUARE, polygons + walls())
    return Case(
        ke.Problem(ke.Point(), world, (2, 2), WALLED_IN),
        seed,
        np.vstack([circles, [*WALLED_IN, 2.5]]),
    )


def between_polygons(seed: int) -> Case:
    """24 convex polygons of 4 to 8 corners between two opposite corners of the square. Rows x, y,
    radius: their circles.
    """
    polygons, circles = discs(24, seed)
    return Case(
        ke.Problem(ke.Point(), ke.PolygonWorld(SQUARE, polygons), (2, 2), (98, 98)), seed, circles
    )


def discs(count: int, seed: int) -> tuple[list[np.ndarray], np.ndarray]:
    """Convex polygons in circles of radius 5 at random, and the circles, rows x, y, radius."""
    rng = np.random.default_rng(seed)
    centres = rng.uniform(10, 90, (count, 2))
    polygons = [inscribed_polygon(centre, 5.0, rng) for centre in centres]
    return polygons, np.column_stack([centres, np.full(count, 5.0)])


def inscribed_polygon(centre: np.ndarray, radius: float, rng: np.random.Generator) -> np.ndarray:
    """A convex polygon of 4 to 8 corners on a circle, with the circle's centre inside, shape (k,
    2).
    """
    k = rng.integers(4, 9)
    while True:
        angles = np.sort(rng.uniform(0, 2 * np.pi, k))
        if np.diff(np.append(angles, angles[0] + 2 * np.pi)).max() < np.pi:
            return centre + radius * np.column_stack([np.cos(angles), np.sin(angles)])


def walls() -> list[np.ndarray]:
    """Four boxes that enclose WALLED_IN."""
    return [box(94, 94, 5, 1), box(94, 98, 5, 1), box(94, 95, 1, 3), box(98, 95, 1, 3)]


def box(x: float, y: float, width: float, height: float) -> np.ndarray:
    """A box by its lower left corner and its size, shape (4, 2)."""
    return np.array([(x, y), (x + width, y), (x + width, y + height), (x, y + height)])


def among_boxes(seed: int) -> Case:
    """24 boxes between two opposite corners of the square. Rows x, y, width, height."""
    rng = np.random.default_rng(seed)
    boxes = np.hstack([rng.uniform(5, 83, (24, 2)), rng.uniform(4, 12, (24, 2))])
    world = ke.PolygonWorld(SQUARE, [box(*row) for row in boxes])
    return Case(ke.Problem(ke.Point(), world, (2, 2), (98, 98)), seed, boxes)


def through_doors(seed: int) -> Case:
    """Three walls across the square, each with a door two units wide. Rows x, y, width, height."""
    doors = np.random.default_rng(seed).uniform(10, 88, 3)
    boxes = np.array(
        [
            row
            for x, door in zip((24, 49, 74), doors)
            for row in ((x, 0, 2, door), (x, door + 2, 2, 98 - door))
        ]
    )
    world = ke.PolygonWorld(SQUARE, [box(*row) for row in boxes])
    return Case(ke.Problem(ke.Point(), world, (2, 2), (98, 98)), seed, boxes)


def bitmap(seed: int, blocked: float, size: int = 1000) -> np.ndarray:
    """A random bitmap (size, size), true where free, with free opposite corners."""
    free = np.random.default_rng(seed).random((size, size)) >= blocked
    free[:3, :3] = free[-3:, -3:] = True
    return free
