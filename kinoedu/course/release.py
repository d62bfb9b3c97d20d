"""Make exercise notebooks from solution notebooks.

A solution notebook is the only source of its assignment. nbgrader removes the answers, then every
cell is run and the outputs are stored. The solution's own outputs are cleared first, because they
would reveal the answers.
"""

import json
import os
import posixpath
import re
import zipfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

from ..errors import InvalidParameter
from ..messages import get_message
from ..support.notebooks import read_notebook
from ..support.progress import Progress
from ..support.whole_files import written_whole
from .assignments import FILE as LIST
from .assignments import read_solutions
from .kit import compress_results, record_results, take_out_answers
from .questions.asking import ASKED, Questions
from .questions.question import Question, hold_back, parse_questions, read_questions
from .section import format_notebook, vary_exercises
from .withheld import FILE

HOUSE = Path(__file__).resolve().parent.parent.parent
README = "docs/students.md"  # in the kit it is README.md
FOR_STUDENTS = (
    "LICENSE",
    "start.py",
    "pyproject.toml",
    "environment.txt",
    "docs/algorithms.md",
    "docs/boards.md",
    "docs/experiments.md",
    "docs/files.md",
    "docs/function_names.md",
    "docs/glossary.md",
    "docs/mesh_up.png",
    "docs/own_code.md",
    "docs/package.md",  # pip needs it to install the kit
    "docs/policies.md",
)
FOLDERS_FOR_STUDENTS = ("kinoedu", "notebooks", "exercises", "docs/boards")
LINK = re.compile(r"(?<=\]\()(?!#|\w+:)[^)]+")  # in Markdown, to another file of the course
LESSONS = "kinoedu/course/lessons/"
QUESTIONS = "kinoedu/course/questions/"
RESULTS = f"kinoedu/course/{FILE.name}"
ASSIGNMENTS = f"kinoedu/course/{LIST.name}"
CHECKED, UNANSWERED = "kinoedu-check", "kinoedu-unanswered"  # in the HTML of a check's feedback
ZIP_DATE = (2020, 1, 1, 0, 0, 0)  # of every file, so that the same course makes the same zip


def assignments(house: Path = HOUSE) -> list[str]:
    """Names of all assignments in order, such as 01_geometry.

    Raises
    ------
    InvalidParameter
        In a copy of the course without solutions: that of students, or one that pip has installed.
    """
    if not (house / "solutions").is_dir():
        raise InvalidParameter(
            "this copy of the course has no solutions: release and grade with the whole course"
        )
    return sorted(file.stem for file in (house / "solutions").glob("*.ipynb"))


def release(name: str, house: Path = HOUSE) -> Path:
    """Make exercises/NAME.ipynb from solutions/NAME.ipynb, run it and store it.

    Returns
    -------
    Path
        The exercise notebook.

    Raises
    ------
    InvalidParameter
        Where there is no such assignment, or the notebook does not run without errors, or a check
        says anything but that nothing is answered yet.
    """
    import nbformat

    exercise = house / "exercises" / f"{name}.ipynb"
    book = run_notebook(remove_answers(solution_path(name, house)), exercise.parent)
    for number, cell in enumerate(book.cells, 1):
        require_unanswered(number, cell)
    with written_whole(exercise) as part:
        part.write_text(nbformat.writes(book) + "\n", encoding="utf-8")
    return exercise


def solution_path(name: str, house: Path = HOUSE) -> Path:
    """Path of an assignment's solution.

    Raises
    ------
    InvalidParameter
        Where there is no such assignment.
    """
    file = house / "solutions" / f"{name}.ipynb"
    if not file.is_file():
        raise InvalidParameter(
            f"there is no assignment {name!r}; there are: {', '.join(assignments(house)) or 'none'}"
        )
    return file


def remove_answers(file: Path) -> Any:
    """Solution notebook with the answers removed, not run yet.

    Raises
    ------
    InvalidParameter
        Where nbgrader rejects the notebook.
    """
    from nbgrader.preprocessors import ClearHiddenTests, ClearOutput, ClearSolutions, LockCells

    book = read_notebook_node(file)
    book.cells = [cell for cell in book.cells if not is_model_answer(cell)]
    for preprocessor in (ClearOutput, LockCells, ClearSolutions, ClearHiddenTests):
        try:
            book, _ = preprocessor().preprocess(book, {})
        except RuntimeError as error:
            raise InvalidParameter(f"{file.name}: {error}") from error
    return book


def read_notebook_node(file: Path) -> Any:
    """A notebook as nbformat has it. Raises UnreadableScene where it is damaged."""
    import nbformat

    read_notebook(file)
    return nbformat.read(file, as_version=4)


def require_released(name: str, house: Path = HOUSE) -> None:
    """Raise InvalidParameter where exercises/NAME.ipynb has other cells than its solution makes.

    Somebody may have tried it and left answers in it. Without such a file nothing is wrong. Of a
    damaged notebook it raises UnreadableScene.
    """
    exercise = house / "exercises" / f"{name}.ipynb"
    if not exercise.exists():
        return
    books = (read_notebook_node(exercise), remove_answers(solution_path(name, house)))
    found, made = ([(cell.cell_type, cell.source) for cell in book.cells] for book in books)
    if found != made:
        raise InvalidParameter(
            f"exercises/{name}.ipynb is not what its solution makes, and may have answers in it: "
            f"release {name} again"
        )


def is_model_answer(cell: Any) -> bool:
    """Whether a code cell holds only a solution and has no nbgrader metadata.

    Such a cell is for instructors and is removed as a whole.
    """
    lines = cell.source.strip().splitlines() or [""]
    whole = "BEGIN SOLUTION" in lines[0] and "END SOLUTION" in lines[-1]
    return whole and cell.cell_type == "code" and "nbgrader" not in cell.metadata


def run_notebook(book: Any, folder: Path) -> Any:
    """Run a notebook in a folder; outputs are kept, timestamps and warnings are not.

    Raises
    ------
    InvalidParameter
        Where a cell raises an error.
    """
    from nbclient import NotebookClient
    from nbclient.exceptions import CellExecutionError, DeadKernelError

    client = NotebookClient(
        book,
        kernel_name="python3",
        resources={"metadata": {"path": str(folder)}},
        record_timing=False,
    )
    client.extra_arguments = ["--log-level=CRITICAL"]  # or it reports what Ctrl-C stopped
    try:
        with client.setup_kernel():  # execute() has its own answer to Ctrl-C, a traceback
            for number, cell in enumerate(book.cells):
                client.execute_cell(cell, number, execution_count=client.code_cells_executed + 1)
    except (CellExecutionError, DeadKernelError) as error:
        raise InvalidParameter(
            f"an exercise notebook must run without errors before it is answered: {error}"
        ) from error
    book.metadata = {"kernelspec": book.metadata["kernelspec"]}
    for cell in book.cells:
        if cell.cell_type == "code":  # warnings are about this computer, with paths of its user
            cell.outputs = [one for one in cell.outputs if one.get("name") != "stderr"]
    return book


def require_unanswered(number: int, cell: Any) -> None:
    """Raise InvalidParameter if the check of a graded cell does not say "not answered yet".

    No check of any cell may have run out of time, as happens on a busy computer.
    """
    ends = [get_message(f"check.{end}") for end in ("stopped", "still_running")]
    graded = cell.metadata.get("nbgrader", {}).get("grade", False)
    for output in cell.get("outputs", []):
        text, page = (output.get("data", {}).get(f"text/{kind}", "") for kind in ("plain", "html"))
        answered = graded and UNANSWERED not in page
        if CHECKED in page and (answered or any(end in text for end in ends)):
            raise InvalidParameter(
                f"cell {number}, {cell.source.splitlines()[0]}, must say that nothing is answered "
                f"yet, but it says: {' '.join(text.split())[:300]} If the computer was busy, "
                "release again"
            )


def pack_course(
    zip_file: str | os.PathLike[str],
    house: Path = HOUSE,
    graded: Iterable[str] = (),
    letter: str = "",
    progress: Progress | None = None,
) -> int:
    """Pack the files for students into a zip, without solutions, banks, tests and answers.

    In place of the answers in the lessons' code there are recorded results (`kit.py`), and in place
    of the solutions a list of what each assignment asks (`assignments.py`).

    Parameters
    ----------
    graded : lessons whose concept questions are graded elsewhere; the zip has no answers to them.
    letter : the variant of the exercises that this zip has, such as B; by default the usual form.
    progress : called while the results are recorded, with how many are, and of how many.

    Returns
    -------
    int
        The number of files.
    """
    files = files_for_students(house)
    for lesson in graded:
        files |= hold_questions_back(lesson, files)
    if letter:
        files |= vary_exercises(files, letter)
    files[ASSIGNMENTS] = (json.dumps(read_solutions(house), indent=1) + "\n").encode()
    files[RESULTS] = compress_results(record_results(progress=progress))
    write_zip(zip_file, (Packed(f"kinoedu-course/{place}", files[place]) for place in files))
    return len(files)


def files_for_students(house: Path = HOUSE) -> dict[str, bytes]:
    """The files of the kit by their paths, but for the recorded results."""
    places = [house / name for name in FOR_STUDENTS]
    for folder in FOLDERS_FOR_STUDENTS:
        inside = sorted((house / folder).rglob("*"))
        places += [file for file in inside if file.is_file() and not is_generated(file)]
    drafts = exercises_without_solution(house)
    places = [file for file in places if file not in drafts]
    files = {"README.md": students_readme(house).encode()}
    files |= {file.relative_to(house).as_posix(): file.read_bytes() for file in places}
    return files | without_answers(files)


def exercises_without_solution(house: Path = HOUSE) -> list[Path]:
    """Notebooks and zips in exercises that no solution makes, such as a copy with answers."""
    made = [house / "exercises" / f"{name}.ipynb" for name in assignments(house)]
    found = sorted((house / "exercises").rglob("*"))
    drafts = [file for file in found if file.suffix.lower() in (".ipynb", ".zip")]
    return [file for file in drafts if file not in made and not is_generated(file)]


def students_readme(house: Path = HOUSE) -> str:
    """The kit's README: the page for students, and the lessons of the course's README."""
    page, course = ((house / name).read_text("utf-8") for name in (README, "README.md"))
    page = LINK.sub(lambda link: posixpath.normpath(f"docs/{link[0]}"), page)
    lessons = course.partition("\n## Lessons\n")[2].partition("\n## ")[0]
    return f"{page}\n## Lessons\n{lessons}"


def without_answers(files: dict[str, bytes]) -> dict[str, bytes]:
    """The lessons' code, of all files, without answers."""
    lessons = {
        place.removeprefix(LESSONS): data.decode()
        for place, data in files.items()
        if place.startswith(LESSONS) and place.endswith(".py")
    }
    return {LESSONS + place: text.encode() for place, text in take_out_answers(lessons).items()}


def hold_questions_back(lesson: str, files: dict[str, bytes]) -> dict[str, bytes]:
    """The files, of all files, with the concept questions of a lesson, without the answers.

    Raises
    ------
    InvalidParameter
        Where the lesson has no questions.
    """
    read_questions(lesson)
    ending = f"/{lesson}.toml"
    held = {
        place: hold_back(data.decode()).encode()
        for place, data in files.items()
        if place.startswith(QUESTIONS) and place.endswith(ending)
    }
    questions = parse_questions(held[f"{QUESTIONS}en{ending}"].decode(), lesson)
    book = f"notebooks/{lesson}.ipynb"
    if book not in files:  # a teacher may ask the questions without the lesson
        return held
    return {**held, book: ask_without_answers(files[book].decode(), questions).encode()}


def ask_without_answers(notebook: str, questions: tuple[Question, ...]) -> str:
    """The text of a notebook, whose stored output of `ask` has no answers."""
    book = json.loads(notebook)
    for cell in book["cells"]:
        for output in cell.get("outputs", ()):
            page = output.get("data", {}).get("text/html", "")
            if ASKED in "".join(page):
                asked = Questions("", questions)
                output["data"] = {"text/html": [asked._repr_html_()], "text/plain": [repr(asked)]}
    return format_notebook(book)


class Packed(NamedTuple):
    """A file in a zip: its path, its bytes and its permissions."""

    place: str
    data: bytes
    mode: int = 0o644


def write_zip(zip_file: str | os.PathLike[str], files: Iterable[Packed], mode: int = 0o644) -> None:
    """Write a zip with these permissions atomically; the same files give the same bytes."""
    with (
        written_whole(zip_file, mode) as part,
        zipfile.ZipFile(part, "w", zipfile.ZIP_DEFLATED) as archive,
    ):
        for file in files:
            entry = zipfile.ZipInfo(file.place, ZIP_DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = file.mode << 16
            archive.writestr(entry, file.data)


def is_generated(file: Path) -> bool:
    """Whether running the course has generated this file."""
    in_cache = any(part in ("__pycache__", ".ipynb_checkpoints") for part in file.parts)
    return in_cache or file.suffix in (".pyc", ".part")
