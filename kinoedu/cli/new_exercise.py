"""kinoedu new-exercise: an instructor's own exercise, to be edited."""

import argparse
from typing import Any

from ..support.progress import show_stage

NEW_EXERCISE_HELP = """\
Begin an exercise of your own: a tiny one, the middle of two points, under your name and in your lesson, with its cells in the
solution notebook, its cases and judge, its words, its bank of wrong answers and its test. It passes all tests as it is; edit it
from there.

  python start.py new-exercise closest_wall --lesson 14_walls
"""
NEXT = """\
Edit these, in this order; the word Edit marks the places. Then

  python start.py test tests/lessons/test_{name}.py tests/test_course.py tests/test_bank.py -k {name}
  python start.py release {lesson}
"""


def add_new_exercise(commands: Any) -> None:
    """The command and its options."""
    new = commands.add_parser(
        "new-exercise",
        help="begin an exercise of your own",
        description=NEW_EXERCISE_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    new.add_argument(
        "name", metavar="NAME", help="the function that it asks for, such as closest_wall"
    )
    new.add_argument(
        "--lesson",
        metavar="NN_topic",
        required=True,
        help="the notebook that asks for it, new or there already",
    )
    new.set_defaults(run=run_new_exercise)


def run_new_exercise(arguments: argparse.Namespace) -> int:
    """Write it, and say what to do next."""
    from ..course.new_exercise import new_exercise

    with show_stage(
        f"writing {arguments.name}, and running the solutions of {arguments.lesson} with it"
    ):
        files = new_exercise(arguments.name, arguments.lesson)
    print("\n".join(f"  {file}" for file in files))
    print(NEXT.format(name=arguments.name, lesson=arguments.lesson), end="")
    return 0
