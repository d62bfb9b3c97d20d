"""Write each student a notebook whose statements and checks hold the student's own contracts."""

import json
from pathlib import Path
from typing import Any

from ...course.lessons import find
from ...course.release import HOUSE, solution_path
from ...errors import InvalidParameter
from ...messages import get_message
from ...support.csv_cells import escape_formula, write_rows
from ...support.file_names import file_name
from ...support.whole_files import written_whole
from ..assignments.questions import read_assignment
from .contracts import Choices, choose_contracts

COLUMNS = ("student", "assignment", "question", "variant")


def write_variants(
    names: list[str], students: list[str], secret: bytes, out: Path, house: Path = HOUSE
) -> int:
    """Write the exercises with each student's contracts to OUT/STUDENT/NAME.ipynb.

    OUT/variants.csv lists which student has which contract.

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
                part.write_text(
                    json.dumps(insert_contracts(book, mine), indent=1, ensure_ascii=False) + "\n",
                    encoding="utf-8",
                )
            lines += [[escape_formula(student), name, *pair] for pair in mine]
    write_rows(out / "variants.csv", [COLUMNS, *lines])
    return len(books) * len(students)


def read_released(name: str, house: Path) -> Any:
    """The exercise as it was released. Raises InvalidParameter."""
    solution_path(name, house)
    file = house / "exercises" / f"{name}.ipynb"
    if not file.is_file():
        raise InvalidParameter(f"exercises/{name}.ipynb is not there: release {name} first")
    return json.loads(file.read_text(encoding="utf-8"))


def insert_contracts(book: Any, chosen: Choices) -> Any:
    """The exercise with a student's contract in the statement and the check of each question."""
    mine, cells = dict(chosen), []
    for cell in book["cells"]:
        name = cell["metadata"].get("nbgrader", {}).get("grade_id", "")
        if name in mine:
            message = get_message("variants.yours", contract=find(name, mine[name]).contract)
            cells.append(
                {
                    "cell_type": "markdown",
                    "id": f"contract_{name}",
                    "metadata": {},
                    "source": [message],
                }
            )
        if name.removeprefix("check_") in mine and name.startswith("check_"):
            question = name.removeprefix("check_")
            source = "".join(cell["source"]).replace(
                f"check({question}", f'check({question}, variant="{mine[question]}"', 1
            )
            cell = {**cell, "source": source.splitlines(keepends=True)}
        cells.append(cell)
    return {**book, "cells": cells}
