"""Scenes: a problem as a JSON file, version 1.

    {"version": 1,
     "about": "optional words",
     "robot": {"kind": "point"}  or  {"kind": "disk", "radius": 0.5}  or  {"kind": "polygon", "vertices": [[x, y], ...]}
          or  {"kind": "turning polygon", "vertices": [[x, y], ...], "turn_weight": 1.0}
          or  {"kind": "arm", "lengths": [1.5, 1.2], "width": 0.2, "base": [0.0, 0.0]}
          or  {"kind": "mesh", "file": "a mesh beside the scene", "slice_at": 0.1, "up": "z", "reference": [x, y],
               "turn_weight": 1.0}
          or  {"kind": "car", "length": 30, "width": 10, "wheelbase": 20,
               "rear_overhang": 5, "max_steering": 0.7853981633974483, "speeds": [-1, 1]},
     "world": {"kind": "polygons", "boundary": [[x, y], ...],
               "obstacles": [{"polygon": [[x, y], ...], "rooms": [[[x, y], ...]]}, {"centre": [x, y], "radius": r}]}
          or  {"kind": "terrain", "rows": ["..@", "..."], "resolution": 1.0, "origin": [0.0, 0.0]}
          or  {"kind": "map", "file": "a map or picture beside the scene"}
          or  {"kind": "mesh", "file": "a mesh beside the scene", "slice_at": 0.1, "up": "z", "boundary": [[x, y], ...]},
     "start": [x, y], "goal": [x, y],  with theta for what turns, and angles for an arm
     "clearance": 0.0}

`turn_weight`, `base`, a car's last three, `obstacles`, `rooms`, `resolution`, `origin`,
`clearance`, and of a mesh all but its file may be left out (see worlds/meshes.py). A terrain's rows
are written as they look, the top one first: "." is free, "@" is blocked. What a reader does not
know it refuses, naming the field.
"""

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter, UnknownFormat, UnreadableScene
from ..geometry.checks import Array
from ..problems import Problem, ProblemRecord
from ..robots import Point
from ..support.json_fields import Field, read_json
from ..support.reading import as_path
from ..support.text import shortened
from ..support.whole_files import written_whole
from ..worlds import PolygonWorld, Terrain
from ..worlds.polygon_world import PolygonWorldRecord, discs_of, rings_of
from ..worlds.terrain import TerrainRecord
from .benchmr import is_polygon_map, read_benchmr
from .meshes import mesh_world
from .movingai import read_scenario, scenario_beside
from .scene_robots import MESH_OPTIONS, ROBOTS, described, mesh_options
from .worlds import read_world

VERSION = 1
FREE, BLOCKED = ".", "@"


def read_scene(path: str | os.PathLike[str]) -> ProblemRecord:
    """The problem in a JSON scene. Raises UnreadableScene, with the field at fault, or
    UnknownFormat for another extension.

    Wrong polygons, a start that is not free and so on raise their own errors (InvalidPolygon,
    InvalidStart), with the file's name.
    """
    file = as_path(path)
    if file.suffix.lower() != ".json":
        raise UnknownFormat(
            f"{file}: a scene ends in .json; maps, pictures and meshes are read by read_world"
        )
    return read_json(file, "scene", problem_from)


def problem_from(scene: Field) -> ProblemRecord:
    """A problem from the whole scene."""
    scene.check_version(VERSION)
    fields = scene.members(("version", "robot", "world", "start", "goal"), ("about", "clearance"))
    return Problem(
        fields["robot"].kind(ROBOTS),
        fields["world"].kind(WORLDS),
        fields["start"].numbers(),
        fields["goal"].numbers(),
        clearance=fields["clearance"].number() if "clearance" in fields else 0.0,
    )


def polygons_from(field: Field) -> PolygonWorldRecord:
    """A world of polygons and discs."""
    fields = field.members(("kind", "boundary"), ("obstacles",))
    obstacles = fields["obstacles"].items() if "obstacles" in fields else []
    return PolygonWorld(
        fields["boundary"].points(), [obstacle_from(obstacle) for obstacle in obstacles]
    )


def obstacle_from(field: Field) -> Any:
    """An obstacle as PolygonWorld takes it."""
    if isinstance(field.value, dict) and "radius" in field.value:
        fields = field.members(("centre", "radius"))
        return fields["centre"].numbers(), fields["radius"].number()
    fields = field.members(("polygon",), ("rooms",))
    rooms = [room.points() for room in fields["rooms"].items()] if "rooms" in fields else []
    return (fields["polygon"].points(), rooms) if rooms else fields["polygon"].points()


def terrain_from(field: Field) -> TerrainRecord:
    """A terrain from its rows, the top one first."""
    fields = field.members(("kind", "rows"), ("resolution", "origin", "cost"))
    rows = [row.text() for row in fields["rows"].items()]
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


def map_from(field: Field) -> Any:
    """A world from a file beside the scene."""
    return read_world(field.folder / field.members(("kind", "file"))["file"].text())


def mesh_from(field: Field) -> PolygonWorldRecord:
    """A world from a mesh beside the scene."""
    fields = field.members(("kind", "file"), (*MESH_OPTIONS, "boundary", "margin"))
    return mesh_world(
        field.folder / fields["file"].text(),
        boundary=fields["boundary"].points() if "boundary" in fields else None,
        margin=fields["margin"].number() if "margin" in fields else None,
        **mesh_options(fields),
    )


WORLDS: dict[str, Callable[[Field], Any]] = {
    "polygons": polygons_from,
    "terrain": terrain_from,
    "map": map_from,
    "mesh": mesh_from,
}


def write_scene(problem: ProblemRecord, path: str | os.PathLike[str]) -> None:
    """Write a problem as a JSON scene that read_scene reads back equal, whole or not at all. Raises
    UnknownFormat, OSError.
    """
    file = Path(path)
    if file.suffix.lower() != ".json":
        raise UnknownFormat(f"{file}: a scene ends in .json")
    scene = scene_of(problem)
    with written_whole(file) as part, part.open("w", encoding="utf-8") as stream:
        json.dump(scene, stream, indent=1)


def scene_of(problem: ProblemRecord) -> dict[str, Any]:
    """A problem as a scene's object. Raises UnreadableScene for a robot that scenes cannot hold,
    InvalidParameter.
    """
    if not isinstance(problem, ProblemRecord):
        raise InvalidParameter(f"a scene holds a Problem, got {shortened(problem)}")
    return {
        "version": VERSION,
        "robot": described(problem.robot),
        "world": described(problem.world),
        "start": problem.start.tolist(),
        "goal": problem.goal.tolist(),
        "clearance": problem.clearance,
    }


@described.register
def _(world: PolygonWorldRecord) -> dict[str, Any]:
    (outline,), *solids = [[ring.tolist() for ring in rings] for rings in rings_of(world)]
    polygons = [{"polygon": ring, **({"rooms": rooms} if rooms else {})} for ring, *rooms in solids]
    discs = [{"centre": [x, y], "radius": r} for x, y, r in discs_of(world).tolist()]
    return {"kind": "polygons", "boundary": outline[::-1], "obstacles": polygons + discs}


@described.register
def _(world: TerrainRecord) -> dict[str, Any]:
    rows = ["".join(FREE if free else BLOCKED for free in row) for row in world.free[::-1].tolist()]
    place = {"resolution": world.resolution, "origin": world.origin.tolist()}
    cost = {"cost": np.where(world.free, world.cost, 1.0)[::-1].tolist()} if world.cost.size else {}
    return {"kind": "terrain", "rows": rows, **place, **cost}


def read_problem(
    path: str | os.PathLike[str],
    *,
    robot: Any = None,
    start: ArrayLike | None = None,
    goal: ArrayLike | None = None,
    query: int | None = None,
    clearance: float = 0.0,
) -> ProblemRecord:
    """A problem from any file that kinoedu reads.

    A JSON scene is a whole problem. A map, a picture or a mesh is a world: give start and goal, or
    for a MovingAI map the number of a `query` of the scenario beside it (0 by default); a map of
    polygons may have its own. The robot is a point unless another is given.

    Raises UnreadableScene or UnknownFormat, InvalidParameter where something is missing or given
    twice, InvalidStart, InvalidGoal.
    """
    file = as_path(path)
    if file.suffix.lower() == ".json" and is_polygon_map(file):
        world, own_start, own_goal = read_benchmr(file)
        start, goal = own_start if start is None else start, own_goal if goal is None else goal
        return problem_in(file, world, robot, start, goal, query, clearance)
    if file.suffix.lower() == ".json":
        if (robot, start, goal, query, clearance) != (None, None, None, None, 0.0):
            raise InvalidParameter(
                f"{file}: a scene has its own robot, start, goal and clearance; give none beside it"
            )
        return read_scene(file)
    return problem_in(file, read_world(file), robot, start, goal, query, clearance)


def problem_in(
    file: Path,
    world: Any,
    robot: Any,
    start: ArrayLike | None,
    goal: ArrayLike | None,
    query: int | None,
    clearance: float,
) -> ProblemRecord:
    """A problem in a world that was read from a file."""
    if (start is None) != (goal is None) or (start is not None and query is not None):
        raise InvalidParameter(
            f"{file}: give both start and goal, or the number of a query of its scenario"
        )
    if start is None or goal is None:
        start, goal = query_of(file, world, 0 if query is None else query)
    return Problem(Point() if robot is None else robot, world, start, goal, clearance=clearance)


def query_of(file: Path, world: Any, number: int) -> tuple[Array, Array]:
    """Start and goal of one query of the scenario that lies beside a map."""
    scenario = scenario_beside(file) if file.suffix.lower() == ".map" else None
    if scenario is None:
        raise InvalidParameter(
            f"{file}: no scenario (.scen) lies beside it; give a start and a goal"
        )
    queries = read_scenario(scenario)
    if not 0 <= number < len(queries):
        raise InvalidParameter(f"{scenario} has queries 0 to {len(queries) - 1}, got {number}")
    meant = queries[number]
    if world.free.shape != (meant.rows, meant.columns):
        size = f"{world.free.shape[1]} x {world.free.shape[0]}"
        raise UnreadableScene(
            f"{scenario}: query {number} is for a map of {meant.columns} x {meant.rows} cells, "
            f"{file} has {size}"
        )
    return meant.start, meant.goal
