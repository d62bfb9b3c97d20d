"""Samples of the places through which a short motion may pass: an ellipse, in d dimensions.

The q with |a - q| + |q - b| < length form an ellipsoid with the foci a and b (a prolate
hyperspheroid). A uniform sample of the unit ball is stretched along the first axis, reflected onto
the line of the foci, and moved to the centre.

J. D. Gammell, S. S. Srinivasa, T. D. Barfoot, "Informed RRT*: optimal sampling-based path planning
focused via direct sampling of an admissible ellipsoidal heuristic" (2014).
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ..compiled import generic, inlined
from ..geometry.checks import Array
from .angles import FULL_TURN, angle_difference, wrap_angle
from .interface import Space, distance, interpolate, sample
from .real import RealSpace
from .rings import coordinate_weight
from .wrapping import WrappingSpace

TRIES = 1000  # draws until one fits; then the middle between a and b


class Ellipsoid(NamedTuple):
    """The q with |a - q| + |q - b| < length, where coordinates are multiplied by their weights.

    centre : (d,), a configuration. axis : (d,), the direction from a to b, of length 1.
    long, short : half the length along the axis, and across it.
    half : (d,), half the extent in each coordinate, not multiplied by its weight.
    holds_all : whether every such q is in it; not where the longer way around an angle may be short
        enough too.
    """

    centre: Array
    axis: Array
    long: float
    short: float
    half: Array
    holds_all: bool


@generic(1)
def wraps(space: Space, i: int) -> bool:
    """Whether coordinate i is an angle."""
    return False


@wraps.register(WrappingSpace)
def wraps_around(space: WrappingSpace, i: int) -> bool:
    """As the space says."""
    return bool(space.wraps[i])


@generic(1)
def sample_between(
    space: Space, a: Array, b: Array, length: float, rng: np.random.Generator
) -> Array:
    """A uniform sample of the q in the space with distance(a, q) + distance(q, b) < length.

    length must exceed distance(a, b). For an unknown distance samples of the space are rejected
    until one fits; after `TRIES` the middle between a and b is returned.
    """
    for _ in range(TRIES):
        q = sample(space, rng)
        if distance(space, a, q) + distance(space, q, b) < length:
            return q
    return interpolate(space, a, b, 0.5)


@sample_between.register(RealSpace)
@sample_between.register(WrappingSpace)
def sample_ellipsoid(
    space: Space, a: Array, b: Array, length: float, rng: np.random.Generator
) -> Array:
    """Draw from the ellipsoid or, where it is smaller, from the box around it in the space.

    A draw that does not lie in the other one too is rejected. Few draws are made in any case: even
    where a and b lie in a corner of a large space, about 2^-d of the ellipsoid is in the space.
    """
    ellipsoid = ellipsoid_between(space, a, b, length)
    lo, hi = box_around(space, ellipsoid)
    is_smaller = ellipsoid.holds_all and is_less_than_box(space, ellipsoid, lo, hi)
    for _ in range(TRIES):
        q = draw_in_ellipsoid(space, ellipsoid, rng) if is_smaller else draw_in_box(lo, hi, rng)
        inside = distance(space, a, q) + distance(space, q, b) < length
        for i in range(len(q)):
            inside = inside and space.lo[i] <= q[i] <= space.hi[i]
        if inside:
            return q
    return interpolate(space, a, b, 0.5)


@inlined
def ellipsoid_between(space: Space, a: Array, b: Array, length: float) -> Ellipsoid:
    """The ellipsoid with the foci a and b; angles take the shorter way around."""
    d, apart = len(a), distance(space, a, b)
    axis, half, holds_all = np.zeros(d), np.empty(d), True
    across = (length - apart) * (length + apart)
    for i in range(d):
        weight = coordinate_weight(space, i)
        gap = weight * (angle_difference(a[i], b[i]) if wraps(space, i) else b[i] - a[i])
        if apart > 0.0:
            axis[i] = gap / apart
        half[i] = 0.5 * math.sqrt(across + gap * gap) / weight
        around = weight * FULL_TURN - abs(gap)  # the other way around
        if wraps(space, i) and across + gap * gap >= around * around:
            holds_all = False
    if apart == 0.0:
        axis[0] = 1.0
    centre = interpolate(space, a, b, 0.5)
    return Ellipsoid(centre, axis, 0.5 * length, 0.5 * math.sqrt(across), half, holds_all)


@inlined
def box_around(space: Space, ellipsoid: Ellipsoid) -> tuple[Array, Array]:
    """The box around an ellipsoid in the space; angles may take all values."""
    lo, hi = space.lo.copy(), space.hi.copy()
    for i in range(len(lo)):
        if not wraps(space, i):
            lo[i] = max(lo[i], ellipsoid.centre[i] - ellipsoid.half[i])
            hi[i] = min(hi[i], ellipsoid.centre[i] + ellipsoid.half[i])
    return lo, hi


@inlined
def is_less_than_box(space: Space, ellipsoid: Ellipsoid, lo: Array, hi: Array) -> bool:
    """Whether the volume of an ellipsoid is smaller than that of a box."""
    d, box = len(lo), 1.0
    volume = 2.0 if d % 2 == 1 else 1.0  # of the unit ball in 1 dimension, or in 0
    for k in range(2 + d % 2, d + 1, 2):
        volume *= FULL_TURN / k  # of the unit ball in k dimensions
    for i in range(d):
        volume *= ellipsoid.long if i == 0 else ellipsoid.short
        box *= coordinate_weight(space, i) * (hi[i] - lo[i])
    return volume < box


@inlined
def draw_in_box(lo: Array, hi: Array, rng: np.random.Generator) -> Array:
    """A uniform sample of a box."""
    q = np.empty(len(lo))
    for i in range(len(q)):
        q[i] = lo[i] + (hi[i] - lo[i]) * rng.random()
    return q


@inlined
def draw_in_ellipsoid(space: Space, ellipsoid: Ellipsoid, rng: np.random.Generator) -> Array:
    """A uniform sample of an ellipsoid; it may lie outside the space."""
    axis, d = ellipsoid.axis, len(ellipsoid.axis)
    q = draw_in_ball(d, rng)
    size, along = 0.0, 0.0
    for i in range(d):
        q[i] *= ellipsoid.long if i == 0 else ellipsoid.short
        # the mirror that takes the first axis e to `axis` is normal to m = e - axis
        m = (1.0 if i == 0 else 0.0) - axis[i]
        size += m * m
        along += m * q[i]
    if size > 0.0:
        for i in range(d):
            q[i] -= 2.0 * along / size * ((1.0 if i == 0 else 0.0) - axis[i])
    for i in range(d):
        q[i] = ellipsoid.centre[i] + q[i] / coordinate_weight(space, i)
        if wraps(space, i):
            q[i] = wrap_angle(q[i])
    return q


@inlined
def draw_in_ball(d: int, rng: np.random.Generator) -> Array:
    """A uniform sample of the unit ball in d dimensions: a random direction, and a distance."""
    q, squared = np.empty(d), 0.0
    for i in range(d):
        q[i] = rng.standard_normal()
        squared += q[i] * q[i]
    return q * (rng.random() ** (1.0 / d) / math.sqrt(squared))
