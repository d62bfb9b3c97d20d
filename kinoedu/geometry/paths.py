"""Paths of straight pieces, given by their points: (n, 2) with n of at least 1."""

import numpy as np

from .checks import Array


def distances_along(path: Array) -> Array:
    """The length of the path from its first point to each of its points, (n,).

    >>> distances_along(np.array([(0, 0), (3, 4), (3, 6)]))
    array([0., 5., 7.])
    """
    return np.append(0.0, np.linalg.norm(np.diff(path, axis=0), axis=1).cumsum())


def path_length(path: Array) -> float:
    """The length of the whole path."""
    return float(distances_along(path)[-1])


def points_at_fractions(path: Array, fractions: Array) -> Array:
    """The points at fractions of the path's length, (k, 2)."""
    along = distances_along(path)
    return np.column_stack([np.interp(fractions * along[-1], along, axis) for axis in path.T])
