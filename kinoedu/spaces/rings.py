"""The nodes near a place, by the buckets of a tree: ring by ring round the place, until no farther
ring can hold a nearer node.

What is looked for is a record, the *search*: it is offered buckets of nodes, returns itself as it
then is, and knows how far away a node may still be wanted. How the distance is measured is the
space's answer.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compiled import compiled, generic, inlined
from ..geometry.checks import Array
from .buckets import GrowingTree, bucket_of, first_ring
from .euclidean import SMALL


@generic(1)
def squared_distance(space: Any, nodes: Array, node: int, q: Array) -> float:
    """The square of the distance between nodes[node] and q."""
    raise TypeError("this space has no distance that buckets can be searched by")


@generic(1)
def weight_of(space: Any, i: int) -> float:
    """What a unit of coordinate i counts in the distance."""
    return 1.0


@generic(1)
def offer_bucket(search: Any, space: Any, tree: GrowingTree, bucket: int, q: Array) -> Any:
    """The search after it was offered the nodes of one bucket."""
    raise TypeError("this search cannot be offered nodes")


@generic(1)
def squared_reach(search: Any) -> float:
    """The squared distance beyond which nodes are not wanted any more."""
    raise TypeError("this search has no reach")


class Nearest(NamedTuple):
    """The search for the nearest node, the first among equals: the best so far."""

    node: int
    squared: float


@offer_bucket.register(Nearest)
def the_nearest_of(
    search: Nearest, space: Any, tree: GrowingTree, bucket: int, q: Array
) -> Nearest:
    """The better of the best so far and the bucket's nodes."""
    best, least = search.node, search.squared
    node = tree.head[bucket]
    while node >= 0:
        squared = squared_distance(space, tree.nodes, node, q)
        if squared < least or (squared == least and node < best):
            best, least = node, squared
        node = tree.next[node]
    return Nearest(best, least)


@squared_reach.register(Nearest)
def to_the_best(search: Nearest) -> float:
    """As far as the best one is."""
    return search.squared


@inlined
def search_rings(space: Any, tree: GrowingTree, q: Array, x: float, y: float, search: Any) -> Any:
    """The search after all wanted nodes near q were offered; q's first coordinates are x and y, or
    mean the same as they.
    """
    wx, wy = weight_of(space, 0), weight_of(space, 1)
    used = tree.used
    column, row = bucket_of(tree, x, y)
    search = offer_bucket(search, space, tree, row * tree.columns + column, q)
    for ring in range(max(first_ring(tree, column, row), 1), max(tree.columns, tree.rows)):
        below, above = (
            squared_gap(y - tree.y, row - ring, tree.cell, wy),
            squared_gap(y - tree.y, row + ring, tree.cell, wy),
        )
        left, right = (
            squared_gap(x - tree.x, column - ring, tree.cell, wx),
            squared_gap(x - tree.x, column + ring, tree.cell, wx),
        )
        if squared_reach(search) < min(min(below, above), min(left, right)):
            break
        for j, gap in ((row - ring, below), (row + ring, above)):
            if used[2] <= j <= used[3] and gap <= squared_reach(search):
                for i in range(max(column - ring, used[0]), min(column + ring, used[1]) + 1):
                    search = offer_bucket(search, space, tree, j * tree.columns + i, q)
        for i, gap in ((column - ring, left), (column + ring, right)):
            if used[0] <= i <= used[1] and gap <= squared_reach(search):
                for j in range(max(row - ring + 1, used[2]), min(row + ring - 1, used[3]) + 1):
                    search = offer_bucket(search, space, tree, j * tree.columns + i, q)
    return search


@compiled
def squared_gap(offset: float, number: int, cell: float, weight: float) -> float:
    """The square of how far a coordinate is from a column or row of buckets, less a little for
    rounding.
    """
    gap = max(max(number * cell - offset, offset - (number + 1) * cell) - 1e-9 * cell, 0.0) * weight
    return gap * gap


@generic(1)
def search_near(space: Any, tree: GrowingTree, q: Array, search: Any) -> Any:
    """The search after all wanted nodes near q were offered."""
    return search_rings(space, tree, q, q[0], q[1] if len(q) > 1 else 0.0, search)


@inlined
def nearest_in_buckets(space: Any, tree: GrowingTree, q: Array) -> int:
    """The number of the node with the least distance to q, the first among equals."""
    if tree.size[0] <= SMALL:
        return nearest_of_all(space, tree, q)
    return search_near(space, tree, q, Nearest(tree.size[0], np.inf)).node


@inlined
def nearest_of_all(space: Any, tree: GrowingTree, q: Array) -> int:
    """The same by looking at every node."""
    best, least = 0, np.inf
    for node in range(tree.size[0]):
        squared = squared_distance(space, tree.nodes, node, q)
        if squared < least:
            best, least = node, squared
    return best
