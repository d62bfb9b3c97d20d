"""A number of many seeds: run a function with each of them, and describe the spread in words."""

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import ArrayLike

from ..geometry.checks import Array, integer


def over_seeds(run: Callable[[int], float], seeds: int | Iterable[int]) -> Array:
    """The number that a function returns for each seed.

    Parameters
    ----------
    run : a function of a seed that returns a number.
    seeds : the seeds, or how many of them, from 0 on.

    Returns
    -------
    (n,)

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> over_seeds(lambda seed: 2.0 * seed, 3)
    array([0., 2., 4.])
    """
    numbers = seeds if isinstance(seeds, Iterable) else range(integer(seeds, "seeds", least=1))
    return np.array([float(run(seed)) for seed in numbers])


def describe_spread(values: ArrayLike, form: str = ".0f") -> str:
    """The median and the range of some numbers, in words; infinite ones are counted apart.

    Parameters
    ----------
    values : (n,), of n seeds; infinite where a run found nothing.
    form : how each number is written.

    Examples
    --------
    >>> describe_spread([739, 317, 1122])
    'median 739, from 317 to 1122 (3 seeds)'
    >>> describe_spread([1.5, 2.5, float("inf")], ".1f")
    'median 2.0, from 1.5 to 2.5 (2 of 3 seeds)'
    """
    given = np.asarray(values, float)
    found = given[np.isfinite(given)]
    if not len(found):
        return f"none (of {len(given)} seeds)"
    how_many = f"{len(given)}" if len(found) == len(given) else f"{len(found)} of {len(given)}"
    low, middle, high = found.min(), np.median(found), found.max()
    return f"median {middle:{form}}, from {low:{form}} to {high:{form}} ({how_many} seeds)"
