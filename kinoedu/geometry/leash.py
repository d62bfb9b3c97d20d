"""How far one path follows another, such as a student's path beside the exact one.

Two points move forward, one on each path, at most a given distance (the leash) apart. Source: T.
Eiter, H. Mannila, "Computing discrete Fréchet distance" (1994).
"""

import numpy as np
from numpy.typing import ArrayLike

from .checks import Array, as_points


def count_followed_points(path: ArrayLike, guide: ArrayLike, leash: float) -> int:
    """The number of points of a path that can be walked while a guide stays within the leash.

    O(n m).

    Parameters
    ----------
    path : (n, 2) points.
    guide : (m, 2) points, walked forward.
    leash : the largest distance allowed between the two.

    Returns
    -------
    int
        n only if the guide reaches its last point too.

    Examples
    --------
    >>> guide = [(0, 0), (1, 0), (2, 0), (3, 0)]
    >>> count_followed_points([(0, 0.1), (3, 0.1)], guide, 0.5)
    1
    >>> count_followed_points([(0, 0), (1, 0.2), (2, -0.2), (3, 0)], guide, 0.5)
    4
    """
    points, (xs, ys) = as_points(path, "path"), as_points(guide, "guide").T
    positions = np.arange(len(xs))
    possible = np.zeros(len(xs) + 1, bool)  # where the guide can be; the first is before its start
    possible[0] = True
    for i, (x, y) in enumerate(points.tolist()):
        near = (xs - x) ** 2 + (ys - y) ** 2 <= leash * leash
        reached = near & (possible[1:] | possible[:-1])
        # The guide goes on from what it has reached, up to the next place that is too far.
        last_reached = np.maximum.accumulate(np.where(reached, positions, -1))
        last_far = np.maximum.accumulate(np.where(near, -1, positions))
        possible[0], possible[1:] = False, last_reached > last_far
        if not possible.any():
            return i
    return len(points) if possible[-1] else max(len(points) - 1, 0)


def densify_path(path: ArrayLike, spacing: float) -> Array:
    """The path, shape (n, 2), with points added so that neighbours are at most `spacing` apart.

    Examples
    --------
    >>> densify_path([(0, 0), (1, 0)], 0.5)
    array([[0. , 0. ],
           [0.5, 0. ],
           [1. , 0. ]])
    """
    points = as_points(path, "path")
    strides = np.diff(points, axis=0)
    lengths = np.linalg.norm(strides, axis=1)
    parts = np.maximum(1, np.ceil(lengths / spacing - 1e-9)).astype(np.int64)
    stride = np.repeat(np.arange(len(parts)), parts)  # of each point but the first
    part = np.arange(1, len(stride) + 1) - np.repeat(np.cumsum(parts) - parts, parts)
    added = points[stride] + (part / parts[stride])[:, None] * strides[stride]
    added[np.cumsum(parts) - 1] = points[1:]
    return np.vstack([points[:1], added])
