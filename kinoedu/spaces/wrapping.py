"""Spaces of which some coordinates are angles: the circle, the torus, SE(2). Bullo & Smith, chapter
3; LaValle, section 5.1.

A configuration's angles lie in [-pi, pi); every distance and every motion takes the short way
round.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.checks import Array, as_array, positive, whole
from .angles import FULL_TURN, short_way, wrapped
from .asks import diameter, distance, interpolate, nearest, sample
from .buckets import GrowingTree
from .real import as_bounds
from .rings import (
    nearest_in_buckets,
    search_near,
    search_rings,
    squared_distance,
    squared_gap,
    squared_reach,
    weight_of,
)


class WrappingSpace(NamedTuple):
    """Coordinates between lo and hi, shapes (d,); those that wrap are angles, from -pi to pi.

    Each coordinate counts with its weight: the distance is sqrt(sum (weight_i * difference_i)^2),
    so that with a weight in metres a radian is comparable with a length.
    """

    lo: Array
    hi: Array
    wraps: NDArray[np.bool_]
    weight: Array


def Circle() -> WrappingSpace:
    """The circle: one angle. The distance is the shorter arc's, in radians.

    >>> distance(Circle(), np.array([3.0]), np.array([-3.0])) == FULL_TURN - 6
    True
    """
    return Torus(1)


def Torus(d: int = 2) -> WrappingSpace:
    """The flat torus: d angles, such as those of an arm's joints, a radian of each counting the
    same. Raises InvalidParameter.

    >>> diameter(Torus(1)) == math.pi
    True
    """
    joints = whole(d, "d", least=1)
    half = np.full(joints, math.pi)
    return WrappingSpace(-half, half, np.ones(joints, np.bool_), np.ones(joints))


def SE2(lo: ArrayLike, hi: ArrayLike, *, turn_weight: float) -> WrappingSpace:
    """The plane's places and headings (x, y, theta), positions between lo and hi, shapes (2,).

    turn_weight : how many units of length a radian counts for; a robot's radius about (x, y) is a
        good choice, for then its corners move by at most the distance and about as far. Raises
        InvalidPoint, InvalidParameter.

    >>> space = SE2((0, 0), (10, 10), turn_weight=2)
    >>> distance(space, np.array([1.0, 1, 3]), np.array([1.0, 1, -3])) == 2 * (FULL_TURN - 6)
    True
    """
    low, high = as_bounds(lo, hi, 2)
    weight = np.array([1.0, 1.0, positive(turn_weight, "turn_weight")])
    return WrappingSpace(
        np.append(low, -math.pi), np.append(high, math.pi), np.array([False, False, True]), weight
    )


def wrapped_configuration(space: WrappingSpace, q: ArrayLike) -> Array:
    """The same configuration, its angles in [-pi, pi); one or many, shape (..., d).

    >>> wrapped_configuration(Torus(), (0.5, 2.0 * math.pi)).tolist()
    [0.5, 0.0]
    """
    inside = np.array(as_array(q, "configuration"))
    for i in np.flatnonzero(space.wraps):
        inside[..., i] = np.vectorize(wrapped.py_func, otypes=[np.float64])(inside[..., i])
    return inside


@distance.register(WrappingSpace)
def weighted_distance(space: WrappingSpace, a: Array, b: Array) -> float:
    """The weighted Euclidean distance, the short way round."""
    total = 0.0
    for i in range(len(a)):
        apart = space.weight[i] * (short_way(a[i], b[i]) if space.wraps[i] else b[i] - a[i])
        total += apart * apart
    return math.sqrt(total)


@diameter.register(WrappingSpace)
def weighted_diameter(space: WrappingSpace) -> float:
    """All the way along what does not wrap, half a turn of what does."""
    total = 0.0
    for i in range(len(space.lo)):
        apart = space.weight[i] * (math.pi if space.wraps[i] else space.hi[i] - space.lo[i])
        total += apart * apart
    return math.sqrt(total)


@interpolate.register(WrappingSpace)
def the_short_way(space: WrappingSpace, a: Array, b: Array, t: float) -> Array:
    """Each coordinate on its own way from a to b, angles the short way."""
    q = np.empty(len(a))
    for i in range(len(a)):
        q[i] = (
            wrapped(a[i] + t * short_way(a[i], b[i]))
            if space.wraps[i]
            else a[i] + t * (b[i] - a[i])
        )
    return q


@sample.register(WrappingSpace)
def all_round(space: WrappingSpace, rng: np.random.Generator) -> Array:
    """Each coordinate uniform between its bounds."""
    q = np.empty(len(space.lo))
    for i in range(len(q)):
        q[i] = space.lo[i] + (space.hi[i] - space.lo[i]) * rng.random()
    return q


@nearest.register(WrappingSpace)
def nearest_the_short_way(space: WrappingSpace, tree: Any, q: Array) -> int:
    """By the tree's grid of buckets, round q and round its images a turn away."""
    return nearest_in_buckets(space, tree, q)


@squared_distance.register(WrappingSpace)
def squared_the_short_way(space: WrappingSpace, nodes: Array, node: int, q: Array) -> float:
    """The square of the weighted distance."""
    total = 0.0
    for i in range(len(q)):
        apart = space.weight[i] * (
            short_way(q[i], nodes[node, i]) if space.wraps[i] else nodes[node, i] - q[i]
        )
        total += apart * apart
    return total


@weight_of.register(WrappingSpace)
def its_weight(space: WrappingSpace, i: int) -> float:
    """A coordinate's weight; that of a missing one is 1."""
    return space.weight[i] if i < len(space.weight) else 1.0


@search_near.register(WrappingSpace)
def search_images(space: WrappingSpace, tree: GrowingTree, q: Array, search: Any) -> Any:
    """Round q, then round each image of q a turn away that is near enough to the buckets."""
    wx, wy = weight_of(space, 0), weight_of(space, 1)
    x = wrapped(q[0]) if space.wraps[0] else q[0]
    y = 0.0 if len(q) < 2 else wrapped(q[1]) if space.wraps[1] else q[1]
    for right in (0.0, FULL_TURN, -FULL_TURN):
        for up in (0.0, FULL_TURN, -FULL_TURN):
            if (right != 0.0 and not space.wraps[0]) or (
                up != 0.0 and not (len(q) > 1 and space.wraps[1])
            ):
                continue
            across = (
                squared_gap(x + right - tree.x, 0, tree.cell * tree.columns, wx)
                if right != 0.0
                else 0.0
            )
            along = squared_gap(y + up - tree.y, 0, tree.cell * tree.rows, wy) if up != 0.0 else 0.0
            if across + along <= squared_reach(search):
                search = search_rings(space, tree, q, x + right, y + up, search)
    return search
