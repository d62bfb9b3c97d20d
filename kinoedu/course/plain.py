"""Numbers as plain data: what a stranger's program returned, copied before anybody looks at it, or
refused in words.
"""

import math
from typing import Any, Protocol

import numpy as np

from ..words import say


class WrongShape(Exception):
    """A value is not of the declared shape; the message says what was expected and what came."""


class Worded(Protocol):
    """What can say what it is; it is only asked to where something does not fit."""

    @property
    def words(self) -> str: ...


def numeric(value: Any, dimensions: tuple[int | str, ...], wanted: Worded) -> np.ndarray:
    """A float64 array of the wanted dimensions, copied; or WrongShape."""
    if type(value) is np.ndarray and value.size and not fits(value.shape, dimensions):
        raise wrong(wanted.words, value)  # before it is copied: it may be huge
    try:
        array = np.array(value)
    except Exception:
        raise wrong(wanted.words, value) from None
    if array.size == 0:
        array = array.astype(float)
        if (
            array.shape == (0,) and dimensions and isinstance(dimensions[0], str)
        ):  # an empty list is an array of no rows
            array = np.empty([length if isinstance(length, int) else 0 for length in dimensions])
    if array.dtype.kind not in "iuf" or not fits(array.shape, dimensions):
        raise wrong(wanted.words, value)
    return array.astype(float)


def fits(shape: tuple[int, ...], dimensions: tuple[int | str, ...]) -> bool:
    """Whether an array's shape is the declared one."""
    if shape == dimensions:
        return True
    lengths: dict[int | str, int] = {}
    return len(shape) == len(dimensions) and all(
        length == (wanted if isinstance(wanted, int) else lengths.setdefault(wanted, length))
        for length, wanted in zip(shape, dimensions, strict=True)
    )


def wrong(words: str, value: Any) -> WrongShape:
    """The refusal, in words."""
    return WrongShape(say("shape.wrong", wanted=words, came=described(value)))


def described(value: Any) -> str:
    """What a value is, safe and short, for a message: nothing of a stranger's own code is run but
    its class is named.
    """
    kind = class_name(type(value))
    if type(value) is int and abs(value) >= 10**50:
        return say("shape.long_number")
    if value is None or type(value) in (bool, int, float, str):
        text = repr(value)
        return text if len(text) <= 60 else text[:57] + "..."
    if type(value) is np.ndarray:
        return say("shape.array", shape=value.shape, kind=value.dtype)
    if type(value) in (list, tuple, dict):
        return say("shape.sized", kind=kind, length=len(value))
    return say("shape.other", kind=kind)


def class_name(kind: type) -> str:
    """A class's name, by Python's own means and not by what the class may say; at most a hundred
    characters.
    """
    return str(type.__dict__["__name__"].__get__(kind))[:100]


def spelled(number: float) -> float | str:
    """A float as JSON has it; those that JSON has no word for by name."""
    return number if math.isfinite(number) else repr(number)


def nested(data: Any) -> Any:
    """Nested lists of floats as JSON has them."""
    return [nested(item) for item in data] if isinstance(data, list) else spelled(data)


def unnested(data: Any, wanted: Worded, depth: int) -> Any:
    """Nested lists of floats from JSON, so many lists deep; deeper ones are refused before they are
    looked into.
    """
    if depth == 0 or not isinstance(data, list):
        return read_number(data, wanted)
    return [unnested(item, wanted, depth - 1) for item in data]


def read_number(data: Any, wanted: Worded) -> float:
    """A float from JSON."""
    if (
        type(data) is float
        or (type(data) is int and abs(data) < 2**53)
        or (type(data) is str and data in ("nan", "inf", "-inf"))
    ):
        return float(data)
    raise wrong(wanted.words, data)
