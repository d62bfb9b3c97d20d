"""`check(my_function)`: judge a student's function here and now, in the notebook."""

import io
import warnings
from collections.abc import Callable, Iterator
from contextlib import redirect_stdout
from typing import Any

import numpy as np

from ..errors import InvalidParameter
from ..words import say
from .exercise import Case, Exercise
from .feedback import ALL, Feedback, stage_of
from .judging import attempt, report_on
from .lessons import find
from .outcomes import Outcome
from .plain import described

PASSED: set[str] = (
    set()
)  # the exercises that were right in this session: their sources are no secret any more


class Printed(io.StringIO):
    """What a function printed, its first few thousand characters."""

    def write(self, text: str) -> int:
        """Keep what there is room for."""
        super().write(text[: max(0, 2000 - self.tell())])
        return len(text)


def check(
    function: Callable[..., Any], exercise: str = "", *, variant: str = "", staged: bool = False
) -> Feedback:
    """Judge a function; the answer shows itself in a notebook.

    Parameters
    ----------
    function : yours. Its name says which exercise it answers; or say it with `exercise`.
    variant : the name of your own contract, where your notebook gives you one.
    staged : tell only the rule that was broken at first; with each further try that is wrong in
    another way also the smallest case,
        then its picture, then a hint.

    >>> from kinoedu.geometry import point_line_distance
    >>> check(point_line_distance).report.score
    1.0
    """
    if not callable(function):
        raise InvalidParameter(say("check.no_function", what=described(function)))
    name = exercise or getattr(function, "__name__", "")
    asked = find(name if isinstance(name, str) else "", variant)
    cases = list(asked.cases(np.random.default_rng(0)))
    printed: list[Printed] = []
    report = report_on(asked, cases, attempts(asked, function, cases, printed))
    if report.is_right:
        PASSED.add(asked.name)
    said = printed[report.failure.number].getvalue() if report.failure is not None else ""
    return Feedback(report, stage_of(report) if staged else ALL, said)


def attempts(
    exercise: Exercise, function: Callable[..., Any], cases: list[Case], printed: list[Printed]
) -> Iterator[Outcome]:
    """The outcome of each case, run when it is asked for; what the function prints is kept apart,
    warnings are not shown.
    """
    for case in cases:
        printed.append(Printed())
        with redirect_stdout(printed[-1]), np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            outcome = attempt(exercise, function, case)
        yield outcome
