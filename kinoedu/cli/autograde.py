"""kinoedu autograde: the command that Gradescope's run_autograder calls."""

import argparse
from pathlib import Path

from ..errors import InvalidParameter
from .commands import Commands

AUTOGRADE_HELP = """\
Grade the one submission in ROOT/submission and write ROOT/results/results.json. The script
run_autograder, in the zip that kinoedu export --gradescope-autograder packs, calls this command.
If the submission cannot be graded, nothing is written, so that nobody gets a score by mistake.
"""


def add_autograde(commands: Commands) -> None:
    """Add the command and its options."""
    autograde = commands.add_parser(
        "autograde",
        help="grade one submission, in Gradescope's container",
        description=AUTOGRADE_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    autograde.add_argument(
        "root", metavar="ROOT", type=Path, help="/autograder, or a folder laid out like it"
    )
    autograde.add_argument(
        "--assignment", required=True, metavar="NAME", help="such as 01_geometry"
    )
    autograde.add_argument(
        "--secret", required=True, metavar="FILE", type=Path, help="the course's secret"
    )
    autograde.add_argument(
        "--trust-container",
        action="store_true",
        help="if no sandbox can be made, run programs WITHOUT ONE, as an ordinary user",
    )
    autograde.add_argument(
        "--variant", default="", metavar="LETTER", help="all students have this variant"
    )
    autograde.set_defaults(run=run_autograde)


def run_autograde(arguments: argparse.Namespace) -> int:
    """Grade, and print the result, which Gradescope shows to instructors only."""
    from ..grading.assignments.questions import read_course_secret
    from ..grading.export.autograder import autograde

    if not arguments.secret.is_file():
        raise InvalidParameter(
            f"there is no secret in {arguments.secret}: pack the autograder again"
        )
    secret = read_course_secret(arguments.secret)
    results = autograde(
        arguments.root,
        arguments.assignment,
        secret,
        container_is_wall=arguments.trust_container,
        letter=arguments.variant,
    )
    print(f"score {results['score']}; {results['output']}")
    return 0
