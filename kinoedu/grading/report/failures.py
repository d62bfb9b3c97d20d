"""A failure as the judge saw it, restored from a record, with its text and picture.

Each picture is drawn once, however many students share the failure.
"""

import hashlib
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ...course.exercise import Case, Exercise
from ...course.feedback import case_lines, draw_failure
from ...course.judging import JudgedCase
from ...course.lessons import find
from ...course.outcomes import Answer, decode_outcome
from ...course.plain import WrongShape
from ...errors import KinoeduError
from ...messages import get_message
from ...support.time_limit import TimeUp, run_within
from ...support.whole_files import written_whole
from ..judge.running import digest_library
from ..judge.submission import Grade

DRAWING = 20.0  # seconds
ROUNDING = 1e-9  # of points


def restore_failure(question: Grade) -> tuple[Exercise, JudgedCase] | None:
    """The exercise and the case that failed, from a question's record.

    None if nothing failed, the case is hidden, or the course has changed since.
    """
    stored: Any = question.get("failure")
    if stored is None:
        return None
    try:
        exercise = find(question["question"], question.get("variant", ""))
        case = Case(stored["case"]["kind"], exercise.given.decode(stored["case"]["given"]))
        outcome = decode_outcome(stored["outcome"], exercise.answer)
        verdict = exercise.judge(case, outcome)
        return exercise, JudgedCase(case, outcome, verdict, stored["slip"], stored["number"])
    except (KinoeduError, WrongShape, KeyError, TypeError):
        return None


def explain_failure(question: Grade) -> list[tuple[str, str]]:
    """What a student may know of a failure beside the rule, as pairs of a title and a text.

    These are the case if everybody has seen it, the hint, the section to read again, and the kinds
    of input that passed and failed.
    """
    found = restore_failure(question)
    entries = case_lines(*found, "") if found is not None else []
    if question.get("hint"):
        entries.append((get_message("check.hint"), question["hint"]))
    if found is not None:
        entries.append((get_message("check.read"), found[0].message("section")))
    return [*entries, *explain_kinds(question)]


def explain_kinds(question: Grade) -> Iterator[tuple[str, str]]:
    """Yield the kinds of input that passed, failed and were not tried, as pairs of title and text.

    Where they are worth less than their share of the points, the reason follows.
    """
    passed, untried = question.get("passed", []), question.get("untried", [])
    failed = [kind for kind in question.get("kinds", []) if kind not in untried]
    for key, kinds in (("passed", passed), ("failed", failed), ("untried", untried)):
        if kinds:
            kinds_text = "; ".join(describe_kind(question["question"], kind) for kind in kinds)
            yield get_message(f"grades.kinds.{key}"), kinds_text
    fraction = len(passed) / max(1, len(passed) + len(failed) + len(untried))
    if question["score"] < fraction * question["max_score"] - ROUNDING:
        yield get_message("grades.kinds.points"), get_message("grades.kinds.trivial")


def describe_kind(question: str, kind: str) -> str:
    """A kind of input in words, or its key if the course has changed since."""
    try:
        return find(question).message(f"kinds.{kind}")
    except (KinoeduError, KeyError):
        return kind


def find_picture(question: Grade, folder: Path) -> bytes | None:
    """The picture of a question's failing case, as PNG, or None if there is none.

    It is read from `folder`, or drawn now and kept there.
    """
    found = restore_failure(question)
    if found is None or shows_nothing(*found):
        return None
    file = folder / f"{name_picture(question)}.png"
    if not file.exists():
        picture = draw_safely(*found)
        if picture is None:
            return None
        folder.mkdir(parents=True, exist_ok=True)
        with written_whole(file) as part:
            part.write_bytes(picture)
    return file.read_bytes()


def shows_nothing(exercise: Exercise, failure: JudgedCase) -> bool:
    """Whether a picture would be empty: there is no input and no answer."""
    return not failure.case.given and not isinstance(failure.outcome, Answer)


def name_picture(question: Grade) -> str:
    """The name of a picture; equal for equal exercise, contract, case, answer and sources."""
    failure = question["failure"]
    what = [question["question"], question.get("variant", ""), failure["case"], failure["outcome"]]
    text = json.dumps(what, sort_keys=True)
    return hashlib.sha256((digest_library() + text).encode()).hexdigest()[:40]


def draw_safely(exercise: Exercise, failure: JudgedCase) -> bytes | None:
    """The picture, or None where it cannot be drawn.

    A program's answer may be anything of the right shape, so drawing may fail.
    """
    try:
        return run_within(DRAWING, lambda: draw_failure(exercise, failure))
    except (Exception, TimeUp):
        return None
