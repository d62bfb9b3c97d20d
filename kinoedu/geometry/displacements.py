"""Rigid motions of the plane as matrices: rotations (2, 2) and displacements (3, 3).

A displacement rotates and then translates. Displacements are composed with `@`: A @ B applies B
first. If B is a frame given in frame A, then A @ B is that frame in the world.

Sources: Bullo & Smith, chapters 3 and 6; LaValle, section 3.2.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidPoint
from .checks import Array, as_array, as_number, as_points


def rotation(theta: float) -> Array:
    """The rotation by theta radians about the origin, counter-clockwise, shape (2, 2).

    The rotation by 0 is exactly the identity.

    Raises
    ------
    InvalidPoint
        Where theta is not one finite number.

    Examples
    --------
    >>> rotation(math.pi / 2).round(12) + 0.0
    array([[ 0., -1.],
           [ 1.,  0.]])
    """
    angle = as_number(theta, "theta")
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]]) + 0.0


def displacement(x: float, y: float, theta: float) -> Array:
    """The displacement that rotates by theta about the origin and then translates by (x, y).

    It maps points given in the robot's frame to the world, for the configuration (x, y, theta).

    Returns
    -------
    (3, 3) array

    Raises
    ------
    InvalidPoint
        Where an argument is not one finite number.

    Examples
    --------
    >>> displacement(3, 4, 0).tolist()
    [[1.0, 0.0, 3.0], [0.0, 1.0, 4.0], [0.0, 0.0, 1.0]]
    """
    matrix = np.eye(3)
    matrix[:2, :2] = rotation(theta)
    matrix[:2, 2] = as_number(x, "x"), as_number(y, "y")
    return matrix


def displaced(points: ArrayLike, by: ArrayLike) -> Array:
    """The images of a point (2,) or of points (n, 2) under a displacement.

    Parameters
    ----------
    points : (2,) point or (n, 2) points.
    by : (3, 3) displacement.

    Raises
    ------
    InvalidPoint
        Where a coordinate is not finite, or `by` is not a displacement.

    Examples
    --------
    >>> displaced([(1, 0), (0, 0)], displacement(5, 5, math.pi))
    array([[4., 5.],
           [5., 5.]])
    """
    matrix = as_displacement(by)
    moved = as_points(points) @ matrix[:2, :2].T + matrix[:2, 2]
    return moved[0] if np.ndim(points) == 1 else moved


def inverse(of: ArrayLike) -> Array:
    """The inverse of a displacement, shape (3, 3).

    Its rotation is transposed, and its translation is the negative one seen in the rotated frame.

    Raises
    ------
    InvalidPoint
        Where `of` is not a displacement.

    Examples
    --------
    >>> A = displacement(1, 2, 3)
    >>> (inverse(A) @ A).round(12).tolist() == np.eye(3).tolist()
    True
    """
    matrix = as_displacement(of)
    back = np.eye(3)
    back[:2, :2] = matrix[:2, :2].T
    back[:2, 2] = 0.0 - matrix[:2, :2].T @ matrix[:2, 2]
    return back


def configuration(of: ArrayLike) -> Array:
    """The configuration (x, y, theta) of a displacement, theta in [-pi, pi), shape (3,).

    Raises
    ------
    InvalidPoint
        Where `of` is not a displacement.

    Examples
    --------
    >>> configuration(displacement(1, 2, 0.5)).tolist()
    [1.0, 2.0, 0.5]
    """
    matrix = as_displacement(of)
    theta = math.atan2(matrix[1, 0], matrix[0, 0])
    return np.array([matrix[0, 2], matrix[1, 2], theta if theta < math.pi else -math.pi])


def as_displacement(value: ArrayLike) -> Array:
    """A (3, 3) matrix that rotates and translates only; raises InvalidPoint for any other."""
    matrix = as_array(value, "displacement")
    if matrix.shape != (3, 3):
        raise InvalidPoint(f"a displacement must have shape (3, 3), got {matrix.shape}")
    (a, b), (c, d) = matrix[:2, :2]
    if not np.allclose(
        [a * a + c * c, a, b, *matrix[2]], [1.0, d, -c, 0.0, 0.0, 1.0], rtol=0.0, atol=1e-9
    ):
        raise InvalidPoint(
            "a displacement must be a rotation, a shift and the last row (0, 0, 1); make it with "
            "displacement(x, y, theta)"
        )
    return matrix
