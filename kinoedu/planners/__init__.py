"""Planners: each takes a problem and returns a plan; the Bugs take start, goal and obstacles."""

from ..decomposition import decomposition_roadmap, sweep, trapezoidation, triangulation
from .answers import path_cost
from .best_within import best_within
from .bugs.bug0 import bug0
from .bugs.bug1 import bug1
from .bugs.bug2 import bug2
from .bugs.bug2_prelim import bug2_prelim
from .bugs.bug_base import bug_base
from .driving.hybrid_astar import hybrid_astar
from .driving.kinodynamic_prm import kinodynamic_prm
from .driving.kinodynamic_rrt import kinodynamic_rrt
from .driving.parameters import Drives, GoalBias, GoalRegion, Refinement, Sparsity
from .driving.sst import sst
from .driving.trajectories import trajectory_along
from .exact.by_decomposition import plan_by_decomposition
from .exact.cells_with_headings import cells_with_headings, plan_by_cells_with_headings
from .exact.visibility import plan_by_visibility, visibility_roadmap
from .exploring.receding_horizon import receding_horizon
from .grids.grid import plan_on_grid
from .moving.safe_intervals import plan_in_time, safe_intervals
from .roadmaps.alternatives import alternative_routes
from .roadmaps.changing import after_change, changed_box, changing_roadmap
from .roadmaps.connecting import ComponentKClosest, KClosest, Radius
from .roadmaps.grid_roadmap import grid_roadmap
from .roadmaps.multi_query import build_roadmap, query
from .roadmaps.prm import prm, prm_star
from .roadmaps.properties import roadmap_properties
from .roadmaps.search import dijkstra_path, plan_on_roadmap
from .shortcut import shortcut
from .trees.rrt import rrt
from .trees.rrt_connect import rrt_connect
from .trees.rrt_star import informed_rrt_star, rrt_star
from .trees.tree_roadmap import nodes_expansion, rrt_expansion, tree_roadmap

__all__ = [
    "ComponentKClosest",
    "Drives",
    "GoalBias",
    "GoalRegion",
    "KClosest",
    "Radius",
    "Refinement",
    "Sparsity",
    "after_change",
    "alternative_routes",
    "best_within",
    "bug0",
    "bug1",
    "bug2",
    "bug2_prelim",
    "bug_base",
    "build_roadmap",
    "cells_with_headings",
    "changed_box",
    "changing_roadmap",
    "decomposition_roadmap",
    "dijkstra_path",
    "grid_roadmap",
    "hybrid_astar",
    "informed_rrt_star",
    "kinodynamic_prm",
    "kinodynamic_rrt",
    "nodes_expansion",
    "path_cost",
    "plan_by_cells_with_headings",
    "plan_by_decomposition",
    "plan_by_visibility",
    "plan_in_time",
    "plan_on_grid",
    "plan_on_roadmap",
    "prm",
    "prm_star",
    "query",
    "receding_horizon",
    "roadmap_properties",
    "rrt",
    "rrt_connect",
    "rrt_expansion",
    "rrt_star",
    "safe_intervals",
    "shortcut",
    "sst",
    "sweep",
    "trajectory_along",
    "trapezoidation",
    "tree_roadmap",
    "triangulation",
    "visibility_roadmap",
]
