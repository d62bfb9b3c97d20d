"""Breadth-first search: visit the nodes in the order of how many edges away they are.

    BFS(G, start, goal)
     1  for each node v: parent(v) := none
     2  insert start into an empty queue Q
     3  while Q is not empty:
     4      v := retrieve the first node of Q
     5      if v = goal: return extract-path
     6      for each node u that an edge leads to from v:
     7          if u was not seen before:
     8              parent(u) := v
     9              insert u at the end of Q
    10  return failure

The book tests for the goal when a node is first seen, in line 7. Here the goal is tested when it
leaves the queue. The path is the same.

Bullo & Smith, chapter 2; LaValle, section 2.2.
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
def breadth_first(
    graph: Any,
    start: int,
    goal: int,
    cost: Array,
    parent: NDArray[np.int64],
    queue: NDArray[np.int64],
) -> Iterator[int]:
    """Yield the nodes as they leave the queue.

    Fills `cost`, `parent` and `queue`, each of shape (n,). A node has been seen when its cost, the
    number of edges from the start, is finite. The array `queue` holds every node that was ever
    inserted, in order. With goal = -1 the search visits every node that it can reach.
    """
    cost[start] = 0.0
    queue[0] = start
    retrieved, inserted = 0, 1
    while retrieved < inserted:
        v = queue[retrieved]
        retrieved += 1
        yield v
        if v == goal:
            return
        for k in range(degree(graph, v)):
            u, _ = edge(graph, v, k)
            if u >= 0 and cost[u] == np.inf:
                cost[u] = cost[v] + 1.0
                parent[u] = v
                queue[inserted] = u
                inserted += 1


@algorithm
def search_breadth_first(
    graph: Any, size: int, start: int, goal: int
) -> tuple[Array, NDArray[np.int64], NDArray[np.int64], int]:
    """Run a whole breadth-first search.

    Returns
    -------
    cost, parent : (n,) arrays.
    expanded : (k,), the nodes in the order in which they left the queue.
    examined : how many edges were examined.
    """
    cost, parent = np.full(size, np.inf), np.full(size, -1, np.int64)
    queue, retrieved, examined = np.empty(size, np.int64), 0, 0
    for v in breadth_first(graph, start, goal, cost, parent, queue):
        retrieved += 1
        if v != goal:
            examined += degree(graph, v)
    return cost, parent, queue[:retrieved].copy(), examined


def bfs(graph: Searchable, start: int, goal: int | None = None) -> Search:
    """Breadth-first search from `start`, to `goal` or over all reachable nodes. O(n + m).

    Weights are ignored: cost[u] is the least number of edges from the start to u.

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
    >>> found = bfs(Graph(5, [(0, 1), (0, 2), (1, 3), (2, 3)]), 0)
    >>> found.cost, found.steps
    (array([ 0.,  1.,  1.,  2., inf]), Steps(nodes=4, edges=8))
    """
    flat, first, last = check_ends(graph, start, goal)
    cost, parent, expanded, examined = search_breadth_first(flat, flat.size, first, last)
    return Search(cost, parent, expanded, Steps(len(expanded), int(examined)))


def bfs_tree(graph: Searchable, start: int) -> NDArray[np.int64]:
    """The parent of each node in the breadth-first tree. O(n + m).

    Among equally short paths the tree takes the one that was seen first.

    Returns
    -------
    (n,) array: the node from which each node was first seen; -1 for the start and for nodes that
    cannot be reached. The two differ in `bfs(graph, start).cost`, which is infinite for the latter.

    Raises
    ------
    InvalidGraph
        Where `start` is not a node of the graph.

    Examples
    --------
    >>> from kinoedu.graphs import Graph
    >>> bfs_tree(Graph(5, [(0, 1), (0, 2), (1, 3), (2, 3)]), 0)
    array([-1,  0,  0,  1, -1])
    """
    return bfs(graph, start).parent


def bfs_path(graph: Searchable, start: int, goal: int) -> NDArray[np.int64] | None:
    """A path with the fewest edges between two nodes. O(n + m).

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
    >>> graph = Graph(5, [(0, 1), (0, 2), (1, 3), (2, 3)])
    >>> bfs_path(graph, 0, 3), bfs_path(graph, 0, 4)
    (array([0, 1, 3]), None)
    """
    _, first, last = check_ends(graph, start, goal)
    return path_or_none(bfs(graph, first, last), last)


def bfs_expansions(graph: Searchable, start: int, goal: int | None = None) -> Iterator[Expansion]:
    """Breadth-first search as an iterator over its expansions, with the queue at each of them.

    Each expansion costs O(n) more than in `bfs`, because it copies the arrays.

    Raises
    ------
    InvalidGraph
        Where `start` or `goal` is not a node of the graph.

    Examples
    --------
    >>> from kinoedu.graphs import Graph
    >>> for moment in bfs_expansions(Graph(4, [(0, 1), (0, 2), (1, 3)]), 0):
    ...     moment.node, moment.frontier
    (0, array([], dtype=int64))
    (1, array([2]))
    (2, array([3]))
    (3, array([], dtype=int64))
    """
    flat, first, last = check_ends(graph, start, goal)
    cost, parent = np.full(flat.size, np.inf), np.full(flat.size, -1)
    queue = np.empty(flat.size, np.int64)
    steps = breadth_first.py_func(flat, first, last, cost, parent, queue)
    return yield_moments(
        steps, cost, parent, lambda v, before: queue[before + 1 : np.isfinite(cost).sum()]
    )
