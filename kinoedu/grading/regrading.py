"""Grade a class again after a judge was corrected, and list the scores that changed and why."""

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from ..errors import InvalidParameter
from ..support.csv_cells import escape_formula, number, write_rows
from .assignments.questions import read_course_secret
from .class_grading import Run, grade_found, list_pairs
from .collect.submissions import Submission, collect
from .judge.class_list import Class, Entry, list_varied, mark_secret, read_class
from .judge.contracts import add_section
from .report.decisions import BY_HAND, OVERRIDES, Decisions, read_decisions
from .report.rows import Row, list_class_rows, refuse_unknown_names

COLUMNS = ("student", "assignment", "question", "before", "after", "why", "kept")


class Change(NamedTuple):
    """A score that changed, and why.

    decided : the score that a person decided, which still holds, or "".
    """

    student: str
    assignment: str
    question: str
    before: float | None
    after: float | None
    why: str
    decided: str


def regrade(
    old: Path, out: Path, run: Run, folder: Path | None = None
) -> tuple[Class, list[Change]]:
    """Grade the submissions of the class in `old` again, into `out`.

    People's decisions are copied to `out`, and changes.csv is written beside the grades.

    Parameters
    ----------
    folder : where the submissions are now, if they were moved.

    Returns
    -------
    Class, list of Change
        The class as graded now, and the scores that changed.

    Raises
    ------
    InvalidParameter
        Where the class, the secret or the submissions do not fit together.
    OSError
        Where a file cannot be written.
    """
    before = read_class(old)
    if out.resolve() == old.resolve():
        raise InvalidParameter(
            f"{out} holds the grades to compare with; name another folder for the new ones"
        )
    if (
        not run.secret_file.exists()
        or mark_secret(read_course_secret(run.secret_file)) != before.secret_mark
    ):
        raise InvalidParameter(
            f"{old} was graded with the secret that was in {before.secret_file}; give it with "
            "--secret"
        )
    places = dict.fromkeys(entry.folder for entry in before.entries)
    if folder is not None and len(places) > 1:
        raise InvalidParameter(
            f"{old} was made of several folders; put each where it was: {', '.join(places)}"
        )
    found = list(collect_again(before.entries, folder, run.letter))
    if not (out / OVERRIDES).exists():  # a copy of wrong lines would stay, and be read next time
        refuse_unknown_names(read_decisions(old), list_pairs(found, []))
    out.mkdir(parents=True, exist_ok=True)
    for name in (OVERRIDES, BY_HAND):
        if (old / name).exists() and not (out / name).exists():
            shutil.copy(old / name, out / name)
    after = grade_found(found, out, run, list_varied(before.entries, folder))
    changes = list(find_changes(before, after, read_decisions(out)))
    write_changes(changes, out / "changes.csv")
    return after, changes


def collect_again(
    entries: list[Entry], folder: Path | None, letter: str
) -> Iterator[tuple[Path, str, list[Submission]]]:
    """Yield each folder of a class with its one assignment, or "", and its submissions.

    A folder that was graded whole, and for one assignment again, has each submission once: as it
    was graded last, and what was handed in since for that assignment alone.
    """
    last = {(one.student, one.assignment): (one.folder, one.only) for one in entries}
    sources = {(one.folder, one.only): one.letter for one in entries}
    for source in sorted(sources, key=lambda source: not source[1]):
        place, only = Path(source[0]) if folder is None else folder, source[1]
        mine = [
            one
            for one in collect(place, only)
            if last.setdefault((one.student, one.assignment), source) == source
        ]
        yield place, only, [add_section(one, letter or sources[source]) for one in mine]


def find_changes(before: Class, after: Class, decisions: Decisions) -> Iterator[Change]:
    """Yield every score that differs, in the order of the table."""
    was, now = ({row[:3]: row for row in list_class_rows(of, {})} for of in (before, after))
    files_before, files_after = (
        {(entry.student, entry.assignment): entry for entry in of.entries} for of in (before, after)
    )
    for whose in sorted({*was, *now}):
        old, new = was.get(whose), now.get(whose)
        scores = (old.score if old else None, new.score if new else None)
        if scores[0] != scores[1]:
            why = explain_change(old, new, files_before.get(whose[:2]), files_after.get(whose[:2]))
            decision = decisions.get(whose)
            decided = number(decision.score) if decision is not None else ""
            yield Change(*whose, *scores, why, decided)


def explain_change(
    old: Row | None, new: Row | None, file_before: Entry | None, file_after: Entry | None
) -> str:
    """The reason for a change, in words."""
    if file_after is None:
        return "the submission is no longer there"
    if file_before is None:
        return "handed in since"
    if file_before.digest != file_after.digest:
        return "another file was handed in since"
    if old is None:
        return "the assignment asks for this now"
    if new is None:
        return "the assignment no longer asks for this"
    if describe_row(new) == describe_row(old) and new.max_score != old.max_score:
        return f"worth {new.max_score:g} points now; before: {old.max_score:g}"
    return f"{describe_row(new)}; before: {describe_row(old)}"


def describe_row(row: Row) -> str:
    """A row's status and message, in words."""
    return f"{row.status}: {row.message}" if row.message and row.status != "right" else row.status


def write_changes(changes: list[Change], file: Path) -> None:
    """Write the changes as a CSV file."""
    lines = [
        [
            *map(escape_formula, one[:3]),
            *map(number, (one.before, one.after)),
            escape_formula(one.why),
            one.decided,
        ]
        for one in changes
    ]
    write_rows(file, [COLUMNS, *lines])
