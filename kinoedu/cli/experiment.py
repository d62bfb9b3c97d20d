"""kinoedu experiment: run planners on problems with many seeds, into one table."""

import argparse
from pathlib import Path

from ..errors import InvalidParameter
from ..support.progress import show_progress, show_stage
from .commands import Commands

EXPERIMENT_HELP = """\
Run every planner on every problem with every seed, and summarise the results.

FILE is a .toml that names planners, problems and seeds (docs/experiments.md explains it;
notebooks/experiments has an example). Results in the folder:
  results.csv   a row for each run
  summary.txt   a line for each planner on each problem
  *.png         pictures, with --plots
  runs/         the finished runs: if the command is stopped, the same command continues from there
"""

EXPERIMENT_EXAMPLES = """\
examples:
  python start.py experiment notebooks/experiments/trees.toml --plots
  python start.py experiment notebooks/experiments/trees.toml --out results --workers 2
  python start.py experiment trees.toml --dask tcp://10.0.0.1:8786

A planner, a robot or a world in the file can be code of yours (module.function). It is run with all
your rights on this computer: run only files that you trust.

exit status: 0 everything was run, 1 some runs were not, or a planner of yours returned a wrong
path, with the reason in the table, 2 the input was wrong
"""


def add_experiment(commands: Commands) -> None:
    """Add the command and its options."""
    experiment = commands.add_parser(
        "experiment",
        help="run planners on problems with many seeds, and compare them",
        description=EXPERIMENT_HELP,
        epilog=EXPERIMENT_EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    experiment.add_argument("file", metavar="FILE", type=Path, help="the experiment, a .toml")
    experiment.add_argument(
        "--out",
        type=Path,
        metavar="FOLDER",
        help="where results go (default: a folder named like the file, here)",
    )
    experiment.add_argument(
        "--plots", action="store_true", help="draw medians, shares of runs, and growth, as .png"
    )
    where = experiment.add_mutually_exclusive_group()
    where.add_argument(
        "--workers",
        type=int,
        metavar="N",
        help="the number of processes (default: one for each processor)",
    )
    where.add_argument(
        "--dask", metavar="ADDRESS", help="run on the Dask cluster whose scheduler has this address"
    )
    experiment.set_defaults(run=run_experiment)


def run_experiment(arguments: argparse.Namespace) -> int:
    """Run what is missing, write the results, and print their summary."""
    folder = Path(arguments.file.stem) if arguments.out is None else arguments.out
    if arguments.file.suffix.lower() != ".toml":
        raise InvalidParameter(f"{arguments.file}: the file of an experiment ends in .toml")
    # imported here so that --help is quick
    from ..experiments import as_text, read_experiment, run, summary
    from ..support.whole_files import written_whole

    with show_stage(f"reading {arguments.file.name}"):
        experiment = read_experiment(arguments.file)
    with show_progress(f"running {experiment.name}") as progress:
        where = "local" if arguments.dask is None else arguments.dask
        table = run(
            experiment, where=where, out=folder, workers=arguments.workers, progress=progress
        )
    text = as_text(summary(table))
    with written_whole(folder / "summary.txt") as part:
        part.write_text(text + "\n", encoding="utf-8")
    if arguments.plots:
        with show_stage("drawing"):
            from ..experiments.plots import save_plots

            save_plots(table, folder)
    print(f"{text}\n{repr(table)[8:-1]}; in {folder}")
    reasons = sorted(
        {
            f"{row.status}: {row.label}: {row.reason}"
            for row in table
            if row.status in ("not run", "wrong")
        }
    )
    print(
        *(" ".join(reason.split()) for reason in reasons),
        sep="\n",
        end="\n" if reasons else "",
    )
    return 1 if reasons else 0
