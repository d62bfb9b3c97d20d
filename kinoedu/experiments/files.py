"""Experiments as TOML files.

    name = "doors"                       # optional, as are seeds (10), repeat (1) and time_limit (60 seconds a run)
    seeds = 50                           # 0 to 49; or a list

    [problems.maze]                      # a file that read_problem reads, by its path from this file
    file = "maps/maze.map"
    query = 3                            # or start and goal; also robot as in a scene, and clearance

    [problems.rubble]                    # a world that is made: its arguments; seed stands for rng
    world = "scattered polygons"
    obstacles = 40
    seed = 1

    [planners.RRT]                       # a function of kinoedu.planners, and its arguments
    planner = "rrt"
    step = 2.0

    [planners."RRT*"]                    # a list is a planner for each of its values
    planner = "rrt_star"
    max_nodes = [500, 1000, 2000]

What a reader does not know it refuses, naming the key.
"""

import inspect
import itertools
import os
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any, get_args

from ..errors import KinoeduError, UnreadableScene
from ..files.scene_robots import ROBOTS
from ..files.scenes import read_problem
from ..planners.registry import PLANNERS
from ..support.json_fields import Field
from ..support.reading import read_text
from .experiment import Experiment, ExperimentRecord, tuned
from .worlds import MADE

PLAIN = (bool, int, float, str)  # what a file can say


def read_experiment(path: str | os.PathLike[str]) -> ExperimentRecord:
    """The experiment in a TOML file. Raises UnreadableScene or another named error, with the file's
    name and the key at fault.
    """
    file = Path(path)
    try:
        return experiment_from(Field("experiment", parsed(read_text(file)), file.parent), file.stem)
    except KinoeduError as error:
        raise type(error)(
            f"{file}: {error}" if str(file) not in str(error) else str(error)
        ) from error


def parsed(text: str) -> Any:
    """TOML as Python values. Raises UnreadableScene."""
    try:
        return tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise UnreadableScene(f"no TOML: {error}") from error


def experiment_from(whole: Field, name: str) -> ExperimentRecord:
    """An experiment from the whole file."""
    fields = whole.members(("problems", "planners"), ("name", "seeds", "repeat", "time_limit"))
    problems = {key: problem_from(field) for key, field in named(fields["problems"]).items()}
    contestants = {key: planners_from(field) for key, field in named(fields["planners"]).items()}
    given = {key: fields[key].value for key in ("repeat", "time_limit") if key in fields}
    seeds = fields["seeds"].value if "seeds" in fields else 10
    return Experiment(
        problems,
        contestants,
        seeds,
        name=fields["name"].text() if "name" in fields else name,
        **given,
    )


def named(table: Field) -> dict[str, Field]:
    """A table of tables by their names, at least one."""
    if not isinstance(table.value, dict) or not table.value:
        raise table.wrong(f"at least one table [{table.name.partition('.')[2]}.NAME]")
    return table.members((), tuple(table.value))


def problem_from(field: Field) -> Any:
    """A problem from a file or from a world that is made."""
    if isinstance(field.value, dict) and "world" in field.value:
        kind = field.value["world"]
        if not isinstance(kind, str) or kind not in MADE:
            raise field._replace(name=f"{field.name}.world", value=kind).wrong(
                f"one of {', '.join(map(repr, MADE))}"
            )
        makes = MADE[kind]
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


def planners_from(field: Field) -> list[Callable[..., Any]]:
    """The planners that a table describes: one, or one for each value of a list."""
    name = field.value.get("planner") if isinstance(field.value, dict) else None
    known = planners_by_name()
    if not isinstance(name, str) or name not in known:
        raise field._replace(name=f"{field.name}.planner", value=name).wrong(
            f"one of {', '.join(known)}"
        )
    lists = {key: value for key, value in field.value.items() if isinstance(value, list)}
    for key, value in lists.items():
        if not value:
            raise field._replace(name=f"{field.name}.{key}", value=value).wrong(
                "a value, or a list of at least one"
            )
    variants = [dict(zip(lists, values)) for values in itertools.product(*lists.values())]
    given = [field._replace(value={**field.value, **variant}) for variant in variants]
    return [
        tuned(known[name], arguments_from(variant, known[name], ("planner",), {}))
        for variant in given
    ]


def planners_by_name() -> dict[str, Callable[..., Any]]:
    """The planners' functions by their own names, as `kinoedu.planners` has them."""
    return {planner.function.__name__: planner.function for planner in PLANNERS.values()}


def arguments_from(
    field: Field, function: Callable[..., Any], said: tuple[str, ...], renamed: dict[str, str]
) -> dict[str, Any]:
    """A function's arguments as a table gives them, by its signature: known ones, of the right
    type; `said` is read already.
    """
    parameters = inspect.signature(function).parameters
    sayable = {
        name: kinds_of(parameter.annotation)
        for name, parameter in parameters.items()
        if name not in ("problem", "rng")
    }
    sayable = {name: kinds for name, kinds in sayable.items() if kinds}
    fields = field.members((*said, *renamed), tuple(sayable))
    for name, kinds in sayable.items():
        if name in fields and not (
            type(fields[name].value) in kinds
            or (type(fields[name].value) is int and float in kinds)
        ):
            raise fields[name].wrong(" or ".join(WORDS[kind] for kind in kinds))
    return {
        renamed.get(name, name): argument.value
        for name, argument in fields.items()
        if name not in said
    }


WORDS = {bool: "true or false", int: "a whole number", float: "a number", str: "a string"}


def kinds_of(annotation: Any) -> list[type]:
    """The plain types that an argument may have."""
    return [kind for kind in PLAIN if kind in (get_args(annotation) or (annotation,))]
