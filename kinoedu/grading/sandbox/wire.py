"""Values as lines of JSON, between a student's program and the library that answers it.

Only plain data pass: numbers, text, truth values, None, lists, tuples, dicts and arrays of numbers;
a fraction passes as a float. What is not plain stays where it is, and only its number passes: a
function or a problem of the library is `lent`, and the program asks it by its number. So neither
side ever runs what the other one sends. Needs Python and numpy alone.

A list is written as a list. Everything else that JSON lacks is written as {mark: content}.
"""

import json
from collections.abc import Callable, Sequence
from contextlib import suppress
from fractions import Fraction
from typing import Any

import numpy as np

from ...support.generators import plain_state

TUPLE, DICT, ARRAY, LENT, GENERATOR, OTHER = "t", "d", "a", "h", "g", "o"
DTYPES = {"f": np.float64, "i": np.int64, "u": np.uint64, "b": np.bool_}  # by numpy's kinds
TEXT = (str, bytes, bytearray, memoryview)  # sequences that are not lists of values
MOST_BITS = 4000  # of an integer
MOST_DEEP = 40  # lists within lists
DEEPEST = 2 * MOST_DEEP + 10  # lists within lists as JSON, where a dict is two lists
# how many numbers of its block a generator may have used; numpy reads on behind the block
MOST_USED = {"MT19937": 624, "Philox": 4}


class Unfit(ValueError):
    """A line is not what `encode` writes."""


class Other:
    """Something that cannot pass; only the name of its class is known."""


def make_other(name: str) -> Other:
    """An object whose class has a name."""
    return type(str(name)[:100], (Other,), {})()


def write_line(data: object) -> bytes:
    """Data of `encode` as a line."""
    return json.dumps(data).encode() + b"\n"


def read_line(line: bytes) -> dict[str, Any]:
    """The message in a line. Raises Unfit."""
    try:
        message = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise Unfit("not JSON") from error
    if not isinstance(message, dict):
        raise Unfit("not a message")
    return message


def encode(value: Any, lend: Callable[[Any], dict[str, Any] | None], deep: int = 0) -> Any:
    """A value as JSON data.

    lend : gives the mark of a value that is lent, or None where it is not lent.
    """
    kind = type(value)
    if value is None or kind in (bool, str, float):
        return value
    if kind is int and value.bit_length() < MOST_BITS:
        return value
    if kind is np.str_:
        return str(value)
    if kind is Fraction:
        with suppress(OverflowError):
            return float(value)
    if isinstance(value, np.ndarray | np.generic) and value.dtype.kind in DTYPES:
        array: np.ndarray = np.asarray(value, DTYPES[value.dtype.kind])
        return {ARRAY: [list(array.shape), array.dtype.kind, array.ravel().tolist()]}
    lent = None if kind in (list, tuple, dict) else lend(value)
    if lent is not None:
        return lent
    if deep < MOST_DEEP:
        if isinstance(value, dict):
            pairs = [[encode(part, lend, deep + 1) for part in pair] for pair in value.items()]
            return {DICT: pairs}
        if isinstance(value, Sequence | np.ndarray) and not isinstance(value, TEXT):
            items = [encode(item, lend, deep + 1) for item in value]
            return {TUPLE: items} if isinstance(value, tuple) else items
    if isinstance(value, float | int) and not isinstance(value, TEXT):
        return float(value) if isinstance(value, float) else encode_integer(value)
    return {OTHER: str(type.__dict__["__name__"].__get__(kind))[:100]}


def encode_integer(value: int) -> Any:
    """An integer of a class of its own, or of too many digits."""
    return int(value) if value.bit_length() < MOST_BITS else {OTHER: "int"}


def decode(data: Any, find: Callable[[str, Any], Any], deep: int = 0) -> Any:
    """The value of JSON data. Raises Unfit, also where it is deeper than `encode` writes.

    find : gives the value of the marks LENT and GENERATOR.
    """
    if deep > DEEPEST:
        raise Unfit("too deep")
    if isinstance(data, list):
        return [decode(item, find, deep + 1) for item in data]
    if not isinstance(data, dict):
        return data
    if len(data) != 1:
        raise Unfit("not a marked value")
    [(mark, content)] = data.items()
    if mark in (LENT, GENERATOR):
        return find(mark, content)
    if mark == OTHER:
        return make_other(content)
    if mark in (TUPLE, DICT) and isinstance(content, list):
        items = [decode(item, find, deep + 1) for item in content]
        return tuple(items) if mark == TUPLE else as_dict(items)
    if mark == ARRAY:
        return as_array(content)
    raise Unfit(f"no mark {str(mark)[:20]!r}")


def as_dict(pairs: list[Any]) -> dict[Any, Any]:
    """A dict of its pairs. Raises Unfit."""
    try:
        return dict(pairs)
    except (TypeError, ValueError) as error:
        raise Unfit("not a dict") from error


def as_array(content: Any) -> Any:
    """An array of its shape, kind and numbers; without dimensions, a number. Raises Unfit."""
    try:
        shape, kind, numbers = content
        if not all(type(number) in (float, int, bool) for number in numbers):
            raise Unfit("not numbers")
        array = np.array(numbers, DTYPES[kind]).reshape(shape)
    except (TypeError, ValueError, KeyError, OverflowError, MemoryError) as error:
        raise Unfit("not an array") from error
    return array if array.ndim else array[()]


def read_state(generator: Any) -> Any:
    """The state of a generator of numpy, of today's or of the older kind, as JSON data."""
    if isinstance(generator, np.random.RandomState):
        return plain_state(generator.get_state(legacy=False))
    return plain_state(generator.bit_generator.state)


def generator_of(state: Any) -> Any:
    """A new generator of the kind of a state. Raises Unfit."""
    kinds = ("PCG64", "PCG64DXSM", "MT19937", "Philox", "SFC64")
    if not isinstance(state, dict) or state.get("bit_generator") not in kinds:
        raise Unfit("not the state of a generator")
    kind = np.random.RandomState if "has_gauss" in state else np.random.Generator
    generator = kind(getattr(np.random, state["bit_generator"])(0))
    set_state(generator, state)
    return generator


def set_state(generator: Any, state: Any) -> None:
    """Give a generator a state. Raises Unfit."""
    try:
        check_used(state)
        if isinstance(generator, np.random.RandomState):
            generator.set_state(restore_arrays(state))
        else:
            generator.bit_generator.state = restore_arrays(state)
    except (TypeError, ValueError, LookupError, OverflowError, RecursionError) as error:
        raise Unfit("not the state of a generator") from error


def check_used(state: Any) -> None:
    """Raise Unfit where a generator of this state would read memory that is not its own."""
    kind = state["bit_generator"]
    if kind not in MOST_USED:
        return
    used = state["state"]["pos"] if kind == "MT19937" else state["buffer_pos"]
    if type(used) is not int or not 0 <= used <= MOST_USED[kind]:
        raise Unfit("not the state of a generator")


def restore_arrays(state: Any) -> Any:
    """The state that `plain_state` wrote."""
    if isinstance(state, dict):
        return {name: restore_arrays(part) for name, part in state.items()}
    return np.array(state, np.uint64) if isinstance(state, list) else state
