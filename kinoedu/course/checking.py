"""`check(my_function)`: judge a student's function here and now, in the notebook."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ..errors import InvalidParameter
from .exercise import Case, Exercise
from .exercises import find
from .feedback import ALL, Feedback, stage_of
from .judging import Report, attempt, report_on
from .outcomes import Outcome

PASSED: set[str] = set()  # the exercises that were right in this session: their sources are no secret any more


def check(function: Callable[..., Any], exercise: str = "", *, staged: bool = False) -> Feedback:
    """Judge a function; the answer shows itself in a notebook.

    Parameters
    ----------
    function : yours. Its name says which exercise it answers; or say it with `exercise`.
    staged : tell only the rule that was broken at first; with each further try that is wrong in another way also the smallest case,
        then its picture, then a hint.

    >>> from kinoedu.geometry import point_line_distance
    >>> check(point_line_distance).report.score
    1.0
    """
    if not callable(function):
        raise InvalidParameter(f"check() takes your function, as in check(point_line_distance), and got {function!r}")
    asked = find(exercise or getattr(function, "__name__", ""))
    cases = list(asked.cases(np.random.default_rng(0)))
    report = report_on(asked, cases, attempts(asked, function, cases))
    if report.is_right:
        PASSED.add(asked.name)
    return Feedback(report, stage_of(report) if staged else ALL)


def attempts(exercise: Exercise, function: Callable[..., Any], cases: list[Case]) -> Iterator[Outcome]:
    """The outcome of each case, run when it is asked for."""
    return (attempt(exercise, function, case) for case in cases)


__all__ = ["PASSED", "Report", "check"]
