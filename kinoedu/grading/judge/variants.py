"""Write notebooks whose statements and checks hold the contracts of a student or of a section."""

from pathlib import Path
from typing import Any

from ...course.release import HOUSE, require_released, solution_path
from ...course.section import choose_for_section, format_notebook, insert_contracts
from ...errors import InvalidParameter
from ...support.csv_cells import escape_formula, write_rows
from ...support.file_names import file_name
from ...support.notebooks import read_notebook
from ...support.whole_files import written_whole
from ..assignments.questions import read_assignment
from .contracts import choose_contracts

COLUMNS = ("student", "assignment", "question", "variant", "notebook")


def write_variants(
    names: list[str], students: list[str], secret: bytes, out: Path, house: Path = HOUSE
) -> int:
    """Write the exercises with each student's contracts to OUT/STUDENT/NAME.ipynb.

    OUT/variants.csv lists which student has which contract, and in which notebook.

    Returns
    -------
    int
        The number of notebooks.

    Raises
    ------
    InvalidParameter
        Where an assignment is not released, or has no exercise with contracts.
    """
    books = {name: read_released(name, house) for name in names}
    lines = []
    for student in students:
        for name, book in books.items():
            mine = choose_contracts(read_assignment(name, house), secret, student)
            if not mine:
                raise InvalidParameter(f"no exercise of {name} has contracts to choose from")
            file = out / file_name(student) / f"{name}.ipynb"
            file.parent.mkdir(parents=True, exist_ok=True)
            with written_whole(file) as part:
                part.write_text(format_notebook(insert_contracts(book, mine)), encoding="utf-8")
            place = file.relative_to(out).as_posix()
            lines += [[escape_formula(student), name, *pair, place] for pair in mine]
    write_rows(out / "variants.csv", [COLUMNS, *lines])
    return len(books) * len(students)


def write_section(names: list[str], letter: str, out: Path, house: Path = HOUSE) -> list[Path]:
    """Write the exercises with the variants of a class section to OUT/NAME.ipynb.

    Raises
    ------
    InvalidParameter
        Where an assignment is not released, or an exercise has no variant of that letter.
    """
    made = []
    for name in names:
        exercises = [one.exercise for one in read_assignment(name, house).questions]
        book = insert_contracts(read_released(name, house), choose_for_section(exercises, letter))
        made.append(out / f"{name}.ipynb")
        out.mkdir(parents=True, exist_ok=True)
        with written_whole(made[-1]) as part:
            part.write_text(format_notebook(book), encoding="utf-8")
    return made


def read_released(name: str, house: Path) -> Any:
    """The exercise as it was released.

    Raises
    ------
    InvalidParameter
        Where it is not there, or is not what its solution makes.
    UnreadableScene
        Where it is no notebook.
    """
    solution_path(name, house)
    file = house / "exercises" / f"{name}.ipynb"
    if not file.is_file():
        raise InvalidParameter(f"exercises/{name}.ipynb is not there: release {name} first")
    require_released(name, house)
    return read_notebook(file)
