"""Grade a submission: run it in the sandbox, judge the outcomes, record scores and reasons."""

from collections.abc import Sequence
from typing import Any

from ...course.feedback import hint_message, rule_message
from ...course.judging import JudgedCase, Report, judge_outcomes
from ...course.outcomes import Late, Outcome, encode_outcome
from ...course.shapes import Maybe, Truth
from ...messages import get_message
from ..assignments.questions import Assignment, AssignmentQuestion, Cases, draw_cases
from ..collect.notebook import Cell, UnreadableSubmission, read_cells
from ..sandbox.sandbox import Sandbox
from .answers import Answers, Question, is_stopped, run_program

RIGHT, PARTLY, WRONG = "right", "partly right", "wrong"
UNANSWERED, LATE, STOPPED = "not answered", "too late", "stopped"
Grade = dict[str, Any]  # JSON data: the record of a graded submission or question


def grade(
    data: bytes, task: Assignment, secret: bytes, sandbox: Sandbox, *, patience: float = 1.0
) -> Grade:
    """Grade the bytes of a notebook.

    Returns
    -------
    dict
        "status", "message", "questions" and "cells". Each question has its score, what the student
        may read, and the case that failed if everybody has seen that case.

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
            "questions": [make_blank_record(asked) for asked in task.questions],
            "cells": [],
        }
    asked = {
        one.exercise.name: (one, draw_cases(one.exercise.name, secret, one.exercise.variant))
        for one in task.questions
    }
    to_ask = [Question(one.exercise, *known) for one, known in asked.values()]
    found = run_program(sandbox, cells, to_ask, task.lent, patience=patience)
    questions = [
        judge_question(one, known, found.outcomes[name]) for name, (one, known) in asked.items()
    ]
    return {
        "status": "graded",
        "message": "",
        "questions": questions,
        "cells": encode_troubles(found, cells),
    }


def make_blank_record(asked: AssignmentQuestion) -> Grade:
    """The record of a question without an answer."""
    variant = {"variant": asked.exercise.variant} if asked.exercise.variant else {}
    return variant | {
        "question": asked.exercise.name,
        "score": 0.0,
        "max_score": asked.points,
        "status": UNANSWERED,
        "message": get_message("grading.unanswered", name=asked.exercise.name),
        "failure": None,
        "late": False,
    }


def judge_question(
    asked: AssignmentQuestion, known: Cases, outcomes: Sequence[Outcome] | None
) -> Grade:
    """The record of a question with its outcomes."""
    if not outcomes:
        return make_blank_record(asked)
    report = judge_outcomes(asked.exercise, known.cases, outcomes)
    if report.unwritten and report.failure is not None and report.failure.number == 0:
        return make_blank_record(asked)
    late = any(isinstance(outcome, Late) for outcome in outcomes)
    record = make_blank_record(asked) | {
        "score": asked.points * report.score,
        "status": name_status(report),
        "message": get_message("grading.right"),
        "late": late,
    }
    if report.failure is None:
        return record
    return record | describe_failure(asked, report, hidden=report.failure.number >= known.seen)


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


def describe_failure(asked: AssignmentQuestion, report: Report, *, hidden: bool) -> Grade:
    """What a student may know of a failure: rule, hint, and the case unless it is hidden."""
    failure, exercise = report.failure, asked.exercise
    assert failure is not None
    shown = None if hidden else encode_failure(report)
    note = " " + get_message("grading.hidden") if hidden else ""
    return {
        "message": rule_message(exercise, failure) + note,
        "hint": hint_message(exercise, failure),
        "failure": shown,
        "kinds": list(report.failed),
        "reason": name_reason(failure),
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


def encode_troubles(found: Answers, cells: list[Cell]) -> list[Grade]:
    """The cells that failed, for the student."""
    numbers = {cell.number for cell in cells}
    nothing = Maybe(Truth())
    return [
        {"cell": number, "trouble": encode_outcome(outcome, nothing)}
        for number, outcome in sorted(found.troubles.items())
        if number in numbers
    ]


def is_late(record: Grade) -> bool:
    """Whether something took too long; the cause may be a slow or busy machine."""
    cells = [trouble["trouble"]["kind"] for trouble in record["cells"]]
    return "Late" in cells or any(question["late"] for question in record["questions"])
