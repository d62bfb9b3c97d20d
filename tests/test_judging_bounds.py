"""Judging takes bounded time: answers that are too large are refused, and judges are stopped."""

import threading
import time

import numpy as np
import pytest

from kinoedu import messages
from kinoedu.course import check
from kinoedu.course.feedback import Feedback
from kinoedu.course.judging import judge_case, judge_outcomes
from kinoedu.course.lessons import EXERCISES
from kinoedu.course.outcomes import Answer, Misshapen
from kinoedu.course.shrinking import shrink
from kinoedu.course.sizes import MOST_NUMBERS
from kinoedu.geometry.paths import path_length
from kinoedu.grading.assignments.questions import AssignmentQuestion, Cases
from kinoedu.grading.judge import submission
from kinoedu.grading.judge.running import is_settled
from kinoedu.support import memory
from kinoedu.support.memory import bounded_memory
from kinoedu.support.time_limit import TimeUp, run_within_thread_time

NO_LIMITS = "this system has no limits of memory"
SECONDS = 5.0  # for the largest answer to a case that is looked at, where the computer is busy


def first_case(name, kind=""):
    """An exercise, and its first case of a kind."""
    exercise = EXERCISES[name]
    cases = exercise.cases(np.random.default_rng(0))
    return exercise, next(case for case in cases if kind in ("", case.kind))


def test_a_long_answer_has_the_wrong_shape():
    """A check and the grader say how many numbers were expected at most, and how many came."""
    exercise, case = first_case("bfs_tree")
    judged = judge_case(exercise, case, Answer([0] * (MOST_NUMBERS + 1)), 0)
    words = "expected at most 10,000 numbers here, got 10,001"
    assert (judged.outcome, judged.verdict.rule) == (Misshapen(words), "shape")
    assert judge_case(exercise, case, Answer([0] * MOST_NUMBERS), 0).verdict.rule != "shape"
    assert words in repr(check(lambda neighbours, start: [0] * 10_001, "bfs_tree"))
    report = judge_outcomes(exercise, [case], [Answer([0] * 10_001)])
    assert report.failure.outcome == Misshapen(words)


@pytest.mark.parametrize("name", ["bug_base", "bug1", "bug2", "inverse_kinematics"])
def test_an_answer_too_large_for_a_picture_has_its_hint(name):
    """Coordinates of 1e200 are wrong, and nothing can draw them."""
    exercise, case = first_case(name)
    answer = Answer(np.full((3, 2), 1e200))
    feedback = Feedback(judge_outcomes(exercise, [case], [answer]))
    assert messages.get_message("check.hint") in repr(feedback)
    assert feedback.picture() is None


def test_an_example_of_ones_own_is_small():
    """Where an exercise asks for the smallest world, a few hundred numbers are enough."""
    exercise, case = first_case("exposing_sight")
    ring = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], float)
    rings = [ring + np.array([3.0 * (i % 8), 3.0 * (i // 8)]) for i in range(51)]
    assert judge_case(exercise, case, Answer(rings), 0).verdict.rule == "shape"


def long_tree(rows):
    """A tree whose nodes all lie beside the start."""
    nodes = np.full((rows, 2), 1.0) + np.arange(rows)[:, None] * 1e-9
    return nodes, np.arange(rows) - 1, None


@pytest.mark.parametrize("name", ["rrt", "rrt_on_terrain"])
def test_a_planner_adds_a_node_for_each_iteration(name):
    """A tree of far more nodes is refused at once, one of the most nodes is judged soon."""
    exercise, case = first_case(name)
    most = exercise.size_limit(case)
    runs = (np.empty((0, 2)), 1, 0), (np.empty((0, 2)), 1, 0)
    for rows in (20_000, most + 1, most):
        began = time.process_time()
        answer = long_tree(rows)
        judged = judge_case(exercise, case, Answer((answer, answer, answer, True, *runs)), 0)
        assert (judged.verdict.rule == "shape") == (rows > most)
        assert not judged.verdict.is_right
        assert time.process_time() - began < SECONDS
    assert f"expected at most {most:,} rows here" in repr(
        judge_case(exercise, case, Answer((long_tree(most + 1),) * 3 + (True, *runs)), 0).outcome
    )


def test_a_walk_in_circles_has_the_hint_of_a_program_that_does_not_end():
    """A guard against an endless loop returns too many rows; the line with `return` is right."""
    exercise, case = first_case("bug2")
    path = np.tile(case.given["start"], (exercise.size_limit(case) + 1, 1))
    feedback = repr(Feedback(judge_outcomes(exercise, [case], [Answer(path)])))
    assert "rows here, got" in feedback
    assert "leave a wall and come back to it for ever" in feedback


def test_a_tree_that_was_given_without_samples_is_judged():
    """A table of right trees draws no sample; that is a fault, and no error of the judge. Where
    the goal is beside the start, a tree needs none.
    """
    for exercise, case in (first_case("rrt", kind) for kind in EXERCISES["rrt"].kinds):
        for rng in range(20):
            answer = exercise.result.decode(
                exercise.result.encode(exercise.source(*{**case.given, "rng": rng}.values()))
            )
            none = (np.empty((0, 0)), 0, 0)
            judged = judge_case(exercise, case, Answer((answer,) * 3 + (True, none, none)), 0)
            assert case.kind in ("same", "room") or not judged.verdict.is_right


def test_a_walk_is_at_most_several_exact_ones():
    """So a bug that circles for ever is refused."""
    exercise, case = first_case("bug1", "one")
    exact = max(exercise.exact_walks(case.given), key=path_length)
    assert exercise.size_limit(case) > 5 * path_length(exact) / case.given["step"]
    path = np.tile(exact, (10_000, 1))
    assert judge_case(exercise, case, Answer(path), 0).verdict.rule == "shape"


def test_judging_is_stopped(monkeypatch):
    """The question has no points, its status is "stopped", and the reason is said."""
    exercise, case = first_case("bfs_tree")

    def judge_for_ever(case, outcome):
        while True:
            pass

    monkeypatch.setattr(type(exercise), "judge", lambda self, *given: judge_for_ever(*given))
    monkeypatch.setattr(submission, "JUDGING", 0.2)
    question = AssignmentQuestion(exercise, 5.0)
    record = submission.judge_in_time(question, Cases([case], 1), [Answer([0])], frozenset())
    assert (record["score"], record["status"]) == (0.0, submission.STOPPED)
    assert record["reason"] == submission.JUDGED_TOO_LONG
    assert "Judging these took too long" in record["message"]
    whole = {"questions": [record], "cells": [], "patience": 2.0}
    assert [is_settled(whole, patience) for patience in (1.0, 2.0, 3.0)] == [True, True, False]


def test_what_a_newer_python_wrote_is_graded_again_by_another_one():
    """The Python that graded it may have taken for an error what it does not know."""
    whole = {"questions": [], "cells": []}
    assert is_settled(whole, 1.0) and is_settled({**whole, "python": submission.PYTHON}, 1.0)
    assert not is_settled({**whole, "python": "3.10"}, 1.0)


def test_time_of_a_thread_counts_whatever_it_calls():
    """Sleeping is free for a while; computing is not, also in functions of the library."""
    assert run_within_thread_time(0.2, lambda: time.sleep(0.5) or 7) == 7

    def compute_for_ever():
        while True:
            pass

    with pytest.raises(TimeUp):
        run_within_thread_time(0.2, compute_for_ever)
    with pytest.raises(ZeroDivisionError):
        run_within_thread_time(0.2, lambda: 1 / 0)


def judge_with(monkeypatch, judge):
    """The record of a question whose judge is replaced."""
    exercise, case = first_case("bfs_tree")
    question = AssignmentQuestion(exercise, 5.0)
    monkeypatch.setattr(submission, "judge_outcomes", judge)
    return submission.judge_in_time(question, Cases([case], 1), [Answer([0])], frozenset())


def test_a_judge_that_takes_too_much_memory_is_stopped(monkeypatch):
    """The question has no points and the reason; the memory is there again afterwards."""
    pytest.importorskip("resource", reason=NO_LIMITS)
    monkeypatch.setattr(submission, "MEMORY", 2**28)
    record = judge_with(monkeypatch, lambda *_: np.ones(2**27))  # a gigabyte
    assert (record["status"], record["score"]) == (submission.STOPPED, 0.0)
    assert "MemoryError" in record["message"]
    assert np.ones(2**26).sum() == 2**26  # half a gigabyte


def test_memory_is_unbounded_after_blocks_of_several_threads():
    """However they overlap."""
    resource = pytest.importorskip("resource", reason=NO_LIMITS)
    before = resource.getrlimit(resource.RLIMIT_AS)
    first, second = threading.Event(), threading.Event()

    def hold(mine, other):
        with bounded_memory(2**30):
            mine.set()
            other.wait(10)

    threads = [
        threading.Thread(target=hold, args=pair) for pair in ((first, second), (second, first))
    ]
    threads[0].start()
    first.wait(10)
    assert resource.getrlimit(resource.RLIMIT_AS) != before
    threads[1].start()
    for thread in threads:
        thread.join()
    assert resource.getrlimit(resource.RLIMIT_AS) == before


def test_an_answer_that_is_too_long_is_not_judged_for_a_smaller_case_either():
    """It has the wrong shape there too, so obstacles can be left out, but for one, which the kind
    of the case may name.
    """
    exercise = next(
        one
        for one in EXERCISES.values()
        if "obstacles" in one.given.fields and one.fixed_cases[-1].given["obstacles"]
    )
    case = next(one for one in exercise.fixed_cases if len(one.given["obstacles"]) > 1)
    too_long = Answer([0.0] * 1_000_000)
    failure = judge_case(exercise, case, too_long, 0)
    assert isinstance(failure.outcome, Misshapen)
    smaller = shrink(exercise, failure, lambda case: too_long)
    assert isinstance(smaller.outcome, Misshapen)
    assert len(smaller.case.given["obstacles"]) == 1


@pytest.mark.skipif(not memory.STATUS.is_file(), reason="only Linux bounds the memory")
def test_a_bound_that_could_not_be_set_leaves_the_next_ones(monkeypatch):
    """As where no more files can be opened: later blocks are bounded all the same."""
    import resource

    usual = resource.getrlimit(resource.RLIMIT_AS)
    with monkeypatch.context() as patch:
        patch.setattr(memory.Path, "read_text", lambda file: "")
        with pytest.raises(IndexError), bounded_memory(2**30):
            pass
    with bounded_memory(2**30):
        assert resource.getrlimit(resource.RLIMIT_AS) != usual
    assert resource.getrlimit(resource.RLIMIT_AS) == usual
