"""Random points. Sources: Bullo & Smith, chapter 4; LaValle, section 5.2.2."""

from __future__ import annotations

import numpy as np

from ..geometry.checks import Array, as_generator, integer


def uniform_random(n: int, d: int = 2, *, rng: int | np.random.Generator) -> Array:
    """Independent random points, uniformly distributed in the unit cube [0, 1)^d.

    More points can always be added. They leave larger holes than a grid: their dispersion is
    proportional to (log n / n)^(1/d).

    Parameters
    ----------
    n, d : positive integers.
    rng : a seed or a numpy Generator.

    Returns
    -------
    (n, d) array

    Raises
    ------
    InvalidParameter
        Where n or d is not a positive integer, or rng is neither a seed nor a Generator.

    Examples
    --------
    >>> uniform_random(100, rng=0).shape
    (100, 2)
    """
    size, dimensions = integer(n, "n", least=1), integer(d, "d", least=1)
    return as_generator(rng).random((size, dimensions))
