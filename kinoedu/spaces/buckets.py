"""A growing tree with a grid of buckets that finds its nodes near a place.

The buckets divide the plane of the first two coordinates. Nodes may have any dimension, because
their distance is at least the distance in these two coordinates.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import callable_from_compiled, inlined
from ..geometry.checks import Array

NODES_PER_BUCKET = 1.0


class GrowingTree(NamedTuple):
    """A tree under construction, with room for `len(nodes)` nodes, of which size[0] exist.

    Bucket (i, j) starts at (x, y) + (i, j) * cell. Its nodes form a linked list: head[j * columns +
    i], then next[node], until -1. Only columns used[0] to used[1] and rows used[2] to used[3] have
    nodes.
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
    used: NDArray[np.int64]


@callable_from_compiled
def empty_tree(capacity: int, lo: Array, hi: Array) -> GrowingTree:
    """A tree without nodes, for configurations between lo and hi, shapes (d,)."""
    return sparse_tree(capacity, capacity, lo, hi)


@callable_from_compiled
def sparse_tree(capacity: int, expected: int, lo: Array, hi: Array) -> GrowingTree:
    """An empty tree with room for `capacity` nodes, whose buckets are made for fewer."""
    width, height = hi[0] - lo[0], hi[1] - lo[1] if len(lo) > 1 else 0.0
    buckets = max(expected / NODES_PER_BUCKET, 1.0)
    cell = max(math.sqrt(width * height / buckets), max(width, height) / buckets) or 1.0
    columns, rows = max(math.ceil(width / cell), 1), max(math.ceil(height / cell), 1)
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
        np.array([columns, -1, rows, -1]),
    )


@inlined
def add(tree: GrowingTree, q: Array, parent: int) -> int:
    """Append a node; returns its index."""
    node = tree.size[0]
    tree.size[0] = node + 1
    for i in range(tree.nodes.shape[1]):
        tree.nodes[node, i] = q[i]
    tree.parent[node] = parent
    column, row = bucket_of(tree, q[0], q[1] if len(q) > 1 else 0.0)
    bucket = row * tree.columns + column
    tree.next[node] = tree.head[bucket]
    tree.head[bucket] = node
    used = tree.used
    used[0], used[1] = min(used[0], column), max(used[1], column)
    used[2], used[3] = min(used[2], row), max(used[3], row)
    return node


@inlined
def first_ring(part: Any, column: int, row: int) -> int:
    """The number of the first ring of buckets around (column, row) that meets a part of them.

    The part is its first and last column and its first and last row, as in `tree.used`.
    """
    return max(max(part[0] - column, column - part[1]), max(part[2] - row, row - part[3]))


@inlined
def bucket_of(tree: GrowingTree, x: float, y: float) -> tuple[int, int]:
    """The column and row of the bucket at (x, y), or of the outermost bucket nearest to it."""
    i = min(max((x - tree.x) / tree.cell, 0.0), tree.columns - 1.0)
    j = min(max((y - tree.y) / tree.cell, 0.0), tree.rows - 1.0)
    return int(i), int(j)
