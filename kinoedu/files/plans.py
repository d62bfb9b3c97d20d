"""Plans as files: all of one as JSON, version 1, or its path alone as CSV, a configuration in each
row.

    {"version": 1, "planner": "rrt", "cost": 17.5, "reason": "", "path": [[x, y], ...], "stats": {"nodes": 34},
     "tree": {"nodes": [[x, y], ...], "parent": [-1, 0, ...]},
     "roadmap": {"nodes": [[x, y], ...], "edges": [[i, j], ...]},
     "trajectory": {"start": [x, y, theta], "controls": [[v, phi], ...], "durations": [...], "wheelbase": 2.5},
     "walk": {"points": [...], "following": [...], "travelled": [...], "distance_to_goal": [...], "hit": [...], "leave": [...]},
     "problem": a scene}

Trees and roadmaps that are driven have "controls" and "durations" too, such roadmaps also "goals".
Null stands for what a plan has not: a path with its cost, a tree, a roadmap, a walk, a trajectory,
and a problem that scenes can hold.
"""

import csv
import json
import os
from pathlib import Path
from typing import Any

import numpy as np

from ..curves.space import CurveSpace
from ..errors import InvalidParameter, InvalidPoint, UnknownFormat, UnreadableScene
from ..geometry.checks import as_array
from ..problems import Plan, ProblemRecord, Recorder, Roadmap, Tree, Walk
from ..robots.trajectory import DrivenRoadmap, DrivenTree, TrajectoryRecord
from ..spaces import RealSpace, WrappingSpace
from ..support.json_fields import Field, read_json
from ..support.reading import as_path
from ..support.text import shortened
from ..support.whole_files import written_whole
from .scenes import problem_from, scene_of

VERSION = 1
KINDS: dict[str, tuple[Any, ...]] = {
    "tree": (Tree, DrivenTree),
    "roadmap": (Roadmap, DrivenRoadmap),
    "walk": (Walk,),
}
WHOLE_NUMBERS = (
    "parent",
    "edges",
    "goals",
    "hit",
    "leave",
)  # the members of these that count nodes
PAIRS = ("edges", "controls")
AS_MANY_AS_THEY_ARE = ("edges", "goals", "hit", "leave")


def write_plan(plan: Plan, path: str | os.PathLike[str]) -> None:
    """Write a plan into a file, whole or not at all.

    path : ends in .json for all of the plan, which `read_plan` reads back equal; or in .csv for the
        path alone, a row for each configuration below a row of names: x, y; x, y, theta; theta1,
        theta2, ... of an arm. Without a path there are no rows below it.

    Raises UnknownFormat for another ending, InvalidParameter for what is no plan, OSError where the
    file cannot be written.

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
    if isinstance(space, RealSpace | CurveSpace) or (
        isinstance(space, WrappingSpace) and not space.wraps[0]
    ):
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
        **{
            name: written_out(getattr(plan, name))
            for name in ("tree", "roadmap", "walk", "trajectory")
        },
        "problem": scene,
    }
    with file.open("w", encoding="utf-8") as stream:
        json.dump(whole, stream, allow_nan=False)


def written_out(built: Any) -> dict[str, Any] | None:
    """A tree, a roadmap, a walk or a trajectory as an object of lists and numbers."""
    return (
        None
        if built is None
        else {name: np.asarray(getattr(built, name)).tolist() for name in built._fields}
    )


def read_plan(path: str | os.PathLike[str]) -> Plan:
    """The plan in a JSON file that `write_plan` wrote: path, cost, and all that was built, equal to
    the last bit.

    What the file says is not judged again: whether its path is free is for
    `plan.problem.is_free_path` to say. Raises UnreadableScene with the field at fault,
    UnknownFormat for another ending.
    """
    file = as_path(path)
    if file.suffix.lower() != ".json":
        raise UnknownFormat(
            f"{file}: a plan that can be read ends in .json, got {file.suffix or 'no ending'}"
        )
    return read_json(file, "plan", plan_from)


def plan_from(plan: Field) -> Plan:
    """A plan from the whole file."""
    plan.check_version(VERSION)
    members = (
        "version",
        "planner",
        "cost",
        "reason",
        "path",
        "stats",
        "tree",
        "roadmap",
        "walk",
        "problem",
    )
    fields = plan.members(members, ("trajectory",))
    there = {name: field for name, field in fields.items() if field.value is not None}
    if ("path" in there) != ("cost" in there):
        raise plan.wrong("with both a path and its cost, or with neither")
    path = numbers_of(there["path"]) if "path" in there else None
    if path is not None and (path.ndim != 2 or len(path) == 0):
        raise fields["path"].wrong("a list of configurations")
    return Plan(
        path,
        fields["cost"].number() if "cost" in there else np.inf,
        **{name: built_from(there[name], kinds) for name, kinds in KINDS.items() if name in there},
        trajectory=trajectory_from(there["trajectory"]) if "trajectory" in there else None,
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


def built_from(field: Field, kinds: tuple[Any, ...]) -> Any:
    """A tree, a roadmap or a walk, of the kind that shares most members; the first are its nodes,
    others may count them.
    """
    given = set(field.value) if isinstance(field.value, dict) else set()
    kind = max(kinds, key=lambda kind: len(given.intersection(kind._fields)))
    fields = field.members(kind._fields)
    first, *others = kind._fields
    nodes = numbers_of(fields[first])
    if nodes.ndim != 2 or len(nodes) == 0:
        raise fields[first].wrong("a list of configurations")
    built = kind(nodes, *(member(fields[name], name, len(nodes)) for name in others))
    for name, array in zip(others, built[1:], strict=True):
        among = "edges" if "edges" in others and name in ("controls", "durations") else first
        if name not in AS_MANY_AS_THEY_ARE and len(array) != len(getattr(built, among)):
            raise fields[name].wrong(f"as long as the list of {len(getattr(built, among))} {among}")
    return built


def member(field: Field, name: str, n: int) -> Any:
    """A member of what has n nodes: flags, numbers, or pairs of them; what counts nodes counts
    nodes that are there.
    """
    if name == "following":
        if not all(isinstance(flag.value, bool) for flag in field.items()):
            raise field.wrong("a list of true and false")
        return np.array(field.value, np.bool_)
    array = numbers_of(field)
    if array.size == 0:
        array = array.reshape((0, 2) if name in PAIRS else 0)
    if array.ndim != (2 if name in PAIRS else 1) or (name in PAIRS and array.shape[1] != 2):
        raise field.wrong("pairs of numbers" if name in PAIRS else "a list of numbers")
    return node_numbers(field, array, n) if name in WHOLE_NUMBERS else array


def trajectory_from(field: Field) -> TrajectoryRecord:
    """A trajectory, as it was driven: whether a car can drive it is for the car to say."""
    fields = field.members(TrajectoryRecord._fields)
    start, controls, durations = (
        numbers_of(fields["start"]),
        *(member(fields[name], name, 0) for name in ("controls", "durations")),
    )
    if start.shape != (3,):
        raise fields["start"].wrong("[x, y, theta]")
    if len(durations) != len(controls) or (durations < 0.0).any():
        raise fields["durations"].wrong(
            f"a number of zero or more for each of {len(controls)} controls"
        )
    if not fields["wheelbase"].number() > 0.0:
        raise fields["wheelbase"].wrong("positive")
    return TrajectoryRecord(start, controls, durations, fields["wheelbase"].number())


def node_numbers(field: Field, array: Any, n: int) -> Any:
    """Whole numbers from 0 to n - 1; or -1, the parent of a root."""
    if (array != np.floor(array)).any() or (array < -1).any() or (array >= n).any():
        raise field.wrong(f"numbers of the {n} nodes")
    return array.astype(np.int64)
