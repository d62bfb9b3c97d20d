"""The k nodes closest to each node of a set, by the buckets of a tree."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm
from ..geometry.checks import Array
from .buckets import GrowingTree, add
from .rings import offer_bucket, search_near, squared_distance, squared_reach


class Closest(NamedTuple):
    """The search for the k nodes closest to one that is left out: found[itself], nearest first, and
    how far they are, squared.
    """

    itself: int
    found: NDArray[np.int64]
    squared: Array


@offer_bucket.register(Closest)
def sorted_in(search: Closest, space: Any, tree: GrowingTree, bucket: int, q: Array) -> Closest:
    """The bucket's nodes at their places among those found, the first among equals first."""
    found, apart, u = search.found, search.squared, search.itself
    k = len(apart)
    node = tree.head[bucket]
    while node >= 0:
        d = squared_distance(space, tree.nodes, node, q)
        if node != u and (d < apart[k - 1] or (d == apart[k - 1] and node < found[u, k - 1])):
            at = k - 1
            while at > 0 and (
                d < apart[at - 1] or (d == apart[at - 1] and node < found[u, at - 1])
            ):
                apart[at], found[u, at] = apart[at - 1], found[u, at - 1]
                at -= 1
            apart[at], found[u, at] = d, node
        node = tree.next[node]
    return search


@squared_reach.register(Closest)
def to_the_last(search: Closest) -> float:
    """As far as the k-th is."""
    return search.squared[len(search.squared) - 1]


@algorithm
def fill(tree: GrowingTree, nodes: Array) -> None:
    """Put nodes (n, d) into the tree's buckets; none has a parent."""
    for node in nodes:
        add(tree, node, -1)


@algorithm
def k_closest_in_buckets(space: Any, tree: GrowingTree, k: int) -> NDArray[np.int64]:
    """The k nodes closest to each node, nearest first and the first among equals, itself left out;
    shape (n, k), k < n.
    """
    found, apart = np.zeros((tree.size[0], k), np.int64), np.empty(k)
    for u in range(len(found)):
        apart[:] = np.inf
        search_near(space, tree, tree.nodes[u], Closest(u, found, apart))
    return found
