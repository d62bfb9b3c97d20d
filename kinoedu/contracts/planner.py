"""The check of a planner: it plans in a fixed set of traps, and its answers are judged."""

from __future__ import annotations

import pickle
import random
from collections.abc import Callable, Iterator, Sequence
from copy import deepcopy
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ..errors import InvalidParameter, KinoeduError
from ..geometry.checks import integer, positive
from ..planners.own import Faults, as_plan, call_planner, find_faults, name_of
from ..problems import Plan, ProblemRecord
from ..robots.kinds import Robot
from ..support.faults import describe_exception
from ..support.text import shortened
from ..support.time_limit import TimeUp, run_within_processor_time
from .report import Finding, Report
from .traps import Trap, traps_for

MOST_TIMEOUTS = 3  # after so many runs that had to be stopped, the others are left out
ROUNDING = 1e-9

PROMISES = {
    "answer": "It returns a path (n, d), a Plan or None.",
    "errors": "It raises no error, but for one of kinoedu's that refuses a problem.",
    "time": "It ends, also where there is no path.",
    "ends": "Its paths begin at the start and end at the goal.",
    "free": "No motion of its paths enters an obstacle or leaves the world.",
    "finds": "It finds a path where nothing is in the way.",
    "cost": "The cost of its plans is that of their paths.",
    "problem": "It leaves the problem as it was.",
    "random": "It leaves the random numbers of Python and numpy alone.",
    "same": "The same seed gives the same path, whatever was planned before.",
}


class Run(NamedTuple):
    """A planner's answer in one trap.

    Attributes
    ----------
    trap : the trap.
    plan : the plan, or None where there was no valid answer.
    faults : what is wrong with its path.
    broken : the names of the other promises that it broke, with what happened.
    refused : the error by which the planner refused the problem.
    """

    trap: Trap
    plan: Plan | None
    faults: Faults
    broken: dict[str, str]
    refused: str = ""

    @property
    def found(self) -> bool:
        """Whether there is a path without a fault, or with contact alone."""
        return self.plan is not None and self.plan.path is not None and not self.faults.is_wrong


@dataclass(frozen=True, eq=False, repr=False)
class PlannerReport(Report):
    """The result of `check_planner`.

    Attributes
    ----------
    runs : the answer in each trap, in order; `figures.draw_plan(run.plan)` draws one.
    """

    runs: tuple[Run, ...] = ()

    @property
    def found(self) -> tuple[str, ...]:
        """The names of the solvable traps in which it found a path."""
        return tuple(run.trap.name for run in self.runs if run.trap.solvable and run.found)


def check_planner(
    planner: Callable[..., object],
    *,
    robot: Robot | None = None,
    traps: Sequence[Trap] | None = None,
    seed: int = 0,
    seconds: float = 2.0,
) -> PlannerReport:
    """Run a planner on traps, and say what it promises and breaks.

    Paths are judged motion by motion, by a problem that the planner did not have. Not to find a
    path is no fault, except where nothing is in the way: a note says what was found.

    Parameters
    ----------
    planner : `f(problem)` or `f(problem, rng)`, which returns a path (n, d), a Plan or None.
    robot : the robot that the planner is for, by default Point().
    traps : other problems instead of `traps_for(robot)`.
    seed : of the generator that the planner gets.
    seconds : the time that the planner may compute in each trap.

    Returns
    -------
    PlannerReport
        Its repr says all in words; `passed`, `broken`, `findings` and `runs` are for programs.

    Raises
    ------
    InvalidParameter
        Where the planner cannot be called, or another argument is not valid.

    Examples
    --------
    >>> def straight(problem):
    ...     return [problem.start, problem.goal]
    >>> report = check_planner(straight)
    >>> report.passed, report.broken
    (False, ('free',))
    >>> report["free"].where[0]
    'a pillar in the way: motion 1 of your path, from (2, 5) to (8, 5), is not free'
    """
    if not callable(planner):
        raise InvalidParameter(f"check_planner needs a function, got {shortened(planner)}")
    limit, number = positive(seconds, "seconds"), integer(seed, "seed", least=0)
    chosen = as_traps(traps_for(robot) if traps is None else traps)
    runs = list(run_traps(planner, chosen, number, limit))
    again = repeat(planner, runs, number, limit)
    findings = tuple(Finding(*row) for row in collect(runs, again))
    return PlannerReport(name_of(planner), findings, tuple(notes_on(runs, chosen)), tuple(runs))


def as_traps(traps: object) -> tuple[Trap, ...]:
    """Check that there is a trap, and that all have problems. Raises InvalidParameter."""
    given = tuple(traps) if isinstance(traps, Sequence) else ()
    if not given or not all(isinstance(trap, Trap) for trap in given):
        raise InvalidParameter(
            "traps must be a list of Trap(name, problem, solvable), or None for the usual ones, "
            f"got {shortened(traps)}"
        )
    for trap in given:
        if not isinstance(trap.problem, ProblemRecord):
            raise InvalidParameter(
                f"the problem of a trap must be a Problem, got {shortened(trap.problem)}"
            )
    return given


def run_traps(
    planner: Callable[..., object], traps: Sequence[Trap], seed: int, seconds: float
) -> Iterator[Run]:
    """Run the planner in each trap, until too many runs had to be stopped."""
    stopped = 0
    for trap in traps:
        run = run_trap(planner, trap, seed, seconds)
        yield run
        stopped += "time" in run.broken
        if stopped == MOST_TIMEOUTS:
            return


def run_trap(planner: Callable[..., object], trap: Trap, seed: int, seconds: float) -> Run:
    """Run the planner once, and judge its answer."""
    asked, broken = deepcopy(trap.problem), dict[str, str]()
    before, numbers = fingerprint(asked), random_states()

    def work() -> tuple[Any, BaseException | None]:
        try:
            return call_planner(planner, asked, seed), None
        except TimeUp:
            raise
        except BaseException as error:  # SystemExit too
            return None, error

    try:
        answer, error = run_within_processor_time(seconds, work)
    except TimeUp as over:
        text = f"no answer after {over.passed:.1f} s, of which it computed for {over.used:.1f} s"
        return Run(trap, None, Faults(), {"time": text})
    if fingerprint(asked) != before:
        broken["problem"] = "the problem is another one afterwards"
    if random_states() != numbers:
        broken["random"] = "the state of the global random numbers has changed"
    if isinstance(error, KinoeduError):
        return Run(trap, None, Faults(), broken, " ".join(str(error).split()))
    if error is not None:
        return Run(trap, None, Faults(), broken | {"errors": describe_exception(error, "it")})
    return judge(answer, trap, broken)


def judge(answer: Any, trap: Trap, broken: dict[str, str]) -> Run:
    """A planner's answer, judged by the trap's own problem."""
    problem = deepcopy(trap.problem)
    try:
        plan = as_plan(answer, problem)
    except KinoeduError as error:
        return Run(trap, None, Faults(), broken | {"answer": str(error)})
    has_cost = isinstance(answer, Plan) and plan.path is not None
    if has_cost and not abs(answer.cost - plan.cost) <= ROUNDING * plan.cost:
        broken = broken | {"cost": f"it says {answer.cost:.6g}, its path has {plan.cost:.6g}"}
    return Run(trap, plan, find_faults(plan, problem), broken)


def fingerprint(problem: ProblemRecord) -> bytes:
    """The bytes of a problem, without its counts."""
    return pickle.dumps(tuple(problem._replace(query_counts=np.zeros(0, np.int64))))


def random_states() -> tuple[object, ...]:
    """The states of the global random numbers of Python and numpy."""
    kind, keys, *others = np.random.get_state(legacy=True)
    return random.getstate(), kind, np.asarray(keys).tobytes(), *others


def repeat(
    planner: Callable[..., object], runs: list[Run], seed: int, seconds: float
) -> list[tuple[str, str]]:
    """What was different when each solvable trap was run again, in the opposite order.

    Returns
    -------
    list of pairs, one for each trap: its name, and what was different or "".
    """
    states = random.getstate(), np.random.get_state()
    rows = []
    for first in reversed([run for run in runs if run.plan is not None and run.trap.solvable]):
        random.seed(1)
        np.random.seed(1)
        second = run_trap(planner, first.trap, seed, seconds)
        rows.append((first.trap.name, difference(first, second)))
        if "time" in second.broken:
            break
    random.setstate(states[0])
    np.random.set_state(states[1])
    return rows[::-1]


def difference(first: Run, second: Run) -> str:
    """How the second answer in a trap differs from the first; "" where it does not."""
    if second.plan is None:
        return second.refused or "; ".join(second.broken.values())
    return "" if same_path(first, second) else "another path"


def same_path(first: Run, second: Run) -> bool:
    """Whether two runs have the same path, to the last bit."""
    paths = [None if run.plan is None else run.plan.path for run in (first, second)]
    if paths[0] is None or paths[1] is None:
        return paths[0] is paths[1]
    return np.array_equal(paths[0], paths[1])


Row = tuple[str, str, int, tuple[str, ...]]


def collect(runs: list[Run], again: list[tuple[str, str]]) -> Iterator[Row]:
    """A row for each promise: its name, the promise, how often it was tried, and where broken."""
    with_path = [run for run in runs if run.plan is not None and run.plan.path is not None]
    asked = [run for run in runs if not run.refused]
    must = [run for run in asked if run.trap.must_find]
    at_ends = [(run, run.faults.text if run.faults.ends else "") for run in with_path]
    in_wall = [(run, motion_fault(run)) for run in with_path]
    cases: dict[str, list[tuple[str, str]]] = {
        "ends": named(at_ends),
        "free": named(in_wall),
        "finds": named([(run, "" if run.found else missed(run)) for run in must]),
        "same": again,
    }
    for name, promise in PROMISES.items():
        tried = runs if name in ("problem", "random", "errors") else asked
        tried = with_path if name == "cost" else tried
        rows = cases.get(name, named([(run, run.broken.get(name, "")) for run in tried]))
        yield name, promise, len(rows), tuple(f"{trap}: {text}" for trap, text in rows if text)


def named(cases: list[tuple[Run, str]]) -> list[tuple[str, str]]:
    """Cases with the names of their traps."""
    return [(run.trap.name, text) for run, text in cases]


def motion_fault(run: Run) -> str:
    """The first motion of a path that is not free, in words, or ""."""
    return run.faults.motion if run.faults.wrong else ""


def missed(run: Run) -> str:
    """Why there is no path where there must be one."""
    if run.plan is None:
        return "; ".join(run.broken.values())
    return run.faults.text or run.plan.reason


def notes_on(runs: list[Run], traps: Sequence[Trap]) -> Iterator[str]:
    """What is worth knowing: which paths were found, contact, problems that were refused."""
    solvable = [run for run in runs if run.trap.solvable and not run.refused]
    missing = [run.trap.name for run in solvable if not run.found]
    text = f"it found {len(solvable) - len(missing)} of {len(solvable)} paths"
    yield text + (f"; not: {', '.join(missing)}" if missing else "")
    touching = [run.trap.name for run in runs if run.faults.touching and not run.faults.is_wrong]
    if touching:
        yield f"its paths touch obstacles: {', '.join(touching)}"
    for reason in dict.fromkeys(run.refused for run in runs if run.refused):
        names = ", ".join(run.trap.name for run in runs if run.refused == reason)
        yield f"it refuses {names}: {reason}"
    if len(runs) < len(traps):
        yield f"{len(traps) - len(runs)} traps were left out, because it did not end in others"
