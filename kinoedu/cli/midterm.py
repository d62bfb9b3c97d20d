"""kinoedu midterm: an examination in variants, with solutions."""

import argparse
from pathlib import Path

from ..support.progress import show_stage
from .commands import Commands

MIDTERM_HELP = """\
Write a midterm on lessons 1 to 8, to print: for each variant the paper and its solutions, as HTML
and as Markdown. The numbers are drawn from the seed, and the answers are computed by the library.
No question has the same answer in two variants.

  python start.py midterm --seed 2024 --out exam
  python start.py midterm --seed 2024 --out exam --variants A B C

Keep the seed secret until the examination: whoever has it and the solutions folder has the paper.
"""


def add_midterm(commands: Commands) -> None:
    """Add the command and its options."""
    midterm = commands.add_parser(
        "midterm",
        help="write an examination in variants, with solutions",
        description=MIDTERM_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    midterm.add_argument("--seed", type=int, required=True, metavar="N", help="from 0")
    midterm.add_argument(
        "--out", type=Path, required=True, metavar="FOLDER", help="the folder to write to"
    )
    midterm.add_argument(
        "--variants",
        nargs="+",
        default=["A", "B"],
        metavar="NAME",
        help="names of the variants (default: A B)",
    )
    midterm.set_defaults(run=run_midterm)


def run_midterm(arguments: argparse.Namespace) -> int:
    """Write the papers, and print where they are."""
    from ..course.midterm import write_midterm
    from ..errors import InvalidParameter

    if arguments.seed < 0 or not all(name.isalnum() for name in arguments.variants):
        raise InvalidParameter("the seed is a number from 0; variants are letters and digits")
    with show_stage("drawing numbers and computing answers"):
        made = write_midterm(arguments.out, arguments.seed, arguments.variants)
    print("\n".join(f"wrote {file}" for file in made))
    return 0
