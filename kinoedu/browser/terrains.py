"""The bodies of the planners' board on a bitmap: the same planners in another world."""

import numpy as np

from ..compiled import algorithm, compiled
from ..problems import ProblemRecord
from ..robots.round import RoundRobot
from ..spaces import RealSpace
from ..worlds.terrain import TerrainRecord
from .grids import GridSettings, plan_by_cells, plan_by_motions
from .plans import (
    PairSettings,
    RoadmapSettings,
    ShownPlan,
    StarSettings,
    TreeSettings,
    find_end_in_contact,
    plan_by_prm,
    plan_by_rrt,
    plan_by_rrt_connect,
    plan_by_rrt_star,
    show_no_plan,
)
from .scenes import FOUND, SceneArrays


@algorithm
def show_terrain_rrt(
    scene: SceneArrays, settings: TreeSettings, rng: np.random.Generator
) -> ShownPlan:
    """RRT on a bitmap."""
    refused, problem = pose_on_terrain(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_rrt(problem, settings, rng)


@algorithm
def show_terrain_rrt_star(
    scene: SceneArrays, settings: StarSettings, rng: np.random.Generator
) -> ShownPlan:
    """RRT* on a bitmap."""
    refused, problem = pose_on_terrain(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_rrt_star(problem, settings, rng)


@algorithm
def show_terrain_rrt_connect(
    scene: SceneArrays, settings: PairSettings, rng: np.random.Generator
) -> ShownPlan:
    """RRT-Connect on a bitmap."""
    refused, problem = pose_on_terrain(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_rrt_connect(problem, settings, rng)


@algorithm
def show_terrain_prm(
    scene: SceneArrays, settings: RoadmapSettings, rng: np.random.Generator
) -> ShownPlan:
    """PRM on a bitmap."""
    refused, problem = pose_on_terrain(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_prm(problem, settings, rng)


@algorithm
def show_terrain_grid(
    scene: SceneArrays, settings: GridSettings, rng: np.random.Generator
) -> ShownPlan:
    """A* on a bitmap, on a grid whose moves the problem judges."""
    refused, problem = pose_on_terrain(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_motions(problem, settings)


@algorithm
def show_terrain_cells(
    scene: SceneArrays, settings: GridSettings, rng: np.random.Generator
) -> ShownPlan:
    """A* of a point on a bitmap's own cells."""
    refused, problem = pose_on_terrain(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_cells(problem, scene.free, settings)


@compiled
def pose_on_terrain(scene: SceneArrays, clearance: float) -> tuple[ShownPlan, ProblemRecord]:
    """What is shown where an end is not free, else with the status FOUND; and the problem."""
    side = (scene.hi[0] - scene.lo[0]) / scene.free.shape[1]
    world = TerrainRecord(scene.free, side, scene.lo, scene.lo, scene.hi, np.empty((0, 0)))
    start, goal = scene.handles[0, :2].copy(), scene.handles[1, :2].copy()
    robot, space = RoundRobot(scene.handles[0, 2]), RealSpace(world.lo, world.hi)
    problem = ProblemRecord(robot, world, space, start, goal, clearance, np.zeros(2, np.int64))
    return show_no_plan(find_end_in_contact(problem), 0, 0, 0), problem
