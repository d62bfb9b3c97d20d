"""Where the parts of a graph enter: lists become checked arrays that can grow, or a named error
says what is wrong with them.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm
from ..errors import InvalidGraph, InvalidPoint
from ..geometry.checks import Array, as_array
from ..spaces import RealSpace, distance
from ..support.text import shortened


class Rows:
    """An array that grows by a row at a time, in O(1) on average: room is doubled when it runs out.

    >>> numbers = Rows(np.array([1.0]))
    >>> numbers.append(2.0)
    >>> numbers.rows
    array([1., 2.])
    """

    def __init__(self, rows: NDArray[Any]) -> None:
        self.room, self.count = rows, len(rows)

    @property
    def rows(self) -> NDArray[Any]:
        """Those that are there."""
        return self.room[: self.count]

    def append(self, row: Any) -> None:
        """Add one at the end."""
        if self.count == len(self.room):
            self.room = np.concatenate(
                [self.room, np.empty((max(4, self.count), *self.room.shape[1:]), self.room.dtype)]
            )
        self.room[self.count] = row
        self.count += 1


def as_size(size: Any, places: int | None) -> int:
    """How many nodes there are, from what was said and from the nodes given, which must agree;
    InvalidGraph otherwise.
    """
    if size is None:
        return places or 0
    if isinstance(size, bool) or not isinstance(size, int | np.integer) or size < 0:
        raise InvalidGraph(
            f"size must be how many nodes there are, 0, 1, 2, ..., got {shortened(size)}; places "
            "go in as nodes="
        )
    if places is not None and size != places:
        raise InvalidGraph(f"{size} nodes need as many places, got {places}; size may be left out")
    return int(size)


def as_edges(edges: ArrayLike, size: int) -> NDArray[np.int64]:
    """Edges as whole numbers of shape (m, 2), each a node of the graph; InvalidGraph otherwise."""
    given = as_regular(edges, "edges must be pairs of nodes, shape (m, 2)")
    if given.size == 0 and given.ndim <= 2:
        return np.empty((0, 2), np.int64)
    whole = given.dtype.kind in "iu" or (
        given.dtype.kind == "f" and (np.abs(given) < 2.0**53).all() and (given % 1 == 0).all()
    )
    if given.ndim != 2 or given.shape[1] != 2 or not whole:
        raise InvalidGraph(
            f"edges must be pairs of whole numbers, shape (m, 2), got shape {given.shape} of "
            f"{given.dtype}"
        )
    if not (0 <= given.min() and given.max() < size):
        wrong = given[((given < 0) | (given >= size)).any(axis=1)][0].tolist()
        raise InvalidGraph(f"edges must name nodes 0 to {size - 1}, got {tuple(wrong)}")
    return given.astype(np.int64, order="C")


def as_weights(weights: ArrayLike, count: int) -> Array:
    """Weights (m,), one for each edge: finite and zero or more; InvalidGraph otherwise."""
    given = as_regular(weights, "weights must be numbers, one for each edge")
    if given.size and given.dtype.kind not in "iuf":
        raise InvalidGraph(f"weights must be numbers, one for each edge, got {shortened(weights)}")
    if given.shape != (count,):
        raise InvalidGraph(f"{count} edges need as many weights, got shape {given.shape}")
    bad = ~((given >= 0) & (given < np.inf))
    if bad.any():
        raise InvalidGraph(f"weights must be zero or more, and finite, got {given[bad][0]:g}")
    return given.astype(np.float64)


def as_regular(value: ArrayLike, expected: str) -> NDArray[Any]:
    """An array; InvalidGraph where rows differ in length."""
    try:
        return np.asarray(value)
    except (TypeError, ValueError):
        raise InvalidGraph(
            f"{expected}, got rows of different lengths: {shortened(value)}"
        ) from None


def as_node_places(nodes: ArrayLike, space: Any) -> Array:
    """Where nodes are, shape (n, d), with the d of the space; none at all are in the plane.
    InvalidPoint otherwise.
    """
    places = as_array(nodes, "nodes")
    d = len(space.lo) if hasattr(space, "lo") else None
    if places.size == 0 and places.ndim <= 2:
        return np.empty((0, d or (places.shape[1] if places.ndim == 2 else 2)))
    if places.ndim != 2 or (d is not None and places.shape[1] != d):
        raise InvalidPoint(f"nodes must be points, shape (n, {d or 'd'}), got {places.shape}")
    return np.ascontiguousarray(places)


def as_node_place(q: ArrayLike | None, nodes: Array, space: Any) -> Array:
    """One place (d,) among nodes (n, d); InvalidPoint otherwise."""
    if q is None:
        raise InvalidPoint("a node of an embedded graph needs its place q")
    place = as_array(q, "q")
    if place.shape != nodes.shape[1:]:
        raise InvalidPoint(
            f"q must be {nodes.shape[1]} numbers, as the nodes of this graph are, got "
            f"{shortened(q)}"
        )
    return place


def everywhere(d: int) -> RealSpace:
    """R^d without bounds, for its distance."""
    return RealSpace(np.full(d, -np.inf), np.full(d, np.inf))


def distances_from(space: Any, nodes: Array, q: Array) -> Array:
    """The distance from each node (n, d) to q by the space's metric, shape (n,)."""
    return ask_distances(space, nodes, q)


def edge_lengths(space: Any, nodes: Array, edges: NDArray[np.int64]) -> Array:
    """The distance between the ends of each edge (m, 2), shape (m,)."""
    return ask_lengths(space, nodes, edges)


@algorithm
def ask_lengths(space: Any, nodes: Array, edges: NDArray[np.int64]) -> Array:
    """One after another."""
    lengths = np.empty(len(edges))
    for e in range(len(edges)):
        lengths[e] = distance(space, nodes[edges[e, 0]], nodes[edges[e, 1]])
    return lengths


@algorithm
def ask_distances(space: Any, nodes: Array, q: Array) -> Array:
    """One after another."""
    apart = np.empty(len(nodes))
    for i in range(len(nodes)):
        apart[i] = distance(space, nodes[i], q)
    return apart
