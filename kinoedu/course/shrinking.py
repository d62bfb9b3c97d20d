"""A failing case without the obstacles that do not matter."""

import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from .exercise import Case, Exercise, Given
from .judging import JudgedCase, judge_case
from .outcomes import Answer, Late, Outcome
from .tasks import problem_of, scene_of
from .withheld import NotInTheKit

SECONDS = 2.0  # in which obstacles are left out; then what is found so far is shown


def shrink(exercise: Exercise, failure: JudgedCase, run: Callable[[Case], Outcome]) -> JudgedCase:
    """Leave out each obstacle without which the program breaks the same rule.

    One stays, since the case's kind may name it.
    A case that the right answer does not solve is none of this exercise and is not taken.

    Parameters
    ----------
    run : calls the student's function on a case.
    """
    if isinstance(failure.outcome, Late):
        return failure
    end = time.monotonic() + SECONDS
    for number in reversed(range(len(failure.case.given.get("obstacles", ())))):
        if len(failure.case.given["obstacles"]) == 1:
            break
        case = failure.case._replace(given=leave_out(failure.case.given, number))
        if time.monotonic() > end:
            break
        if not is_solved(exercise, case):
            continue
        judged = judge_case(exercise, case, run(case), failure.number)
        is_alike = type(judged.outcome) is type(failure.outcome)
        if is_alike and judged.verdict.rule == failure.verdict.rule:
            failure = replace(judged, slip=failure.slip)
    return failure


def leave_out(given: Given, number: int) -> Given:
    """The arguments without an obstacle, also in the problem that they hold."""
    smaller = {**given, "obstacles": without(given["obstacles"], number)}
    if "problem" in given:
        scene = scene_of(given["problem"].problem)
        world = scene["world"]
        world = {**world, "obstacles": without(world["obstacles"], number)}
        smaller["problem"] = problem_of({**scene, "world": world})
    return smaller


def without(things: list[Any], number: int) -> list[Any]:
    """A list without one of its items."""
    return [*things[:number], *things[number + 1 :]]


def is_solved(exercise: Exercise, case: Case) -> bool:
    """Whether the course's own answer to a case is right; False where students do not have it."""
    try:
        given = exercise.given.decode(exercise.given.encode(case.given))
        answer = exercise.answer.encode(exercise.right_answer(*given.values()))
        return exercise.judge(case, Answer(exercise.answer.decode(answer))).is_right
    except (ValueError, ArithmeticError, IndexError, NotInTheKit):
        return False
