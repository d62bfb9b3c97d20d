"""kinoedu bench: measure speed row by row, and write one table."""

import argparse
import time
from collections.abc import Sequence
from pathlib import Path
from textwrap import shorten
from typing import Any

from ..bench import (
    BENCHMARKS,
    PICTURES,
    Outcome,
    Row,
    as_markdown,
    draw_folder,
    install_peer,
    load,
    named_peers,
    read_ratios,
    read_rows,
    run_row,
    select_rows,
    surroundings,
    totals,
)
from ..errors import InvalidParameter
from ..support.progress import format_duration, show_stage
from .commands import Commands

BENCH_HELP = """\
Compare the speed of kinoedu with other libraries and with C, row by row. Each row runs in a process
of its own.

Results in the folder:
  ratios.csv               a line for each library that was compared
  ratios.md                the table of all rows, with the computer and the versions
  ratios.png, ratios.svg   a picture of the table
  ROW.md                   the output of each row

The ratios are those of this run alone; earlier ones are replaced.

The other libraries (peers) are not part of the course. Those that are not installed are named and
left out. --peers installs them beside the course's packages, each by itself. Do not use the
computer for anything else while this runs.
"""

BENCH_EXAMPLES = """\
examples:
  python start.py bench --list
  python start.py bench --peers
  python start.py bench rrt prm --repeats 3 --out results

exit status: 0 every row ended, whether it met its goal or not; 1 some rows failed, with the reason
in the table; 2 the input was wrong
"""


def add_bench(commands: Commands) -> None:
    """Add the command and its options."""
    bench = commands.add_parser(
        "bench",
        help="time kinoedu beside other libraries and beside C",
        description=BENCH_HELP,
        epilog=BENCH_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    bench.add_argument("rows", nargs="*", metavar="ROW", help="such as rrt (default: all)")
    bench.add_argument(
        "--list",
        action="store_true",
        help="list the rows and how long they take, and run none",
    )
    bench.add_argument(
        "--peers",
        action="store_true",
        help="install the libraries of benchmarks/environment.txt first",
    )
    bench.add_argument(
        "--pythonrobotics",
        type=Path,
        metavar="PATH",
        help="a checkout of PythonRobotics, to compare with it too",
    )
    bench.add_argument(
        "--repeats",
        type=int,
        metavar="N",
        help="rounds of each row that has rounds (default: its own number)",
    )
    bench.add_argument(
        "--out", type=Path, metavar="FOLDER", help="where results go (default: benchmarks/results)"
    )
    bench.set_defaults(run=run_bench)


def run_bench(arguments: argparse.Namespace) -> int:
    """Run the rows, and print where the table is."""
    rows = select_rows(read_rows(BENCHMARKS), arguments.rows)
    if arguments.list:
        print_rows(rows)
        return 0
    if arguments.repeats is not None and arguments.repeats < 1:
        raise InvalidParameter(f"--repeats must be at least 1, got {arguments.repeats}")
    if arguments.pythonrobotics is not None and not arguments.pythonrobotics.is_dir():
        raise InvalidParameter(
            f"--pythonrobotics {arguments.pythonrobotics} is not a folder; give a checkout of "
            "PythonRobotics"
        )
    if arguments.peers:
        install_peers()
    options = {
        "repeats": arguments.repeats,
        "pythonrobotics": arguments.pythonrobotics and arguments.pythonrobotics.resolve(),
    }
    given = {name: value for name, value in options.items() if value is not None}
    folder = BENCHMARKS / "results" if arguments.out is None else arguments.out
    folder.mkdir(parents=True, exist_ok=True)
    outcomes = run_rows(rows, folder, given)
    counts = totals(read_ratios(folder / "ratios.csv"), outcomes)
    print(f"{counts} The table is {folder / 'ratios.md'}")
    return int(any(outcome.ended == "failed" for outcome in outcomes))


def print_rows(rows: Sequence[Row]) -> None:
    """Print a line for each row."""
    width = max(len(row.name) for row in rows)
    for row in rows:
        print(
            f"{row.name:<{width}}  {format_duration(row.seconds):>6}  "
            f"{shorten(row.about, 100, placeholder=' ...')}"
        )
    print(f"{len(rows)} rows, about {format_duration(sum(row.seconds for row in rows))} in all")


def install_peers() -> None:
    """Install the libraries to compare with, and name those that cannot be installed."""
    file = BENCHMARKS / "environment.txt"
    for peer in named_peers(file):
        with show_stage(f"installing {peer}"):
            wrong = install_peer(peer, file)
        print(f"{peer}: not installed ({wrong})" if wrong else f"{peer}: installed", flush=True)


def run_rows(rows: Sequence[Row], folder: Path, options: dict[str, Any]) -> list[Outcome]:
    """Run one row after another; write the table after each row.

    The picture is drawn at the end, also after an interruption.
    """
    for old in ("ratios.csv", "ratios.md", *PICTURES):
        (folder / old).unlink(missing_ok=True)
    outcomes: list[Outcome] = []
    began = f"{time.strftime('%Y-%m-%d %H:%M')}, at the start {load()}"
    try:
        for number, row in enumerate(rows, start=1):
            with show_stage(
                f"{number} of {len(rows)}: {row.name}, about {format_duration(row.seconds)}"
            ):
                outcomes.append(run_row(row, folder, options))
            print(describe_outcome(outcomes[-1]), flush=True)
            around = [
                began,
                f"at the end: {surroundings()}",
                f"{len(outcomes)} of {len(rows)} rows were run",
            ]
            text = as_markdown(read_ratios(folder / "ratios.csv"), outcomes, around)
            (folder / "ratios.md").write_text(text, encoding="utf-8")
    finally:
        with show_stage("drawing the ratios"):
            draw_folder(folder)
    return outcomes


def describe_outcome(outcome: Outcome) -> str:
    """How a row ended, in one line."""
    left_out = f"; without {'; '.join(outcome.left_out)}" if outcome.left_out else ""
    reason = f": {outcome.reason}" if outcome.reason else ""
    duration = format_duration(outcome.seconds)
    return f"{outcome.row.name}: {outcome.ended} in {duration}{reason}{left_out}"
