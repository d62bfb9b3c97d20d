"""Grade a submission: run it in the sandbox, judge the outcomes, record scores and reasons."""

import sys
import time
from collections.abc import Callable, Container, Iterator, Sequence
from typing import Any

from ...course.feedback import hint_message, rule_message
from ...course.judging import JudgedCase, Report, judge_outcomes
from ...course.outcomes import Late, Outcome, encode_outcome
from ...messages import get_message
from ...support.memory import bounded_memory
from ...support.time_limit import TimeUp, run_within_thread_time, slowdown
from ..assignments.questions import (
    Assignment,
    AssignmentQuestion,
    Cases,
    draw_cases,
    draw_trivial_kinds,
)
from ..collect.left_out import find_left_out
from ..collect.notebook import Cell, UnreadableSubmission, python_of, read_cells
from ..sandbox.cells import Failure, find_names, is_placeholder, parse_cell
from ..sandbox.sandbox import Sandbox
from ..sandbox.talk import LONGEST
from .answers import (
    NO_VALUE,
    Answers,
    Question,
    is_stopped,
    is_used_up,
    leave_out_stopped,
    run_program,
)
from .as_checked import find_cells_as_checked

RIGHT, PARTLY, WRONG = "right", "partly right", "wrong"
UNANSWERED, LATE, STOPPED, SYNTAX = "not answered", "too late", "stopped", "syntax error"
JUDGING = 60.0  # seconds of processor time in which the answers to a question are judged
MEMORY = 2**31  # bytes that judging may use beyond those that are in use
JUDGED_TOO_LONG = "rules.judging"
OURS = sys.version_info[:2]  # of Python; a newer one may know more
PYTHON = ".".join(map(str, OURS))
Grade = dict[str, Any]  # JSON data: the record of a graded submission or question


def grade(
    data: bytes, task: Assignment, secret: bytes, sandbox: Sandbox, *, patience: float = 1.0
) -> Grade:
    """Grade the bytes of a notebook.

    Functions are called after all cells have run. If a cell below a question's check changes what
    the function uses, it is also called as its check saw it, and the better result counts. All
    these calls together have as much time as one program; those that come too late are marked.

    Returns
    -------
    dict
        "status", "message", "questions", "cells" and "left_out". Each question has its score, what
        the student may read, and the case that failed if everybody has seen that case. "python" is
        the version that graded, if the notebook was run with a newer one.

    Raises
    ------
    NoSandbox
        Where the sandbox does not start or breaks; nothing else is raised.
    """
    try:
        cells = read_cells(data)
    except UnreadableSubmission as trouble:
        return {
            "status": "unreadable",
            "message": str(trouble),
            "questions": [make_blank_record(question) for question in task.questions],
            "cells": [],
            "left_out": [],
        }

    how = (secret, task.lent, patience)
    records, answers = ask_questions(sandbox, cells, task.questions, *how)
    wrong = [record["question"] for record in records if record["status"] != RIGHT]
    as_checked = find_cells_as_checked(wrong, cells)

    def ask_as_checked(name: str) -> Grade:
        above = list(leave_out_stopped(as_checked[name], answers))
        asked = [one for one in task.questions if one.exercise.name == name]
        (record,), _ = ask_questions(sandbox, above, asked, *how)
        return record

    seconds = LONGEST * patience * slowdown()
    records = list(take_better(records, as_checked, ask_as_checked, seconds))
    theirs = python_of(data)
    errors = find_syntax_errors(cells, theirs)
    return ({"python": PYTHON} if theirs > OURS else {}) | {
        "status": "graded",
        "message": "",
        "questions": [describe_syntax_error(record, errors) for record in records],
        "cells": encode_troubles(answers, cells),
        "left_out": [one._asdict() for one in find_left_out(cells)],
    }


def take_better(
    records: list[Grade], names: Container[str], ask: Callable[[str], Grade], seconds: float
) -> Iterator[Grade]:
    """Yield the records, or those of the questions as their checks saw them where they are better.

    names : the questions to ask so.
    seconds : after which no more are asked. These count as late, so that the notebook is graded
        again with more time.
    """
    until = time.monotonic() + seconds
    for record in records:
        if record["question"] not in names:
            yield record
        elif time.monotonic() > until:
            yield record | {"late": True}
        else:
            again = ask(record["question"])
            better = max(record, again, key=lambda one: one["score"])
            yield better | {"late": record["late"] or again["late"]}


def ask_questions(
    sandbox: Sandbox,
    cells: list[Cell],
    questions: Sequence[AssignmentQuestion],
    secret: bytes,
    lent: tuple[str, ...],
    patience: float,
) -> tuple[list[Grade], Answers]:
    """The records of some questions, and what came back from the program. Raises NoSandbox."""
    exercises = [question.exercise for question in questions]
    drawn_from = [(exercise.name, secret, exercise.variant) for exercise in exercises]
    cases = [draw_cases(*whose) for whose in drawn_from]
    to_run = [Question(exercise, *drawn) for exercise, drawn in zip(exercises, cases, strict=True)]
    answers = run_program(sandbox, cells, to_run, lent, patience=patience)
    records = [
        judge_in_time(
            question,
            drawn._replace(cases=answers.cases[question.exercise.name]),
            answers.outcomes.get(question.exercise.name),
            draw_trivial_kinds(*whose),
            patience,
        )
        for question, drawn, whose in zip(questions, cases, drawn_from, strict=True)
    ]
    return records, answers


def make_blank_record(question: AssignmentQuestion) -> Grade:
    """The record of a question without an answer."""
    variant = {"variant": question.exercise.variant} if question.exercise.variant else {}
    return variant | {
        "question": question.exercise.name,
        "score": 0.0,
        "max_score": question.points,
        "status": UNANSWERED,
        "message": get_message("grading.unanswered", name=question.exercise.name),
        "failure": None,
        "late": False,
    }


def find_syntax_errors(cells: list[Cell], theirs: tuple[int, ...] = ()) -> dict[str, str]:
    """The functions whose last definition is not Python, each with its place and the reason.

    theirs : the version of Python that the notebook was run with.
    """
    found: dict[str, str] = {}
    versions = {"theirs": ".".join(map(str, theirs)), "ours": PYTHON}
    newer = f" {get_message('grading.newer_python', **versions)}" if theirs > OURS else ""
    for cell in cells:
        for part in parse_cell(cell.source, f"cell {cell.number}"):
            if not isinstance(part, Failure) and is_placeholder(part):
                continue
            names = part.names if isinstance(part, Failure) else find_names(part)
            for name in names:
                found.pop(name, None)
            if isinstance(part, Failure):
                reason = part.error.msg if isinstance(part.error, SyntaxError) else str(part.error)
                place = {"cell": cell.number, "line": part.line, "reason": reason}
                for name in names:
                    found[name] = get_message("grading.syntax", name=name, **place) + newer
    return found


def describe_syntax_error(record: Grade, errors: dict[str, str]) -> Grade:
    """The record of a question, which names the syntax error if that is why it has no answer."""
    if record["status"] != UNANSWERED or record["question"] not in errors:
        return record
    return record | {"status": SYNTAX, "message": errors[record["question"]]}


def judge_in_time(
    question: AssignmentQuestion,
    cases: Cases,
    outcomes: Sequence[Outcome] | None,
    trivial: frozenset[frozenset[str]],
    patience: float = 1.0,
) -> Grade:
    """The record of a question, without points if its outcomes cannot be judged in time and memory.

    Nor if the judge fails on them: no answer keeps the others from being graded.
    """
    try:
        with bounded_memory(MEMORY):
            return run_within_thread_time(
                JUDGING * patience * slowdown(),
                lambda: judge_question(question, cases, outcomes, trivial),
            )
    except TimeUp:
        return make_blank_record(question) | {
            "status": STOPPED,
            "message": question.exercise.message("rules.judging"),
            "hint": question.exercise.message("hints.judging"),
            "reason": JUDGED_TOO_LONG,
        }
    except Exception as error:
        return make_blank_record(question) | {
            "status": STOPPED,
            "message": get_message("grading.judge_failed", kind=type(error).__name__),
            "reason": "rules.judge_failed",
        }


def judge_question(
    question: AssignmentQuestion,
    cases: Cases,
    outcomes: Sequence[Outcome] | None,
    trivial: frozenset[frozenset[str]] = frozenset(),
) -> Grade:
    """The record of a question with its outcomes."""
    if not outcomes:
        return make_blank_record(question)
    report = judge_outcomes(question.exercise, cases.cases, outcomes, trivial)
    if report.unwritten and report.failure is not None and report.failure.number == 0:
        return make_blank_record(question)
    late = any(isinstance(outcome, Late) for outcome in outcomes)
    record = make_blank_record(question) | {
        "score": round(question.points * report.score, 9),
        "status": name_status(report),
        "message": get_message("grading.right"),
        "late": late,
        "passed": list(report.passed),
        "untried": list(report.untried),
    }
    if report.is_right:
        return record
    if report.failure is None:
        return record | {"message": get_message("grading.untried", name=question.exercise.name)}
    return record | describe_failure(question, report, hidden=report.failure.number >= cases.seen)


def name_status(report: Report) -> str:
    """A report's status, in a word or two."""
    if report.is_right:
        return RIGHT
    if report.score > 0.0:
        return PARTLY
    outcome = report.failure.outcome if report.failure is not None else None
    if isinstance(outcome, Late):
        return LATE
    return STOPPED if outcome is not None and is_stopped(outcome) else WRONG


def describe_failure(question: AssignmentQuestion, report: Report, *, hidden: bool) -> Grade:
    """What a student may know of a failure: rule, hint, and the case unless it is hidden."""
    failure, exercise = report.failure, question.exercise
    assert failure is not None
    found = {"kinds": list(report.failed), "reason": name_reason(failure)}
    if is_used_up(failure.outcome):  # this case is not at fault
        message, hint = get_message("grading.used_up"), get_message("grading.used_up_hint")
        return found | {"message": message, "hint": hint}
    note = " " + get_message("grading.hidden") if hidden else ""
    return found | {
        "message": rule_message(exercise, failure) + note,
        "hint": hint_message(exercise, failure),
        "failure": None if hidden else encode_failure(report),
    }


def name_reason(failure: JudgedCase) -> str:
    """The key of the recognised misconception, or of the broken rule; instructors count these."""
    return f"slips.{failure.slip}" if failure.slip else f"rules.{failure.verdict.rule}"


def encode_failure(report: Report) -> Grade:
    """The failing case and its outcome as JSON data, from which its picture is drawn later."""
    failure, exercise = report.failure, report.exercise
    assert failure is not None
    case = {"kind": failure.case.kind, "given": exercise.given.encode(failure.case.given)}
    return {
        "case": case,
        "outcome": encode_outcome(failure.outcome, exercise.answer),
        "number": failure.number,
        "slip": failure.slip,
    }


def encode_troubles(answers: Answers, cells: list[Cell]) -> list[Grade]:
    """What failed in the cells, for the student."""
    numbers = {cell.number for cell in cells}
    return [
        {
            "cell": number,
            "line": trouble.line,
            "trouble": encode_outcome(trouble.outcome, NO_VALUE),
        }
        for number, troubles in sorted(answers.troubles.items())
        for trouble in troubles
        if number in numbers
    ]


def is_late(record: Grade) -> bool:
    """Whether something took too long; the cause may be a slow or busy machine."""
    cells = [trouble["trouble"]["kind"] for trouble in record["cells"]]
    return "Late" in cells or any(question["late"] for question in record["questions"])


def is_cut_off(record: Grade) -> bool:
    """Whether a time limit had a part in a result."""
    return is_late(record) or any(
        question.get("reason") == JUDGED_TOO_LONG for question in record["questions"]
    )
