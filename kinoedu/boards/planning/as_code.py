"""A board as Python code, to paste into another notebook."""

import base64
import zlib
from typing import Any

import numpy as np

from ...errors import InvalidParameter
from ...problems import ProblemRecord
from ...robots.polygon import TranslatingPolygonRobot
from ...robots.round import RoundRobot
from ...support.text import shortened
from ...worlds.polygon_world import PolygonWorldRecord, discs_of, rings_of
from ...worlds.terrain import TerrainRecord


def write_code(problem: ProblemRecord, planner: str, settings: dict[str, Any]) -> str:
    """Python code that makes the same problem and shows it on a board.

    Parameters
    ----------
    problem : of a point, a disk or a translating polygon, in any world.
    planner : an expression for the planner, such as `"rrt"` with its quotation marks.
    settings : other arguments of `board`.

    Raises
    ------
    InvalidParameter
        For another robot.
    """
    world = problem.world
    is_map = isinstance(world, TerrainRecord)
    lines = write_terrain(world) if is_map else write_polygons(world)
    start, goal = (tuple(q.tolist()) for q in (problem.start, problem.goal))
    robot = write_robot(problem.robot)
    margin = f", clearance={problem.clearance!r}" if problem.clearance else ""
    given = "".join(f", {name}={value!r}" for name, value in settings.items())
    return "\n".join(
        [
            *(("import base64, zlib", "import numpy as np") if is_map else ()),
            "import kinoedu as ke",
            "",
            *lines,
            f"problem = ke.Problem({robot}, world, start={start}, goal={goal}{margin})",
            f"ke.board(problem, {planner}{given})",
            "",
        ]
    )


def write_robot(robot: object) -> str:
    """The expression that makes a robot."""
    if isinstance(robot, RoundRobot):
        return f"ke.Disk({robot.radius!r})" if robot.radius else "ke.Point()"
    if isinstance(robot, TranslatingPolygonRobot):
        return f"ke.TranslatingPolygon({list_points(robot.outline)})"
    raise InvalidParameter(f"no code is known for this robot: {shortened(robot)}")


def write_polygons(world: PolygonWorldRecord) -> list[str]:
    """The lines that make a world of polygons and discs."""
    (outline,), *solids = rings_of(world)
    obstacles = [list_points(rings[0]) for rings in solids if not rings[1:]]
    obstacles += [
        f"({list_points(rings[0])}, [{', '.join(map(list_points, rings[1:]))}])"
        for rings in solids
        if rings[1:]
    ]
    obstacles += [f"(({x!r}, {y!r}), {radius!r})" for x, y, radius in discs_of(world).tolist()]
    return [
        "world = ke.PolygonWorld(",
        f"    {list_points(outline[::-1])},",
        "    [",
        *(f"        {obstacle}," for obstacle in obstacles),
        "    ],",
        ")",
    ]


def write_terrain(world: TerrainRecord) -> list[str]:
    """The lines that make a terrain: its cells, packed, and its costs where it has any."""
    about = f"resolution={world.resolution!r}, origin={tuple(world.origin.tolist())}"
    lines = [
        f"cells = {pack(np.packbits(world.free))}",
        "cells = np.unpackbits(np.frombuffer(zlib.decompress(cells), np.uint8))",
        f"free = cells[:{world.free.size}].reshape({world.free.shape})",
    ]
    if world.cost.size:
        costs = np.where(world.free, world.cost, 1.0)
        lines.append(f"cost = np.frombuffer(zlib.decompress({pack(costs)}))")
        about += f", cost=cost.reshape({world.free.shape})"
    return [*lines, f"world = ke.Terrain(free, {about})"]


def pack(numbers: np.ndarray[Any, Any]) -> str:
    """The expression for the compressed bytes of an array."""
    packed = base64.b64encode(zlib.compress(numbers.tobytes(), 9))
    return f'base64.b64decode("{packed.decode("ascii")}")'


def list_points(points: np.ndarray[Any, Any]) -> str:
    """Points as a list of pairs."""
    return repr([tuple(point) for point in points.tolist()])
