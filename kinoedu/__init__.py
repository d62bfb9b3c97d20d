"""kinoedu: a motion-planning course you can run.

A first plan:

>>> import kinoedu as ke
>>> boundary = [(0, 0), (10, 0), (10, 10), (0, 10)]
>>> obstacle = [(4, 0), (6, 0), (6, 8), (4, 8)]
>>> world = ke.PolygonWorld(boundary, [obstacle])
>>> plan = ke.rrt(ke.Problem(ke.Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
>>> plan.path is not None
True

The modules are `geometry`, `graphs`, `spaces`, `curves`, `worlds`, `robots`, `collision`,
`problems`, `decomposition`, `planners`, `files`, `sampling`, `c_space`, `course`, `experiments`,
`contracts`, `figures` and `boards`. Each is imported at its first use.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # shows type checkers the names of the table below
    from . import (
        collision,
        contracts,
        curves,
        decomposition,
        files,
        geometry,
        graphs,
        planners,
        problems,
        robots,
        spaces,
        worlds,
    )
    from .collision import clearance_of, collision_bound, collision_probability, link_in_contact
    from .contracts import check_planner, check_robot, check_world
    from .course import ask
    from .curves import dubins_path, reeds_shepp_path
    from .decomposition import decomposition_roadmap, sweep, trapezoidation, triangulation
    from .files import (
        read_mesh,
        read_plan,
        read_problem,
        read_scene,
        read_world,
        write_plan,
        write_scene,
    )
    from .graphs import Graph, astar, bfs_path, bfs_tree, dfs_path, dijkstra
    from .planners import (
        ComponentKClosest,
        Drives,
        GoalBias,
        GoalRegion,
        KClosest,
        Radius,
        Refinement,
        Sparsity,
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
    from .problems import Plan, Problem, Recorder, TimedProblem
    from .robots import Car, Disk, Point, RigidPolygon, Trajectory, TranslatingPolygon, TwoLinkArm
    from .spaces import circle_distance, torus_distance
    from .worlds import Moving, MovingWorld, PolygonWorld, Terrain, UncertainWorld, scan

__version__ = "1.0.0"

# The top-level names, by the module that defines them.
ROOMS = {
    "boards": "board",
    "collision": "clearance_of collision_bound collision_probability link_in_contact",
    "contracts": "check_planner check_robot check_world",
    "course": "ask",
    "curves": "dubins_path reeds_shepp_path",
    "decomposition": "decomposition_roadmap sweep trapezoidation triangulation",
    "files": "read_mesh read_plan read_problem read_scene read_world write_plan write_scene",
    "graphs": "Graph astar bfs_path bfs_tree dfs_path dijkstra",
    "planners": (
        "ComponentKClosest Drives GoalBias GoalRegion KClosest Radius Refinement Sparsity "
        "after_change alternative_routes best_within bug0 bug1 bug2 bug2_prelim bug_base "
        "build_roadmap cells_with_headings changed_box changing_roadmap grid_roadmap "
        "hybrid_astar informed_rrt_star kinodynamic_prm kinodynamic_rrt path_cost "
        "plan_by_cells_with_headings plan_by_decomposition plan_by_visibility "
        "plan_in_time plan_on_grid plan_on_roadmap prm prm_star query receding_horizon "
        "roadmap_properties rrt rrt_connect rrt_expansion rrt_star shortcut sst "
        "trajectory_along tree_roadmap visibility_roadmap"
    ),
    "problems": "Plan Problem Recorder TimedProblem",
    "robots": "Car Disk Point RigidPolygon Trajectory TranslatingPolygon TwoLinkArm",
    "sampling": "corner_grid dispersion halton sukharev_grid uniform_random",
    "spaces": "circle_distance torus_distance",
    "worlds": "Moving MovingWorld PolygonWorld Terrain UncertainWorld scan",
}
MODULES = (
    "boards c_space collision contracts course curves decomposition experiments figures files "
    "geometry graphs planners problems robots sampling spaces worlds"
)
HOME = {name: room for room, names in ROOMS.items() for name in names.split()}


def __getattr__(name: str) -> Any:
    """Import a module, or a name from one, at its first use."""
    if name in MODULES.split():
        return import_module(f"{__name__}.{name}")
    if name in HOME:
        found = globals()[name] = getattr(import_module(f"{__name__}.{HOME[name]}"), name)
        return found
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """All public names, including those not imported yet."""
    return __all__


__all__ = sorted([*HOME, *MODULES.split()])
