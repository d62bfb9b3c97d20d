"""Depth-first search: go on from the newest node while that finds new nodes, then go back.

    DFS(v)
    1  mark v as seen
    2  for each node u that an edge leads to from v, in increasing order:
    3      if u was not seen before:
    4          parent(u) := v
    5          DFS(u)

The pending calls form a stack. Here the stack is an array, so a path of a million nodes needs no
million nested calls; the order is that of the recursion. The path that is found is in general not
a shortest one.

LaValle, section 2.2; R. Tarjan, "Depth-first search and linear graph algorithms" (1972).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled
from ..geometry.checks import Array
from .flat import Searchable, degree, edge
from .paths import Expansion, Search, Steps, check_ends, path_or_none, yield_moments


@compiled
def depth_first(
    graph: Any,
    start: int,
    goal: int,
    cost: Array,
    parent: NDArray[np.int64],
    stack: NDArray[np.int64],
    examined: NDArray[np.int64],
) -> Iterator[int]:
    """Yield the nodes as they are entered.

    Fills `cost`, `parent`, `stack`, and `examined`, which must be zero at first; shapes (n,). A
    node has been seen when its cost, the number of edges on its path, is finite. The stack is the
    path from the start to the current node v; examined[v] of the edges of v have been examined.
    With goal = -1 the search enters every node that it can reach.
    """
    cost[start] = 0.0
    stack[0] = start
    height = 1
    while height > 0:
        v = stack[height - 1]
        if examined[v] == 0:
            yield v
            if v == goal:
                return
        if examined[v] == degree(graph, v):
            height -= 1
            continue
        u, _ = edge(graph, v, examined[v])
        examined[v] += 1
        if u >= 0 and cost[u] == np.inf:
            cost[u] = cost[v] + 1.0
            parent[u] = v
            stack[height] = u
            height += 1


@algorithm
def search_depth_first(
    graph: Any, size: int, start: int, goal: int
) -> tuple[Array, NDArray[np.int64], NDArray[np.int64], int]:
    """Run a whole depth-first search.

    Returns
    -------
    cost, parent : (n,) arrays.
    expanded : (k,), the nodes in the order in which they were entered.
    examined : how many edges were examined.
    """
    cost, parent = np.full(size, np.inf), np.full(size, -1, np.int64)
    stack, examined = np.empty(size, np.int64), np.zeros(size, np.int64)
    expanded, entered, total = np.empty(size, np.int64), 0, 0
    for v in depth_first(graph, start, goal, cost, parent, stack, examined):
        expanded[entered] = v
        entered += 1
    for v in expanded[:entered]:
        total += examined[v]
    return cost, parent, expanded[:entered].copy(), total


def dfs(graph: Searchable, start: int, goal: int | None = None) -> Search:
    """Depth-first search from `start`, to `goal` or over all reachable nodes. O(n + m).

    cost[u] is the number of edges on the path that was found, in general not the least number.

    Returns
    -------
    Search, with the order of expansion and the number of steps.

    Raises
    ------
    InvalidGraph
        Where `start` or `goal` is not a node of the graph.

    Examples
    --------
    >>> from kinoedu.graphs import Graph
    >>> found = dfs(Graph(4, [(0, 1), (1, 2), (2, 3), (3, 0)]), 0)
    >>> found.expanded, found.cost, found.steps
    (array([0, 1, 2, 3]), array([0., 1., 2., 3.]), Steps(nodes=4, edges=8))
    """
    flat, first, last = check_ends(graph, start, goal)
    cost, parent, expanded, examined = search_depth_first(flat, flat.size, first, last)
    return Search(cost, parent, expanded, Steps(len(expanded), int(examined)))


def dfs_path(graph: Searchable, start: int, goal: int) -> NDArray[np.int64] | None:
    """A path between two nodes, in general not a shortest one. O(n + m).

    In the example the path goes all the way round, although an edge leads from 0 to 3.

    Returns
    -------
    (k,) array of node numbers, or None where there is no path.

    Raises
    ------
    InvalidGraph
        Where `start` or `goal` is not a node of the graph.

    Examples
    --------
    >>> from kinoedu.graphs import Graph
    >>> dfs_path(Graph(4, [(0, 1), (1, 2), (2, 3), (3, 0)]), 0, 3)
    array([0, 1, 2, 3])
    """
    _, first, last = check_ends(graph, start, goal)
    return path_or_none(dfs(graph, first, last), last)


def dfs_expansions(graph: Searchable, start: int, goal: int | None = None) -> Iterator[Expansion]:
    """Depth-first search as an iterator over its expansions, with the stack at each of them.

    The frontier is the stack below the current node, its parent first: nodes that were entered
    before and to whose other edges the search returns. Each expansion costs O(n) more than in
    `dfs`.

    Raises
    ------
    InvalidGraph
        Where `start` or `goal` is not a node of the graph.

    Examples
    --------
    >>> from kinoedu.graphs import Graph
    >>> for moment in dfs_expansions(Graph(4, [(0, 1), (0, 2), (1, 3)]), 0):
    ...     moment.node, moment.frontier
    (0, array([], dtype=int64))
    (1, array([0]))
    (3, array([1, 0]))
    (2, array([0]))
    """
    flat, first, last = check_ends(graph, start, goal)
    cost, parent = np.full(flat.size, np.inf), np.full(flat.size, -1)
    stack, examined = np.empty(flat.size, np.int64), np.zeros(flat.size, np.int64)
    steps = depth_first.py_func(flat, first, last, cost, parent, stack, examined)
    return yield_moments(steps, cost, parent, lambda v, before: stack[: int(cost[v])][::-1])
