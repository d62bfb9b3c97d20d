"""kinoedu lab, kinoedu lessons: open the course, and copy its lessons to a folder of your own."""

import argparse
from pathlib import Path

from .commands import Commands

LAB_HELP = """\
Open the course in JupyterLab.

  kinoedu lab               the lessons of this copy of the course; if pip has installed it, or it
                            is read-only, copies in the folder kinoedu of your home
  kinoedu lab my_lessons    copies in a folder of your choice

Lessons that are missing in the folder are copied to it. Files that are there are never overwritten.
To get the original of a lesson again, rename your copy.
"""
LESSONS_HELP = """\
Copy the lessons, exercises and maps to a folder, for VS Code, Colab or another editor.

  kinoedu lessons my_lessons

Files that are there are never overwritten. To get the original of a lesson again, rename your copy.
"""


def add_lab(commands: Commands) -> None:
    """Add the command that opens the course."""
    lab = commands.add_parser(
        "lab",
        help="open the course in JupyterLab",
        description=LAB_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    lab.add_argument(
        "folder", nargs="?", type=Path, metavar="FOLDER", help="where your lessons are"
    )
    lab.add_argument(
        "--no-browser", action="store_true", help="print the address instead of opening a browser"
    )
    lab.set_defaults(run=run_lab)


def add_lessons(commands: Commands) -> None:
    """Add the command that copies the lessons."""
    lessons = commands.add_parser(
        "lessons",
        help="copy the lessons to a folder of your own",
        description=LESSONS_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    lessons.add_argument("folder", type=Path, metavar="FOLDER", help="where to copy them")
    lessons.set_defaults(run=run_lessons)


def run_lab(arguments: argparse.Namespace) -> int:
    """Open the tour in JupyterLab."""
    from ..lab import open_lab

    return open_lab(arguments.folder, browser=not arguments.no_browser)


def run_lessons(arguments: argparse.Namespace) -> int:
    """Copy the lessons, and print how many files are new."""
    from ..lab import copy_lessons

    copies = copy_lessons(arguments.folder)
    print(f"files copied to {arguments.folder}: {len(copies)}; the files there are unchanged")
    return 0
