"""The body of A* on a grid among polygons and discs."""

from typing import NamedTuple

import numpy as np

from ..compiled import algorithm, compiled
from ..graphs.search import search
from ..planners.grids.grid import (
    Grid,
    Motions,
    centres,
    find_joined_node,
    octile,
    parent_positions,
    path_through,
)
from ..problems import ProblemRecord
from .plans import NOT_FOUND, ShownPlan, numbers_to, pose_problem, show_plan, tree_edges
from .scenes import FOUND, SceneArrays, no_rows


class GridSettings(NamedTuple):
    """The settings of A* on a grid: the side of a cell, and the numbers of columns and rows."""

    clearance: float
    spacing: float
    columns: float
    rows: float


@algorithm
def show_grid(scene: SceneArrays, settings: GridSettings, rng: np.random.Generator) -> ShownPlan:
    """A* on a grid among polygons and discs."""
    refused, problem = pose_problem(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_grid(problem, settings)


@compiled
def plan_by_grid(problem: ProblemRecord, settings: GridSettings) -> ShownPlan:
    """The nodes in the order in which A* settles them, and the path."""
    side, (x, y) = settings.spacing, problem.space.lo
    grid = Grid(Motions(problem), x, y, side, int(settings.columns), int(settings.rows))
    first = find_joined_node(problem, grid, problem.start)
    last = find_joined_node(problem, grid, problem.goal)
    path = np.empty((0, 2))
    if first < 0 or last < 0:
        shown = show_plan(problem, path, np.empty((0, 7)), no_rows(), 0, 0, side)
        shown.facts[0] = NOT_FOUND + (1 if first < 0 else 2)
        return shown
    cost, parent, expanded, _ = search(grid, first, last, octile(grid, last))
    if cost[last] < np.inf:
        path = path_through(problem, centres(grid, numbers_to(parent, last)))
    n, above = len(expanded), parent_positions(expanded, parent)
    edges = tree_edges(centres(grid, expanded), above, n)
    return show_plan(problem, path, edges, no_rows(), n, n, side)
