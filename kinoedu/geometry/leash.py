"""How far one path follows another, such as a student's path beside the exact one.

Two points move forward, one on each path, at most a given distance (the leash) apart. Source: T.
Eiter, H. Mannila, "Computing discrete Fréchet distance" (1994).
"""

import numpy as np
from numpy.typing import ArrayLike

from ..compiled import compiled
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
    return int(count_followed(as_points(path, "path"), as_points(guide, "guide"), leash * leash))


@compiled
def count_followed(path: Array, guide: Array, square: float) -> int:
    """`count_followed_points` for arrays and the squared length of the leash."""
    n, m = len(path), len(guide)
    possible = np.zeros(m, np.bool_)  # whether the guide can be at j when the path is at i
    for i in range(n):
        diagonal = False  # whether the guide could be at j - 1 when the path was at i - 1
        for j in range(m):
            waiting = possible[j]
            reached = waiting or diagonal or (j > 0 and possible[j - 1]) or (i == 0 and j == 0)
            dx, dy = path[i, 0] - guide[j, 0], path[i, 1] - guide[j, 1]
            possible[j] = reached and dx * dx + dy * dy <= square
            diagonal = waiting
        if not possible.any():
            return i
    return n if possible[m - 1] else n - 1


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
    pieces = [points[:1]]
    for a, b in zip(points, points[1:]):
        n = max(1, int(np.ceil(np.linalg.norm(b - a) / spacing - 1e-9)))
        pieces.append(a + np.linspace(0.0, 1.0, n + 1)[1:, None] * (b - a))
    return np.concatenate(pieces)
