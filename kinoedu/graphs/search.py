"""Dijkstra's algorithm and A*: one search, told apart by its estimate of what remains.

    A*(G, start, goal, estimate)                                    Dijkstra's algorithm: every estimate is 0
     1  for each node v: cost(v) := infinity, parent(v) := none
     2  cost(start) := 0; insert start into an empty priority queue Q
     3  while Q is not empty:
     4      u := retrieve from Q the node with the least cost(u) + estimate(u)
     5      if u = goal: return extract-path
     6      for each node v that an edge leads to from u:
     7          if cost(u) + weight(u, v) < cost(v):
     8              cost(v) := cost(u) + weight(u, v); parent(v) := u
     9              insert v into Q, or move it forward
    10  return failure

The queue is a radix heap. Nothing is moved in it: v is inserted once more, and what is retrieved
again at no gain is passed over.

E. W. Dijkstra (1959); P. E. Hart, N. J. Nilsson, B. Raphael, "A formal basis for the heuristic
determination of minimum cost paths" (1968); Bullo & Smith, chapter 2; LaValle, section 2.2.
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm, callable_from_compiled, inlined
from ..errors import InvalidGraph
from ..geometry.checks import Array
from ..support.text import shortened
from .flat import degree, edge
from .paths import Expansion, Search, Steps, ends, path_found
from .radix_heap import (
    NONE,
    RadixHeap,
    enlarged,
    first,
    has_room,
    in_order,
    insert,
    radix_heap,
    remove_first,
)

ROUNDING = 1e-12  # of a cost


class Known(NamedTuple):
    """What a search knows of each node: its least cost so far, its parent, and whether it has been
    expanded at that cost.
    """

    cost: Array
    parent: NDArray[np.int64]
    settled: NDArray[np.bool_]


@inlined
def expand(
    graph: Any,
    goal: int,
    estimate: Array,
    known: Known,
    queue: RadixHeap,
    expanded: NDArray[np.int64],
    n: int,
) -> tuple[int, bool]:
    """Lines 3 to 10: expand node after node, least cost so far plus estimate first, of several the
    one inserted last.

    Returns how many are in `expanded`, and whether that is all: the goal is one of them, or none is
    left. It stops short where that array is full, or the queue might be. An estimate that never
    exceeds the true remaining cost makes the first path found a shortest one; where it is not
    consistent, a node is expanded again whenever that gains more than rounding.
    """
    cost, parent, settled = known
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
        for k in range(degree(graph, u)):
            v, weight = edge(graph, u, k)
            if v < 0 or cost[u] + weight >= cost[v] * (1.0 - ROUNDING if settled[v] else 1.0):
                continue
            cost[v] = cost[u] + weight
            parent[v] = u
            settled[v] = False
            insert(queue, v, cost[v] + estimate[v])


@callable_from_compiled
def first_unsettled(queue: RadixHeap, settled: NDArray[np.bool_]) -> int:
    """The first of the queue, left in it, once what has been settled since it was inserted is taken
    out; or -1.
    """
    u = first(queue)
    while u != NONE and settled[u]:
        remove_first(queue)
        u = first(queue)
    return u


@callable_from_compiled
def begun(size: int, start: int, estimate: Array) -> tuple[Known, RadixHeap]:
    """Lines 1 and 2."""
    known, queue = (
        Known(np.full(size, np.inf), np.full(size, -1, np.int64), np.zeros(size, np.bool_)),
        radix_heap(64),
    )
    known.cost[start] = 0.0
    insert(queue, start, estimate[start])
    return known, queue


@algorithm
def search(
    graph: Any, start: int, goal: int, estimate: Array
) -> tuple[Array, NDArray[np.int64], NDArray[np.int64], int]:
    """The whole search: costs, parents, expanded nodes, how many edges were looked at. goal = -1
    expands all that are reached.
    """
    known, queue = begun(len(estimate), start, estimate)
    expanded = np.empty(len(estimate), np.int64)
    n, done = expand(graph, goal, estimate, known, queue, expanded, 0)
    while not done:
        if n == len(expanded):
            expanded = np.append(expanded, expanded)
        else:
            queue = enlarged(queue, degree(graph, first(queue)))
        n, done = expand(graph, goal, estimate, known, queue, expanded, n)
    looked_at = 0
    for u in expanded[:n]:
        looked_at += degree(graph, u) if u != goal else 0
    return known.cost, known.parent, expanded[:n], looked_at


def best_first(flat: Any, start: int, goal: int, estimate: Array) -> Search:
    """The search with its result in one piece."""
    cost, parent, expanded, looked_at = search(flat, start, goal, estimate)
    return Search(cost, parent, expanded, Steps(len(expanded), int(looked_at)))


def dijkstra(graph: Any, start: int) -> Search:
    """Shortest paths from one node to all: their costs, and each node's parent on its path.

    O(n + m b) for costs that differ in b bits, of 63. Raises InvalidGraph where `start` is not a
    node.

    >>> from kinoedu.graphs import Graph
    >>> found = dijkstra(Graph(4, [(0, 1), (1, 2), (0, 2)], [1.0, 1.0, 5.0]), 0)
    >>> found.cost, found.steps
    (array([ 0.,  1.,  2., inf]), Steps(nodes=3, edges=6))
    """
    flat, first, _ = ends(graph, start, None)
    return best_first(flat, first, -1, np.zeros(flat.size))


def astar(
    graph: Any, start: int, goal: int, estimate: ArrayLike | None = None
) -> tuple[NDArray[np.int64] | None, Search]:
    """A shortest path between two nodes, as node numbers (k,), or None where there is none; and the
    search that found it.

    estimate : (n,) lower bounds on the cost from each node to the goal; without them this is
        Dijkstra's algorithm stopped at the goal. In a graph whose weights are distances,
        `graph.distances(goal)` are such bounds. Raises InvalidGraph.

    >>> from kinoedu.graphs import Graph
    >>> path, found = astar(Graph(4, [(0, 1), (1, 2), (0, 2)], [1.0, 1.0, 5.0]), 0, 2)
    >>> path, found.cost[2]
    (array([0, 1, 2]), np.float64(2.0))
    """
    flat, first, last = ends(graph, start, goal)
    found = best_first(flat, first, last, as_estimate(estimate, flat.size))
    return path_found(found, last), found


def astar_expansions(
    graph: Any, start: int, goal: int, estimate: ArrayLike | None = None
) -> Iterator[Expansion]:
    """The same search one expansion after another, each with the priority queue as it was then; O(n
    log n) more for each.

    Raises InvalidGraph.

    >>> from kinoedu.graphs import Graph
    >>> for moment in astar_expansions(Graph(4, [(0, 1), (1, 2), (0, 2)], [1.0, 1.0, 5.0]), 0, 2):
    ...     moment.node, moment.frontier
    (0, array([], dtype=int64))
    (1, array([2]))
    (2, array([], dtype=int64))
    """
    flat, first, last = ends(graph, start, goal)
    return best_first_moments(flat, first, last, as_estimate(estimate, flat.size))


def dijkstra_expansions(graph: Any, start: int) -> Iterator[Expansion]:
    """Dijkstra's algorithm one expansion after another, as `astar_expansions`. Raises InvalidGraph.

    >>> from kinoedu.graphs import Graph
    >>> [moment.node for moment in dijkstra_expansions(Graph(3, [(0, 1), (1, 2), (0, 2)], [4.0, 1.0, 1.0]), 0)]
    [0, 2, 1]
    """
    flat, first, _ = ends(graph, start, None)
    return best_first_moments(flat, first, -1, np.zeros(flat.size))


def best_first_moments(flat: Any, start: int, goal: int, estimate: Array) -> Iterator[Expansion]:
    """Before each expansion, what is known and which nodes wait."""
    known, queue = begun(flat.size, start, estimate)
    expanded, n, done = np.empty(flat.size, np.int64), 0, False
    while not done and (u := first_unsettled(queue, known.settled)) != NONE:
        waiting = [v for v in dict.fromkeys(in_order(queue)) if v != u and not known.settled[v]]
        yield Expansion(
            int(u),
            expanded[:n].copy(),
            np.array(waiting, np.int64),
            known.cost.copy(),
            known.parent.copy(),
        )
        if not has_room(queue, degree(flat, u)):
            queue = enlarged(queue, degree(flat, u))
        if n == len(expanded):
            expanded = np.append(expanded, expanded)
        n, done = expand.py_func(flat, goal, estimate, known, queue, expanded[: n + 1], n)


def as_estimate(estimate: ArrayLike | None, size: int) -> Array:
    """Lower bounds, one for each node: shape (n,), zero or more; zeros for None. InvalidGraph
    otherwise.
    """
    if estimate is None:
        return np.zeros(size)
    try:
        bounds = np.array(estimate, np.float64)
    except (TypeError, ValueError):
        bounds = np.empty(0)
    if bounds.shape != (size,) or not (bounds >= 0.0).all():
        raise InvalidGraph(
            f"the estimate must be {size} numbers, zero or more, one for each node, got "
            f"{shortened(estimate)}"
        )
    return bounds
