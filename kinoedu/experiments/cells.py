"""One run of an experiment, a cell of its table: the task, the run and the outcome."""

import hashlib
import math
import statistics
import time
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from ..compiled import COMPILED_FIRST, running
from ..errors import InvalidParameter
from ..geometry.checks import Array
from ..problems import MOTIONS, PLACES, Plan, ProblemRecord
from ..support.text import shortened

FOUND, NO_PATH, OUT_OF_TIME, NOT_RUN = "found", "no path", "out of time", "not run"


class Cell(NamedTuple):
    """One planner on one problem with one seed.

    Attributes
    ----------
    seed : None for a deterministic planner.
    kind : a digest of everything except the seed.
    """

    problem_name: str
    planner_name: str
    tuning: str
    seed: int | None
    problem: ProblemRecord
    planner: Callable[..., Any]
    repeat: int
    time_limit: float
    kind: str

    @property
    def key(self) -> str:
        """Identifier of the outcome, the same for the same run."""
        return f"{self.kind}-{self.seed}"


class Outcome(NamedTuple):
    """The result of a run.

    Attributes
    ----------
    status : "found", "no path", "out of time" or "not run".
    motions, places, nodes, iterations : None where the planner does not count them.
    """

    status: str
    cost: float = math.inf
    seconds: float = math.nan
    motions: int | None = None
    places: int | None = None
    nodes: int | None = None
    iterations: int | None = None
    reason: str = ""
    path: str = ""


@running(COMPILED_FIRST)
def run_cell(cell: Cell) -> Outcome:
    """Run the planner as often as the cell says, and return the outcome with the median time.

    An exception of the planner becomes an outcome of status "not run".
    """
    random = {} if cell.seed is None else {"rng": cell.seed}
    seconds = []
    try:
        for _ in range(cell.repeat):
            cell.problem.query_counts[:] = 0
            began = time.perf_counter()
            plan = cell.planner(cell.problem, **random)
            seconds.append(time.perf_counter() - began)
        return outcome_of(plan, cell.problem.query_counts, statistics.median(seconds))
    except Exception as error:
        return Outcome(NOT_RUN, reason=f"{type(error).__name__}: {error}")


def outcome_of(plan: object, query_counts: Any, seconds: float) -> Outcome:
    """Outcome of a plan.

    Raises
    ------
    InvalidParameter
        Where the planner has not returned a Plan.
    """
    if not isinstance(plan, Plan):
        raise InvalidParameter(f"a planner must return a Plan, got {shortened(plan)}")
    found = plan.path is not None
    return Outcome(
        FOUND if found else NO_PATH,
        float(plan.cost) if found else math.inf,
        seconds,
        int(query_counts[MOTIONS]),
        int(query_counts[PLACES]),
        plan.stats.get("nodes"),
        plan.stats.get("iterations"),
        plan.reason,
        digest_of(plan.path) if found else "",
    )


def digest_of(path: Array | None) -> str:
    """16 hexadecimal digits that identify a path, to the last bit."""
    return hashlib.sha256(np.ascontiguousarray(path, dtype="<f8").tobytes()).hexdigest()[:16]


def out_of_time(cell: Cell) -> Outcome:
    """Outcome of a run that was stopped."""
    reason = f"stopped after {cell.time_limit:g} s"
    return Outcome(OUT_OF_TIME, seconds=cell.time_limit, reason=reason)
