"""kinoedu new-exercise: create an exercise for an instructor to edit."""

import argparse

from ..support.progress import show_stage
from .commands import Commands

NEW_EXERCISE_HELP = """\
Create an exercise of your own, with the name and the lesson that you give. It is complete but tiny
(the middle of two points): cells in the solution notebook, cases and judge, messages, a bank of
wrong answers, and a test. It passes all tests as it is; edit it step by step.

  python start.py new-exercise closest_wall --lesson 14_walls
"""
NEXT = """\
Edit these files, in this order; the word Edit marks the places. Then run

  python start.py test tests/lessons/test_{name}.py tests/test_course.py \
tests/test_bank.py -k {name}
  python start.py release {lesson}
"""


def add_new_exercise(commands: Commands) -> None:
    """Add the command and its options."""
    new = commands.add_parser(
        "new-exercise",
        help="create an exercise of your own",
        description=NEW_EXERCISE_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    new.add_argument(
        "name", metavar="NAME", help="the function that students write, such as closest_wall"
    )
    new.add_argument(
        "--lesson",
        metavar="NN_topic",
        required=True,
        help="the lesson's notebook, new or existing",
    )
    new.set_defaults(run=run_new_exercise)


def run_new_exercise(arguments: argparse.Namespace) -> int:
    """Write the files of the exercise, and print what to do next."""
    from ..course.new_exercise import new_exercise

    with show_stage(
        f"writing {arguments.name}, and running the solutions of {arguments.lesson} with it"
    ):
        files = new_exercise(arguments.name, arguments.lesson)
    print("\n".join(f"  {file}" for file in files))
    print(NEXT.format(name=arguments.name, lesson=arguments.lesson), end="")
    return 0
