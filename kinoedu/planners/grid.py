"""Shortest paths on a grid laid over the plane, by A*: from each node to its eight neighbours, where the motion is free.

LaValle, section 5.4.2. On a terrain's own cells these are the moves of N. R. Sturtevant, "Benchmarks for grid-based pathfinding"
(2012): diagonally only past two free cells, since touching is contact.
"""

from itertools import product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled, inlined
from ..errors import InvalidParameter
from ..geometry.checks import Array
from ..graphs import astar
from ..graphs.flat import degree, edge
from ..problems import MOTIONS, Plan, ProblemRecord, Tree
from ..robots.round import RoundRobot
from ..spaces import RealSpace
from ..worlds.terrain import TerrainRecord
from .answers import plan_along
from .asking import world_size
from .tuning import positive

SQRT2 = float(np.sqrt(2.0))


class Lattice(NamedTuple):
    """A grid of configurations of any problem in the plane: node j * columns + i is (x, y) + (i + 1/2, j + 1/2) * side.

    A move is allowed when the problem says that its motion is free.
    """

    problem: Any
    x: float
    y: float
    side: float
    columns: int
    rows: int

    @property
    def size(self) -> int:
        """How many nodes there are."""
        return self.columns * self.rows


class CellGrid(NamedTuple):
    """The same for a point on a terrain, node by cell: a move is allowed when the cells that it touches are free."""

    free: NDArray[np.bool_]
    x: float
    y: float
    side: float
    columns: int
    rows: int

    @property
    def size(self) -> int:
        """How many nodes there are."""
        return self.columns * self.rows


class CostLattice(NamedTuple):
    """A `Lattice` on a terrain with costs: a move costs what its motion does."""

    problem: Any
    x: float
    y: float
    side: float
    columns: int
    rows: int

    @property
    def size(self) -> int:
        """How many nodes there are."""
        return self.columns * self.rows


Grid = Lattice | CellGrid | CostLattice
COLUMN_STEP = (-1, 1, 0, 0, -1, 1, -1, 1)  # the straight moves first
ROW_STEP = (0, 0, -1, 1, -1, -1, 1, 1)


@degree.register(Lattice)
@degree.register(CostLattice)
@degree.register(CellGrid)
def grid_degree(grid: Any, u: int) -> int:
    """Eight moves."""
    return 8


@compiled
def moved(columns: int, rows: int, u: int, k: int) -> tuple[int, int]:
    """Column and row after move k from node u; (-1, -1) outside the grid."""
    i, j = u % columns + COLUMN_STEP[k], u // columns + ROW_STEP[k]
    return (i, j) if 0 <= i < columns and 0 <= j < rows else (-1, -1)


@inlined
def centre(grid: Any, i: int, j: int) -> Array:
    """The centre of cell (i, j), shape (2,)."""
    return np.array([grid.x + (i + 0.5) * grid.side, grid.y + (j + 0.5) * grid.side])


@edge.register(Lattice)
def lattice_edge(grid: Lattice, u: int, k: int) -> tuple[int, float]:
    """Move k, where its motion is free."""
    i, j = moved(grid.columns, grid.rows, u, k)
    if i < 0:
        return -1, 0.0
    if not grid.problem.is_free_path(centre(grid, u % grid.columns, u // grid.columns), centre(grid, i, j)):
        return -1, 0.0
    return j * grid.columns + i, grid.side if k < 4 else SQRT2 * grid.side


@edge.register(CostLattice)
def cost_edge(grid: CostLattice, u: int, k: int) -> tuple[int, float]:
    """Move k, where its motion is free, and what that costs."""
    i, j = moved(grid.columns, grid.rows, u, k)
    if i < 0:
        return -1, 0.0
    here, there = centre(grid, u % grid.columns, u // grid.columns), centre(grid, i, j)
    if not grid.problem.is_free_path(here, there):
        return -1, 0.0
    return j * grid.columns + i, grid.problem.motion_cost(here, there)


@edge.register(CellGrid)
def cell_edge(grid: CellGrid, u: int, k: int) -> tuple[int, float]:
    """Move k, where the cell is free and, for a diagonal move, the two beside it are."""
    i, j = moved(grid.columns, grid.rows, u, k)
    if i < 0 or not grid.free[j, i]:
        return -1, 0.0
    if k < 4:
        return j * grid.columns + i, grid.side
    if not (grid.free[u // grid.columns, i] and grid.free[j, u % grid.columns]):
        return -1, 0.0
    return j * grid.columns + i, SQRT2 * grid.side


def plan_on_grid(problem: ProblemRecord, *, spacing: float | None = None) -> Plan:
    """The cheapest path of grid moves between the nodes that start and goal are joined to; A* with the octile distance.

    Parameters
    ----------
    problem : a Problem in the plane.
    spacing : the side of the grid's cells. By default a terrain's own cells, or a hundredth of a polygon world's diagonal.

    The path goes from the start to the nearest grid node that it reaches freely, from node to node, and on to the goal. Returns a
    Plan; its `tree` has the nodes in the order A* settled them. Complete for the grid only: where nothing is found, a finer grid
    may have a path. Raises InvalidParameter.

    >>> from kinoedu import Point, Problem, Terrain
    >>> plan = plan_on_grid(Problem(Point(), Terrain([[1, 1, 1], [1, 0, 1], [1, 1, 1]]), start=(0.5, 0.5), goal=(2.5, 2.5)))
    >>> plan.cost
    4.0
    """
    if not isinstance(problem, ProblemRecord) or not isinstance(problem.space, RealSpace) or problem.start.shape != (2,):
        raise InvalidParameter("a grid needs a Problem whose configurations are points of the plane")
    before = problem.asked[MOTIONS]
    grid = grid_for(problem, None if spacing is None else positive(spacing, "spacing"))
    first, last = (joined_node(problem, grid, q) for q in (problem.start, problem.goal))
    if first < 0 or last < 0:
        name = "start" if first < 0 else "goal"
        return Plan(
            None, np.inf, reason=f"no grid node is in free reach of the {name}; try a finer spacing", problem=problem, planner="A*"
        )
    numbers, found = astar(grid, first, last, octile(grid, last))
    order = np.full(grid.size, -1)
    order[found.expanded] = np.arange(len(found.expanded))
    tree = Tree(centres(grid, found.expanded), np.where(found.parent[found.expanded] < 0, -1, order[found.parent[found.expanded]]))
    looked_at = 8 * len(found.expanded) if isinstance(grid, CellGrid) else 0  # moves judged by cells, without asking the problem
    stats = {"expanded": len(found.expanded), "checks": int(problem.asked[MOTIONS] - before) + looked_at}
    reason = f"the goal cannot be reached on a grid of spacing {grid.side:g}; a finer one may have a path"
    if numbers is None:
        return plan_along(problem, tree.nodes, None, reason, planner="A*", tree=tree, stats=stats)
    nodes = centres(grid, numbers)
    if first == last and problem.is_free_path(problem.start, problem.goal):
        nodes = nodes[:0]  # both in one cell: no way round by its centre
    path = np.concatenate([[problem.start], nodes, [problem.goal]])
    path = path[np.append(True, (path[1:] != path[:-1]).any(axis=1))]
    return plan_along(problem, path, np.arange(len(path)), reason, planner="A*", tree=tree, stats=stats)


def grid_for(problem: ProblemRecord, spacing: float | None) -> Grid:
    """The grid that serves a problem: a point on a terrain's own cells is judged by the cells alone."""
    robot, world = problem.robot, problem.world
    on_terrain = isinstance(world, TerrainRecord)
    kind = CostLattice if on_terrain and world.cost.size else Lattice
    x, y = problem.space.lo.tolist()
    if on_terrain and spacing in (None, world.resolution):
        rows, columns = world.free.shape
        if isinstance(robot, RoundRobot) and robot.radius + problem.clearance == 0.0 and not world.cost.size:
            return CellGrid(world.free, x, y, world.resolution, columns, rows)
        return kind(problem, x, y, world.resolution, columns, rows)
    side = world_size(problem) / 100.0 if spacing is None else spacing
    extent = problem.space.hi - problem.space.lo
    width, height = extent.tolist()
    if side > max(width, height) or max(width / side, 1.0) * max(height / side, 1.0) > 50e6:
        raise InvalidParameter(
            f"spacing {side:g} must be within the world's size {extent.max():g} and make at most 50 million nodes"
        )
    columns, rows = np.maximum(np.floor(extent / side + 1e-9), 1).astype(int).tolist()
    return kind(problem, x, y, side, columns, rows)


def centres(grid: Grid, nodes: NDArray[np.int64]) -> Array:
    """Where grid nodes (k,) are in the world, shape (k, 2)."""
    cells = np.stack([nodes % grid.columns, nodes // grid.columns], axis=1)
    return np.array([grid.x, grid.y]) + (cells + 0.5) * grid.side


def joined_node(problem: ProblemRecord, grid: Grid, q: Array) -> int:
    """The nearest of the nine grid nodes round q that a free motion joins it to, or -1."""
    size = np.array([grid.columns, grid.rows])
    cell = np.clip(np.floor((q - [grid.x, grid.y]) / grid.side).astype(int), 0, size - 1)
    around = [cell + np.array(step) for step in product((-1, 0, 1), repeat=2)]
    nodes = np.array([j * grid.columns + i for i, j in around if 0 <= i < grid.columns and 0 <= j < grid.rows])
    places = centres(grid, nodes)
    for i in np.argsort(((places - q) ** 2).sum(axis=1), kind="stable"):
        if problem.is_free_path(q, places[i]):
            return int(nodes[i])
    return -1


def octile(grid: Grid, goal: int) -> Array:
    """The length of grid moves from each node to the goal if nothing were in the way, shape (n,)."""
    across = np.abs(np.arange(grid.columns) - goal % grid.columns)[None, :]
    up = np.abs(np.arange(grid.rows) - goal // grid.columns)[:, None]
    return (grid.side * (np.maximum(across, up) + (SQRT2 - 1.0) * np.minimum(across, up))).ravel()
