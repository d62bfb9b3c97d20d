"""Grids in the unit cube, and Sukharev's bound on the dispersion of any point set.

Sources: Bullo & Smith, chapter 4; A. G. Sukharev, "Optimal strategies of the search for an
extremum" (1971); LaValle, section 5.2.
"""

from __future__ import annotations

import numpy as np

from ..errors import InvalidParameter
from ..geometry.checks import Array, integer

POWERS = {1: "first power", 2: "square", 3: "cube"}


def corner_grid(n: int, d: int = 2) -> Array:
    """The n = k^d points at the lower corners of k^d equal cells of the unit cube.

    The coordinates are i/k, i = 0, ..., k-1. The last coordinate changes fastest.

    Returns
    -------
    (n, d) array

    Raises
    ------
    InvalidParameter
        Where n is not the d-th power of an integer; the message gives the nearest that are.

    Examples
    --------
    >>> corner_grid(4)
    array([[0. , 0. ],
           [0. , 0.5],
           [0.5, 0. ],
           [0.5, 0.5]])
    """
    k = points_per_side(n, d)
    return lattice(np.arange(k) / k, d)


def sukharev_grid(n: int, d: int = 2) -> Array:
    """The n = k^d points at the centres of k^d equal cells of the unit cube.

    The coordinates are (i + 1/2)/k, i = 0, ..., k-1. No n points have a smaller dispersion in the
    sup norm. Result and errors are those of `corner_grid`.

    Examples
    --------
    >>> sukharev_grid(4)
    array([[0.25, 0.25],
           [0.25, 0.75],
           [0.75, 0.25],
           [0.75, 0.75]])
    """
    k = points_per_side(n, d)
    return lattice((2 * np.arange(k) + 1) / (2 * k), d)


def sukharev_bound(n: int, d: int = 2) -> float:
    """The smallest dispersion in the sup norm that n points of the unit cube can have.

    It is 1 / (2 floor(n^(1/d))) by Sukharev's theorem.

    Raises
    ------
    InvalidParameter
        Where n or d is not a positive integer.

    Examples
    --------
    >>> sukharev_bound(100), sukharev_bound(99)
    (0.05, 0.05555555555555555)
    """
    return 1.0 / (2.0 * integer_root(integer(n, "n", least=1), integer(d, "d", least=1)))


def lattice(along: Array, d: int) -> Array:
    """All points whose d coordinates are among those given, shape (k^d, d)."""
    return np.stack(np.meshgrid(*[along] * d, indexing="ij"), axis=-1).reshape(-1, d)


def points_per_side(n: int, d: int) -> int:
    """The integer k with k^d = n; raises InvalidParameter where there is none."""
    size, dimensions = integer(n, "n", least=1), integer(d, "d", least=1)
    if dimensions > 32:
        raise InvalidParameter(f"a grid has at most 32 dimensions, got d = {d}")
    k = integer_root(size, dimensions)
    if k**dimensions != size:
        power = POWERS.get(dimensions, f"{dimensions}th power")
        raise InvalidParameter(
            f"a grid in {dimensions} dimensions needs n to be a perfect {power}, got {size:,}; "
            f"the nearest are {k**dimensions:,} and {(k + 1) ** dimensions:,}"
        )
    return k


def integer_root(n: int, d: int) -> int:
    """The largest integer k with k^d <= n."""
    k = max(round(n ** (1.0 / d)), 1)
    return k if k**d <= n else k - 1
