"""kinoedu grade and kinoedu regrade: a class's submissions, run in a sandbox and judged."""

import argparse
import sys
from pathlib import Path
from typing import Any

from ..errors import InvalidParameter
from ..support.progress import show_progress

GRADE_HELP = """\
Grade a folder of submissions, as nbgrader, Canvas, Moodle or Gradescope lay them out, or a zip of it. Into GRADES go

  grades.csv    a row for each question       report.html   the class at a glance
  feedback/     a page for each student       overrides.csv is yours: what it says overrules (docs/grading.md)

The same command, stopped at any time, goes on where it stopped.
"""

GRADE_EXAMPLES = """\
examples:
  python start.py grade submissions --out grades
  python start.py grade submissions.zip --out grades --assignment 01_geometry --workers 4
  python start.py grade submissions --out grades --dask tcp://10.0.0.1:8786

exit status: 0 everything was graded, 1 something was not, with the reason, 2 the input was wrong
"""

REGRADE_HELP = """\
Grade a class once more, after a judge was repaired or files were replaced, into another folder; list whose score changed and why.
What you decided in overrides.csv, and what was graded by hand, goes along and still holds.
"""

TRUSTED = """\
=====================================================================
  --trust: SUBMISSIONS RUN WITHOUT A SANDBOX.
  Each may read and delete what you can, send it anywhere, and write
  grades. Only for programs that you would run with your own hands.
====================================================================="""
MOST_LISTED = 20


def add_grade(commands: Any) -> None:
    """The commands and their options."""
    raw = argparse.RawDescriptionHelpFormatter
    grade = commands.add_parser(
        "grade",
        help="grade a class's submissions",
        description=GRADE_HELP,
        epilog=GRADE_EXAMPLES,
        formatter_class=raw,
    )
    grade.add_argument(
        "submissions",
        metavar="SUBMISSIONS",
        type=Path,
        help="the folder or zip of what was handed in",
    )
    grade.add_argument(
        "--out", metavar="GRADES", type=Path, required=True, help="the folder of the grades"
    )
    grade.add_argument(
        "--assignment", default="", metavar="NAME", help="only this one, such as 01_geometry"
    )
    add_how(grade)
    grade.set_defaults(run=run_grade)
    regrade = commands.add_parser(
        "regrade", help="grade a class once more, and compare", description=REGRADE_HELP
    )
    regrade.add_argument(
        "old", metavar="OLD", type=Path, help="the folder of the grades to compare with"
    )
    regrade.add_argument(
        "--out", metavar="NEW", type=Path, required=True, help="the folder of the new grades"
    )
    regrade.add_argument(
        "--submissions",
        metavar="FOLDER",
        type=Path,
        help="where the submissions are now (default: where they were)",
    )
    add_how(regrade)
    regrade.set_defaults(run=run_regrade)


def add_how(command: argparse.ArgumentParser) -> None:
    """What both have in common."""
    where = command.add_mutually_exclusive_group()
    where.add_argument(
        "--workers",
        type=int,
        metavar="N",
        help="so many processes (default: one for each processor)",
    )
    where.add_argument(
        "--dask", metavar="ADDRESS", help="grade on the Dask cluster whose scheduler is there"
    )
    command.add_argument(
        "--secret",
        metavar="FILE",
        type=Path,
        help="the course's secret, from which hidden cases are drawn",
    )
    command.add_argument(
        "--variants",
        action="store_true",
        help="each student has contracts of their own (release --variants)",
    )
    command.add_argument(
        "--trust",
        action="store_true",
        help="run submissions WITHOUT A SANDBOX: they may do whatever you may",
    )


def run_grade(arguments: argparse.Namespace) -> int:
    """Grade, write, and say what came out."""
    from ..grading.class_grading import grade_class
    from ..grading.report.rows import class_rows

    secret_file = secret_of(arguments, "")
    with show_progress("grading") as grading, show_progress("writing pages") as writing:
        run = run_of(arguments, secret_file, grading, writing)
        of = grade_class(arguments.submissions, arguments.assignment, arguments.out, run)
    return sum_up(of, class_rows(of, {}))


def run_regrade(arguments: argparse.Namespace) -> int:
    """Grade anew, and list what changed."""
    from ..grading.judge.class_list import read_class
    from ..grading.regrading import regrade
    from ..grading.report.rows import class_rows
    from ..support.csv_cells import number, one_line

    secret_file = secret_of(arguments, read_class(arguments.old).secret_file)
    with show_progress("grading") as grading, show_progress("writing pages") as writing:
        of, changes = regrade(
            arguments.old,
            arguments.out,
            run_of(arguments, secret_file, grading, writing),
            arguments.submissions,
        )
    status = sum_up(of, class_rows(of, {}))
    print(
        f"{len(changes)} scores changed"
        + (f"; all of them in {of.out / 'changes.csv'}" if changes else "")
    )
    for one in changes[:MOST_LISTED]:
        kept = f" (yours holds: {one.kept})" if one.kept else ""
        scores = f"{number(one.before) or '-'} -> {number(one.after) or '-'}"
        print(
            "  "
            f"{one_line(f'{one.student} {one.assignment} {one.question}: {scores}{kept}; {one.why}')}"
        )
    return status


def secret_of(arguments: argparse.Namespace, before: str) -> Path:
    """The secret's file: as given, as before, or this user's own; says so where it is made."""
    from ..grading.assignments.secret_place import usual_secret

    file = arguments.secret or (Path(before) if before else usual_secret())
    if not file.exists() and not before:
        print(
            f"kinoedu: the course's secret is made, once, in {file}; keep it, and keep it to "
            "yourself",
            file=sys.stderr,
        )
    return Path(file)


def run_of(arguments: argparse.Namespace, secret_file: Path, grading: Any, writing: Any) -> Any:
    """How it is to be done."""
    from ..grading.class_grading import Run
    from ..grading.judge.running import dask, local

    if arguments.workers is not None and arguments.workers < 1:
        raise InvalidParameter(f"--workers is a number from 1, got {arguments.workers}")
    if arguments.trust:
        print(TRUSTED, file=sys.stderr)
    place = dask(arguments.dask) if arguments.dask is not None else local(arguments.workers)
    return Run(secret_file, place, arguments.trust, grading, writing, arguments.variants)


def sum_up(of: Any, rows: Any) -> int:
    """One line on what was graded, one for each that was not, and what to do next."""
    from ..grading.report.rows import NOT_GRADED, UNREADABLE
    from ..support.csv_cells import one_line

    bad = {row[:2]: row for row in rows if row.status in (UNREADABLE, NOT_GRADED)}
    lost = [entry for entry in of.entries if (entry.student, entry.assignment) in bad]
    unreadable = sum(bad[entry.student, entry.assignment].status == UNREADABLE for entry in lost)
    counts = (
        f"{len(of.entries) - len(lost)} graded, {len(lost) - unreadable} not graded, {unreadable} "
        "unreadable"
    )
    late = sum(entry.late for entry in of.entries)
    marked = f", {late} of them handed in late" if late else ""
    print(
        f"{counts}{marked}; look at {of.out / 'report.html'}; scores are in {of.out / 'grades.csv'}"
    )
    for entry in lost[:MOST_LISTED]:
        row = bad[entry.student, entry.assignment]
        print(f"  {one_line(f'{entry.student}, {entry.file}: {row.status}: {row.message}')}")
    if len(lost) > MOST_LISTED:
        print(f"  and {len(lost) - MOST_LISTED} more, in the report")
    if len(lost) > unreadable:
        print("what was not graded is tried again by the same command")
    return 1 if lost else 0
