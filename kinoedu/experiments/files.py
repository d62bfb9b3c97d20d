"""Experiments as TOML files.

    name = "doors"            # optional, like the next three
    seeds = 50                # default 10; 50 stands for 0 to 49; or a list
    repeat = 3                # default 1
    time_limit = 30           # seconds for each run, default 60

    [problems.maze]           # a file that read_problem reads; the path is relative to this file
    file = "maps/maze.map"
    query = 3                 # or start and goal; also robot as in a scene, and clearance

    [problems.paris]          # queries of a MovingAI scenario: paris 0, paris 10
    scenario = "maps/Paris_1_256-even-1.scen"
    queries = [0, 10]         # by default all; also robot as in a scene

    [problems.rubble]         # a generated world with its arguments; seed stands for rng
    world = "scattered polygons"
    obstacles = 40
    seed = 1

    [planners.RRT]            # a function of kinoedu.planners with its arguments
    planner = "rrt"
    step_size = 2.0

    [planners."RRT*"]         # a list stands for one planner for each of its values
    planner = "rrt_star"
    max_nodes = [500, 1000, 2000]

    [planners.driven]         # a record such as Drives is a table
    planner = "kinodynamic_rrt"
    drives.trials = [8, 20]
    drives.duration = 0.5

    [planners.mine]           # a function of yours in mine.py beside this file, with its arguments
    planner = "mine.potential"
    gain = [1.0, 2.0]

    [problems.garden]         # a function of yours that returns a Problem, or a world
    world = "mine.garden"
    trees = 12                # its argument
    robot = {kind = "mine.Hovercraft", length = 2.0}   # what a function or class of yours returns
    start = [1, 1]
    goal = [9, 9]

Unknown keys are rejected by name. A file that names code runs it: run only what you trust.
"""

import inspect
import itertools
import os
import tomllib
from collections.abc import Callable
from typing import Any

from ..errors import InvalidParameter, KinoeduError, UnreadableScene
from ..files.scenario_files import read_scenario_problems
from ..files.scene_robots import ROBOTS
from ..files.scenes import read_problem
from ..geometry.checks import as_generator
from ..planners.own import rng_argument
from ..planners.registry import PLANNERS
from ..problems import Problem, ProblemRecord
from ..robots import Point
from ..support.faults import describe_exception
from ..support.json_fields import Field
from ..support.own_code import load_function, names_code
from ..support.reading import as_path, naming, read_text
from .arguments import arguments_from
from .experiment import Experiment, ExperimentRecord, Planner, bind_arguments
from .worlds import GENERATORS


def read_experiment(path: str | os.PathLike[str]) -> ExperimentRecord:
    """Read an experiment from a TOML file.

    Returns
    -------
    ExperimentRecord

    Raises
    ------
    UnreadableScene
        Or another error of kinoedu, with the file's name and the key at fault.
    """
    file = as_path(path)
    with naming(file):
        table = Field("experiment", parse_toml(read_text(file)), file.parent)
        return experiment_from(table, file.stem)


def parse_toml(text: str) -> Any:
    """Parse TOML. Raises UnreadableScene."""
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise UnreadableScene(f"not valid TOML: {error}") from error


def experiment_from(table: Field, name: str) -> ExperimentRecord:
    """Experiment from the contents of a file."""
    fields = table.members(("problems", "planners"), ("name", "seeds", "repeat", "time_limit"))
    problems: dict[str, ProblemRecord] = {}
    for key, field in named_tables(fields["problems"]).items():
        problems |= problems_from(key, field)
    contestants = {
        key: planners_from(field) for key, field in named_tables(fields["planners"]).items()
    }
    given = {key: fields[key].value for key in ("repeat", "time_limit") if key in fields}
    seeds = fields["seeds"].value if "seeds" in fields else 10
    return Experiment(
        problems,
        contestants,
        seeds,
        name=fields["name"].text() if "name" in fields else name,
        **given,
    )


def named_tables(table: Field) -> dict[str, Field]:
    """Table of at least one named table."""
    if not isinstance(table.value, dict) or not table.value:
        raise table.wrong(f"at least one table [{table.name.partition('.')[2]}.NAME]")
    return table.members((), tuple(table.value))


def problems_from(name: str, field: Field) -> dict[str, ProblemRecord]:
    """The problem of a table, or those of a scenario, each with its number."""
    if not isinstance(field.value, dict) or "scenario" not in field.value:
        return {name: problem_from(field)}
    fields = field.members(("scenario",), ("queries", "robot"))
    queries = [item.value for item in fields["queries"].items()] if "queries" in fields else None
    robot = robot_from(fields["robot"]) if "robot" in fields else None
    found = read_scenario_problems(field.folder / fields["scenario"].text(), queries, robot=robot)
    return {f"{name} {key.rpartition(' ')[2]}": problem for key, problem in found.items()}


def problem_from(field: Field) -> ProblemRecord:
    """Problem from a file, or with a generated world."""
    if isinstance(field.value, dict) and "world" in field.value:
        kind = field.value["world"]
        if names_code(kind):
            return problem_in_own_world(field, kind)
        if not isinstance(kind, str) or kind not in GENERATORS:
            raise field._replace(name=f"{field.name}.world", value=kind).wrong(
                f"one of {', '.join(map(repr, GENERATORS))}, or module.function of your own"
            )
        makes = GENERATORS[kind]
        return makes(**arguments_from(field, makes, ("world",), seed_of(makes)))
    fields = field.members(("file",), ("query", *ENDS))
    query = fields.get("query")
    if query is not None and (isinstance(query.value, bool) or not isinstance(query.value, int)):
        raise query.wrong("a whole number")
    return read_problem(
        field.folder / fields["file"].text(),
        query=None if query is None else query.value,
        **ends_from(fields),
    )


ENDS = ("robot", "start", "goal", "clearance")


def ends_from(fields: dict[str, Field]) -> dict[str, Any]:
    """The robot, start, goal and clearance of a problem, as far as they are given."""
    readers: dict[str, Callable[[Field], Any]] = {
        "robot": robot_from,
        "start": Field.numbers,
        "goal": Field.numbers,
        "clearance": Field.number,
    }
    return {name: readers[name](fields[name]) for name in ENDS if name in fields}


def robot_from(field: Field) -> Any:
    """A robot as in a scene, or what a reader's own function or class returns."""
    kind = field.value.get("kind") if isinstance(field.value, dict) else None
    if not names_code(kind):
        return field.kind(ROBOTS)
    makes = own_function(field, "kind", str(kind))
    return call_own(field, makes, arguments_from(field, makes, ("kind",), seed_of(makes)))


def problem_in_own_world(field: Field, name: str) -> ProblemRecord:
    """What a reader's own function returns: a problem, or a world for a start and a goal."""
    makes = own_function(field, "world", name)
    takes = inspect.signature(makes).parameters
    ends = tuple(key for key in ENDS if key in field.value and key not in takes)
    given = arguments_from(field, makes, ("world", *ends), seed_of(makes))
    made = call_own(field, makes, given)
    if isinstance(made, ProblemRecord):
        if ends:
            raise UnreadableScene(
                f"{field.name}: {name} returns a whole problem; do not give {', '.join(ends)} too"
            )
        return made
    fields = field.members(("world", "start", "goal"), tuple(field.value))
    with_robot = {"robot": Point(), **ends_from({key: fields[key] for key in ends})}
    return Problem(world=made, **with_robot)


def own_function(field: Field, key: str, name: str) -> Callable[..., Any]:
    """A reader's own function that a key of a table names; its file is run."""
    try:
        return load_function(name, field.folder)
    except InvalidParameter as error:
        raise UnreadableScene(f"{field.name}.{key}: {error}") from error


def call_own(field: Field, function: Callable[..., Any], arguments: dict[str, Any]) -> Any:
    """The result of a reader's own function; what it raises becomes an error with its line.

    A seed becomes a generator.
    """
    try:
        random = {"rng": as_generator(arguments["rng"])} if "rng" in arguments else {}
        return function(**{**arguments, **random})
    except KinoeduError:
        raise
    except Exception as error:
        message = describe_exception(error, function.__name__)
        raise UnreadableScene(f"{field.name}: {message}") from error


def seed_of(function: Callable[..., object]) -> dict[str, str]:
    """The key for a function's random numbers: seed stands for rng."""
    return {"seed": "rng"} if "rng" in inspect.signature(function).parameters else {}


def planners_from(field: Field) -> list[Planner]:
    """Planners of a table: one, or one for each value of its lists."""
    name = field.value.get("planner") if isinstance(field.value, dict) else None
    planners = planners_by_name()
    if names_code(name):
        planner = own_function(field, "planner", str(name))
    elif isinstance(name, str) and name in planners:
        planner = planners[name]
    else:
        raise field._replace(name=f"{field.name}.planner", value=name).wrong(
            f"one of {', '.join(planners)}, or module.function of your own"
        )
    return [
        bind_arguments(
            planner,
            arguments_from(
                field._replace(value=variant), planner, ("planner",), {}, first_arguments(planner)
            ),
        )
        for variant in variants_of(field)
    ]


def first_arguments(planner: Callable[..., object]) -> set[str]:
    """The names of the arguments that a planner is called with: its problem and its generator."""
    names = list(inspect.signature(planner).parameters)
    return {*names[: 2 if rng_argument(planner) == "second" else 1], "rng"}


def variants_of(table: Field) -> list[Any]:
    """A table for each combination of values in the lists of a table and of its tables."""
    choices = {
        key: choices_of(table._replace(name=f"{table.name}.{key}", value=value))
        for key, value in table.value.items()
    }
    return [dict(zip(choices, values)) for values in itertools.product(*choices.values())]


def choices_of(field: Field) -> list[Any]:
    """The values of a list, the variants of a table, or a value alone."""
    if isinstance(field.value, dict):
        return variants_of(field)
    if field.value == []:
        raise field.wrong("a value, or a list of at least one")
    return field.value if isinstance(field.value, list) else [field.value]


def planners_by_name() -> dict[str, Callable[..., Any]]:
    """The planners' functions by their own names, as `kinoedu.planners` has them."""
    return {planner.function.__name__: planner.function for planner in PLANNERS.values()}
