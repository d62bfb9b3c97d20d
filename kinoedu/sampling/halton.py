"""Halton's sequence: van der Corput's sequence in a different prime base for each coordinate.

Sources: J. H. Halton, "On the efficiency of certain quasi-random sequences of points" (1960); Bullo
& Smith, chapter 4; LaValle, section 5.2.4.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidParameter
from ..geometry.checks import Array, integer, is_integer
from ..support.text import shortened

# Approximate length of a block whose digits are reversed one by one; it fits the first-level cache.
BLOCK = 4096
EXACT = 2**53  # every integer up to here is a float


def halton(n: int, primes: Sequence[int] = (2, 3), start: int = 1) -> Array:
    """The points with numbers start, ..., start + n - 1 of Halton's sequence.

    The sequence is infinite: a larger n only adds points. The dispersion of the first n points is
    O(n^(-1/d)). Point number 0 is the origin. Each coordinate is the float nearest to the exact
    fraction. O(n d).

    Parameters
    ----------
    n : how many points.
    primes : d distinct primes, the bases of the coordinates.
    start : the number of the first point.

    Returns
    -------
    (n, d) array

    Raises
    ------
    InvalidParameter
        Where an argument is out of range, or a base is not prime or occurs twice.

    Examples
    --------
    >>> halton(3)
    array([[0.5       , 0.33333333],
           [0.25      , 0.66666667],
           [0.75      , 0.11111111]])
    """
    bases = as_distinct_primes(primes)
    points = np.empty((integer(n, "n", least=1), len(bases)))
    for coordinate, base in zip(points.T, bases):
        fill_van_der_corput(coordinate, base, as_first_index(start))
    return points


def van_der_corput(n: int, base: int = 2, start: int = 1) -> Array:
    """The numbers i = start, ..., start + n - 1 with their digits reflected at the radix point.

    In base 2, the number 6 = 110 becomes 0.011 = 3/8. Any base from 2 is allowed. Each result is
    the float nearest to the exact fraction. O(n).

    Returns
    -------
    (n,) array

    Raises
    ------
    InvalidParameter
        Where an argument is out of range.

    Examples
    --------
    >>> van_der_corput(4)
    array([0.5  , 0.25 , 0.75 , 0.125])
    """
    numbers = np.empty(integer(n, "n", least=1))
    fill_van_der_corput(numbers, integer(base, "base", least=2), as_first_index(start))
    return numbers


def fill_van_der_corput(numbers: Array, base: int, start: int) -> None:
    """Write van der Corput's numbers from `start` on, block by block.

    The numerators are integers below 2^53, and each is divided once. For i = j * block + k, the
    reflected digits of k stand before those of j, so each block is the first one plus a constant.
    """
    end = start + len(numbers)
    digits = digits_needed(base, end)
    low = min(max(digits_needed(base, BLOCK), 1), digits)
    scale, block = base**digits, base**low
    if scale > EXACT:
        raise InvalidParameter(
            f"number {end - 1:,} has too many digits in base {base:,} to be exact; "
            "use a smaller start"
        )
    of_k = (all_reversed(base, low) * base ** (digits - low)).astype(np.float64)
    blocks = np.arange(start // block, (end - 1) // block + 1)
    for j, of_j in zip(blocks.tolist(), reverse_digits(blocks, base, digits - low).tolist()):
        first, last = max(j * block, start), min((j + 1) * block, end)
        numerators = of_k[first - j * block : last - j * block] + of_j
        np.divide(numerators, scale, out=numbers[first - start : last - start])


def digits_needed(base: int, number: int) -> int:
    """The least e with base^e >= number."""
    e = 0
    while base**e < number:
        e += 1
    return e


def all_reversed(base: int, digits: int) -> NDArray[np.int64]:
    """Each of the numbers 0, ..., base^digits - 1 with its digits in reverse order.

    One more digit in front of a number is one more behind its reverse.
    """
    reverse = np.zeros(1, np.int64)
    for _ in range(digits):
        reverse = np.add.outer(np.arange(base), reverse * base).ravel()
    return reverse


def reverse_digits(numbers: NDArray[np.int64], base: int, digits: int) -> NDArray[np.int64]:
    """Each number with its last `digits` digits in reverse order."""
    reverse, rest = np.zeros_like(numbers), numbers
    for _ in range(digits):
        reverse, rest = reverse * base + rest % base, rest // base
    return reverse


def as_first_index(start: object) -> int:
    """The first index of a sequence: an integer from 0, small enough for exact digits."""
    if not is_integer(start) or not 0 <= start < EXACT:
        raise InvalidParameter(
            f"start must be a whole number, zero or more and below 2^53, got {shortened(start)}"
        )
    return int(start)


def as_distinct_primes(primes: Any) -> list[int]:
    """The bases of Halton's sequence as a list; raises InvalidParameter unless distinct primes."""
    try:
        given = [integer(p, "a prime", least=2) for p in primes]
    except TypeError:
        given = []
    if not given:
        raise InvalidParameter(
            f"primes must be one prime for each coordinate, such as (2, 3), got {shortened(primes)}"
        )
    for i, p in enumerate(given):
        factor = next((f for f in range(2, int(p**0.5) + 1) if p % f == 0), p)
        if factor < p:
            raise InvalidParameter(
                f"primes must be primes, such as (2, 3, 5), got {p} = {factor} * {p // factor}"
            )
        if p in given[:i]:
            raise InvalidParameter(
                f"primes must differ from each other, got {p} twice: its coordinates would be equal"
            )
    return given
