"""R^n: configurations that are points of a box. LaValle, Planning Algorithms, section 5.1."""

import math
from typing import Any, NamedTuple

import numpy as np

from ..geometry.checks import Array
from .asks import distance, interpolate, nearest, sample
from .buckets import nearest_in_buckets


class RealSpace(NamedTuple):
    """The box from lo to hi, shapes (d,), with the Euclidean distance."""

    lo: Array
    hi: Array


@distance.register(RealSpace)
def euclidean_distance(space: RealSpace, a: Array, b: Array) -> float:
    """|b - a|."""
    total = 0.0
    for i in range(len(a)):
        total += (b[i] - a[i]) * (b[i] - a[i])
    return math.sqrt(total)


@interpolate.register(RealSpace)
def on_the_line(space: RealSpace, a: Array, b: Array, t: float) -> Array:
    """a + t (b - a)."""
    q = np.empty(len(a))
    for i in range(len(a)):
        q[i] = a[i] + t * (b[i] - a[i])
    return q


@sample.register(RealSpace)
def in_the_box(space: RealSpace, rng: np.random.Generator) -> Array:
    """Each coordinate uniform between its bounds."""
    q = np.empty(len(space.lo))
    for i in range(len(q)):
        q[i] = space.lo[i] + (space.hi[i] - space.lo[i]) * rng.random()
    return q


@nearest.register(RealSpace)
def nearest_euclidean(space: RealSpace, tree: Any, q: Array) -> int:
    """By the tree's grid of buckets."""
    return nearest_in_buckets(tree, q)
