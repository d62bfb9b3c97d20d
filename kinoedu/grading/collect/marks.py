"""Which assignment a file answers: by its name, and by the questions that its cells are about.

A lesson and its exercise have the same file name, and only their cells tell them apart.
"""

import re
from pathlib import Path, PurePosixPath

from ...course.release import HOUSE
from .notebook import join_text, parse_notebook

LONGEST = 255  # bytes of a name in a folder; a zip may have longer ones
# what a download or a second upload adds to a name
COPIED = re.compile(r"([ _-]?\(\d+\)|-\d+|[ _-]copy\d*)+$", re.IGNORECASE)
# a function at the left margin, and the check of one; a cell may have errors, so it is not parsed
ABOUT = re.compile(r"^(?:(?:async +)?def +|check *\( *)(\w+)", re.MULTILINE)

CONTRACT = re.compile(r"""^check *\( *(\w+) *, *variant *= *["'](\w+)["']""", re.MULTILINE)


def find_assignment(
    name: str, place: tuple[str, ...], shared: dict[str, int], known: list[str]
) -> str:
    """The assignment that a file answers, or "" where none fits.

    Its name decides, then its folders' names, then the start of its name, then its cells, of which
    `shared` says how many questions of each assignment they are about.
    """
    stem = COPIED.sub("", PurePosixPath(name).stem[:LONGEST])  # its time grows with the square
    for candidate in (stem, *map(strip_zip, reversed(place[:-1]))):
        if candidate in known:
            return candidate
    starts = [candidate for candidate in known if stem.lower().startswith(candidate.lower())]
    return max(starts, key=len) if starts else choose_most_shared(shared)


def find_questions(data: bytes) -> set[str]:
    """The names of the questions that a notebook's cells may be about.

    They are the names that nbgrader gave to cells, which some editors remove, and those of
    functions that are defined or checked. There are others among them.

    Raises
    ------
    UnreadableSubmission
        Where the file is no notebook.
    """
    cells = parse_notebook(data)["cells"]
    found: set[str] = set()
    for cell in cells if isinstance(cells, list) else []:
        if isinstance(cell, dict):
            found.add(get_mark(cell).removeprefix("check_"))
            if cell.get("cell_type") == "code":
                found.update(ABOUT.findall(join_text(cell.get("source"))))
    return found - {""}


def find_contracts(data: bytes) -> set[tuple[str, str]]:
    """The contracts for which a notebook's checks ask, as pairs of a question and a name.

    Raises
    ------
    UnreadableSubmission
        Where the file is no notebook.
    """
    cells = parse_notebook(data)["cells"]
    sources = (
        join_text(cell.get("source"))
        for cell in (cells if isinstance(cells, list) else [])
        if isinstance(cell, dict) and cell.get("cell_type") == "code"
    )
    return {pair for source in sources for pair in CONTRACT.findall(source)}


def get_mark(cell: dict[str, object]) -> str:
    """The name that nbgrader gave to a cell, or ""."""
    metadata = cell.get("metadata")
    mark = metadata.get("nbgrader") if isinstance(metadata, dict) else None
    name = mark.get("grade_id") if isinstance(mark, dict) else None
    return name if isinstance(name, str) else ""


def count_shared(names: set[str], known: list[str], house: Path = HOUSE) -> dict[str, int]:
    """How many of the names are questions of each assignment, also of those graded by hand."""
    from ..assignments.questions import read_assignment

    tasks = {name: read_assignment(name, house) for name in known}
    return {
        name: len(names & {*task.by_hand, *(one.exercise.name for one in task.questions)})
        for name, task in tasks.items()
    }


def choose_most_shared(shared: dict[str, int]) -> str:
    """The assignment with the most questions; "" where there are none."""
    best = max(shared, key=lambda name: shared[name], default="")
    return best if best and shared[best] else ""


def strip_zip(name: str) -> str:
    """A file's name without ".zip" at its end."""
    return name[: -len(".zip")] if name.lower().endswith(".zip") else name
