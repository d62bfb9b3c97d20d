"""Where cells are run: in local processes, in this process, or by an executor such as Dask's."""

import os
import pickle
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import contextmanager

from ..errors import InvalidParameter
from ..geometry.checks import integer
from ..support.text import shortened
from ..support.time_limit import TimeUp, run_within
from .cells import NOT_RUN, Cell, Outcome, out_of_time, run_cell
from .children import Answer, Batch, Children, run_batch, run_in_children

LOADING = 300.0  # extra seconds for the first of two runs, which compiles
Submit = Callable[[Batch], "Future[list[Answer]]"]


@contextmanager
def open_workers(where: object, workers: int | None) -> Iterator[Submit]:
    """Context manager that yields a function to submit batches; its workers end with the block.

    Raises
    ------
    InvalidParameter
    """
    if not isinstance(where, Executor | str):
        raise InvalidParameter(
            'where must be "local", "here", the address of a Dask scheduler or an Executor, got '
            f"{shortened(where)}"
        )
    if workers is not None and where != "local":
        raise InvalidParameter(
            'workers can be given for where="local" only; "here" has one, and an executor or a '
            "cluster has its own"
        )
    if where == "local":
        count = os.cpu_count() or 1 if workers is None else integer(workers, "workers", least=1)
        with local_workers(count) as submit:
            yield submit
    elif where == "here":
        with ThreadPoolExecutor(1) as one:
            yield lambda batch: one.submit(run_batch, batch, run_in_this_process)
    elif isinstance(where, str):
        with cluster_executor(where) as executor:
            yield lambda batch: executor.submit(run_in_children, pickle.dumps(batch))
    else:
        yield lambda batch: where.submit(run_in_children, pickle.dumps(batch))


@contextmanager
def local_workers(workers: int) -> Iterator[Submit]:
    """Submit batches to this many processes of this computer, with a thread for each."""
    children, threads = Children(), ThreadPoolExecutor(workers)
    try:
        yield lambda batch: threads.submit(run_batch, batch, children.run)
    finally:
        children.close()
        threads.shutdown(cancel_futures=True)


@contextmanager
def cluster_executor(address: str) -> Iterator[Executor]:
    """Executor of a Dask cluster whose workers have this kinoedu. Raises InvalidParameter."""
    try:
        from dask.distributed import Client
    except ImportError:
        raise InvalidParameter(
            "a Dask cluster needs the package distributed: pip install distributed"
        ) from None
    try:
        client = Client(address, timeout=10, set_as_default=False)
    except (OSError, ValueError) as error:
        raise InvalidParameter(
            f"no Dask scheduler answers at {shortened(address)}: {error}"
        ) from error
    with client:
        yield client.get_executor(pure=False)


def run_in_this_process(cell: Cell) -> Outcome:
    """Run a cell in this process, after an untimed run to load and compile what it needs.

    Compiled code cannot be stopped here.
    """
    try:
        limit = cell.time_limit * cell.repeat
        first = run_within(limit + LOADING, lambda: run_cell(cell._replace(repeat=1)))
        if first.status == NOT_RUN:
            return first
        return run_within(limit, lambda: run_cell(cell))
    except TimeUp:
        return out_of_time(cell)


def check_portable(cells: list[Cell]) -> None:
    """Raise InvalidParameter for a planner or a problem that another process cannot import."""
    things: dict[str, object] = {}
    for cell in cells:
        things[f"planner {cell.planner_name!r}"] = cell.planner
        things[f"problem {cell.problem_name!r}"] = cell.problem
    for name, thing in things.items():
        try:
            portable = b"__main__" not in pickle.dumps(thing)
        except Exception:  # pickling can raise anything
            portable = False
        if not portable:
            raise InvalidParameter(
                f"{name} exists only in this process; define it in a module that you import, not "
                'in a notebook, or run with where="here"'
            )
