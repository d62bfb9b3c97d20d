"""Dijkstra's algorithm and A*: one best-first search, with and without a heuristic.

    A*(G, start, goal, h)                       Dijkstra's algorithm: h(u) = 0 for every node u
     1  for each node v: cost(v) := infinity, parent(v) := none
     2  cost(start) := 0; insert start into an empty priority queue Q
     3  while Q is not empty:
     4      u := retrieve from Q the node with the least cost(u) + h(u)
     5      if u = goal: return extract-path
     6      for each node v that an edge leads to from u:
     7          if cost(u) + weight(u, v) < cost(v):
     8              cost(v) := cost(u) + weight(u, v); parent(v) := u
     9              insert v into Q, or move it forward
    10  return failure

The queue is a radix heap. Entries are never moved forward: line 9 inserts v once more, and line 4
skips a node that has been settled since its entry was inserted.

E. W. Dijkstra (1959); P. E. Hart, N. J. Nilsson, B. Raphael, "A formal basis for the heuristic
determination of minimum cost paths" (1968); Bullo & Smith, chapter 5; LaValle, section 2.2.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm, callable_from_compiled, inlined
from ..errors import InvalidGraph
from ..geometry.checks import Array
from ..support.text import shortened
from .flat import Heuristic, Searchable, degree, edge, edges_after, estimate
from .paths import Expansion, Search, Steps, check_ends, path_or_none
from .radix_heap import (
    NONE,
    RadixHeap,
    empty_heap,
    enlarge,
    has_room,
    insert,
    list_in_order,
    peek,
    remove_first,
)

ROUNDING = 1e-12  # relative, of a cost


class Labels(NamedTuple):
    """The labels of each node: its least cost so far, its parent, whether it is settled.

    A settled node has been expanded at its present cost. All arrays have shape (n,).
    """

    cost: Array
    parent: NDArray[np.int64]
    settled: NDArray[np.bool_]


@inlined
def expand(
    graph: Any,
    goal: int,
    heuristic: Heuristic,
    labels: Labels,
    queue: RadixHeap,
    expanded: NDArray[np.int64],
    n: int,
) -> tuple[int, bool]:
    """Lines 3 to 10: expand the node of least cost plus heuristic, again and again.

    Ties go to the most recently inserted node. The first path found is a shortest one where the
    heuristic never exceeds the true remaining cost. Where the heuristic is not consistent, a node
    is expanded again whenever its cost decreases by more than rounding.

    Returns
    -------
    n : how many nodes are in `expanded` now.
    done : whether the goal was expanded or the queue is empty. It is false where `expanded` is
        full, or the queue may lack room for the edges of the next node.
    """
    cost, parent, settled = labels
    while True:
        u = first_unsettled(queue, settled)
        if u == NONE:
            return n, True
        if n == len(expanded) or not has_room(queue, degree(graph, u)):
            return n, False
        remove_first(queue)
        settled[u] = True
        expanded[n] = u
        n += 1
        if u == goal:
            return n, True
        for k in edges_after(graph, parent[u], u):
            v, weight = edge(graph, u, k)
            if v < 0 or cost[u] + weight >= cost[v] * (1.0 - ROUNDING if settled[v] else 1.0):
                continue
            cost[v] = cost[u] + weight
            parent[v] = u
            settled[v] = False
            insert(queue, v, cost[v] + estimate(heuristic, v))


@callable_from_compiled
def first_unsettled(queue: RadixHeap, settled: NDArray[np.bool_]) -> int:
    """The first unsettled node of the queue, or -1; settled nodes before it are removed."""
    u = peek(queue)
    while u != NONE and settled[u]:
        remove_first(queue)
        u = peek(queue)
    return u


@callable_from_compiled
def begin_search(size: int, start: int, heuristic: Heuristic) -> tuple[Labels, RadixHeap]:
    """Lines 1 and 2, with room for a quarter of the nodes in the queue.

    Python calls it, because numpy asks for large pages of memory and numba does not.
    """
    labels = Labels(np.full(size, np.inf), np.full(size, -1, np.int64), np.zeros(size, np.bool_))
    queue = empty_heap(64 + size // 4)
    labels.cost[start] = 0.0
    insert(queue, start, labels.cost[start] + estimate(heuristic, start))
    return labels, queue


@algorithm
def search(
    graph: Any, goal: int, heuristic: Heuristic, labels: Labels, queue: RadixHeap
) -> tuple[NDArray[np.int64], int]:
    """Run a search that has begun to its end; goal = -1 expands every node that can be reached.

    Returns
    -------
    expanded : (k,), the nodes in the order of expansion.
    examined : how many edges the expanded nodes have; no more are examined.
    """
    expanded = np.empty(len(labels.cost), np.int64)
    n, done = expand(graph, goal, heuristic, labels, queue, expanded, 0)
    while not done:
        if n == len(expanded):
            expanded = np.append(expanded, expanded)
        else:
            queue = enlarge(queue, degree(graph, peek(queue)))
        n, done = expand(graph, goal, heuristic, labels, queue, expanded, n)
    examined = 0
    for u in expanded[:n]:
        examined += degree(graph, u) if u != goal else 0
    return expanded[:n], examined


def run_search(flat: Any, start: int, goal: int, heuristic: Heuristic) -> Search:
    """Run a whole search and collect its result in a Search."""
    labels, queue = begin_search(flat.size, start, heuristic)
    expanded, examined = search(flat, goal, heuristic, labels, queue)
    return Search(labels.cost, labels.parent, expanded, Steps(len(expanded), int(examined)))


def dijkstra(graph: Searchable, start: int) -> Search:
    """Shortest paths from one node to all others, by Dijkstra's algorithm.

    O(n + m b) for costs that differ in b of their 63 bits.

    Returns
    -------
    Search, with the cost of each node and its parent on a shortest path.

    Raises
    ------
    InvalidGraph
        Where `start` is not a node of the graph.

    Examples
    --------
    >>> from kinoedu.graphs import Graph
    >>> found = dijkstra(Graph(4, [(0, 1), (1, 2), (0, 2)], [1.0, 1.0, 5.0]), 0)
    >>> found.cost, found.steps
    (array([ 0.,  1.,  2., inf]), Steps(nodes=3, edges=6))
    """
    flat, first, _ = check_ends(graph, start, None)
    return run_search(flat, first, -1, np.zeros(flat.size))


def astar(
    graph: Searchable, start: int, goal: int, heuristic: ArrayLike | Heuristic | None = None
) -> tuple[NDArray[np.int64] | None, Search]:
    """A shortest path between two nodes, by A*.

    Parameters
    ----------
    heuristic : (n,), lower bounds on the cost from each node to the goal. Without it this is
        Dijkstra's algorithm, stopped at the goal. Where weights are distances,
        `graph.distances(graph.nodes[goal])` is such a heuristic. A record that answers `estimate`
        computes them.

    Returns
    -------
    (k,) array of node numbers, or None where there is no path; and the Search that found it.

    Raises
    ------
    InvalidGraph
        Where `start` or `goal` is not a node, or `heuristic` is not n numbers of zero or more.

    Examples
    --------
    >>> from kinoedu.graphs import Graph
    >>> path, found = astar(Graph(4, [(0, 1), (1, 2), (0, 2)], [1.0, 1.0, 5.0]), 0, 2)
    >>> path, found.cost[2]
    (array([0, 1, 2]), np.float64(2.0))
    """
    flat, first, last = check_ends(graph, start, goal)
    found = run_search(flat, first, last, as_heuristic(heuristic, flat.size))
    return path_or_none(found, last), found


def astar_expansions(
    graph: Searchable, start: int, goal: int, heuristic: ArrayLike | Heuristic | None = None
) -> Iterator[Expansion]:
    """A* as an iterator over its expansions, with the priority queue at each of them.

    Each expansion costs O(n log n) more than in `astar`, because it copies the arrays and sorts
    the queue.

    Raises
    ------
    InvalidGraph
        As `astar`.

    Examples
    --------
    >>> from kinoedu.graphs import Graph
    >>> for moment in astar_expansions(Graph(4, [(0, 1), (1, 2), (0, 2)], [1.0, 1.0, 5.0]), 0, 2):
    ...     moment.node, moment.frontier
    (0, array([], dtype=int64))
    (1, array([2]))
    (2, array([], dtype=int64))
    """
    flat, first, last = check_ends(graph, start, goal)
    return yield_expansions(flat, first, last, as_heuristic(heuristic, flat.size))


def dijkstra_expansions(graph: Searchable, start: int) -> Iterator[Expansion]:
    """Dijkstra's algorithm as an iterator over its expansions; see `astar_expansions`.

    Raises
    ------
    InvalidGraph
        Where `start` is not a node of the graph.

    Examples
    --------
    >>> from kinoedu.graphs import Graph
    >>> graph = Graph(3, [(0, 1), (1, 2), (0, 2)], [4.0, 1.0, 1.0])
    >>> [moment.node for moment in dijkstra_expansions(graph, 0)]
    [0, 2, 1]
    """
    flat, first, _ = check_ends(graph, start, None)
    return yield_expansions(flat, first, -1, np.zeros(flat.size))


def yield_expansions(flat: Any, start: int, goal: int, heuristic: Heuristic) -> Iterator[Expansion]:
    """Yield the labels and the waiting nodes before each expansion."""
    labels, queue = begin_search(flat.size, start, heuristic)
    expanded, n, done = np.empty(flat.size, np.int64), 0, False
    while not done and (u := first_unsettled(queue, labels.settled)) != NONE:
        queued = dict.fromkeys(list_in_order(queue))
        waiting = [v for v in queued if v != u and not labels.settled[v]]
        yield Expansion(
            int(u),
            expanded[:n].copy(),
            np.array(waiting, np.int64),
            labels.cost.copy(),
            labels.parent.copy(),
        )
        if not has_room(queue, degree(flat, u)):
            queue = enlarge(queue, degree(flat, u))
        if n == len(expanded):
            expanded = np.append(expanded, expanded)
        n, done = expand.py_func(flat, goal, heuristic, labels, queue, expanded[: n + 1], n)


def as_heuristic(values: ArrayLike | Heuristic | None, size: int) -> Heuristic:
    """Lower bounds (n,), zeros for None; raises InvalidGraph unless all are zero or more.

    A record that answers `estimate` is taken as it is.
    """
    if values is None:
        return np.zeros(size)
    if estimate.is_known(type(values)):
        return values
    try:
        bounds = np.require(values, np.float64, ["C", "W", "E"])
    except (TypeError, ValueError):
        bounds = np.empty(0)
    if bounds.shape != (size,) or not bounds.min(initial=0.0) >= 0.0:
        raise InvalidGraph(
            f"the heuristic must be {size} numbers, zero or more, one for each node, got "
            f"{shortened(values)}"
        )
    return bounds
