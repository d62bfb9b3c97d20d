"""Checks of what a graph is built from: valid input becomes arrays, other input a named error."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm
from ..errors import InvalidGraph, InvalidPoint
from ..geometry.checks import Array, as_array, is_integer
from ..spaces import RealSpace, distance
from ..spaces.interface import Space
from ..support.text import shortened

HEAVIEST = 1e200  # of weights: the cost of no path is infinite


class Rows:
    """An array that grows by one row at a time, in O(1) on average.

    The capacity is doubled when it runs out.

    Examples
    --------
    >>> numbers = Rows(np.array([1.0]))
    >>> numbers.append(2.0)
    >>> numbers.rows
    array([1., 2.])
    """

    def __init__(self, rows: NDArray[Any]) -> None:
        self.room, self.count = rows, len(rows)

    @property
    def rows(self) -> NDArray[Any]:
        """The rows that have been added, a view."""
        return self.room[: self.count]

    def append(self, row: object) -> None:
        """Add one row at the end."""
        if self.count == len(self.room):
            self.room = np.concatenate(
                [self.room, np.empty((max(4, self.count), *self.room.shape[1:]), self.room.dtype)]
            )
        self.room[self.count] = row
        self.count += 1


def as_size(size: object, places: int | None) -> int:
    """The number of nodes, from `size` and from the number of given positions.

    Raises
    ------
    InvalidGraph
        Where `size` is not 0, 1, 2, ..., or differs from the number of positions.
    """
    if size is None:
        return places or 0
    if not is_integer(size) or size < 0:
        raise InvalidGraph(
            f"size must be how many nodes there are, 0, 1, 2, ..., got {shortened(size)}; give "
            "positions as nodes="
        )
    if places is not None and size != places:
        raise InvalidGraph(
            f"{size} nodes need as many positions, got {places}; size may be left out"
        )
    return int(size)


def as_edges(edges: ArrayLike, size: int) -> NDArray[np.int64]:
    """Edges as an array of node numbers, shape (m, 2).

    Raises
    ------
    InvalidGraph
        Where they are not pairs of whole numbers from 0 to size - 1.
    """
    given = as_regular_array(edges, "edges must be pairs of nodes, shape (m, 2)")
    if given.size == 0 and given.ndim <= 2:
        return np.empty((0, 2), np.int64)
    if given.ndim != 2 or given.shape[1] != 2 or not holds_integers(given):
        raise InvalidGraph(
            f"edges must be pairs of whole numbers, shape (m, 2), got shape {given.shape} of "
            f"{given.dtype}"
        )
    if size == 0:
        raise InvalidGraph("a graph without nodes has no edges; give size= or nodes=")
    if not (0 <= given.min() and given.max() < size):
        wrong = given[((given < 0) | (given >= size)).any(axis=1)][0].tolist()
        raise InvalidGraph(f"edges must name nodes 0 to {size - 1}, got {tuple(wrong)}")
    return given.astype(np.int64, order="C")


def holds_integers(array: NDArray[Any]) -> bool:
    """Whether all numbers of an array are integers, as such or as floats below 2^53."""
    if array.dtype.kind == "f":
        return bool((np.abs(array) < 2.0**53).all() and (array % 1 == 0).all())
    return array.dtype.kind in "iu"


def as_weights(weights: ArrayLike, count: int) -> Array:
    """Weights as an array, shape (m,), one for each edge.

    Raises
    ------
    InvalidGraph
        Where they are not `count` numbers from zero to 1e200, whose sums are finite.
    """
    given = as_regular_array(weights, "weights must be numbers, one for each edge")
    if given.size and given.dtype.kind not in "iuf":
        raise InvalidGraph(f"weights must be numbers, one for each edge, got {shortened(weights)}")
    if given.shape != (count,):
        raise InvalidGraph(f"{count} edges need as many weights, got shape {given.shape}")
    bad = ~((given >= 0) & (given <= HEAVIEST))
    if bad.any():
        raise InvalidGraph(f"weights must be from zero to {HEAVIEST:g}, got {given[bad][0]:g}")
    return given.astype(np.float64)


def as_regular_array(value: ArrayLike, expected: str) -> NDArray[Any]:
    """Convert to an array; raises InvalidGraph where rows differ in length."""
    try:
        return np.asarray(value)
    except (TypeError, ValueError):
        raise InvalidGraph(
            f"{expected}, got rows of different lengths: {shortened(value)}"
        ) from None


def as_node_places(nodes: ArrayLike, space: Any) -> Array:
    """The positions of nodes, shape (n, d), with the dimension of the space.

    Where there are no nodes and no dimension is given, d is 2.

    Raises
    ------
    InvalidPoint
        Where they are not points of that dimension.
    """
    places = as_array(nodes, "nodes")
    d = len(space.lo) if hasattr(space, "lo") else None
    if places.size == 0 and places.ndim <= 2:
        return np.empty((0, d or (places.shape[1] if places.ndim == 2 else 2)))
    if places.ndim != 2 or (d is not None and places.shape[1] != d):
        raise InvalidPoint(f"nodes must be points, shape (n, {d or 'd'}), got {places.shape}")
    return np.ascontiguousarray(places)


def as_node_place(q: ArrayLike | None, nodes: Array) -> Array:
    """The position of one new node, shape (d,), beside nodes (n, d).

    Raises
    ------
    InvalidPoint
        Where it is missing, or is not a point of that dimension.
    """
    if q is None:
        raise InvalidPoint("a node of an embedded graph needs its position q")
    place = as_array(q, "q")
    if place.shape != nodes.shape[1:]:
        raise InvalidPoint(
            f"q must be {nodes.shape[1]} numbers, as the nodes of this graph are, got "
            f"{shortened(q)}"
        )
    return place


def unbounded_space(d: int) -> RealSpace:
    """R^d without bounds, used for its distance only."""
    return RealSpace(np.full(d, -np.inf), np.full(d, np.inf))


@algorithm
def edge_lengths(space: Space | None, nodes: Array, edges: NDArray[np.int64]) -> Array:
    """The distance between the ends of each edge (m, 2) by the space's metric, shape (m,)."""
    lengths = np.empty(len(edges))
    for e in range(len(edges)):
        lengths[e] = distance(space, nodes[edges[e, 0]], nodes[edges[e, 1]])
    return lengths


@algorithm
def compute_distances(space: Space | None, nodes: Array, q: Array) -> Array:
    """The distance from each node (n, d) to q by the space's metric, shape (n,)."""
    apart = np.empty(len(nodes))
    for i in range(len(nodes)):
        apart[i] = distance(space, nodes[i], q)
    return apart
