"""Where runs are made: in processes of this computer, in this very process, or by any executor,
such as a Dask cluster's.
"""

import os
import pickle
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any

from ..errors import InvalidParameter
from ..geometry.checks import whole
from ..support.text import shortened
from ..support.time_limit import TimeUp, within
from .cells import Cell, Outcome, out_of_time, run_cell
from .children import Children, in_child

LOADING = 300.0  # seconds that the first of two runs may take longer, for compiling
HandOver = Callable[[Cell], "Future[Outcome]"]


@contextmanager
def place(where: Any, workers: int | None) -> Iterator[HandOver]:
    """What hands over a cell and gives its future outcome; whoever worked is gone when the block
    ends. Raises InvalidParameter.
    """
    if not isinstance(where, Executor | str):
        raise InvalidParameter(
            f'where must be "local", "here", a Dask scheduler\'s address or an Executor, got {shortened(where)}'
        )
    if workers is not None and where != "local":
        raise InvalidParameter(
            'workers are counted where="local"; here there is one, and an executor or a cluster has its own'
        )
    if where == "local":
        with local(
            os.cpu_count() or 1 if workers is None else whole(workers, "workers", least=1)
        ) as hand_over:
            yield hand_over
    elif where == "here":
        with ThreadPoolExecutor(1) as one:
            yield lambda cell: one.submit(in_this_process, cell)
    elif isinstance(where, str):
        with cluster(where) as executor:
            yield lambda cell: executor.submit(in_child, cell)
    else:
        yield lambda cell: where.submit(in_child, cell)


@contextmanager
def local(workers: int) -> Iterator[HandOver]:
    """So many processes of this computer, each led by a thread."""
    children, threads = Children(), ThreadPoolExecutor(workers)
    try:
        yield lambda cell: threads.submit(children.ask, cell)
    finally:
        children.close()
        threads.shutdown(cancel_futures=True)


@contextmanager
def cluster(address: str) -> Iterator[Executor]:
    """The executor of a Dask cluster, whose workers have this kinoedu. Raises InvalidParameter."""
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


def in_this_process(cell: Cell) -> Outcome:
    """The outcome of one run, made twice: first to load and compile what it needs. Compiled code
    cannot be stopped here.
    """
    try:
        first = within(
            cell.time_limit * cell.repeat + LOADING, lambda: run_cell(cell._replace(repeat=1))
        )
        return (
            within(cell.time_limit * cell.repeat, lambda: run_cell(cell))
            if first.path or not first.reason
            else first
        )
    except TimeUp:
        return out_of_time(cell)


def check_portable(cells: list[Cell]) -> None:
    """Raise InvalidParameter for a planner that another process cannot import."""
    for planner_name, planner in {cell.planner_name: cell.planner for cell in cells}.items():
        try:
            pickle.dumps(planner)
            portable = getattr(planner, "func", planner).__module__ != "__main__"
        except Exception:  # pickle raises what it meets
            portable = False
        if not portable:
            raise InvalidParameter(
                f"planner {planner_name!r} is known to this process alone; "
                'define it in a module that you import, not in a notebook, or run where="here"'
            )
