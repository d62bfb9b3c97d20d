"""One run of an experiment, a cell of its table: the task, the run and the outcome."""

import hashlib
import math
import statistics
import time
from collections.abc import Callable
from copy import deepcopy
from typing import Any, NamedTuple

import numpy as np

from ..compiled import compiled_first
from ..geometry.checks import Array
from ..planners.own import Faults, as_plan, call_planner, find_faults, is_own
from ..problems import MOTIONS, PLACES, Plan, ProblemRecord
from ..support.faults import shorten_message
from .digests import digest, version

FOUND, NO_PATH, WRONG, OUT_OF_TIME, NOT_RUN = (
    *("found", "no path", "wrong", "out of time", "not run"),
)


class Cell(NamedTuple):
    """One planner on one problem with one seed.

    Attributes
    ----------
    seed : None for a deterministic planner.
    kind : a digest of everything except the seed.
    version : of the kinoedu that made the cell; another one does not run it.
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
    version: str

    @property
    def key(self) -> str:
        """Identifier of the outcome, the same for the same run."""
        return f"{self.kind}-{self.seed}"


class Outcome(NamedTuple):
    """The result of a run.

    Attributes
    ----------
    status : "found", "no path", "wrong" (a path that is not free), "out of time" or "not run".
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


def kind_of(problem: ProblemRecord, planner: Callable[..., Any], repeat: int) -> str:
    """A digest of all that a cell's outcome depends on, but for its seed.

    Raises
    ------
    InvalidParameter
        Where something has no digest, or a reader's file has changed since it was imported.
    """
    return digest((version(), problem, planner, repeat))


@compiled_first()
def run_cell(cell: Cell) -> Outcome:
    """Run the planner as often as the cell says, and return the outcome with the median time.

    An exception of the planner becomes an outcome of status "not run".
    """
    own, seconds = is_own(cell.planner), []
    try:
        for _ in range(cell.repeat):
            # a reader's planner gets a copy, so that it cannot change the judge's problem
            problem = deepcopy(cell.problem) if own else cell.problem
            problem.query_counts[:] = 0
            began = time.perf_counter()
            answer = call_planner(cell.planner, problem, cell.seed)
            seconds.append(time.perf_counter() - began)
        counts = problem.query_counts.copy()
        plan = as_plan(answer, cell.problem) if own else answer
        faults = find_faults(plan, cell.problem) if own else Faults()
        return outcome_of(plan, faults, counts, statistics.median(seconds))
    except (Exception, SystemExit) as error:
        return Outcome(NOT_RUN, reason=f"{type(error).__name__}: {shorten_message(error)}")


def outcome_of(plan: Plan, faults: Faults, query_counts: Any, seconds: float) -> Outcome:
    """Outcome of a plan. A path that is not free has no cost; one that only touches has."""
    found = plan.path is not None
    return Outcome(
        WRONG if faults.is_wrong else FOUND if found else NO_PATH,
        float(plan.cost) if found and not faults.is_wrong else math.inf,
        seconds,
        int(query_counts[MOTIONS]),
        int(query_counts[PLACES]),
        count_of(plan, "nodes"),
        count_of(plan, "iterations"),
        faults.text or plan.reason,
        digest_of(plan.path) if found else "",
    )


def count_of(plan: Plan, name: str) -> int | None:
    """A count of a plan, which may be a reader's own; None where it is no number."""
    try:
        return int(plan.stats[name])
    except (KeyError, TypeError, ValueError, OverflowError):
        return None


def digest_of(path: Array | None) -> str:
    """16 hexadecimal digits that identify a path, to the last bit."""
    return hashlib.sha256(np.ascontiguousarray(path, dtype="<f8").tobytes()).hexdigest()[:16]


def out_of_time(cell: Cell) -> Outcome:
    """Outcome of a run that was stopped."""
    reason = f"stopped after {cell.time_limit:g} s"
    return Outcome(OUT_OF_TIME, seconds=cell.time_limit, reason=reason)
