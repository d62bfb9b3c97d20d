"""Lines, and on which side of a line a point lies.

Source: Bullo & Smith, Lectures on Robotic Planning and Kinematics, chapter 1.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidSegment
from .checks import Array, as_point
from .exact import height, orientation_sign, over_length, sum_of_products, unit_vector


def orientation(a: ArrayLike, b: ArrayLike, c: ArrayLike) -> int:
    """Whether three points turn left, turn right or lie on one line.

    Parameters
    ----------
    a, b, c : (2,) points.

    Returns
    -------
    int
        1 for a left turn, -1 for a right turn, 0 on one line. Exact for every finite input.

    Raises
    ------
    InvalidPoint
        Where a point is not two finite numbers.

    Examples
    --------
    >>> orientation((0, 0), (1, 0), (1, 1)), orientation((0, 0), (0.1, 0.3), (0.2, 0.6))
    (1, 0)
    """
    a, b, c = as_point(a, "a"), as_point(b, "b"), as_point(c, "c")
    return int(orientation_sign(a[0], a[1], b[0], b[1], c[0], c[1]))


def line_through_points(p1: ArrayLike, p2: ArrayLike) -> tuple[float, float, float]:
    """The line {(x, y): a x + b y + c = 0} through two distinct points.

    Parameters
    ----------
    p1, p2 : (2,) points.

    Returns
    -------
    a, b, c
        With a^2 + b^2 = 1. The vector (a, b) points to the left of the direction from p1 to p2, so
        a x + b y + c is the signed distance of (x, y), positive on the left.

    Raises
    ------
    InvalidSegment
        Where the points coincide.
    InvalidPoint
        Where a point is not two finite numbers.

    Examples
    --------
    >>> line_through_points((0, 1), (5, 1))
    (0.0, 1.0, -1.0)
    """
    p1, p2 = two_points(p1, p2)
    dx, dy = p2 - p1
    ux, uy = unit_vector(dx, dy)
    m, e = sum_of_products(np.array([p1[0], -p2[0]]), np.array([p2[1], p1[1]]))
    return float(-uy) + 0.0, float(ux) + 0.0, float(over_length(m, e, dx, dy)) + 0.0


def point_line_distance(q: ArrayLike, p1: ArrayLike, p2: ArrayLike) -> float:
    """Distance from a point to the line through two points.

    Parameters
    ----------
    q, p1, p2 : (2,) points; p1 and p2 are distinct.

    Raises
    ------
    InvalidSegment
        Where p1 and p2 coincide.
    InvalidPoint
        Where a point is not two finite numbers.

    Examples
    --------
    >>> point_line_distance((3, 4), (0, 0), (1, 0))
    4.0
    """
    q, (p1, p2) = as_point(q, "q"), two_points(p1, p2)
    return float(abs(height(p1[0], p1[1], p2[0], p2[1], q[0], q[1])))


def two_points(p1: ArrayLike, p2: ArrayLike) -> tuple[Array, Array]:
    """Two distinct points; raises InvalidSegment where they coincide."""
    p1, p2 = as_point(p1, "p1"), as_point(p2, "p2")
    if (p1 == p2).all():
        raise InvalidSegment(f"two distinct points make a line, got {tuple(p1.tolist())} twice")
    return p1, p2
