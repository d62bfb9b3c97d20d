"""Spaces of which some coordinates are angles: the circle, the torus, SE(2). Bullo & Smith, section 3.2; LaValle, section 5.1.

A configuration's angles lie in [-pi, pi); every distance and every motion takes the short way round.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..geometry.checks import Array
from .angles import short_way, wrapped
from .asks import distance, interpolate, sample


class WrappingSpace(NamedTuple):
    """Coordinates between lo and hi, shapes (d,); those that wrap are angles, from -pi to pi.

    Each coordinate counts with its weight: the distance is sqrt(sum (weight_i * difference_i)^2), so that with a weight in metres
    a radian is comparable with a length.
    """

    lo: Array
    hi: Array
    wraps: NDArray[np.bool_]
    weight: Array


@distance.register(WrappingSpace)
def weighted_distance(space: WrappingSpace, a: Array, b: Array) -> float:
    """The weighted Euclidean distance, the short way round."""
    total = 0.0
    for i in range(len(a)):
        apart = space.weight[i] * (short_way(a[i], b[i]) if space.wraps[i] else b[i] - a[i])
        total += apart * apart
    return math.sqrt(total)


@interpolate.register(WrappingSpace)
def the_short_way(space: WrappingSpace, a: Array, b: Array, t: float) -> Array:
    """Each coordinate on its own way from a to b, angles the short way."""
    q = np.empty(len(a))
    for i in range(len(a)):
        q[i] = wrapped(a[i] + t * short_way(a[i], b[i])) if space.wraps[i] else a[i] + t * (b[i] - a[i])
    return q


@sample.register(WrappingSpace)
def all_round(space: WrappingSpace, rng: np.random.Generator) -> Array:
    """Each coordinate uniform between its bounds."""
    q = np.empty(len(space.lo))
    for i in range(len(q)):
        q[i] = space.lo[i] + (space.hi[i] - space.lo[i]) * rng.random()
    return q
