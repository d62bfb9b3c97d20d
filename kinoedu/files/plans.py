"""Plans as files: the whole plan as JSON, version 1, or its path alone as CSV.

    {"version": 1, "planner": "rrt", "cost": 17.5, "reason": "",
     "path": [[x, y], ...],
     "stats": {"nodes": 34},
     "tree": {"nodes": [[x, y], ...], "parent": [-1, 0, ...]},
     "roadmap": {"nodes": [[x, y], ...], "edges": [[i, j], ...]},
     "trajectory": {"start": [x, y, theta], "controls": [[v, phi], ...], "durations": [...],
                    "wheelbase": 2.5},
     "walk": {"points": [...], "following": [...], "travelled": [...],
              "distance_to_goal": [...], "hit": [...], "leave": [...]},
     "problem": a scene}

Trees and roadmaps of drives also have "controls" and "durations", and such roadmaps "goals". The
roadmap of cells with headings has "empty", the places at which no heading is free.
A part that a plan does not have is null: the path and its cost, the tree, the roadmap, the walk,
the trajectory, or a problem that a scene cannot hold.
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
from ..problems import CellsWithHeadings, Plan, ProblemRecord, Roadmap, Tree, Walk
from ..problems.recorder import unwrap_recorder
from ..robots.trajectory import DrivenRoadmap, DrivenTree, TrajectoryRecord
from ..spaces import RealSpace, WrappingSpace
from ..support.json_fields import Field, JsonObject, read_json
from ..support.reading import as_path
from ..support.text import shortened
from ..support.whole_files import written_whole
from .path_formats import write_ompl_path, write_ros_path
from .scenes import as_scene_object, parse_problem

VERSION = 1
KINDS: dict[str, tuple[Any, ...]] = {
    "tree": (Tree, DrivenTree),
    "roadmap": (Roadmap, DrivenRoadmap, CellsWithHeadings),
    "walk": (Walk,),
}
NODE_NUMBERS = ("parent", "edges", "goals", "hit", "leave")
PAIRS = ("edges", "controls", "empty")
ANY_LENGTH = ("edges", "goals", "hit", "leave", "empty")  # the others are as long as nodes or edges


def write_plan(plan: Plan, path: str | os.PathLike[str]) -> None:
    """Write a plan to a file, completely or not at all.

    Parameters
    ----------
    path : a name in .json for the whole plan, from which `read_plan` reads an equal one; or, for
        the path alone, in .csv, in .yaml for ROS 2 (a nav_msgs/msg/Path in the frame "map") or in
        .path for OMPL.app. A CSV file has a row of names (x, y; or x, y, theta; or theta1, theta2,
        ... for an arm), and then a row for each configuration of the path, if there is one.

    Raises
    ------
    UnknownFormat
        Where the file name extension is another one.
    InvalidParameter
        Where `plan` is not a Plan; for ROS 2 and OMPL.app where there is no path in the plane.
    OSError
        Where the file cannot be written.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, plan_by_visibility
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    >>> plan = plan_by_visibility(Problem(Point(), world, start=(0.5, 4), goal=(8.5, 4)))
    >>> with TemporaryDirectory() as folder:
    ...     write_plan(plan, Path(folder) / "plan.csv")
    ...     print((Path(folder) / "plan.csv").read_text())
    x,y
    0.5,4.0
    8.5,4.0
    <BLANKLINE>
    """
    if not isinstance(plan, Plan):
        raise InvalidParameter(f"expected the Plan of a planner, got {shortened(plan)}")
    file = Path(path)
    writers = {
        ".csv": write_rows,
        ".json": write_whole_plan,
        ".path": write_ompl_path,
        ".yaml": write_ros_path,
    }
    if file.suffix.lower() not in writers:
        raise UnknownFormat(
            f"{file}: a plan ends in .json, or in .csv, .yaml or .path for its path alone"
        )
    with written_whole(file) as part:
        writers[file.suffix.lower()](plan, part)


def write_rows(plan: Plan, file: Path) -> None:
    """Write the path as CSV."""
    rows = [] if plan.path is None else plan.path.tolist()
    with file.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(column_names(plan))
        writer.writerows([repr(number) for number in row] for row in rows)


def column_names(plan: Plan) -> list[str]:
    """The names of the coordinates of a plan's configurations."""
    space = getattr(plan.problem, "space", None)
    d = np.size(getattr(plan.problem, "start", ())) if plan.path is None else plan.path.shape[1]
    if isinstance(space, RealSpace | CurveSpace) or (
        isinstance(space, WrappingSpace) and not space.wraps[0]
    ):
        return ["x", "y", "theta"][:d]
    letter = "theta" if isinstance(space, WrappingSpace) else "q"
    return [f"{letter}{i + 1}" for i in range(d)]


def write_whole_plan(plan: Plan, file: Path) -> None:
    """Write the whole plan as JSON."""
    inner = unwrap_recorder(plan.problem)
    try:
        scene = as_scene_object(inner) if isinstance(inner, ProblemRecord) else None
    except UnreadableScene:  # a robot that scenes cannot hold
        scene = None
    parts = ("tree", "roadmap", "walk", "trajectory")
    plan_object = {
        "version": VERSION,
        "planner": plan.planner,
        "cost": float(plan.cost) if np.isfinite(plan.cost) else None,
        "reason": plan.reason,
        "path": None if plan.path is None else plan.path.tolist(),
        "stats": {name: int(count) for name, count in plan.stats.items()},
        **{name: as_json_object(getattr(plan, name)) for name in parts},
        "problem": scene,
    }
    with file.open("w", encoding="utf-8") as stream:
        json.dump(plan_object, stream, allow_nan=False)


def as_json_object(record: Any) -> JsonObject | None:
    """A tree, a roadmap, a walk or a trajectory as an object of lists and numbers."""
    if record is None:
        return None
    return {name: np.asarray(getattr(record, name)).tolist() for name in record._fields}


def read_plan(path: str | os.PathLike[str]) -> Plan:
    """Read the plan in a JSON file that `write_plan` wrote.

    The path is not checked for collisions; `plan.problem.is_free_path` can do that.

    Returns
    -------
    Plan, equal to the one that was written to the last bit.

    Raises
    ------
    UnreadableScene
        Where the file is missing or damaged; the message names the field.
    UnknownFormat
        Where the file name extension is not .json.
    """
    file = as_path(path)
    if file.suffix.lower() != ".json":
        raise UnknownFormat(
            f"{file}: a plan is read from a .json file, got {file.suffix or 'no ending'}"
        )
    return read_json(file, "plan", parse_plan)


def parse_plan(plan: Field) -> Plan:
    """Build the plan of a parsed file."""
    plan.check_version(VERSION)
    required = "version planner cost reason path stats tree roadmap walk problem"
    fields = plan.members(tuple(required.split()), ("trajectory",))
    there = {name: field for name, field in fields.items() if field.value is not None}
    if ("path" in there) != ("cost" in there):
        raise plan.wrong("with both a path and its cost, or with neither")
    path = parse_array(there["path"]) if "path" in there else None
    if path is not None and (path.ndim != 2 or len(path) == 0):
        raise fields["path"].wrong("a list of configurations")
    return Plan(
        path,
        fields["cost"].number() if "cost" in there else np.inf,
        **{
            name: parse_record(there[name], kinds) for name, kinds in KINDS.items() if name in there
        },
        trajectory=parse_trajectory(there["trajectory"]) if "trajectory" in there else None,
        stats=parse_stats(fields["stats"]),
        reason=fields["reason"].text(),
        problem=parse_problem(there["problem"]) if "problem" in there else None,
        planner=fields["planner"].text(),
    )


def parse_stats(field: Field) -> dict[str, int]:
    """The counts by their names. Any name is allowed."""
    counts = field.members((), tuple(field.value) if isinstance(field.value, dict) else ())
    for count in counts.values():
        if isinstance(count.value, bool) or not isinstance(count.value, int):
            raise count.wrong("a whole number")
    return {name: count.value for name, count in counts.items()}


def parse_array(field: Field) -> Any:
    """An array of numbers, of any shape."""
    try:
        return as_array(field.value, field.name)
    except InvalidPoint as error:
        raise UnreadableScene(str(error)) from error


def parse_record(field: Field, kinds: tuple[Any, ...]) -> Any:
    """A tree, a roadmap or a walk: the record of `kinds` that shares most members with the file.

    The first member of each record is its nodes (n, d); other members may hold numbers of nodes.
    """
    given = set(field.value) if isinstance(field.value, dict) else set()
    kind = max(kinds, key=lambda kind: len(given.intersection(kind._fields)))
    fields = field.members(kind._fields)
    first, *others = kind._fields
    nodes = parse_array(fields[first])
    if nodes.ndim != 2 or len(nodes) == 0:
        raise fields[first].wrong("a list of configurations")
    record = kind(nodes, *(parse_member(fields[name], name, len(nodes)) for name in others))
    for name, array in zip(others, record[1:], strict=True):
        among = "edges" if "edges" in others and name in ("controls", "durations") else first
        length = len(getattr(record, among))
        if name not in ANY_LENGTH and len(array) != length:
            raise fields[name].wrong(f"as long as the list of {length} {among}")
    return record


def parse_member(field: Field, name: str, n: int) -> Any:
    """A member of a record with n nodes: flags, numbers, or pairs of numbers.

    Numbers of nodes must be those of the n nodes.
    """
    if name == "following":
        if not all(isinstance(flag.value, bool) for flag in field.items()):
            raise field.wrong("a list of true and false")
        return np.array(field.value, np.bool_)
    array = parse_array(field)
    if array.size == 0:
        array = array.reshape((0, 2) if name in PAIRS else 0)
    if array.ndim != (2 if name in PAIRS else 1) or (name in PAIRS and array.shape[1] != 2):
        raise field.wrong("pairs of numbers" if name in PAIRS else "a list of numbers")
    if name not in NODE_NUMBERS:
        return array
    return as_node_numbers(field, array, n, least=-1 if name == "parent" else 0)


def parse_trajectory(field: Field) -> TrajectoryRecord:
    """A trajectory. Whether a car can drive it is not checked."""
    fields = field.members(TrajectoryRecord._fields)
    start, controls, durations = (
        parse_array(fields["start"]),
        *(parse_member(fields[name], name, 0) for name in ("controls", "durations")),
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


def as_node_numbers(field: Field, array: Any, n: int, least: int) -> Any:
    """Integers from 0 to n - 1; or from -1, the parent of a root."""
    if (array != np.floor(array)).any() or (array < least).any() or (array >= n).any():
        raise field.wrong(f"numbers of the {n} nodes")
    return array.astype(np.int64)
