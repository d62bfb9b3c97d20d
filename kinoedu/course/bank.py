"""The bank of wrong answers: plausible wrong programs that each exercise must reject.

Each program is wrong for a reason of its own. A bank is a Python file that only instructors have,
beside the solutions. It holds functions marked `@wrong("name_of_the_exercise")`.
"""

import runpy
from collections.abc import Callable
from os import PathLike
from typing import Any, NamedTuple


class Wrong(NamedTuple):
    """A wrong program, its exercise, and the misconception that a check must recognise, or ""."""

    exercise: str
    slip: str
    function: Callable[..., Any]


def wrong(exercise: str, slip: str = "") -> Callable[[Callable[..., Any]], Wrong]:
    """Mark a function of a bank as a wrong answer to an exercise.

    Returns
    -------
    Callable
        A decorator; the decorated function becomes a `Wrong`.
    """
    return lambda function: Wrong(exercise, slip, function)


def read_bank(path: str | PathLike[str]) -> list[Wrong]:
    """Read the wrong answers of a bank, in the order of the file.

    The file is executed: read only banks that you trust.

    Returns
    -------
    list of Wrong
    """
    return [item for item in runpy.run_path(str(path)).values() if isinstance(item, Wrong)]
