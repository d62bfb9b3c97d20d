"""A* on a grid as it is shown, by the problem's motions or by the cells of a bitmap."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled
from ..graphs.search import begin_search, search
from ..planners.grids.grid import (
    Cells,
    Grid,
    Motions,
    Raster,
    centres,
    find_joined_node,
    octile,
    path_through,
    tree_of_search,
)
from ..planners.grids.jump_points import fill_in, fill_table, pack_bits, points_towards
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
    return plan_by_motions(problem, settings)


@compiled
def plan_by_motions(problem: ProblemRecord, settings: GridSettings) -> ShownPlan:
    """The nodes in the order in which A* settles them, and the path; the problem judges moves."""
    grid = grid_by(Motions(problem), problem, settings)
    refused, first, last = join_ends(problem, grid)
    if first < 0 or last < 0:
        return refused
    heuristic = octile(grid, last)
    labels, queue = begin_search(grid.columns * grid.rows, first, heuristic)
    expanded, _ = search(grid, last, heuristic, labels, queue)
    nodes = numbers_to(labels.parent, last) if labels.cost[last] < np.inf else expanded[:0]
    return show_search(problem, grid, expanded, labels.parent, nodes)


@compiled
def plan_by_cells(
    problem: ProblemRecord, free: NDArray[np.bool_], settings: GridSettings
) -> ShownPlan:
    """The same on the cells of a bitmap, by its jump points."""
    columns, rows = int(settings.columns), int(settings.rows)
    padded = np.zeros((rows, columns), np.bool_)
    padded[1:-1, 1:-1] = free
    cells = padded.ravel()
    grid = grid_by(Cells(cells), problem, settings)
    refused, first, last = join_ends(problem, grid)
    if first < 0 or last < 0:
        return refused
    table = fill_table(pack_bits(cells), len(cells), columns)
    points = points_towards(last, table, cells, grid.side, columns)
    heuristic = octile(grid, last)
    labels, queue = begin_search(len(cells), first, heuristic)
    expanded, _ = search(points, last, heuristic, labels, queue)
    jumps = numbers_to(labels.parent, last) if labels.cost[last] < np.inf else expanded[:0]
    nodes = fill_in(jumps, columns) if len(jumps) > 0 else jumps
    return show_search(problem, grid, expanded, labels.parent, nodes)


@compiled
def grid_by(moves: Any, problem: ProblemRecord, settings: GridSettings) -> Grid:
    """The grid of the settings."""
    x, y = problem.space.lo
    return Grid(moves, x, y, settings.spacing, int(settings.columns), int(settings.rows))


@compiled
def join_ends(problem: ProblemRecord, grid: Grid) -> tuple[ShownPlan, int, int]:
    """The grid nodes at start and goal, -1 where there is none, and what is shown then."""
    first = find_joined_node(problem, grid, problem.start)
    last = find_joined_node(problem, grid, problem.goal)
    shown = show_plan(problem, np.empty((0, 2)), np.empty((0, 7)), no_rows(), 0, 0, grid.side)
    shown.facts[0] = NOT_FOUND + (1 if first < 0 else 2)
    return shown, first, last


@compiled
def show_search(
    problem: ProblemRecord,
    grid: Grid,
    expanded: NDArray[np.int64],
    parent: NDArray[np.int64],
    nodes: NDArray[np.int64],
) -> ShownPlan:
    """A search that expanded some nodes, and the path through others, none where there is none."""
    path = np.empty((0, 2))
    if len(nodes) > 0:
        path = path_through(problem, centres(grid, nodes))
    n, raster = len(expanded), Raster(grid.x, grid.y, grid.side, grid.columns)
    tree, above = tree_of_search(raster, expanded, parent, np.empty(len(parent), np.int32))
    edges = tree_edges(tree, above, n)
    return show_plan(problem, path, edges, no_rows(), n, n, grid.side)
