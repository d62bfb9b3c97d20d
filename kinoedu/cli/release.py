"""kinoedu release: make exercises from solutions, and a zip for students."""

import argparse
import importlib.util
import os
from pathlib import Path

from ..errors import InvalidParameter
from ..support.progress import show_progress, show_stage
from .commands import Commands

RELEASE_HELP = """\
Make the exercises from the solutions: answers are removed, every cell is run, and the outputs that
students see are stored.

  python start.py release                     all assignments
  python start.py release 01_geometry         one of them
  python start.py release --zip course.zip    and pack the course for students: without solutions,
                                              wrong answers and tests, and with recorded results in
                                              place of the answers in the lessons' code

With --variants each student gets their own exercises: students are asked for different answers,
such as distances in different metrics. Then grade with --variants. STUDENTS is a file with an id on
each line, spelled as in the column student of grades.csv.

  python start.py release 02_bug_algorithms --variants students.txt --out handouts

With --variant all students of a section get the same: A is the first variant of each exercise, B
the second. Then grade this section with the same --variant.

  python start.py release --zip course_B.zip --variant B
  python start.py release 02_bug_algorithms --variant B --out section_B     only the notebooks

In the zip, students can check themselves with the concept questions at the end of each lesson. If
you grade these elsewhere (python start.py questions), leave the answers out:

  python start.py release 01_geometry --zip course.zip --graded-questions 01_geometry 06_sampling
"""


def add_release(commands: Commands) -> None:
    """Add the command and its options."""
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
        "--graded-questions",
        nargs="+",
        default=[],
        metavar="NAME",
        help="zip: lessons whose concept questions come without answers",
    )
    which = release.add_mutually_exclusive_group()
    which.add_argument(
        "--variants",
        type=Path,
        metavar="STUDENTS",
        help="write each student's own variants of released exercises",
    )
    which.add_argument(
        "--variant",
        default="",
        metavar="LETTER",
        help="give all students variant A, or B, of the exercises",
    )
    release.add_argument(
        "--out",
        type=Path,
        metavar="FOLDER",
        help="variants, variant: the folder to write notebooks to",
    )
    release.add_argument(
        "--secret",
        type=Path,
        metavar="FILE",
        help="variants: the course's secret, from which variants are drawn",
    )
    release.set_defaults(run=run_release)


def run_release(arguments: argparse.Namespace) -> int:
    """Make the exercises, and print where they are."""
    from ..course.lessons import EXERCISES
    from ..course.release import (
        assignments,
        exercises_without_solution,
        pack_course,
        release,
        require_released,
    )
    from ..course.section import choose_for_section
    from ..grading.assignments.questions import read_assignment

    refuse_useless_options(arguments)
    if importlib.util.find_spec("nbgrader") is None:
        raise InvalidParameter("releasing needs nbgrader, which python start.py release installs")
    if arguments.variants is not None:
        return release_variants(arguments)
    names = arguments.assignments or assignments()
    if arguments.variant:
        if arguments.out is not None:
            return release_section(names, arguments)
        if arguments.zip is None:
            raise InvalidParameter("--variant needs --zip FILE or --out FOLDER")
        choose_for_section(EXERCISES.values(), arguments.variant)  # refuse a wrong letter at once
    if arguments.zip is not None:
        require_place_for(arguments.zip)
        for other in assignments():
            if other not in names:
                require_released(other)
    for name in names:
        read_assignment(name)  # refuse what could not be graded
    for name in names:
        with show_stage(f"releasing {name}"):
            made = release(name)
        print(f"made exercises/{made.name}")
    if arguments.zip is not None:
        with show_progress("recording the results that check needs") as progress:
            count = pack_course(
                arguments.zip,
                graded=arguments.graded_questions,
                letter=arguments.variant,
                progress=progress,
            )
        print(f"packed {count} files in {arguments.zip}")
        for file in exercises_without_solution():
            print(f"left out {file}: no solution makes it")
    return 0


def refuse_useless_options(arguments: argparse.Namespace) -> None:
    """Raise InvalidParameter where an option would have no effect, or names no lesson."""
    from ..course.questions.question import read_questions

    if arguments.out is not None and arguments.variants is None and not arguments.variant:
        raise InvalidParameter(
            "--out is for --variants and --variant; without them the notebooks are in exercises"
        )
    if arguments.zip is not None and arguments.out is not None:
        raise InvalidParameter("--out writes notebooks and --zip a kit: give one of them at a time")
    if arguments.secret is not None and arguments.variants is None:
        raise InvalidParameter("--secret is for --variants STUDENTS: nothing else is drawn from it")
    if arguments.graded_questions and arguments.zip is None:
        raise InvalidParameter("--graded-questions is for --zip FILE")
    for lesson in arguments.graded_questions:
        read_questions(lesson)


def require_place_for(file: Path) -> None:
    """Raise InvalidParameter where a file cannot be written, before the work that it is for."""
    if not file.parent.is_dir():
        raise InvalidParameter(f"there is no folder {file.parent} for {file}")
    if file.is_dir() or not os.access(file.parent, os.W_OK):
        reason = "it is a folder" if file.is_dir() else f"nothing can be written in {file.parent}"
        raise InvalidParameter(f"{file} cannot be written: {reason}")


def release_section(names: list[str], arguments: argparse.Namespace) -> int:
    """Write released exercises with the variants of a section, and print where they are."""
    from ..grading.judge.variants import write_section

    for made in write_section(names, arguments.variant, arguments.out):
        print(f"wrote {made}")
    print(f"grade them with --variant {arguments.variant}")
    return 0


def release_variants(arguments: argparse.Namespace) -> int:
    """Write each student's own variants, and print where they are."""
    from ..grading.assignments.questions import read_course_secret
    from ..grading.judge.variants import write_variants
    from ..support.reading import read_text
    from .grade import find_secret_file

    if arguments.out is None or not arguments.assignments:
        raise InvalidParameter(
            "--variants needs the names of assignments before it, and --out FOLDER"
        )
    lines = read_text(arguments.variants).splitlines()
    students = list(dict.fromkeys(line.strip() for line in lines if line.strip()))
    if not students:
        raise InvalidParameter(
            f"{arguments.variants} names no student; it should have an id on each line"
        )
    secret = read_course_secret(find_secret_file(arguments, ""))
    count = write_variants(arguments.assignments, students, secret, arguments.out)
    print(
        f"wrote {count} notebooks in {arguments.out}; variants.csv says who has which. Grade them "
        "with --variants"
    )
    return 0
