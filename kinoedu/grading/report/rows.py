"""The grades as a table, GRADES/grades.csv: one row for each question of each submission."""

import difflib
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from ...errors import InvalidParameter
from ...messages import get_message
from ...support.csv_cells import escape_formula, number, write_rows
from ..assignments.questions import read_assignment
from ..judge.class_list import Class, Entry, read_record
from ..judge.submission import Grade
from .decisions import Decision, Decisions

UNREADABLE, NOT_GRADED = "unreadable", "not graded"
BY_HAND, DECIDED = "to grade by hand", "set by hand"
COLUMNS = ("student", "assignment", "question", "score", "max_score", "status", "message")


class Row(NamedTuple):
    """One question of one student.

    score : None while there is none.
    late : whether Canvas marked the submission as late.
    comment : a person's, or "".
    """

    student: str
    assignment: str
    question: str
    score: float | None
    max_score: float
    status: str
    message: str
    late: bool = False
    comment: str = ""


def list_class_rows(of: Class, decisions: Decisions) -> list[Row]:
    """All rows of a class, with people's decisions applied.

    Raises
    ------
    InvalidParameter
        Where a decision matches no row.
    """
    records = ((entry, read_record(entry, of.out)) for entry in of.entries)
    rows = [row for entry, record in records for row in list_entry_rows(entry, record)]
    refuse_unknown_names(decisions, {(entry.student, entry.assignment) for entry in of.entries})
    return [apply_decision(row, decisions.get(row[:3])) for row in rows]


def refuse_unknown_names(decisions: Decisions, pairs: set[tuple[str, str]]) -> None:
    """Raise InvalidParameter if a decision matches no student, assignment and question.

    The message names its line, and the most similar name.

    Parameters
    ----------
    pairs : the students and their assignments.
    """
    for (student, assignment, question), decision in decisions.items():
        mine = {its for whose, its in pairs if whose == student}
        asked = list_questions(assignment if assignment in mine else "")
        known: tuple[tuple[str, str, Iterable[str]], ...] = (
            ("student", student, {whose for whose, _ in pairs}),
            (f"assignment of {student}", assignment, mine),
            (f"question of {assignment}", question, asked),
        )
        for what, name, names in known:
            if name not in names:
                near = difflib.get_close_matches(name, names, 1)
                guess = f"did you mean {near[0]!r}?" if near else "check the names."
                raise InvalidParameter(
                    f"{decision.source}: grades.csv would have no row for {student} {assignment} "
                    f"{question}: there is no {what} {name!r}; {guess} If this work is gone, "
                    "delete the line"
                )


def list_questions(assignment: str) -> list[str]:
    """The names of an assignment's questions, and of the answers that people grade.

    One empty name if the assignment is unknown, "".
    """
    if not assignment:
        return [""]
    task = read_assignment(assignment)
    return [*(one.exercise.name for one in task.questions), *task.by_hand]


def list_entry_rows(entry: Entry, record: Grade | None) -> list[Row]:
    """The grader's rows for one submission, with the reason if it could not be graded."""
    if not entry.assignment:
        trouble = (UNREADABLE, describe_trouble(entry, record))
        return [Row(entry.student, "", "", None, 0.0, *trouble, entry.late)]
    task = read_assignment(entry.assignment)
    if record is None or record["status"] == UNREADABLE:
        trouble = (name_trouble(entry, record), describe_trouble(entry, record))
        results = [(one.exercise.name, None, one.points, *trouble) for one in task.questions]
    else:
        results = [
            (one["question"], one["score"], one["max_score"], one["status"], one["message"])
            for one in record["questions"]
        ]
    results += [(name, None, most, BY_HAND, "") for name, most in task.by_hand.items()]
    return [Row(entry.student, entry.assignment, *result, entry.late) for result in results]


def name_trouble(entry: Entry, record: Grade | None) -> str:
    """Whether the file could not be read, or the machine failed."""
    return UNREADABLE if record is not None or not entry.key else NOT_GRADED


def describe_trouble(entry: Entry, record: Grade | None) -> str:
    """Why a submission has no scores, in words; "" if it has."""
    if record is not None:
        return str(record["message"])
    return entry.trouble or get_message("grades.not_graded")


def apply_decision(row: Row, decision: Decision | None) -> Row:
    """The row with a person's decision applied."""
    if decision is None:
        return row
    row = row._replace(message=decision.comment or row.message, comment=decision.comment)
    return row if decision.score is None else row._replace(score=decision.score, status=DECIDED)


class Total(NamedTuple):
    """A student's total for an assignment.

    score, max_score : sums over its questions.
    waiting : the number of questions without a score yet.
    questions : the number of all questions.
    """

    score: float
    max_score: float
    waiting: int
    questions: int


def sum_totals(rows: Iterable[Row]) -> dict[tuple[str, str], Total]:
    """The total for each student and assignment, in the order of the rows."""
    found: dict[tuple[str, str], Total] = {}
    for row in rows:
        before = found.get((row.student, row.assignment), Total(0.0, 0.0, 0, 0))
        sums = (before.score + (row.score or 0.0), before.max_score + row.max_score)
        counts = (before.waiting + (row.score is None), before.questions + 1)
        found[row.student, row.assignment] = Total(*sums, *counts)
    return found


def write_grades(rows: Iterable[Row], file: Path) -> None:
    """Write grades.csv; equal rows give equal bytes."""
    write_rows(file, format_grades(rows))


def format_grades(rows: Iterable[Row]) -> list[tuple[str, ...]]:
    """The lines of grades.csv."""
    return [COLUMNS, *format_rows(rows)]


def format_rows(rows: Iterable[Row]) -> Iterator[tuple[str, ...]]:
    """Yield the rows as text."""
    for row in rows:
        names = map(escape_formula, (row.student, row.assignment, row.question))
        scores = (number(row.score), number(row.max_score))
        yield (*names, *scores, row.status, escape_formula(row.message))
