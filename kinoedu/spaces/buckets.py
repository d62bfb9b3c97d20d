"""The nearest node of a growing tree, by a grid of buckets over the first two coordinates.

While a tree is small all nodes are compared. Then only the buckets round the query are, ring by ring, until no farther ring can
hold a nearer node. Nodes of any dimension may be kept so: their distance is at least that of their first two coordinates.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled, inlined
from ..geometry.checks import Array

SMALL = 150  # up to here comparing all is faster
NODES_PER_BUCKET = 1.0


class GrowingTree(NamedTuple):
    """A tree under construction: room for `len(nodes)` nodes, of which the first size[0] are there.

    Bucket (i, j) covers (x, y) + (i, j) * cell. Its nodes are a chain: head[j * columns + i], then next[node], until -1.
    """

    nodes: Array
    parent: NDArray[np.int64]
    size: NDArray[np.int64]
    x: float
    y: float
    cell: float
    columns: int
    rows: int
    head: NDArray[np.int64]
    next: NDArray[np.int64]


def empty_tree(capacity: int, lo: Array, hi: Array) -> GrowingTree:
    """A tree without nodes, for configurations between lo and hi, shapes (d,)."""
    plane = np.append(hi - lo, 0.0)[:2] if len(lo) < 2 else (hi - lo)[:2]
    buckets = max(capacity / NODES_PER_BUCKET, 1.0)
    cell = float(max(np.sqrt(plane[0] * plane[1] / buckets), plane.max() / buckets)) or 1.0
    columns, rows = np.maximum(np.ceil(plane / cell), 1).astype(int).tolist()
    return GrowingTree(
        np.empty((capacity, len(lo))),
        np.empty(capacity, np.int64),
        np.zeros(1, np.int64),
        float(lo[0]),
        float(lo[1]) if len(lo) > 1 else 0.0,
        cell,
        columns,
        rows,
        np.full(columns * rows, -1, np.int64),
        np.empty(capacity, np.int64),
    )


@inlined
def add(tree: GrowingTree, q: Array, parent: int) -> int:
    """Append a node; returns its number."""
    node = tree.size[0]
    tree.size[0] = node + 1
    for i in range(tree.nodes.shape[1]):
        tree.nodes[node, i] = q[i]
    tree.parent[node] = parent
    column, row = bucket_of(tree, q)
    bucket = row * tree.columns + column
    tree.next[node] = tree.head[bucket]
    tree.head[bucket] = node
    return node


@inlined
def bucket_of(tree: GrowingTree, q: Array) -> tuple[int, int]:
    """The column and row of q's bucket; the outermost ones take what lies beyond."""
    y = q[1] if len(q) > 1 else 0.0
    i = min(max((q[0] - tree.x) / tree.cell, 0.0), tree.columns - 1.0)
    j = min(max((y - tree.y) / tree.cell, 0.0), tree.rows - 1.0)
    return int(i), int(j)


@inlined
def squared_distance(nodes: Array, node: int, q: Array) -> float:
    """|nodes[node] - q|^2."""
    total = 0.0
    for i in range(len(q)):
        total += (nodes[node, i] - q[i]) * (nodes[node, i] - q[i])
    return total


@inlined
def nearest_in_buckets(tree: GrowingTree, q: Array) -> int:
    """The number of the node with the least Euclidean distance to q, the first among equals."""
    if tree.size[0] <= SMALL:
        return nearest_of_all(tree, q)
    column, row = bucket_of(tree, q)
    x, y = q[0] - tree.x, (q[1] if len(q) > 1 else 0.0) - tree.y
    best, least = nearest_in_bucket(tree, row * tree.columns + column, q, -1, np.inf)
    for ring in range(1, max(tree.columns, tree.rows)):
        below, above = squared_gap(y, row - ring, tree.cell), squared_gap(y, row + ring, tree.cell)
        left, right = squared_gap(x, column - ring, tree.cell), squared_gap(x, column + ring, tree.cell)
        if least < min(min(below, above), min(left, right)):
            break
        for j, gap in ((row - ring, below), (row + ring, above)):
            if 0 <= j < tree.rows and gap <= least:
                for i in range(max(column - ring, 0), min(column + ring, tree.columns - 1) + 1):
                    best, least = nearest_in_bucket(tree, j * tree.columns + i, q, best, least)
        for i, gap in ((column - ring, left), (column + ring, right)):
            if 0 <= i < tree.columns and gap <= least:
                for j in range(max(row - ring + 1, 0), min(row + ring - 1, tree.rows - 1) + 1):
                    best, least = nearest_in_bucket(tree, j * tree.columns + i, q, best, least)
    return best


@compiled
def squared_gap(offset: float, number: int, cell: float) -> float:
    """The square of how far a coordinate is from a column or row of buckets, less a little for rounding."""
    gap = max(max(number * cell - offset, offset - (number + 1) * cell) - 1e-9 * cell, 0.0)
    return gap * gap


@inlined
def nearest_in_bucket(tree: GrowingTree, bucket: int, q: Array, best: int, best_distance: float) -> tuple[int, float]:
    """The better of the best node so far and those of one bucket, with its squared distance."""
    node = tree.head[bucket]
    while node >= 0:
        d = squared_distance(tree.nodes, node, q)
        if d < best_distance or (d == best_distance and node < best):
            best, best_distance = node, d
        node = tree.next[node]
    return best, best_distance


@inlined
def nearest_of_all(tree: GrowingTree, q: Array) -> int:
    """The same by comparing every node."""
    best, best_distance = 0, np.inf
    for node in range(tree.size[0]):
        d = squared_distance(tree.nodes, node, q)
        if d < best_distance:
            best, best_distance = node, d
    return best
