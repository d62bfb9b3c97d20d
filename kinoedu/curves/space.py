"""The space of a car's poses, with the length of the shortest curve as its distance.

With this space, every planner that uses a space's distance and interpolation plans curves that a
car can drive. Source: LaValle, Planning Algorithms, section 15.3.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..spaces import diameter, distance, interpolate, near, nearest, sample
from ..spaces.angles import angle_difference
from ..spaces.buckets import GrowingTree
from ..spaces.interface import sample_box
from .curve import poses_along, relative_pose
from .dubins import shortest_forward
from .reeds_shepp import shortest


class CurveSpace(NamedTuple):
    """Poses (x, y, theta) between lo and hi, shapes (3,), with a turning radius.

    The angle theta goes from -pi to pi.

    both_ways : whether the car drives backward too, along Reeds and Shepp's curves. If not,
        it drives along Dubins' curves, and the distance from a to b differs from that from b to a.
    """

    lo: Array
    hi: Array
    radius: float
    both_ways: bool


sample.register(CurveSpace)(sample_box)


@compiled
def pieces_between(
    a: Array, b: Array, radius: float, both_ways: bool
) -> tuple[NDArray[np.int64], Array]:
    """The turns and signed lengths of the pieces of the shortest curve from a to b.

    Several curves of equal length often exist. A car that drives both ways may drive an edge from
    its other end than the one a planner has checked. So the curve is always computed from the pose
    that comes first in lexicographic order, and reversed where necessary.
    """
    if both_ways and comes_before(b, a):
        x, y, phi = relative_pose(b, a, radius)
        turns, lengths = shortest(x, y, phi)
        return turns[::-1].copy(), -radius * lengths[::-1]
    x, y, phi = relative_pose(a, b, radius)
    turns, lengths = shortest(x, y, phi) if both_ways else shortest_forward(x, y, phi)
    return turns, radius * lengths


@compiled
def comes_before(a: Array, b: Array) -> bool:
    """Whether a is smaller than b in lexicographic order."""
    for i in range(len(a)):
        if a[i] != b[i]:
            return bool(a[i] < b[i])
    return False


@distance.register(CurveSpace)
def curve_distance(space: CurveSpace, a: Array, b: Array) -> float:
    """The length of the shortest curve from a to b, forward and backward."""
    _, lengths = pieces_between(a, b, space.radius, space.both_ways)
    total = 0.0
    for length in lengths:
        total += abs(length)
    return total


@interpolate.register(CurveSpace)
def interpolate_curve(space: CurveSpace, a: Array, b: Array, t: float) -> Array:
    """The pose after a fraction t of the curve."""
    turns, lengths = pieces_between(a, b, space.radius, space.both_ways)
    along = np.array([t * np.abs(lengths).sum()])
    return poses_along(a, space.radius, turns, lengths, along)[0].copy()


@diameter.register(CurveSpace)
def curve_space_diameter(space: CurveSpace) -> float:
    """The diagonal of the box plus the length of a full circle: about the largest distance."""
    dx, dy = space.hi[0] - space.lo[0], space.hi[1] - space.lo[1]
    return np.sqrt(dx * dx + dy * dy) + 2.0 * np.pi * space.radius


@nearest.register(CurveSpace)
def nearest_along_curves(space: CurveSpace, tree: GrowingTree, q: Array) -> int:
    """The node with the shortest curve to q; ties go to the first.

    A curve is computed only where its lower bound is less than the best length so far.
    """
    best, least = 0, np.inf
    for node in range(tree.size[0]):
        if length_lower_bound(space, tree.nodes[node], q) < least:
            length = distance(space, tree.nodes[node], q)
            if length < least:
                best, least = node, length
    return best


@near.register(CurveSpace)
def near_along_curves(
    space: CurveSpace, tree: GrowingTree, q: Array, radius: float
) -> NDArray[np.int64]:
    """The nodes with a curve to q of at most a radius.

    A curve is computed only where its lower bound is small enough.
    """
    found, size = np.empty(tree.size[0], np.int64), 0
    for node in range(tree.size[0]):
        pose = tree.nodes[node]
        if length_lower_bound(space, pose, q) <= radius and distance(space, pose, q) <= radius:
            found[size] = node
            size += 1
    return found[:size].copy()


@inlined
def length_lower_bound(space: CurveSpace, a: Array, b: Array) -> float:
    """A lower bound of a curve's length: the straight distance and the turn that it must make."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    return max(np.sqrt(dx * dx + dy * dy), space.radius * abs(angle_difference(a[2], b[2])))
