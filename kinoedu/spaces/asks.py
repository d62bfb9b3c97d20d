"""What a planner asks of a configuration space. Each kind of space answers in its own file."""

import math
from typing import Any

import numpy as np

from ..compiled import generic
from ..geometry.checks import Array


@generic(1)
def distance(space: Any, a: Array, b: Array) -> float:
    """The distance between two configurations, the short way round where coordinates wrap."""
    raise TypeError("this space has no distance")


@generic(1)
def interpolate(space: Any, a: Array, b: Array, t: float) -> Array:
    """The configuration a fraction t of the short way from a to b."""
    raise TypeError("this space cannot interpolate")


@generic(1)
def sample(space: Any, rng: np.random.Generator) -> Array:
    """A configuration drawn uniformly."""
    raise TypeError("this space cannot be sampled")


@generic(1)
def nearest(space: Any, tree: Any, q: Array) -> int:
    """The number of the tree's node nearest to q, the first among equally near ones."""
    best, best_distance = 0, np.inf
    for i in range(tree.size[0]):
        d = distance(space, tree.nodes[i], q)
        if d < best_distance:
            best, best_distance = i, d
    return best


@generic(1)
def diameter(space: Any) -> float:
    """The largest distance between two configurations: of a box, its diagonal."""
    total = 0.0
    for i in range(len(space.lo)):
        total += (space.hi[i] - space.lo[i]) * (space.hi[i] - space.lo[i])
    return math.sqrt(total)
