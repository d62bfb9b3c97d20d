"""From solutions to exercises: nbgrader takes the answers out, every cell is run, and what a
student sees is stored.

A solution notebook is the only source of its assignment. Its outputs are cleared first of all,
since they would tell the answers.
"""

import os
import zipfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

from ..errors import InvalidParameter
from ..support.whole_files import written_whole

HOUSE = Path(__file__).resolve().parent.parent.parent
FOR_STUDENTS = (
    "README.md",
    "LICENSE",
    "CHANGELOG.md",
    "start.py",
    "pyproject.toml",
    "environment.txt",
)
ROOMS_FOR_STUDENTS = ("kinoedu", "notebooks", "exercises", "docs")
LONG_AGO = (
    2020,
    1,
    1,
    0,
    0,
    0,
)  # the date of every file in a zip, so that the same course makes the same zip


def assignments(house: Path = HOUSE) -> list[str]:
    """The names of all assignments, such as 01_geometry, in order."""
    return sorted(file.stem for file in (house / "solutions").glob("*.ipynb"))


def release(name: str, house: Path = HOUSE) -> Path:
    """Make exercises/NAME.ipynb from solutions/NAME.ipynb, run it, and store it. Raises
    InvalidParameter.
    """
    import nbformat

    book = without_answers(solution(name, house))
    exercise = house / "exercises" / f"{name}.ipynb"
    with written_whole(exercise) as part:
        part.write_text(nbformat.writes(run(book, exercise.parent)) + "\n", encoding="utf-8")
    return exercise


def solution(name: str, house: Path = HOUSE) -> Path:
    """Where an assignment's solution is."""
    file = house / "solutions" / f"{name}.ipynb"
    if not file.is_file():
        raise InvalidParameter(
            f"there is no assignment {name!r}; there are: {', '.join(assignments(house)) or 'none'}"
        )
    return file


def without_answers(file: Path) -> Any:
    """A solution notebook as a student gets it, not run yet. Raises InvalidParameter."""
    import nbformat
    from nbgrader.preprocessors import ClearHiddenTests, ClearOutput, ClearSolutions, LockCells

    book = nbformat.read(file, as_version=4)
    book.cells = [cell for cell in book.cells if not is_model_answer(cell)]
    for preprocessor in (ClearOutput, LockCells, ClearSolutions, ClearHiddenTests):
        try:
            book, _ = preprocessor().preprocess(book, {})
        except RuntimeError as error:
            raise InvalidParameter(f"{file.name}: {error}") from error
    return book


def is_model_answer(cell: Any) -> bool:
    """Whether a code cell is an answer as a whole, for instructors alone: nothing but a solution,
    and not marked for nbgrader.
    """
    lines = cell.source.strip().splitlines() or [""]
    whole = "BEGIN SOLUTION" in lines[0] and "END SOLUTION" in lines[-1]
    return whole and cell.cell_type == "code" and "nbgrader" not in cell.metadata


def run(book: Any, folder: Path) -> Any:
    """Run a notebook as if it lay in a folder; its outputs stay, its timestamps do not. Raises
    InvalidParameter.
    """
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError

    client = NotebookClient(
        book,
        kernel_name="python3",
        resources={"metadata": {"path": str(folder)}},
        record_timing=False,
    )
    client.extra_arguments = ["--log-level=ERROR"]
    try:
        client.execute()
    except CellExecutionError as error:
        raise InvalidParameter(
            f"an exercise must run without errors before it is answered: {error}"
        ) from error
    book.metadata = {"kernelspec": book.metadata["kernelspec"]}
    return book


def pack(zip_file: str | os.PathLike[str], house: Path = HOUSE) -> int:
    """Pack what students get into a zip: no solutions, no bank, no tests. Returns the number of
    files.
    """
    rooms = [
        file
        for room in ROOMS_FOR_STUDENTS
        for file in sorted((house / room).rglob("*"))
        if file.is_file()
    ]
    files = [house / name for name in FOR_STUDENTS] + [
        file for file in rooms if not is_by_product(file)
    ]
    write_zip(
        zip_file,
        (
            Packed(f"kinoedu-course/{file.relative_to(house).as_posix()}", file.read_bytes())
            for file in files
        ),
    )
    return len(files)


class Packed(NamedTuple):
    """A file of a zip: its place there, its bytes, who may do what with it."""

    place: str
    data: bytes
    mode: int = 0o644


def write_zip(zip_file: str | os.PathLike[str], files: Iterable[Packed]) -> None:
    """Write a zip, whole or not at all: the same bytes for the same files."""
    with (
        written_whole(zip_file) as part,
        zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED) as archive,
    ):
        for file in files:
            entry = zipfile.ZipInfo(file.place, LONG_AGO)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = file.mode << 16
            archive.writestr(entry, file.data)


def is_by_product(file: Path) -> bool:
    """Whether a file is one that running the course left behind."""
    return any(
        part in ("__pycache__", ".ipynb_checkpoints") for part in file.parts
    ) or file.suffix in (".pyc", ".part")
