"""kinoedu release: exercises from solutions, and a zip for students."""

import argparse
import importlib.util
from pathlib import Path
from typing import Any

from ..errors import InvalidParameter
from ..progress import stage

RELEASE_HELP = """\
Make the exercises from the solutions: answers are taken out, every cell is run, and what a student sees is stored.

  python start.py release                     all assignments
  python start.py release 01_geometry         one of them
  python start.py release --zip course.zip    and pack what students get: no solutions, no bank of wrong answers, no tests
"""


def add_release(commands: Any) -> None:
    """The command and its options."""
    release = commands.add_parser(
        "release",
        help="make the exercises from the solutions, and a zip for students",
        description=RELEASE_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    release.add_argument("assignments", nargs="*", metavar="NAME", help="such as 01_geometry (default: all)")
    release.add_argument("--zip", type=Path, metavar="FILE", help="pack the course for students into this file")
    release.set_defaults(run=run_release)


def run_release(arguments: argparse.Namespace) -> int:
    """Make each exercise, and say where it is."""
    from ..course.release import assignments, pack, release

    if importlib.util.find_spec("nbgrader") is None:
        raise InvalidParameter("releasing needs nbgrader, which python start.py release installs")

    for name in arguments.assignments or assignments():
        with stage(f"releasing {name}"):
            made = release(name)
        print(f"made exercises/{made.name}")
    if arguments.zip is not None:
        with stage(f"packing {arguments.zip}"):
            count = pack(arguments.zip)
        print(f"packed {count} files in {arguments.zip}")
    return 0
