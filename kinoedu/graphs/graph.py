"""Graphs that can be built at once or grown: numbered nodes, with or without positions.

The number of a node never changes. After `delete_node` the other nodes keep their numbers, and the
number of the deleted node is refused with an error. So arrays that a reader keeps beside a graph
(parents, costs, a picture) stay valid.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, TypeGuard

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidGraph
from ..geometry.checks import Array, is_integer
from ..spaces.interface import Space
from ..support.text import shortened
from .checks import (
    Rows,
    as_edges,
    as_node_place,
    as_node_places,
    as_size,
    as_weights,
    compute_distances,
    edge_lengths,
    unbounded_space,
)
from .components import label_components
from .flat import GraphRecord, as_searchable, check_node, flat_graph
from .matrices import adjacency_matrix, incidence_matrix, laplacian_matrix
from .search import dijkstra

if TYPE_CHECKING:
    from scipy.sparse import csr_array


class Graph:
    """A graph of nodes numbered from 0.

    `len(graph)` counts the nodes; `for u in graph` and `u in graph` use their numbers. `size`
    counts all numbers ever given, and is the length of every array with an entry for each node.
    `node_data` is a list of that length, for the reader's own data.

    Parameters
    ----------
    size : how many nodes; may be left out where `nodes` are given.
    edges : (m, 2) pairs of nodes; each leads both ways unless `directed`. Loops and parallel edges
        are allowed.
    weights : (m,) numbers, zero or more. By default they are 1, or in an embedded graph the
        distances between the ends of the edges.
    nodes : (n, d) positions of the nodes; they make the graph embedded.
    space : a space of `kinoedu.spaces`, for its distance; Euclidean by default.

    Raises
    ------
    InvalidGraph
        Where an edge names a node that does not exist, or a weight is negative, infinite or not a
        number.
    InvalidPoint
        Where `nodes` are not points of the space.

    Examples
    --------
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
        space: Space | None = None,
        directed: bool = False,
    ) -> None:
        places = None
        if nodes is not None or space is not None:
            places = as_node_places(() if nodes is None else nodes, space)
        count = as_size(size, None if places is None else len(places))
        pairs = as_edges(edges, count)
        self.directed = bool(directed)
        self.space = space
        if places is not None and space is None:
            self.space = unbounded_space(places.shape[1])
        self.node_data: list[Any] = [None] * count
        self._there = [True] * count
        self._places = None if places is None else Rows(places)
        self._edges = Rows(pairs)
        given = self._metric(pairs) if weights is None else as_weights(weights, len(pairs))
        self._weights = Rows(given)
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
        return self._is_number(u) and bool(self._there[u])

    @property
    def size(self) -> int:
        """How many numbers have been given to nodes."""
        return len(self._there)

    @property
    def nodes(self) -> Array:
        """The positions of the nodes, (size, d), also of deleted ones; a copy.

        Raises
        ------
        InvalidGraph
            Where the graph is not embedded.
        """
        return self._embedding().rows.copy()

    @property
    def edges(self) -> NDArray[np.int64]:
        """The edges, (m, 2), in the order in which they were added; a copy."""
        return self._edges.rows.copy()

    @property
    def weights(self) -> Array:
        """The weights of the edges, (m,); a copy."""
        return self._weights.rows.copy()

    def add_node(self, q: ArrayLike | None = None, data: object = None) -> int:
        """Add a node, at position q (d,) in an embedded graph. O(1) on average.

        Returns
        -------
        The number of the new node.

        Raises
        ------
        InvalidGraph
            Where q is given, but the graph is not embedded.
        InvalidPoint
            Where the graph is embedded, and q is missing or not a point of its space.
        """
        if self._places is not None:
            self._places.append(as_node_place(q, self._places.rows))
        elif q is not None:
            raise InvalidGraph(
                f"a node of this graph has no position, got {shortened(q)}; give Graph its nodes "
                "or space"
            )
        self._there.append(True)
        self.node_data.append(data)
        self._flat = None
        return self.size - 1

    def add_edge(self, u: int, v: int, weight: float | None = None, data: object = None) -> None:
        """Add an edge from u to v, in both directions unless directed. O(1) on average.

        By default its weight is 1, or the distance between its ends in an embedded graph. Where
        there is an edge from u to v already, the new one is parallel to it.

        Raises
        ------
        InvalidGraph
            Where u or v is not a node, or the weight is negative, infinite or not a number.
        """
        pair = np.array([[check_node(self, u, "u"), check_node(self, v, "v")]])
        cost = self._metric(pair) if weight is None else as_weights([weight], 1)
        self._edges.append(pair[0])
        self._weights.append(cost[0])
        self._edge_data.append(data)
        self._flat = None

    def delete_edge(self, u: int, v: int) -> None:
        """Delete the edge from u to v and its parallels; undirected, also those from v to u. O(m).

        Raises
        ------
        InvalidGraph
            Where there is no such edge.
        """
        self._keep_edges(np.delete(np.arange(self._edges.count), self._between(u, v)))

    def delete_node(self, u: int) -> None:
        """Delete a node and its edges; its number is never given again. O(n + m).

        Raises
        ------
        InvalidGraph
            Where u is not a node.
        """
        self._there[check_node(self, u, "u")] = False
        self.node_data[u] = None
        self._keep_edges(np.flatnonzero((self._edges.rows != u).all(axis=1)))

    def neighbours(self, u: int) -> NDArray[np.int64]:
        """The nodes that edges from u lead to, each once, in increasing order.

        Raises
        ------
        InvalidGraph
            Where u is not a node.
        """
        return np.unique(self.flat().neighbours(check_node(self, u, "u")))

    def degree(self, u: int) -> int:
        """The number of edges that leave u; in an undirected graph a loop counts twice.

        Raises
        ------
        InvalidGraph
            Where u is not a node.
        """
        return len(self.flat().neighbours(check_node(self, u, "u")))

    def is_edge(self, u: int, v: int) -> bool:
        """Whether an edge leads from u to v.

        Raises
        ------
        InvalidGraph
            Where u or v is not a node.
        """
        return bool(
            (self.flat().neighbours(check_node(self, u, "u")) == check_node(self, v, "v")).any()
        )

    def weight(self, u: int, v: int) -> float:
        """The weight of the edge from u to v, the least one of parallel edges. O(m).

        Raises
        ------
        InvalidGraph
            Where there is no such edge.
        """
        return float(self._weights.rows[self._between(u, v)].min())

    def edge_data(self, u: int, v: int) -> Any:
        """The data of the edge from u to v, of parallel edges that of the least weight.

        Raises
        ------
        InvalidGraph
            Where there is no such edge.
        """
        between = self._between(u, v)
        return self._edge_data[between[self._weights.rows[between].argmin()]]

    def components(self) -> list[NDArray[np.int64]]:
        """The connected components, each sorted, in the order of their least nodes.

        For a directed graph the weakly connected components, as if its edges led both ways.
        O(m + n log n).
        """
        both_ways = flat_graph(self.size, self._edges.rows, self._weights.rows)
        labels = np.where(self._there, label_components(both_ways, self.size), -1)
        order = np.argsort(labels, kind="stable")
        starts = np.searchsorted(labels[order], np.unique(labels[labels >= 0]))
        return np.split(order, starts)[1:]

    def distances(self, q: ArrayLike) -> Array:
        """The distance from each node to q by the metric of the space; infinite for deleted nodes.

        Returns
        -------
        (size,) array.

        Raises
        ------
        InvalidGraph
            Where the graph is not embedded.
        InvalidPoint
            Where q is not a point of its space.
        """
        nodes = self._embedding().rows
        apart = compute_distances(self.space, nodes, as_node_place(q, nodes))
        return np.where(self._there, apart, np.inf)

    def closest(self, q: ArrayLike) -> tuple[int, float]:
        """The node closest to q and its distance; ties go to the least number.

        On a board this is the vertex that is picked.

        Raises
        ------
        InvalidGraph
            Where the graph has no nodes, or is not embedded.
        InvalidPoint
            Where q is not a point of its space.
        """
        if not len(self):
            raise InvalidGraph("a graph without nodes has none that is closest; add one first")
        apart = self.distances(q)
        return int(apart.argmin()), float(apart.min())

    def cost_to_go(self, goal: int) -> Array:
        """The least cost from each node to the goal, by Dijkstra's algorithm on the reversed edges.

        Returns
        -------
        (size,) array, infinite where no path leads to the goal.

        Raises
        ------
        InvalidGraph
            Where the goal is not a node.
        """
        backwards = flat_graph(
            self.size, self._edges.rows[:, ::-1].copy(), self._weights.rows, directed=self.directed
        )
        return dijkstra(backwards, check_node(self, goal, "goal")).cost

    def adjacency(self, *, weighted: bool = True) -> csr_array:
        """The adjacency matrix A (size, size), scipy sparse; see `matrices.adjacency_matrix`.

        The rows and columns of deleted nodes are zero; `A[list(graph)][:, list(graph)]` leaves them
        out.
        """
        return adjacency_matrix(
            self.size, self._edges.rows, self._costs(weighted), directed=self.directed
        )

    def incidence(self) -> csr_array:
        """The incidence matrix B (size, m), scipy sparse; see `matrices.incidence_matrix`."""
        return incidence_matrix(self.size, self._edges.rows)

    def laplacian(self, *, weighted: bool = True) -> csr_array:
        """The Laplacian L = D - A (size, size), scipy sparse; see `matrices.laplacian_matrix`."""
        return laplacian_matrix(self.adjacency(weighted=weighted))

    def flat(self) -> GraphRecord:
        """The record on which searches run; it is kept until the graph changes. O(n + m)."""
        if self._flat is None:
            self._flat = flat_graph(
                self.size, self._edges.rows, self._weights.rows, directed=self.directed
            )
        return self._flat

    def _embedding(self) -> Rows:
        if self._places is None:
            raise InvalidGraph(
                "this graph has no positions, and so no distances; give Graph its nodes"
            )
        return self._places

    def _metric(self, pairs: NDArray[np.int64]) -> Array:
        """The default weights of edges, (m,)."""
        if self._places is None:
            return np.ones(len(pairs))
        return as_weights(edge_lengths(self.space, self._places.rows, pairs), len(pairs))

    def _costs(self, weighted: bool) -> Array:
        return self._weights.rows if weighted else np.ones(self._edges.count)

    def _between(self, u: int, v: int) -> NDArray[np.int64]:
        """The numbers of the edges from u to v; raises InvalidGraph where there are none."""
        pair, edges = [check_node(self, u, "u"), check_node(self, v, "v")], self._edges.rows
        same = (edges == pair).all(axis=1)
        if not self.directed:
            same |= (edges == pair[::-1]).all(axis=1)
        if not same.any():
            raise InvalidGraph(f"there is no edge from {u} to {v}")
        return np.flatnonzero(same)

    def _is_number(self, u: object) -> TypeGuard[int]:
        """Whether u is the number of a node, which may have been deleted."""
        return is_integer(u) and bool(0 <= u < self.size)

    def _keep_edges(self, rows: NDArray[np.int64]) -> None:
        self._edges, self._weights = Rows(self._edges.rows[rows]), Rows(self._weights.rows[rows])
        self._edge_data = [self._edge_data[e] for e in rows]
        self._flat = None


@as_searchable.register
def _(graph: Graph) -> GraphRecord:
    return graph.flat()


@check_node.register
def _(graph: Graph, u: Any, name: str) -> int:
    if u not in graph:
        have = f"from 0 to {graph.size - 1}" if len(graph) else "of the graph, and it has none"
        deleted = ", which was deleted" if graph._is_number(u) else ""
        raise InvalidGraph(f"{name} must be a node {have}, got {shortened(u)}{deleted}")
    return int(u)
