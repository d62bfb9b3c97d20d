"""The chance that a path is hit by obstacles whose places are uncertain: bounded by its distances,
and estimated by scenarios.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..chances import wilson
from ..compiled import algorithm
from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import Array, as_array
from ..geometry.exact import length
from ..geometry.parts import Parts
from ..robots.polygon import TranslatingPolygonRobot
from ..robots.round import RoundRobot
from ..support.text import shortened
from ..worlds.uncertain import UncertainWorldRecord, scenarios
from .asks import is_free_path
from .passing import gap, touches

SURE = 1e-9  # an offset shorter than a gap by this share of it cannot close it


class Chance(NamedTuple):
    """A chance that was tried: the share of the n scenarios with a contact, and the ends of
    Wilson's 95 percent interval.
    """

    estimate: float
    low: float
    high: float
    hits: int
    n: int


def collision_probability(
    robot: Any,
    world: UncertainWorldRecord,
    path: ArrayLike,
    *,
    n: int = 10_000,
    rng: int | np.random.Generator,
) -> Chance:
    """The chance that the robot touches an obstacle anywhere along a path, estimated by n
    scenarios.

    Parameters
    ----------
    robot : Point(), Disk(radius) or TranslatingPolygon(vertices). world : an UncertainWorld.
    path : (k, 2), k >= 1, its stretches judged whole. rng : a seed or a Generator; the same one
    draws the same scenarios for
        another path, so that what two paths differ by is not chance.

    A path that touches the boundary, which is certain, is hit in all. O(n m k). Raises
    InvalidPoint, InvalidParameter.

    >>> from ..robots import Point
    >>> from ..worlds.uncertain import UncertainWorld
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [((4, 3), 1)], 0.5)
    >>> chance = collision_probability(Point(), world, [(1, 1), (8, 1)], rng=0)
    >>> bool(chance.low < 0.0228 < chance.high)
    True
    """
    body_of, way = as_mover(robot), as_path(path)
    offsets = scenarios(world, n, rng=rng)
    if len(offsets) == 0:
        raise InvalidParameter("a chance is estimated from at least one scenario, n >= 1")
    if any(
        not is_free_path(body_of, world.empty, a, b, 0.0) for a, b in zip(way, [*way[1:], way[-1]])
    ):
        return Chance(1.0, 1.0, 1.0, len(offsets), len(offsets))
    hits = int(
        hit_scenarios(
            body_of, world.parts, world.owner, part_gaps(body_of, world.parts, way), way, offsets
        ).sum()
    )
    low, high = wilson(hits, len(offsets))
    return Chance(hits / len(offsets), float(low), float(high), hits, len(offsets))


def path_clearances(robot: Any, world: UncertainWorldRecord, path: ArrayLike) -> Array:
    """How near a path comes to each obstacle where it is expected, shape (m,); 0 where it touches.
    Raises as above.

    >>> from ..robots import Point
    >>> from ..worlds.uncertain import UncertainWorld
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [((4, 3), 1)], 0.5)
    >>> path_clearances(Point(), world, [(1, 1), (8, 1)])
    array([1.])
    """
    gaps, nearest = (
        part_gaps(as_mover(robot), world.parts, as_path(path)),
        np.full(len(world.sigma), np.inf),
    )
    np.minimum.at(nearest, world.owner, gaps)
    return np.maximum(nearest, 0.0)


def collision_bound(robot: Any, world: UncertainWorldRecord, path: ArrayLike) -> float:
    """A number that the chance to be hit does not exceed: the sum of exp(-d^2 / (2 sigma^2)) over
    the obstacles, at most 1.

    d is how near the path comes to an obstacle: an offset shorter than that cannot reach it. Raises
    as above.

    >>> from ..robots import Point
    >>> from ..worlds.uncertain import UncertainWorld
    >>> world = UncertainWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [((4, 3), 1)], 0.5)
    >>> round(collision_bound(Point(), world, [(1, 1), (8, 1)]), 4)
    0.1353
    """
    d, sigma = path_clearances(robot, world, path), world.sigma
    certain = sigma == 0.0
    if (certain & (d == 0.0)).any():
        return 1.0
    chances = np.exp(-0.5 * (d[~certain] / sigma[~certain]) ** 2)
    return float(min(chances.sum(), 1.0))


@algorithm
def part_gaps(robot: Any, parts: Parts, path: Array) -> Array:
    """How near the path comes to each part, shape (k,); negative where it is inside what is
    round.
    """
    least = np.full(len(parts.radius), np.inf)
    for j in range(len(parts.radius)):
        for i in range(len(path)):
            least[j] = min(least[j], gap(robot, path[max(i - 1, 0)], path[i], parts, j))
    return least


@algorithm
def hit_scenarios(
    robot: Any, parts: Parts, owner: NDArray[np.int64], gaps: Array, path: Array, offsets: Array
) -> NDArray[np.bool_]:
    """Whether the path touches some obstacle in each scenario, offsets (n, m, 2); shape (n,).

    An obstacle moved by e is passed as the path moved by -e passes it where it is expected. gaps
    are the `part_gaps`.
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


def as_mover(robot: Any) -> Any:
    """A robot that does not turn, or InvalidParameter."""
    if not isinstance(robot, RoundRobot | TranslatingPolygonRobot):
        raise InvalidParameter(
            "expected Point(), Disk(radius) or TranslatingPolygon(vertices), got "
            f"{shortened(robot)}"
        )
    return robot


def as_path(path: ArrayLike) -> Array:
    """A path of at least one point, (k, 2), or InvalidPoint."""
    way = as_array(path, "path")
    if way.ndim != 2 or way.shape[1] != 2 or len(way) == 0:
        raise InvalidPoint(f"a path must have shape (k, 2), k >= 1, got {way.shape}")
    return way
