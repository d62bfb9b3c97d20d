"""Pack what a student hands in: one zip of the notebook and a receipt. Nothing is run."""

import hashlib
import re
import zipfile
from datetime import datetime
from pathlib import Path
from typing import Any, NamedTuple

from ...course.assignments import list_assignments
from ...course.lessons import EXERCISES
from ...errors import InvalidParameter
from ...messages import get_message
from ...support.json_fields import JsonObject
from ...support.whole_files import written_whole
from ..sandbox.cells import Failure, find_names, is_placeholder, parse_cell
from .marks import choose_most_shared, find_questions
from .notebook import Cell, join_text, parse_notebook, read_bytes, read_cells

UNTOUCHED = "YOUR ANSWER HERE"


class Receipt(NamedTuple):
    """What was packed and when.

    sha256 : the digest of the notebook.
    answers : for each question whether it is answered, and a remark: the last message of its check,
        or why Python cannot read it, or "".
    """

    assignment: str
    sha256: str
    time: datetime
    answers: dict[str, tuple[bool, str]]

    def __str__(self) -> str:
        done = sum(answered for answered, _ in self.answers.values())
        lines = [
            get_message("hand_in.title", assignment=self.assignment),
            get_message("hand_in.time", time=self.time.isoformat(sep=" ", timespec="seconds")),
            get_message("hand_in.digest", sha256=self.sha256),
            get_message("hand_in.answered", done=done, questions=len(self.answers)),
        ]
        for name, (answered, remark) in self.answers.items():
            state = get_message("hand_in.yes" if answered else "hand_in.no")
            lines.append(f"  {name}: {state}" + (f"; {remark}" if remark else ""))
        return "\n".join(lines)


def hand_in(file: Path, zip_file: Path, now: datetime) -> Receipt:
    """Check a notebook, and pack it with a receipt.

    Returns
    -------
    Receipt

    Raises
    ------
    UnreadableSubmission
        Where the notebook could not be graded.
    InvalidParameter
        Where it has no cells of the exercise that its name says, or of any exercise.
    """
    data = read_bytes(file)
    assignment = find_assignment(file, data)
    answers = find_answers(data, assignment)
    receipt = Receipt(assignment, hashlib.sha256(data).hexdigest(), now, answers)
    with (
        written_whole(zip_file) as part,
        zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED) as archive,
    ):
        archive.writestr(f"{receipt.assignment}.ipynb", data)
        archive.writestr("receipt.txt", f"{receipt}\n")
    return receipt


def find_assignment(file: Path, data: bytes) -> str:
    """The assignment that a notebook answers, by its name and the questions of its cells.

    Where the name is that of no assignment, the cells decide.

    Raises
    ------
    InvalidParameter
        Where they are those of another assignment, or of a lesson, or of none.
    UnreadableSubmission
        Where it is no notebook.
    """
    is_notebook = file.suffix.lower() == ".ipynb"
    questions = find_questions(data) if is_notebook else set()
    known = list_assignments()
    shared = {name: len(questions & {*asked}) for name, asked in known.items()}
    best = choose_most_shared(shared)
    starts = [name for name in known if file.stem.lower().startswith(name.lower())]
    named = max(starts, key=len, default=best)
    if not is_notebook or not named:
        raise InvalidParameter(
            f"{file.name} is named like no exercise, and has no cells of one; its name should "
            f"begin with one of: {', '.join(known)}"
        )
    if not shared[named]:
        fault = f"its cells are those of {best}" if best else "it has none of its functions"
        raise InvalidParameter(
            f"{file.name} is named like {named}, but {fault}: is it the wrong file? Exercises are "
            "in the folder exercises, and lessons of the same names in the folder notebooks"
        )
    return named


def find_answers(data: bytes, assignment: str) -> dict[str, tuple[bool, str]]:
    """Whether each question is answered, and the last message of its check, in the order asked.

    Raises UnreadableSubmission.
    """
    written, broken = find_functions(read_cells(data))
    book = parse_notebook(data)["cells"]
    messages = read_check_messages(book)
    asked = list_assignments()[assignment]
    answers = {
        name: (True, messages.get(name, "")) if written.get(name) else (False, broken.get(name, ""))
        for name in asked
        if name in EXERCISES
    }
    answers |= {name: (is_touched, "") for name, is_touched in find_prose_answers(book)}
    return {name: answers[name] for name in [*asked, *answers] if name in answers}


def find_functions(cells: list[Cell]) -> tuple[dict[str, bool], dict[str, str]]:
    """The functions that a notebook defines.

    Returns
    -------
    dict, dict
        Whether each has been written by the student, and the syntax errors of those that have one.
    """
    written: dict[str, bool] = {}
    broken: dict[str, str] = {}
    for part in (part for cell in cells for part in parse_cell(cell.source, "")):
        if isinstance(part, Failure):
            reason = part.error.msg if isinstance(part.error, SyntaxError) else str(part.error)
            message = get_message("hand_in.unreadable", message=reason, line=part.line)
            written |= dict.fromkeys(part.names, False)
            broken |= dict.fromkeys(part.names, message)
        elif is_placeholder(part):  # it does not take the place of an answer above it
            written = dict.fromkeys(find_names(part), False) | written
        else:
            written |= dict.fromkeys(find_names(part), True)
    return written, broken


def read_check_messages(cells: list[Any]) -> dict[str, str]:
    """The first line of the output of each check() that is stored in the notebook."""
    messages = {}
    for cell in cells:
        outputs = as_table(cell).get("outputs")
        called = re.match(r"\s*check\((\w+)", join_text(as_table(cell).get("source")))
        if called and isinstance(outputs, list) and outputs:
            text = join_text(
                as_table(as_table(outputs[0]).get("data")).get("text/plain")
            ).partition("\n")[0]
            # the output that the exercise was handed out with
            stale = text == get_message("check.unanswered", name=called[1])
            messages[called[1]] = (
                get_message("hand_in.unchecked") if stale else text.removeprefix(f"{called[1]}: ")
            )
    return messages


def find_prose_answers(cells: list[Any]) -> list[tuple[str, bool]]:
    """The answers that people grade, and whether the student changed each."""
    marked = [
        (cell, as_table(as_table(as_table(cell).get("metadata")).get("nbgrader"))) for cell in cells
    ]
    return [
        (str(mark["grade_id"]), UNTOUCHED not in join_text(cell.get("source")))
        for cell, mark in marked
        if mark.get("grade") and mark.get("solution") and "grade_id" in mark
    ]


def as_table(data: object) -> JsonObject:
    """`data` if it is a table, else an empty one."""
    return data if isinstance(data, dict) else {}
