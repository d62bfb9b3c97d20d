"""Programs that solve nothing, and the kinds of input that each of them passes.

A trivial program always gives the same answer, or returns its arguments, or refuses every input; it
may also know the answers to the cases that everybody has seen. Points are given for what an answer
does better than each of these (`Report.score`).
"""

from collections.abc import Callable, Iterator
from itertools import combinations
from typing import TypeVar

import numpy as np

from .exercise import Case, Exercise, ValueExercise
from .judging import judge_case, run_case
from .shapes import Value

T = TypeVar("T")
Program = Callable[..., object]
CONSTANTS: tuple[Value, ...] = (None, False, True, 0, 1, 0.0, 1.0, [])
ROWS = (0, 1, -1)  # rows of an argument that are returned alone


def find_trivial_kinds(
    exercise: Exercise, cases: list[Case], seen: int = 0
) -> frozenset[frozenset[str]]:
    """The sets of kinds that trivial programs pass.

    An exercise without arguments has none: its answer is a constant.

    Parameters
    ----------
    cases : the cases by which answers are judged.
    seen : the number of cases, the first ones, whose right answers a program may know.

    Returns
    -------
    frozenset of frozenset of str
    """
    if not exercise.given.fields:
        return frozenset()
    of_kind = {kind: [one for one in cases[seen:] if one.kind == kind] for kind in exercise.kinds}
    found = set()
    for program in make_trivial_programs(exercise, [one for one in of_kind.values() if one]):
        found.add(
            frozenset(
                kind
                for kind, its in of_kind.items()
                if all(is_right(exercise, program, case) for case in its)
            )
        )
    return frozenset(found)


def make_trivial_programs(exercise: Exercise, kinds: list[list[Case]]) -> Iterator[Program]:
    """Yield the trivial programs of an exercise.

    A constant that is right for a whole kind is right for the kind's first case. So these cases
    give all constants that matter, up to answers to which several others would be right as well.
    """
    yield refuse
    constants = [*CONSTANTS, *(value for its in kinds for value in find_answers(exercise, its[0]))]
    yield from map(return_constant, constants)
    names = list(exercise.given.fields)
    for at in range(len(names)):
        yield return_argument(at)
        yield return_list((at,))
        yield from (return_row(at, row) for row in ROWS)
    yield from map(return_list, combinations(range(len(names)), 2))
    yield from exercise.trivial


def find_answers(exercise: Exercise, case: Case) -> Iterator[Value]:
    """Yield the right answer to a case, if there is one."""
    if isinstance(exercise, ValueExercise):
        if not isinstance(exercise.truth(case), ValueError):
            yield exercise.truth(case)
        return
    given = exercise.given.decode(exercise.given.encode(case.given))
    try:
        yield exercise.right_answer(*given.values())
    except Exception:  # the library answers this call only with help from `call`
        return


def is_right(exercise: Exercise, program: Program, case: Case) -> bool:
    """Whether a trivial program's outcome is right for a case."""
    with np.errstate(all="ignore"):
        outcome = run_case(exercise, program, case, run_unbounded)
        try:
            return judge_case(exercise, case, outcome, 0).verdict.is_right
        except Exception:  # a judge that fails here must not keep a class from being graded
            return False


def run_unbounded(seconds: float, work: Callable[[], T]) -> T:
    """Run work() in place: a trivial program needs no time limit."""
    return work()


def refuse(*given: Value) -> Value:
    """Refuse every input."""
    raise ValueError


def return_constant(value: Value) -> Program:
    """The program that always returns a value."""
    return lambda *given: value


def return_argument(at: int) -> Program:
    """The program that returns one of its arguments."""
    return lambda *given: given[at]


def return_row(at: int, row: int) -> Program:
    """The program that returns a row of one of its arguments."""
    return lambda *given: given[at][row]


def return_list(places: tuple[int, ...]) -> Program:
    """The program that returns a list of some of its arguments."""
    return lambda *given: [given[at] for at in places]
