"""Angles in radians: wrapping to [-pi, pi), and differences and distances of directions.

A full turn is the float 2 * math.pi everywhere, so pi and -pi are exactly the same direction.
Sources: Bullo & Smith, chapter 3; LaValle, section 5.1.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from ..compiled import compiled
from ..errors import InvalidPoint
from ..geometry.checks import Array, as_array
from ..geometry.exact import two_sum

FULL_TURN = 2.0 * math.pi


@compiled
def wrap_angle(angle: float) -> float:
    """The same direction in [-pi, pi); an angle in this interval is returned unchanged."""
    if -math.pi <= angle < math.pi:
        return angle
    # not math.floor: in compiled code its integers end at 2^63
    inside = float(angle - FULL_TURN * np.floor((angle + math.pi) / FULL_TURN))
    return inside if -math.pi <= inside < math.pi else -math.pi


@compiled
def angle_difference(a: float, b: float) -> float:
    """The signed difference b - a of two directions, in [-pi, pi); half a turn is -pi.

    It is rounded once if both angles are wrapped.
    """
    difference, error = two_sum(b, -a)
    if -math.pi <= difference < math.pi:
        return difference
    return wrap_angle(wrap_angle(difference) + error)


def circle_distance(a: ArrayLike, b: ArrayLike) -> float | Array:
    """The length of the shorter arc of the unit circle between two directions, from 0 to pi.

    It is correctly rounded, for nearly equal and nearly opposite directions too. Source: Bullo &
    Smith, chapter 3.

    Parameters
    ----------
    a, b : finite angles in radians, wrapped or not, each one angle or shape (n,). One angle is
        compared with each of many.

    Returns
    -------
    float, or (n,) array for many angles.

    Raises
    ------
    InvalidPoint
        Where an angle is not finite, or the shapes do not match.

    Examples
    --------
    >>> circle_distance(3, -3) == 2 * math.pi - 6, circle_distance(0.5, [0.5, 1.0]).tolist()
    (True, [0.0, 0.5])
    """
    x, y = as_array(a, "a"), as_array(b, "b")
    if max(x.ndim, y.ndim) > 1 or (x.ndim == y.ndim and x.shape != y.shape):
        raise InvalidPoint(
            f"a and b must be one angle or shape (n,), n the same for both, got shapes {x.shape} "
            f"and {y.shape}"
        )
    distances = circle_distances(x, y)
    return distances if distances.ndim else float(distances)


def torus_distance(a: ArrayLike, b: ArrayLike) -> float | Array:
    """The distance on the flat torus: the Euclidean norm of the circle distances of all angles.

    Parameters
    ----------
    a, b : (d,) finite angles in radians, or (n, d) rows of them. One row is compared with each of
        many.

    Returns
    -------
    float, or (n,) array for many rows.

    Raises
    ------
    InvalidPoint
        Where an angle is not finite, or the shapes do not match.

    Examples
    --------
    >>> torus_distance((3, 0), (3, 1)), torus_distance((math.pi, 0.25), (-math.pi, 0.25))
    (1.0, 0.0)
    """
    x, y = as_array(a, "a"), as_array(b, "b")
    is_valid = (
        all(1 <= p.ndim <= 2 and p.shape[-1] > 0 for p in (x, y)) and x.shape[-1] == y.shape[-1]
    )
    if not is_valid or (x.ndim == y.ndim and x.shape != y.shape):
        raise InvalidPoint(
            f"a and b must have shape (d,) or (n, d), d and n the same for both, got {x.shape} "
            f"and {y.shape}"
        )
    distances = np.hypot.reduce(circle_distances(x, y), axis=-1)
    return distances if distances.ndim else float(distances)


def circle_distances(a: Array, b: Array) -> Array:
    """Circle distances of arrays, element by element.

    Remainders are exact, and so is the rounding error of a difference of two.
    """
    x, y = wrap_angles_exactly(a), wrap_angles_exactly(b)
    apart, error = two_sum.py_func(np.maximum(x, y), -np.minimum(x, y))
    return np.where(apart > math.pi, np.abs((FULL_TURN - apart) - error), apart)


def wrap_angles_exactly(angles: Array) -> Array:
    """The same directions in [-pi, pi], exactly."""
    inside = np.fmod(angles, FULL_TURN)
    return inside - FULL_TURN * (inside > math.pi) + FULL_TURN * (inside < -math.pi)
