"""Write what people read of a class: grades.csv, report.html, and a page for each student."""

import shutil
from pathlib import Path

from ..judge.class_list import Class, Entry, read_record
from ..judge.running import Progress
from .decisions import read_decisions
from .feedback_page import name_page, render_feedback
from .pages import write_page
from .report_page import render_report
from .rows import Row, list_class_rows, write_grades


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
    for done, (name, whose) in enumerate(pages.items(), 1):
        write_page(of.out / name, render_page(mine[whose], entries[whose], of.out))
        if progress is not None:
            progress(done, len(pages))
    remove_others(of.out / "feedback", {of.out / name for name in pages})
    return rows


def render_page(rows: list[Row], entry: Entry, out: Path) -> str:
    """The page of one submission."""
    record = read_record(entry, out)
    trouble = entry.trouble if record is None else record["message"]
    return render_feedback(rows, record, trouble, out / "pictures")


def remove_others(folder: Path, kept: set[Path]) -> None:
    """Remove the pages of submissions that are gone, so that nobody hands them out."""
    for file in folder.rglob("*.html"):
        if file not in kept:
            file.unlink()
    for below in folder.iterdir() if folder.is_dir() else ():
        if below.is_dir() and not any(below.iterdir()):
            shutil.rmtree(below)
