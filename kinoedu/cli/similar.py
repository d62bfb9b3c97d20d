"""kinoedu similar: list similar programs for a person to look at."""

import argparse
from itertools import groupby
from pathlib import Path

from ..errors import InvalidParameter
from ..support.progress import show_stage
from .commands import Commands

SIMILAR_HELP = """\
Rank submissions by the code that they share with each other, and with the course's own solution,
wrong answers and library. Names, comments, layout and the order of functions do not matter; code
that all students were given is left out. Nothing is run, nothing is scored, and nothing is proved:
look at the pairs.

  python start.py similar submissions --out similar
"""


def add_similar(commands: Commands) -> None:
    """Add the command and its options."""
    similar = commands.add_parser(
        "similar",
        help="list similar programs, for you to look at",
        description=SIMILAR_HELP,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    similar.add_argument(
        "submissions",
        metavar="SUBMISSIONS",
        type=Path,
        help="the folder or zip of submissions",
    )
    similar.add_argument(
        "--out", metavar="FOLDER", type=Path, required=True, help="the folder for the pages"
    )
    similar.add_argument(
        "--assignment",
        default="",
        metavar="NAME",
        help="read every notebook as this assignment, such as 01_geometry",
    )
    similar.add_argument(
        "--most",
        type=int,
        default=100,
        metavar="N",
        help="pairs of either kind to list (default: %(default)s)",
    )
    similar.set_defaults(run=run_similar)


def run_similar(arguments: argparse.Namespace) -> int:
    """Compare the programs, and print where the pages are."""
    from ..grading.class_grading import refuse_out_among_submissions
    from ..grading.collect.submissions import collect
    from ..grading.report.similar import find_similar
    from ..grading.report.similar_page import write_similar

    if arguments.most < 1:
        raise InvalidParameter(f"--most must be at least 1, got {arguments.most}")
    submissions = [
        one for one in collect(arguments.submissions, arguments.assignment) if one.assignment
    ]
    if not submissions:
        raise InvalidParameter(
            f"{arguments.submissions} holds no notebooks that answer an assignment"
        )
    refuse_out_among_submissions(arguments.out, [arguments.submissions])
    submissions.sort(key=lambda one: one.assignment)
    with show_stage(f"comparing {len(submissions)} submissions"):
        found = [
            find_similar(name, mine, arguments.most)
            for name, mine in groupby(submissions, key=lambda one: one.assignment)
        ]
        count = write_similar(found, arguments.out)
    left_out = len(submissions) - sum(len(one.programs) for one in found)
    unread = f"; {left_out} submissions could not be read" if left_out else ""
    print(f"pairs found: {count}; look at {arguments.out / 'similar.html'}{unread}")
    return 0
