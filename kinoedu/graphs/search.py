"""Dijkstra's algorithm and A*: one search, told apart by its estimate of what remains.

E. W. Dijkstra (1959); P. E. Hart, N. J. Nilsson, B. Raphael, "A formal basis for the heuristic determination of minimum cost
paths" (1968); Bullo & Smith, section 2.4; LaValle, section 2.2.
"""

from collections.abc import Iterator
from heapq import heappop, heappush
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import body, compiled
from ..errors import InvalidGraph
from ..geometry.checks import Array
from .graph import degree, edge

ROUNDING = 1e-12  # of a cost


class Search(NamedTuple):
    """The result of a search: cost (n,) from the start, final for expanded nodes, else the least found so far, or infinite;
    parent (n,), -1 for the start and for nodes not reached; expanded (k,), the nodes in the order in which they were settled, some
    again where an estimate is not consistent.
    """

    cost: Array
    parent: NDArray[np.int64]
    expanded: NDArray[np.int64]


@compiled
def expansions(graph: Any, start: int, goal: int, estimate: Array, cost: Array, parent: NDArray[np.int64]) -> Iterator[int]:
    """Yield the nodes in the order in which they are expanded: least cost so far plus estimate first. Fills cost and parent.

    An estimate that never exceeds the true remaining cost makes the first path found a shortest one; where it is not consistent, a
    node is expanded again whenever that gains more than rounding.
    """
    settled = np.zeros(len(cost), np.bool_)
    cost[start] = 0.0
    frontier = [(estimate[start], estimate[start], start)]
    while len(frontier) > 0:
        _, _, u = heappop(frontier)
        if settled[u]:
            continue
        settled[u] = True
        yield u
        if u == goal:
            return
        for k in range(degree(graph, u)):
            v, weight = edge(graph, u, k)
            if v < 0 or cost[u] + weight >= cost[v] * (1.0 - ROUNDING if settled[v] else 1.0):
                continue
            cost[v] = cost[u] + weight
            parent[v] = u
            settled[v] = False
            heappush(frontier, (cost[v] + estimate[v], estimate[v], v))


@body
def search(graph: Any, start: int, goal: int, estimate: Array) -> tuple[Array, NDArray[np.int64], NDArray[np.int64]]:
    """Run the expansions to their end; goal = -1 expands all that can be reached."""
    cost, parent = np.full(len(estimate), np.inf), np.full(len(estimate), -1, np.int64)
    expanded, n = np.empty(len(estimate), np.int64), 0
    for u in expansions(graph, start, goal, estimate, cost, parent):
        if n == len(expanded):
            expanded = np.append(expanded, expanded)
        expanded[n] = u
        n += 1
    return cost, parent, expanded[:n]


def dijkstra(graph: Any, start: int) -> Search:
    """Shortest paths from one node to all: their costs, and each node's parent on its path. O(m log n).

    Raises InvalidGraph where `start` is not a node.

    >>> from kinoedu.graphs import Graph
    >>> dijkstra(Graph(4, [(0, 1), (1, 2), (0, 2)], [1.0, 1.0, 5.0]), 0).cost
    array([ 0.,  1.,  2., inf])
    """
    check_node(graph, start, "start")
    return Search(*search(graph, int(start), -1, np.zeros(graph.size)))


def astar(graph: Any, start: int, goal: int, estimate: ArrayLike | None = None) -> tuple[NDArray[np.int64] | None, Search]:
    """A shortest path between two nodes, as node numbers (k,), or None where there is none; and the search that found it.

    estimate : (n,) lower bounds on the cost from each node to the goal; without them this is Dijkstra's algorithm stopped at the
        goal. Raises InvalidGraph.

    >>> from kinoedu.graphs import Graph
    >>> path, found = astar(Graph(4, [(0, 1), (1, 2), (0, 2)], [1.0, 1.0, 5.0]), 0, 2)
    >>> path, found.cost[2]
    (array([0, 1, 2]), np.float64(2.0))
    """
    check_node(graph, start, "start")
    check_node(graph, goal, "goal")
    bounds = np.zeros(graph.size) if estimate is None else np.asarray(estimate, np.float64)
    if bounds.shape != (graph.size,) or not (bounds >= 0.0).all():
        raise InvalidGraph(f"the estimate must be {graph.size} numbers, zero or more, one for each node")
    found = Search(*search(graph, int(start), int(goal), bounds))
    return (extract_path(found.parent, int(goal)) if np.isfinite(found.cost[goal]) else None), found


def check_node(graph: Any, u: int, name: str) -> None:
    """Raise InvalidGraph unless u is one of the graph's nodes."""
    if isinstance(u, bool) or not isinstance(u, int | np.integer) or not 0 <= u < graph.size:
        raise InvalidGraph(f"{name} must be a node from 0 to {graph.size - 1}, got {u!r}")


def extract_path(parent: ArrayLike, goal: int) -> NDArray[np.int64]:
    """The nodes from the root to `goal` by following parents (n,), where the root's is -1; shape (k,). Bullo & Smith, 2.3.

    Raises InvalidGraph where the parents lead round in a circle or out of the graph.

    >>> extract_path([-1, 0, 1, 1], 3)
    array([0, 1, 3])
    """
    parents = np.asarray(parent)
    path = [goal]
    while 0 <= (above := int(parents[path[-1]])) < len(parents) and len(path) <= len(parents):
        path.append(above)
    if above != -1:
        raise InvalidGraph("these parents lead to no root")
    return np.array(path[::-1], np.int64)
