"""Run the missing cells of an experiment on any workers, and make one table."""

import os
from collections import Counter, deque
from collections.abc import Generator, Iterator
from concurrent.futures import Future
from contextlib import closing
from itertools import groupby
from pathlib import Path

from ..errors import InvalidParameter
from ..support.completed_futures import CompletedFutures, failure_of
from ..support.progress import Progress
from ..support.text import shortened
from .cells import FOUND, NOT_RUN, Cell, Outcome
from .experiment import ExperimentRecord, cells_of
from .places import Answer, Batch, Submit, check_portable, open_workers
from .store import Store
from .table import Row, Table

AHEAD = 256  # batches submitted at a time, since a cluster holds their problems in memory
TRIES = 2  # a worker may be lost through no fault of the run


def run(
    experiment: ExperimentRecord,
    *,
    where: object = "local",
    out: str | os.PathLike[str] | None = None,
    workers: int | None = None,
    progress: Progress | None = None,
) -> Table:
    """Run every planner on every problem with every seed.

    Each run has a process of its own while it runs. The first run of each kind is preceded by an
    untimed one, so that the times contain no compilation. A run that takes too long is stopped. A
    run whose process crashes is tried once more. If that fails too, its status is "not run", with
    the reason; the same holds if the planner raises an error.

    Parameters
    ----------
    where : "local" for processes on this computer; "here" for this process, needed for planners
        defined in a notebook (compiled code cannot be stopped then); the address of a Dask
        scheduler, such as "tcp://10.0.0.1:8786"; or an Executor of concurrent.futures.
    out : a folder for the outcomes and `results.csv`. An experiment that was stopped at any time,
        even killed, continues with the missing runs when it is called again with the same folder.
        Stored outcomes are used for the same planners, arguments, problems, seeds and sources of
        kinoedu.
    workers : the number of processes for "local"; by default one for each processor.
    progress : called with the number of finished runs and the number of all runs.

    Returns
    -------
    Table
        A row for each run, in the experiment's order. Except for times it does not depend on the
        number of workers.

    Raises
    ------
    InvalidParameter
    OSError
        Where `out` cannot be written, or a cluster is lost (a ConnectionError).

    Examples
    --------
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
    report = progress or (lambda done, everything: None)
    report(len(done), everything)
    with (
        open_workers(where, workers) as submit,
        closing(run_cells(list(missing.values()), submit)) as outcomes,
    ):
        for cell, outcome in outcomes:
            store.write(cell, outcome)
            done[cell.key] = outcome
            report(len(done), everything)
    table = Table(tuple(make_row(cell, done[cell.key]) for cell in cells))
    if out is not None:
        table.write(Path(out) / "results.csv")
    return table


def run_cells(cells: list[Cell], submit: Submit) -> Generator[tuple[Cell, Outcome]]:
    """Yield every cell with its outcome, in order of completion.

    A cell whose worker is lost is submitted again. Where the caller stops, as by Ctrl-C, batches
    that no worker has begun are cancelled.

    Raises
    ------
    ConnectionError
        Where the cluster is lost.
    """
    waiting, tries = deque(make_batches(cells)), Counter[str]()
    completed = CompletedFutures[Batch]()
    try:
        submit_ahead(waiting, completed, submit)
        for batch, future in completed:
            answers = answers_of(future, batch)
            for cell, answer in zip(batch, answers):  # a batch may come back before its end
                tries[cell.key] += 1
                if isinstance(answer, Outcome):
                    yield cell, answer
                elif tries[cell.key] < TRIES:
                    waiting.appendleft((cell,))
                else:
                    yield cell, Outcome(NOT_RUN, reason=f"{type(answer).__name__}: {answer}")
            waiting.extendleft(split(batch[len(answers) :], len(answers)))
            submit_ahead(waiting, completed, submit)
    finally:
        for future in completed.waiting:
            future.cancel()


def submit_ahead(
    waiting: "deque[Batch]", completed: "CompletedFutures[Batch]", submit: Submit
) -> None:
    """Submit batches until AHEAD of them are being run."""
    while waiting and len(completed.waiting) < AHEAD:
        batch = waiting.popleft()
        completed.add(submit(batch), batch)


def answers_of(future: "Future[list[Answer]]", batch: Batch) -> list[Answer]:
    """The answers to the first cells of a batch; if its worker was lost, the loss for each.

    Raises
    ------
    ConnectionError
        Where the cluster is lost.
    """
    lost = failure_of(future)
    return future.result() if lost is None else [lost] * len(batch)


def make_batches(cells: list[Cell]) -> Iterator[Batch]:
    """Batches of cells of one kind, which share a problem and the untimed run.

    As far as possible there are as many as are submitted at a time, so that no worker is idle.
    """
    for _, alike in groupby(cells, key=lambda cell: cell.kind):
        yield from split(tuple(alike), max(1, len(cells) // AHEAD))


def split(batch: Batch, size: int) -> Iterator[Batch]:
    """Batches of at most this many cells."""
    for i in range(0, len(batch), size):
        yield batch[i : i + size]


def make_row(cell: Cell, outcome: Outcome) -> Row:
    """Row of the table for a cell and its outcome."""
    return Row(
        cell.problem_name,
        cell.planner_name,
        cell.tuning,
        cell.seed,
        outcome.status == FOUND,
        *outcome,
    )
