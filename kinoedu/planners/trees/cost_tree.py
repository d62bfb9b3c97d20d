"""A growing tree that can be rewired: what each node costs is kept up to date, and who was hung
below whom can be written down.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import inlined
from ...geometry.checks import Array
from ...spaces.buckets import GrowingTree, add


class CostTree(NamedTuple):
    """A growing tree that knows what each node costs: `cost` from the root, `length` of the motion
    from its parent (what it costs where the terrain has costs).

    The children of a node are a chain: child[node], then sibling[child], until -1. `log` has room
    for the first rows (node, parent) of who was hung below whom, in the order in which it happened;
    hung[0] counts them all.
    """

    tree: GrowingTree
    cost: Array
    length: Array
    child: NDArray[np.int64]
    sibling: NDArray[np.int64]
    log: NDArray[np.int64]
    hung: NDArray[np.int64]


def empty_costs(tree: GrowingTree, rows: int = 0) -> CostTree:
    """Room for the costs of an empty tree, and a log of so many rows."""
    room = len(tree.nodes)
    cost, length = np.empty((2, room))
    child, sibling = np.empty((2, room), np.int64)
    return CostTree(
        tree, cost, length, child, sibling, np.empty((rows, 2), np.int64), np.zeros(1, np.int64)
    )


@inlined
def join(costs: CostTree, q: Array, parent: int, length: float) -> int:
    """Append a node below its parent; returns its number."""
    node = add(costs.tree, q, parent)
    costs.child[node], costs.sibling[node], costs.cost[node] = -1, -1, length
    if parent >= 0:
        hang(costs, node, parent, length)
        costs.cost[node] = costs.cost[parent] + length
    return node


@inlined
def hang(costs: CostTree, node: int, parent: int, length: float) -> None:
    """Make a node the first child of a parent, and write it down where there is room."""
    costs.tree.parent[node], costs.length[node] = parent, length
    costs.sibling[node], costs.child[parent] = costs.child[parent], node
    if costs.hung[0] < len(costs.log):
        costs.log[costs.hung[0], 0], costs.log[costs.hung[0], 1] = node, parent
    costs.hung[0] += 1


@inlined
def rewire(costs: CostTree, node: int, parent: int, length: float) -> None:
    """Hang a node, with all that hangs on it, below another parent."""
    above = costs.tree.parent[node]
    if costs.child[above] == node:
        costs.child[above] = costs.sibling[node]
    else:
        before = costs.child[above]
        while costs.sibling[before] != node:
            before = costs.sibling[before]
        costs.sibling[before] = costs.sibling[node]
    hang(costs, node, parent, length)
    pass_on(costs, node)


@inlined
def pass_on(costs: CostTree, root: int) -> None:
    """Reckon anew the cost of a node and of all below it, parents before children, by walking round
    that part of the tree.
    """
    node = root
    while True:
        costs.cost[node] = costs.cost[costs.tree.parent[node]] + costs.length[node]
        if costs.child[node] >= 0:
            node = costs.child[node]
            continue
        while node != root and costs.sibling[node] < 0:
            node = costs.tree.parent[node]
        if node == root:
            return
        node = costs.sibling[node]
