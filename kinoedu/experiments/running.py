"""Run an experiment: what is missing of it, wherever there are workers, into one table."""

import os
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

from ..errors import InvalidParameter
from ..support.completed_futures import Arrivals
from ..support.text import shortened
from .cells import FOUND, NOT_RUN, Cell, Outcome
from .experiment import ExperimentRecord, cells_of
from .places import HandOver, check_portable, place
from .store import Store
from .table import Row, Table

AHEAD = 256  # runs handed over at a time: a cluster's memory holds their problems
TRIES = 2  # a worker may be lost by no fault of the run

Progress = Callable[[int, int], None]


def run(
    experiment: ExperimentRecord,
    *,
    where: Any = "local",
    out: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    progress: Progress | None = None,
) -> Table:
    """Run every planner on every problem with every seed.

    Parameters
    ----------
    where : "local", processes of this computer; "here", this process, for a planner defined in a
    notebook (compiled code cannot be
        stopped then); the address of a Dask scheduler, such as "tcp://10.0.0.1:8786"; or an
        Executor of concurrent.futures.
    out : a folder for what was run and `results.csv`. Stopped at any time, even killed, and called
    again with the same folder, only
        what is missing is run; what is there holds for the same planners, arguments, problems,
        seeds and sources of kinoedu.
    workers : how many processes, where "local"; by default one for each processor.
    progress : is called with how many runs are done and how many there are.

    Returns a Table, a row for each run in the experiment's order whoever ran it; but for seconds it
    is the same for any number of workers. Each run has a process that others do not share at the
    time, and is made once untimed before the first of its kind, so that seconds hold no compiling.
    A run that takes too long is stopped; one whose process crashes is tried once more, and then
    listed as "not run", like one whose planner raises an error, with the reason.

    Raises InvalidParameter, and OSError where `out` cannot be written.

    >>> import kinoedu as ke
    >>> from kinoedu.experiments import Experiment
    >>> problem = ke.Problem(ke.Point(), ke.Terrain([[1] * 9] * 9), (1, 1), (8, 8))
    >>> run(Experiment({"empty": problem}, {"A*": ke.plan_on_grid}), where="here").column("status")
    ['found']
    """
    if not isinstance(experiment, ExperimentRecord):
        raise InvalidParameter(
            f"run takes an Experiment(...) or read_experiment(file), got {shortened(experiment)}"
        )
    cells, store = cells_of(experiment), Store(out)
    if where != "here":
        check_portable(cells)
    done = {cell.key: outcome for cell in cells if (outcome := store.read(cell)) is not None}
    missing = {cell.key: cell for cell in cells if cell.key not in done}
    everything = len(done) + len(missing)
    tell = progress or (lambda done, everything: None)
    tell(len(done), everything)
    with place(where, workers) as hand_over:
        for cell, outcome in outcomes(missing.values(), hand_over):
            store.write(cell, outcome)
            done[cell.key] = outcome
            tell(len(done), everything)
    table = Table(tuple(row(cell, done[cell.key]) for cell in cells))
    if out is not None:
        table.write(Path(out) / "results.csv")
    return table


def outcomes(cells: Iterable[Cell], hand_over: HandOver) -> Iterator[tuple[Cell, Outcome]]:
    """Every cell with its outcome, as they come; a run whose worker is lost is handed over
    again.
    """
    left, arrivals, tries = iter(cells), Arrivals[Cell](), dict[str, int]()

    def start(cell: Cell) -> None:
        tries[cell.key] = tries.get(cell.key, 0) + 1
        arrivals.expect(hand_over(cell), cell)

    for _, cell in zip(range(AHEAD), left):  # in this order, or one would be lost
        start(cell)
    for cell, future in arrivals:
        lost = future.exception()
        if lost is not None and tries[cell.key] < TRIES:
            start(cell)
            continue
        yield (
            cell,
            future.result()
            if lost is None
            else Outcome(NOT_RUN, reason=f"{type(lost).__name__}: {lost}"),
        )
        for following in left:
            start(following)
            break


def row(cell: Cell, outcome: Outcome) -> Row:
    """A run and its outcome."""
    return Row(
        cell.problem_name,
        cell.planner_name,
        cell.tuning,
        cell.seed,
        outcome.status == FOUND,
        *outcome,
    )
