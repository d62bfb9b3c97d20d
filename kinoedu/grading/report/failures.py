"""A kept failure as the judge saw it, to be told and drawn again; each picture is drawn once,
however many students it is for.
"""

import functools
import hashlib
import json
from pathlib import Path
from typing import Any

from ...compiled.store import source_digest
from ...course.exercise import Case, Exercise
from ...course.feedback import case_lines, draw_failure
from ...course.judging import JudgedCase
from ...course.lessons import find
from ...course.outcomes import Answer, decode_outcome
from ...course.plain import WrongShape
from ...course.release import HOUSE
from ...errors import KinoeduError
from ...messages import get_message
from ...support.time_limit import TimeUp, run_within
from ...support.whole_files import written_whole
from ..judge.submission import Grade

DRAWING = 20.0  # seconds


def failure_of(question: Grade) -> tuple[Exercise, JudgedCase] | None:
    """The exercise and the case that failed, from a question's record; None where there is none, or
    the course has changed.
    """
    kept: Any = question.get("failure")
    if kept is None:
        return None
    try:
        exercise = find(question["question"], question.get("variant", ""))
        case = Case(kept["case"]["kind"], exercise.given.decode(kept["case"]["given"]))
        outcome = decode_outcome(kept["outcome"], exercise.answer)
        return exercise, JudgedCase(
            case, outcome, exercise.judge(case, outcome), kept["slip"], kept["number"]
        )
    except (KinoeduError, WrongShape, KeyError, TypeError):
        return None


def told_of(question: Grade) -> list[tuple[str, str]]:
    """What a failure's student may know beside the rule, as pairs of a title and a text: the case,
    if everybody has seen it, the hint, and what to read again.
    """
    found = failure_of(question)
    told = case_lines(*found, "") if found is not None else []
    if question.get("hint"):
        told.append((get_message("check.hint"), question["hint"]))
    if found is not None:
        told.append((get_message("check.read"), found[0].message("section")))
    return told


def picture_for(question: Grade, folder: Path) -> bytes | None:
    """The failing case of a question as a PNG, from `folder`, drawn now where it is not there; None
    where none can be drawn.
    """
    found = failure_of(question)
    if found is None or shows_nothing(*found):
        return None
    file = folder / f"{name_of(question)}.png"
    if not file.exists():
        picture = drawn(*found)
        if picture is None:
            return None
        folder.mkdir(parents=True, exist_ok=True)
        with written_whole(file) as part:
            part.write_bytes(picture)
    return file.read_bytes()


def shows_nothing(exercise: Exercise, failure: JudgedCase) -> bool:
    """Whether a picture would be empty: nothing was given, and nothing came back."""
    return not failure.case.given and not isinstance(failure.outcome, Answer)


def name_of(question: Grade) -> str:
    """The same for the same exercise, contract, case, answer and sources."""
    what = [
        question["question"],
        question.get("variant", ""),
        question["failure"]["case"],
        question["failure"]["outcome"],
    ]
    said = json.dumps(what, sort_keys=True)
    return hashlib.sha256((sources() + said).encode()).hexdigest()[:40]


@functools.cache
def sources() -> str:
    """Of kinoedu, which draws."""
    return source_digest(HOUSE / "kinoedu")


def drawn(exercise: Exercise, failure: JudgedCase) -> bytes | None:
    """A picture; None where the exercise cannot draw what a program answered, which may be anything
    of the right shape.
    """
    try:
        return run_within(DRAWING, lambda: draw_failure(exercise, failure))
    except (Exception, TimeUp):
        return None
