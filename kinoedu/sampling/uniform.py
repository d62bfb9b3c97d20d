"""Random points. Bullo & Smith, chapter 4; LaValle, section 5.2.2."""

import numpy as np

from ..geometry.checks import Array, as_generator, whole


def uniform_random(n: int, d: int = 2, *, rng: int | np.random.Generator) -> Array:
    """n independent points, uniform in the unit cube [0, 1)^d, shape (n, d); rng is a seed or a
    numpy Generator.

    They can be drawn one after another for ever, and leave larger holes than a grid: their
    dispersion goes like (log n / n)^(1/d). Raises InvalidParameter.

    >>> uniform_random(100, rng=0).shape
    (100, 2)
    """
    size, dimensions = whole(n, "n", least=1), whole(d, "d", least=1)
    return as_generator(rng).random((size, dimensions))
