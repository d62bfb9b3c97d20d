"""Compile ahead what the course uses, so that no lesson waits for it."""

from typing import Any

from .compiled import CACHE
from .graphs import Graph, bfs, dfs, dijkstra
from .planners import bug2, plan_by_decomposition, plan_on_grid, prm, rrt
from .problems import Problem
from .progress import stage
from .robots import Point
from .worlds import PolygonWorld, Terrain


def warm_up() -> None:
    """Run every planner once in every kind of world, and the searches on a graph.

    What is compiled already is left; without a cache nothing is gained.
    """
    if CACHE is None or (CACHE / "warm").exists():
        return
    worlds = {
        "polygons": PolygonWorld([(0, 0), (9, 0), (9, 9), (5, 8), (0, 9)], [[(4, 0), (5, 0), (5, 5)], ((7, 5), 1.0)]),
        "terrain": Terrain([[1] * 9] * 9),
    }
    jobs: list[tuple[Any, str]] = [(planner, kind) for kind in worlds for planner in (rrt, prm, plan_on_grid)]
    worlds["straight polygons"] = PolygonWorld([(0, 0), (9, 0), (9, 9), (0, 9)], [[(4, 0), (5, 0), (5, 5)]])
    jobs.append((plan_by_decomposition, "straight polygons"))
    for number, (planner, kind) in enumerate(jobs, start=1):
        with stage(f"compiling once, {number} of {len(jobs)}: {planner.__name__} on {kind}"):
            problem = Problem(Point(), worlds[kind], (1, 1), (8, 8))
            planner(problem, **({"rng": 0} if planner in (rrt, prm) else {}))
    with stage("compiling once: bugs"):
        bug2((1, 1), (8, 8), [[(4, 2), (5, 2), (5, 6)], [(1, 8), (2, 8), (2, 9)]], 1.0)
    with stage("compiling once: searches on graphs"):
        graph = Graph(nodes=[(0, 0), (1, 0)], edges=[(0, 1)])
        for search in (bfs, dfs, dijkstra):
            search(graph, 0)
        graph.components()
        graph.closest((1, 1))
    (CACHE / "warm").touch()
