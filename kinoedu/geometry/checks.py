"""Checks of arguments: arrays of float64, numbers and Generators, or a named error."""

import math
from collections.abc import Callable
from functools import partial
from numbers import Real
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidParameter, InvalidPoint, InvalidWorld
from ..support.text import shortened

Array = NDArray[np.float64]
LIMIT = 1e150  # squares of larger coordinates overflow


def as_array(value: ArrayLike, name: str) -> Array:
    """Real numbers as a new float64 array of any shape.

    Raises
    ------
    InvalidPoint
        Where a number is missing, not finite, or larger than 1e150 in absolute value.
    """
    return convert(value, name, np.array)


def as_row(value: ArrayLike, name: str) -> Array:
    """One number, shape (), or a row of numbers, (m,); raises InvalidPoint."""
    numbers = as_array(value, name)
    if numbers.ndim > 1:
        raise InvalidPoint(f"{name} must be a number or a row of numbers, got {shortened(value)}")
    return numbers


def as_number(value: ArrayLike, name: str) -> float:
    """One number of any sign; raises InvalidPoint for anything else, such as a row of one."""
    number = as_array(value, name)
    if number.ndim:
        raise InvalidPoint(f"{name} must be one number, got {shortened(value)}")
    return float(number)


def borrow_array(value: ArrayLike, name: str) -> Array:
    """`as_array` for numbers that are only read: a float64 array is not copied.

    Compiled code has one kind of array, so an array that is not row by row, or is write-protected,
    is copied.
    """
    return convert(value, name, partial(np.require, requirements="CAW"))


def convert(value: ArrayLike, name: str, convert_numbers: Callable[..., Array]) -> Array:
    """Convert numbers by `convert_numbers`, a function like `np.array`, and check them."""
    array = as_floats(value, convert_numbers)
    if array is None:
        raise InvalidPoint(
            f"{name} must be real numbers in a regular array, got {shortened(value)}"
        )
    # a NaN compares False with both limits
    if array.size == 0 or (-LIMIT <= array.min() and array.max() <= LIMIT):
        return array
    if not np.all(np.isfinite(array)):
        raise InvalidPoint(f"{name} must be finite, got {shortened(value)}")
    raise InvalidPoint(
        f"{name} must not exceed 1e150 in size, got {np.abs(array).max():g}; choose a larger unit "
        "of length"
    )


def as_floats(value: ArrayLike, convert_numbers: Callable[..., Array] = np.array) -> Array | None:
    """Real numbers as float64, also infinite ones and NaN; None for anything else.

    A masked array is something else: its hidden values would count.
    """
    if isinstance(value, np.ma.MaskedArray):
        return None
    try:
        given = np.asarray(value)
        return convert_numbers(given, dtype=np.float64) if given.dtype.kind in "iufO" else None
    except (TypeError, ValueError, OverflowError):
        return None


def as_point(value: ArrayLike, name: str = "point") -> Array:
    """One point of the plane, shape (2,).

    Raises
    ------
    InvalidPoint
        Where the value is not two finite numbers.

    Examples
    --------
    >>> as_point([1, 2])
    array([1., 2.])
    """
    point = as_array(value, name)
    if point.shape != (2,):
        raise InvalidPoint(f"{name} must be one point (x, y), got {shortened(value)}")
    return point


def as_points(value: ArrayLike, name: str = "points") -> Array:
    """One point or many points, as an array of shape (m, 2).

    Raises
    ------
    InvalidPoint
        Where the value has neither shape (2,) nor shape (m, 2).
    """
    points = as_array(value, name)
    if points.shape == (2,):
        return points.reshape(1, 2)
    if points.ndim != 2 or points.shape[1] != 2:
        raise InvalidPoint(f"{name} must have shape (2,) or (m, 2), got {points.shape}")
    return points


def as_list(value: Any, name: str) -> list[Any]:
    """The items of an iterable as a list.

    Raises
    ------
    InvalidWorld
        Where the value cannot be iterated.
    """
    try:
        return list(value)
    except TypeError:
        raise InvalidWorld(f"{name} must be a list, got {shortened(value)}") from None


def one_or_many(value: ArrayLike, answers: NDArray[Any]) -> Any:
    """The first answer alone if `value` is a single point, else the array of all answers."""
    if np.ndim(value) > 1:
        return answers
    return answers[0].item() if answers.ndim == 1 else answers[0]


def positive(value: object, name: str) -> float:
    """A number above 0 and at most 1e150, as a float.

    Raises
    ------
    InvalidParameter
        Where the value is anything else.

    Examples
    --------
    >>> positive(2, "step")
    2.0
    """
    number = as_float(value)
    if not 0.0 < number <= LIMIT:
        raise InvalidParameter(
            f"{name} must be a positive number, at most 1e150, got {shortened(value)}"
        )
    return number


def nonnegative(value: object, name: str) -> float:
    """A number from 0 to 1e150, as a float.

    Raises
    ------
    InvalidParameter
        Where the value is anything else.
    """
    number = as_float(value)
    if not 0.0 <= number <= LIMIT:
        raise InvalidParameter(
            f"{name} must be a number, zero or more, at most 1e150, got {shortened(value)}"
        )
    return number


def integer(value: object, name: str, *, least: int, most: int = 10_000_000) -> int:
    """An integer from `least` to `most`: by default the most nodes that memory should hold.

    Raises
    ------
    InvalidParameter
        Where the value is anything else.
    """
    if not is_integer(value) or not least <= value <= most:
        raise InvalidParameter(
            f"{name} must be a whole number from {least} to {most:,}, got {shortened(value)}"
        )
    return int(value)


def as_float(value: object) -> float:
    """A real number as a float, before its size is checked; NaN for anything else."""
    try:
        return float(value) if is_real(value) else math.nan
    except OverflowError:  # an integer or a fraction that no float can hold
        return math.inf


def is_integer(value: object) -> TypeGuard[int]:
    """Whether the value is an integer of Python or numpy; True and False are not."""
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def is_real(value: object) -> TypeGuard[float]:
    """Whether the value is a real number; True and False are not."""
    return isinstance(value, Real) and not isinstance(value, bool | np.bool_)


def as_generator(rng: int | np.random.Generator) -> np.random.Generator:
    """A numpy Generator made from a seed; an existing Generator is returned unchanged.

    Raises
    ------
    InvalidParameter
        Where `rng` is neither a nonnegative integer nor a Generator.

    Examples
    --------
    >>> as_generator(0).random() == np.random.default_rng(0).random()
    True
    """
    if isinstance(rng, np.random.Generator):
        return rng
    if not is_integer(rng) or rng < 0:
        raise InvalidParameter(
            f"the seed (rng) must be 0, 1, 2, ... or a numpy Generator, got {shortened(rng)}"
        )
    return np.random.default_rng(int(rng))
