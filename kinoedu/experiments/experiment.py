"""An experiment: every planner on every problem with every seed."""

import difflib
import inspect
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import Any, NamedTuple

from ..errors import InvalidParameter
from ..geometry.checks import is_real, positive, whole
from ..support.text import shortened
from .cells import Cell
from .digests import digest, version

Planner = Callable[..., Any]


class Contestant(NamedTuple):
    """A planner with its arguments: the name it goes by, in words what tells it from others of that
    name, and the function.
    """

    name: str
    tuning: str
    function: Planner
    seeded: bool


class ExperimentRecord(NamedTuple):
    """What `Experiment` makes."""

    name: str
    problems: dict[str, Any]
    contestants: tuple[Contestant, ...]
    seeds: tuple[int, ...]
    repeat: int
    time_limit: float


def Experiment(
    problems: Mapping[str, Any],
    planners: Mapping[str, Planner | Sequence[Planner]],
    seeds: int | Iterable[int] = 10,
    *,
    name: str = "experiment",
    repeat: int = 1,
    time_limit: float = 60.0,
) -> ExperimentRecord:
    """Planners x problems x seeds, checked.

    Parameters
    ----------
    problems : Problems by the names they go by.
    planners : functions of a problem by the names they go by, such as `rrt` or
    `functools.partial(rrt, step=2.0)`; or several in a
        list, which differ in an argument. Those that draw lots have an argument `rng`, and get the
        seed; the others run once.
    seeds : how many, from 0; or which.
    repeat : each run is made so often, for its median time; its path is the same each time.
    time_limit : seconds after which a run is stopped.

    Raises InvalidParameter.

    >>> import kinoedu as ke
    >>> problem = ke.Problem(ke.Point(), ke.Terrain([[1] * 9] * 9), (1, 1), (8, 8))
    >>> experiment = Experiment({"empty": problem}, {"RRT": ke.rrt, "A*": ke.plan_on_grid}, seeds=50)
    >>> len(cells_of(experiment))
    51
    """
    for kind, things in (("problem", problems), ("planner", planners)):
        if (
            not isinstance(things, Mapping)
            or not things
            or not all(isinstance(key, str) and key for key in things)
        ):
            raise InvalidParameter(
                f"{kind}s must be a dict of at least one {kind} by its name, got "
                f"{shortened(things)}"
            )
    for label, problem in problems.items():
        if not isinstance(problem, tuple) or not hasattr(problem, "asked"):
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
        whole(repeat, "repeat", least=1),
        as_limit(time_limit),
    )


def as_seeds(seeds: Any) -> tuple[int, ...]:
    """So many seeds from 0, or those given. Raises InvalidParameter."""
    if is_real(seeds):
        return tuple(range(whole(seeds, "seeds", least=1)))
    if not isinstance(seeds, Iterable) or isinstance(seeds, str | Mapping):
        raise InvalidParameter(
            f"seeds must be how many there are, or a list of them, got {shortened(seeds)}"
        )
    chosen = tuple(whole(seed, "each of the seeds", least=0) for seed in seeds)
    if not chosen or len(set(chosen)) < len(chosen):
        raise InvalidParameter(
            f"seeds must be at least one, each once, got {shortened(list(chosen))}"
        )
    return chosen


def as_limit(seconds: Any) -> float:
    """A time limit, at most a week. Raises InvalidParameter."""
    limit = positive(seconds, "time_limit")
    if limit > 604_800.0:
        raise InvalidParameter(
            f"time_limit must be at most 604800 seconds, a week, got {shortened(seconds)}"
        )
    return limit


def contestants_of(name: str, given: Planner | Sequence[Planner]) -> list[Contestant]:
    """The planner or planners that go by a name. Raises InvalidParameter."""
    functions: list[Any] = list(given) if isinstance(given, list | tuple) else [given]
    for function in functions:
        check_planner(name, function)
    tunings = differences([getattr(function, "keywords", {}) for function in functions])
    if not functions or len(set(tunings)) < len(tunings):
        raise InvalidParameter(
            f"planners {name!r} must differ in an argument, given by functools.partial, got "
            f"{shortened(given)}"
        )
    return [
        Contestant(name, tuning, function, is_seeded(function))
        for tuning, function in zip(tunings, functions)
    ]


def check_planner(name: str, planner: Any) -> None:
    """Raise InvalidParameter unless it is a function, with arguments that it has."""
    function = getattr(planner, "func", planner)
    if not inspect.isfunction(function):
        raise InvalidParameter(
            f"planner {name!r} must be a function such as rrt, or partial(rrt, step=2.0), got "
            f"{shortened(planner)}"
        )
    known = inspect.signature(function).parameters
    for argument in getattr(planner, "keywords", {}):
        if argument not in known:
            close = difflib.get_close_matches(argument, known, 1)
            hint = (
                f"did you mean {close[0]!r}?"
                if close
                else f"it has {', '.join(list(known)[1:]) or 'none'}"
            )
            raise InvalidParameter(
                f"planner {name!r}: {function.__name__} has no argument {argument!r}; {hint}"
            )


def is_seeded(planner: Planner) -> bool:
    """Whether it draws lots."""
    return "rng" in inspect.signature(getattr(planner, "func", planner)).parameters


def differences(arguments: list[dict[str, Any]]) -> list[str]:
    """In words the arguments in which some differ.

    >>> differences([{"step": 2, "n": 10}, {"step": 2, "n": 20}])
    ['n=10', 'n=20']
    """
    names = list(dict.fromkeys(name for given in arguments for name in given))
    different = [name for name in names if len({repr(given.get(name)) for given in arguments}) > 1]
    return [
        ", ".join(f"{name}={given[name]!r}" for name in different if name in given)
        for given in arguments
    ]


def cells_of(experiment: ExperimentRecord) -> list[Cell]:
    """Its runs: problem by problem, planner by planner, seed by seed."""
    cells = []
    for problem_name, problem in experiment.problems.items():
        fresh = problem._replace(asked=problem.asked * 0)
        for name, tuning, function, seeded in experiment.contestants:
            kind = digest((version(), fresh, function, experiment.repeat))
            for seed in experiment.seeds if seeded else (None,):
                about = (problem_name, name, tuning, seed)
                cells.append(
                    Cell(*about, fresh, function, experiment.repeat, experiment.time_limit, kind)
                )
    return cells


def tuned(planner: Planner, arguments: dict[str, Any]) -> Planner:
    """A planner with its arguments."""
    return partial(planner, **arguments) if arguments else planner
