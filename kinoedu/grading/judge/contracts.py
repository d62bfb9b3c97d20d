"""Each student has a contract of their own: which way a bug turns, which of two parents a node
takes. What is right for one is wrong for another, so a copy does not pass.

Which contract is whose follows from the course's secret and the student's id, at release and at
grading alike.
"""

import hashlib
import hmac
from collections.abc import Iterable

from ...course.exercise import Exercise
from ...course.lessons import find
from ...errors import InvalidParameter
from ..assignments.questions import Assignment, assignment
from ..collect.submissions import Submission

Choices = tuple[tuple[str, str], ...]  # pairs of a question and the name of a contract
MARK = b"variant="  # in a notebook that gives its student a contract


def choice(exercise: Exercise, secret: bytes, student: str) -> str:
    """The contract of a student; capitals and blanks round an id do not matter."""
    text = f"variant:{exercise.name}:{student.strip().casefold()}"
    digest = hmac.digest(secret, text.encode("utf-8", "surrogatepass"), hashlib.sha256)
    return exercise.variants[int.from_bytes(digest) % len(exercise.variants)]


def choices(task: Assignment, secret: bytes, student: str) -> Choices:
    """A student's contracts for the questions of an assignment that have any."""
    asked = [one.exercise for one in task.questions if one.exercise.variants]
    return tuple((exercise.name, choice(exercise, secret, student)) for exercise in asked)


def with_variants(task: Assignment, chosen: Choices) -> Assignment:
    """An assignment with a student's contracts."""
    mine = dict(chosen)
    named = ((one, one.exercise.name) for one in task.questions)
    return task._replace(
        questions=tuple(
            one._replace(exercise=find(name, mine.get(name, ""))) for one, name in named
        )
    )


def personal(one: Submission, secret: bytes) -> Submission:
    """A submission with its student's contracts."""
    return (
        one._replace(variants=choices(assignment(one.assignment), secret, one.student))
        if one.assignment
        else one
    )


def refuse_forgotten(submissions: Iterable[Submission]) -> None:
    """Raise InvalidParameter where most notebooks give their student a contract, and nobody said
    so.
    """
    readable = [one for one in submissions if not one.trouble]
    if 2 * sum(MARK in one.data for one in readable) > len(readable):
        raise InvalidParameter(
            "these notebooks give each student contracts of their own: grade them with --variants"
        )
