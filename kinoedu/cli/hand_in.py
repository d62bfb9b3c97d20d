"""kinoedu hand-in: pack one notebook to hand in, with a receipt."""

import argparse
from datetime import UTC, datetime
from pathlib import Path

from ..errors import InvalidParameter
from .commands import Commands

HAND_IN_HELP = """\
Check that a notebook can be graded, and pack it into a zip to hand in, with a receipt: the
answered questions, the time, and a number that no other notebook has (SHA-256). Nothing is run and
nothing is sent: upload the zip yourself.

  python start.py hand-in exercises/01_geometry.ipynb
"""


def add_hand_in(commands: Commands) -> None:
    """Add the command and its options."""
    hand_in = commands.add_parser(
        "hand-in",
        help="pack a notebook to hand in, with a receipt",
        description=HAND_IN_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    hand_in.add_argument("file", metavar="FILE", type=Path, help="your notebook, saved")
    hand_in.add_argument(
        "--out",
        metavar="ZIP",
        type=Path,
        help="the zip to write (default: here, named like the notebook)",
    )
    hand_in.set_defaults(run=run_hand_in)


def run_hand_in(arguments: argparse.Namespace) -> int:
    """Pack the notebook, and print the receipt."""
    from ..grading.collect.handing_in import hand_in

    if not arguments.file.is_file():
        raise InvalidParameter(
            f"{arguments.file}: there is no such notebook; name one, such as "
            "exercises/01_geometry.ipynb"
        )
    zip_file = arguments.out or Path(f"{arguments.file.stem}.zip")
    if zip_file.suffix.lower() != ".zip":
        raise InvalidParameter(f"--out {zip_file}: what you hand in is a file that ends in .zip")
    receipt = hand_in(arguments.file, zip_file, datetime.now(UTC))
    print(
        f"{receipt}\nYour zip: {zip_file}. Nothing was sent: upload it yourself. What you had not "
        "saved is not in it."
    )
    return 0
