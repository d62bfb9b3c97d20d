"""Contracts of each student's own, such as which way a bug turns or which parent a node takes.

A program that is right for one student is wrong for another, so a copy does not pass. A student's
contract follows from the course's secret and the student's id, both at release and at grading.
"""

import hashlib
import hmac
from collections.abc import Iterable

from ...course.exercise import Exercise
from ...course.lessons import find
from ...errors import InvalidParameter
from ..assignments.questions import Assignment, read_assignment
from ..collect.submissions import Submission

Choices = tuple[tuple[str, str], ...]  # pairs of a question and its contract's name
MARK = b"variant="  # stands in a notebook with contracts of its student


def choose_contract(exercise: Exercise, secret: bytes, student: str) -> str:
    """The contract of a student; upper case and spaces around an id do not matter."""
    text = f"variant:{exercise.name}:{student.strip().casefold()}"
    digest = hmac.digest(secret, text.encode("utf-8", "surrogatepass"), hashlib.sha256)
    return exercise.variants[int.from_bytes(digest) % len(exercise.variants)]


def choose_contracts(task: Assignment, secret: bytes, student: str) -> Choices:
    """A student's contracts for those questions of an assignment that have any."""
    exercises = [one.exercise for one in task.questions if one.exercise.variants]
    return tuple(
        (exercise.name, choose_contract(exercise, secret, student)) for exercise in exercises
    )


def apply_contracts(task: Assignment, chosen: Choices) -> Assignment:
    """The assignment with a student's contracts."""
    mine = dict(chosen)
    named = ((one, one.exercise.name) for one in task.questions)
    return task._replace(
        questions=tuple(
            one._replace(exercise=find(name, mine.get(name, ""))) for one, name in named
        )
    )


def add_contracts(one: Submission, secret: bytes) -> Submission:
    """The submission with its student's contracts."""
    return (
        one._replace(
            variants=choose_contracts(read_assignment(one.assignment), secret, one.student)
        )
        if one.assignment
        else one
    )


def refuse_forgotten(submissions: Iterable[Submission]) -> None:
    """Raise InvalidParameter if most notebooks hold contracts of their students.

    Call it where notebooks are graded without `--variants`.
    """
    readable = [one for one in submissions if not one.trouble]
    if 2 * sum(MARK in one.data for one in readable) > len(readable):
        raise InvalidParameter(
            "these notebooks give each student contracts of their own: grade them with --variants"
        )
