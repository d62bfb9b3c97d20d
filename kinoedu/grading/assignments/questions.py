"""What an assignment asks, and the cases that answers are judged by: the small ones that every
student sees, and others that nobody has seen.

The hidden cases come from the course's secret, which lives outside the repository. So judges and
solutions may be public: they tell no case.
"""

import functools
import hashlib
import hmac
import json
import os
import re
import secrets
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ...course.exercise import Case, Exercise
from ...course.lessons import find
from ...course.release import HOUSE, solution_path
from ...errors import InvalidParameter
from ...support.whole_files import written_whole

LENT = re.compile(
    r"^from (kinoedu\.course\.lessons\.\w+\.\w+) import (\w+(?: *, *\w+)*)$", re.MULTILINE
)


class Asked(NamedTuple):
    """A question of an assignment: its exercise and what it is worth."""

    exercise: Exercise
    points: float


class Assignment(NamedTuple):
    """An assignment: its name, its questions, the names of the answers that people grade, with
    their points, and the functions that it takes from the exercises' own modules, as "module:name".
    """

    name: str
    questions: tuple[Asked, ...]
    by_hand: dict[str, float]
    lent: tuple[str, ...] = ()


@functools.cache
def assignment(name: str, house: Path = HOUSE) -> Assignment:
    """An assignment, from its solution notebook: what a student hands in has no say in what is
    asked. Raises InvalidParameter.
    """
    book = json.loads(solution_path(name, house).read_text(encoding="utf-8"))
    marks = [
        cell["metadata"]["nbgrader"] for cell in book["cells"] if "nbgrader" in cell["metadata"]
    ]
    graded = [mark for mark in marks if mark.get("grade")]
    tests = {
        mark["grade_id"].removeprefix("check_"): float(mark["points"])
        for mark in graded
        if not mark.get("solution")
    }
    by_hand = {mark["grade_id"]: float(mark["points"]) for mark in graded if mark.get("solution")}
    sources = "".join(
        "".join(cell["source"]) + "\n" for cell in book["cells"] if cell["cell_type"] == "code"
    )
    lent = tuple(
        f"{home}:{thing}"
        for home, things in LENT.findall(sources)
        for thing in things.replace(" ", "").split(",")
    )
    return Assignment(
        name,
        tuple(Asked(find(question), points) for question, points in tests.items()),
        by_hand,
        lent,
    )


def course_secret(file: Path) -> bytes:
    """The course's secret; made, and kept where only you can read it, where there is none yet.
    Raises InvalidParameter.
    """
    if not file.exists():
        file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        with written_whole(file) as part:
            part.write_text(secrets.token_hex(32) + "\n", encoding="ascii")
        os.chmod(file, 0o600)
    try:
        secret = bytes.fromhex(file.read_text(encoding="ascii").strip())
    except ValueError as error:
        raise InvalidParameter(
            f"{file} does not hold a course secret, 64 hexadecimal digits"
        ) from error
    if len(secret) < 16:
        raise InvalidParameter(
            f"{file} holds a secret of {len(secret)} bytes; at least 16 are needed"
        )
    return secret


class Cases(NamedTuple):
    """The cases that an answer is judged by; the first `seen` of them everybody has seen."""

    cases: list[Case]
    seen: int


@functools.lru_cache(maxsize=256)
def cases_of(name: str, secret: bytes, variant: str = "") -> Cases:
    """An exercise's cases, drawn from the secret; the same for every student of a course who has
    the same contract. The small ones that are always asked have been seen: `check` shows them.
    """
    exercise = find(name, variant)
    digest = hmac.digest(
        secret, (f"{name}:{variant}" if variant else name).encode(), hashlib.sha256
    )
    cases = list(exercise.cases(np.random.default_rng(int.from_bytes(digest))))
    shown = {spelled(exercise, case) for case in exercise.cases(np.random.default_rng(0))}
    seen = [case for case in cases if spelled(exercise, case) in shown]
    return Cases(seen + [case for case in cases if spelled(exercise, case) not in shown], len(seen))


def spelled(exercise: Exercise, case: Case) -> str:
    """A case as text."""
    return json.dumps(exercise.given.encode(case.given), sort_keys=True)
