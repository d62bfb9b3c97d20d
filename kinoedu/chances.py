"""Confidence intervals of probabilities that were measured by repeated trials."""

import numpy as np
from numpy.typing import ArrayLike

from .errors import InvalidParameter
from .geometry.checks import Array, as_array, integer
from .support.text import shortened

Z = 1.959963984540054  # 95 percent of a normal distribution lie within Z standard deviations


def wilson_interval(successes: ArrayLike, trials: int) -> tuple[Array, Array]:
    """Wilson's 95 percent confidence interval of a proportion.

    Source: E. B. Wilson, "Probable inference, the law of succession, and statistical inference"
    (1927).

    Parameters
    ----------
    successes : array of any shape, each from 0 to `trials`.
    trials : how many trials there were.

    Returns
    -------
    low, high
        The ends of the intervals, each of the shape of `successes`. An interval is never empty, not
        even for 0 or `trials` successes. It is from 0 to 1 where there were no trials.

    Raises
    ------
    InvalidParameter
        Where a count is negative or larger than `trials`, or `trials` is no integer from 0.
    InvalidPoint
        Where `successes` are not numbers.

    Examples
    --------
    >>> low, high = wilson_interval([0, 50, 100], 100)
    >>> low.round(3).tolist(), high.round(3).tolist()
    ([0.0, 0.404, 0.963], [0.037, 0.596, 1.0])
    """
    counts, n = as_array(successes, "successes"), integer(trials, "trials", least=0, most=2**53)
    if not ((counts >= 0) & (counts <= n)).all():
        raise InvalidParameter(
            f"successes must lie between 0 and trials = {n}, got {shortened(successes)}"
        )
    if n == 0:
        return np.zeros_like(counts), np.ones_like(counts)
    p, square = counts / n, Z * Z / n
    middle = (p + square / 2) / (1 + square)
    reach = Z * np.sqrt(p * (1 - p) / n + square / (4 * n)) / (1 + square)
    low, high = np.maximum(middle - reach, 0.0), np.minimum(middle + reach, 1.0)
    return np.where(counts == 0, 0.0, low), np.where(counts == n, 1.0, high)
