"""Which exercises each assignment has, as students know it who have no solutions.

An assignment may have some exercises of a lesson, or of several lessons, and answers that people
grade. Its solution says which. The kit for students has a list instead.
"""

import json
from pathlib import Path
from typing import Any

from ..support.notebooks import read_notebook
from .lessons import EXERCISES

FILE = Path(__file__).with_name("assignments.json")  # only in the kit
HOUSE = FILE.parent.parent.parent

Assignments = dict[str, list[str]]  # the names of exercises and of answers that people grade


def list_assignments(house: Path = HOUSE, file: Path = FILE) -> Assignments:
    """What each assignment asks, in order: in a kit by its list, in the course by the solutions.

    Where there is neither, as in a package from pip, each lesson is an assignment.

    Parameters
    ----------
    house : the folder of the course.
    file : the list that a kit has.

    Raises
    ------
    UnreadableScene
        Where a solution is damaged.
    """
    if file.exists():
        found: Assignments = json.loads(file.read_text(encoding="utf-8"))
        return found
    if (house / "solutions").is_dir():
        return read_solutions(house)
    lessons = dict.fromkeys(exercise.lesson for exercise in EXERCISES.values())
    return {
        lesson: [name for name, exercise in EXERCISES.items() if exercise.lesson == lesson]
        for lesson in lessons
    }


def read_solutions(house: Path) -> Assignments:
    """What each solution notebook has graded."""
    files = sorted((house / "solutions").glob("*.ipynb"))
    return {file.stem: list_graded(read_notebook(file)) for file in files}


def list_graded(book: Any) -> list[str]:
    """The names of what is graded in a notebook.

    >>> check = {"nbgrader": {"grade": True, "grade_id": "check_bug1"}}
    >>> list_graded({"cells": [{"metadata": check}, {"metadata": {}}]})
    ['bug1']
    """
    marks = [cell["metadata"].get("nbgrader", {}) for cell in book["cells"]]
    return [mark["grade_id"].removeprefix("check_") for mark in marks if mark.get("grade")]
