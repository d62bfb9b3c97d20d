"""The command line of kinoedu.

kinoedu plan | experiment | lab | lessons | warm | release | grade | regrade | export | hand-in |
similar | new-exercise | questions | slides | midterm | autograde | bench.
"""

import argparse
import io
import re
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any, NoReturn

from .. import __version__
from ..errors import KinoeduError, MendedPolygons
from .autograde import add_autograde
from .bench import add_bench
from .experiment import add_experiment
from .export import add_export
from .grade import add_grade
from .hand_in import add_hand_in
from .lab import add_lab, add_lessons
from .midterm import add_midterm
from .new_exercise import add_new_exercise
from .plan import add_plan
from .questions import add_questions
from .release import add_release
from .similar import add_similar
from .slides import add_slides

DESCRIPTION = "kinoedu: a motion-planning course you can run."
A_FILE = "; where a folder is needed there is a file: name another path"
TO_DO = {  # after an error of the system
    FileNotFoundError: "; check the path, and make its folder first",
    FileExistsError: A_FILE,
    NotADirectoryError: A_FILE,
    IsADirectoryError: "; it is a folder: name a file",
    PermissionError: "; check its permissions, or name another path",
}


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command.

    Returns
    -------
    The exit status: 0, or 1 where the command says so; 2 where the input was wrong; 130 after
    Ctrl-C.
    """
    arguments = make_parser().parse_args(argv)
    if isinstance(sys.stdout, io.TextIOWrapper):
        # a name with characters that the terminal cannot show is escaped, not an error
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        with one_line_warnings():
            return int(arguments.run(arguments))
    except (KinoeduError, OSError) as error:
        message = describe_os_error(error) if isinstance(error, OSError) else str(error)
        print(f"kinoedu: {' '.join(message.split())}", file=sys.stderr)
    except MemoryError:
        print(
            "kinoedu: this computer has not enough memory for that; use fewer nodes or a coarser "
            "grid",
            file=sys.stderr,
        )
    except KeyboardInterrupt:
        return 130
    return 2


def describe_os_error(error: OSError) -> str:
    """What the system refused, and what to do, without the system's number of the error.

    >>> describe_os_error(FileNotFoundError(2, "No such file or directory", "no/a.xml"))
    'no/a.xml: No such file or directory; check the path, and make its folder first'
    >>> describe_os_error(OSError("--out a.bmp: a picture ends in .png"))
    '--out a.bmp: a picture ends in .png'
    """
    if error.filename is None or error.strerror is None:
        return str(error)
    todo = next((todo for kind, todo in TO_DO.items() if isinstance(error, kind)), "")
    return f"{error.filename}: {error.strerror}{todo}"


@contextmanager
def one_line_warnings() -> Iterator[None]:
    """Print that polygons were mended as an error is printed, without a place in the code."""
    usual = warnings.formatwarning

    def format_in_one_line(
        message: Warning | str,
        category: type[Warning],
        filename: str,
        lineno: int,
        line: str | None = None,
    ) -> str:
        if issubclass(category, MendedPolygons):
            return f"kinoedu: warning: {message}\n"
        return usual(message, category, filename, lineno, line)

    warnings.formatwarning = format_in_one_line
    try:
        yield
    finally:
        warnings.formatwarning = usual


class Parser(argparse.ArgumentParser):
    """An argument parser that reports an error in one line and accepts -9,-9 as a value."""

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self._negative_number_matcher = re.compile(r"^-[\d.]+(e[-+]?\d+)?(,-?[\d.]+(e[-+]?\d+)?)*$")

    def error(self, message: str) -> NoReturn:
        """Print the error and how to get help, and exit with status 2."""
        self.exit(2, f"{self.prog}: {message}; see {self.prog} --help\n")


def make_parser() -> argparse.ArgumentParser:
    """Make the parser of all commands and their options."""
    top = Parser(prog="kinoedu", description=DESCRIPTION)
    top.add_argument("--version", action="version", version=f"kinoedu {__version__}")
    commands = top.add_subparsers(title="commands", required=True, metavar="COMMAND")
    add_plan(commands)
    add_experiment(commands)
    add_lab(commands)
    add_lessons(commands)
    warm = commands.add_parser(
        "warm",
        help="compile what the course uses, once",
        description="Compile what the course uses, once.",
    )
    how = warm.add_mutually_exclusive_group()
    how.add_argument(
        "--all", action="store_true", help="compile for all lessons, not only the first"
    )
    how.add_argument(
        "--behind",
        action="store_true",
        help="the same at low priority, as the lab does",
    )
    warm.set_defaults(run=run_warm)
    add_release(commands)
    add_grade(commands)
    add_export(commands)
    add_hand_in(commands)
    add_autograde(commands)
    add_similar(commands)
    add_new_exercise(commands)
    add_questions(commands)
    add_slides(commands)
    add_midterm(commands)
    add_bench(commands)
    return top


def run_warm(arguments: argparse.Namespace) -> int:
    """Compile ahead of use; an error is what could not be compiled, which stays interpreted."""
    from ..compiled.store import folder
    from ..warm import warm_all, warm_behind, warm_up

    if folder() is None:
        print(
            "kinoedu: nothing was compiled: no folder for machine code can be written "
            "(KINOEDU_CACHE names another)",
            file=sys.stderr,
        )
        return 1
    warm = warm_behind if arguments.behind else warm_all if arguments.all else warm_up
    interpreted = warm()
    for name in interpreted:
        print(f"{name} could not be compiled: see log and *.refused in {folder()}", file=sys.stderr)
    return 1 if interpreted else 0
