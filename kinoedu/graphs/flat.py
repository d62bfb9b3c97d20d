"""The interface between a search and a graph, and a graph in flat arrays.

A search needs two operations: `degree`, the number of edges that leave a node, and `edge`, where
the k-th of them leads and its weight. With `edges_after` a graph spares a search for shortest paths
some edges. A grid computes both without storing edges. A `Graph`
converts itself to a `GraphRecord`, which stores compressed sparse rows as in Y. Saad, "Iterative
Methods for Sparse Linear Systems", section 3.4.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import singledispatch
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled, generic, record
from ..errors import InvalidGraph
from ..geometry.checks import Array, is_integer
from ..support.constructors import with_type_names
from ..support.text import shortened

Searchable = object  # a Graph, or a record with answers for `degree` and `edge`
Heuristic = object  # an array (n,), or a record with an answer for `estimate`


@generic(1)
def degree(graph: Searchable, u: int) -> int:
    """The number of edges that leave node u; they are numbered 0 to degree - 1.

    A grid counts moves that it may refuse.
    """
    raise TypeError("this kind of graph cannot be searched")


@generic(1)
def edge(graph: Searchable, u: int, k: int) -> tuple[int, float]:
    """The end of the k-th edge from u, or -1 where a grid refuses the move; and its weight."""
    raise TypeError("this kind of graph cannot be searched")


@generic(1)
def edges_after(graph: Searchable, before: int, u: int) -> Iterable[int]:
    """The numbers of the edges from u that a search for shortest paths must examine.

    It has come to u from `before`, -1 for the start. By default all edges; a graph leaves out those
    of which it knows that another path is as short.
    """
    return range(degree(graph, u))


@generic(1)
def estimate(heuristic: Any, u: int) -> float:
    """h(u), at most the cost from node u to the goal: of an array (n,) its entry."""
    return heuristic[u]


@with_type_names
@record
class GraphRecord(NamedTuple):
    """A graph in flat arrays.

    The edges that leave u lead to to[first[u]:first[u + 1]]; `weight` holds their weights in the
    same order. edges (m, 2) and weights (m,) keep the order in which the edges were given.
    """

    size: int
    edges: NDArray[np.int64]
    weights: Array
    first: NDArray[np.int64]
    to: NDArray[np.int64]
    weight: Array

    def degree(self, u: int) -> int:
        """The number of edges that leave node u."""
        return len(self.neighbours(u))

    def neighbours(self, u: int) -> NDArray[np.int64]:
        """The nodes that edges from u lead to, in increasing order, one for each edge."""
        return self.to[self.first[u] : self.first[u + 1]]


def flat_graph(
    size: int, edges: NDArray[np.int64], weights: Array, *, directed: bool = False
) -> GraphRecord:
    """Build the record of a graph from edges (m, 2) and weights (m,) without checks. O(n + m).

    For planners, whose edges are known to be valid; a reader's own edges go through `Graph`. Edges
    that leave a node are sorted by the node they lead to; parallel edges keep their order.

    Returns
    -------
    GraphRecord

    Examples
    --------
    >>> graph = flat_graph(3, np.array([(0, 2), (0, 1)]), np.array([5.0, 1.0]))
    >>> graph.neighbours(0), degree(graph, 2), edge(graph, 0, 1)
    (array([1, 2]), np.int64(1), (np.int64(2), np.float64(5.0)))
    """
    return GraphRecord(
        size, edges, weights, *compress_rows(size, edges, weights, 1 if directed else 2)
    )


@algorithm
def compress_rows(
    size: int, edges: NDArray[np.int64], weights: Array, directions: int
) -> tuple[NDArray[np.int64], NDArray[np.int64], Array]:
    """The compressed sparse rows of a graph: where each node's edges begin, their ends and weights.

    Each edge is stored once (directions = 1), or once in each direction (directions = 2). Two
    counting sorts, by target and then by source: the second is stable and keeps the order that the
    first has made.
    """
    m = len(edges)
    by_target, by_source = np.zeros(size + 2, np.int64), np.zeros(size + 2, np.int64)
    for direction in range(directions):
        for e in range(m):
            by_source[edges[e, direction] + 2] += 1
            by_target[edges[e, 1 - direction] + 2] += 1
    for u in range(2, size + 2):
        by_source[u] += by_source[u - 1]
        by_target[u] += by_target[u - 1]
    source, its_weight = np.empty(directions * m, np.int64), np.empty(directions * m)
    for direction in range(directions):
        for e in range(m):
            target = edges[e, 1 - direction]
            at = by_target[target + 1]
            by_target[target + 1] += 1
            source[at], its_weight[at] = edges[e, direction], weights[e]
    to, weight = np.empty(directions * m, np.int64), np.empty(directions * m)
    for target in range(size):
        for i in range(by_target[target], by_target[target + 1]):
            at = by_source[source[i] + 1]
            by_source[source[i] + 1] += 1
            to[at], weight[at] = target, its_weight[i]
    return by_source[:-1].copy(), to, weight


@compiled
def counting_sort(
    keys: NDArray[np.int64], order: NDArray[np.int64], size: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Sort `order` by keys from 0 to size - 1, stably. O(n + size).

    Returns
    -------
    (size + 1,) array: where each key begins; and the sorted order.
    """
    at = np.zeros(size + 2, np.int64)
    for key in keys:
        at[key + 2] += 1
    for key in range(2, size + 2):
        at[key] += at[key - 1]
    sorted_order = np.empty(len(order), np.int64)
    for i in order:
        sorted_order[at[keys[i] + 1]] = i
        at[keys[i] + 1] += 1
    return at[:-1], sorted_order


@degree.register(GraphRecord)
def graph_degree(graph: GraphRecord, u: int) -> int:
    """Read from the flat arrays."""
    return graph.first[u + 1] - graph.first[u]


@edge.register(GraphRecord)
def graph_edge(graph: GraphRecord, u: int, k: int) -> tuple[int, float]:
    """Read from the flat arrays."""
    at = graph.first[u] + k
    return graph.to[at], graph.weight[at]


@singledispatch
def as_searchable(graph: Searchable) -> Any:
    """Convert a graph to the record on which compiled searches run.

    Raises
    ------
    InvalidGraph
        Where it is neither a Graph nor a record with answers for `degree` and `edge`.
    """
    if not isinstance(graph, tuple) or not hasattr(graph, "size"):
        raise InvalidGraph(
            f"expected a Graph, or a record that answers degree and edge, got {shortened(graph)}"
        )
    return graph


@singledispatch
def check_node(graph: Any, u: Any, name: str) -> int:
    """The node u as a plain number.

    Raises
    ------
    InvalidGraph
        Where u is not a node of the graph.
    """
    if not is_integer(u) or not 0 <= u < graph.size:
        have = (
            f"a node from 0 to {graph.size - 1}"
            if graph.size
            else "a node, and this graph has none"
        )
        raise InvalidGraph(f"{name} must be {have}, got {shortened(u)}")
    return int(u)
