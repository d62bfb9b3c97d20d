"""Rigid motions of the plane as matrices: rotations (2, 2), and displacements (3, 3) that rotate
and then move. Bullo & Smith, chapters 3 and 6; LaValle, section 3.2.

Displacements are composed with `@`: (A @ B) does B first, or puts a frame B that is given in frame
A into the world.
"""

import math

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidPoint
from .checks import Array, as_array, as_points


def rotation(theta: float) -> Array:
    """The rotation by theta radians about the origin, counter-clockwise, shape (2, 2). By 0 it is
    the identity, exactly.

    >>> rotation(math.pi / 2).round(12) + 0.0
    array([[ 0., -1.],
           [ 1.,  0.]])
    """
    angle = one_number(theta, "theta")
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]]) + 0.0


def displacement(x: float, y: float, theta: float) -> Array:
    """The displacement that turns by theta about the origin, then moves by (x, y), shape (3, 3).

    It takes a point of a robot's body to where it is when the robot is at the configuration (x, y,
    theta).

    >>> displacement(3, 4, 0).tolist()
    [[1.0, 0.0, 3.0], [0.0, 1.0, 4.0], [0.0, 0.0, 1.0]]
    """
    matrix = np.eye(3)
    matrix[:2, :2] = rotation(theta)
    matrix[:2, 2] = one_number(x, "x"), one_number(y, "y")
    return matrix


def displaced(points: ArrayLike, by: ArrayLike) -> Array:
    """Where a displacement takes a point (2,), or points (n, 2).

    >>> displaced([(1, 0), (0, 0)], displacement(5, 5, math.pi))
    array([[4., 5.],
           [5., 5.]])
    """
    matrix = as_displacement(by)
    moved = as_points(points) @ matrix[:2, :2].T + matrix[:2, 2]
    return moved[0] if np.ndim(points) == 1 else moved


def inverse(of: ArrayLike) -> Array:
    """The displacement that undoes another: its rotation transposed, and the way back seen from
    there.

    >>> (inverse(displacement(1, 2, 3)) @ displacement(1, 2, 3)).round(12).tolist() == np.eye(3).tolist()
    True
    """
    matrix = as_displacement(of)
    back = np.eye(3)
    back[:2, :2] = matrix[:2, :2].T
    back[:2, 2] = 0.0 - matrix[:2, :2].T @ matrix[:2, 2]
    return back


def configuration(of: ArrayLike) -> Array:
    """The configuration (x, y, theta) that a displacement leads to, theta in [-pi, pi), shape (3,).

    >>> configuration(displacement(1, 2, 0.5)).tolist()
    [1.0, 2.0, 0.5]
    """
    matrix = as_displacement(of)
    theta = math.atan2(matrix[1, 0], matrix[0, 0])
    return np.array([matrix[0, 2], matrix[1, 2], theta if theta < math.pi else -math.pi])


def as_displacement(value: ArrayLike) -> Array:
    """A matrix (3, 3) that turns and moves and does nothing else; InvalidPoint otherwise."""
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


def one_number(value: float, name: str) -> float:
    """One finite number."""
    number = as_array(value, name)
    if number.ndim:
        raise InvalidPoint(f"{name} must be one number, got shape {number.shape}")
    return float(number)
