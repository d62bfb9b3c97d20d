"""Depth-first search: on from the newest node as long as that leads to new ones, then back.
LaValle, 2.2.

    DFS(v)
    1  mark v as seen
    2  for each node u that an edge leads to from v, in increasing order:
    3      if u was not seen before:
    4          parent(u) := v
    5          DFS(u)

The calls that wait are a stack. Here it is held in an array, so that a path of a million nodes
needs no million calls: the order is that of the recursion. The path it finds is a path, and that is
all: it is in general not a shortest one.

R. Tarjan, "Depth-first search and linear graph algorithms" (1972).
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled
from ..geometry.checks import Array
from .flat import degree, edge
from .paths import Expansion, Search, Steps, ends, moments, path_found


@compiled
def depth_first(
    graph: Any,
    start: int,
    goal: int,
    cost: Array,
    parent: NDArray[np.int64],
    stack: NDArray[np.int64],
    looked_at: NDArray[np.int64],
) -> Iterator[int]:
    """Yield the nodes as they are entered; goal = -1 enters all. Fills cost, parent, stack, and
    looked_at, which starts at zero; shapes (n,).

    A node was seen when its cost, the number of edges of its path, is finite. The stack is the path
    from the start to the node that is being looked at; looked_at[v] of its edges have been tried.
    """
    cost[start] = 0.0
    stack[0] = start
    height = 1
    while height > 0:
        v = stack[height - 1]
        if looked_at[v] == 0:
            yield v
            if v == goal:
                return
        if looked_at[v] == degree(graph, v):
            height -= 1
            continue
        u, _ = edge(graph, v, looked_at[v])
        looked_at[v] += 1
        if u >= 0 and cost[u] == np.inf:
            cost[u] = cost[v] + 1.0
            parent[u] = v
            stack[height] = u
            height += 1


@algorithm
def search_depth_first(
    graph: Any, size: int, start: int, goal: int
) -> tuple[Array, NDArray[np.int64], NDArray[np.int64], int]:
    """Run it to its end: cost, parent, the nodes in the order they were entered, and how many edges
    were looked at.
    """
    cost, parent = np.full(size, np.inf), np.full(size, -1, np.int64)
    stack, looked_at = np.empty(size, np.int64), np.zeros(size, np.int64)
    expanded, entered, total = np.empty(size, np.int64), 0, 0
    for v in depth_first(graph, start, goal, cost, parent, stack, looked_at):
        expanded[entered] = v
        entered += 1
    for v in expanded[:entered]:
        total += looked_at[v]
    return cost, parent, expanded[:entered].copy(), total


def dfs(graph: Any, start: int, goal: int | None = None) -> Search:
    """Depth-first search from `start`, of all it can reach or until `goal`, with its order and its
    count of steps. O(n + m).

    cost[u] is the number of edges on the path found, in general not the least. Raises InvalidGraph
    where a node is not there.

    >>> from kinoedu.graphs import Graph
    >>> found = dfs(Graph(4, [(0, 1), (1, 2), (2, 3), (3, 0)]), 0)
    >>> found.expanded, found.cost, found.steps
    (array([0, 1, 2, 3]), array([0., 1., 2., 3.]), Steps(nodes=4, edges=8))
    """
    flat, first, last = ends(graph, start, goal)
    cost, parent, expanded, looked_at = search_depth_first(flat, flat.size, first, last)
    return Search(cost, parent, expanded, Steps(len(expanded), int(looked_at)))


def dfs_path(graph: Any, start: int, goal: int) -> NDArray[np.int64] | None:
    """Some path between two nodes, as node numbers (k,), or None where there is none. O(n + m).
    InvalidGraph.

    Not a shortest one: here it goes round, though an edge leads from 0 to 3.

    >>> from kinoedu.graphs import Graph
    >>> dfs_path(Graph(4, [(0, 1), (1, 2), (2, 3), (3, 0)]), 0, 3)
    array([0, 1, 2, 3])
    """
    _, first, last = ends(graph, start, goal)
    return path_found(dfs(graph, first, last), last)


def dfs_expansions(graph: Any, start: int, goal: int | None = None) -> Iterator[Expansion]:
    """The same search one expansion after another; O(n) more for each. InvalidGraph.

    The frontier is the stack below the node, its parent first: nodes entered before, to whose other
    edges the search comes back.

    >>> from kinoedu.graphs import Graph
    >>> for moment in dfs_expansions(Graph(4, [(0, 1), (0, 2), (1, 3)]), 0):
    ...     moment.node, moment.frontier
    (0, array([], dtype=int64))
    (1, array([0]))
    (3, array([1, 0]))
    (2, array([0]))
    """
    flat, first, last = ends(graph, start, goal)
    cost, parent = np.full(flat.size, np.inf), np.full(flat.size, -1)
    stack, looked_at = np.empty(flat.size, np.int64), np.zeros(flat.size, np.int64)
    steps = depth_first.py_func(flat, first, last, cost, parent, stack, looked_at)
    return moments(steps, cost, parent, lambda v, before: stack[: int(cost[v])][::-1])
