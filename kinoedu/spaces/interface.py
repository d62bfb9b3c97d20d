"""The operations that a planner needs of a configuration space.

They are generic functions. Each kind of space implements them in its own file.
"""

from __future__ import annotations

import math
from typing import Protocol

import numpy as np

from ..compiled import generic
from ..geometry.checks import Array
from .buckets import GrowingTree


class Space(Protocol):
    """A configuration space: configurations lie between lo and hi, shapes (d,)."""

    @property
    def lo(self) -> Array:
        """The least coordinates."""

    @property
    def hi(self) -> Array:
        """The largest coordinates."""


@generic(1)
def distance(space: Space, a: Array, b: Array) -> float:
    """The distance between two configurations; angles take the shorter way around.

    Raises
    ------
    TypeError
        Where `space` is not a space.
    """
    raise TypeError("this space has no distance")


@generic(1)
def interpolate(space: Space, a: Array, b: Array, t: float) -> Array:
    """The configuration at a fraction t of the shortest motion from a to b.

    Raises
    ------
    TypeError
        Where `space` is not a space.
    """
    raise TypeError("this space cannot interpolate")


@generic(1)
def sample(space: Space, rng: np.random.Generator) -> Array:
    """A configuration drawn uniformly.

    Raises
    ------
    TypeError
        Where `space` is not a space.
    """
    raise TypeError("this space cannot be sampled")


def sample_box(space: Space, rng: np.random.Generator) -> Array:
    """`sample` for a box: each coordinate is uniform between its bounds."""
    q = np.empty(len(space.lo))
    for i in range(len(q)):
        q[i] = space.lo[i] + (space.hi[i] - space.lo[i]) * rng.random()
    return q


@generic(1)
def nearest(space: Space, tree: GrowingTree, q: Array) -> int:
    """The index of the tree's node nearest to q; ties go to the first."""
    best, best_distance = 0, np.inf
    for i in range(tree.size[0]):
        d = distance(space, tree.nodes[i], q)
        if d < best_distance:
            best, best_distance = i, d
    return best


@generic(1)
def diameter(space: Space) -> float:
    """The largest distance between two configurations; by default the diagonal of the box."""
    total = 0.0
    for i in range(len(space.lo)):
        total += (space.hi[i] - space.lo[i]) * (space.hi[i] - space.lo[i])
    return math.sqrt(total)
