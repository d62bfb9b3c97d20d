"""Problems for OMPL.app: a .cfg with a mesh of the robot and one of the obstacles, all flat.

The format is that of OMPL.app's own examples (github.com/ompl/omplapp, resources/2D): rigid bodies
that move and turn in the plane.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import InvalidParameter, UnknownFormat
from ..geometry.checks import Array
from ..geometry.convex import convex_parts
from ..geometry.parts import Parts
from ..problems import ProblemRecord
from ..robots.car import CarRobot
from ..robots.round import RoundRobot
from ..support.text import shortened
from ..support.whole_files import written_whole
from ..worlds.polygon_world import PolygonWorldRecord
from .outlines import rectangle

CORNERS = 32  # of the polygon that replaces a disc
WALL = 0.1  # the width of the wall round a world, as a fraction of its longer side
# ompl_benchmark stops without these; the numbers are those of OMPL.app's examples
BENCHMARK = ("[benchmark]", "time_limit = 20.0", "mem_limit = 1000.0", "run_count = 30")


def write_ompl_app(problem: ProblemRecord, path: str | os.PathLike[str]) -> None:
    """Write a problem for OMPL.app: `X.cfg`, and beside it `X_env.obj` and `X_robot.obj`.

    OMPL.app turns every body; give it the same problem, with a heading of 0, for one that does not.
    A disc becomes a polygon round it, and the world has a wall round it, so that a path there is
    free here too. The box of the world bounds the position of the robot's reference point. A
    clearance is not written.

    Raises
    ------
    UnknownFormat
        Where the file name extension is not .cfg.
    InvalidParameter
        Where the world is not of polygons, the robot is a point or an arm, there is a clearance, or
        the file's name has a #.
    OSError
    """
    file = Path(path)
    if file.suffix.lower() != ".cfg":
        raise UnknownFormat(f"{file}: a problem for OMPL.app ends in .cfg")
    if "#" in file.name:
        raise InvalidParameter(f"{file}: # begins a comment in OMPL.app's files; take another name")
    check(problem)
    environment, robot = (file.with_name(f"{file.stem}_{name}.obj") for name in ("env", "robot"))
    solids, body = solid_pieces(problem.world), convex_pieces(body_of(problem.robot))
    for mesh, pieces in ((environment, solids), (robot, body)):
        with written_whole(mesh) as part:
            part.write_text(mesh_text(pieces), encoding="ascii")
    with written_whole(file) as part:
        text = config_text(problem, file.stem, robot.name, environment.name)
        part.write_text(text, encoding="utf-8")


def check(problem: object) -> None:
    """Raise InvalidParameter for a problem that OMPL.app has no form for."""
    if not isinstance(problem, ProblemRecord):
        raise InvalidParameter(f"write_ompl_app takes a Problem, got {shortened(problem)}")
    robot = problem.robot
    if not isinstance(problem.world, PolygonWorldRecord):
        raise InvalidParameter("OMPL.app has meshes: give a problem among polygons")
    if isinstance(robot, RoundRobot) and robot.radius == 0.0:
        raise InvalidParameter(
            "OMPL.app moves a body: give a Disk, a polygon or a Car, not a point"
        )
    if not isinstance(robot, RoundRobot) and not hasattr(robot, "outline"):
        raise InvalidParameter("OMPL.app's robots here are a Disk, a polygon or a Car")
    if problem.clearance:
        raise InvalidParameter("OMPL.app has no clearance: grow the robot instead")


def body_of(robot: Any) -> Parts:
    """The convex pieces of a robot at the origin."""
    return robot.body if isinstance(robot, RoundRobot) else robot.shape


def solid_pieces(world: PolygonWorldRecord) -> Iterable[Array]:
    """The obstacles as convex polygons, and a wall round the outline of the world.

    A body there would leave the world otherwise: only its reference point has bounds.
    """
    yield from convex_pieces(world.obstacles)
    width = WALL * float((world.hi - world.lo).max())
    yield from convex_parts(rectangle(world.lo - width, world.hi + width), [world.hull])


def convex_pieces(parts: Parts) -> Iterable[Array]:
    """The pieces as convex polygons; a disc becomes a polygon round it."""
    for k, radius in enumerate(parts.radius):
        points = parts.points[parts.first[k] : parts.first[k + 1]]
        if radius == 0.0:
            yield points
            continue
        angles = 2.0 * np.pi * np.arange(CORNERS) / CORNERS
        reach = radius / math.cos(math.pi / CORNERS)
        yield points[0] + reach * np.column_stack([np.cos(angles), np.sin(angles)])


def mesh_text(pieces: Iterable[Array]) -> str:
    """Flat triangles of convex polygons, in Wavefront's format."""
    lines, count = ["# flat, at z = 0"], 0
    for points in pieces:
        lines += [f"v {x!r} {y!r} 0.0" for x, y in points.tolist()]
        lines += [
            f"f {count + 1} {count + k + 1} {count + k + 2}" for k in range(1, len(points) - 1)
        ]
        count += len(points)
    return "\n".join([*lines, ""])


def config_text(problem: ProblemRecord, name: str, robot: str, world: str) -> str:
    """The settings, in the words of OMPL.app."""
    lines = ["[problem]", f"name = {name}", f"robot = {robot}", f"world = {world}"]
    if isinstance(problem.robot, CarRobot):
        lines.append("control = kinematic_car")
    for end, q in (("start", problem.start), ("goal", problem.goal)):
        x, y, theta = [*q.tolist(), 0.0][:3]
        lines += [f"{end}.x = {x!r}", f"{end}.y = {y!r}", f"{end}.theta = {theta!r}"]
    for end, corner in (("min", problem.world.lo), ("max", problem.world.hi)):
        lines += [f"volume.{end}.{axis} = {float(c)!r}" for axis, c in zip("xy", corner)]
    other = "est=" if isinstance(problem.robot, CarRobot) else "prm="  # PRM plans no controls
    return "\n".join([*lines, "", *BENCHMARK, "", "[planner]", "rrt=", other, ""])
