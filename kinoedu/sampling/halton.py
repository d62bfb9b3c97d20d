"""Halton's sequence: van der Corput's, in another prime base for each coordinate. J. H. Halton, "On
the efficiency of certain quasi-random sequences of points" (1960); Bullo & Smith, chapter 4;
LaValle, section 5.2.4.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import InvalidParameter
from ..geometry.checks import Array, whole
from ..support.text import shortened

# about how many numbers have their digits mirrored one by one; as many floats stay in the nearest
# cache
BLOCK = 4096
EXACT = 2**53  # up to here every whole number is a float


def halton(n: int, primes: Sequence[int] = (2, 3), start: int = 1) -> Array:
    """Points number start, ..., start + n - 1 of Halton's sequence, shape (n, d): a coordinate for
    each of d distinct primes.

    The first n points are those of any larger n: the sequence can be drawn for ever, and its
    dispersion goes like n^(-1/d). Number 0 is the origin. Each coordinate is the float nearest to
    the exact fraction. O(n d). Raises InvalidParameter.

    >>> halton(3)
    array([[0.5       , 0.33333333],
           [0.25      , 0.66666667],
           [0.75      , 0.11111111]])
    """
    bases = distinct_primes(primes)
    points = np.empty((whole(n, "n", least=1), len(bases)))
    for coordinate, base in zip(points.T, bases):
        fill(coordinate, base, first_number(start))
    return points


def van_der_corput(n: int, base: int = 2, start: int = 1) -> Array:
    """The numbers i = start, ..., start + n - 1, their digits mirrored at the point, shape (n,): 6
    = 110 becomes 0.011 = 3/8.

    In any base from 2. Each is the float nearest to the exact fraction. O(n). Raises
    InvalidParameter.

    >>> van_der_corput(4)
    array([0.5  , 0.25 , 0.75 , 0.125])
    """
    numbers = np.empty(whole(n, "n", least=1))
    fill(numbers, whole(base, "base", least=2), first_number(start))
    return numbers


def fill(numbers: Array, base: int, start: int) -> None:
    """Write van der Corput's numbers from `start` on, block by block: whole numbers below 2^53,
    divided once.

    Where i = j * block + k, the mirrored digits of k stand before those of j. So a block is the
    first one moved.
    """
    end = start + len(numbers)
    digits = exponent(base, end)
    low = min(max(exponent(base, BLOCK), 1), digits)
    scale, block = base**digits, base**low
    if scale > EXACT:
        raise InvalidParameter(
            f"number {end - 1:,} has too many digits in base {base:,} to be exact; begin earlier"
        )
    of_k = (mirrored(np.arange(block), base, low) * base ** (digits - low)).astype(np.float64)
    blocks = np.arange(start // block, (end - 1) // block + 1)
    for j, of_j in zip(blocks.tolist(), mirrored(blocks, base, digits - low).tolist()):
        first, last = max(j * block, start), min((j + 1) * block, end)
        np.divide(
            of_k[first - j * block : last - j * block] + of_j,
            scale,
            out=numbers[first - start : last - start],
        )


def exponent(base: int, number: int) -> int:
    """The least e with base^e >= number."""
    e = 0
    while base**e < number:
        e += 1
    return e


def mirrored(numbers: NDArray[np.int64], base: int, digits: int) -> NDArray[np.int64]:
    """Each number with so many of its digits in reverse order."""
    reverse, rest = np.zeros_like(numbers), numbers
    for _ in range(digits):
        reverse, rest = reverse * base + rest % base, rest // base
    return reverse


def first_number(start: Any) -> int:
    """Where a sequence begins: a whole number that leaves room for exact digits."""
    if isinstance(start, bool) or not isinstance(start, int | np.integer) or not 0 <= start < EXACT:
        raise InvalidParameter(
            f"start must be a whole number, zero or more and below 2^53, got {shortened(start)}"
        )
    return int(start)


def distinct_primes(primes: Any) -> list[int]:
    """Bases that have no common factor, as Halton's sequence needs them; InvalidParameter names the
    first that will not do.
    """
    try:
        given = [whole(p, "a prime", least=2) for p in primes]
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
