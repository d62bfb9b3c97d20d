"""Planners on a board: the scene of a problem, the problem of a scene, the drawing of a plan."""

import json
from collections.abc import Callable
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from ...errors import InvalidParameter
from ...figures.drawing import dot_size, growth_of, line_width, summary
from ...problems import Plan, Problem, ProblemRecord, Roadmap
from ...problems.plan import roots_of
from ...problems.protocols import ProblemLike
from ...support.json_fields import JsonObject
from ...support.text import shortened
from ...worlds import PolygonWorld
from ...worlds.checks import World
from ...worlds.polygon_world import PolygonWorldRecord, discs_of, rings_of
from ...worlds.terrain import TerrainRecord
from ..core.canvas import Canvas
from ..core.drawing import Drawing, Layer, dots, edges, path
from ..core.notes import note, with_notes
from ..core.scene import Scene, disc, handle, make_scene, place_of, polygon

START, GOAL = "start", "goal"


class Settings(NamedTuple):
    """The values of a board's controls."""

    seed: int
    step_size: float
    samples: int


def check_in_plane(problem: ProblemLike) -> ProblemRecord:
    """The problem itself, if its configurations are points of the plane; or InvalidParameter."""
    if not isinstance(problem, ProblemRecord) or problem.start.shape != (2,):
        raise InvalidParameter(
            "a board needs a Problem whose configurations are points of the plane, got "
            f"{shortened(problem)}"
        )
    return problem


def make_problem_canvas(
    problem: ProblemRecord,
    answer: Callable[[Scene], Drawing],
    code: Callable[[], str] | None = None,
) -> Canvas:
    """A canvas on which a problem's parts can be dragged; `code` as in `Canvas`."""
    return make_canvas(problem.world, make_problem_scene(problem), answer, code=code)


def make_canvas(
    world: World,
    scene: Scene,
    answer: Callable[[Scene], Drawing],
    drive: Callable[[set[str]], None] | None = None,
    code: Callable[[], str] | None = None,
) -> Canvas:
    """A canvas of a scene in a world, with the world's bitmap if it is a terrain.

    drive, code : the effect of arrow keys, and the board as Python code, as in `Canvas`.
    """
    free = world.free if isinstance(world, TerrainRecord) else None
    return Canvas(scene, answer, free=free, drive=drive, code=code)


def make_problem_scene(problem: ProblemRecord) -> Scene:
    """A problem's world with start and goal as handles; its obstacles can be dragged too."""
    radius = getattr(problem.robot, "radius", 0.0)
    handles = [
        handle(START, problem.start[:2], colour="start", radius=radius),
        handle(GOAL, problem.goal[:2], colour="goal", marker="star", radius=radius),
    ]
    return make_world_scene(problem.world, handles)


def make_world_scene(world: World, handles: list[JsonObject]) -> Scene:
    """A world with handles; among polygons every obstacle and its vertices can be dragged."""
    if not isinstance(world, PolygonWorldRecord):
        return make_scene(world.lo, world.hi, handles=handles)
    (outline,), *solids = rings_of(world)
    names = [f"obstacle {k}" for k in range(len(solids) + len(discs_of(world)))]
    polygons = [polygon(name, rings) for name, rings in zip(names, solids, strict=False)]
    discs = [
        disc(name, row[:2], row[2])
        for name, row in zip(names[len(solids) :], discs_of(world), strict=True)
    ]
    return make_scene(
        world.lo, world.hi, boundary=outline[::-1], handles=handles, polygons=polygons, discs=discs
    )


def problem_in(scene: Scene, problem: ProblemRecord) -> ProblemRecord:
    """The same problem with everything where the scene has it.

    Raises
    ------
    InvalidPolygon, InvalidStart, InvalidGoal
    """
    world = problem.world
    if isinstance(world, PolygonWorldRecord):
        world = world_in(scene)
    ends = place_of(scene, START), place_of(scene, GOAL)
    return Problem(problem.robot, world, *ends, clearance=problem.clearance)


def world_in(scene: Scene) -> PolygonWorldRecord:
    """The world of a scene's obstacles within its boundary, or InvalidPolygon."""
    rings = [item["rings"] for item in scene["polygons"]]
    discs = [(item["at"], item["radius"]) for item in scene["discs"]]
    return build_world(json.dumps([scene["boundary"], rings, discs]))


@lru_cache(maxsize=4)  # most drags move a start or a goal: then the world is the same
def build_world(parts: str) -> PolygonWorldRecord:
    """The world of a boundary, the rings of polygons, and discs, given as JSON."""
    boundary, polygons, discs = json.loads(parts)
    solids: list[Any] = [(rings[0], rings[1:]) if rings[1:] else rings[0] for rings in polygons]
    return PolygonWorld(boundary, solids + discs)


def draw_plan(plan: Plan) -> Drawing:
    """A plan as it grew, and its path."""
    layers: list[Layer] = []
    total, unit = growth_of(plan)
    if plan.tree is not None:
        nodes, parent = plan.tree.nodes[:, :2], plan.tree.parent
        grown = np.flatnonzero(parent >= 0)
        segments = np.stack([nodes[parent[grown]], nodes[grown]], axis=1)
        first = np.asarray(roots_of(parent)[grown] == 0)
        for these, colour in ((first, "tree"), (~first, "goal_tree")):
            if these.any():
                width, when = line_width(total), grown[these] + 1
                branch = {"node": grown[these], "parent": parent[grown[these]]}
                layer = edges(segments[these], colour, width=width, when=when)
                layers.append(with_notes(layer, note("node", node=None), **branch))
    if plan.roadmap is not None:
        nodes, pairs = plan.roadmap.nodes[:, :2], plan.roadmap.edges
        links = edges(nodes[pairs], "roadmap", width=0.8, when=np.arange(1, total + 1))
        spots = dots(nodes, "tree", radius=dot_size(len(nodes)) / 2.0)
        layers += note_roadmap(plan.roadmap, links, spots)
    if plan.path is not None:
        layers.append(path(plan.path[:, :2], "path"))
    return Drawing(layers, text=summary(plan, total), total=total, unit=unit)


def note_roadmap(roadmap: Roadmap, links: Layer, spots: Layer) -> list[Layer]:
    """The layers of a roadmap's edges and nodes, with what each of them says."""
    n, (u, v) = len(roadmap.nodes), roadmap.edges.T
    degree = np.bincount(roadmap.edges.ravel(), minlength=n)
    joined = note("roadmap_node", node=None, degree=None)
    return [
        with_notes(links, note("roadmap_edge", u=None, v=None), u=u, v=v),
        with_notes(spots, joined, node=np.arange(n), degree=degree),
    ]
