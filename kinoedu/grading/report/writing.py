"""Write what people read of a class: grades.csv, report.html, and a page for each student."""

import hashlib
import json
import os
import shutil
from pathlib import Path

from ...support.progress import Progress
from ...support.whole_files import written_whole
from ..judge.class_list import Class, Entry, read_record
from ..judge.running import digest_library
from ..judge.submission import Grade
from .decisions import read_decisions
from .feedback_page import name_page, render_feedback
from .pages import write_page
from .report_page import render_report
from .rows import Row, list_class_rows, write_grades

MADE = "pages.json"  # of what each page was made; a page of an unchanged result is kept


def write_all(of: Class, progress: Progress | None = None) -> list[Row]:
    """Write all tables and pages of a class; equal classes give equal bytes.

    Returns
    -------
    list of Row
        The rows of grades.csv.

    Raises
    ------
    InvalidParameter
        Where a decision is wrong.
    OSError
        Where a file cannot be written.
    """
    rows = list_class_rows(of, read_decisions(of.out))
    write_grades(rows, of.out / "grades.csv")
    write_page(of.out / "report.html", render_report(of, rows))
    mine: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        mine.setdefault((row.student, row.assignment), []).append(row)
    pages = {name_page(*whose): whose for whose in mine}
    entries = {(entry.student, entry.assignment): entry for entry in of.entries}
    before, now = read_made(of.out / MADE), dict[str, list[str]]()
    for done, (name, whose) in enumerate(pages.items(), 1):
        file, entry = of.out / name, entries[whose]
        record = read_record(entry, of.out)
        key = digest_page(mine[whose], entry, record)
        if before.get(name) != [key, digest_file(file)]:
            write_page(file, render_page(mine[whose], entry, record, of.out))
        now[name] = [key, digest_file(file)]
        if progress is not None:
            progress(done, len(pages))
    with written_whole(of.out / MADE) as part:
        part.write_text(json.dumps(now, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    remove_others(of.out / "feedback", {of.out / name for name in pages})
    return rows


def read_made(file: Path) -> dict[str, list[str]]:
    """The pages that were made before: of what each was made, and what it was."""
    try:
        found = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def digest_page(rows: list[Row], entry: Entry, record: Grade | None) -> str:
    """The digest of everything of which a page is made."""
    language = os.environ.get("KINOEDU_LANGUAGE", "")
    text = json.dumps([rows, entry, record, language, digest_library()], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:40]


def digest_file(file: Path) -> str:
    """The digest of a file; "" where there is none."""
    return hashlib.sha256(file.read_bytes()).hexdigest()[:40] if file.is_file() else ""


def render_page(rows: list[Row], entry: Entry, record: Grade | None, out: Path) -> str:
    """The page of one submission."""
    trouble = entry.trouble if record is None else record["message"]
    return render_feedback(rows, record, trouble, out / "pictures", entry.name)


def remove_others(folder: Path, written: set[Path]) -> None:
    """Remove the pages of submissions that are gone, so that nobody hands them out.

    And pages that were half-written when a command was killed.
    """
    for file in [*folder.rglob("*.html"), *folder.rglob("*.part")]:
        if file not in written:
            file.unlink()
    for below in folder.iterdir() if folder.is_dir() else ():
        if below.is_dir() and not any(below.iterdir()):
            shutil.rmtree(below)
