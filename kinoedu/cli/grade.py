"""kinoedu grade and kinoedu regrade: run a class's submissions in a sandbox and judge them."""

import argparse
import sys
from pathlib import Path
from typing import Any

from ..errors import InvalidParameter
from ..support.progress import show_progress
from .commands import Commands

GRADE_HELP = """\
Grade a folder of submissions, or a zip of it, in the layout of nbgrader, Canvas, Moodle or
Gradescope. Results in GRADES:

  grades.csv      a row for each question
  report.html     an overview of the class
  feedback/       a page for each student
  overrides.csv   for your own decisions, which overrule the grader (docs/grading.md)

If the command is stopped, the same command continues from there.
"""

GRADE_EXAMPLES = """\
examples:
  python start.py grade submissions --out grades
  python start.py grade submissions.zip --out grades --assignment 01_geometry --workers 4
  python start.py grade submissions --out grades --dask tcp://10.0.0.1:8786

exit status: 0 everything was graded, 1 something was not, with the reason, 2 the input was wrong
"""

REGRADE_HELP = """\
Grade a class again into another folder, after a judge was repaired or files were replaced, and list
whose score changed and why. Your decisions in overrides.csv and the scores given by hand are copied
and stay valid.
"""

TRUSTED = """\
=====================================================================
  --trust: SUBMISSIONS RUN WITHOUT A SANDBOX.
  Each may read and delete what you can, send it anywhere, and write
  grades. Only for programs that you would run with your own hands.
====================================================================="""
MOST_LISTED = 20
MOST_PATIENCE = 100.0


def add_grade(commands: Commands) -> None:
    """Add the two commands and their options."""
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
        help="the folder or zip of submissions",
    )
    grade.add_argument(
        "--out", metavar="GRADES", type=Path, required=True, help="the folder of the grades"
    )
    grade.add_argument(
        "--assignment", default="", metavar="NAME", help="only this assignment, such as 01_geometry"
    )
    add_grading_options(grade)
    grade.set_defaults(run=run_grade)
    regrade = commands.add_parser(
        "regrade", help="grade a class again, and compare", description=REGRADE_HELP
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
    add_grading_options(regrade)
    regrade.set_defaults(run=run_regrade)


def add_grading_options(command: argparse.ArgumentParser) -> None:
    """Add the options that both commands have."""
    where = command.add_mutually_exclusive_group()
    where.add_argument(
        "--workers",
        type=int,
        metavar="N",
        help="the number of processes (default: one for each processor)",
    )
    where.add_argument(
        "--dask",
        metavar="ADDRESS",
        help="grade on the Dask cluster whose scheduler has this address",
    )
    command.add_argument(
        "--secret",
        metavar="FILE",
        type=Path,
        help="the course's secret, from which hidden cases are drawn",
    )
    which = command.add_mutually_exclusive_group()
    which.add_argument(
        "--variants",
        action="store_true",
        help="each student has their own variants of exercises (release --variants)",
    )
    which.add_argument(
        "--variant",
        default="",
        metavar="LETTER",
        help="all students have variant A, or B, of the exercises (release --variant)",
    )
    command.add_argument(
        "--names",
        metavar="FILE",
        type=Path,
        help="a CSV file with the columns student and name, or your export of Canvas's gradebook: "
        "the report and the pages show the names",
    )
    command.add_argument(
        "--patience",
        type=float,
        default=1.0,
        metavar="FACTOR",
        help="multiply all time limits, for a slow computer; what took too long is graded again",
    )
    command.add_argument(
        "--trust",
        action="store_true",
        help="run submissions WITHOUT A SANDBOX: they can do whatever you can",
    )


def run_grade(arguments: argparse.Namespace) -> int:
    """Grade a class, write the results, and print a summary."""
    from ..grading.class_grading import grade_class
    from ..grading.report.decisions import read_decisions
    from ..grading.report.rows import list_class_rows

    secret_file = find_secret_file(arguments, "")
    with show_progress("grading") as grading, show_progress("writing pages") as writing:
        run = make_run(arguments, secret_file, grading, writing)
        of = grade_class(arguments.submissions, arguments.assignment, arguments.out, run)
    warn_of_old_exports(of, list_class_rows(of, read_decisions(of.out)))
    return sum_up(of, list_class_rows(of, {}))


def run_regrade(arguments: argparse.Namespace) -> int:
    """Grade a class again, and list what changed."""
    from ..grading.judge.class_list import read_class
    from ..grading.regrading import regrade
    from ..grading.report.rows import list_class_rows
    from ..support.csv_cells import number, one_line

    secret_file = find_secret_file(arguments, read_class(arguments.old).secret_file)
    with show_progress("grading") as grading, show_progress("writing pages") as writing:
        of, changes = regrade(
            arguments.old,
            arguments.out,
            make_run(arguments, secret_file, grading, writing),
            arguments.submissions,
        )
    status = sum_up(of, list_class_rows(of, {}))
    listed = f"; all of them in {of.out / 'changes.csv'}" if changes else ""
    print(f"{len(changes)} scores changed{listed}")
    for one in changes[:MOST_LISTED]:
        note = f" (yours holds: {one.decided})" if one.decided else ""
        scores = f"{number(one.before) or '-'} -> {number(one.after) or '-'}"
        question = f"{one.student} {one.assignment} {one.question}"
        print(f"  {one_line(f'{question}: {scores}{note}; {one.why}')}")
    return status


def find_secret_file(arguments: argparse.Namespace, before: str) -> Path:
    """The file of the course's secret: as given, else `before`, else this user's own."""
    from ..grading.assignments.secret_place import default_secret_file

    return arguments.secret or (Path(before) if before else default_secret_file())


def make_run(arguments: argparse.Namespace, secret_file: Path, grading: Any, writing: Any) -> Any:
    """Collect the settings of a grading run."""
    from ..grading.class_grading import Run
    from ..grading.judge.running import use_dask_workers, use_local_workers

    if arguments.workers is not None and arguments.workers < 1:
        raise InvalidParameter(f"--workers must be at least 1, got {arguments.workers}")
    if not 1.0 <= arguments.patience <= MOST_PATIENCE:
        raise InvalidParameter(
            f"--patience must be a number from 1 to {MOST_PATIENCE:g}, got {arguments.patience:g}"
        )
    if arguments.trust:
        print(TRUSTED, file=sys.stderr)
    place = (
        use_dask_workers(arguments.dask)
        if arguments.dask is not None
        else use_local_workers(arguments.workers)
    )
    return Run(
        secret_file,
        place,
        arguments.trust,
        grading,
        writing,
        arguments.variants,
        arguments.patience,
        arguments.names,
        arguments.variant,
    )


def warn_of_old_exports(of: Any, rows: Any) -> None:
    """Print a warning for each exported table that was made of other grades."""
    from ..grading.export.freshness import list_old_exports

    for place in list_old_exports(of, rows):
        print(
            f"kinoedu: warning: {place} was exported from other grades; export again",
            file=sys.stderr,
        )


def sum_up(of: Any, rows: Any) -> int:
    """Print how many submissions were graded, and a line for each that was not; the exit status."""
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
