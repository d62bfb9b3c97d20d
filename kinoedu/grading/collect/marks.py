"""Which assignment a file answers: by its name, else by the marks that nbgrader left in its
cells.
"""

import re
from pathlib import PurePosixPath

from .notebook import UnreadableSubmission, notebook_in

COPIED = re.compile(
    r"([ _-]?\(\d+\)|-\d+|[ _-]copy\d*)+$", re.IGNORECASE
)  # what a download or a second try adds to a name


def assignment_of(name: str, place: tuple[str, ...], data: bytes, known: list[str]) -> str:
    """The assignment that a file answers: by its name, by its folder, else by the marks of its
    cells; "" where none fits.
    """
    stem = COPIED.sub("", PurePosixPath(name).stem)
    for candidate in (stem, *map(unzipped, reversed(place[:-1]))):
        if candidate in known:
            return candidate
    starts = [candidate for candidate in known if stem.lower().startswith(candidate.lower())]
    if starts:
        return max(starts, key=len)
    return most_marks(shared_marks(data, known))


def shared_marks(data: bytes, known: list[str]) -> dict[str, int]:
    """How many questions of each assignment stand in a notebook's marks."""
    from ..assignments.questions import assignment

    marks = marks_in(data)
    return (
        {
            name: sum(asked.exercise.name in marks for asked in assignment(name).questions)
            for name in known
        }
        if marks
        else {}
    )


def marks_in(data: bytes) -> set[str]:
    """The names that nbgrader gave a notebook's cells; none where it cannot be read, or was made
    elsewhere.
    """
    try:
        cells = notebook_in(data)["cells"]
        return {
            cell["metadata"]["nbgrader"]["grade_id"]
            for cell in cells
            if "nbgrader" in cell.get("metadata", {})
        }
    except (UnreadableSubmission, KeyError, TypeError, AttributeError):
        return set()


def most_marks(shared: dict[str, int]) -> str:
    """The assignment of most of them; "" where there are none."""
    best = max(shared, key=lambda name: shared[name], default="")
    return best if best and shared[best] else ""


def unzipped(name: str) -> str:
    """A name without the ending of a zip."""
    return name[: -len(".zip")] if name.lower().endswith(".zip") else name
