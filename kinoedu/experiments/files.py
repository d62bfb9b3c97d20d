"""Experiments as TOML files.

    name = "doors"            # optional, like the next three
    seeds = 50                # default 10; 50 stands for 0 to 49; or a list
    repeat = 3                # default 1
    time_limit = 30           # seconds for each run, default 60

    [problems.maze]           # a file that read_problem reads; the path is relative to this file
    file = "maps/maze.map"
    query = 3                 # or start and goal; also robot as in a scene, and clearance

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

Unknown keys are rejected by name.
"""

import inspect
import itertools
import os
import tomllib
from collections.abc import Callable
from dataclasses import is_dataclass
from pathlib import Path
from typing import Any, get_args

from ..errors import KinoeduError, UnreadableScene
from ..files.scene_robots import ROBOTS
from ..files.scenes import read_problem
from ..planners.registry import PLANNERS
from ..problems import ProblemRecord
from ..support.json_fields import Field
from ..support.reading import read_text
from .experiment import Experiment, ExperimentRecord, Planner, bind_arguments
from .worlds import GENERATORS

PLAIN = (bool, int, float, str)  # types of values in a file


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
    file = Path(path)
    try:
        return experiment_from(
            Field("experiment", parse_toml(read_text(file)), file.parent), file.stem
        )
    except KinoeduError as error:
        raise type(error)(
            f"{file}: {error}" if str(file) not in str(error) else str(error)
        ) from error


def parse_toml(text: str) -> Any:
    """Parse TOML. Raises UnreadableScene."""
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise UnreadableScene(f"not valid TOML: {error}") from error


def experiment_from(table: Field, name: str) -> ExperimentRecord:
    """Experiment from the contents of a file."""
    fields = table.members(("problems", "planners"), ("name", "seeds", "repeat", "time_limit"))
    problems = {key: problem_from(field) for key, field in named_tables(fields["problems"]).items()}
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


def problem_from(field: Field) -> ProblemRecord:
    """Problem from a file, or with a generated world."""
    if isinstance(field.value, dict) and "world" in field.value:
        kind = field.value["world"]
        if not isinstance(kind, str) or kind not in GENERATORS:
            raise field._replace(name=f"{field.name}.world", value=kind).wrong(
                f"one of {', '.join(map(repr, GENERATORS))}"
            )
        makes = GENERATORS[kind]
        seed = {"seed": "rng"} if "rng" in inspect.signature(makes).parameters else {}
        return makes(**arguments_from(field, makes, ("world",), seed))
    fields = field.members(("file",), ("query", "start", "goal", "robot", "clearance"))
    query = fields.get("query")
    if query is not None and (isinstance(query.value, bool) or not isinstance(query.value, int)):
        raise query.wrong("a whole number")
    return read_problem(
        field.folder / fields["file"].text(),
        robot=fields["robot"].kind(ROBOTS) if "robot" in fields else None,
        start=fields["start"].numbers() if "start" in fields else None,
        goal=fields["goal"].numbers() if "goal" in fields else None,
        query=None if query is None else query.value,
        clearance=fields["clearance"].number() if "clearance" in fields else 0.0,
    )


def planners_from(field: Field) -> list[Planner]:
    """Planners of a table: one, or one for each value of its lists."""
    name = field.value.get("planner") if isinstance(field.value, dict) else None
    planners = planners_by_name()
    if not isinstance(name, str) or name not in planners:
        raise field._replace(name=f"{field.name}.planner", value=name).wrong(
            f"one of {', '.join(planners)}"
        )
    return [
        bind_arguments(
            planners[name],
            arguments_from(field._replace(value=variant), planners[name], ("planner",), {}),
        )
        for variant in variants_of(field)
    ]


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


def arguments_from(
    field: Field,
    function: Callable[..., object],
    already_read: tuple[str, ...],
    renamed: dict[str, str],
) -> dict[str, Any]:
    """Arguments of a function from a table, checked against its signature.

    `already_read` names the keys that do not count; `renamed` maps keys to other parameters.
    """
    parameters = inspect.signature(function, eval_str=True).parameters
    accepted = {
        name: parameter.annotation
        for name, parameter in parameters.items()
        if name not in ("problem", "rng")
        and (is_dataclass(parameter.annotation) or kinds_of(parameter.annotation))
    }
    fields = field.members((*already_read, *renamed), tuple(accepted))
    return {
        renamed.get(name, name): argument_from(argument, accepted.get(name, int))
        for name, argument in fields.items()
        if name not in already_read
    }


def argument_from(field: Field, annotation: Any) -> Any:
    """A value of the type that a parameter has: a plain value, or a record from a table."""
    if is_dataclass(annotation) and isinstance(annotation, type):
        return annotation(**arguments_from(field, annotation, (), {}))
    kinds, given = kinds_of(annotation), type(field.value)
    if given not in kinds and not (given is int and float in kinds):
        raise field.wrong(" or ".join(TYPE_NAMES[kind] for kind in kinds))
    return field.value


TYPE_NAMES = {bool: "true or false", int: "a whole number", float: "a number", str: "a string"}


def kinds_of(annotation: object) -> list[type]:
    """Plain types that an argument may have."""
    return [kind for kind in PLAIN if kind in (get_args(annotation) or (annotation,))]
