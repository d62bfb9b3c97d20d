"""The k nodes closest to each node of a set, by the buckets of a tree: row by row and ring by ring as for the nearest one."""

import numpy as np
from numpy.typing import NDArray

from ..compiled import body, inlined
from ..geometry.checks import Array
from .buckets import GrowingTree, add, bucket_of, squared_distance, squared_gap


@body
def fill(tree: GrowingTree, nodes: Array) -> None:
    """Put nodes (n, d) into the tree's buckets; none has a parent."""
    for node in nodes:
        add(tree, node, -1)


@body
def k_closest_in_buckets(tree: GrowingTree, k: int) -> NDArray[np.int64]:
    """The k nodes closest to each node, nearest first and the first among equals, itself left out; shape (n, k), k < n."""
    found, apart = np.zeros((tree.size[0], k), np.int64), np.empty(k)
    for u in range(len(found)):
        apart[:] = np.inf
        column, row = bucket_of(tree, tree.nodes[u])
        x, y = tree.nodes[u, 0] - tree.x, (tree.nodes[u, 1] if tree.nodes.shape[1] > 1 else 0.0) - tree.y
        offer_bucket(tree, row * tree.columns + column, u, found, apart)
        for ring in range(1, max(tree.columns, tree.rows)):
            below, above = squared_gap(y, row - ring, tree.cell), squared_gap(y, row + ring, tree.cell)
            left, right = squared_gap(x, column - ring, tree.cell), squared_gap(x, column + ring, tree.cell)
            if apart[k - 1] < min(min(below, above), min(left, right)):
                break
            for j, gap in ((row - ring, below), (row + ring, above)):
                if 0 <= j < tree.rows and gap <= apart[k - 1]:
                    for i in range(max(column - ring, 0), min(column + ring, tree.columns - 1) + 1):
                        offer_bucket(tree, j * tree.columns + i, u, found, apart)
            for i, gap in ((column - ring, left), (column + ring, right)):
                if 0 <= i < tree.columns and gap <= apart[k - 1]:
                    for j in range(max(row - ring + 1, 0), min(row + ring - 1, tree.rows - 1) + 1):
                        offer_bucket(tree, j * tree.columns + i, u, found, apart)
    return found


@inlined
def offer_bucket(tree: GrowingTree, bucket: int, u: int, found: NDArray[np.int64], apart: Array) -> None:
    """Sort the nodes of one bucket into those closest to u so far: found[u], with their squared distances in `apart`."""
    k = len(apart)
    node = tree.head[bucket]
    while node >= 0:
        d = squared_distance(tree.nodes, node, tree.nodes[u])
        if node != u and (d < apart[k - 1] or (d == apart[k - 1] and node < found[u, k - 1])):
            at = k - 1
            while at > 0 and (d < apart[at - 1] or (d == apart[at - 1] and node < found[u, at - 1])):
                apart[at], found[u, at] = apart[at - 1], found[u, at - 1]
                at -= 1
            apart[at], found[u, at] = d, node
        node = tree.next[node]
