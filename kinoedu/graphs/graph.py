"""Graphs: nodes with numbers, edges with weights, held flat so that a search runs at the speed of memory."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled, generic, record
from ..errors import InvalidGraph
from ..geometry.checks import Array


@generic(1)
def degree(graph: object, u: int) -> int:
    """How many edges leave node u: they are numbered 0 to degree - 1. A grid counts moves that it may refuse."""
    raise TypeError("this kind of graph cannot be searched")


@generic(1)
def edge(graph: object, u: int, k: int) -> tuple[int, float]:
    """Where the k-th edge that leaves u leads, and its weight; -1 where that move is refused."""
    raise TypeError("this kind of graph cannot be searched")


@record
class GraphRecord(NamedTuple):
    """What `Graph` makes: the edges that leave u lead to to[first[u]:first[u + 1]], with the weights beside them.

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
        """The nodes that an edge from u leads to, in increasing order."""
        return self.to[self.first[u] : self.first[u + 1]]


def Graph(size: int, edges: ArrayLike, weights: ArrayLike | None = None, *, directed: bool = False) -> GraphRecord:
    """A graph of `size` nodes, numbered from 0.

    Parameters
    ----------
    edges : (m, 2) pairs of nodes; each leads both ways unless `directed`.
    weights : (m,) non-negative numbers; 1 for every edge where they are left out.

    Raises InvalidGraph where an edge names a node that is not there or a weight is negative or not a number.

    >>> graph = Graph(4, [(0, 1), (1, 2), (0, 3)])
    >>> graph.neighbours(0), graph.degree(1)
    (array([1, 3]), 2)
    """
    pairs = as_edges(edges, size)
    costs = np.ones(len(pairs)) if weights is None else np.asarray(weights, np.float64)
    if costs.shape != (len(pairs),):
        raise InvalidGraph(f"{len(pairs)} edges need as many weights, got shape {costs.shape}")
    if not (costs >= 0.0).all():
        raise InvalidGraph(f"weights must be zero or more, got {costs[~(costs >= 0.0)][0]:g}")
    ways = pairs if directed else np.concatenate([pairs, pairs[:, ::-1]])
    costs_there = costs if directed else np.concatenate([costs, costs])
    _, by_target = counting_sort(ways[:, 1], np.arange(len(ways)), size)
    first, order = counting_sort(ways[:, 0], by_target, size)
    return GraphRecord(size, pairs, costs, first, ways[order, 1], costs_there[order])


@compiled
def counting_sort(keys: NDArray[np.int64], order: NDArray[np.int64], size: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Where each key from 0 to size begins, (size + 1,), and `order` with its keys in increasing order, stable. O(n + size)."""
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


def as_edges(edges: ArrayLike, size: int) -> NDArray[np.int64]:
    """Edges as whole numbers of shape (m, 2), each a node of the graph."""
    given = np.asarray(edges)
    pairs = given.reshape(-1, 2).astype(np.int64) if given.size == 0 else given.astype(np.int64)
    if pairs.ndim != 2 or pairs.shape[1] != 2 or (given.size and not np.array_equal(pairs, given)):
        raise InvalidGraph(f"edges must be pairs of whole numbers, shape (m, 2), got shape {given.shape} of {given.dtype}")
    if pairs.size and not (0 <= pairs.min() and pairs.max() < size):
        raise InvalidGraph(f"edges must name nodes 0 to {size - 1}, got {pairs.min()} to {pairs.max()}")
    return pairs


@degree.register(GraphRecord)
def graph_degree(graph: GraphRecord, u: int) -> int:
    """From the flat arrays."""
    return graph.first[u + 1] - graph.first[u]


@edge.register(GraphRecord)
def graph_edge(graph: GraphRecord, u: int, k: int) -> tuple[int, float]:
    """From the flat arrays."""
    at = graph.first[u] + k
    return graph.to[at], graph.weight[at]
