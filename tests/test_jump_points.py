"""Jump points: paths as short as those of A* on all cells and of scipy, by free moves only."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.sparse import coo_array
from scipy.sparse.csgraph import dijkstra

import kinoedu as ke
from kinoedu.compiled import COMPILED_FIRST, INTERPRETED, running
from kinoedu.graphs import astar, astar_expansions
from kinoedu.graphs.flat import edge
from kinoedu.planners.grids.directions import COLUMN_STEP, ROW_STEP, SQRT2
from kinoedu.planners.grids.grid import (
    Cells,
    Grid,
    centres,
    find_joined_node,
    grid_for,
    octile,
    path_through,
)
from kinoedu.planners.grids.jump_points import fill_in, jump_points, jump_table

SHAPES = [(1, 1), (1, 2), (1, 13), (13, 1), (2, 2), (3, 3), (5, 4), (9, 9), (7, 16), (20, 11)]
DENSITIES = (0.0, 0.05, 0.15, 0.25, 0.35, 0.5, 0.7)


def random_grid(rng, shape, blocked):
    """A grid with a blocked border, its record, and the nodes that are free."""
    free = np.pad(rng.random(shape) >= blocked, 1)
    grid = Grid(Cells(free.ravel()), 0.0, 0.0, 1.0, shape[1] + 2, shape[0] + 2)
    return grid, np.flatnonzero(free)


def points_of(grid, goal):
    """The jump points of a grid, for a goal."""
    return jump_points(grid.moves.free, grid.side, grid.columns, goal)


def all_moves(grid):
    """The moves of a grid as a sparse matrix, by the rule: diagonally past two free cells."""
    rows, columns, lengths = [], [], []
    free = grid.moves.free
    for u in np.flatnonzero(free):
        for a, b in zip(COLUMN_STEP, ROW_STEP):
            if free[[u + a, u + b * grid.columns, u + a + b * grid.columns]].all():
                rows.append(u)
                columns.append(u + a + b * grid.columns)
                lengths.append(SQRT2 if a and b else 1.0)
    return coo_array((lengths, (rows, columns)), shape=(grid.size, grid.size)).tocsr()


@pytest.mark.parametrize("shape", SHAPES, ids=str)
@pytest.mark.parametrize("blocked", DENSITIES)
def test_lengths_equal_scipys_on_random_grids(shape, blocked):
    """From a random cell to itself and to ten others, also such as are out of reach: 4,000 queries
    in all. Each path is one of single free moves.
    """
    rng = np.random.default_rng([*shape, int(100 * blocked)])
    for _ in range(6):
        grid, cells = random_grid(rng, shape, blocked)
        if not len(cells):
            continue
        start, moves = int(rng.choice(cells)), all_moves(grid)
        shortest = dijkstra(moves, indices=start)
        for goal in [start, *rng.permutation(cells)[:10].tolist()]:
            path, found = astar(points_of(grid, goal), start, goal, octile(grid, goal))
            assert found.cost[goal] == pytest.approx(shortest[goal], rel=1e-12)
            assert (path is None) == np.isinf(shortest[goal])
            if path is not None:
                steps = fill_in(path, grid.columns).tolist()
                assert steps[0] == start and steps[-1] == goal
                assert sum(moves[u, v] for u, v in pairwise(steps)) == pytest.approx(shortest[goal])
                assert all(moves[u, v] for u, v in pairwise(steps))


@pytest.mark.parametrize("blocked", [0.1, 0.25, 0.35])
def test_lengths_equal_those_of_all_cells_on_a_larger_grid(blocked):
    """By at most three fifths of the expansions."""
    rng = np.random.default_rng(0)
    grid, cells = random_grid(rng, (150, 220), blocked)
    expanded = np.zeros(2)
    for _ in range(10):
        start, goal = rng.choice(cells, 2).tolist()
        h = octile(grid, goal)
        (path, found), (other, every) = (
            astar(graph, start, goal, h) for graph in (points_of(grid, goal), grid)
        )
        assert (path is None) == (other is None)
        assert found.cost[goal] == pytest.approx(every.cost[goal], rel=1e-12)
        expanded += len(found.expanded), len(every.expanded)
    assert expanded[0] < 0.6 * expanded[1]


def test_a_jump_is_a_straight_or_diagonal_free_way_to_the_first_jump_point():
    """Every edge in every direction, by its definition."""
    rng = np.random.default_rng(1)
    for _ in range(40):
        grid, cells = random_grid(rng, (9, 12), rng.uniform(0, 0.6))
        if not len(cells):
            continue
        goal = int(rng.choice(cells))
        points, free = points_of(grid, goal), grid.moves.free
        for u in cells.tolist():
            for k, (a, b) in enumerate(zip(COLUMN_STEP, ROW_STEP)):
                v, length = edge(points, u, k)
                assert v == (first_jump_point(free, grid.columns, goal, u, a, b) or -1)
                if v >= 0:
                    columns, rows = np.subtract(divmod(v, grid.columns), divmod(u, grid.columns))
                    assert length == pytest.approx(np.hypot(columns, rows), rel=1e-15)


def first_jump_point(free, columns, goal, u, a, b):
    """The first jump point from u in a direction, by Harabor and Grastien's recursion, or None."""
    up = b * columns
    while free[u + a] and free[u + up] and free[u + a + up]:
        u = u + a + up
        if u == goal:
            return u
        if a and b:
            if any(first_jump_point(free, columns, goal, u, *part) for part in ((a, 0), (0, b))):
                return u
        elif any(
            free[u + side] and not free[u + side - a - up]
            for side in ((columns, -columns) if a else (1, -1))
        ):
            return u
    return None


@pytest.mark.parametrize("start_in", ["the open", "a closed room"])
def test_a_sealed_goal_cannot_be_reached(start_in):
    """From inside or outside of the room; and the plan says so."""
    free = np.ones((20, 30), bool)
    free[5:12, 10], free[5:12, 18], free[5, 10:19], free[11, 10:19] = False, False, False, False
    ends = [(2.5, 2.5), (14.5, 8.5)]
    start, goal = ends if start_in == "the open" else ends[::-1]
    plan = ke.plan_on_grid(ke.Problem(ke.Point(), ke.Terrain(free), start, goal))
    assert plan.path is None and plan.cost == np.inf and plan.reason


def test_a_path_has_a_point_in_each_cell_that_it_enters():
    """So it is as long as the moves between neighbouring cells, as on any other grid."""
    free = np.ones((40, 60), bool)
    free[10:30, 30] = False
    plan = ke.plan_on_grid(ke.Problem(ke.Point(), ke.Terrain(free), (3.5, 20.5), (55.5, 20.5)))
    moves = np.abs(np.diff(plan.path, axis=0))
    assert moves.max() == 1.0 and plan.cost == pytest.approx(np.hypot(*moves.T).sum())
    assert len(plan.tree.nodes) < 20
    parents = plan.tree.parent
    assert (parents < np.arange(len(parents))).all() and parents[0] == -1


def test_a_map_that_was_changed_is_seen_at_once():
    """A map's table is kept by its cells, not by its array."""
    free = np.ones((9, 9), bool)
    world = ke.Terrain(free)
    problem = ke.Problem(ke.Point(), world, (0.5, 4.5), (8.5, 4.5))
    assert ke.plan_on_grid(problem).cost == 8.0
    world.free[1:, 4] = False
    assert ke.plan_on_grid(problem).cost > 8.0
    world.free[0, 4] = False
    assert ke.plan_on_grid(problem).path is None


def test_a_second_query_on_a_map_makes_no_table():
    """The table is kept, and no query changes it."""
    world = ke.Terrain(np.random.default_rng(2).random((50, 50)) > 0.2)
    cells = np.argwhere(world.free)[:, ::-1] + 0.5
    jump_table.cache_clear()
    plans = [ke.plan_on_grid(ke.Problem(ke.Point(), world, cells[0], q)) for q in cells[-5:]]
    assert jump_table.cache_info().misses == 1
    again = ke.plan_on_grid(ke.Problem(ke.Point(), world, cells[0], cells[-5]))
    assert np.array_equal(again.path, plans[0].path)


def test_interpreted_and_compiled_searches_expand_the_same_cells():
    """In the same order and at the same costs, bit by bit; so does the iterator of moments."""
    rng = np.random.default_rng(3)
    grid, cells = random_grid(rng, (25, 40), 0.2)
    start, goal = int(cells[0]), int(cells[-1])
    points, h = points_of(grid, goal), octile(grid, goal)
    results = []
    for mode in (INTERPRETED, COMPILED_FIRST):
        with running(mode):
            results.append(astar(points, start, goal, h)[1])
    for one, other in zip(results[0][:3], results[1][:3]):
        assert np.array_equal(one, other)
    moments = list(astar_expansions(points, start, goal, h))
    assert [moment.node for moment in moments] == results[0].expanded.tolist()


def test_a_path_has_each_place_once():
    """Equal neighbours are one place; one that returns to the start's column is another."""
    problem = ke.Problem(ke.Point(), ke.Terrain(np.ones((3, 3))), (0.5, 0.5), (2.5, 2.5))
    nodes = [(0.5, 0.5), (1.5, 1.5), (0.5, 1.5), (0.5, 2.5), (1.5, 2.5), (2.5, 2.5)]
    assert path_through(problem, np.array(nodes)).tolist() == list(map(list, nodes))


@pytest.mark.parametrize("spacing", [0.25, 0.5, 2.0])
def test_a_place_is_joined_to_the_nearest_node(spacing):
    """Where nothing is in the way, that of its own cell."""
    room = ke.PolygonWorld([(3, 1), (13, 1), (13, 11), (3, 11)])
    problem = ke.Problem(ke.Point(), room, (4, 2), (12, 10))
    grid = grid_for(problem, spacing)
    for q in np.random.default_rng(0).uniform((5, 3), (11, 9), (20, 2)):
        joined = centres(grid, np.array([find_joined_node(problem, grid, q)]))[0]
        assert np.abs(joined - q).max() <= spacing / 2 + 1e-9
