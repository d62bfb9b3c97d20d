"""Scenes: a problem as a JSON file, version 1.

    {"version": 1,
     "about": "optional text",
     "robot": {"kind": "point"}
          or  {"kind": "disk", "radius": 0.5}
          or  {"kind": "polygon", "vertices": [[x, y], ...]}
          or  {"kind": "turning polygon", "vertices": [[x, y], ...], "turn_weight": 1.0}
          or  {"kind": "arm", "lengths": [1.5, 1.2], "width": 0.2, "base": [0.0, 0.0]}
          or  {"kind": "mesh", "file": "a mesh beside the scene", "slice_at": 0.1, "up": "z",
               "reference": [x, y], "turn_weight": 1.0}
          or  {"kind": "car", "length": 30, "width": 10, "wheelbase": 20,
               "rear_overhang": 5, "max_steering": 0.7853981633974483, "speeds": [-1, 1]},
     "world": {"kind": "polygons", "boundary": [[x, y], ...],
               "obstacles": [{"polygon": [[x, y], ...], "rooms": [[[x, y], ...]]},
                             {"centre": [x, y], "radius": r}]}
          or  {"kind": "terrain", "rows": ["..@", "..."], "resolution": 1.0,
               "origin": [0.0, 0.0], "cost": [[1.0, 2.5, 1.0], ...]}
          or  {"kind": "map", "file": "a map or picture beside the scene"}
          or  {"kind": "mesh", "file": "a mesh beside the scene", "slice_at": 0.1, "up": "z",
               "boundary": [[x, y], ...]},
     "start": [x, y], "goal": [x, y],
     "clearance": 0.0}

Start and goal are [x, y, theta] for a car or a turning polygon, and a list of angles for an arm.
These fields are optional: `about`, `turn_weight`, `base`, `rear_overhang`, `max_steering`,
`speeds`, `obstacles`, `rooms`, `resolution`, `origin`, `cost`, `clearance`, and all fields of a
mesh except its file (see meshes.py). The rows of a terrain, and of its costs, are written as in a
picture, the top row first: "." is free, "@" is blocked. An unknown field is an error that names it.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter, UnknownFormat, UnreadableScene
from ..geometry.checks import Array, integer
from ..problems import Problem, ProblemRecord
from ..problems.configurations import space_of
from ..robots import Point
from ..robots.kinds import Robot
from ..support.json_fields import Field, JsonObject, read_json
from ..support.reading import as_path, naming
from ..support.text import shortened
from ..support.whole_files import written_whole
from ..worlds import PolygonWorld, Terrain
from ..worlds.polygon_world import PolygonWorldRecord, discs_of, rings_of
from ..worlds.terrain import TerrainRecord
from .benchmr import is_polygon_map, read_benchmr
from .mending import mend_scene
from .meshes import mesh_world
from .movingai import read_scenario, scenario_beside
from .scene_robots import MESH_OPTIONS, ROBOTS, describe_for_scene, mesh_options
from .tpcap import read_tpcap
from .worlds import read_world

VERSION = 1
FREE, BLOCKED = ".", "@"


def read_scene(path: str | os.PathLike[str], *, repair: bool = False) -> ProblemRecord:
    """Read the problem in a JSON scene.

    Parameters
    ----------
    repair : whether polygons with repeated corners, that cross themselves, or that are there twice
        are repaired; the warning MendedPolygons says which, and how. By default they are refused.

    Returns
    -------
    ProblemRecord, equal to the problem that `write_scene` wrote.

    Raises
    ------
    UnreadableScene
        Where the file is missing or damaged; the message names the field.
    UnknownFormat
        Where the file name extension is not .json.
    KinoeduError
        The errors of `Problem` and its parts, such as InvalidPolygon or InvalidStart, with the name
        of the file.
    """
    file = as_path(path)
    if file.suffix.lower() != ".json":
        raise UnknownFormat(
            f"{file}: a scene ends in .json; maps, pictures and meshes are read by read_world"
        )
    return read_json(
        file,
        "scene",
        lambda scene: parse_problem(mend_scene(scene, str(file)) if repair else scene),
    )


def parse_problem(scene: Field) -> ProblemRecord:
    """Build the problem of a parsed scene."""
    scene.check_version(VERSION)
    if isinstance(scene.value, dict) and "planner" in scene.value:
        raise UnreadableScene(f"{scene.name} is a plan, for read_plan; its 'problem' is a scene")
    fields = scene.members(("version", "robot", "world", "start", "goal"), ("about", "clearance"))
    return Problem(
        fields["robot"].kind(ROBOTS),
        fields["world"].kind(WORLDS),
        fields["start"].numbers(),
        fields["goal"].numbers(),
        clearance=fields["clearance"].number() if "clearance" in fields else 0.0,
    )


def parse_polygon_world(field: Field) -> PolygonWorldRecord:
    """Build a world of polygons and discs."""
    fields = field.members(("kind", "boundary"), ("obstacles",))
    obstacles = fields["obstacles"].items() if "obstacles" in fields else []
    return PolygonWorld(
        fields["boundary"].points(), [parse_obstacle(obstacle) for obstacle in obstacles]
    )


def parse_obstacle(field: Field) -> Any:
    """An obstacle in the form that PolygonWorld takes."""
    if isinstance(field.value, dict) and "radius" in field.value:
        fields = field.members(("centre", "radius"))
        return fields["centre"].numbers(), fields["radius"].number()
    fields = field.members(("polygon",), ("rooms",))
    rooms = [room.points() for room in fields["rooms"].items()] if "rooms" in fields else []
    return (fields["polygon"].points(), rooms) if rooms else fields["polygon"].points()


def parse_terrain(field: Field) -> TerrainRecord:
    """Build a terrain from its rows, the top row first."""
    fields = field.members(("kind", "rows"), ("resolution", "origin", "cost"))
    rows = [row.text() for row in fields["rows"].items()]
    if not rows:
        raise fields["rows"].wrong("at least one row of cells")
    for row in fields["rows"].items():
        if set(row.value) - {FREE, BLOCKED} or len(row.value) != len(rows[0]):
            raise row.wrong(
                f'{len(rows[0])} cells, each "{FREE}" for free or "{BLOCKED}" for blocked'
            )
    return Terrain(
        np.array([[cell == FREE for cell in row] for row in rows[::-1]]).reshape(len(rows), -1),
        resolution=fields["resolution"].number() if "resolution" in fields else 1.0,
        origin=fields["origin"].numbers() if "origin" in fields else (0.0, 0.0),
        cost=[row.numbers() for row in fields["cost"].items()[::-1]] if "cost" in fields else None,
    )


def read_map_file(field: Field) -> Any:
    """Read a world from a file beside the scene."""
    return read_world(field.folder / field.members(("kind", "file"))["file"].text())


def read_mesh_file(field: Field) -> PolygonWorldRecord:
    """Read a world from a mesh file beside the scene."""
    fields = field.members(("kind", "file"), (*MESH_OPTIONS, "boundary", "margin"))
    return mesh_world(
        field.folder / fields["file"].text(),
        boundary=fields["boundary"].points() if "boundary" in fields else None,
        margin=fields["margin"].number() if "margin" in fields else None,
        **mesh_options(fields),
    )


WORLDS: dict[str, Callable[[Field], Any]] = {
    "polygons": parse_polygon_world,
    "terrain": parse_terrain,
    "map": read_map_file,
    "mesh": read_mesh_file,
}


def write_scene(problem: ProblemRecord, path: str | os.PathLike[str]) -> None:
    """Write a problem as a JSON scene, from which `read_scene` reads an equal problem.

    The file is written completely or not at all.

    Raises
    ------
    UnknownFormat
        Where the file name extension is not .json.
    UnreadableScene
        Where scenes have no such kind of robot.
    InvalidParameter
        Where `problem` is not a Problem.
    OSError
        Where the file cannot be written.
    """
    file = Path(path)
    if file.suffix.lower() != ".json":
        raise UnknownFormat(f"{file}: a scene ends in .json")
    scene = as_scene_object(problem)
    with written_whole(file) as part, part.open("w", encoding="utf-8") as stream:
        json.dump(scene, stream, indent=1)


def as_scene_object(problem: ProblemRecord) -> JsonObject:
    """The object of a scene, as JSON holds it.

    Raises
    ------
    UnreadableScene
        Where scenes have no such kind of robot.
    InvalidParameter
        Where `problem` is not a Problem.
    """
    if not isinstance(problem, ProblemRecord):
        raise InvalidParameter(f"a scene holds a Problem, got {shortened(problem)}")
    return {
        "version": VERSION,
        "robot": describe_for_scene(problem.robot),
        "world": describe_for_scene(problem.world),
        "start": problem.start.tolist(),
        "goal": problem.goal.tolist(),
        "clearance": problem.clearance,
    }


@describe_for_scene.register
def _(world: PolygonWorldRecord) -> JsonObject:
    (outline,), *solids = [[ring.tolist() for ring in rings] for rings in rings_of(world)]
    polygons = [{"polygon": ring, **({"rooms": rooms} if rooms else {})} for ring, *rooms in solids]
    discs = [{"centre": [x, y], "radius": r} for x, y, r in discs_of(world).tolist()]
    return {"kind": "polygons", "boundary": outline[::-1], "obstacles": polygons + discs}


@describe_for_scene.register
def _(world: TerrainRecord) -> JsonObject:
    rows = ["".join(FREE if free else BLOCKED for free in row) for row in world.free[::-1].tolist()]
    place = {"resolution": world.resolution, "origin": world.origin.tolist()}
    cost = {"cost": np.where(world.free, world.cost, 1.0)[::-1].tolist()} if world.cost.size else {}
    return {"kind": "terrain", "rows": rows, **place, **cost}


def read_problem(
    path: str | os.PathLike[str],
    *,
    robot: Robot | None = None,
    start: ArrayLike | None = None,
    goal: ArrayLike | None = None,
    query: int | None = None,
    clearance: float = 0.0,
    repair: bool = False,
) -> ProblemRecord:
    """Read a problem from any file that kinoedu reads.

    A JSON scene or a parking case (`read_tpcap`) is a whole problem. A map, a picture or a mesh is
    only a world.

    Parameters
    ----------
    robot : by default a point.
    start, goal : by default those of a polygon map, or of a query for a MovingAI map.
    query : the number of a query, from 0, in the scenario beside a MovingAI map. Default: 0.
    clearance : the distance to keep from obstacles.
    repair : whether the polygons of a scene are repaired, as by `read_scene`. Those of a polygon
        map, or a parking case, always are.

    Returns
    -------
    ProblemRecord

    Raises
    ------
    UnreadableScene, UnknownFormat
        Where the file cannot be read.
    InvalidParameter
        Where start or goal is missing, or something is given that the file has already.
    InvalidStart, InvalidGoal
        Where the start or the goal is not free.
    """
    file = as_path(path)
    if file.suffix.lower() == ".json" and is_polygon_map(file):
        drawn, robot = read_benchmr(file), Point() if robot is None else robot
        d = len(space_of(robot, drawn.world).lo)
        start = end_of_map(file, "start", drawn.start, d) if start is None else start
        goal = end_of_map(file, "goal", drawn.goal, d) if goal is None else goal
        return make_problem(file, drawn.world, robot, start, goal, query, clearance)
    if file.suffix.lower() in (".json", ".csv"):
        if any(one is not None for one in (robot, start, goal, query)) or clearance != 0.0:
            raise InvalidParameter(
                f"{file}: a scene has its own robot, start, goal and clearance; do not give others"
            )
        return (
            read_tpcap(file) if file.suffix.lower() == ".csv" else read_scene(file, repair=repair)
        )
    return make_problem(file, read_world(file), robot, start, goal, query, clearance)


def end_of_map(file: Path, name: str, own: Array | None, d: int) -> Array | None:
    """The start or the goal of a polygon map, for a robot with d numbers; None where it has none.

    Raises
    ------
    InvalidParameter
        Where it has another number of numbers.
    """
    if own is not None and len(own) != d:
        has = "x, y and a heading" if len(own) == 3 else "x and y"
        raise InvalidParameter(
            f"{file}: its {name} is {has}, and a configuration of the robot is {d} numbers; give a "
            "start and a goal"
        )
    return own


def make_problem(
    file: Path,
    world: PolygonWorldRecord | TerrainRecord,
    robot: Robot | None,
    start: ArrayLike | None,
    goal: ArrayLike | None,
    query: int | None,
    clearance: float,
) -> ProblemRecord:
    """Build a problem in a world that was read from a file."""
    if (start is None) != (goal is None) or (start is not None and query is not None):
        raise InvalidParameter(
            f"{file}: give both start and goal, or the number of a query of its scenario"
        )
    if start is None or goal is None:
        start, goal = read_query(file, world, 0 if query is None else query)
    with naming(file):
        return Problem(Point() if robot is None else robot, world, start, goal, clearance=clearance)


def read_query(file: Path, world: Any, number: int) -> tuple[Array, Array]:
    """The start and the goal of one query of the scenario beside a map."""
    if file.suffix.lower() != ".map":
        raise InvalidParameter(f"{file}: it is only a world; give a start and a goal")
    scenario = scenario_beside(file)
    if scenario is None:
        raise InvalidParameter(
            f"{file}: there is no scenario (.scen) beside it; give a start and a goal"
        )
    queries = read_scenario(scenario)
    meant = queries[integer(number, f"a query of {scenario}", least=0, most=len(queries) - 1)]
    if world.free.shape != (meant.rows, meant.columns):
        size = f"{world.free.shape[1]} x {world.free.shape[0]}"
        raise UnreadableScene(
            f"{scenario}: query {number} is for a map of {meant.columns} x {meant.rows} cells, "
            f"{file} has {size}"
        )
    return meant.start, meant.goal
