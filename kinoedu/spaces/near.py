"""The nodes of a growing tree within a radius.

Spaces whose distance is bounded by the buckets use them. Other spaces compare every node.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import generic
from ..geometry.checks import Array
from .buckets import GrowingTree, bucket_of
from .interface import Space, distance
from .real import RealSpace
from .rings import search_near, squared_distance, squared_radius, visit_bucket
from .wrapping import WrappingSpace


@generic(1)
def near(space: Space, tree: GrowingTree, q: Array, radius: float) -> NDArray[np.int64]:
    """The indices of the tree's nodes within a radius of q, shape (k,), in no particular order."""
    found, size = np.empty(tree.size[0], np.int64), 0
    for node in range(tree.size[0]):
        if distance(space, tree.nodes[node], q) <= radius:
            found[size] = node
            size += 1
    return found[:size].copy()


@near.register(RealSpace)
def near_in_buckets(
    space: RealSpace, tree: GrowingTree, q: Array, radius: float
) -> NDArray[np.int64]:
    """`near` by the buckets that intersect a square around q; O(k) for evenly spread nodes.

    It repeats the loop of `visit_for_those_within`: an RRT* that passes the record of a search from
    bucket to bucket takes more than twice as long.
    """
    beyond = radius * (1.0 + 1e-9)  # no node is lost by the rounding of a bucket's number
    x, y = q[0], q[1] if len(q) > 1 else 0.0
    left, below = bucket_of(tree, x - beyond, y - beyond)
    right, above = bucket_of(tree, x + beyond, y + beyond)
    found, size = np.empty(16, np.int64), 0
    for row in range(below, above + 1):
        for column in range(left, right + 1):
            node = tree.head[row * tree.columns + column]
            while node >= 0:
                if squared_distance(space, tree.nodes, node, q) <= radius * radius:
                    if size == len(found):
                        found = np.concatenate((found, found))
                    found[size] = node
                    size += 1
                node = tree.next[node]
    return found[:size].copy()


class Within(NamedTuple):
    """A search for the nodes within a distance, of which `found` has the first `size`."""

    found: NDArray[np.int64]
    size: int
    squared: float


@visit_bucket.register(Within)
def visit_for_those_within(
    search: Within, space: Space, tree: GrowingTree, bucket: int, q: Array
) -> Within:
    """The search with the bucket's nodes that are near enough added."""
    found, size = search.found, search.size
    node = tree.head[bucket]
    while node >= 0:
        if squared_distance(space, tree.nodes, node, q) <= search.squared:
            if size == len(found):
                found = np.concatenate((found, found))
            found[size] = node
            size += 1
        node = tree.next[node]
    return Within(found, size, search.squared)


@squared_radius.register(Within)
def squared_distance_within(search: Within) -> float:
    """The squared distance of the search, however many nodes it has found."""
    return search.squared


@near.register(WrappingSpace)
def near_images(
    space: WrappingSpace, tree: GrowingTree, q: Array, radius: float
) -> NDArray[np.int64]:
    """`near` by the buckets around q and around its images; O(k) for evenly spread nodes."""
    search = search_near(space, tree, q, Within(np.empty(16, np.int64), 0, radius * radius))
    return search.found[: search.size].copy()
