"""Grade a folder of submissions."""

from itertools import islice
from pathlib import Path
from typing import NamedTuple

from ..errors import InvalidParameter
from ..support.progress import Progress
from .assignments.questions import read_course_secret
from .collect.names import read_gradescope_names, read_names
from .collect.submissions import Submission, collect, warn_of_same
from .judge.class_list import (
    FILE,
    Class,
    Entry,
    add_earlier,
    add_names,
    list_varied,
    locked_class,
    make_entry,
    mark_secret,
    read_class,
    warn_of_replaced,
    write_class,
)
from .judge.contracts import add_section, leave_usual, vary
from .judge.running import Place, grade_all, use_local_workers
from .report.decisions import read_decisions
from .report.rows import refuse_unknown_names
from .report.writing import write_all
from .sandbox.sandbox import explain_no_sandbox


class Run(NamedTuple):
    """How a class is graded.

    secret_file : the file with the course's secret.
    place : where notebooks are graded, such as `running.use_local_workers()`.
    trusted : whether programs run without a sandbox.
    grading, writing : called with the progress of each stage.
    variants : whether each student has contracts of their own.
    patience : a factor on all time limits, for slow computers.
    names : a table with the students' names, or None.
    letter : the variant of the section, such as B, or "".
    """

    secret_file: Path
    place: Place = use_local_workers()
    trusted: bool = False
    grading: Progress | None = None
    writing: Progress | None = None
    variants: bool = False
    patience: float = 1.0
    names: Path | None = None
    letter: str = ""


def list_pairs(
    sources: list[tuple[Path, str, list[Submission]]], earlier: list[Entry]
) -> set[tuple[str, str]]:
    """The students and their assignments, before anything is graded."""
    folders = {(str(folder.resolve()), only) for folder, only, _ in sources}
    now = {(one.student, one.assignment) for _, _, found in sources for one in found}
    kept = {
        (one.student, one.assignment) for one in earlier if (one.folder, one.only) not in folders
    }
    return now | kept


def require_sandbox(trusted: bool) -> None:
    """Raise InvalidParameter if programs are not trusted and cannot be run in a sandbox."""
    reason = "" if trusted else explain_no_sandbox()
    if reason:
        raise InvalidParameter(
            f"submissions are strangers' programs, and cannot be shut in here: {reason}. If every "
            "one of them may do on this computer what you may, --trust runs them without a sandbox"
        )


def refuse_out_among_submissions(out: Path, folders: list[Path]) -> None:
    """Raise InvalidParameter where the next grading would take what is written for submissions."""
    place = out.resolve()
    for folder in folders:
        if folder.resolve() in (place, *place.parents):
            raise InvalidParameter(
                f"{out} is in {folder}, where the next grading would take it for a student's; name "
                "a folder outside"
            )


def read_earlier(out: Path, secret: bytes) -> Class | None:
    """The class that a folder of grades holds already, or None.

    Raises InvalidParameter where it was graded with another secret.
    """
    earlier = read_class(out) if (out / FILE).exists() else None
    if earlier is not None and earlier.secret_mark != mark_secret(secret):
        raise InvalidParameter(
            f"{out} was graded with another secret, that of {earlier.secret_file}; name that one "
            "with --secret, or another folder"
        )
    return earlier


def grade_class(folder: Path, only: str, out: Path, run: Run) -> Class:
    """Grade the submissions in a folder or zip, and write the tables and pages.

    Grades of other folders that `out` already holds are kept.

    Parameters
    ----------
    folder : the folder or zip of submissions.
    only : the one assignment to grade, or "" for all.
    out : the folder of the grades.

    Raises
    ------
    InvalidParameter
        Where the submissions, the secret or a decision cannot be used.
    OSError
        Where a file cannot be written.
    """
    found = [add_section(one, run.letter) for one in collect(folder, only)]
    return grade_found([(folder, only, found)], out, run)


def grade_found(
    sources: list[tuple[Path, str, list[Submission]]],
    out: Path,
    run: Run,
    varied: set[tuple[str, str]] | None = None,
) -> Class:
    """Grade submissions that are collected already; otherwise like `grade_class`.

    Parameters
    ----------
    sources : for each folder its path, its one assignment ("" for all) and its submissions.
    varied : the folders with such an assignment whose students have contracts of their own; by
        default those that `out` remembers.
    """
    require_sandbox(run.trusted)
    if not any(found for _, _, found in sources):
        raise InvalidParameter(f"{sources[0][0]} holds no notebooks, and no zips of them")
    refuse_out_among_submissions(out, [folder for folder, _, _ in sources])
    secret = read_course_secret(run.secret_file)
    earlier = read_earlier(out, secret)
    names = {
        key: name for folder, _, _ in sources for key, name in read_gradescope_names(folder).items()
    } | (read_names(run.names) if run.names is not None else {})
    refuse_unknown_names(
        read_decisions(out), list_pairs(sources, earlier.entries if earlier is not None else [])
    )
    if varied is None:
        varied = list_varied(earlier.entries if earlier is not None else [])
    submissions = []
    for folder, only, found in sources:
        warn_of_same(found)
        has_own = run.variants or (str(folder.resolve()), only) in varied
        submissions += vary(found, secret) if has_own else leave_usual(found)
    out.mkdir(parents=True, exist_ok=True)
    graded = iter(
        grade_all(
            submissions,
            out,
            secret,
            place=run.place,
            progress=run.grading,
            trusted=run.trusted,
            patience=run.patience,
        )
    )
    entries = [
        make_entry(one, folder, only, secret)
        for folder, only, found in sources
        for one in islice(graded, len(found))
    ]
    with locked_class(out):  # another command may have added its students meanwhile
        earlier = read_earlier(out, secret)
        before = earlier.entries if earlier is not None else []
        warn_of_replaced(entries, before)
        kept = add_names(add_earlier(entries, before), before, names)
        of = Class(out, str(run.secret_file.resolve()), mark_secret(secret), run.trusted, kept)
        write_class(of)
        write_all(of, run.writing)
    return of
