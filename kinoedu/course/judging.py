"""Judge a program's outcomes: what is right, the smallest failing case, and the misconception.

Cases are judged in the process that knows the truth. The outcomes may come from that process, from
a sandbox, or from a file.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from ..support.json_fields import JsonObject
from ..support.time_limit import Limiter, run_within_processor_time
from .exercise import CONTRACT, NO_ANSWER, Case, Exercise, Slip, ValueExercise, Verdict
from .outcomes import Answer, Changed, Late, Outcome, Raised, outcome_of
from .plain import WrongShape
from .shapes import Shape, Truth


@dataclass(frozen=True)
class JudgedCase:
    """One case with its number, outcome, verdict, and the misconception that explains it, or ""."""

    case: Case
    outcome: Outcome
    verdict: Verdict
    slip: str = ""
    number: int = 0


@dataclass(frozen=True)
class Report:
    """The result of judging a program.

    Attributes
    ----------
    survived : number of right cases of each kind.
    failed : kinds with a case that was wrong or was not reached.
    right_so_far : kinds with a right case and no wrong one; some of their cases may not be reached.
    failure : the smallest case that failed, or None.
    untried : kinds without a wrong case, of which some cases were not reached.
    trivial : sets of kinds that programs pass which solve nothing (`find_trivial_kinds`).
    """

    exercise: Exercise
    survived: dict[str, int] = field(default_factory=dict)
    failed: tuple[str, ...] = ()
    right_so_far: tuple[str, ...] = ()
    failure: JudgedCase | None = None
    untried: tuple[str, ...] = ()
    trivial: frozenset[frozenset[str]] = frozenset()

    @property
    def unwritten(self) -> str:
        """Name of the function that is not written yet, or "".

        It is this exercise's function, or one that it calls.
        """
        if self.failure is None or not is_unwritten(self.failure.outcome):
            return ""
        return getattr(self.failure.outcome, "function", "") or self.exercise.name

    @property
    def is_right(self) -> bool:
        """Whether the answers to all kinds of input are right."""
        return not self.failed

    @property
    def passed(self) -> tuple[str, ...]:
        """The kinds of input with right answers to all their cases."""
        return tuple(kind for kind in self.exercise.kinds if kind not in self.failed)

    @property
    def score(self) -> float:
        """From 0 to 1: what the answers are worth beside those of every trivial program.

        It is the fraction of the kinds with right answers. Beside a trivial program, only the kinds
        that this one fails are counted. The smallest of these fractions is the score. So a trivial
        program itself gets 0, and an answer that is right for all kinds gets 1.
        """
        passed, kinds = set(self.passed), set(self.exercise.kinds)
        counted = [kinds, *(kinds - one for one in self.trivial if not kinds <= one)]
        return min(len(passed & its) / len(its) for its in counted)


def run_case(
    exercise: Exercise,
    function: Callable[..., object],
    case: Case,
    bounded: Limiter = run_within_processor_time,
) -> Outcome:
    """Call a student's function on a copy of a case.

    Returns
    -------
    Outcome
    """
    return run_encoded_case(exercise, function, exercise.given.encode(case.given), bounded)


def run_encoded_case(
    exercise: Exercise, function: Callable[..., object], data: JsonObject, bounded: Limiter
) -> Outcome:
    """Call a student's function in this process on a case's arguments, given as JSON data.

    Returns
    -------
    Outcome
    """

    def called(*given: Any) -> object:
        return function(*(one.lend() if hasattr(one, "lend") else one for one in given))

    return run_called(exercise, called, data, bounded)


def run_called(
    exercise: Exercise, called: Callable[..., object], data: JsonObject, bounded: Limiter
) -> Outcome:
    """Call a function, which lends problems and axes itself, on a case's arguments.

    Returns
    -------
    Outcome
    """
    given = exercise.given.decode(data)
    outcome = outcome_of(
        lambda: exercise.call(called, dict(given)), exercise.answer, exercise.seconds, bounded
    )
    changed = [
        name
        for name, value in given.items()
        if not is_unchanged(exercise.given.fields[name], value, data[name])
    ]
    return Changed(changed) if isinstance(outcome, Answer) and changed else outcome


def is_unchanged(shape: Shape, value: object, data: object) -> bool:
    """Whether a value still encodes to the given JSON data."""
    try:
        return bool(shape.encode(value) == data)
    except WrongShape:
        return False


def judge_outcomes(
    exercise: Exercise,
    cases: Iterable[Case],
    outcomes: Iterable[Outcome],
    trivial: frozenset[frozenset[str]] = frozenset(),
) -> Report:
    """Judge outcomes in the order of their cases.

    No further outcome is requested after one that came too late, or one of an unwritten function. A
    kind with a case that was not reached counts as failed, so that giving up early never helps.

    Parameters
    ----------
    trivial : the sets of kinds that trivial programs pass in these cases; the score allows for
        them.

    Returns
    -------
    Report
    """
    all_cases, seen = list(cases), list[JudgedCase]()
    for number, (case, outcome) in enumerate(zip(all_cases, outcomes, strict=False)):
        seen.append(judge_case(exercise, case, outcome, number))
        if ends_a_run(outcome):
            break
    report = make_report(exercise, all_cases, doubt_contract(exercise, seen))
    return replace(report, trivial=trivial)


def judge_until_failure(
    exercise: Exercise, cases: Iterable[Case], run: Callable[[Case], Outcome]
) -> Report:
    """Run and judge cases in order up to the first that fails.

    Where a known misconception explains that failure, all cases are run, to see whether it explains
    the others as well. So the failure and its misconception are those of `judge_outcomes`.

    Returns
    -------
    Report
    """
    all_cases, seen, failed = list(cases), list[JudgedCase](), False
    for number, case in enumerate(all_cases):
        outcome = run(case)
        seen.append(judge_case(exercise, case, outcome, number))
        if not seen[-1].verdict.is_right:
            seen = doubt_contract(exercise, seen)
        is_first_failure = not (failed or seen[-1].verdict.is_right)
        failed = failed or is_first_failure
        if ends_a_run(outcome) or (is_first_failure and not likely_slips(exercise, seen)):
            break
    return make_report(exercise, all_cases, seen)


def judge_case(exercise: Exercise, case: Case, outcome: Outcome, number: int) -> JudgedCase:
    """Judge the outcome of one case; a larger answer than the case can need is not looked at."""
    outcome = exercise.bound_size(case, outcome)
    return JudgedCase(case, outcome, exercise.judge(case, outcome), number=number)


def doubt_contract(exercise: Exercise, seen: list[JudgedCase]) -> list[JudgedCase]:
    """The cases seen, in which the first failure breaks the contract only where all may do so.

    A program has the usual form if none of its answers is wrong in the usual form. Otherwise its
    failures break other rules.
    """
    first = next((at for at, one in enumerate(seen) if one.verdict.rule == CONTRACT), None)
    if first is None or all(exercise.is_usual(one.case, one.outcome) for one in seen):
        return seen
    return [
        replace(one, verdict=exercise.judge_own_form(one.case, one.outcome))
        if one.verdict.rule == CONTRACT
        else one
        for one in seen
    ]


def ends_a_run(outcome: Outcome) -> bool:
    """Whether no further case is run after an outcome."""
    return isinstance(outcome, Late) or is_unwritten(outcome)


def make_report(exercise: Exercise, cases: list[Case], seen: list[JudgedCase]) -> Report:
    """Report on the cases seen, of all cases."""
    right = dict.fromkeys(exercise.kinds, 0)
    for one in seen:
        right[one.case.kind] += one.verdict.is_right
    failures = [one for one in seen if not one.verdict.is_right]
    broken = {failure.case.kind for failure in failures}
    unreached = {case.kind for case in cases[len(seen) :]}
    if not any(one.verdict.is_right and isinstance(one.outcome, Answer) for one in seen):
        broken = set(exercise.kinds)  # raising an error for every input earns nothing
    failed = tuple(k for k in exercise.kinds if k in broken | unreached or not right[k])
    so_far = tuple(k for k in exercise.kinds if k not in broken and right[k])
    untried = tuple(k for k in exercise.kinds if k in unreached - broken)
    if not failures:
        return Report(exercise, right, failed, so_far, untried=untried)
    first = replace(failures[0], slip=find_slip(exercise, seen))
    return Report(exercise, right, failed, so_far, first, untried)


def find_slip(exercise: Exercise, seen: list[JudgedCase]) -> str:
    """Key of the misconception that explains most of the cases seen, or "".

    Where some wrong answers have values, it explains one of those: many mistakes give empty
    answers. It explains no program whose answers are all empty.
    """
    values = [
        one for one in seen if isinstance(one.outcome, Answer) and is_definite(one.outcome.value)
    ]
    wrong_values = [one for one in values if not one.verdict.is_right]
    likely = [
        slip
        for slip in likely_slips(exercise, seen)
        if not wrong_values or any(explains(exercise, slip, one) for one in wrong_values)
    ]
    if not likely or not values:
        return ""
    return max(likely, key=lambda slip: sum(explains(exercise, slip, one) for one in seen)).key


def likely_slips(exercise: Exercise, seen: list[JudgedCase]) -> list[Slip]:
    """Misconceptions that may explain the failures among the cases seen.

    Each explains every failure of the first failure's kind and at least half of all failures, and
    contradicts no right answer to the kinds that did not fail. Many misconceptions explain a wrong
    yes or no, so for a truth value each explains every case seen. An answer that breaks only the
    contract has no misconception.
    """
    failures = [one for one in seen if not one.verdict.is_right]
    if not failures or failures[0].verdict.rule == CONTRACT:
        return []
    failing = {one.case.kind for one in failures}
    of_first_kind = [one for one in failures if one.case.kind == failures[0].case.kind]
    passed = [one for one in seen if one.case.kind not in failing]

    def is_likely(slip: Slip) -> bool:
        if isinstance(exercise.answer, Truth):
            return all(explains(exercise, slip, one) for one in seen)
        return (
            all(explains(exercise, slip, one) for one in of_first_kind)
            and 2 * sum(explains(exercise, slip, one) for one in failures) >= len(failures)
            and not any(contradicts(exercise, slip, one) for one in passed)
        )

    return [slip for slip in exercise.slips if is_likely(slip)]


def is_unwritten(outcome: Outcome) -> bool:
    """Whether an outcome shows that a function is not written yet."""
    return isinstance(outcome, Raised) and outcome.is_unwritten


@np.errstate(all="ignore")
def explains(exercise: Exercise, slip: Slip, judged: JudgedCase) -> bool:
    """Whether a misconception gives the same value as the student's program."""
    found = value_of_slip(exercise, slip, judged)
    if found is None or not isinstance(judged.outcome, Answer):
        return False
    assert isinstance(exercise, ValueExercise)
    return exercise.agree(judged.case, judged.outcome.value, found.value)


@np.errstate(all="ignore")
def contradicts(exercise: Exercise, slip: Slip, judged: JudgedCase) -> bool:
    """Whether a misconception gives another value than a program that is right.

    It says nothing where there is no right value, or where it gives no number itself.
    """
    found = value_of_slip(exercise, slip, judged)
    if found is None or not isinstance(judged.outcome, Answer):
        return False
    assert isinstance(exercise, ValueExercise)
    value = judged.outcome.value
    both = is_definite(found.value) and is_definite(value)
    return both and not exercise.agree(judged.case, value, found.value)


def is_definite(value: object) -> bool:
    """Whether a value is not None, not empty, and has no nan."""
    if isinstance(value, tuple | list):
        return len(value) > 0 and all(map(is_definite, value))
    array = np.asarray(value)
    return value is not None and array.size > 0 and bool(np.all(array == array))


def value_of_slip(exercise: Exercise, slip: Slip, judged: JudgedCase) -> Answer | None:
    """The value that a misconception gives in a case; None where none is there to compare."""
    if not isinstance(exercise, ValueExercise) or not isinstance(judged.outcome, Answer):
        return None
    if isinstance(exercise.truth(judged.case), ValueError):
        return None
    found = exercise.mistaken_answer(slip, judged.case)
    return None if isinstance(found, NO_ANSWER) else Answer(found)
