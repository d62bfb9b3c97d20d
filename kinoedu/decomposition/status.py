"""The status of a sweep: the open cells that the line crosses, from bottom to top, held so that one
is found in O(log n).

A treap (C. R. Aragon, R. G. Seidel, "Randomized search trees", 1989) in one flat array, threaded
from bottom to top. Row i of `nodes` is one place in that order: the places next below and above it,
its children on the low and the high side, its parent, and the open cell that stands there. Row 0 is
nobody: the parent of the root, below the lowest place and above the highest.

Priorities are a hash of the row's number, so that a sweep is the same every time; depths are O(log
n) as if they were drawn.
"""

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled

NOBODY = 0
BELOW, ABOVE, LOW, HIGH, PARENT, CELL = range(6)


@compiled
def priority(node: int) -> int:
    """The node nearer to the root is the one with more of it; nobody has none. Fibonacci hashing
    (Knuth, volume 3, section 6.4).
    """
    return (node * 2654435769) & 0xFFFFFFFF if node != NOBODY else -1


@compiled
def insert_above(nodes: NDArray[np.int64], below: int, node: int) -> None:
    """Give a new node its place next above `below`; above NOBODY is the bottom. O(log n) expected,
    O(1) rotations.
    """
    above = nodes[below, ABOVE]
    nodes[node, BELOW], nodes[node, ABOVE] = below, above
    nodes[below, ABOVE] = nodes[above, BELOW] = node
    if nodes[below, HIGH] == NOBODY:
        nodes[below, HIGH], nodes[node, PARENT] = node, below
    else:  # then the next above is the lowest on that side, with nobody on its own low side
        nodes[above, LOW], nodes[node, PARENT] = node, above
    while nodes[node, PARENT] != NOBODY and priority(node) > priority(nodes[node, PARENT]):
        rotate_up(nodes, node)


@compiled
def remove(nodes: NDArray[np.int64], node: int) -> None:
    """Take a node out: rotate it down to where it has no children. O(log n) expected, O(1)
    rotations.
    """
    while nodes[node, LOW] != NOBODY or nodes[node, HIGH] != NOBODY:
        low, high = nodes[node, LOW], nodes[node, HIGH]
        rotate_up(nodes, low if priority(low) > priority(high) else high)
    nodes[nodes[node, PARENT], side_of(nodes, node)] = NOBODY
    below, above = nodes[node, BELOW], nodes[node, ABOVE]
    nodes[below, ABOVE], nodes[above, BELOW] = above, below


@compiled
def rotate_up(nodes: NDArray[np.int64], node: int) -> None:
    """Swap a node with its parent; the order from bottom to top stays."""
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
    """On which side of its parent a node hangs; the root on the high side of nobody."""
    return HIGH if nodes[nodes[node, PARENT], HIGH] == node else LOW
