"""kinoedu release: exercises from solutions, and a zip for students."""

import argparse
import importlib.util
from pathlib import Path
from typing import Any

from ..errors import InvalidParameter
from ..support.progress import show_stage

RELEASE_HELP = """\
Make the exercises from the solutions: answers are taken out, every cell is run, and what a student sees is stored.

  python start.py release                     all assignments
  python start.py release 01_geometry         one of them
  python start.py release --zip course.zip    and pack what students get: no solutions, no bank of wrong answers, no tests

With --variants each student gets exercises of their own: where several answers would do, each is asked for another one. Grade with
--variants then. STUDENTS is a file with an id on each line, spelled as in the column student of grades.csv.

  python start.py release 02_bug_algorithms --variants students.txt --out handouts
"""


def add_release(commands: Any) -> None:
    """The command and its options."""
    release = commands.add_parser(
        "release",
        help="make the exercises from the solutions, and a zip for students",
        description=RELEASE_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    release.add_argument(
        "assignments", nargs="*", metavar="NAME", help="such as 01_geometry (default: all)"
    )
    release.add_argument(
        "--zip", type=Path, metavar="FILE", help="pack the course for students into this file"
    )
    release.add_argument(
        "--variants",
        type=Path,
        metavar="STUDENTS",
        help="write each student's own exercises, as released before",
    )
    release.add_argument(
        "--out", type=Path, metavar="FOLDER", help="variants: the folder to write them to"
    )
    release.add_argument(
        "--secret",
        type=Path,
        metavar="FILE",
        help="variants: the course's secret, from which they are drawn",
    )
    release.set_defaults(run=run_release)


def run_release(arguments: argparse.Namespace) -> int:
    """Make each exercise, and say where it is."""
    from ..course.release import assignments, pack_course, release

    if arguments.variants is not None:
        return release_variants(arguments)
    if importlib.util.find_spec("nbgrader") is None:
        raise InvalidParameter("releasing needs nbgrader, which python start.py release installs")

    for name in arguments.assignments or assignments():
        with show_stage(f"releasing {name}"):
            made = release(name)
        print(f"made exercises/{made.name}")
    if arguments.zip is not None:
        with show_stage(f"packing {arguments.zip}"):
            count = pack_course(arguments.zip)
        print(f"packed {count} files in {arguments.zip}")
    return 0


def release_variants(arguments: argparse.Namespace) -> int:
    """Write each student's own exercises, and say where they are."""
    from ..grading.assignments.questions import course_secret
    from ..grading.judge.variants import write_variants
    from .grade import secret_of

    if arguments.out is None or not arguments.assignments:
        raise InvalidParameter(
            "--variants needs the names of assignments before it, and --out FOLDER"
        )
    lines = arguments.variants.read_text(encoding="utf-8-sig").splitlines()
    students = list(dict.fromkeys(line.strip() for line in lines if line.strip()))
    if not students:
        raise InvalidParameter(
            f"{arguments.variants} names no student; it should have an id on each line"
        )
    count = write_variants(
        arguments.assignments, students, course_secret(secret_of(arguments, "")), arguments.out
    )
    print(
        f"wrote {count} notebooks in {arguments.out}; variants.csv says who has which. Grade them "
        "with --variants"
    )
    return 0
