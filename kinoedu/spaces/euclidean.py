"""The node with the least Euclidean distance, which planners in R^n need in every step.

This is the search of rings.py for one distance and one question. The separate code is a sixth
faster, because the general search passes the space on, and compiled code counts references to its
arrays.
"""

import numpy as np

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from .buckets import GrowingTree, bucket_of, first_ring

SMALL = 150  # up to this number of nodes, comparing all of them is faster


@inlined
def squared_difference(nodes: Array, node: int, q: Array) -> float:
    """|nodes[node] - q|^2."""
    total = 0.0
    for i in range(len(q)):
        gap = nodes[node, i] - q[i]
        total += gap * gap
    return total


@inlined
def nearest_euclidean_node(tree: GrowingTree, q: Array) -> int:
    """The index of the node with the least Euclidean distance to q; ties go to the first."""
    if tree.size[0] <= SMALL:
        return nearest_of_all(tree, q)
    used = tree.used
    column, row = bucket_of(tree, q[0], q[1] if len(q) > 1 else 0.0)
    x, y = q[0] - tree.x, (q[1] if len(q) > 1 else 0.0) - tree.y
    best, least = nearest_in_bucket(tree, row * tree.columns + column, q, -1, np.inf)
    for ring in range(max(first_ring(used, column, row), 1), max(tree.columns, tree.rows)):
        below = squared_gap(y, row - ring, tree.cell)
        above = squared_gap(y, row + ring, tree.cell)
        left = squared_gap(x, column - ring, tree.cell)
        right = squared_gap(x, column + ring, tree.cell)
        if least < min(min(below, above), min(left, right)):
            break
        for j, gap in ((row - ring, below), (row + ring, above)):
            if used[2] <= j <= used[3] and gap <= least:
                for i in range(max(column - ring, used[0]), min(column + ring, used[1]) + 1):
                    best, least = nearest_in_bucket(tree, j * tree.columns + i, q, best, least)
        for i, gap in ((column - ring, left), (column + ring, right)):
            if used[0] <= i <= used[1] and gap <= least:
                for j in range(max(row - ring + 1, used[2]), min(row + ring - 1, used[3]) + 1):
                    best, least = nearest_in_bucket(tree, j * tree.columns + i, q, best, least)
    return best


@compiled
def squared_gap(offset: float, number: int, cell: float) -> float:
    """The squared distance of a coordinate from a column or row of buckets.

    It is reduced slightly to allow for rounding.
    """
    gap = max(max(number * cell - offset, offset - (number + 1) * cell) - 1e-9 * cell, 0.0)
    return gap * gap


@inlined
def nearest_in_bucket(
    tree: GrowingTree, bucket: int, q: Array, best: int, best_distance: float
) -> tuple[int, float]:
    """The better of the best node so far and the nodes of one bucket, with its squared distance."""
    node = tree.head[bucket]
    while node >= 0:
        d = squared_difference(tree.nodes, node, q)
        if d < best_distance or (d == best_distance and node < best):
            best, best_distance = node, d
        node = tree.next[node]
    return best, best_distance


@inlined
def nearest_of_all(tree: GrowingTree, q: Array) -> int:
    """`nearest_euclidean_node` by comparing every node."""
    best, best_distance = 0, np.inf
    for node in range(tree.size[0]):
        d = squared_difference(tree.nodes, node, q)
        if d < best_distance:
            best, best_distance = node, d
    return best
