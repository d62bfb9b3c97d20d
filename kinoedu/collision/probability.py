"""The probability that a path collides with obstacles at uncertain positions.

It is bounded by the clearances of the path, and estimated by random scenarios.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..chances import wilson_interval
from ..compiled import algorithm
from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import Array, as_array
from ..geometry.exact import length
from ..geometry.parts import Parts
from ..robots.kinds import Robot
from ..robots.polygon import TranslatingPolygonRobot
from ..robots.round import RoundRobot
from ..support.constructors import with_type_names
from ..support.text import shortened
from ..worlds.uncertain import UncertainWorldRecord, check_uncertain, scenarios
from .interface import is_free_path
from .passing import gap, touches

SURE = 1e-9  # an offset shorter than (1 - SURE) times a gap cannot close it


@with_type_names
class Chance(NamedTuple):
    """An estimated probability: the fraction of n scenarios with contact.

    low and high are the ends of Wilson's 95 percent interval, hits the number of scenarios with
    contact.
    """

    estimate: float
    low: float
    high: float
    hits: int
    n: int


def collision_probability(
    robot: Robot,
    world: UncertainWorldRecord,
    path: ArrayLike,
    *,
    n: int = 10_000,
    rng: int | np.random.Generator,
) -> Chance:
    """Estimate the probability that the robot touches an obstacle along a path, by n scenarios.

    A path that touches the boundary, which is certain, collides in all scenarios. O(n m k) for m
    convex pieces of obstacles and k points of the path.

    Parameters
    ----------
    robot : Point(), Disk(radius) or TranslatingPolygon(vertices).
    world : an UncertainWorld.
    path : (k, 2), k >= 1; each segment is tested as a whole.
    rng : a seed or a Generator. The same seed draws the same scenarios for another path, so that
        the difference between two paths is not random.

    Returns
    -------
    Chance

    Raises
    ------
    InvalidPoint
        Where the path is not valid.
    InvalidParameter
        Where the robot, the world or n is not valid.

    Examples
    --------
    >>> from kinoedu import Point, UncertainWorld
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [((4, 3), 1)], 0.5)
    >>> chance = collision_probability(Point(), world, [(1, 1), (8, 1)], rng=0)
    >>> bool(chance.low < 0.0228 < chance.high)
    True
    """
    robot, points = as_translating_robot(robot), as_path(path)
    check_uncertain(world)
    offsets = scenarios(world, n, rng=rng)
    if len(offsets) == 0:
        raise InvalidParameter("a probability is estimated from at least one scenario, n >= 1")
    if not stays_inside(robot, world, points):
        return Chance(1.0, 1.0, 1.0, len(offsets), len(offsets))
    gaps = part_gaps(robot, world.parts, points)
    hits = int(hit_scenarios(robot, world.parts, world.owner, gaps, points, offsets).sum())
    low, high = wilson_interval(hits, len(offsets))
    return Chance(hits / len(offsets), float(low), float(high), hits, len(offsets))


def path_clearances(robot: Robot, world: UncertainWorldRecord, path: ArrayLike) -> Array:
    """The distance between a path and the expected position of each obstacle; 0 where they touch.

    Returns
    -------
    (m,) array.

    Raises
    ------
    InvalidPoint, InvalidParameter
        As `collision_probability`.

    Examples
    --------
    >>> from kinoedu import Point, UncertainWorld
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [((4, 3), 1)], 0.5)
    >>> path_clearances(Point(), world, [(1, 1), (8, 1)])
    array([1.])
    """
    check_uncertain(world)
    gaps = part_gaps(as_translating_robot(robot), world.parts, as_path(path))
    nearest = np.full(len(world.sigma), np.inf)
    np.minimum.at(nearest, world.owner, gaps)
    return np.maximum(nearest, 0.0)


def collision_bound(robot: Robot, world: UncertainWorldRecord, path: ArrayLike) -> float:
    """An upper bound of the probability of a collision along a path.

    The sum of exp(-d^2 / (2 sigma^2)) over the obstacles, at most 1, where d is the clearance of
    the path from the obstacle: a shorter offset cannot reach the path. It is 1 where the path
    touches the boundary, which is certain.

    Returns
    -------
    float

    Raises
    ------
    InvalidPoint, InvalidParameter
        As `collision_probability`.

    Examples
    --------
    >>> from kinoedu import Point, UncertainWorld
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [((4, 3), 1)], 0.5)
    >>> round(collision_bound(Point(), world, [(1, 1), (8, 1)]), 4)
    0.1353
    """
    d, sigma = path_clearances(robot, world, path), world.sigma
    if not stays_inside(as_translating_robot(robot), world, as_path(path)):
        return 1.0
    certain = sigma == 0.0
    if (certain & (d == 0.0)).any():
        return 1.0
    chances = np.exp(-0.5 * (d[~certain] / sigma[~certain]) ** 2)
    return float(min(chances.sum(), 1.0))


@algorithm
def part_gaps(robot: Robot, parts: Parts, path: Array) -> Array:
    """The distance between the path and each part, shape (k,); negative inside a round part."""
    least = np.full(len(parts.radius), np.inf)
    for j in range(len(parts.radius)):
        for i in range(len(path)):
            least[j] = min(least[j], gap(robot, path[max(i - 1, 0)], path[i], parts, j))
    return least


@algorithm
def hit_scenarios(
    robot: Robot, parts: Parts, owner: NDArray[np.int64], gaps: Array, path: Array, offsets: Array
) -> NDArray[np.bool_]:
    """Whether the path touches an obstacle in each scenario, shape (n,); offsets (n, m, 2).

    An obstacle moved by e meets the path exactly where the obstacle at its expected position meets
    the path moved by -e. gaps are the `part_gaps`.
    """
    hit = np.zeros(len(offsets), np.bool_)
    for s in range(len(offsets)):
        for j in range(len(parts.radius)):
            ex, ey = offsets[s, owner[j], 0], offsets[s, owner[j], 1]
            if length(ex, ey) < gaps[j] * (1.0 - SURE):
                continue
            for i in range(len(path)):
                a, b = path[max(i - 1, 0)], path[i]
                if touches(robot, a[0] - ex, a[1] - ey, b[0] - ex, b[1] - ey, parts, j, 0.0):
                    hit[s] = True
                    break
            if hit[s]:
                break
    return hit


def stays_inside(robot: Any, world: UncertainWorldRecord, path: Array) -> bool:
    """Whether a path does not touch the boundary."""
    segments = zip(path, [*path[1:], path[-1]])
    return all(is_free_path(robot, world.empty, a, b, 0.0) for a, b in segments)


def as_translating_robot(robot: Robot) -> Any:
    """Check that a robot does not rotate; raise InvalidParameter otherwise."""
    if not isinstance(robot, RoundRobot | TranslatingPolygonRobot):
        raise InvalidParameter(
            "expected Point(), Disk(radius) or TranslatingPolygon(vertices), got "
            f"{shortened(robot)}"
        )
    return robot


def as_path(path: ArrayLike) -> Array:
    """Check a path of at least one point, (k, 2); raise InvalidPoint otherwise."""
    points = as_array(path, "path")
    if points.ndim != 2 or points.shape[1] != 2 or len(points) == 0:
        raise InvalidPoint(f"a path must have shape (k, 2), k >= 1, got {points.shape}")
    return points
