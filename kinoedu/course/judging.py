"""From a program's outcomes to one report: what holds, the smallest case that fails, and what was
probably misunderstood.

The cases are judged where the truth is; the outcomes may come from this process, from a sandbox, or
from a file.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..support.time_limit import Bounded, within_processor_time
from .exercise import CONTRACT, Case, Exercise, ValueExercise, Verdict
from .outcomes import Answer, Changed, Late, Outcome, Raised, outcome_of
from .plain import WrongShape
from .shapes import Shape, Truth


@dataclass(frozen=True)
class Judged:
    """One case and its number, what came, what the judge said; and where that is wrong the slip
    that answers just so, or "".
    """

    case: Case
    outcome: Outcome
    verdict: Verdict
    slip: str = ""
    number: int = 0


@dataclass(frozen=True)
class Report:
    """What a program is worth.

    survived : the cases that were right, for each kind. failed : the kinds with a case that was
        wrong or that was not reached.
    failure : the smallest case that failed, or None.
    """

    exercise: Exercise
    survived: dict[str, int] = field(default_factory=dict)
    failed: tuple[str, ...] = ()
    failure: Judged | None = None

    @property
    def unwritten(self) -> str:
        """The function that nobody has written yet: this exercise's, or one that it calls; "" where
        there is none.
        """
        if self.failure is None or not is_unwritten(self.failure.outcome):
            return ""
        return getattr(self.failure.outcome, "function", "") or self.exercise.name

    @property
    def is_right(self) -> bool:
        """Whether every kind of input is answered right."""
        return not self.failed

    @property
    def score(self) -> float:
        """The share of the kinds of input that are answered right, 0 to 1."""
        return 1.0 - len(self.failed) / len(self.exercise.kinds)


def attempt(
    exercise: Exercise,
    function: Callable[..., Any],
    case: Case,
    bounded: Bounded = within_processor_time,
) -> Outcome:
    """Call a student's function on a copy of a case."""
    return attempted(exercise, function, exercise.given.encode(case.given), bounded)


def attempted(
    exercise: Exercise, function: Callable[..., Any], data: dict[str, Any], bounded: Bounded
) -> Outcome:
    """Call a student's function on a case's arguments, which are JSON data here. This is all that
    ever runs student code.
    """
    given = exercise.given.decode(data)
    outcome = outcome_of(
        lambda: exercise.call(function, dict(given)), exercise.answer, exercise.seconds, bounded
    )
    changed = [
        name
        for name, value in given.items()
        if not same_data(exercise.given.fields[name], value, data[name])
    ]
    return Changed(changed) if isinstance(outcome, Answer) and changed else outcome


def same_data(shape: Shape, value: Any, data: Any) -> bool:
    """Whether a value is still what JSON data say."""
    try:
        return bool(shape.encode(value) == data)
    except WrongShape:
        return False


def report_on(exercise: Exercise, cases: Iterable[Case], outcomes: Iterable[Outcome]) -> Report:
    """Judge outcomes in the order of their cases. Asks for no more after one that came too late or
    was not written yet; a kind of which some case was not reached is not right, so that nobody
    gains by giving up.
    """
    right, all_cases = dict.fromkeys(exercise.kinds, 0), list(cases)
    seen: list[Judged] = []
    for number, (case, outcome) in enumerate(zip(all_cases, outcomes, strict=False)):
        verdict = exercise.judge(case, outcome)
        seen.append(Judged(case, outcome, verdict, number=number))
        right[case.kind] += verdict.is_right
        if isinstance(outcome, Late) or is_unwritten(outcome):
            break
    failures = [one for one in seen if not one.verdict.is_right]
    broken = {failure.case.kind for failure in failures} | {
        case.kind for case in all_cases[len(seen) :]
    }
    if not any(one.verdict.is_right and isinstance(one.outcome, Answer) for one in seen):
        broken = set(exercise.kinds)  # to refuse every input is not to refuse the wrong ones
    failed = tuple(kind for kind in exercise.kinds if kind in broken or not right[kind])
    if not failures:
        return Report(exercise, right, failed)
    first = replace(failures[0], slip=slip_in(exercise, failures, seen))
    return Report(exercise, right, failed, first)


def slip_in(exercise: Exercise, failures: list[Judged], seen: list[Judged]) -> str:
    """The misconception that explains every failure of the first one's kind and half of all, and
    the most of what was seen.

    A wrong yes or no is explained by many: there it must explain all that was seen. What is right
    but for the contract needs none.
    """
    if failures[0].verdict.rule == CONTRACT:
        return ""
    first = failures[0].case.kind
    explained = {
        slip: [explains(exercise, slip.answer, one) for one in failures] for slip in exercise.slips
    }
    likely = [
        slip
        for slip, told in explained.items()
        if 2 * sum(told) >= len(failures)
        and all(yes or one.case.kind != first for yes, one in zip(told, failures))
    ]
    if isinstance(exercise.answer, Truth):
        likely = [
            slip for slip in likely if all(explains(exercise, slip.answer, one) for one in seen)
        ]
    if not likely:
        return ""
    return max(
        likely, key=lambda slip: sum(explains(exercise, slip.answer, one) for one in seen)
    ).key


def is_unwritten(outcome: Outcome) -> bool:
    """Whether a student has not written the function yet, or one that it calls."""
    return isinstance(outcome, Raised) and outcome.is_unwritten


def explains(exercise: Exercise, mistaken: Callable[..., Any], failure: Judged) -> bool:
    """Whether a misconception gives the very answer that a student's program gave."""
    if not isinstance(exercise, ValueExercise) or not isinstance(failure.outcome, Answer):
        return False
    if isinstance(exercise.truth(failure.case), ValueError):
        return False
    with np.errstate(all="ignore"):
        try:
            return exercise.same(failure.outcome.value, mistaken(*failure.case.given.values()))
        except (ValueError, ZeroDivisionError):
            return False
