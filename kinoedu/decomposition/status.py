"""The status of a sweep: the open cells that the line crosses, ordered from bottom to top.

It is a treap (C. R. Aragon, R. G. Seidel, "Randomized search trees", 1989) in one flat array, with
links between neighbours in the order. Row i of `nodes` is one node: the nodes next below and above
it, its children on the low and the high side, its parent, and its open cell. Row 0, NOBODY, is a
sentinel: the parent of the root, below the lowest node and above the highest.

Priorities are a hash of the row number, so that a sweep is deterministic; depths are O(log n), as
for random priorities.
"""

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled

NOBODY = 0
BELOW, ABOVE, LOW, HIGH, PARENT, CELL = range(6)


@compiled
def priority(node: int) -> int:
    """The priority of a node, lower than its parent's; the sentinel has the lowest.

    Fibonacci hashing (Knuth, volume 3, section 6.4).
    """
    return (node * 2654435769) & 0xFFFFFFFF if node != NOBODY else -1


@compiled
def next_above(nodes: NDArray[np.int64], node: int) -> int:
    """The node next above a node; NOBODY above the highest. The lowest is next above NOBODY."""
    return nodes[node, ABOVE]


@compiled
def next_below(nodes: NDArray[np.int64], node: int) -> int:
    """The node next below a node; NOBODY below the lowest. The highest is next below NOBODY."""
    return nodes[node, BELOW]


@compiled
def insert_above(nodes: NDArray[np.int64], below: int, node: int) -> None:
    """Insert a new node next above `below`; above NOBODY is the bottom.

    O(log n) expected, with O(1) rotations.
    """
    above = nodes[below, ABOVE]
    nodes[node, BELOW], nodes[node, ABOVE] = below, above
    nodes[below, ABOVE] = nodes[above, BELOW] = node
    if nodes[below, HIGH] == NOBODY:
        nodes[below, HIGH], nodes[node, PARENT] = node, below
    else:  # then `above` is the lowest node on that side, and has no low child
        nodes[above, LOW], nodes[node, PARENT] = node, above
    while nodes[node, PARENT] != NOBODY and priority(node) > priority(nodes[node, PARENT]):
        rotate_up(nodes, node)


@compiled
def remove(nodes: NDArray[np.int64], node: int) -> None:
    """Remove a node: rotate it down until it has no children.

    O(log n) expected, with O(1) rotations.
    """
    while nodes[node, LOW] != NOBODY or nodes[node, HIGH] != NOBODY:
        low, high = nodes[node, LOW], nodes[node, HIGH]
        rotate_up(nodes, low if priority(low) > priority(high) else high)
    nodes[nodes[node, PARENT], side_of(nodes, node)] = NOBODY
    below, above = nodes[node, BELOW], nodes[node, ABOVE]
    nodes[below, ABOVE], nodes[above, BELOW] = above, below


@compiled
def rotate_up(nodes: NDArray[np.int64], node: int) -> None:
    """Rotate a node above its parent; the order from bottom to top stays."""
    parent = nodes[node, PARENT]
    grandparent, side = nodes[parent, PARENT], side_of(nodes, node)
    inner = LOW if side == HIGH else HIGH
    child = nodes[node, inner]
    nodes[grandparent, side_of(nodes, parent)] = node
    nodes[node, PARENT], nodes[node, inner] = grandparent, parent
    nodes[parent, PARENT], nodes[parent, side] = node, child
    if child != NOBODY:
        nodes[child, PARENT] = parent


@compiled
def side_of(nodes: NDArray[np.int64], node: int) -> int:
    """The side of its parent on which a node is: LOW or HIGH. The root is on NOBODY's high side."""
    return HIGH if nodes[nodes[node, PARENT], HIGH] == node else LOW
