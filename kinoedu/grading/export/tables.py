"""Grades for other programs: a plain table, a table for Canvas, and Gradescope's results."""

import csv
import io
import json
import re
from collections.abc import Iterable
from itertools import groupby
from pathlib import Path

from ...errors import InvalidParameter
from ...support.csv_cells import escape_formula, number, one_line, write_rows
from ...support.file_names import file_name
from ...support.text import show_controls
from ...support.whole_files import written_whole
from ..report.rows import Row, Total, sum_totals

# Canvas's columns that identify a student
IDENTITIES = ("Student", "ID", "SIS User ID", "SIS Login ID")


def export_csv(rows: list[Row], file: Path) -> None:
    """Write a row for each student and a column for each assignment.

    A cell is empty while a question of that assignment has no score.
    """
    found = sum_totals(rows)
    names = sorted({name for _, name in found if name})
    lines = [
        [
            escape_formula(student),
            *(format_complete_total(found.get((student, name))) for name in names),
        ]
        for student in sorted({row.student for row in rows})
    ]
    write_rows(file, [["student", *names], *lines])


def format_complete_total(total: Total | None) -> str:
    """A total as a cell; "" while a question has no score."""
    return "" if total is None or total.waiting else number(total.score)


def export_canvas(
    rows: list[Row], template: Path, file: Path, column: str = ""
) -> tuple[list[str], list[str]]:
    """Fill in the assignments' columns of a gradebook that was exported from Canvas.

    A column belongs to the assignment of its name. Cells of students with a question that has no
    score yet stay as they are.

    Parameters
    ----------
    template : the export from Canvas.
    column : the column's name, if there is only one assignment and its column is named otherwise.

    Returns
    -------
    list of str, list of str
        The students in the grades who are not in Canvas, and the assignments without a column.

    Raises
    ------
    InvalidParameter
        Where `template` is no export from Canvas, or has no such column.
    """
    lines = read_canvas(template)
    head, found = lines[0], sum_totals(rows)
    names = sorted({name for _, name in found if name})
    places = find_canvas_columns(head, names, column, template)
    known = find_canvas_students(lines)
    missing: list[str] = []
    for (student, assignment), total in found.items():
        line = known.get(student.lower())
        if line is None:
            missing.append(student)
        elif assignment in places and format_complete_total(total):
            line += [""] * (len(head) - len(line))
            line[places[assignment]] = format_complete_total(total)
    stream = io.StringIO(newline="")
    # names stay as Canvas spells them, since it finds its students by them
    csv.writer(stream, lineterminator="\n").writerows(lines)
    with written_whole(file) as part:
        part.write_text(stream.getvalue(), encoding="utf-8")
    return sorted(set(missing)), [name for name in names if name not in places]


def find_canvas_students(lines: list[list[str]]) -> dict[str, list[str]]:
    """Each student's line, by every name that is unique to the student.

    Names are the id, the login, and the prefix that Canvas gives to files, as in doejane_1234.
    """
    head, names = lines[0], dict[str, list[list[str]]]()
    for line in lines[1:]:
        cells = {
            name: one_line(line[at]).lower()
            for at, name in enumerate(head)
            if name in IDENTITIES and at < len(line)
        }
        called = re.sub(r"\W", "", cells.get("Student", ""))
        for name in {*cells.values(), f"{called}_{cells.get('ID', '')}"} - {"", "_"}:
            names.setdefault(name, []).append(line)
    return {name: found[0] for name, found in names.items() if len(found) == 1}


def read_canvas(template: Path) -> list[list[str]]:
    """The rows of an export from Canvas. Raises InvalidParameter."""
    try:
        lines = list(csv.reader(io.StringIO(template.read_text(encoding="utf-8-sig"), newline="")))
    except (UnicodeDecodeError, csv.Error) as error:
        raise InvalidParameter(f"{template} cannot be read as CSV: {error}") from error
    if not lines or not {"Student", "ID"} <= set(lines[0]):
        raise InvalidParameter(
            f"{template} is no export of Canvas's gradebook: its first line has no columns "
            "Student and ID"
        )
    return lines


def find_canvas_columns(
    head: list[str], names: list[str], column: str, template: Path
) -> dict[str, int]:
    """The place of each assignment's column. Raises InvalidParameter.

    Canvas writes "01 Geometry (12345)" for 01_geometry.
    """
    plain = [re.sub(r"[^a-z0-9]", "", re.sub(r"\(\d+\)\s*$", "", name).lower()) for name in head]
    if column:
        at = [
            place
            for place, name in enumerate(head)
            if column in (name, re.sub(r"\s*\(\d+\)\s*$", "", name))
        ]
        if len(names) != 1:
            raise InvalidParameter(
                f"--column is for one assignment; choose one with --assignment: {', '.join(names)}"
            )
        if len(at) != 1:
            raise InvalidParameter(
                f"{len(at)} columns of {template} are named {column!r}; there are: "
                f"{', '.join(head)}"
            )
        return {names[0]: at[0]}
    keys = {name: re.sub(r"[^a-z0-9]", "", name.lower()) for name in names}
    several = next((name for name, key in keys.items() if plain.count(key) > 1), "")
    if several:
        raise InvalidParameter(
            f"{plain.count(keys[several])} columns of {template} are named like {several}; choose "
            "one with --assignment and --column, by its whole name"
        )
    places = {name: plain.index(key) for name, key in keys.items() if key in plain}
    if not places:
        raise InvalidParameter(
            f"no column of {template} is named like {' or '.join(names)}; choose "
            "them with --assignment and --column"
        )
    return places


def export_gradescope(rows: list[Row], folder: Path) -> tuple[int, list[str]]:
    """Write a results.json for each submission, in the format of Gradescope's autograders.

    A submission without any score has no file, not even that of an earlier export: a file without a
    score would count as zero.

    Returns
    -------
    int, list of str
        The number of files, and the submissions without a score.
    """
    folder.mkdir(parents=True, exist_ok=True)
    count, missing = 0, []
    for (student, assignment), group in groupby(rows, key=lambda row: row[:2]):
        its = list(group)
        file = folder / f"{file_name(student)}.{file_name(assignment)}.json"
        if all(row.score is None for row in its):
            file.unlink(missing_ok=True)
            missing.append(f"{student} {assignment}".strip())
            continue
        with written_whole(file) as part:
            part.write_text(
                json.dumps(make_gradescope_results(its), indent=1) + "\n", encoding="ascii"
            )
        count += 1
    return count, missing


def make_gradescope_results(rows: Iterable[Row]) -> dict[str, object]:
    """The results of one submission as Gradescope reads them."""
    its = list(rows)
    return {
        "score": round(sum(round(row.score or 0.0, 6) for row in its), 6),
        "visibility": "visible",
        "tests": [make_gradescope_test(row) for row in its],
    }


def make_gradescope_test(row: Row) -> dict[str, object]:
    """The results of one question; one without a score yet has no points, not even zero."""
    output = f"{row.status}: {row.message}" if row.message else row.status
    points: dict[str, object] = {}
    if row.score is not None:
        points = {
            "score": round(row.score, 6),
            "max_score": row.max_score,
            "status": "passed" if row.score >= row.max_score else "failed",
        }
    return {
        "name": row.question,
        **points,
        "output": show_controls(output),
        "output_format": "text",
    }
