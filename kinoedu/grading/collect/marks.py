"""Which assignment a file answers: by its name, or by the marks that nbgrader left in its cells."""

import re
from pathlib import PurePosixPath

from .notebook import UnreadableSubmission, parse_notebook

# what a download or a second upload adds to a name
COPIED = re.compile(r"([ _-]?\(\d+\)|-\d+|[ _-]copy\d*)+$", re.IGNORECASE)


def find_assignment(name: str, place: tuple[str, ...], data: bytes, known: list[str]) -> str:
    """The assignment that a file answers, or "" where none fits.

    Its name decides, then its folders' names, then the start of its name, then the marks in its
    cells.
    """
    stem = COPIED.sub("", PurePosixPath(name).stem)
    for candidate in (stem, *map(strip_zip, reversed(place[:-1]))):
        if candidate in known:
            return candidate
    starts = [candidate for candidate in known if stem.lower().startswith(candidate.lower())]
    if starts:
        return max(starts, key=len)
    return choose_by_marks(count_shared_marks(data, known))


def count_shared_marks(data: bytes, known: list[str]) -> dict[str, int]:
    """How many questions of each assignment have a mark in the notebook."""
    from ..assignments.questions import read_assignment

    marks = find_marks(data)
    return (
        {
            name: sum(
                question.exercise.name in marks for question in read_assignment(name).questions
            )
            for name in known
        }
        if marks
        else {}
    )


def find_marks(data: bytes) -> set[str]:
    """The names that nbgrader gave to a notebook's cells; none where it cannot be read."""
    try:
        cells = parse_notebook(data)["cells"]
        return {
            cell["metadata"]["nbgrader"]["grade_id"]
            for cell in cells
            if "nbgrader" in cell.get("metadata", {})
        }
    except (UnreadableSubmission, KeyError, TypeError, AttributeError):
        return set()


def choose_by_marks(shared: dict[str, int]) -> str:
    """The assignment with the most marks; "" where there are none."""
    best = max(shared, key=lambda name: shared[name], default="")
    return best if best and shared[best] else ""


def strip_zip(name: str) -> str:
    """A file's name without ".zip" at its end."""
    return name[: -len(".zip")] if name.lower().endswith(".zip") else name
