"""Convex pieces grown by a radius, as polygons on the safe side: never smaller than the truth."""

import math

import numpy as np

from .checks import Array
from .convex import convex_hull

SIDES = 32  # of the polygon that stands for a disc: it reaches half a percent beyond it


def round_disc(radius: float) -> Array:
    """A regular polygon that holds the disc of a radius round the origin, and touches it; the
    origin alone for 0. Shape (k, 2).

    >>> round_disc(0.0)
    array([[0., 0.]])
    >>> bool(np.hypot(*(round_disc(1.0) + np.roll(round_disc(1.0), 1, axis=0)).T).min() / 2 >= 1.0)
    True
    """
    if radius == 0.0:
        return np.zeros((1, 2))
    angles = (np.arange(SIDES) + 0.5) * (2.0 * math.pi / SIDES)
    reach = radius / math.cos(math.pi / SIDES) * (1.0 + 1e-12)
    return reach * np.column_stack([np.cos(angles), np.sin(angles)])


def summed(P: Array, Q: Array) -> Array:
    """The convex hull of all sums of a point of P, shape (n, 2), and one of Q, (k, 2):
    counter-clockwise.
    """
    return convex_hull((P[:, None] + Q[None]).reshape(-1, 2))


def grown(piece: Array, radius: float) -> Array:
    """A convex polygon that holds all that is within a radius of the convex hull of points (n, 2),
    and little more.
    """
    return summed(piece, round_disc(radius))
