"""kinoedu slides: slides for a lecture, made from the lessons' notebooks."""

import argparse
from pathlib import Path

from ..support.progress import show_stage
from .commands import Commands

SLIDES_HELP = """\
Make slides from the lessons' notebooks as they were stored: one file of HTML for each lesson, with
its figures, boards that play, and the whole text as notes. A browser shows it without network.

  python start.py slides                              all lessons, into build/slides
  python start.py slides 01_geometry --out lecture    one lesson
"""


def add_slides(commands: Commands) -> None:
    """Add the command and its options."""
    slides = commands.add_parser(
        "slides",
        help="make slides from the lessons",
        description=SLIDES_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    slides.add_argument(
        "lessons", nargs="*", metavar="NAME", help="such as 01_geometry (default: all)"
    )
    slides.add_argument(
        "--out",
        type=Path,
        default=Path("build/slides"),
        metavar="FOLDER",
        help="the folder to write to (default: %(default)s)",
    )
    slides.set_defaults(run=run_slides)


def run_slides(arguments: argparse.Namespace) -> int:
    """Make the slides, and print where they are."""
    from ..slides.page import lessons_with_slides, make_slides

    for lesson in arguments.lessons or lessons_with_slides():
        with show_stage(f"slides of {lesson}"):
            made = make_slides(lesson, arguments.out)
        print(f"wrote {made}")
    return 0
