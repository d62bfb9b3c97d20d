"""Programs that solve nothing earn nothing: constants, arguments, and tables of the shown cases."""

import json
from itertools import chain, combinations

import numpy as np
import pytest

from kinoedu.course.drawn import Drawn
from kinoedu.course.exercise import ValueExercise
from kinoedu.course.judging import Report, judge_outcomes, run_case
from kinoedu.course.lessons import EXERCISES
from kinoedu.course.lessons.trees.insert import insert_without_descendants, insert_without_rewiring
from kinoedu.course.outcomes import Raised
from kinoedu.course.trivial import find_trivial_kinds, run_unbounded
from kinoedu.grading.assignments.questions import (
    draw_cases,
    draw_trivial_kinds,
    read_assignment,
)
from kinoedu.grading.judge.submission import RIGHT, WRONG, judge_question

SECRET = bytes(range(32))
ASKED = [exercise for exercise in EXERCISES.values() if exercise.given.fields]
MOST_EARNED = 0.1
MOST_CONSTANTS = 6  # about as many cases give their right answers as constants


def outcome(exercise, function, case):
    """Outcome of a function in this process."""
    with np.errstate(all="ignore"):
        return run_case(exercise, function, case, run_unbounded)


def passed_kinds(exercise, function, cases):
    """The kinds for which a function is right in all cases."""
    failed = set()
    for case in cases:
        if case.kind not in failed:
            verdict = exercise.judge(case, outcome(exercise, function, case))
            failed |= set() if verdict.is_right else {case.kind}
    return [kind for kind in exercise.kinds if kind not in failed]


def points(exercise, passed, trivial):
    """The share of the points for some kinds of input."""
    failed = tuple(kind for kind in exercise.kinds if kind not in passed)
    return Report(exercise, failed=failed, trivial=trivial).score


def constants(exercise, cases):
    """Right answers to cases of all kinds, each once, and the plainest values."""
    found = {}
    if isinstance(exercise, ValueExercise) and exercise.answer != Drawn():
        for case in cases[:: max(1, len(cases) // MOST_CONSTANTS)]:
            truth = exercise.truth(case)
            if not isinstance(truth, ValueError):
                found.setdefault(json.dumps(exercise.answer.encode(truth)), truth)
    return [*found.values(), 0, 0.0, 1.0, True, False, None, [], "", np.inf]


def echoes(exercise):
    """Programs that return an argument, or one of its rows."""
    for at in range(len(exercise.given.fields)):
        yield lambda *given, at=at: given[at]
        yield lambda *given, at=at: given[at][0]
        yield lambda *given, at=at: given[at][-1]
        yield lambda *given, at=at: np.array(given[at])[:, 0]


@pytest.mark.parametrize("exercise", ASKED, ids=lambda exercise: exercise.name)
def test_no_constant_argument_or_table_earns_points(exercise):
    """At most a tenth of them, alone or beside the right answers to the cases that all have seen;
    neither does a program that refuses every input.
    """
    cases, seen = draw_cases(exercise.name, SECRET)
    trivial = draw_trivial_kinds(exercise.name, SECRET)
    of_hidden = {kind for kind in exercise.kinds if any(c.kind == kind for c in cases[seen:])}
    by_table = set(exercise.kinds) - of_hidden if seen else set()

    def refuse(*given):
        raise ValueError

    always = [lambda *given, value=value: value for value in constants(exercise, cases)]
    for program in [*always, *echoes(exercise), refuse]:
        hidden = set(passed_kinds(exercise, program, cases[seen:])) & of_hidden
        everywhere = [k for k in passed_kinds(exercise, program, cases[:seen]) if k in hidden]
        assert points(exercise, everywhere, trivial) <= MOST_EARNED
        assert points(exercise, hidden | by_table, trivial) <= MOST_EARNED


@pytest.mark.parametrize("exercise", ASKED, ids=lambda exercise: exercise.name)
def test_points_follow_from_kinds(exercise):
    """Nothing earns nothing, all kinds earn all points, no kinds earn more than their share, and
    one more kind never costs points.
    """
    trivial = draw_trivial_kinds(exercise.name, SECRET)
    kinds = exercise.kinds
    every = chain.from_iterable(combinations(kinds, size) for size in range(len(kinds) + 1))
    for passed in every:
        earned = points(exercise, passed, trivial)
        assert 0.0 <= earned <= len(passed) / len(kinds)
        more = [points(exercise, {*passed, kind}, trivial) for kind in kinds]
        assert all(earned <= other for other in more)
    assert points(exercise, kinds, trivial) == 1.0
    assert all(set(one) != set(kinds) for one in trivial)


def test_trivial_programs_are_those_that_pass():
    """The kinds of point_segment_distance that 0.0 passes, of a truth value, and of a refusal."""
    found = draw_trivial_kinds("point_segment_distance", SECRET)
    assert frozenset({"on"}) in found
    assert frozenset({"boundary", "inside"}) in draw_trivial_kinds(
        "point_in_convex_polygon", SECRET
    )
    assert frozenset({"coincident"}) in draw_trivial_kinds("line_through_points", SECRET)


def test_a_table_of_the_shown_cases_is_trivial():
    """If all cases of a kind were shown, a table passes this kind."""
    exercise = EXERCISES["circle_distance"]
    cases = draw_cases("circle_distance", SECRET).cases
    last = {case.kind: number for number, case in enumerate(cases)}
    ordered = sorted(cases, key=lambda case: last[case.kind])
    whole = sum(case.kind == ordered[0].kind for case in cases)
    assert any(ordered[0].kind in one for one in find_trivial_kinds(exercise, ordered, whole))


def test_an_exercise_without_arguments_has_no_trivial_programs():
    """Its answer is a constant, and may be right."""
    assert find_trivial_kinds(EXERCISES["exposing_case"], []) == frozenset()


def test_a_constant_gets_no_points_and_the_reason():
    """A constant that is right for two kinds of five is wrong; a real attempt is partly right."""
    question = next(
        one
        for one in read_assignment("07_collision_detection").questions
        if one.exercise.name == "point_in_convex_polygon"
    )
    exercise, cases = question.exercise, draw_cases("point_in_convex_polygon", SECRET)
    trivial = draw_trivial_kinds(exercise.name, SECRET)

    def grade(function):
        found = [outcome(exercise, function, case) for case in cases.cases]
        return judge_question(question, cases, found, trivial)

    always = grade(lambda q, P: True)
    assert (always["score"], always["status"]) == (0.0, WRONG)
    assert set(always["passed"]) == {"boundary", "inside"}
    assert set(always["kinds"]) == set(exercise.kinds) - {"boundary", "inside"}
    right = grade(exercise.source)
    assert (right["score"], right["status"]) == (question.points, RIGHT)


def test_refusing_every_input_still_earns_nothing():
    """Also where a ValueError is right for a kind of input."""
    exercise = EXERCISES["line_through_points"]
    cases = draw_cases(exercise.name, SECRET).cases
    refusal = Raised(["ValueError", "Exception"], "", [], "")
    assert judge_outcomes(exercise, cases, [refusal] * len(cases)).score == 0.0


@pytest.mark.parametrize(
    ("program", "parts"),
    [
        (insert_without_rewiring, ["parent", "blocked"]),
        (insert_without_descendants, ["parent", "rewire", "blocked"]),
    ],
    ids=["without rewiring", "without descendants"],
)
def test_parts_of_the_insertion_earn_their_share(program, parts):
    """Choosing a parent and rewiring are judged by kinds of input that need nothing else."""
    exercise = EXERCISES["insert"]
    passed = passed_kinds(exercise, program, draw_cases("insert", SECRET).cases)
    assert passed == parts
    earned = points(exercise, passed, draw_trivial_kinds("insert", SECRET))
    assert earned == pytest.approx(len(parts) / len(exercise.kinds))
