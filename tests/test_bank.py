"""The bank of wrong answers: each is rejected for its own reason, with cases sent as JSON."""

import json
from functools import lru_cache
from pathlib import Path

import pytest
from judged_programs import ENDLESS, take_few_cases

from kinoedu import messages
from kinoedu.course import EXERCISES
from kinoedu.course.bank import Solutions, read_bank
from kinoedu.course.feedback import Feedback, rule_message
from kinoedu.course.judging import judge_until_failure, run_encoded_case
from kinoedu.course.lessons import find
from kinoedu.course.outcomes import Late, Raised, decode_outcome, encode_outcome
from kinoedu.figures.plane import plane_figure
from kinoedu.support.time_limit import run_within_processor_time

HOUSE = Path(__file__).resolve().parent.parent
BANK = [
    item for file in sorted((HOUSE / "solutions" / "bank").glob("*.py")) for item in read_bank(file)
]
FIRST_OF_ITS_SLIP = [
    next(item for item in BANK if (item.exercise, item.slip) == pair)
    for pair in {(item.exercise, item.slip): None for item in BANK}
]


@lru_cache(maxsize=1)
def cases_of(exercise):
    """Cases of an exercise, few of a variant, and their arguments as JSON by the cases' ids."""
    few = take_few_cases(exercise) if exercise.variant else None
    cases = few or exercise.fixed_cases
    return cases, {
        id(case): json.dumps(exercise.given.encode(case.given), allow_nan=False) for case in cases
    }


def travelled(exercise, function, sent):
    """Outcome of a call, with case and outcome encoded as JSON."""
    outcome = run_encoded_case(exercise, function, json.loads(sent), run_within_processor_time)
    return decode_outcome(
        json.loads(json.dumps(encode_outcome(outcome, exercise.answer), allow_nan=False)),
        exercise.answer,
    )


@pytest.mark.parametrize("item", BANK, ids=lambda item: f"{item.exercise}-{item.name}")
def test_a_wrong_answer_is_rejected_with_its_reason(item, monkeypatch):
    """Every program fails, its misconception is recognised, and the first failing case is drawn."""
    exercise = find(item.exercise, item.variant)
    cases, given = cases_of(exercise)
    is_endless = item.name in ENDLESS
    monkeypatch.setattr(type(exercise), "seconds", 0.5 if is_endless else 4.0)
    report = judge_until_failure(
        exercise, cases, lambda case: travelled(exercise, item.function, given[id(case)])
    )
    assert not report.is_right
    assert not is_accident(report.failure.outcome)
    assert report.score < 1.0
    assert isinstance(report.failure.outcome, Late) == is_endless
    assert report.failure.slip == item.slip
    assert rule_message(exercise, report.failure)
    assert messages.get_message("check.hint") in repr(Feedback(report))
    assert messages.get_message("check.hint") in Feedback(report)._repr_html_()
    if item in FIRST_OF_ITS_SLIP:
        figure, ax = plane_figure()
        figure.set_layout_engine("none")  # it would take most of the time, and what is drawn counts
        exercise.draw(report.failure.case, report.failure.outcome, ax)
        ax.xaxis.set_visible(False)  # ticks take most of the time, and the case counts
        ax.yaxis.set_visible(False)
        figure.draw_without_rendering()


def is_accident(outcome):
    """Whether a program failed because the bank names what is not there, and not by its mistake."""
    if not isinstance(outcome, Raised) or not outcome.kinds:
        return False
    missing = ("NameError", "ImportError", "ModuleNotFoundError")
    return outcome.kinds[0] in missing or "'module' object is not callable" in outcome.message


@pytest.mark.parametrize("exercise", EXERCISES.values(), ids=list(EXERCISES))
def test_every_exercise_has_a_bank(exercise):
    """At least six wrong answers, and one for every named misconception."""
    mine = [item for item in BANK if item.exercise == exercise.name and not item.variant]
    assert len(mine) >= 6
    assert {slip.key for slip in exercise.slips} <= {item.slip for item in mine}


def test_a_change_that_does_not_fit_its_solution_is_an_error():
    """A text that does not occur, or more than once, is named with the number of times."""
    solutions = Solutions(HOUSE / "solutions" / "04_graph_search.ipynb")
    with pytest.raises(ValueError, match="'pop' must occur once in dfs_path, not 0 times"):
        solutions.changed("dfs_path", ("pop", "popleft"))
    with pytest.raises(ValueError, match="'parent' must occur once in dfs_path, not 3 times"):
        solutions.changed("dfs_path", ("parent", "seen"))
