"""A search for nodes near a place, through a tree's buckets, ring by ring around the place.

It ends when no farther ring can hold a node that is wanted. The nodes found so far are a record,
the *search*. It visits each bucket at most once and returns an updated record, and it knows the
distance beyond which nodes are not wanted. Each kind of space defines its distance.
"""

from typing import Any, NamedTuple

import numpy as np

from ..compiled import compiled, generic, inlined
from ..geometry.checks import Array
from .buckets import GrowingTree, bucket_of, first_ring
from .euclidean import SMALL
from .interface import Space


@generic(1)
def squared_distance(space: Space, nodes: Array, node: int, q: Array) -> float:
    """The squared distance between nodes[node] and q."""
    raise TypeError("this space has no squared distance for a search by buckets")


@generic(1)
def coordinate_weight(space: Space, i: int) -> float:
    """The weight of coordinate i in the distance."""
    return 1.0


@generic(1)
def visit_bucket(search: Any, space: Space, tree: GrowingTree, bucket: int, q: Array) -> Any:
    """The search record after the nodes of one bucket."""
    raise TypeError("this search cannot visit buckets")


@generic(1)
def squared_radius(search: Any) -> float:
    """The squared distance beyond which nodes are not wanted."""
    raise TypeError("this search has no radius")


class Nearest(NamedTuple):
    """A search for the nearest node, by the best node so far; ties go to the first."""

    node: int
    squared: float


@visit_bucket.register(Nearest)
def visit_for_nearest(
    search: Nearest, space: Space, tree: GrowingTree, bucket: int, q: Array
) -> Nearest:
    """The better of the best node so far and the bucket's nodes."""
    best, least = search.node, search.squared
    node = tree.head[bucket]
    while node >= 0:
        squared = squared_distance(space, tree.nodes, node, q)
        if squared < least or (squared == least and node < best):
            best, least = node, squared
        node = tree.next[node]
    return Nearest(best, least)


@squared_radius.register(Nearest)
def best_squared_distance(search: Nearest) -> float:
    """The squared distance of the best node so far."""
    return search.squared


@inlined
def search_rings(
    space: Space, tree: GrowingTree, q: Array, x: float, y: float, part: Any, search: Any
) -> Any:
    """The search record after all wanted nodes near q in a part of the buckets.

    The centre (x, y) of the rings is equivalent to the first two coordinates of q. The part is its
    first and last column and its first and last row, as in `tree.used`.
    """
    wx, wy = coordinate_weight(space, 0), coordinate_weight(space, 1)
    column, row = bucket_of(tree, x, y)
    first = first_ring(part, column, row)
    if first <= 0:
        search = visit_bucket(search, space, tree, row * tree.columns + column, q)
    for ring in range(max(first, 1), max(tree.columns, tree.rows)):
        below = squared_gap(y - tree.y, row - ring, tree.cell, wy)
        above = squared_gap(y - tree.y, row + ring, tree.cell, wy)
        left = squared_gap(x - tree.x, column - ring, tree.cell, wx)
        right = squared_gap(x - tree.x, column + ring, tree.cell, wx)
        if squared_radius(search) < min(min(below, above), min(left, right)):
            break
        for j, gap in ((row - ring, below), (row + ring, above)):
            if part[2] <= j <= part[3] and gap <= squared_radius(search):
                for i in range(max(column - ring, part[0]), min(column + ring, part[1]) + 1):
                    search = visit_bucket(search, space, tree, j * tree.columns + i, q)
        for i, gap in ((column - ring, left), (column + ring, right)):
            if part[0] <= i <= part[1] and gap <= squared_radius(search):
                for j in range(max(row - ring + 1, part[2]), min(row + ring - 1, part[3]) + 1):
                    search = visit_bucket(search, space, tree, j * tree.columns + i, q)
    return search


@compiled
def squared_gap(offset: float, number: int, cell: float, weight: float) -> float:
    """The squared, weighted distance of a coordinate from a column or row of buckets.

    It is reduced slightly to allow for rounding.
    """
    gap = max(max(number * cell - offset, offset - (number + 1) * cell) - 1e-9 * cell, 0.0) * weight
    return gap * gap


@generic(1)
def search_near(space: Space, tree: GrowingTree, q: Array, search: Any) -> Any:
    """The search record after all wanted nodes near q."""
    return search_rings(space, tree, q, q[0], q[1] if len(q) > 1 else 0.0, tree.used, search)


@inlined
def nearest_in_buckets(space: Space, tree: GrowingTree, q: Array) -> int:
    """The index of the node with the least distance to q; ties go to the first."""
    if tree.size[0] <= SMALL:
        return nearest_of_all(space, tree, q)
    return search_near(space, tree, q, Nearest(tree.size[0], np.inf)).node


@inlined
def nearest_of_all(space: Space, tree: GrowingTree, q: Array) -> int:
    """`nearest_in_buckets` by comparing every node."""
    best, least = 0, np.inf
    for node in range(tree.size[0]):
        squared = squared_distance(space, tree.nodes, node, q)
        if squared < least:
            best, least = node, squared
    return best
