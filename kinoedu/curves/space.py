"""The space of a car's poses, as far apart as the shortest curve between them is long. LaValle,
Planning Algorithms, section 15.3.

So any planner that asks a space for distances and steps steers a car along curves that it can
drive.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..spaces import diameter, distance, interpolate, near, nearest, sample
from ..spaces.angles import short_way
from .curve import poses_along, seen_from
from .dubins import shortest_forward
from .reeds_shepp import shortest


class CurveSpace(NamedTuple):
    """Poses (x, y, theta) between lo and hi, shapes (3,), theta from -pi to pi, and a turning
    radius.

    both_ways : whether the car drives back as well, along Reeds and Shepp's curves, or only
        forward, along Dubins'; then the distance from a to b is not that from b to a.
    """

    lo: Array
    hi: Array
    radius: float
    both_ways: bool


@compiled
def pieces_between(
    a: Array, b: Array, radius: float, both_ways: bool
) -> tuple[NDArray[np.int64], Array]:
    """The turns and signed lengths of the pieces of the shortest curve from a to b.

    Poses between which several curves are as short are no rarity. Driven both ways a curve is the
    same from either end, for a planner that judges an edge from one may drive it from the other: it
    is chosen from the pose that comes first in order.
    """
    if both_ways and comes_before(b, a):
        x, y, phi = seen_from(b, a, radius)
        turns, lengths = shortest(x, y, phi)
        return turns[::-1].copy(), -radius * lengths[::-1]
    x, y, phi = seen_from(a, b, radius)
    turns, lengths = shortest(x, y, phi) if both_ways else shortest_forward(x, y, phi)
    return turns, radius * lengths


@compiled
def comes_before(a: Array, b: Array) -> bool:
    """Whether a comes before b in the order of their first numbers that differ."""
    for i in range(len(a)):
        if a[i] != b[i]:
            return bool(a[i] < b[i])
    return False


@distance.register(CurveSpace)
def length_between(space: CurveSpace, a: Array, b: Array) -> float:
    """The length of the curve, forward and back."""
    _, lengths = pieces_between(a, b, space.radius, space.both_ways)
    total = 0.0
    for length in lengths:
        total += abs(length)
    return total


@interpolate.register(CurveSpace)
def along_the_curve(space: CurveSpace, a: Array, b: Array, t: float) -> Array:
    """The pose after a fraction t of the curve."""
    turns, lengths = pieces_between(a, b, space.radius, space.both_ways)
    along = np.array([t * np.abs(lengths).sum()])
    return poses_along(a, space.radius, turns, lengths, along)[0].copy()


@sample.register(CurveSpace)
def pose_in_the_box(space: CurveSpace, rng: np.random.Generator) -> Array:
    """Each coordinate uniform between its bounds."""
    q = np.empty(3)
    for i in range(3):
        q[i] = space.lo[i] + (space.hi[i] - space.lo[i]) * rng.random()
    return q


@diameter.register(CurveSpace)
def box_and_turn(space: CurveSpace) -> float:
    """The box's diagonal, and a whole turn."""
    dx, dy = space.hi[0] - space.lo[0], space.hi[1] - space.lo[1]
    return np.sqrt(dx * dx + dy * dy) + 2.0 * np.pi * space.radius


@nearest.register(CurveSpace)
def nearest_by_curve(space: CurveSpace, tree: Any, q: Array) -> int:
    """The node from which q is nearest, the first among equals. Curves are found only where one
    could be shorter than the best.
    """
    best, least = 0, np.inf
    for node in range(tree.size[0]):
        if at_least(space, tree.nodes[node], q) < least:
            length = distance(space, tree.nodes[node], q)
            if length < least:
                best, least = node, length
    return best


@near.register(CurveSpace)
def near_by_curve(space: CurveSpace, tree: Any, q: Array, radius: float) -> NDArray[np.int64]:
    """Those from which q is no farther than a radius, by asking; curves are found only where one
    could be short enough.
    """
    found, size = np.empty(tree.size[0], np.int64), 0
    for node in range(tree.size[0]):
        if (
            at_least(space, tree.nodes[node], q) <= radius
            and distance(space, tree.nodes[node], q) <= radius
        ):
            found[size] = node
            size += 1
    return found[:size].copy()


@inlined
def at_least(space: CurveSpace, a: Array, b: Array) -> float:
    """No curve is shorter than the straight line, nor than the turn that it must make."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    return max(np.sqrt(dx * dx + dy * dy), space.radius * abs(short_way(a[2], b[2])))
