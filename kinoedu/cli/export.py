"""kinoedu export: write grades for other programs."""

import argparse
import importlib.util
import sys
from pathlib import Path
from typing import Any

from ..errors import InvalidParameter
from ..support.progress import show_stage
from .commands import Commands

EXPORT_HELP = """\
Write the grades in the formats of other programs.

  csv         a line for each student, a column for each assignment
  canvas      your own export of Canvas's gradebook (--template), with the assignment's column
              filled in; import it into Canvas
  gradescope  a results.json for each submission
  nbgrader    a course folder with nbgrader's gradebook; formgrader shows the answers that people
              grade

Or, without grades, pack an autograder that runs on Gradescope: --gradescope-autograder.
"""

EXPORT_EXAMPLES = """\
examples:
  python start.py export grades --to csv
  python start.py export grades --to canvas --template from_canvas.csv --out to_canvas.csv
  python start.py export grades --to nbgrader --out nbgrader
  python start.py export grades --from-nbgrader nbgrader     (reads the scores given there)
  python start.py export --gradescope-autograder autograder.zip --assignment 01_geometry
"""

TRUST_CONTAINER = (
    "gradescope-autograder: if no sandbox can be made there, run programs WITHOUT ONE, as an "
    "ordinary user"
)
ONLY_FOR = {
    "template": "--to canvas",
    "column": "--to canvas",
    "secret": "--gradescope-autograder",
    "variant": "--gradescope-autograder",
    "trust_container": "--gradescope-autograder",
}


def add_export(commands: Commands) -> None:
    """Add the command and its options."""
    export = commands.add_parser(
        "export",
        help="write grades for Canvas, Gradescope, nbgrader, or a spreadsheet",
        description=EXPORT_HELP,
        epilog=EXPORT_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    export.add_argument(
        "grades", metavar="GRADES", type=Path, nargs="?", help="the folder that kinoedu grade made"
    )
    what = export.add_mutually_exclusive_group(required=True)
    what.add_argument("--to", choices=tuple(EXPORTS), help="the format")
    what.add_argument(
        "--from-nbgrader",
        metavar="FOLDER",
        type=Path,
        help="read the scores that people gave in formgrader",
    )
    what.add_argument(
        "--gradescope-autograder",
        metavar="ZIP",
        type=Path,
        help="pack an autograder of --assignment for Gradescope",
    )
    export.add_argument(
        "--out", metavar="PATH", type=Path, help="the file or folder to write (default: in GRADES)"
    )
    export.add_argument(
        "--template",
        metavar="FILE",
        type=Path,
        help="canvas: your export of its gradebook",
    )
    export.add_argument(
        "--column",
        default="",
        metavar="NAME",
        help="canvas: the column of the assignment, if it has another name",
    )
    export.add_argument("--assignment", default="", metavar="NAME", help="only this assignment")
    export.add_argument(
        "--secret",
        metavar="FILE",
        type=Path,
        help="gradescope-autograder: the course's secret, which is packed too",
    )
    export.add_argument(
        "--variant",
        default="",
        metavar="LETTER",
        help="gradescope-autograder: all students have variant A, or B, of the exercises",
    )
    export.add_argument("--trust-container", action="store_true", help=TRUST_CONTAINER)
    export.set_defaults(run=run_export)


def run_export(arguments: argparse.Namespace) -> int:
    """Read the class, and write the export that the arguments name."""
    from ..grading.export.freshness import list_warnings, note_export
    from ..grading.judge.class_list import locked_class, read_class
    from ..grading.report.decisions import read_decisions
    from ..grading.report.rows import list_class_rows

    refuse_useless_options(arguments)
    if arguments.gradescope_autograder is not None:
        return pack_for_gradescope(arguments)
    if arguments.grades is None:
        raise InvalidParameter("name the folder of grades that kinoedu grade made")
    of = read_class(arguments.grades)
    if arguments.from_nbgrader is not None:
        return read_back_from_nbgrader(of, arguments.from_nbgrader)
    all_rows = list_class_rows(of, read_decisions(of.out))
    rows = [row for row in all_rows if arguments.assignment in ("", row.assignment)]
    if not rows:
        raise InvalidParameter(f"{of.out} has no grades for {arguments.assignment or 'anything'}")
    for warning in list_warnings(of, all_rows):
        print(f"kinoedu: warning: {warning}", file=sys.stderr)
    arguments.out = arguments.out or of.out / DEFAULT_PLACES[arguments.to]
    print(EXPORTS[arguments.to](arguments, of, rows))
    try:
        with locked_class(of.out):
            note_export(of, rows, arguments.to, arguments.out)
    except OSError as error:  # the export is whole; the grades may be in a folder to read only
        print(
            f"kinoedu: warning: {of.out} cannot note this export ({error.strerror}), so grade will "
            "not warn when it is old",
            file=sys.stderr,
        )
    return 0


def refuse_useless_options(arguments: argparse.Namespace) -> None:
    """Raise InvalidParameter where an option would have no effect."""
    asked = f"--to {arguments.to}"
    if arguments.to is None:
        packs = arguments.gradescope_autograder is not None
        asked = "--gradescope-autograder" if packs else "--from-nbgrader"
    for option, what in ONLY_FOR.items():
        if getattr(arguments, option) and asked != what:
            raise InvalidParameter(f"--{option.replace('_', '-')} is for {what}, not for {asked}")
    if arguments.out is not None and arguments.to is None:
        raise InvalidParameter(f"--out is for --to, not for {asked}")


def write_csv(arguments: argparse.Namespace, of: Any, rows: Any) -> str:
    """Write a plain table."""
    from ..grading.export.tables import export_csv

    export_csv(rows, arguments.out)
    return f"wrote {arguments.out}; a cell is empty where something has no score yet"


def write_canvas(arguments: argparse.Namespace, of: Any, rows: Any) -> str:
    """Fill in the table that was exported from Canvas."""
    from ..grading.export.tables import export_canvas
    from ..support.csv_cells import one_line

    if arguments.template is None:
        raise InvalidParameter(
            "--to canvas needs --template FILE, your export of Canvas's gradebook (Grades, Export "
            "Entire Gradebook)"
        )
    unknown, left = export_canvas(rows, arguments.template, arguments.out, arguments.column)
    no_column = (
        f"; no column is named like {', '.join(left)}: choose one with --assignment and --column"
        if left
        else ""
    )
    missing = f"; Canvas does not have: {one_line(', '.join(unknown))}" if unknown else ""
    return f"wrote {arguments.out}{no_column}{missing}"


def write_gradescope(arguments: argparse.Namespace, of: Any, rows: Any) -> str:
    """Write Gradescope's results for each submission."""
    from ..grading.export.tables import export_gradescope
    from ..support.csv_cells import one_line

    count, missing = export_gradescope(rows, arguments.out)
    left_out = f"; no file for these, without a score: {', '.join(missing)}" if missing else ""
    return f"wrote {count} files in {arguments.out}{one_line(left_out)}"


def pack_for_gradescope(arguments: argparse.Namespace) -> int:
    """Pack the autograder of one assignment."""
    require_nbgrader()
    from ..grading.assignments.questions import read_course_secret
    from ..grading.export.autograder_zip import pack_autograder
    from .grade import find_secret_file

    if not arguments.assignment:
        raise InvalidParameter(
            "an autograder is for one assignment: name it with --assignment, such as 01_geometry"
        )
    secret = read_course_secret(find_secret_file(arguments, ""))
    file, wall = arguments.gradescope_autograder, arguments.trust_container
    with show_stage(f"packing {file}"):
        count = pack_autograder(
            file, arguments.assignment, secret, container_is_wall=wall, letter=arguments.variant
        )
    print(
        f"packed {count} files in {file}; it holds the course's secret, so give it to Gradescope "
        "and to nobody else"
    )
    return 0


def write_nbgrader(arguments: argparse.Namespace, of: Any, rows: Any) -> str:
    """Write a course folder with nbgrader's gradebook."""
    require_nbgrader()
    from ..grading.export.nbgrader_course import export_nbgrader

    folder = arguments.out
    entries = [entry for entry in of.entries if arguments.assignment in ("", entry.assignment)]
    with show_stage("writing the gradebook"):
        count = export_nbgrader(of._replace(entries=entries), rows, folder)
    return (
        f"wrote {count} notebooks in {folder}; in that folder: jupyter lab, then Nbgrader, "
        "Formgrader, Manual Grading"
    )


def read_back_from_nbgrader(of: Any, folder: Path) -> int:
    """Read the scores that people gave in formgrader, and write the grades again."""
    require_nbgrader()
    from ..grading.export.freshness import renew_export
    from ..grading.export.nbgrader_course import import_nbgrader_scores, list_scores_of_programs
    from ..grading.judge.class_list import locked_class, read_class
    from ..grading.report.decisions import read_decisions
    from ..grading.report.rows import list_class_rows
    from ..grading.report.writing import write_all
    from ..support.csv_cells import one_line
    from .grade import warn_of_old_exports

    if not (folder / "gradebook.db").exists():
        raise InvalidParameter(
            f"{folder} has no gradebook.db; name the folder that kinoedu export --to nbgrader made"
        )
    with show_stage("reading the gradebook"), locked_class(of.out):
        of = read_class(of.out)  # another command may have added its students meanwhile
        before = list_class_rows(of, read_decisions(of.out))
        count = import_nbgrader_scores(of, folder)
        rows = write_all(of)
        renew_export(of, before, rows, folder)
        left = list_scores_of_programs(rows, folder)
    warn_of_old_exports(of, rows)
    if left:
        print(
            "kinoedu: warning: scores for programs are not taken from formgrader; write these into "
            f"{of.out / 'overrides.csv'}: {one_line(', '.join(left))}",
            file=sys.stderr,
        )
    print(
        f"brought the scores ({count}) and the comments into {of.out / 'by_hand.csv'}, grades.csv, "
        "the report and the pages"
    )
    return 0


def require_nbgrader() -> None:
    """Raise InvalidParameter where nbgrader is not installed."""
    if importlib.util.find_spec("nbgrader") is None:
        raise InvalidParameter("this needs nbgrader, which python start.py export installs")


DEFAULT_PLACES = {
    "csv": "totals.csv",
    "canvas": "canvas.csv",
    "gradescope": "gradescope",
    "nbgrader": "nbgrader",
}
EXPORTS = {
    "csv": write_csv,
    "canvas": write_canvas,
    "gradescope": write_gradescope,
    "nbgrader": write_nbgrader,
}
