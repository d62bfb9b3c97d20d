"""An experiment: every planner on every problem with every seed."""

from __future__ import annotations

import difflib
import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import is_dataclass
from functools import partial
from typing import Any, NamedTuple

from ..errors import InvalidParameter
from ..geometry.checks import integer, is_real, positive
from ..planners.own import name_of, rng_argument
from ..problems import ProblemRecord
from ..support.constructors import with_type_names
from ..support.json_fields import JsonObject
from ..support.text import shortened
from .cells import Cell, kind_of
from .digests import version

Planner = Callable[..., Any]


@with_type_names
class Contestant(NamedTuple):
    """A planner with its arguments.

    Attributes
    ----------
    name : the planner's name.
    tuning : the arguments that distinguish it from others of the same name.
    seeded : whether it takes a random generator.
    """

    name: str
    tuning: str
    function: Planner
    seeded: bool


@with_type_names
class ExperimentRecord(NamedTuple):
    """The result of `Experiment`."""

    name: str
    problems: JsonObject
    contestants: tuple[Contestant, ...]
    seeds: tuple[int, ...]
    repeat: int
    time_limit: float


def Experiment(
    problems: Mapping[str, ProblemRecord],
    planners: Mapping[str, Planner | Sequence[Planner]],
    seeds: int | Iterable[int] = 10,
    *,
    name: str = "experiment",
    repeat: int = 1,
    time_limit: float = 60.0,
) -> ExperimentRecord:
    """Define an experiment: planners x problems x seeds.

    Parameters
    ----------
    problems : dict of Problems by name.
    planners : dict of planners by name. A planner is a function of a problem, such as `rrt` or
        `functools.partial(rrt, step_size=2.0)`, or a list of such functions that differ in an
        argument. It can be yours, as on a board: `f(problem)` or `f(problem, rng)`, which returns a
        path, a Plan or None; its path is checked. Planners with an argument `rng` run once for
        each seed, the others once.
    seeds : the number of seeds, counted from 0, or the seeds themselves.
    name : the name of the experiment.
    repeat : the number of times each run is repeated for its median time; its path is always the
        same.
    time_limit : seconds after which a run is stopped.

    Returns
    -------
    ExperimentRecord

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> import kinoedu as ke
    >>> problem = ke.Problem(ke.Point(), ke.Terrain([[1] * 9] * 9), (1, 1), (8, 8))
    >>> planners = {"RRT": ke.rrt, "A*": ke.plan_on_grid}
    >>> experiment = Experiment({"empty": problem}, planners, seeds=50)
    >>> len(cells_of(experiment))
    51
    """
    for kind, things in (("problem", problems), ("planner", planners)):
        if not isinstance(things, Mapping) or not things:
            raise InvalidParameter(
                f"{kind}s must be a dict of at least one {kind} by name, got {shortened(things)}"
            )
        for label in things:
            if not isinstance(label, str) or not label:
                raise InvalidParameter(
                    f"the name of a {kind} must be text, and not empty, got {shortened(label)}"
                )
    for label, problem in problems.items():
        if not isinstance(problem, tuple) or not hasattr(problem, "query_counts"):
            raise InvalidParameter(
                f"problem {label!r} must be a Problem(robot, world, start, goal), got "
                f"{shortened(problem)}"
            )
    contestants = [
        contestant
        for label, given in planners.items()
        for contestant in contestants_of(label, given)
    ]
    return ExperimentRecord(
        str(name),
        dict(problems),
        tuple(contestants),
        as_seeds(seeds),
        integer(repeat, "repeat", least=1),
        as_limit(time_limit),
    )


def as_seeds(seeds: object) -> tuple[int, ...]:
    """The seeds from 0, or the given ones. Raises InvalidParameter."""
    if is_real(seeds):
        return tuple(range(integer(seeds, "seeds", least=1)))
    if not isinstance(seeds, Iterable) or isinstance(seeds, str | Mapping):
        raise InvalidParameter(
            f"seeds must be a number of seeds, or a list of seeds, got {shortened(seeds)}"
        )
    chosen = tuple(integer(seed, "each of the seeds", least=0) for seed in seeds)
    if not chosen or len(set(chosen)) < len(chosen):
        raise InvalidParameter(
            f"seeds must be at least one seed, each once, got {shortened(list(chosen))}"
        )
    return chosen


def as_limit(seconds: object) -> float:
    """Check a time limit of at most a week. Raises InvalidParameter."""
    limit = positive(seconds, "time_limit")
    if limit > 604_800.0:
        raise InvalidParameter(
            f"time_limit must be at most 604800 seconds, a week, got {shortened(seconds)}"
        )
    return limit


def contestants_of(name: str, given: Planner | Sequence[Planner]) -> list[Contestant]:
    """Planners with one name. Raises InvalidParameter."""
    functions: list[Any] = list(given) if isinstance(given, list | tuple) else [given]
    for function in functions:
        check_contestant(name, function)
    tunings = describe_differences([getattr(function, "keywords", {}) for function in functions])
    if not functions or len(set(tunings)) < len(tunings):
        raise InvalidParameter(
            f"planners {name!r} must differ in an argument that functools.partial gives, got "
            f"{shortened(given)}"
        )
    return [
        Contestant(name, tuning, function, bool(rng_argument(function)))
        for tuning, function in zip(tunings, functions)
    ]


def check_contestant(name: str, planner: object) -> None:
    """Raise InvalidParameter unless a planner is a function that has the given arguments."""
    function = getattr(planner, "func", planner)
    if not callable(function) or isinstance(function, type):
        raise InvalidParameter(
            f"planner {name!r} must be a function such as rrt, or partial(rrt, step_size=2.0), got "
            f"{shortened(planner)}"
        )
    keywords = getattr(planner, "keywords", {})
    if "rng" in keywords:
        raise InvalidParameter(
            f"planner {name!r}: leave rng out; it is a generator for each of the experiment's seeds"
        )
    parameters = inspect.signature(function).parameters if keywords else {}
    if any(p.kind is inspect.Parameter.VAR_KEYWORD for p in parameters.values()):
        return
    for argument in keywords:
        if argument not in parameters:
            close = difflib.get_close_matches(argument, parameters, 1)
            hint = f"its arguments are {', '.join(list(parameters)[1:]) or 'none'}"
            if close:
                hint = f"did you mean {close[0]!r}?"
            raise InvalidParameter(
                f"planner {name!r}: {name_of(function)} has no argument {argument!r}; {hint}"
            )


def describe_differences(arguments: list[dict[str, Any]]) -> list[str]:
    """Descriptions of the arguments in which planners differ.

    >>> describe_differences([{"step_size": 2, "n": 10}, {"step_size": 2, "n": 20}])
    ['n=10', 'n=20']
    """
    flat = [flatten_records(given) for given in arguments]
    names = list(dict.fromkeys(name for given in flat for name in given))
    different = [name for name in names if len({repr(given.get(name)) for given in flat}) > 1]
    return [
        ", ".join(f"{name}={given[name]!r}" for name in different if name in given)
        for given in flat
    ]


def flatten_records(arguments: dict[str, Any]) -> dict[str, Any]:
    """Arguments with the parameters of each record such as Drives, as `drives.trials`."""
    flat: dict[str, Any] = {}
    for name, value in arguments.items():
        if is_dataclass(value):
            flat |= {f"{name}.{part}": held for part, held in vars(value).items()}
        else:
            flat[name] = value
    return flat


def cells_of(experiment: ExperimentRecord) -> list[Cell]:
    """Cells of an experiment: problem by problem, planner by planner, seed by seed."""
    cells = []
    for problem_name, problem in experiment.problems.items():
        fresh = problem._replace(query_counts=problem.query_counts * 0)
        for name, tuning, function, seeded in experiment.contestants:
            kind = kind_of(fresh, function, experiment.repeat)
            limits = (experiment.repeat, experiment.time_limit)
            for seed in experiment.seeds if seeded else (None,):
                about = (problem_name, name, tuning, seed)
                cells.append(Cell(*about, fresh, function, *limits, kind, version()))
    return cells


def bind_arguments(planner: Planner, arguments: dict[str, Any]) -> Planner:
    """A planner with its arguments bound."""
    return partial(planner, **arguments) if arguments else planner
