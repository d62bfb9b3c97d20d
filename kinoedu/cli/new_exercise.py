"""kinoedu new-exercise: create an exercise for an instructor to edit."""

import argparse
from pathlib import Path

from ..errors import InvalidParameter
from ..support.progress import show_stage
from .commands import Commands

NEW_EXERCISE_HELP = """\
Create an exercise of your own, with the name and the lesson that you give. It is complete but tiny
(the middle of two points): cells in the solution notebook, cases and judge, messages, a bank of
wrong answers, and a test. It passes all tests as it is; edit it step by step.

  python start.py new-exercise closest_wall --lesson 15_walls

In ten minutes, from a plain function: write it into a file with a docstring, an example, and its
kinds of input as annotations (point, points, polygon, number, length, angle, count; the answer may
also be truth). The exercise gets cases, a judge, the usual mistakes that are mistakes here, a bank.

  python start.py new-exercise closest_wall --lesson 15_walls --from closest_wall.py

  import numpy as np

  def closest_wall(q: "point", wall: "polygon") -> "number":
      \"\"\"The distance from q to the nearest vertex of the wall.

      >>> closest_wall((0, 0), [(3, 4), (9, 4), (9, 9)])
      5
      \"\"\"
      return np.linalg.norm(wall - q, axis=1).min()
"""
FROM_EXAMPLE = "Edit these files, in this order; the word Edit marks the places."
FROM_PLAIN = """\
It is complete. The first file has the statement, the .toml the words that students read; to add
mistakes of your students, edit the .py beside it and the bank."""
NEXT = """\
{what} Then run

  python start.py release {lesson}
  python start.py test tests/lessons/test_{name}.py tests/test_course.py \
tests/test_bank.py -k "{name} or every_word"

The first makes exercises/{lesson}.ipynb: open it, answer wrongly, and see what your students see.
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
        help="the lesson's notebook, new or existing; always needed",
    )
    new.add_argument(
        "--from",
        type=Path,
        metavar="FILE",
        dest="plain",
        help="make it from the plain function in this file",
    )
    new.set_defaults(run=run_new_exercise)


def run_new_exercise(arguments: argparse.Namespace) -> int:
    """Write the files of the exercise, and print what to do next."""
    from ..course.new_exercise import new_exercise
    from ..course.plain_function import read_plain_function

    if arguments.lesson is None:
        raise InvalidParameter(
            "say which lesson the exercise belongs to, an existing one such as 01_geometry or a "
            f"new one: python start.py new-exercise {arguments.name} --lesson 15_walls"
        )
    plain = read_plain_function(arguments.plain) if arguments.plain else None
    if plain is not None and plain.name != arguments.name:
        raise InvalidParameter(
            f"{arguments.plain} defines {plain.name}; the exercise has the name of its function, "
            f"so it cannot be {arguments.name}"
        )
    with show_stage(
        f"writing {arguments.name}, and running the solutions of {arguments.lesson} with it"
    ):
        files = new_exercise(arguments.name, arguments.lesson, plain=plain)
    print("\n".join(f"  {file}" for file in files))
    what = FROM_PLAIN if plain is not None else FROM_EXAMPLE
    print(NEXT.format(what=what, name=arguments.name, lesson=arguments.lesson), end="")
    return 0
