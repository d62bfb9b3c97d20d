"""Any graph search on any roadmap: what a search finds depends on the search, not on who built the
roadmap.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...graphs import Graph, astar
from ...problems import MOTIONS, Plan
from ..answers import plan_along
from ..problem_input import askable
from .multi_query import costs_of
from .prm import why_apart

Search = Callable[[Graph, int, int], NDArray[np.int64] | None]


def dijkstra_path(graph: Graph, start: int, goal: int) -> NDArray[np.int64] | None:
    """A path of the least weight in all, as node numbers (k,), or None: A* without an estimate,
    which is Dijkstra's algorithm.

    >>> dijkstra_path(Graph(3, [(0, 1), (0, 2), (2, 1)], [5, 1, 1]), 0, 1)
    array([0, 2, 1])
    """
    return astar(graph, start, goal)[0]


def plan_on_roadmap(problem: Any, roadmap: Any, search: Search = dijkstra_path) -> Plan:
    """The path that a graph search finds in a roadmap whose nodes 0 and 1 are start and goal, such
    as the roadmap of a `prm` plan.

    Parameters
    ----------
    problem : whose roadmap it is. roadmap : nodes (n, d) and edges (m, 2), all of whose motions are
    free.
    search : a function of a graph, weighted by the problem's distances, and the numbers of start
    and goal, that gives the nodes of
        a path, or None: `bfs_path`, `dfs_path`, or `dijkstra_path`.

    Nothing is judged again: a path of free motions is free, whichever search found it. O(n + m)
    besides the search.

    >>> from kinoedu import Point, PolygonWorld, Problem, bfs_path, prm
    >>> problem = Problem(Point(), PolygonWorld([(0, 0), (9, 0), (9, 9), (0, 9)]), start=(1, 1), goal=(8, 8))
    >>> roadmap = prm(problem, n=50, k=5, rng=0).roadmap
    >>> fewest, shortest = plan_on_roadmap(problem, roadmap, bfs_path), plan_on_roadmap(problem, roadmap)
    >>> len(fewest.path) <= len(shortest.path), shortest.cost <= fewest.cost
    (True, True)
    """
    asked = askable(problem)
    before = asked.asked[MOTIONS]
    graph = Graph(len(roadmap.nodes), roadmap.edges, costs_of(asked, roadmap.nodes, roadmap.edges))
    numbers = search(graph, 0, 1)
    stats = {
        "nodes": len(roadmap.nodes),
        "edges": len(roadmap.edges),
        "checks": int(asked.asked[MOTIONS] - before),
    }
    name = getattr(search, "__name__", "search").replace("_", " ")
    return plan_along(
        asked,
        roadmap.nodes,
        numbers,
        why_apart(graph.flat()),
        planner=name,
        roadmap=roadmap,
        stats=stats,
    )
