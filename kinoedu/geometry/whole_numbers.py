"""Exact sums and products of many floats, as whole numbers of any size.

For the few comparisons that have too many factors for the expansions of `exact.py`. A number is an
array of digits (k,) of the base 2^24, the least first. All digits are from 0 to 2^24 - 1, except
that the last one may be negative: its sign is that of the number.
"""

import math

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled

BITS = 24  # of a digit: 32,768 products of two digits are summed without overflow
BASE = 1 << BITS
MANTISSA = 53  # bits of a float
NO_UNIT = 10000  # more than every float's exponent

Digits = NDArray[np.int64]


@compiled
def unit_of(x: float) -> int:
    """An exponent e so that x is a multiple of 2^e; NO_UNIT for 0."""
    return NO_UNIT if x == 0.0 else math.frexp(x)[1] - MANTISSA


@compiled
def whole_number(x: float, unit: int) -> Digits:
    """The number x / 2^unit, which must be whole."""
    if x == 0.0:
        return np.zeros(1, np.int64)
    mantissa, exponent = math.frexp(x)
    mantissa = math.ldexp(mantissa, MANTISSA)
    shift = exponent - MANTISSA - unit
    sign, rest = (1 if mantissa > 0.0 else -1), int(abs(mantissa))
    first, raised = shift // BITS, 1 << (shift % BITS)
    digits = np.zeros(first + 4, np.int64)
    for k in range(first, first + 3):
        digits[k] = sign * (rest % BASE) * raised
        rest //= BASE
    return carried(digits)


@compiled
def difference(a: Digits, b: Digits) -> Digits:
    """The number a - b."""
    digits = np.zeros(max(len(a), len(b)) + 1, np.int64)
    digits[: len(a)] += a
    digits[: len(b)] -= b
    return carried(digits)


@compiled
def sum_of(a: Digits, b: Digits) -> Digits:
    """The number a + b."""
    digits = np.zeros(max(len(a), len(b)) + 1, np.int64)
    digits[: len(a)] += a
    digits[: len(b)] += b
    return carried(digits)


@compiled
def product(a: Digits, b: Digits) -> Digits:
    """The number a b."""
    digits = np.zeros(len(a) + len(b) + 1, np.int64)
    for i in range(len(a)):
        if a[i] != 0:
            digits[i : i + len(b)] += a[i] * b
    return carried(digits)


@compiled
def sign_of(a: Digits) -> int:
    """1, 0 or -1."""
    last = a[len(a) - 1]
    return int(last > 0) - int(last < 0)


@compiled
def carried(digits: Digits) -> Digits:
    """The same number with digits in their range, without zeros at its end."""
    for k in range(len(digits) - 1):
        carry = digits[k] // BASE
        digits[k] -= carry * BASE
        digits[k + 1] += carry
    size = len(digits)
    while size > 1 and digits[size - 1] == 0:
        size -= 1
    return digits[:size].copy()
