"""Warnings where tables, pages, exports and submissions of a class no longer agree."""

import hashlib
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ...errors import InvalidParameter
from ...support.csv_cells import format_table, one_line
from ...support.whole_files import written_whole
from ..collect.notebook import UnreadableSubmission
from ..collect.submissions import collect
from ..judge.class_list import Class, digest_submission
from ..report.rows import Row, format_grades

FILE = "exports.json"  # the tables that were exported, and of which grades
MOST_NAMED = 5


def list_warnings(of: Class, rows: list[Row]) -> Iterator[str]:
    """Yield what somebody should know who exports these rows."""
    if is_table_old(of, rows):
        yield (
            f"{of.out / 'grades.csv'}, the report and the pages are older than your decisions or "
            "results; grade again to renew them. This export is up to date"
        )
    yield from list_changed_files(of)


def is_table_old(of: Class, rows: list[Row]) -> bool:
    """Whether grades.csv does not hold these rows."""
    file = of.out / "grades.csv"
    return not file.is_file() or file.read_bytes() != format_table(format_grades(rows))


def list_changed_files(of: Class) -> Iterator[str]:
    """Yield a warning for submissions that changed, came or went since they were graded.

    Those in whose place a later command graded others, such as corrected ones, do not count.
    """
    graded = {(entry.student, entry.assignment) for entry in of.entries}
    for folder, only in dict.fromkeys((entry.folder, entry.only) for entry in of.entries):
        try:
            found = collect(Path(folder), only)
        except (InvalidParameter, UnreadableSubmission, OSError):
            yield f"the submissions are no longer in {folder}, so nobody knows if they changed"
            continue
        now = {(one.student, one.assignment): digest_submission(one) for one in found}
        then = {
            (entry.student, entry.assignment): entry.digest
            for entry in of.entries
            if (entry.folder, entry.only) == (folder, only)
        }
        mine = {*now, *then} - (graded - {*then})
        changed = sorted(who for who in mine if now.get(who) != then.get(who))
        if changed:
            named = ", ".join(" ".join(who) for who in changed[:MOST_NAMED])
            more = f" and {len(changed) - MOST_NAMED} more" if len(changed) > MOST_NAMED else ""
            yield (
                f"these submissions in {folder} changed, came or went since they were graded: "
                f"{one_line(named)}{more}; grade again"
            )


def note_export(of: Class, rows: list[Row], what: str, place: Path) -> None:
    """Note of which rows a table was exported."""
    noted = read_exports(of)
    assignments = sorted({row.assignment for row in rows})
    noted[str(place.resolve())] = [what, assignments, digest_rows(rows)]
    with written_whole(of.out / FILE) as part:
        part.write_text(json.dumps(noted, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def renew_export(of: Class, before: list[Row], rows: list[Row], place: Path) -> None:
    """Note that what was exported from rows `before` agrees with these rows, which it has changed.

    What was exported from yet other rows stays old.
    """
    where = str(place.resolve())
    noted = read_exports(of).get(where)
    if noted is not None and where not in list_old_exports(of, before):
        what, assignments, _ = noted
        note_export(of, [row for row in rows if row.assignment in assignments], what, place)


def list_old_exports(of: Class, rows: list[Row]) -> list[str]:
    """The exported tables that are still there and were made of other grades."""
    return [
        place
        for place, (_, assignments, digest) in read_exports(of).items()
        if Path(place).exists()
        and digest != digest_rows([row for row in rows if row.assignment in assignments])
    ]


def read_exports(of: Class) -> dict[str, list[Any]]:
    """What was exported, by its place; nothing if the file is damaged."""
    try:
        found = json.loads((of.out / FILE).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def digest_rows(rows: list[Row]) -> str:
    """The digest of rows."""
    return hashlib.sha256(json.dumps(rows).encode()).hexdigest()[:40]
