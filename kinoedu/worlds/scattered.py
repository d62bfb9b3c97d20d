"""Random convex polygons in a square: test worlds that are determined by a seed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..errors import InvalidParameter
from ..geometry.checks import Array, as_array, as_generator, integer, nonnegative, positive
from .polygon_world import PolygonWorld, PolygonWorldRecord

TRIES = 1000  # draws for each obstacle before the world counts as full


def scattered(
    n: int,
    *,
    side: float = 20.0,
    radius: float = 1.5,
    gap: float | None = None,
    keep_free: Sequence[Sequence[float]] = (),
    rng: int | np.random.Generator,
) -> PolygonWorldRecord:
    """Draw a square world with n random convex polygons.

    The same seed gives the same world; the first k of n obstacles are those of the world with k.

    Parameters
    ----------
    n : the number of obstacles; 0 or more.
    side : of the square, whose lower left corner is (0, 0).
    radius : each obstacle has 3 to 7 corners on a circle whose radius is between half of this and
        this; it contains the centre of the circle.
    gap : the least distance between the circles of two obstacles; without it they may overlap.
    keep_free : discs (x, y, r) that no obstacle touches, such as those around start and goal.
    rng : a seed or a numpy Generator.

    Returns
    -------
    PolygonWorldRecord

    Raises
    ------
    InvalidParameter
        Where an argument is not valid, or there is no room for n obstacles.
    InvalidPoint
        Where `keep_free` is not finite numbers.

    Examples
    --------
    >>> ten, twenty = scattered(10, rng=0), scattered(20, rng=0)
    >>> len(ten.obstacles.radius), len(twenty.obstacles.radius)
    (10, 20)
    >>> bool((ten.obstacles.points == twenty.obstacles.points[: len(ten.obstacles.points)]).all())
    True
    """
    count, width, size = (
        integer(n, "n", least=0),
        positive(side, "side"),
        positive(radius, "radius"),
    )
    if 2.0 * size > width:
        raise InvalidParameter(
            f"an obstacle of radius {size:g} must fit into a side of {width:g}; make it smaller"
        )
    apart = -np.inf if gap is None else nonnegative(gap, "gap")
    generator, placed, polygons = as_generator(rng), as_discs(keep_free), []
    fixed = len(placed)
    for number in range(count):
        x, y, r = draw_disc(placed, fixed, apart, width, size, generator, number)
        placed = np.vstack([placed, (x, y, r)])
        polygons.append((x, y) + r * draw_corners(generator))
    return PolygonWorld([(0.0, 0.0), (width, 0.0), (width, width), (0.0, width)], polygons)


def draw_disc(
    placed: Array,
    fixed: int,
    apart: float,
    side: float,
    radius: float,
    rng: np.random.Generator,
    number: int,
) -> tuple[float, float, float]:
    """Draw a disc (x, y, r) off the first `fixed` discs and `apart` from the others."""
    least = np.where(np.arange(len(placed)) < fixed, 0.0, apart)
    for _ in range(TRIES):
        r = radius * rng.uniform(0.5, 1.0)
        x, y = rng.uniform(r, side - r, 2)
        if (np.hypot(placed[:, 0] - x, placed[:, 1] - y) - placed[:, 2] - r > least).all():
            return float(x), float(y), float(r)
    raise InvalidParameter(
        f"after {TRIES:,} tries there is no room for obstacle {number}; choose fewer or smaller "
        "obstacles"
    )


def draw_corners(rng: np.random.Generator) -> Array:
    """Draw the corners (k, 2), 3 <= k <= 7, of a convex polygon on the unit circle.

    They are counter-clockwise, and the polygon contains the centre.
    """
    k = int(rng.integers(3, 8))
    while True:
        angles = np.sort(rng.uniform(0.0, 2.0 * np.pi, k))
        steps = np.diff(angles, append=angles[0] + 2.0 * np.pi)
        if 0.05 < steps.min() and steps.max() < np.pi:
            return np.column_stack([np.cos(angles), np.sin(angles)])


def as_discs(discs: Sequence[Sequence[float]]) -> Array:
    """Check discs; rows x, y, r, shape (k, 3). Raises InvalidParameter or InvalidPoint."""
    rows = as_array(discs, "keep_free")
    if rows.shape == (0,):
        return rows.reshape(0, 3)
    if rows.ndim != 2 or rows.shape[1] != 3 or (rows[:, 2] < 0.0).any():
        raise InvalidParameter(
            f"keep_free takes discs (x, y, r) whose radius is not negative, got {rows.tolist()}"
        )
    return rows
