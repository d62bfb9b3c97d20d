"""R^n: configurations that are points of a box. Source: LaValle, section 5.1."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidPoint
from ..geometry.checks import Array, as_array
from ..support.constructors import with_type_names
from .buckets import GrowingTree
from .euclidean import nearest_euclidean_node, squared_difference
from .interface import distance, interpolate, nearest, sample, sample_box
from .rings import squared_distance


@with_type_names
class RealSpace(NamedTuple):
    """The box from lo to hi, shapes (d,), with the Euclidean distance."""

    lo: Array
    hi: Array


sample.register(RealSpace)(sample_box)


def Box(lo: ArrayLike, hi: ArrayLike) -> RealSpace:
    """R^n between two opposite corners, with the Euclidean distance.

    Parameters
    ----------
    lo, hi : (n,) lower and upper bounds, n >= 1.

    Raises
    ------
    InvalidPoint
        Where a bound is not finite, the shapes differ, or lo is not below hi.

    Examples
    --------
    >>> distance(Box((0, 0), (4, 4)), np.array([0.0, 0.0]), np.array([3.0, 4.0]))
    5.0
    """
    return RealSpace(*as_bounds(lo, hi, None))


def as_bounds(lo: ArrayLike, hi: ArrayLike, d: int | None) -> tuple[Array, Array]:
    """Check the corners of a box, (d,) each; None for any dimension. Raises InvalidPoint."""
    low, high = as_array(lo, "lo"), as_array(hi, "hi")
    is_size_right = low.ndim == 1 and (len(low) > 0 if d is None else len(low) == d)
    if not is_size_right or low.shape != high.shape:
        shape = "(n,) with the same n >= 1" if d is None else f"({d},)"
        raise InvalidPoint(f"lo and hi must have shape {shape}, got {low.shape} and {high.shape}")
    if not (low < high).all():
        raise InvalidPoint(
            f"lo must be below hi in every coordinate, got {low.tolist()} and {high.tolist()}"
        )
    return low, high


@distance.register(RealSpace)
def euclidean_distance(space: RealSpace, a: Array, b: Array) -> float:
    """|b - a|."""
    total = 0.0
    for i in range(len(a)):
        gap = b[i] - a[i]
        total += gap * gap
    return math.sqrt(total)


@interpolate.register(RealSpace)
def interpolate_line(space: RealSpace, a: Array, b: Array, t: float) -> Array:
    """a + t (b - a)."""
    q = np.empty(len(a))
    for i in range(len(a)):
        q[i] = a[i] + t * (b[i] - a[i])
    return q


@nearest.register(RealSpace)
def nearest_euclidean(space: RealSpace, tree: GrowingTree, q: Array) -> int:
    """Found by the tree's grid of buckets."""
    return nearest_euclidean_node(tree, q)


@squared_distance.register(RealSpace)
def squared_euclidean(space: RealSpace, nodes: Array, node: int, q: Array) -> float:
    """|nodes[node] - q|^2."""
    return squared_difference(nodes, node, q)
