"""Graphs that can be built in one go or grown: nodes with numbers, in a space or in none; edges
with weights, both ways or one.

A number once given stays its node's for ever: after `delete_node` the others keep theirs, and the
one that is gone is refused by name instead of meaning another node. So what a reader keeps beside a
graph (parents, costs, a picture) stays right.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidGraph
from ..geometry.checks import Array
from ..support.text import shortened
from .checks import (
    Rows,
    as_edges,
    as_node_place,
    as_node_places,
    as_size,
    as_weights,
    distances_from,
    edge_lengths,
    everywhere,
)
from .components import component_labels
from .flat import GraphRecord, check_node, flat_graph, searchable
from .matrices import adjacency_matrix, incidence_matrix, laplacian_matrix
from .search import dijkstra


class Graph:
    """A graph of nodes numbered from 0.

    Parameters
    ----------
    size : how many nodes; may be left out where `nodes` are given.
    edges : (m, 2) pairs of nodes; each leads both ways unless `directed`. Loops and parallel edges
    are allowed.
    weights : (m,) numbers, zero or more. Left out they are 1, or in an embedded graph the distance
    between the edge's ends.
    nodes : (n, d) where the nodes are: the graph is embedded.
    space : any space of `kinoedu.spaces`, whose distance is meant; Euclidean by default.

    Raises InvalidGraph where an edge names a node that is not there, or a weight is negative,
    infinite or not a number; InvalidPoint for nodes that are no points.

    `len(graph)` counts the nodes, `for u in graph` and `u in graph` go by their numbers. `size`
    counts the numbers ever given, and the length of every array that has an entry for each node.
    `node_data` is a list of that length, to read and write.

    >>> graph = Graph(4, [(0, 1), (1, 2), (0, 3)])
    >>> graph.neighbours(0), graph.degree(1)
    (array([1, 3]), 2)
    >>> grown = Graph(nodes=[(0, 0), (3, 4)])
    >>> grown.add_edge(0, 1, data="the road")
    >>> grown.add_node((3, 5)), grown.weight(0, 1), grown.closest((3, 6))
    (2, 5.0, (2, 1.0))
    """

    def __init__(
        self,
        size: int | None = None,
        edges: ArrayLike = (),
        weights: ArrayLike | None = None,
        *,
        nodes: ArrayLike | None = None,
        space: Any = None,
        directed: bool = False,
    ) -> None:
        places = (
            None
            if nodes is None and space is None
            else as_node_places(() if nodes is None else nodes, space)
        )
        count = as_size(size, None if places is None else len(places))
        pairs = as_edges(edges, count)
        self.directed = bool(directed)
        self.space = everywhere(places.shape[1]) if places is not None and space is None else space
        self.node_data: list[Any] = [None] * count
        self._there = [True] * count
        self._places = None if places is None else Rows(places)
        self._edges = Rows(pairs)
        self._weights = Rows(
            self._metric(pairs) if weights is None else as_weights(weights, len(pairs))
        )
        self._edge_data: list[Any] = [None] * len(pairs)
        self._flat: GraphRecord | None = None

    def __repr__(self) -> str:
        kind = "directed " if self.directed else ""
        return f"<Graph: {len(self):,} nodes, {self._edges.count:,} {kind}edges>"

    def __len__(self) -> int:
        return sum(self._there)

    def __iter__(self) -> Iterator[int]:
        return iter(np.flatnonzero(self._there).tolist())

    def __contains__(self, u: object) -> bool:
        whole = isinstance(u, int | np.integer) and not isinstance(u, bool)
        return whole and 0 <= u < self.size and self._there[u]  # type: ignore[operator, call-overload]

    @property
    def size(self) -> int:
        """How many numbers have been given to nodes."""
        return len(self._there)

    @property
    def nodes(self) -> Array:
        """Where the nodes are, (size, d), a deleted one where it was; a copy. InvalidGraph where
        the graph is not embedded.
        """
        return self._embedding().rows.copy()

    @property
    def edges(self) -> NDArray[np.int64]:
        """The edges that are there, (m, 2), in the order they were added; a copy."""
        return self._edges.rows.copy()

    @property
    def weights(self) -> Array:
        """Their weights, (m,); a copy."""
        return self._weights.rows.copy()

    def add_node(self, q: ArrayLike | None = None, data: Any = None) -> int:
        """Add a node, at q (d,) if the graph is embedded; returns its number. O(1) on average.
        InvalidGraph, InvalidPoint.
        """
        if self._places is not None:
            self._places.append(as_node_place(q, self._places.rows, self.space))
        elif q is not None:
            raise InvalidGraph(
                f"a node of a graph in no space has no place, got {shortened(q)}; give Graph its "
                "nodes or space"
            )
        self._there.append(True)
        self.node_data.append(data)
        self._flat = None
        return self.size - 1

    def add_edge(self, u: int, v: int, weight: float | None = None, data: Any = None) -> None:
        """Add an edge from u to v, both ways unless directed. O(1) on average. Raises InvalidGraph.

        Its weight is by default 1, or the distance in an embedded graph. An edge that is there
        already gets a parallel one.
        """
        pair = np.array([[check_node(self, u, "u"), check_node(self, v, "v")]])
        cost = self._metric(pair) if weight is None else as_weights([weight], 1)
        self._edges.append(pair[0])
        self._weights.append(cost[0])
        self._edge_data.append(data)
        self._flat = None

    def delete_edge(self, u: int, v: int) -> None:
        """Delete the edge from u to v with its parallels; undirected, the other way too. O(m).
        InvalidGraph where there is none.
        """
        between = self._between(u, v)
        self._keep_edges(np.setdiff1d(np.arange(self._edges.count), between))

    def delete_node(self, u: int) -> None:
        """Delete a node and its edges; its number is not given again. O(n + m). Raises
        InvalidGraph.
        """
        self._there[check_node(self, u, "u")] = False
        self.node_data[u] = None
        self._keep_edges(np.flatnonzero((self._edges.rows != u).all(axis=1)))

    def neighbours(self, u: int) -> NDArray[np.int64]:
        """The nodes that an edge from u leads to, each once, in increasing order."""
        return np.unique(self.flat().neighbours(check_node(self, u, "u")))

    def degree(self, u: int) -> int:
        """How many edges leave u. Undirected, a loop counts twice, as it has two ends there. Raises
        InvalidGraph.
        """
        return len(self.flat().neighbours(check_node(self, u, "u")))

    def is_edge(self, u: int, v: int) -> bool:
        """Whether an edge leads from u to v. Raises InvalidGraph where either is no node."""
        return bool(
            (self.flat().neighbours(check_node(self, u, "u")) == check_node(self, v, "v")).any()
        )

    def weight(self, u: int, v: int) -> float:
        """The weight of the edge from u to v, of parallel ones the least. O(m). InvalidGraph where
        there is none.
        """
        return float(self._weights.rows[self._between(u, v)].min())

    def edge_data(self, u: int, v: int) -> Any:
        """What was given with the edge from u to v, of parallel ones with the least in weight.
        InvalidGraph where none is.
        """
        between = self._between(u, v)
        return self._edge_data[between[self._weights.rows[between].argmin()]]

    def components(self) -> list[NDArray[np.int64]]:
        """The connected components, each in increasing order, that of the least node first. O(n +
        m).

        Of a directed graph the weakly connected ones: as if its edges led both ways.
        """
        both_ways = flat_graph(self.size, self._edges.rows, self._weights.rows)
        labels = np.where(self._there, component_labels(both_ways, self.size), -1)
        order = np.argsort(labels, kind="stable")
        starts = np.searchsorted(labels[order], np.unique(labels[labels >= 0]))
        return np.split(order, starts)[1:]

    def distances(self, q: ArrayLike) -> Array:
        """From each node to q by the space's metric, (size,); infinite for deleted nodes.
        InvalidGraph, InvalidPoint.
        """
        nodes = self._embedding().rows
        return np.where(
            self._there,
            distances_from(self.space, nodes, as_node_place(q, nodes, self.space)),
            np.inf,
        )

    def closest(self, q: ArrayLike) -> tuple[int, float]:
        """The node closest to q, the first among equals, and its distance: on a board, the vertex
        that is picked.
        """
        if not len(self):
            raise InvalidGraph("a graph without nodes has none that is closest; add one first")
        apart = self.distances(q)
        return int(apart.argmin()), float(apart.min())

    def cost_to_go(self, goal: int) -> Array:
        """The least cost from each node to the goal, (size,), infinite where no path leads:
        Dijkstra backwards. InvalidGraph.
        """
        backwards = flat_graph(
            self.size, self._edges.rows[:, ::-1].copy(), self._weights.rows, directed=self.directed
        )
        return dijkstra(backwards, check_node(self, goal, "goal")).cost

    def adjacency(self, *, weighted: bool = True) -> Any:
        """A (size, size), scipy sparse: A[u, v] is the weight of the edge from u to v; see
        `matrices.adjacency_matrix`.

        The rows and columns of deleted nodes are zero; `A[list(graph)][:, list(graph)]` leaves them
        out.
        """
        return adjacency_matrix(
            self.size, self._edges.rows, self._costs(weighted), directed=self.directed
        )

    def incidence(self) -> Any:
        """B (size, m), scipy sparse: +1 where edge e leaves, -1 where it arrives; see
        `matrices.incidence_matrix`.
        """
        return incidence_matrix(self.size, self._edges.rows)

    def laplacian(self, *, weighted: bool = True) -> Any:
        """L = D - A (size, size), scipy sparse, with D the weights that leave each node; see
        `matrices.laplacian_matrix`.
        """
        return laplacian_matrix(self.adjacency(weighted=weighted))

    def flat(self) -> GraphRecord:
        """What searches run on; made when asked for, and kept until the graph changes. O(n + m)."""
        if self._flat is None:
            self._flat = flat_graph(
                self.size, self._edges.rows, self._weights.rows, directed=self.directed
            )
        return self._flat

    def _embedding(self) -> Rows:
        if self._places is None:
            raise InvalidGraph(
                "this graph is in no space, so it knows no places or distances; give Graph its "
                "nodes"
            )
        return self._places

    def _metric(self, pairs: NDArray[np.int64]) -> Array:
        """The weights (m,) that edges have where none are given."""
        if self._places is None:
            return np.ones(len(pairs))
        return as_weights(edge_lengths(self.space, self._places.rows, pairs), len(pairs))

    def _costs(self, weighted: bool) -> Array:
        return self._weights.rows if weighted else np.ones(self._edges.count)

    def _between(self, u: int, v: int) -> NDArray[np.int64]:
        """The numbers of the edges from u to v; InvalidGraph where there are none."""
        pair, edges = [check_node(self, u, "u"), check_node(self, v, "v")], self._edges.rows
        same = (edges == pair).all(axis=1)
        if not self.directed:
            same |= (edges == pair[::-1]).all(axis=1)
        if not same.any():
            raise InvalidGraph(f"there is no edge from {u} to {v}")
        return np.flatnonzero(same)

    def _keep_edges(self, kept: NDArray[np.int64]) -> None:
        self._edges, self._weights = Rows(self._edges.rows[kept]), Rows(self._weights.rows[kept])
        self._edge_data = [self._edge_data[e] for e in kept]
        self._flat = None


@searchable.register
def _(graph: Graph) -> GraphRecord:
    return graph.flat()


@check_node.register
def _(graph: Graph, u: Any, name: str) -> int:
    if u not in graph:
        gone = isinstance(u, int | np.integer) and not isinstance(u, bool) and 0 <= u < graph.size
        have = f"from 0 to {graph.size - 1}" if len(graph) else "of the graph, and it has none"
        raise InvalidGraph(
            f"{name} must be a node {have}, got "
            f"{shortened(u)}{', which was deleted' if gone else ''}"
        )
    return int(u)
