"""A* on random bitmaps of 1,000 x 1,000 cells, from the bitmap to the path between opposite
corners; and a hundred queries on one map of a town.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from timing import Contestant, Goal, available, measure, report, run
from worlds import bitmap

import kinoedu as ke
from kinoedu.files.movingai import Query, read_scenario
from kinoedu.planners.grids.jump_points import jump_table

SECONDS = 50
GOALS = {"scipy": Goal(at_least=4), "pathplanning": Goal(at_least=4)}
MOVES = ((0, 1), (1, 0), (1, 1), (1, -1))  # rows, columns; the other four go back
SQRT2 = 2.0**0.5


class Case(NamedTuple):
    """A bitmap, true where free."""

    free: np.ndarray


def kinoedu() -> Contestant:
    """The terrain, the problem and the plan, without what it keeps of a map for the next query."""

    def contestant(case: Case) -> Callable[[], Any]:
        rows, columns = case.free.shape
        ends = (0.5, 0.5), (columns - 0.5, rows - 0.5)

        def run() -> Any:
            jump_table.cache_clear()
            return ke.plan_on_grid(ke.Problem(ke.Point(), ke.Terrain(case.free), *ends))

        return run

    return contestant


def scipy() -> Contestant:
    """Its sparse graph of the same moves, and its Dijkstra: it has no A*."""
    from scipy.sparse.csgraph import dijkstra

    def contestant(case: Case) -> Callable[[], Any]:
        def run() -> Any:
            distances, above = dijkstra(graph_of(case.free), indices=0, return_predecessors=True)
            path = [case.free.size - 1]
            while above[path[-1]] >= 0:
                path.append(above[path[-1]])
            return distances[-1], np.array(path[::-1])

        return run

    return contestant


def graph_of(free: np.ndarray) -> Any:
    """The moves between free cells, diagonally only past two free ones, as a sparse matrix."""
    from scipy.sparse import coo_array

    number = np.arange(free.size, dtype=np.int32).reshape(free.shape)
    froms, tos, weights = [], [], []
    for rows, columns in MOVES:
        here, there = shifted(rows, columns)
        allowed = free[here] & free[there]
        if rows and columns:
            allowed &= free[here[0], there[1]] & free[there[0], here[1]]
        a, b = number[here][allowed], number[there][allowed]
        froms += [a, b]
        tos += [b, a]
        weights.append(np.full(2 * len(a), SQRT2 if rows and columns else 1.0))
    ends = np.concatenate(froms), np.concatenate(tos)
    return coo_array((np.concatenate(weights), ends), shape=(free.size, free.size)).tocsr()


def shifted(rows: int, columns: int) -> tuple[tuple[slice, slice], tuple[slice, slice]]:
    """The cells that a move can leave from, and where it leads from each."""
    left = (slice(None, -1), slice(1, None)) if columns == 1 else (slice(1, None), slice(None, -1))
    across = left if columns else (slice(None), slice(None))
    up = (slice(None, -1), slice(1, None)) if rows else (slice(None), slice(None))
    return (up[0], across[0]), (up[1], across[1])


def pathplanning() -> Contestant:
    """Its own grid and A*, native from the bitmap on. It also moves diagonally between blocked
    cells: its path may be shorter.
    """
    from pathplanning.core.contracts import DiscreteProblem
    from pathplanning.planners.search.astar import plan_astar
    from pathplanning.spaces import Grid2DSearchSpace

    def contestant(case: Case) -> Callable[[], Any]:
        rows, columns = case.free.shape

        def run() -> Any:
            grid = Grid2DSearchSpace(columns, rows, occupancy=~case.free)
            return plan_astar(DiscreteProblem(grid, (0, 0), (columns - 1, rows - 1)))

        return run

    return contestant


def judge(case: Case, answers: dict[str, Any]) -> None:
    """kinoedu's path costs what scipy's does; pathplanning's keeps to free cells and costs no
    more.
    """
    cost = answers["kinoedu"].cost
    if "scipy" in answers:
        distance, path = answers["scipy"]
        assert np.isclose(cost, distance, rtol=1e-12) and path[0] == 0
    if "pathplanning" in answers:
        cells = answers["pathplanning"].path.astype(int)
        steps = np.abs(np.diff(cells, axis=0))
        assert case.free[cells[:, 1], cells[:, 0]].all() and steps.max() == 1
        assert np.sqrt((steps**2).sum(axis=1)).sum() <= cost * (1 + 1e-12)


class Town(NamedTuple):
    """A map, true where free, and queries between centres of cells."""

    free: np.ndarray
    queries: list[Query]


def town() -> Town:
    """A hundred queries on a piece of Paris, 256 x 256 cells."""
    maps = Path(__file__).resolve().parent.parent / "notebooks" / "maps"
    queries = read_scenario(maps / "Paris_1_256-even-1.scen")
    free = ke.read_world(maps / "Paris_1_256.map").free
    return Town(free, queries[:: len(queries) // 100][:100])


def kinoedu_in_town() -> Contestant:
    """One terrain, a problem and a plan for each query."""

    def contestant(case: Town) -> Callable[[], Any]:
        def run() -> Any:
            world = ke.Terrain(case.free)
            return [
                ke.plan_on_grid(ke.Problem(ke.Point(), world, query.start, query.goal)).cost
                for query in case.queries
            ]

        return run

    return contestant


def pathplanning_in_town() -> Contestant:
    """One grid, and its A* for each query."""
    from pathplanning.core.contracts import DiscreteProblem
    from pathplanning.planners.search.astar import plan_astar
    from pathplanning.spaces import Grid2DSearchSpace

    def contestant(case: Town) -> Callable[[], Any]:
        rows, columns = case.free.shape
        ends = [
            [tuple(np.floor(q).astype(int).tolist()) for q in (query.start, query.goal)]
            for query in case.queries
        ]

        def run() -> Any:
            grid = Grid2DSearchSpace(columns, rows, occupancy=~case.free)
            return [plan_astar(DiscreteProblem(grid, *pair)).path for pair in ends]

        return run

    return contestant


def judge_town(case: Town, answers: dict[str, Any]) -> None:
    """kinoedu's lengths are those of the scenario; pathplanning's paths are no longer."""
    lengths = [query.length for query in case.queries]
    assert np.allclose(answers["kinoedu"], lengths, rtol=0.0, atol=1e-6)
    for path, length in zip(answers.get("pathplanning", []), lengths):
        assert np.linalg.norm(np.diff(path, axis=0), axis=1).sum() <= length + 1e-6


def main(repeats: int = 3) -> None:
    """Three densities, two bitmaps of each."""
    for blocked in (0.1, 0.25, 0.35):
        contestants = available({"kinoedu": kinoedu, "scipy": scipy, "pathplanning": pathplanning})
        seconds = measure(
            contestants, [Case(bitmap(seed, blocked)) for seed in range(2)], judge, repeats=repeats
        )
        report(f"A* on 1,000 x 1,000 cells, {blocked:.0%} blocked", seconds, GOALS)
    contestants = available({"kinoedu": kinoedu_in_town, "pathplanning": pathplanning_in_town})
    seconds = measure(contestants, [town()], judge_town, repeats=repeats)
    report("100 queries on a town of 256 x 256 cells", seconds, {})


if __name__ == "__main__":
    run(main)
