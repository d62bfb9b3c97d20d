"""Grids in the unit cube, and the bound that the best of them meets. Bullo & Smith, chapter 4; A.
G. Sukharev, "Optimal strategies of the search for an extremum" (1971); LaValle, section 5.2.
"""

import numpy as np

from ..errors import InvalidParameter
from ..geometry.checks import Array, whole

POWERS = {1: "first power", 2: "square", 3: "cube"}


def corner_grid(n: int, d: int = 2) -> Array:
    """n = k^d points at the lower corners i/k, i = 0, ..., k-1, of k^d equal cells of the unit
    cube, shape (n, d).

    The last coordinate changes fastest. Raises InvalidParameter where n is not a perfect power.

    >>> corner_grid(4)
    array([[0. , 0. ],
           [0. , 0.5],
           [0.5, 0. ],
           [0.5, 0.5]])
    """
    k = points_a_side(n, d)
    return lattice(np.arange(k) / k, d)


def sukharev_grid(n: int, d: int = 2) -> Array:
    """n = k^d points at the centres (i + 1/2)/k of the same cells, shape (n, d): in the sup norm no
    n points are spread better.

    >>> sukharev_grid(4)
    array([[0.25, 0.25],
           [0.25, 0.75],
           [0.75, 0.25],
           [0.75, 0.75]])
    """
    k = points_a_side(n, d)
    return lattice((2 * np.arange(k) + 1) / (2 * k), d)


def sukharev_bound(n: int, d: int = 2) -> float:
    """1 / (2 floor(n^(1/d))): no n points of the unit cube have a smaller dispersion in the sup
    norm (Sukharev's theorem).

    >>> sukharev_bound(100), sukharev_bound(99)
    (0.05, 0.05555555555555555)
    """
    return 1.0 / (2.0 * root(whole(n, "n", least=1), whole(d, "d", least=1)))


def lattice(along: Array, d: int) -> Array:
    """All points whose d coordinates are among those given, shape (k^d, d)."""
    return np.stack(np.meshgrid(*[along] * d, indexing="ij"), axis=-1).reshape(-1, d)


def points_a_side(n: int, d: int) -> int:
    """k with k^d = n, or InvalidParameter that names the nearest numbers that will do."""
    size, dimensions = whole(n, "n", least=1), whole(d, "d", least=1)
    if dimensions > 32:
        raise InvalidParameter(f"a grid has at most 32 dimensions, got d = {d}")
    k = root(size, dimensions)
    if k**dimensions != size:
        power = POWERS.get(dimensions, f"{dimensions}th power")
        raise InvalidParameter(
            f"a grid in {dimensions} dimensions needs n to be a perfect {power}, got {size:,}; "
            f"the nearest are {k**dimensions:,} and {(k + 1) ** dimensions:,}"
        )
    return k


def root(n: int, d: int) -> int:
    """The largest k with k^d <= n."""
    k = max(round(n ** (1.0 / d)), 1)
    return k if k**d <= n else k - 1
