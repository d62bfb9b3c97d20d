"""Answers that students get as recorded values, and not as code.

A function marked `@withheld` computes a right answer, or nearly one. In the whole project the mark
changes nothing. The kit for students has the function's signature without its body, and a file with
the results of all calls that the fixed cases of `check` make (`kit.py` writes both). There the mark
looks results up in this file, so `check` judges and hints as it does in the whole project.
"""

import functools
import gzip
import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar

from ..support.json_fields import Json
from .recorded import (
    decode,
    decode_error,
    encode,
    encode_error,
    key_of,
    key_of_bits,
    rounded,
    to_bits,
)

Function = TypeVar("Function", bound=Callable[..., Any])
Results = dict[str, dict[str, Json]]  # by the name of a function and the key of its arguments

FILE = Path(__file__).with_name("recorded_results.json.gz")  # only in the kit


class NotInTheKit(LookupError):
    """The kit for students has no result for this call of a withheld function.

    It is not a KinoeduError, since these are ValueErrors, which can be right answers.
    """


def withheld(function: Function) -> Function:
    """Mark a function whose body students do not get.

    It must not change its arguments, and its result must depend on nothing else.
    """
    lesson = function.__module__.partition(".lessons.")[2]
    return withhold(function, f"{lesson}.{function.__qualname__}")


def withhold(function: Function, name: str) -> Function:
    """The same function, whose calls can be recorded, and are looked up in the kit.

    Parameters
    ----------
    name : the name under which its results are recorded.
    """

    @functools.wraps(function)
    def called(*given: Any, **more: Any) -> Any:
        if IN_THE_KIT:
            return look_up(name, given, more)
        if recording is None:
            return function(*given, **more)
        return record(function, name, given, more)

    called.is_withheld = True  # type: ignore[attr-defined]  # `is_withheld` reads it
    return called  # type: ignore[return-value]  # it has the signature of the function


def is_withheld(function: object) -> bool:
    """Whether a function is withheld from students."""
    return getattr(function, "is_withheld", False)


def not_in_the_kit(*given: Any) -> Any:
    """The function of which the kit has nothing but recorded results."""
    raise NotInTheKit(f"this call has no recorded result: {given!r:.200}")


IN_THE_KIT = FILE.exists()
ERRORS = (ValueError, ArithmeticError, LookupError)  # that are recorded as results
recording: Results | None = None  # where results are being recorded


@contextmanager
def recorded_results() -> Iterator[Results]:
    """Record the results of withheld functions; of nested calls only the outermost."""
    global recording
    recording = results = Results()
    try:
        yield results
    finally:
        recording = None


def record(
    function: Callable[..., Any], name: str, given: tuple[Any, ...], more: dict[str, Any]
) -> Any:
    """Call a withheld function and record its result, which may be an error.

    Raises
    ------
    RuntimeError
        Where the function changes its arguments, or two calls with different results have the same
        key.
    """
    global recording
    results, recording = recording, None
    assert results is not None
    arguments, error, result = to_bits(encode((given, more))), None, None
    try:
        result = function(*given, **more)
    except ERRORS as raised:
        error = raised
    finally:
        recording = results
    data = encode(result) if error is None else encode_error(error)
    if to_bits(encode((given, more))) != arguments:
        raise RuntimeError(f"{name} is withheld, and must not change its arguments")
    known = results.setdefault(name, {}).setdefault(key_of_bits(arguments), data)
    if known is not data and rounded(known) != rounded(data):
        raise RuntimeError(f"two calls of {name} have the same key and different results")
    if error is not None:
        raise error
    return result


@functools.cache
def read_results() -> Results:
    """Read the results that the kit has."""
    with gzip.open(FILE, "rt", encoding="utf-8") as file:
        results: Results = json.load(file)
    return results


def look_up(name: str, given: tuple[Any, ...], more: dict[str, Any]) -> Any:
    """Return the recorded result of a call, or raise the recorded error.

    Raises
    ------
    NotInTheKit
        Where the call was not recorded.
    """
    try:
        data = read_results()[name][key_of((given, more))]
    except LookupError:
        raise NotInTheKit(
            f"this copy of the course is for students; it has no result of {name} for this call"
        ) from None
    if isinstance(data, dict) and "error" in data:
        raise decode_error(data)
    return decode(data)
