"""Where points enter: lists and arrays become checked float64 arrays, or a named error says what is wrong with them."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidPoint

Array = NDArray[np.float64]
LIMIT = 1e150  # squares of larger coordinates overflow


def as_array(value: ArrayLike, name: str) -> Array:
    """Any numbers as float64, each finite and at most 1e150 in size; InvalidPoint otherwise."""
    try:
        given = np.asarray(value)
        array = np.array(value, dtype=np.float64) if given.dtype.kind in "iufO" else None
    except (TypeError, ValueError, OverflowError):
        array = None
    if array is None or isinstance(value, np.ma.MaskedArray):
        raise InvalidPoint(f"{name} must be real numbers in a regular array, got {shortened(value)}")
    if array.size == 0 or (array.min() >= -LIMIT and array.max() <= LIMIT):  # neither where there is a NaN
        return array
    if not np.all(np.isfinite(array)):
        raise InvalidPoint(f"{name} must be finite, got {shortened(value)}")
    raise InvalidPoint(f"{name} must not exceed 1e150 in size, got {np.abs(array).max():g}; choose a larger unit of length")


def shortened(value: Any) -> str:
    """A value as text that fits an error message."""
    text = " ".join(repr(value).split())
    return text if len(text) <= 80 else text[:77] + "..."


def as_point(value: ArrayLike, name: str = "point") -> Array:
    """One point of the plane, shape (2,).

    >>> as_point([1, 2])
    array([1., 2.])
    """
    point = as_array(value, name)
    if point.shape != (2,):
        raise InvalidPoint(f"{name} must be one point (x, y), got {shortened(value)}")
    return point


def as_points(value: ArrayLike, name: str = "points") -> Array:
    """One point or many, as shape (m, 2)."""
    points = as_array(value, name)
    if points.shape == (2,):
        return points.reshape(1, 2)
    if points.ndim != 2 or points.shape[1] != 2:
        raise InvalidPoint(f"{name} must have shape (2,) or (m, 2), got {points.shape}")
    return points


def one_or_many(value: ArrayLike, answers: NDArray[Any]) -> Any:
    """A plain number or row where one point was asked about, the array of answers where many were."""
    if np.ndim(value) > 1:
        return answers
    return answers[0].item() if answers.ndim == 1 else answers[0]
