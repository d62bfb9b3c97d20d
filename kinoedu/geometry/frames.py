"""A frame for shapely: coordinates near 1, on a grid as fine as the size of the figure allows.

With coordinates near 1 its products neither overflow nor vanish. Far from the origin a figure is
moved back first, so that the grid is a fraction of its size and not of its distance.
"""

from typing import NamedTuple

import numpy as np

from .checks import Array

DIGITS = 53  # of a float


class Frame(NamedTuple):
    """A point p is at (p - origin) / 2^power in it; its grid is in the frame's unit."""

    origin: Array
    power: int
    grid: float


def frame_of(points: Array, grid: float) -> Frame:
    """The frame of points (n, 2), with this grid, or that of their coordinates if it is coarser.

    A point of the grid is a float in the plane too.
    """
    lo, hi = points.min(axis=0), points.max(axis=0)
    size = exponent_of(np.ldexp(hi, -1) - np.ldexp(lo, -1)) + 1  # halves do not overflow
    origin = np.ldexp(np.trunc(np.ldexp(lo, -size)), size)
    power = exponent_of(points - origin)
    finest = exponent_of(points) - DIGITS - power
    return Frame(origin, power, max(grid, float(np.ldexp(1.0, finest))))


def exponent_of(values: Array) -> int:
    """The exponent of a power of two above all absolute values."""
    return int(np.frexp(np.abs(values).max())[1])


def into_frame(frame: Frame, points: Array) -> Array:
    """Points (..., 2) in a frame."""
    return np.ldexp(points - frame.origin, -frame.power)


def out_of_frame(frame: Frame, points: Array) -> Array:
    """Points (..., 2) of a frame in the plane."""
    return np.ldexp(points, frame.power) + frame.origin
