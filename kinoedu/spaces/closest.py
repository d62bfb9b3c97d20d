"""The k nodes nearest to each node of a set, found by a tree's buckets."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm
from ..geometry.checks import Array
from .buckets import GrowingTree, add
from .interface import Space
from .rings import search_near, squared_distance, squared_radius, visit_bucket

STRIP = 32  # columns of buckets


class Closest(NamedTuple):
    """A search for the k nodes nearest to node `itself`, which is excluded.

    found[itself] lists them in order of distance, and `squared` their squared distances.
    """

    itself: int
    found: NDArray[np.int64]
    squared: Array


@visit_bucket.register(Closest)
def visit_for_closest(
    search: Closest, space: Space, tree: GrowingTree, bucket: int, q: Array
) -> Closest:
    """Insert the bucket's nodes among those found; ties go to the first."""
    found, apart, u = search.found, search.squared, search.itself
    k = len(apart)
    node = tree.head[bucket]
    while node >= 0:
        d = squared_distance(space, tree.nodes, node, q)
        is_closer = d < apart[k - 1] or (d == apart[k - 1] and node < found[u, k - 1])
        if node != u and is_closer:
            i = k - 1  # insertion sort by distance, then by index
            while i > 0 and (d < apart[i - 1] or (d == apart[i - 1] and node < found[u, i - 1])):
                apart[i], found[u, i] = apart[i - 1], found[u, i - 1]
                i -= 1
            apart[i], found[u, i] = d, node
        node = tree.next[node]
    return search


@squared_radius.register(Closest)
def kth_squared_distance(search: Closest) -> float:
    """The squared distance of the k-th node found."""
    return search.squared[len(search.squared) - 1]


@algorithm
def add_nodes(tree: GrowingTree, nodes: Array) -> None:
    """Put nodes (n, d) into the tree's buckets, without parents."""
    for node in nodes:
        add(tree, node, -1)


@algorithm
def list_by_bucket(tree: GrowingTree) -> NDArray[np.int64]:
    """The nodes of a tree, (n,), bucket by bucket, in strips of `STRIP` columns.

    Strips are so narrow that a processor's cache holds a few rows of one.
    """
    order, size = np.empty(tree.size[0], np.int64), 0
    for left in range(0, tree.columns, STRIP):
        for row in range(tree.rows):
            for column in range(left, min(left + STRIP, tree.columns)):
                node = tree.head[row * tree.columns + column]
                while node >= 0:
                    order[size] = node
                    size += 1
                    node = tree.next[node]
    return order


@algorithm
def k_closest_in_buckets(space: Space, tree: GrowingTree, k: int) -> NDArray[np.int64]:
    """The k nodes nearest to each node, in order of distance, without the node itself.

    Ties go to the first. The result has shape (n, k), k < n. The nodes are visited bucket by
    bucket: most of the memory that a search reads was read by the search before it.
    """
    found, apart = np.zeros((tree.size[0], k), np.int64), np.empty(k)
    for u in list_by_bucket(tree):
        apart[:] = np.inf
        search_near(space, tree, tree.nodes[u], Closest(u, found, apart))
    return found
