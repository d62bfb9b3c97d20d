"""The names of students, from a table or from Gradescope's list.

A table has the columns student and name, or is the gradebook that Canvas exports.
"""

import csv
import io
import re
import zipfile
from collections.abc import Iterator
from pathlib import Path

from ...errors import InvalidParameter
from ...support.csv_cells import one_line, unescape_formula
from .found import METADATA, UNREADABLE, read_member
from .gradescope import read_submitters
from .notebook import UnreadableSubmission, read_bytes

Names = dict[str, str]  # by id, in small letters
CANVAS_IDS = ("ID", "SIS User ID", "SIS Login ID")


def find_name(student: str, names: Names) -> str:
    """The name of a student, or ""."""
    return names.get(one_line(student).casefold(), "")


def read_names(file: Path) -> Names:
    """The names in a table. Raises InvalidParameter where it is no such table."""
    try:
        text = file.read_text(encoding="utf-8-sig")
        reader = csv.DictReader(io.StringIO(text, newline=""))
        head, rows = reader.fieldnames or (), list(reader)
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise InvalidParameter(f"{file} cannot be read as CSV in UTF-8: {error}") from error
    if {"student", "name"} <= set(head):
        pairs = [(row["student"] or "", row["name"] or "") for row in rows]
    elif {"Student", "ID"} <= set(head):
        pairs = [pair for row in rows for pair in name_in_canvas(row)]
    else:
        raise InvalidParameter(
            f"{file} has neither the columns student and name nor those of Canvas's gradebook; "
            "its first line should be student,name"
        )
    return {
        one_line(unescape_formula(one.strip())).casefold(): unescape_formula(name.strip())
        for one, name in pairs
        if one
    }


def name_in_canvas(row: dict[str, str | None]) -> Iterator[tuple[str, str]]:
    """Yield each id of a line of Canvas's gradebook, with the name.

    Canvas names files "doejane_1234" for "Doe, Jane", and keeps letters of all alphabets.
    """
    name, number = row.get("Student") or "", row.get("ID") or ""
    last, comma, first = name.partition(",")
    full_name = f"{first.strip()} {last.strip()}" if comma else name
    if number:
        yield re.sub(r"\W", "", name) + f"_{number}", full_name
        yield from ((row.get(column) or "", full_name) for column in CANVAS_IDS)


def read_gradescope_names(folder: Path) -> Names:
    """The names in the list beside Gradescope's folders; none where there is no such list."""
    try:
        submitters = read_submitters(read_list(folder)).values()
    except (*UNREADABLE, UnreadableSubmission):
        return {}
    everybody = (one for group in submitters for one in group)
    return {one_line(one.id).casefold(): one.name for one in everybody if one.name}


def read_list(folder: Path) -> bytes:
    """Gradescope's list of the students in a folder or zip; empty if there is none.

    It is beside the students' folders, alone at the top or in the only folder there. A file of
    that name in a student's own folder is not read.
    """
    if not folder.is_file():
        inside = [one for one in folder.iterdir() if not one.name.startswith(".")]
        file = (inside[0] if len(inside) == 1 and inside[0].is_dir() else folder) / METADATA
        return read_bytes(file) if file.is_file() else b""
    if folder.suffix.lower() != ".zip":
        return b""
    with zipfile.ZipFile(folder) as archive:
        names = {one.filename: one for one in archive.infolist()}
        tops = {name.partition("/")[0] for name in names}
        place = METADATA if len(tops) > 1 else f"{min(tops, default='')}/{METADATA}"
        return read_member(archive, names[place], (METADATA,)).data if place in names else b""
