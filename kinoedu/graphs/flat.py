"""What a search asks of a graph, and the flat arrays that answer at the speed of memory.

A search asks two things: how many edges leave a node, and where each leads at what weight. A grid
answers without holding edges; a `Graph` answers by its `GraphRecord`, compressed sparse rows as in
Y. Saad, "Iterative Methods for Sparse Linear Systems", section
3.4.
"""

from functools import singledispatch
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled, generic, record
from ..errors import InvalidGraph
from ..geometry.checks import Array
from ..support.text import shortened


@generic(1)
def degree(graph: object, u: int) -> int:
    """How many edges leave node u: they are numbered 0 to degree - 1. A grid counts moves that it
    may refuse.
    """
    raise TypeError("this kind of graph cannot be searched")


@generic(1)
def edge(graph: object, u: int, k: int) -> tuple[int, float]:
    """Where the k-th edge that leaves u leads, and its weight; -1 where that move is refused."""
    raise TypeError("this kind of graph cannot be searched")


@record
class GraphRecord(NamedTuple):
    """A graph held flat: the edges that leave u lead to to[first[u]:first[u + 1]], with the weights
    beside them.

    edges (m, 2) and weights (m,) are as given: the order in which a planner found them.
    """

    size: int
    edges: NDArray[np.int64]
    weights: Array
    first: NDArray[np.int64]
    to: NDArray[np.int64]
    weight: Array

    def degree(self, u: int) -> int:
        """How many edges leave node u."""
        return len(self.neighbours(u))

    def neighbours(self, u: int) -> NDArray[np.int64]:
        """The nodes that edges from u lead to, in increasing order, one for each edge."""
        return self.to[self.first[u] : self.first[u + 1]]


def flat_graph(
    size: int, edges: NDArray[np.int64], weights: Array, *, directed: bool = False
) -> GraphRecord:
    """The record of a graph from edges (m, 2) and weights (m,) that are known to be right. O(n +
    m).

    For planners, whose edges need no checks; a reader's own go through `Graph`. Edges that leave a
    node stand in the order of the nodes they lead to, parallel ones in the order they were given.

    >>> graph = flat_graph(3, np.array([(0, 2), (0, 1)]), np.array([5.0, 1.0]))
    >>> graph.neighbours(0), degree(graph, 2), edge(graph, 0, 1)
    (array([1, 2]), np.int64(1), (np.int64(2), np.float64(5.0)))
    """
    return GraphRecord(
        size, edges, weights, *compressed_rows(size, edges, weights, 1 if directed else 2)
    )


@algorithm
def compressed_rows(
    size: int, edges: NDArray[np.int64], weights: Array, ways: int
) -> tuple[NDArray[np.int64], NDArray[np.int64], Array]:
    """Where the edges that leave each node begin, where they lead and their weights; each edge goes
    there, or there and back.

    Two counting sorts, by the node led to and then by the node left: the second keeps what the
    first has put in order.
    """
    m = len(edges)
    by_target, by_source = np.zeros(size + 2, np.int64), np.zeros(size + 2, np.int64)
    for way in range(ways):
        for e in range(m):
            by_source[edges[e, way] + 2] += 1
            by_target[edges[e, 1 - way] + 2] += 1
    for u in range(2, size + 2):
        by_source[u] += by_source[u - 1]
        by_target[u] += by_target[u - 1]
    arcs = np.empty((ways * m, 2), np.int64)
    for way in range(ways):
        for e in range(m):
            at = by_target[edges[e, 1 - way] + 1]
            by_target[edges[e, 1 - way] + 1] += 1
            arcs[at, 0], arcs[at, 1] = e, way
    to, weight = np.empty(ways * m, np.int64), np.empty(ways * m)
    for i in range(len(arcs)):
        e, way = arcs[i, 0], arcs[i, 1]
        at = by_source[edges[e, way] + 1]
        by_source[edges[e, way] + 1] += 1
        to[at], weight[at] = edges[e, 1 - way], weights[e]
    return by_source[:-1].copy(), to, weight


@compiled
def counting_sort(
    keys: NDArray[np.int64], order: NDArray[np.int64], size: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Where each key from 0 to size begins, (size + 1,), and `order` with its keys in increasing
    order, stable. O(n + size).
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
    """From the flat arrays."""
    return graph.first[u + 1] - graph.first[u]


@edge.register(GraphRecord)
def graph_edge(graph: GraphRecord, u: int, k: int) -> tuple[int, float]:
    """From the flat arrays."""
    at = graph.first[u] + k
    return graph.to[at], graph.weight[at]


@singledispatch
def searchable(graph: Any) -> Any:
    """What a compiled search runs on: a record that answers `degree` and `edge`; InvalidGraph for
    what is none.
    """
    if not isinstance(graph, tuple) or not hasattr(graph, "size"):
        raise InvalidGraph(
            f"expected a Graph, or a record that answers degree and edge, got {shortened(graph)}"
        )
    return graph


@singledispatch
def check_node(graph: Any, u: Any, name: str) -> int:
    """The node u as a plain number; InvalidGraph unless it is one of the graph's."""
    if isinstance(u, bool) or not isinstance(u, int | np.integer) or not 0 <= u < graph.size:
        have = (
            f"a node from 0 to {graph.size - 1}"
            if graph.size
            else "a node, and this graph has none"
        )
        raise InvalidGraph(f"{name} must be {have}, got {shortened(u)}")
    return int(u)
