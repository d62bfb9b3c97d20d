"""Spaces with coordinates that are angles: the circle, the torus, SE(2).

The angles of a configuration lie in [-pi, pi). Every distance and every motion takes the shorter
way around. Sources: Bullo & Smith, chapter 3; LaValle, section 5.1.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..errors import InvalidPoint
from ..geometry.checks import Array, as_array, integer, positive
from ..support.constructors import with_type_names
from .angles import FULL_TURN, angle_difference, wrap_angle
from .buckets import GrowingTree
from .interface import diameter, distance, interpolate, nearest, sample, sample_box
from .real import as_bounds
from .rings import (
    coordinate_weight,
    nearest_in_buckets,
    search_near,
    search_rings,
    squared_distance,
    squared_gap,
    squared_radius,
)


@with_type_names
class WrappingSpace(NamedTuple):
    """Coordinates between lo and hi, shapes (d,), of which some wrap.

    Coordinates that wrap are angles from -pi to pi. Each coordinate has a weight: the distance is
    sqrt(sum (weight_i * difference_i)^2). With a weight in metres, a radian is comparable with a
    length.
    """

    lo: Array
    hi: Array
    wraps: NDArray[np.bool_]
    weight: Array


sample.register(WrappingSpace)(sample_box)


def Circle() -> WrappingSpace:
    """The circle: one angle, with the length of the shorter arc in radians as distance.

    Examples
    --------
    >>> distance(Circle(), np.array([3.0]), np.array([-3.0])) == FULL_TURN - 6
    True
    """
    return Torus(1)


def Torus(d: int = 2) -> WrappingSpace:
    """The flat torus of d angles with equal weights, such as the joint angles of an arm.

    Raises
    ------
    InvalidParameter
        Where d is not a positive integer.

    Examples
    --------
    >>> diameter(Torus(1)) == math.pi
    True
    """
    joints = integer(d, "d", least=1)
    half = np.full(joints, math.pi)
    return WrappingSpace(-half, half, np.ones(joints, np.bool_), np.ones(joints))


def SE2(lo: ArrayLike, hi: ArrayLike, *, turn_weight: float) -> WrappingSpace:
    """Positions and headings (x, y, theta) in the plane.

    Parameters
    ----------
    lo, hi : (2,) bounds of the positions.
    turn_weight : the length that one radian counts as. A robot's radius about (x, y) is a good
        choice: then no corner moves farther than sqrt(2) times the distance.

    Raises
    ------
    InvalidPoint
        Where a bound is not finite, or lo is not below hi.
    InvalidParameter
        Where turn_weight is not positive.

    Examples
    --------
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
    """The same configuration with its angles in [-pi, pi); one or many, shape (..., d).

    Raises
    ------
    InvalidPoint
        Where a coordinate is not finite, or their number is not that of the space.

    Examples
    --------
    >>> wrapped_configuration(Torus(), (0.5, 2.0 * math.pi)).tolist()
    [0.5, 0.0]
    """
    inside = np.array(as_array(q, "configuration"))
    if inside.shape[-1:] != space.lo.shape:
        raise InvalidPoint(
            f"a configuration has {len(space.lo)} coordinates here, got shape {inside.shape}"
        )
    for i in np.flatnonzero(space.wraps):
        inside[..., i] = np.vectorize(wrap_angle.py_func, otypes=[np.float64])(inside[..., i])
    return inside


@distance.register(WrappingSpace)
def weighted_distance(space: WrappingSpace, a: Array, b: Array) -> float:
    """The weighted Euclidean distance; angles take the shorter way around."""
    total = 0.0
    for i in range(len(a)):
        apart = space.weight[i] * (angle_difference(a[i], b[i]) if space.wraps[i] else b[i] - a[i])
        total += apart * apart
    return math.sqrt(total)


@diameter.register(WrappingSpace)
def weighted_diameter(space: WrappingSpace) -> float:
    """The distance with the full range of lengths and half a turn of angles."""
    total = 0.0
    for i in range(len(space.lo)):
        apart = space.weight[i] * (math.pi if space.wraps[i] else space.hi[i] - space.lo[i])
        total += apart * apart
    return math.sqrt(total)


@interpolate.register(WrappingSpace)
def interpolate_wrapping(space: WrappingSpace, a: Array, b: Array, t: float) -> Array:
    """Each coordinate is interpolated from a to b; angles take the shorter way around."""
    q = np.empty(len(a))
    for i in range(len(a)):
        if space.wraps[i]:
            q[i] = wrap_angle(a[i] + t * angle_difference(a[i], b[i]))
        else:
            q[i] = a[i] + t * (b[i] - a[i])
    return q


@nearest.register(WrappingSpace)
def nearest_wrapping(space: WrappingSpace, tree: GrowingTree, q: Array) -> int:
    """Found by the tree's grid of buckets, around q and around its images a full turn away."""
    return nearest_in_buckets(space, tree, q)


@squared_distance.register(WrappingSpace)
def squared_weighted_distance(space: WrappingSpace, nodes: Array, node: int, q: Array) -> float:
    """The square of the weighted distance."""
    total = 0.0
    for i in range(len(q)):
        p = nodes[node, i]
        apart = space.weight[i] * (angle_difference(q[i], p) if space.wraps[i] else p - q[i])
        total += apart * apart
    return total


@coordinate_weight.register(WrappingSpace)
def wrapping_weight(space: WrappingSpace, i: int) -> float:
    """The weight of a coordinate; 1 for a coordinate that does not exist."""
    return space.weight[i] if i < len(space.weight) else 1.0


@search_near.register(WrappingSpace)
def search_images(space: WrappingSpace, tree: GrowingTree, q: Array, search: Any) -> Any:
    """Search around q and around its images a full turn away, each in the buckets closest to it.

    So no bucket is visited twice.
    """
    x_wraps, y_wraps = space.wraps[0], len(q) > 1 and space.wraps[1]
    x, y = q[0], q[1] if len(q) > 1 else 0.0
    if x_wraps:
        x = wrap_angle(x)
    if y_wraps:
        y = wrap_angle(y)
    used = tree.used
    for right in (0, 1, -1):
        left, until = closest_to_image(x_wraps, x - tree.x, tree.cell, right, used[0], used[1])
        across = gap_of_image(space, 0, x - tree.x, tree.cell, right, left, until)
        for up in (0, 1, -1):
            low, high = closest_to_image(y_wraps, y - tree.y, tree.cell, up, used[2], used[3])
            along = gap_of_image(space, 1, y - tree.y, tree.cell, up, low, high)
            if left <= until and low <= high and across + along <= squared_radius(search):
                part = (left, until, low, high)
                around_x, around_y = x + right * FULL_TURN, y + up * FULL_TURN
                search = search_rings(space, tree, q, around_x, around_y, part, search)
    return search


@compiled
def closest_to_image(
    wraps: bool, offset: float, cell: float, turns: int, first: int, last: int
) -> tuple[int, int]:
    """Of the columns first to last, the first and last whose centres are closest to an image.

    The images of a coordinate that wraps are -1, 0 and 1 turns away; another coordinate has no
    image but itself. Where there is no such column, the first is after the last.
    """
    if not wraps:
        return (first, last) if turns == 0 else (1, 0)
    back = (offset - math.pi) / cell - 0.5  # half a turn from the coordinate
    ahead = (offset + math.pi) / cell - 0.5
    begin = math.ceil(min(max(back, first), last + 1.0))
    end = math.ceil(min(max(ahead, first), last + 1.0))
    if turns == 0:
        return begin, end - 1
    return (end, last) if turns > 0 else (first, begin - 1)


@compiled
def gap_of_image(
    space: WrappingSpace, i: int, offset: float, cell: float, turns: int, first: int, last: int
) -> float:
    """The squared, weighted distance of coordinate i's image from the columns closest to it."""
    if turns == 0:
        return 0.0
    nearest_column = last if turns > 0 else first
    return squared_gap(
        offset + turns * FULL_TURN, nearest_column, cell, coordinate_weight(space, i)
    )
