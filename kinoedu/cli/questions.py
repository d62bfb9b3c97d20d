"""kinoedu questions: the concept questions for Canvas and Moodle."""

import argparse
from pathlib import Path

from ..errors import InvalidParameter
from .commands import Commands

# for each platform the ending of its file, and where it imports one
PLATFORMS = {
    "canvas": (".zip", "Settings, Import Course Content, QTI .zip file"),
    "moodle": (".xml", "Question bank, Import, Moodle XML format"),
}
QUESTIONS_HELP = """\
Write the concept questions of the lessons, five for each, for a learning platform. Every choice
carries its reason, which students see after they have answered.

  python start.py questions --to canvas --out questions.zip          a quiz for each lesson
  python start.py questions --to moodle --out questions.xml          for the question bank
  python start.py questions 01_geometry --to canvas --out one.zip    one lesson

In the notebooks the same questions are asked with their answers. If they count, hand out a kit
without these: python start.py release --zip course.zip --graded-questions 01_geometry
"""


def add_questions(commands: Commands) -> None:
    """Add the command and its options."""
    questions = commands.add_parser(
        "questions",
        help="write the concept questions for Canvas or Moodle",
        description=QUESTIONS_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    questions.add_argument(
        "lessons", nargs="*", metavar="NAME", help="such as 01_geometry (default: all)"
    )
    questions.add_argument("--to", choices=PLATFORMS, required=True, help="the platform")
    questions.add_argument(
        "--out", type=Path, required=True, metavar="FILE", help="the file to write"
    )
    questions.set_defaults(run=run_questions)


def run_questions(arguments: argparse.Namespace) -> int:
    """Write the file, and print how to import it."""
    ending, menu = PLATFORMS[arguments.to]
    if arguments.out.suffix.lower() != ending:
        raise InvalidParameter(
            f"--out {arguments.out}: a file of questions for {arguments.to} ends in {ending}"
        )
    from ..course.questions import lessons_with_questions
    from ..course.questions.canvas import write_canvas
    from ..course.questions.moodle import write_moodle

    write = {"canvas": write_canvas, "moodle": write_moodle}[arguments.to]
    count = write(arguments.out, arguments.lessons or lessons_with_questions())
    print(f"wrote {count} questions to {arguments.out}; import them under {menu}")
    return 0
