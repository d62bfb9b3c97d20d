"""The questions of an assignment, and the cases by which answers are judged.

Every student sees the small cases; nobody sees the others. These hidden cases are drawn from the
course's secret, which is kept outside the repository. So judges and solutions may be public: they
reveal no case.
"""

import ast
import functools
import hashlib
import hmac
import json
import logging
import os
import secrets
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

import numpy as np

from ...course.exercise import Case, Exercise
from ...course.lessons import find
from ...course.release import HOUSE, solution_path
from ...course.trivial import find_trivial_kinds
from ...errors import InvalidParameter
from ...support.notebooks import read_notebook

# these only show something in a notebook, and do nothing in the sandbox
FOR_NOTEBOOKS = ("kinoedu.course:", "kinoedu.figures", "kinoedu.boards")
ANNOUNCED = "kinoedu: the course's secret was made, once, in %s; keep it, and keep it to yourself"

log = logging.getLogger("kinoedu")


class AssignmentQuestion(NamedTuple):
    """A question of an assignment: its exercise and its points."""

    exercise: Exercise
    points: float


class Assignment(NamedTuple):
    """An assignment: its name, its questions, and what else its solution says.

    by_hand : the names of the answers that people grade, with their points.
    lent : what it imports from kinoedu, as "module:name"; programs get nothing else of it.
    """

    name: str
    questions: tuple[AssignmentQuestion, ...]
    by_hand: dict[str, float]
    lent: tuple[str, ...] = ()


@functools.cache
def read_assignment(name: str, house: Path = HOUSE) -> Assignment:
    """The assignment of that name, read from its solution notebook.

    A submission has no influence on the questions or their points.

    Raises
    ------
    InvalidParameter
        Where there is no such assignment, or its solution imports what cannot be lent.
    UnreadableScene
        Where the solution is damaged.
    """
    book = read_notebook(solution_path(name, house))
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
    sources = ["".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == "code"]
    refused = next((line for source in sources for line in list_whole_imports(source)), None)
    if refused is not None:
        raise InvalidParameter(
            f"solutions/{name}.ipynb has {refused!r}, which gives graded programs nothing; name "
            "the module and what it lends, as in 'from kinoedu.geometry import convex_hull'"
        )
    imported = (place for source in sources for place in list_imports(source))
    lent = tuple(place for place in imported if not place.startswith(FOR_NOTEBOOKS))
    return Assignment(
        name,
        tuple(AssignmentQuestion(find(question), points) for question, points in tests.items()),
        by_hand,
        lent,
    )


def list_imports(source: str) -> Iterator[str]:
    """Yield what a cell of a solution imports from modules of kinoedu, as "module:name".

    >>> list(list_imports("from kinoedu.geometry import (\\n    point_in_polygon as inside,\\n)"))
    ['kinoedu.geometry:point_in_polygon']
    """
    for node in parse_cell(source).body:
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("kinoedu."):
            yield from (f"{node.module}:{one.name}" for one in node.names)


def list_whole_imports(source: str) -> Iterator[str]:
    """Yield the imports in a cell of a solution that name no thing of a module of kinoedu.

    Nothing is lent for them: a whole module holds also what programs must not reach. Those of
    modules that only show something do no harm.

    >>> list(list_whole_imports("import kinoedu as ke, numpy\\nimport kinoedu.figures"))
    ['import kinoedu as ke']
    """
    for node in parse_cell(source).body:
        if isinstance(node, ast.Import):
            lines = [(one.name, f"import {ast.unparse(one)}") for one in node.names]
        elif isinstance(node, ast.ImportFrom) and (
            node.module == "kinoedu" or node.names[0].name == "*"
        ):
            lines = [(node.module or "", ast.unparse(node))]
        else:
            continue
        for module, line in lines:
            is_ours = module.partition(".")[0] == "kinoedu"
            if is_ours and not f"{module}:".startswith(FOR_NOTEBOOKS):
                yield line


def parse_cell(source: str) -> ast.Module:
    """The syntax tree of a cell, which may have commands such as %time."""
    try:
        return ast.parse(source)
    except SyntaxError:
        from IPython.core.inputtransformer2 import TransformerManager

        return ast.parse(TransformerManager().transform_cell(source))


def read_course_secret(file: Path) -> bytes:
    """The course's secret, made if there is none yet, in a file that only its owner can read.

    A warning in the log says where it was made; on the command line it is seen.

    Raises
    ------
    InvalidParameter
        Where the file does not hold a secret of at least 16 bytes.
    """
    if not file.exists():
        make_course_secret(file)
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


def make_course_secret(file: Path) -> None:
    """Write a new secret, unless another command has just written one."""
    file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    secret = secrets.token_hex(32) + "\n"
    with suppress(FileExistsError):
        handle = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        try:
            with os.fdopen(handle, "w", encoding="ascii") as stream:
                stream.write(secret)
        except OSError as error:  # such as a full disk
            file.unlink()
            raise type(error)(error.errno, error.strerror, str(file)) from None
        log.warning(ANNOUNCED, file)


class Cases(NamedTuple):
    """The cases by which an answer is judged; everybody has seen the first `seen` of them."""

    cases: list[Case]
    seen: int


@functools.lru_cache(maxsize=256)
def draw_cases(name: str, secret: bytes, variant: str = "") -> Cases:
    """An exercise's cases, drawn from the secret; equal for all students with the same contract.

    The small cases, which are always the same, come first. `check` shows them to everybody. Where
    all cases are drawn, the first of each kind that `check` shows comes first. The order of the
    others is drawn too: a program that counts its calls does not know which case it is asked.
    """
    exercise = find(name, variant)
    digest = hmac.digest(
        secret, (f"{name}:{variant}" if variant else name).encode(), hashlib.sha256
    )
    rng = np.random.default_rng(int.from_bytes(digest))
    cases = list(exercise.cases(rng))
    shown = exercise.fixed_cases
    spelled = {spell_case(exercise, case) for case in shown}
    hidden = [case for case in cases if spell_case(exercise, case) not in spelled]
    seen = [case for case in cases if spell_case(exercise, case) in spelled]
    if not seen:
        seen = [
            next(case for case in shown if case.kind == kind)
            for kind in exercise.kinds
            if any(case.kind == kind for case in shown)
        ]
    return Cases(seen + [hidden[i] for i in rng.permutation(len(hidden))], len(seen))


@functools.lru_cache(maxsize=256)
def draw_trivial_kinds(name: str, secret: bytes, variant: str = "") -> frozenset[frozenset[str]]:
    """The kinds that trivial programs pass in an exercise's cases; found once for a class."""
    return find_trivial_kinds(find(name, variant), *draw_cases(name, secret, variant))


def spell_case(exercise: Exercise, case: Case) -> str:
    """A case as text."""
    return json.dumps(exercise.given.encode(case.given), sort_keys=True)
