"""Plans as files: all of one as JSON, version 1, or its path alone as CSV, a configuration in each row.

    {"version": 1, "planner": "rrt", "cost": 17.5, "reason": "", "path": [[x, y], ...], "stats": {"nodes": 34},
     "tree": {"nodes": [[x, y], ...], "parent": [-1, 0, ...]},
     "roadmap": {"nodes": [[x, y], ...], "edges": [[i, j], ...]},
     "walk": {"points": [...], "following": [...], "travelled": [...], "distance_to_goal": [...], "hit": [...], "leave": [...]},
     "problem": a scene}

Null stands for what a plan has not: a path with its cost, a tree, a roadmap, a walk, and a problem that scenes can hold.
"""

import csv
import json
import os
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from .curves.space import CurveSpace
from .errors import InvalidParameter, InvalidPoint, UnknownFormat, UnreadableScene
from .fields import Field, read_json
from .geometry.checks import as_array, shortened
from .problems import Plan, ProblemRecord, Recorder, Roadmap, Tree, Walk
from .scenes import problem_from, scene_of
from .spaces import RealSpace, WrappingSpace
from .whole_file import written_whole

VERSION = 1
WHOLE_NUMBERS = ("parent", "edges", "hit", "leave")  # the members of trees, roadmaps and walks that count nodes

Built = TypeVar("Built", Tree, Roadmap, Walk)


def write_plan(plan: Plan, path: str | os.PathLike[str]) -> None:
    """Write a plan into a file, whole or not at all.

    path : ends in .json for all of the plan, which `read_plan` reads back equal; or in .csv for the path alone, a row for each
    configuration below a row of names: x, y; x, y, theta; theta1, theta2, ... of an arm. Without a path there are no rows below it.

    Raises UnknownFormat for another ending, InvalidParameter for what is no plan, OSError where the file cannot be written.

    >>> from kinoedu import Point, PolygonWorld, Problem, plan_by_visibility
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    >>> with TemporaryDirectory() as folder:
    ...     write_plan(plan_by_visibility(Problem(Point(), world, start=(0.5, 4), goal=(8.5, 4))), Path(folder) / "plan.csv")
    ...     print((Path(folder) / "plan.csv").read_text())
    x,y
    0.5,4.0
    8.5,4.0
    <BLANKLINE>
    """
    if not isinstance(plan, Plan):
        raise InvalidParameter(f"expected the Plan of a planner, got {shortened(plan)}")
    file = Path(path)
    writers = {".csv": write_rows, ".json": write_whole_plan}
    if file.suffix.lower() not in writers:
        raise UnknownFormat(f"{file}: a plan ends in .json, or in .csv for its path alone")
    with written_whole(file) as part:
        writers[file.suffix.lower()](plan, part)


def write_rows(plan: Plan, file: Path) -> None:
    """The path as CSV."""
    rows = [] if plan.path is None else plan.path.tolist()
    with file.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(columns(plan))
        writer.writerows([repr(number) for number in row] for row in rows)


def columns(plan: Plan) -> list[str]:
    """What the coordinates of a plan's configurations are called."""
    space = getattr(plan.problem, "space", None)
    d = np.size(getattr(plan.problem, "start", ())) if plan.path is None else plan.path.shape[1]
    if isinstance(space, RealSpace | CurveSpace) or (isinstance(space, WrappingSpace) and not space.wraps[0]):
        return ["x", "y", "theta"][:d]
    letter = "theta" if isinstance(space, WrappingSpace) else "q"
    return [f"{letter}{i + 1}" for i in range(d)]


def write_whole_plan(plan: Plan, file: Path) -> None:
    """All of a plan as JSON."""
    inner = plan.problem.problem if isinstance(plan.problem, Recorder) else plan.problem
    try:
        scene = scene_of(inner) if isinstance(inner, ProblemRecord) else None
    except UnreadableScene:  # a robot that scenes cannot hold
        scene = None
    whole = {
        "version": VERSION,
        "planner": plan.planner,
        "cost": float(plan.cost) if np.isfinite(plan.cost) else None,
        "reason": plan.reason,
        "path": None if plan.path is None else plan.path.tolist(),
        "stats": {name: int(count) for name, count in plan.stats.items()},
        **{name: written_out(getattr(plan, name)) for name in ("tree", "roadmap", "walk")},
        "problem": scene,
    }
    with file.open("w", encoding="utf-8") as stream:
        json.dump(whole, stream, allow_nan=False)


def written_out(built: Any) -> dict[str, Any] | None:
    """A tree, a roadmap or a walk as an object of lists."""
    return None if built is None else {name: np.asarray(getattr(built, name)).tolist() for name in built._fields}


def read_plan(path: str | os.PathLike[str]) -> Plan:
    """The plan in a JSON file that `write_plan` wrote: path, cost, tree, roadmap and walk equal to the last bit.

    What the file says is not judged again: whether its path is free is for `plan.problem.is_free_path` to say. Raises
    UnreadableScene with the field at fault, UnknownFormat for another ending.
    """
    file = Path(path)
    if file.suffix.lower() != ".json":
        raise UnknownFormat(f"{file}: a plan that can be read ends in .json, got {file.suffix or 'no ending'}")
    return read_json(file, "plan", plan_from)


def plan_from(plan: Field) -> Plan:
    """A plan from the whole file."""
    plan.check_version(VERSION)
    members = ("version", "planner", "cost", "reason", "path", "stats", "tree", "roadmap", "walk", "problem")
    fields = plan.members(members)
    there = {name: field for name, field in fields.items() if field.value is not None}
    if ("path" in there) != ("cost" in there):
        raise plan.wrong("with both a path and its cost, or with neither")
    path = numbers_of(there["path"]) if "path" in there else None
    if path is not None and (path.ndim != 2 or len(path) == 0):
        raise fields["path"].wrong("a list of configurations")
    return Plan(
        path,
        fields["cost"].number() if "cost" in there else np.inf,
        tree=built_from(there["tree"], Tree) if "tree" in there else None,
        roadmap=built_from(there["roadmap"], Roadmap) if "roadmap" in there else None,
        walk=built_from(there["walk"], Walk) if "walk" in there else None,
        stats={name: int(numbers_of(count)) for name, count in stats_of(fields["stats"]).items()},
        reason=fields["reason"].text(),
        problem=problem_from(there["problem"]) if "problem" in there else None,
        planner=fields["planner"].text(),
    )


def stats_of(field: Field) -> dict[str, Field]:
    """Counts by their names, whatever these are."""
    counts = field.members((), tuple(field.value) if isinstance(field.value, dict) else ())
    for count in counts.values():
        if isinstance(count.value, bool) or not isinstance(count.value, int):
            raise count.wrong("a whole number")
    return counts


def numbers_of(field: Field) -> Any:
    """An array of any shape."""
    try:
        return as_array(field.value, field.name)
    except InvalidPoint as error:
        raise UnreadableScene(str(error)) from error


def built_from(field: Field, kind: type[Built]) -> Built:
    """A tree, a roadmap or a walk; its first member are its nodes, and what counts nodes counts nodes that are there."""
    fields = field.members(kind._fields)
    first, *others = kind._fields
    nodes = numbers_of(fields[first])
    if nodes.ndim != 2 or len(nodes) == 0:
        raise fields[first].wrong("a list of configurations")
    return kind(nodes, *(member(fields[name], name, len(nodes)) for name in others))


def member(field: Field, name: str, n: int) -> Any:
    """A member of what has n nodes: a flag, a length or a parent for each; or any number of nodes' numbers or of pairs of them."""
    if name == "following":
        if not all(isinstance(flag.value, bool) for flag in field.items()) or len(field.items()) != n:
            raise field.wrong(f"true or false for each of {n} points")
        return np.array(field.value, np.bool_)
    array = numbers_of(field)
    if array.size == 0:
        array = array.reshape((0, 2) if name == "edges" else 0)
    if array.ndim != (2 if name == "edges" else 1) or (name == "edges" and array.shape[1] != 2):
        raise field.wrong("pairs of numbers" if name == "edges" else "a list of numbers")
    if name not in ("edges", "hit", "leave") and len(array) != n:
        raise field.wrong(f"as long as the list of {n} nodes")
    return node_numbers(field, array, n) if name in WHOLE_NUMBERS else array


def node_numbers(field: Field, array: Any, n: int) -> Any:
    """Whole numbers from 0 to n - 1; or -1, the parent of a root."""
    if (array != np.floor(array)).any() or (array < -1).any() or (array >= n).any():
        raise field.wrong(f"numbers of the {n} nodes")
    return array.astype(np.int64)
