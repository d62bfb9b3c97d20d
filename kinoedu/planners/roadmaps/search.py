"""Search any roadmap with any graph search."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ...errors import InvalidParameter
from ...graphs import Graph, astar
from ...problems import Plan
from ...problems.protocols import ProblemLike, RoadmapLike
from ...support.text import shortened
from ..answers import plan_along
from ..problem_input import as_problem, count_checks
from .multi_query import motion_costs
from .prm import explain_no_path

GraphSearch = Callable[[Graph, int, int], NDArray[np.int64] | None]


def dijkstra_path(graph: Graph, start: int, goal: int) -> NDArray[np.int64] | None:
    """A path of least total weight, as node numbers (k,), or None, by Dijkstra's algorithm.

    Examples
    --------
    >>> dijkstra_path(Graph(3, [(0, 1), (0, 2), (2, 1)], [5, 1, 1]), 0, 1)
    array([0, 2, 1])
    """
    return astar(graph, start, goal)[0]


def plan_on_roadmap(
    problem: ProblemLike, roadmap: RoadmapLike, search: GraphSearch = dijkstra_path
) -> Plan:
    """The path that a graph search finds in a roadmap whose nodes 0 and 1 are start and goal.

    No motion is checked again: a path of free motions is free, whichever search found it. O(n + m)
    besides the search.

    Parameters
    ----------
    problem : the problem for which the roadmap was built.
    roadmap : a record with nodes (n, d) and edges (m, 2), all of whose motions are free, such as
        the roadmap of a `prm` plan.
    search : a function of a graph, whose weights are the costs of its motions, and of the numbers
        of start and goal; it returns the nodes of a path or None. For example `bfs_path`,
        `dfs_path` or `dijkstra_path`.

    Returns
    -------
    Plan with this `roadmap`. Without a path `plan.reason` says why there is none.

    Raises
    ------
    InvalidParameter
        Where `roadmap` has no nodes and edges, or nodes 0 and 1 are not the problem's start and
        goal.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, bfs_path, prm
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 9), (0, 9)])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(8, 8))
    >>> roadmap = prm(problem, n=50, k=5, rng=0).roadmap
    >>> fewest = plan_on_roadmap(problem, roadmap, bfs_path)
    >>> shortest = plan_on_roadmap(problem, roadmap)
    >>> len(fewest.path) <= len(shortest.path), shortest.cost <= fewest.cost
    (True, True)
    """
    problem = as_problem(problem)
    if not (hasattr(roadmap, "nodes") and hasattr(roadmap, "edges")):
        raise InvalidParameter(
            f"expected a roadmap with nodes and edges, such as prm's, got {shortened(roadmap)}"
        )
    if not np.array_equal(roadmap.nodes[:2], [problem.start, problem.goal]):
        raise InvalidParameter(
            "nodes 0 and 1 of the roadmap must be the problem's start and goal; `query` joins them "
            "to a roadmap without them"
        )
    before = count_checks(problem)
    costs = motion_costs(problem, roadmap.nodes, roadmap.edges)
    graph = Graph(len(roadmap.nodes), roadmap.edges, costs)
    numbers = search(graph, 0, 1)
    stats = {
        "nodes": len(roadmap.nodes),
        "edges": len(roadmap.edges),
        "checks": count_checks(problem) - before,
    }
    name = getattr(search, "__name__", "search").replace("_", " ")
    return plan_along(
        problem,
        roadmap.nodes,
        numbers,
        explain_no_path(graph.flat()),
        planner=name,
        roadmap=roadmap,
        stats=stats,
    )
