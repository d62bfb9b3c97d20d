"""The bank of wrong answers: plausible programs that each exercise must reject, each for its own
reason.

A bank is a Python file that only instructors have, beside the solutions: functions marked
`@wrong("name_of_the_exercise")`.
"""

import runpy
from collections.abc import Callable
from os import PathLike
from typing import Any, NamedTuple


class Wrong(NamedTuple):
    """A wrong program, the exercise it answers, and the slip that a check must recognise in it (""
    for none).
    """

    exercise: str
    slip: str
    function: Callable[..., Any]


def wrong(exercise: str, slip: str = "") -> Callable[[Callable[..., Any]], Wrong]:
    """Mark a function of a bank as a wrong answer to an exercise."""
    return lambda function: Wrong(exercise, slip, function)


def read_bank(path: str | PathLike[str]) -> list[Wrong]:
    """The wrong answers of a bank, in the order of the file. Runs the file: it is the instructor's
    own.
    """
    return [item for item in runpy.run_path(str(path)).values() if isinstance(item, Wrong)]
