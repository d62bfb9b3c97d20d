"""kinoedu: a motion-planning course you can run.

A plan in four lines:

>>> import kinoedu as ke
>>> world = ke.PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
>>> plan = ke.rrt(ke.Problem(ke.Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
>>> plan.path is not None
True

The rooms of the house: `geometry`, `graphs`, `spaces`, `curves`, `worlds`, `robots`, `collision`, `problems`, `decomposition`,
`planners`, `scenes`; and imported when first used, `sampling`, `c_space`, `course`, `experiments`, and `figures` and `boards`,
which bring matplotlib and ipywidgets.
"""

from importlib import import_module
from typing import Any

from . import collision, curves, decomposition, geometry, graphs, planners, problems, robots, scenes, spaces, worlds
from .collision import collision_bound, collision_probability, link_in_contact
from .curves import dubins_path, reeds_shepp_path
from .decomposition import decomposition_roadmap, sweep, trapezoidation, triangulation
from .graphs import Graph, astar, bfs_path, bfs_tree, dfs_path, dijkstra
from .plan_files import read_plan, write_plan
from .planners import (
    ComponentKClosest,
    KClosest,
    Radius,
    after_change,
    alternative_routes,
    best_within,
    bug0,
    bug1,
    bug2,
    bug2_prelim,
    bug_base,
    build_roadmap,
    cells_with_headings,
    changed_box,
    changing_roadmap,
    grid_roadmap,
    hybrid_astar,
    informed_rrt_star,
    kinodynamic_prm,
    kinodynamic_rrt,
    path_cost,
    plan_by_cells_with_headings,
    plan_by_decomposition,
    plan_by_visibility,
    plan_in_time,
    plan_on_grid,
    plan_on_roadmap,
    prm,
    prm_star,
    query,
    receding_horizon,
    roadmap_properties,
    rrt,
    rrt_connect,
    rrt_expansion,
    rrt_star,
    shortcut,
    sst,
    trajectory_along,
    tree_roadmap,
    visibility_roadmap,
)
from .problems import Plan, Problem, Recorder
from .robots import Car, Disk, Point, RigidPolygon, Trajectory, TranslatingPolygon, TwoLinkArm
from .scenes import read_problem, read_scene, write_scene
from .spaces import circle_distance, torus_distance
from .timed_problems import TimedProblem
from .worlds import Moving, MovingWorld, PolygonWorld, Terrain, UncertainWorld, read_world, scan

__version__ = "0.1.0"


LATER = {"board": "boards"} | dict.fromkeys(("corner_grid", "dispersion", "halton", "sukharev_grid", "uniform_random"), "sampling")


def __getattr__(name: str) -> Any:
    """Import a room that draws, or that no plan needs, at its first use."""
    if name in ("boards", "c_space", "course", "experiments", "figures", "sampling"):
        return import_module(f"{__name__}.{name}")
    if name in LATER:
        return getattr(import_module(f"{__name__}.{LATER[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """All names, those as well that are not imported yet."""
    return __all__


__all__ = [
    "Car",
    "ComponentKClosest",
    "Disk",
    "Graph",
    "KClosest",
    "Moving",
    "MovingWorld",
    "Plan",
    "Point",
    "PolygonWorld",
    "Problem",
    "Radius",
    "Recorder",
    "RigidPolygon",
    "Terrain",
    "TimedProblem",
    "Trajectory",
    "TranslatingPolygon",
    "TwoLinkArm",
    "UncertainWorld",
    "after_change",
    "alternative_routes",
    "astar",
    "best_within",
    "bfs_path",
    "bfs_tree",
    "board",
    "boards",
    "bug0",
    "bug1",
    "bug2",
    "bug2_prelim",
    "bug_base",
    "build_roadmap",
    "c_space",
    "cells_with_headings",
    "changed_box",
    "changing_roadmap",
    "circle_distance",
    "collision",
    "collision_bound",
    "collision_probability",
    "corner_grid",
    "course",
    "curves",
    "decomposition",
    "decomposition_roadmap",
    "dfs_path",
    "dijkstra",
    "dispersion",
    "dubins_path",
    "experiments",
    "figures",
    "geometry",
    "graphs",
    "grid_roadmap",
    "halton",
    "hybrid_astar",
    "informed_rrt_star",
    "kinodynamic_prm",
    "kinodynamic_rrt",
    "link_in_contact",
    "path_cost",
    "plan_by_cells_with_headings",
    "plan_by_decomposition",
    "plan_by_visibility",
    "plan_in_time",
    "plan_on_grid",
    "plan_on_roadmap",
    "planners",
    "prm",
    "prm_star",
    "problems",
    "query",
    "read_plan",
    "read_problem",
    "read_scene",
    "read_world",
    "receding_horizon",
    "reeds_shepp_path",
    "roadmap_properties",
    "robots",
    "rrt",
    "rrt_connect",
    "rrt_expansion",
    "rrt_star",
    "sampling",
    "scan",
    "scenes",
    "shortcut",
    "spaces",
    "sst",
    "sukharev_grid",
    "sweep",
    "torus_distance",
    "trajectory_along",
    "trapezoidation",
    "tree_roadmap",
    "triangulation",
    "uniform_random",
    "visibility_roadmap",
    "worlds",
    "write_plan",
    "write_scene",
]
