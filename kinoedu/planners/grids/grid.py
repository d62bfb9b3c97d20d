"""Shortest paths on a grid in the plane, by A*, with moves from each node to its eight neighbours.

LaValle, section 5.4.2. On a terrain's own cells these are the moves of N. R. Sturtevant,
"Benchmarks for grid-based pathfinding" (2012): a diagonal move needs two free cells beside it,
because touching is contact.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm, callable_from_compiled, generic, inlined
from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...graphs import astar
from ...graphs.flat import degree, edge, estimate
from ...messages import get_message
from ...problems import Plan, ProblemRecord, Tree
from ...robots.round import RoundRobot
from ...spaces import RealSpace
from ...worlds.terrain import TerrainRecord
from ..answers import plan_along
from ..problem_input import count_checks, world_size
from ..tuning import positive
from .directions import COLUMN_STEP, ROW_STEP, SQRT2, STRAIGHT, moves_between
from .jump_points import JumpPoints, fill_in, jump_points


class Grid(NamedTuple):
    """A grid of configurations, row by row, with a border that no move enters.

    Node j * columns + i is at (x, y) + (i - 1/2, j - 1/2) * side. `moves` gives the cost of each of
    the eight moves. The border is the outermost rows and columns.
    """

    moves: object
    x: float
    y: float
    side: float
    columns: int
    rows: int

    @property
    def size(self) -> int:
        """How many nodes there are."""
        return self.columns * self.rows


class Raster(NamedTuple):
    """Where a grid's nodes are, whatever its moves."""

    x: float
    y: float
    side: float
    columns: int


class Motions(NamedTuple):
    """Moves of any problem in the plane: a free motion costs its length."""

    problem: ProblemRecord


class CostedMotions(NamedTuple):
    """Moves on a terrain with costs: a free motion costs its integral."""

    problem: ProblemRecord


class Cells(NamedTuple):
    """Moves of a point on a terrain: a move costs its length where the cells it touches are free.

    free : (nodes,), whether the cell of each node is free.
    """

    free: NDArray[np.bool_]


REFUSED = np.inf


@degree.register(Grid)
def grid_degree(grid: Grid, u: int) -> int:
    """Eight moves."""
    return 8


@edge.register(Grid)
def grid_edge(grid: Grid, u: int, k: int) -> tuple[int, float]:
    """The end of move k and its cost; -1 where the move is refused."""
    cost = move_cost(grid.moves, grid, u, k)
    return u + ROW_STEP[k] * grid.columns + COLUMN_STEP[k] if cost < REFUSED else -1, cost


@generic(1)
def move_cost(moves: object, grid: Grid, u: int, k: int) -> float:
    """The cost of move k from node u; infinite where the move is refused."""
    raise TypeError("the moves of this grid have no costs")


@move_cost.register(Cells)
def cost_by_cells(moves: Cells, grid: Grid, u: int, k: int) -> float:
    """By the cell that it leads to and, for a diagonal move, the two cells beside it.

    Cells of the border are not free.
    """
    across, up = COLUMN_STEP[k], ROW_STEP[k] * grid.columns
    if not moves.free[u + across + up]:
        return REFUSED
    if k < STRAIGHT:
        return grid.side
    return SQRT2 * grid.side if moves.free[u + across] and moves.free[u + up] else REFUSED


@move_cost.register(Motions)
def cost_by_motions(moves: Motions, grid: Grid, u: int, k: int) -> float:
    """The length of the move where the problem says that it is free."""
    if not is_free_move(moves.problem, grid, u, k):
        return REFUSED
    return grid.side if k < STRAIGHT else SQRT2 * grid.side


@move_cost.register(CostedMotions)
def cost_by_costed_motions(moves: CostedMotions, grid: Grid, u: int, k: int) -> float:
    """The problem's cost of the move where it says that it is free."""
    if not is_free_move(moves.problem, grid, u, k):
        return REFUSED
    return moves.problem.motion_cost(*ends_of_move(grid, u, k))


@inlined
def is_free_move(problem: ProblemRecord, grid: Grid, u: int, k: int) -> bool:
    """Whether move k from node u stays off the border and its motion is free."""
    i, j = u % grid.columns + COLUMN_STEP[k], u // grid.columns + ROW_STEP[k]
    inside = 0 < i < grid.columns - 1 and 0 < j < grid.rows - 1
    return inside and problem.is_free_path(*ends_of_move(grid, u, k))


@inlined
def ends_of_move(grid: Grid, u: int, k: int) -> tuple[Array, Array]:
    """Where move k from node u begins and ends, each of shape (2,)."""
    i, j = u % grid.columns, u // grid.columns
    return centre(grid, i, j), centre(grid, i + COLUMN_STEP[k], j + ROW_STEP[k])


@inlined
def centre(grid: Grid, i: int, j: int) -> Array:
    """The node in column i and row j, shape (2,)."""
    return np.array([place(grid.x, i, grid.side), place(grid.y, j, grid.side)])


@callable_from_compiled
def place(origin: float, number: Any, side: float) -> Any:
    """Where the middle of a column or a row is, by its number; or of many, by an array."""
    return origin + (number - 0.5) * side


def plan_on_grid(problem: ProblemRecord, *, spacing: float | None = None) -> Plan:
    """Plan by A* on a grid, with the octile distance as heuristic.

    Where a point moves on a terrain's own cells at uniform cost, A* expands jump points only: see
    jump_points.py.

    The path goes from the start to the nearest grid node that it reaches by a free motion, from
    node to node, and to the goal. Complete for the grid only: where nothing is found, a finer grid
    may have a path.

    Parameters
    ----------
    problem : a Problem in the plane.
    spacing : the side of the grid's cells. By default a terrain's own cells, or a hundredth of a
        polygon world's diagonal.

    Returns
    -------
    Plan whose `tree` has the nodes in the order in which A* settled them.

    Raises
    ------
    InvalidParameter
        Where configurations are not points of the plane, or `spacing` is not positive, too large or
        too small.

    Examples
    --------
    >>> from kinoedu import Point, Problem, Terrain
    >>> ring = Terrain([[1, 1, 1], [1, 0, 1], [1, 1, 1]])
    >>> plan_on_grid(Problem(Point(), ring, start=(0.5, 0.5), goal=(2.5, 2.5))).cost
    4.0
    """
    if (
        not isinstance(problem, ProblemRecord)
        or not isinstance(problem.space, RealSpace)
        or problem.start.shape != (2,)
    ):
        raise InvalidParameter(
            "a grid needs a Problem whose configurations are points of the plane"
        )
    before = count_checks(problem)
    grid = grid_for(problem, None if spacing is None else positive(spacing, "spacing"))
    first, last = (find_joined_node(problem, grid, q) for q in (problem.start, problem.goal))
    if first < 0 or last < 0:
        reason = get_message("plan.start_off_grid" if first < 0 else "plan.goal_off_grid")
        return Plan(None, np.inf, reason=reason, problem=problem, planner="A*")
    graph: Grid | JumpPoints = grid
    if isinstance(grid.moves, Cells):
        graph = jump_points(grid.moves.free, grid.side, grid.columns, last)
    numbers, found = astar(graph, first, last, octile(grid, last))
    raster = Raster(grid.x, grid.y, grid.side, grid.columns)
    order = np.empty(grid.size, np.int32)
    tree = Tree(*tree_of_search(raster, found.expanded, found.parent, order))
    # directions that the cells answered, not the problem; a jump point has up to 8
    examined = 8 * len(found.expanded) if isinstance(grid.moves, Cells) else 0
    stats = {
        "expanded": len(found.expanded),
        "checks": count_checks(problem) - before + examined,
    }
    reason = get_message("plan.grid_failed", spacing=f"{grid.side:g}")
    if numbers is None:
        return plan_along(problem, tree.nodes, None, reason, planner="A*", tree=tree, stats=stats)
    nodes = centres(grid, fill_in(numbers, grid.columns))
    path = path_through(problem, nodes)
    return plan_along(
        problem, path, np.arange(len(path)), reason, planner="A*", tree=tree, stats=stats
    )


def grid_for(problem: ProblemRecord, spacing: float | None) -> Grid:
    """The grid for a problem; where a point moves on a terrain's own cells, by the cells alone."""
    robot, world = problem.robot, problem.world
    on_terrain = isinstance(world, TerrainRecord)
    has_costs = on_terrain and world.cost.size > 0
    moves: Motions | CostedMotions | Cells = (
        CostedMotions(problem) if has_costs else Motions(problem)
    )
    x, y = problem.space.lo.tolist()
    if on_terrain and spacing in (None, world.resolution):
        rows, columns = world.free.shape
        is_point = isinstance(robot, RoundRobot) and robot.radius + problem.clearance == 0.0
        if is_point and not has_costs:
            moves = Cells(np.pad(world.free, 1).ravel())
        return Grid(moves, x, y, world.resolution, columns + 2, rows + 2)
    side = world_size(problem) / 100.0 if spacing is None else spacing
    extent = problem.space.hi - problem.space.lo
    width, height = extent.tolist()
    if side > max(width, height) or max(width / side, 1.0) * max(height / side, 1.0) > 50e6:
        raise InvalidParameter(
            f"spacing {side:g} must be within the world's size {extent.max():g} and make at most "
            "50 million nodes"
        )
    columns, rows = np.maximum(np.floor(extent / side + 1e-9), 1).astype(int).tolist()
    return Grid(moves, x, y, side, columns + 2, rows + 2)


@callable_from_compiled
def path_through(problem: ProblemRecord, nodes: Array) -> Array:
    """The path (k, 2) from start to goal through grid nodes (m, 2), each place once."""
    if len(nodes) == 1 and problem.is_free_path(problem.start, problem.goal):
        nodes = nodes[:0]  # both in one cell, whose centre would be a detour
    path = np.concatenate((problem.start.reshape(1, 2), nodes, problem.goal.reshape(1, 2)))
    is_new = np.ones(len(path), np.bool_)
    is_new[1:] = (path[1:, 0] != path[:-1, 0]) | (path[1:, 1] != path[:-1, 1])
    return path[is_new]


@callable_from_compiled
def centres(grid: Grid, nodes: NDArray[np.int64]) -> Array:
    """The positions of grid nodes (k,), shape (k, 2)."""
    places = np.empty((len(nodes), 2))
    places[:, 0] = place(grid.x, nodes % grid.columns, grid.side)
    places[:, 1] = place(grid.y, nodes // grid.columns, grid.side)
    return places


@algorithm
def tree_of_search(
    grid: Raster, expanded: NDArray[np.int64], parent: NDArray[np.int64], order: NDArray[np.int32]
) -> tuple[Array, NDArray[np.int64]]:
    """The expanded nodes, (k,), as a tree.

    Returns their positions, (k, 2), and the parent of each among them, (k,), -1 for the start.

    order : (nodes,), to be filled in for expanded nodes; parents are expanded. Its numbers are
        short, because new memory costs more than the work on it.
    """
    nodes, above = np.empty((len(expanded), 2)), np.empty(len(expanded), np.int64)
    for i in range(len(expanded)):
        order[expanded[i]] = i
        column, row = moves_between(0, expanded[i], grid.columns)
        nodes[i, 0], nodes[i, 1] = place(grid.x, column, grid.side), place(grid.y, row, grid.side)
    for i in range(len(expanded)):
        before = parent[expanded[i]]
        above[i] = order[before] if before >= 0 else -1
    return nodes, above


@callable_from_compiled
def find_joined_node(problem: ProblemRecord, grid: Grid, q: Array) -> int:
    """The nearest of the nine grid nodes round q that a free motion joins it to, or -1."""
    column = min(max(math.floor((q[0] - grid.x) / grid.side) + 1, 1), grid.columns - 2)
    row = min(max(math.floor((q[1] - grid.y) / grid.side) + 1, 1), grid.rows - 2)
    nodes, n = np.empty(9, np.int64), 0
    for i in range(max(column - 1, 1), min(column + 1, grid.columns - 2) + 1):
        for j in range(max(row - 1, 1), min(row + 1, grid.rows - 2) + 1):
            nodes[n], n = j * grid.columns + i, n + 1
    places = centres(grid, nodes[:n])
    dx, dy = places[:, 0] - q[0], places[:, 1] - q[1]
    for k in np.argsort(dx * dx + dy * dy, kind="mergesort"):
        if problem.is_free_path(q, places[k]):
            return int(nodes[k])
    return -1


class OctileDistance(NamedTuple):
    """The octile distance from a node to the goal: the length without obstacles."""

    goal: int
    columns: int
    side: float


@callable_from_compiled
def octile(grid: Grid, goal: int) -> OctileDistance:
    """The heuristic of A* on a grid."""
    return OctileDistance(goal, grid.columns, grid.side)


@estimate.register(OctileDistance)
def octile_estimate(distance: OctileDistance, u: int) -> float:
    """Computed for the few nodes that a search inserts into its queue."""
    across, up = moves_between(u, distance.goal, distance.columns)
    length, less = max(abs(across), abs(up)), min(abs(across), abs(up))
    return (length + less * (SQRT2 - 1.0)) * distance.side
