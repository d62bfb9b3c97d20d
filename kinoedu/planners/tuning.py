"""Tuning arguments, checked: each becomes a plain number, or InvalidParameter says which was wrong and what it may be."""

from numbers import Real
from typing import Any

import numpy as np

from ..errors import InvalidParameter
from ..geometry.checks import LIMIT, shortened


def positive(value: Any, name: str) -> float:
    """A finite number above zero.

    >>> positive(2, "step")
    2.0
    """
    if not is_real(value) or not 0.0 < value <= LIMIT or float(value) == 0.0:
        raise InvalidParameter(f"{name} must be a positive number, at most 1e150, got {shortened(value)}")
    return float(value)


def none_or_more(value: Any, name: str) -> float:
    """A finite number, zero or more."""
    if not is_real(value) or not 0.0 <= value <= LIMIT:
        raise InvalidParameter(f"{name} must be a number, zero or more, at most 1e150, got {shortened(value)}")
    return float(value)


def one_of(value: Any, name: str, choices: tuple[str, ...]) -> str:
    """One of a few words.

    >>> one_of("left", "turn", ("left", "right"))
    'left'
    """
    if not isinstance(value, str) or value not in choices:
        raise InvalidParameter(f"{name} must be {' or '.join(map(repr, choices))}, got {shortened(value)}")
    return value


def share(value: Any, name: str) -> float:
    """A number from 0 to 1."""
    if not is_real(value) or not 0.0 <= value <= 1.0:
        raise InvalidParameter(f"{name} must be a number from 0 to 1, got {value!r}")
    return float(value)


def whole(value: Any, name: str, *, least: int) -> int:
    """A whole number, not less than `least`; at most ten million, which is what memory holds nodes for."""
    if isinstance(value, bool) or not isinstance(value, int | np.integer) or not least <= value <= 10_000_000:
        raise InvalidParameter(f"{name} must be a whole number from {least} to 10,000,000, got {value!r}")
    return int(value)


def is_real(value: Any) -> bool:
    """Whether a value is a number; True and False are not."""
    return isinstance(value, Real) and not isinstance(value, bool | np.bool_)
