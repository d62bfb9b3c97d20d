"""The variant that all students of a class section have: A, B and so on.

A is the first variant of every exercise that has any, B the second.
"""

import json
from collections.abc import Iterable
from string import ascii_uppercase
from typing import Any

from ..errors import InvalidParameter
from ..messages import get_message
from .exercise import Exercise
from .lessons import EXERCISES, find

Choices = tuple[tuple[str, str], ...]  # pairs of an exercise and the name of its variant


def choose_for_section(exercises: Iterable[Exercise], letter: str) -> Choices:
    """The variants of a section, for those exercises that have any.

    Raises
    ------
    InvalidParameter
        Where a letter is none, or an exercise has no variant of that letter.

    Examples
    --------
    >>> choose_for_section([find("bug2"), find("bug_base")], "B")
    (('bug2', 'right'),)
    """
    varied = [one for one in exercises if one.variants]
    letters = ascii_uppercase[: min((len(one.variants) for one in varied), default=26)]
    if len(letter) != 1 or letter not in letters:
        raise InvalidParameter(
            f"--variant is one of the letters {', '.join(letters)}, got {letter!r}; to give each "
            "student a variant, use --variants"
        )
    return tuple((one.name, one.variants[letters.index(letter)]) for one in varied)


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


def vary_exercises(files: dict[str, bytes], letter: str) -> dict[str, bytes]:
    """The exercises, of all files of a kit by their paths, with the variants of a section."""
    return {
        place: insert_section(data.decode(), letter).encode()
        for place, data in files.items()
        if place.startswith("exercises/") and place.endswith(".ipynb")
    }


def insert_section(notebook: str, letter: str) -> str:
    """The text of an exercise's notebook with the variants of a section."""
    book = json.loads(notebook)
    marks = [cell["metadata"].get("nbgrader", {}).get("grade_id") for cell in book["cells"]]
    chosen = choose_for_section([EXERCISES[mark] for mark in marks if mark in EXERCISES], letter)
    return format_notebook(insert_contracts(book, chosen))


def format_notebook(book: Any) -> str:
    """The text of a notebook."""
    return json.dumps(book, indent=1, ensure_ascii=False) + "\n"
