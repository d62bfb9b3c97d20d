"""Copies untrusted values into plain numbers, or rejects them with a message."""

import math
from fractions import Fraction
from typing import Any, Protocol

import numpy as np

from ..messages import get_message
from ..support.json_fields import Json
from .exceptions import class_name

SCALARS = (np.bool_, np.int64, np.float64)  # of numpy, shown as the Python values that they hold
# numbers that an array of objects may hold
EXACT = (int, float, Fraction, np.float64, np.int64)


class WrongShape(Exception):
    """A value is not of the declared shape; the message says what was expected and what came."""


class Describable(Protocol):
    """An object with a description of itself, used only when a value does not fit."""

    @property
    def description(self) -> str: ...


def as_array(value: object, dimensions: tuple[int | str, ...], wanted: Describable) -> np.ndarray:
    """Copy a value into a float64 array of the wanted dimensions; fractions are rounded.

    Raises
    ------
    WrongShape
    """
    if type(value) is np.ndarray and value.size and not fits(value.shape, dimensions):
        raise wrong_shape(wanted.description, value)  # without copying it, since it may be huge
    try:
        array = np.array(value)
        array = array if array.dtype.kind in "iuf" else np.array(value, object)
    except Exception:
        raise wrong_shape(wanted.description, value) from None
    if array.size == 0:
        array = array.astype(float)
        # an empty list is an array without rows
        if array.shape == (0,) and dimensions and isinstance(dimensions[0], str):
            array = np.empty([length if isinstance(length, int) else 0 for length in dimensions])
    if not fits(array.shape, dimensions):
        raise wrong_dimensions(wanted.description, value, array.shape, len(dimensions))
    if array.dtype.kind not in "iuf" and not all(type(item) in EXACT for item in array.flat):
        raise no_numbers(wanted.description, value, array)
    try:
        return array.astype(float)
    except Exception:  # too large
        raise wrong_shape(wanted.description, value) from None


def fits(shape: tuple[int, ...], dimensions: tuple[int | str, ...]) -> bool:
    """Whether an array's shape is the declared one."""
    if shape == dimensions:
        return True
    lengths: dict[int | str, int] = {}
    return len(shape) == len(dimensions) and all(
        length == (wanted if isinstance(wanted, int) else lengths.setdefault(wanted, length))
        for length, wanted in zip(shape, dimensions, strict=True)
    )


def wrong_shape(words: str, value: object) -> WrongShape:
    """Exception for a value of the wrong shape, with its message."""
    return WrongShape(get_message("shape.wrong", wanted=words, came=describe_value(value)))


def wrong_dimensions(
    words: str, value: object, shape: tuple[int, ...], dimensions: int
) -> WrongShape:
    """Exception for a value that makes an array of another shape, which it names.

    It is not named where the length of a list says the same.
    """
    if type(value) not in (list, tuple) or len(shape) == dimensions == 1:
        return wrong_shape(words, value)
    came = get_message("shape.makes", value=describe_value(value), shape=shape)
    return WrongShape(get_message("shape.wrong", wanted=words, came=came))


def no_numbers(words: str, value: object, items: np.ndarray) -> WrongShape:
    """Exception for a value of the right shape whose items are not all numbers."""
    for item in items.flat if type(value) in (list, tuple) else ():
        if type(item) is bool or not isinstance(item, float | int | np.number):
            return wrong_item(words, value, item)
    return wrong_shape(words, value)


def wrong_item(words: str, value: object, item: object) -> WrongShape:
    """Exception for a value of the right shape with an item that does not fit, which it names."""
    held = {"value": describe_value(value), "item": describe_value(item)}
    came = get_message("shape.holding", **held)
    return WrongShape(get_message("shape.wrong", wanted=words, came=came))


def describe_value(value: Any) -> str:
    """Short and safe description of a value for a message.

    None of the value's own code is run; only its class is named.
    """
    if type(value) in SCALARS:
        value = value.item()
    kind = class_name(type(value))
    if type(value) is int and abs(value) >= 10**50:
        return get_message("shape.long_number")
    if value is None or type(value) in (bool, int, float, str):
        text = repr(value)
        return text if len(text) <= 60 else text[:57] + "..."
    if type(value) is np.ndarray:
        return get_message("shape.array", shape=value.shape, kind=value.dtype)
    if type(value) in (list, tuple, dict):
        return get_message("shape.sized", kind=kind, length=len(value))
    return get_message("shape.other", kind=kind)


def encode_float(number: float) -> float | str:
    """Encode a float for JSON; nan and the infinities become strings."""
    return number if math.isfinite(number) else repr(number)


def encode_floats(data: Json) -> Any:
    """Encode nested lists of floats for JSON."""
    return [encode_floats(item) for item in data] if isinstance(data, list) else encode_float(data)


def decode_floats(data: object, wanted: Describable, depth: int) -> Any:
    """Decode nested lists of floats of a known depth; deeper lists are rejected unvisited."""
    if depth == 0 or not isinstance(data, list):
        return decode_float(data, wanted)
    return [decode_floats(item, wanted, depth - 1) for item in data]


def decode_float(data: object, wanted: Describable) -> float:
    """Decode a float from JSON. Raises WrongShape."""
    if (
        type(data) is float
        or (type(data) is int and abs(data) < 2**53)
        or (type(data) is str and data in ("nan", "inf", "-inf"))
    ):
        return float(data)
    raise wrong_shape(wanted.description, data)
