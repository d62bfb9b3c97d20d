"""Breadth-first search: the nodes in the order of how many edges away they are. Bullo & Smith,
chapter 2; LaValle, 2.2.

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

The book looks for the goal when it is first seen, in line 7; here it may wait in the queue. The
path is the same.
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
def breadth_first(
    graph: Any,
    start: int,
    goal: int,
    cost: Array,
    parent: NDArray[np.int64],
    queue: NDArray[np.int64],
) -> Iterator[int]:
    """Yield the nodes as they leave the queue; goal = -1 takes out all. Fills cost, parent and
    queue, shapes (n,).

    A node was seen when its cost, the number of edges from the start, is finite. The queue is what
    was ever inserted, in order.
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
    """Run it to its end: cost, parent, the nodes in the order they left the queue, and how many
    edges were looked at.
    """
    cost, parent = np.full(size, np.inf), np.full(size, -1, np.int64)
    queue, retrieved, looked_at = np.empty(size, np.int64), 0, 0
    for v in breadth_first(graph, start, goal, cost, parent, queue):
        retrieved += 1
        if v != goal:
            looked_at += degree(graph, v)
    return cost, parent, queue[:retrieved].copy(), looked_at


def bfs(graph: Any, start: int, goal: int | None = None) -> Search:
    """Breadth-first search from `start`, of all it can reach or until `goal`, with its order and
    its count of steps. O(n + m).

    Weights are not looked at: cost[u] is the least number of edges from the start. Raises
    InvalidGraph where a node is not there.

    >>> from kinoedu.graphs import Graph
    >>> found = bfs(Graph(5, [(0, 1), (0, 2), (1, 3), (2, 3)]), 0)
    >>> found.cost, found.steps
    (array([ 0.,  1.,  1.,  2., inf]), Steps(nodes=4, edges=8))
    """
    flat, first, last = ends(graph, start, goal)
    cost, parent, expanded, looked_at = search_breadth_first(flat, flat.size, first, last)
    return Search(cost, parent, expanded, Steps(len(expanded), int(looked_at)))


def bfs_tree(graph: Any, start: int) -> NDArray[np.int64]:
    """The parent of each node in the breadth-first tree, shape (n,): the node from which it was
    first seen. O(n + m).

    It is -1 for the start and for nodes that cannot be reached; only for the latter is `bfs(graph,
    start).cost` infinite. Among equally short ways the tree takes the one seen first. Raises
    InvalidGraph.

    >>> from kinoedu.graphs import Graph
    >>> bfs_tree(Graph(5, [(0, 1), (0, 2), (1, 3), (2, 3)]), 0)
    array([-1,  0,  0,  1, -1])
    """
    return bfs(graph, start).parent


def bfs_path(graph: Any, start: int, goal: int) -> NDArray[np.int64] | None:
    """A path of the fewest edges between two nodes, as node numbers (k,), or None where there is
    none. O(n + m). InvalidGraph.

    >>> from kinoedu.graphs import Graph
    >>> graph = Graph(5, [(0, 1), (0, 2), (1, 3), (2, 3)])
    >>> bfs_path(graph, 0, 3), bfs_path(graph, 0, 4)
    (array([0, 1, 3]), None)
    """
    _, first, last = ends(graph, start, goal)
    return path_found(bfs(graph, first, last), last)


def bfs_expansions(graph: Any, start: int, goal: int | None = None) -> Iterator[Expansion]:
    """The same search one expansion after another, each with the queue as it was then. O(n) more
    for each. InvalidGraph.

    >>> from kinoedu.graphs import Graph
    >>> for moment in bfs_expansions(Graph(4, [(0, 1), (0, 2), (1, 3)]), 0):
    ...     moment.node, moment.frontier
    (0, array([], dtype=int64))
    (1, array([2]))
    (2, array([3]))
    (3, array([], dtype=int64))
    """
    flat, first, last = ends(graph, start, goal)
    cost, parent, queue = (
        np.full(flat.size, np.inf),
        np.full(flat.size, -1),
        np.empty(flat.size, np.int64),
    )
    steps = breadth_first.py_func(flat, first, last, cost, parent, queue)
    return moments(
        steps, cost, parent, lambda v, before: queue[before + 1 : np.isfinite(cost).sum()]
    )
