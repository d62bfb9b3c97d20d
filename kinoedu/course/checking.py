"""`check(my_function)`: judge a student's function in the notebook."""

from __future__ import annotations

import io
import warnings
from collections.abc import Callable
from contextlib import redirect_stdout
from dataclasses import replace

import numpy as np

from ..errors import InvalidParameter
from ..messages import get_message
from .advice import default_sizes
from .exercise import Case, Exercise
from .feedback import ALL, Feedback, advance_stage
from .judging import judge_until_failure, run_case
from .lessons import find
from .outcomes import Outcome
from .plain import describe_value
from .shrinking import shrink

# exercises that passed in this session; their sources may be shown
PASSED: set[str] = set()


class OutputBuffer(io.StringIO):
    """A buffer that keeps the first few thousand characters that a function prints."""

    def write(self, text: str) -> int:
        """Keep as much of the text as there is room for."""
        super().write(text[: max(0, 2000 - self.tell())])
        return len(text)


def check(
    function: Callable[..., object], exercise: str = "", *, variant: str = "", staged: bool = False
) -> Feedback:
    """Judge a student's function and return the feedback, which a notebook displays.

    Parameters
    ----------
    function : Callable
        The student's function. Its name says which exercise it answers, unless `exercise` is given.
    exercise : str
        The name of the exercise, where the function has another name.
    variant : str
        The name of the student's own contract, where the notebook assigns one.
    staged : bool
        Show only the broken rule at first. Each new wrong answer also reveals the next of: the
        smallest failing case, its picture, a hint.

    Returns
    -------
    Feedback

    Raises
    ------
    InvalidParameter
        Where `function` is not callable, or the exercise or the variant does not exist.

    Examples
    --------
    >>> from kinoedu.geometry import point_line_distance
    >>> check(point_line_distance).report.score
    1.0
    """
    if not callable(function):
        raise InvalidParameter(get_message("check.no_function", what=describe_value(function)))
    name = exercise or getattr(function, "__name__", "")
    judged_exercise = find(name if isinstance(name, str) else "", variant)
    cases = judged_exercise.fixed_cases
    printed: dict[int, str] = {}  # by the identity of the case

    def run(case: Case) -> Outcome:
        outcome, printed[id(case)] = run_quietly(judged_exercise, function, case)
        return outcome

    sizes = default_sizes(function)
    report = judge_until_failure(judged_exercise, cases, run)
    if report.failure is None:
        PASSED.add(judged_exercise.name)
        return Feedback(report)
    smallest = shrink(judged_exercise, report.failure, run)
    stage = advance_stage(report) if staged else ALL
    advice = "shared_default" if default_sizes(function) != sizes else ""
    return Feedback(replace(report, failure=smallest), stage, printed[id(smallest.case)], advice)


def run_quietly(
    exercise: Exercise, function: Callable[..., object], case: Case
) -> tuple[Outcome, str]:
    """Call a student's function on a case, with its warnings hidden.

    Returns
    -------
    The outcome, and what the function printed.
    """
    printed = OutputBuffer()
    with redirect_stdout(printed), np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        outcome = run_case(exercise, function, case)
    return outcome, printed.getvalue()
