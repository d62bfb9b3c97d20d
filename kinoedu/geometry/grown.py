"""Polygons that contain a convex piece grown by a radius: never smaller than the exact shape."""

import math

import numpy as np

from .checks import Array
from .convex import convex_hull

SIDES = 32  # sides of the polygon around a disc; its corners are half a percent outside the disc


def disc_polygon(radius: float) -> Array:
    """A regular polygon around the disc of a radius at the origin; for radius 0 the origin. (k, 2).

    Examples
    --------
    >>> disc_polygon(0.0)
    array([[0., 0.]])
    >>> corners = disc_polygon(1.0)
    >>> midpoints = (corners + np.roll(corners, 1, axis=0)) / 2
    >>> bool(np.hypot(*midpoints.T).min() >= 1.0)
    True
    """
    if radius == 0.0:
        return np.zeros((1, 2))
    angles = (np.arange(SIDES) + 0.5) * (2.0 * math.pi / SIDES)
    reach = radius / math.cos(math.pi / SIDES) * (1.0 + 1e-12)
    return reach * np.column_stack([np.cos(angles), np.sin(angles)])


def hull_of_sums(P: Array, Q: Array) -> Array:
    """The convex hull, counter-clockwise, of all sums of a point of P, (n, 2), and Q, (k, 2)."""
    return convex_hull((P[:, None] + Q[None]).reshape(-1, 2))


def grow_piece(piece: Array, radius: float) -> Array:
    """A convex polygon slightly larger than the hull of points (n, 2) grown by a radius."""
    return hull_of_sums(piece, disc_polygon(radius))
