"""How far one walk follows another: a student's path beside the exact one.

Two walkers go forward, each on its own path, joined by a leash of a given length. T. Eiter, H.
Mannila, "Computing discrete Fréchet distance" (1994).
"""

import numpy as np
from numpy.typing import ArrayLike

from ..compiled import compiled
from .checks import Array, as_points


def followed(path: ArrayLike, guide: ArrayLike, leash: float) -> int:
    """How many points of a path, shape (n, 2), can be walked while a guide walks another, shape (m,
    2), never farther away than the leash. All n only if the guide arrives too. O(n m).

    >>> guide = [(0, 0), (1, 0), (2, 0), (3, 0)]
    >>> followed([(0, 0.1), (3, 0.1)], guide, 0.5), followed([(0, 0), (1, 0.2), (2, -0.2), (3, 0)], guide, 0.5)
    (1, 4)
    """
    return int(steps_on_leash(as_points(path, "path"), as_points(guide, "guide"), leash * leash))


@compiled
def steps_on_leash(path: Array, guide: Array, square: float) -> int:
    """The same for arrays and the square of the leash's length."""
    n, m = len(path), len(guide)
    possible = np.zeros(
        m, np.bool_
    )  # where the guide can be when the path has been walked to its point i
    for i in range(n):
        behind = False  # whether the guide could be at j - 1 before the path's last step
        for j in range(m):
            before = possible[j]
            reached = before or behind or (j > 0 and possible[j - 1]) or (i == 0 and j == 0)
            dx, dy = path[i, 0] - guide[j, 0], path[i, 1] - guide[j, 1]
            possible[j] = reached and dx * dx + dy * dy <= square
            behind = before
        if not possible.any():
            return i
    return n if possible[m - 1] else n - 1


def at_most_apart(path: ArrayLike, spacing: float) -> Array:
    """The same path, shape (n, 2), with points added so that no two neighbours are farther apart
    than the spacing.

    >>> at_most_apart([(0, 0), (1, 0)], 0.5)
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
