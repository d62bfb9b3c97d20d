"""Read a submission's cells safely.

The file may be empty, cut off, not a notebook, or made to break its reader.
"""

import json
import os
import re
import stat
from pathlib import Path
from typing import Any, NamedTuple

from ...errors import KinoeduError
from ...support.json_fields import JsonObject
from .notebook_python import PythonReader

MOST_BYTES = 60 * 2**20  # of a notebook with its pictures
MOST_PARTS = 2**21  # commas and brackets; each may be a value, which takes far more than a byte
MOST_SOURCE = 2**20  # characters of code
MOST_CELLS = 2_000


class Cell(NamedTuple):
    """A cell of code: its number among all cells of the notebook, from 1, and its source."""

    number: int
    source: str


class UnreadableSubmission(KinoeduError):
    """A file is not a notebook that can be graded; the message tells the student why."""


def read_bytes(file: Path, most: int = MOST_BYTES) -> bytes:
    """The bytes of a plain file of at most `most` bytes.

    Raises
    ------
    UnreadableSubmission
        Where it is a link, a pipe or the like, is too large, or cannot be opened.
    """
    try:
        handle = os.open(
            file, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
        )
    except OSError as error:
        raise UnreadableSubmission(f"the file cannot be opened: {error.strerror}") from error
    about = os.fstat(handle)
    if not stat.S_ISREG(about.st_mode):
        os.close(handle)
        raise UnreadableSubmission("this is not a plain file")
    with os.fdopen(handle, "rb") as stream:
        if about.st_size > most:
            raise UnreadableSubmission(
                f"the file is too large: {about.st_size / 2**20:.0f} MB, and "
                f"{most / 2**20:.0f} MB is the most"
            )
        return stream.read(most)


def read_cells(data: bytes) -> list[Cell]:
    """The code cells of a notebook that are not empty, numbered among all cells from 1.

    Commands that only a notebook understands are calls of get_ipython(), as IPython makes them.

    Raises
    ------
    UnreadableSubmission
        Where it is no notebook of version 4, or a large one.

    Examples
    --------
    >>> cell = b'{"cell_type": "code", "source": ["x = 1\\\\n", "%time x"]}'
    >>> book = b'{"nbformat": 4, "cells": [' + cell + b"]}"
    >>> read_cells(book)
    [Cell(number=1, source="x = 1\\nget_ipython().run_line_magic('time', 'x')\\n")]
    """
    cells = parse_notebook(data)["cells"]
    if not isinstance(cells, list) or len(cells) > MOST_CELLS:
        raise UnreadableSubmission(
            f"a notebook has a list of at most {MOST_CELLS:,} cells, and this has not"
        )
    codes = [
        (number, cell)
        for number, cell in enumerate(cells, 1)
        if isinstance(cell, dict) and cell.get("cell_type") == "code"
    ]
    found = [Cell(number, extract_source(cell)) for number, cell in codes]
    if sum(len(cell.source) for cell in found) > MOST_SOURCE:
        raise UnreadableSubmission(
            f"the notebook holds more than {MOST_SOURCE:,} characters of code"
        )
    reader = PythonReader()
    return [Cell(cell.number, reader.read(cell.source)) for cell in found if cell.source.strip()]


def parse_notebook(data: bytes) -> JsonObject:
    """A notebook of version 4 as JSON data. Raises UnreadableSubmission."""
    if not data.strip():
        raise UnreadableSubmission("the file is empty")
    if sum(map(data.count, (b",", b"[", b"{"))) > MOST_PARTS:
        raise UnreadableSubmission("the file holds more numbers and words than a notebook does")
    try:
        book = json.loads(data.decode("utf-8-sig"))
    except (ValueError, RecursionError) as error:
        raise UnreadableSubmission(
            f"the file is not a whole notebook ({' '.join(str(error).split())[:100]})"
        ) from error
    if not isinstance(book, dict) or "cells" not in book:
        raise UnreadableSubmission("the file is not a notebook: it has no cells")
    if book.get("nbformat") != 4:
        raise UnreadableSubmission(
            f"the notebook is of version {str(book.get('nbformat'))[:20]}; open it in JupyterLab "
            "and save it as version 4"
        )
    return book


def python_of(data: bytes) -> tuple[int, ...]:
    """The version of Python, such as (3, 13), that a notebook was last run with; () if unknown.

    Raises
    ------
    UnreadableSubmission
        Where it is no notebook of version 4.

    Examples
    --------
    >>> about = b'{"language_info": {"version": "3.13.0"}}'
    >>> python_of(b'{"nbformat": 4, "cells": [], "metadata": ' + about + b"}")
    (3, 13)
    """
    told: Any = parse_notebook(data)
    for name in ("metadata", "language_info", "version"):
        told = told.get(name) if isinstance(told, dict) else None
    found = re.match(r"(\d{1,3})\.(\d{1,3})(?!\d)", told if isinstance(told, str) else "", re.ASCII)
    return tuple(map(int, found.groups())) if found else ()


def extract_source(cell: JsonObject) -> str:
    """A cell's source, with characters that no file can hold replaced."""
    return join_text(cell.get("source")).encode("utf-8", "replace").decode("utf-8")


def join_text(text: Any) -> str:
    """The text of a cell, or of its list of lines; what is not text is dropped."""
    parts = text if isinstance(text, list) else [text]
    return "".join(part for part in parts if isinstance(part, str))
