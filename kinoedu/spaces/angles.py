"""Angles, in radians: wrapped to [-pi, pi), and the short way between two. Bullo & Smith, chapter
3; LaValle, section 5.1.

A full turn is the float 2 * math.pi, here and everywhere, so that pi and -pi are the same direction
to the last bit.
"""

import math

import numpy as np
from numpy.typing import ArrayLike

from ..compiled import compiled
from ..errors import InvalidPoint
from ..geometry.checks import Array, as_array
from ..geometry.exact import two_sum

FULL_TURN = 2.0 * math.pi


@compiled
def wrapped(angle: float) -> float:
    """The same direction in [-pi, pi); an angle that is there already is left as it is."""
    if -math.pi <= angle < math.pi:
        return angle
    inside = angle - FULL_TURN * math.floor((angle + math.pi) / FULL_TURN)
    return inside if -math.pi <= inside < math.pi else -math.pi


@compiled
def short_way(a: float, b: float) -> float:
    """The turn from direction a to direction b, in [-pi, pi): half a turn goes clockwise. Rounded
    once for wrapped angles.
    """
    turn, lost = two_sum(b, -a)
    if -math.pi <= turn < math.pi:
        return turn
    return wrapped(wrapped(turn) + lost)


def circle_distance(a: ArrayLike, b: ArrayLike) -> float | Array:
    """The length of the shorter arc of the unit circle from direction a to direction b, from 0 to
    pi.

    a, b : finite angles in radians, wrapped or not; one, or shape (n,). One angle is compared with
        each of many. Returns a number or shape (n,). Correctly rounded, for nearly equal and nearly
        opposite directions too. Bullo & Smith, chapter 3. Raises
    InvalidPoint.

    >>> circle_distance(3, -3) == 2 * math.pi - 6, circle_distance(0.5, [0.5, 1.0]).tolist()
    (True, [0.0, 0.5])
    """
    x, y = as_array(a, "a"), as_array(b, "b")
    if max(x.ndim, y.ndim) > 1 or (x.ndim == y.ndim and x.shape != y.shape):
        raise InvalidPoint(
            f"a and b must be one angle or shape (n,), n the same for both, got shapes {x.shape} "
            f"and {y.shape}"
        )
    apart = arcs(x, y)
    return apart if apart.ndim else float(apart)


def torus_distance(a: ArrayLike, b: ArrayLike) -> float | Array:
    """The distance on the flat torus: the root of the sum of squared circle distances, an angle at
    a time.

    a, b : d finite angles in radians, or many such rows, shape (n, d). One row is compared with
        each of many. Returns a number or shape (n,). Raises InvalidPoint.

    >>> torus_distance((3, 0), (3, 1)), torus_distance((math.pi, 0.25), (-math.pi, 0.25))
    (1.0, 0.0)
    """
    x, y = as_array(a, "a"), as_array(b, "b")
    fits = all(1 <= p.ndim <= 2 and p.shape[-1] > 0 for p in (x, y)) and x.shape[-1] == y.shape[-1]
    if not fits or (x.ndim == y.ndim and x.shape != y.shape):
        raise InvalidPoint(
            f"a and b must have shape (d,) or (n, d), d and n the same for both, got {x.shape} "
            f"and {y.shape}"
        )
    apart = np.hypot.reduce(arcs(x, y), axis=-1)
    return apart if apart.ndim else float(apart)


def arcs(a: Array, b: Array) -> Array:
    """Circle distances, element by element. Remainders are exact, and so is what a difference of
    two loses.
    """
    x, y = nearest_turn(a), nearest_turn(b)
    apart, lost = two_sum.py_func(np.maximum(x, y), -np.minimum(x, y))
    return np.where(apart > math.pi, np.abs((FULL_TURN - apart) - lost), apart)


def nearest_turn(angles: Array) -> Array:
    """The same directions in [-pi, pi], exactly."""
    inside = np.fmod(angles, FULL_TURN)
    return inside - FULL_TURN * (inside > math.pi) + FULL_TURN * (inside < -math.pi)
