"""The course's own notebooks as JSON data; `grading/collect/notebook.py` reads students'."""

import json
from pathlib import Path

from ..errors import UnreadableScene
from .json_fields import JsonObject
from .reading import read_text


def read_notebook(file: Path) -> JsonObject:
    """A notebook of the course: its `cells` are a list of objects with metadata and source.

    Raises
    ------
    UnreadableScene
        Where the file is missing or no notebook, as after a merge that was not resolved. The
        message names the file.
    """
    text = read_text(file)
    try:
        book = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise damaged(file, str(error)) from error
    cells = book.get("cells") if isinstance(book, dict) else None
    if not isinstance(cells, list) or not all(map(is_cell, cells)):
        raise damaged(file, "something else")
    return dict(book)


def is_cell(cell: object) -> bool:
    """Whether something is a cell of a notebook of version 4."""
    return isinstance(cell, dict) and {"cell_type", "metadata", "source"} <= cell.keys()


def damaged(file: Path, found: str) -> UnreadableScene:
    """The error for a file that is no notebook."""
    return UnreadableScene(
        f"{file}: expected a notebook, got {found}; restore it, or save it again in JupyterLab"
    )
