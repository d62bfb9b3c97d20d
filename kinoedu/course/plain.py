"""Numbers as plain data: what a stranger's program returned, copied before anybody looks at it, or refused in words."""

import math
from typing import Any

import numpy as np

from ..words import say


class WrongShape(Exception):
    """A value is not of the declared shape; the message says what was expected and what came."""


def numeric(value: Any, dimensions: tuple[int | str, ...], words: str) -> np.ndarray:
    """A float64 array of the wanted dimensions, copied; or WrongShape."""
    try:
        array = np.array(value)
    except Exception:
        raise wrong(words, value) from None
    if array.size == 0:
        array = array.astype(float)
    if array.dtype.kind not in "iuf" or not fits(array.shape, dimensions):
        raise wrong(words, value)
    return array.astype(float)


def fits(shape: tuple[int, ...], dimensions: tuple[int | str, ...]) -> bool:
    """Whether an array's shape is the declared one."""
    lengths: dict[int | str, int] = {}
    return len(shape) == len(dimensions) and all(
        length == (wanted if isinstance(wanted, int) else lengths.setdefault(wanted, length))
        for length, wanted in zip(shape, dimensions, strict=True)
    )


def wrong(words: str, value: Any) -> WrongShape:
    """The refusal, in words."""
    return WrongShape(say("shape.wrong", wanted=words, came=described(value)))


def described(value: Any) -> str:
    """What a value is, safe and short, for a message: nothing of a stranger's own code is run but its class is named."""
    kind = type(value).__name__
    if value is None or type(value) in (bool, int, float, str):
        text = repr(value)
        return text if len(text) <= 60 else text[:57] + "..."
    if type(value) is np.ndarray:
        return say("shape.array", shape=value.shape, kind=value.dtype)
    if type(value) in (list, tuple, dict):
        return say("shape.sized", kind=kind, length=len(value))
    return say("shape.other", kind=kind)


def spelled(number: float) -> float | str:
    """A float as JSON has it; those that JSON has no word for by name."""
    return number if math.isfinite(number) else repr(number)


def nested(data: Any) -> Any:
    """Nested lists of floats as JSON has them."""
    return [nested(item) for item in data] if isinstance(data, list) else spelled(data)


def unnested(data: Any, words: str) -> Any:
    """Nested lists of floats from JSON."""
    return [unnested(item, words) for item in data] if isinstance(data, list) else read_number(data, words)


def read_number(data: Any, words: str) -> float:
    """A float from JSON."""
    if type(data) in (int, float) or data in ("nan", "inf", "-inf"):
        return float(data)
    raise wrong(words, data)
