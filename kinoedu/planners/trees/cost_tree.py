"""A growing tree that can be rewired, with the cost of each node and a log of its edges."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import callable_from_compiled, inlined
from ...geometry.checks import Array
from ...spaces.buckets import GrowingTree, add


class CostTree(NamedTuple):
    """A growing tree with the cost of each node.

    cost : (n,), from the root.
    length : (n,), the cost of the motion from the parent.
    child, sibling : (n,), a linked list: the children of a node are child[node], then
        sibling[child], until -1.
    log : (rows, 2), the edges (node, parent) in the order in which they were made, as many as fit.
    attached : (1,), how many edges were made in all.
    """

    tree: GrowingTree
    cost: Array
    length: Array
    child: NDArray[np.int64]
    sibling: NDArray[np.int64]
    log: NDArray[np.int64]
    attached: NDArray[np.int64]


@callable_from_compiled
def empty_costs(tree: GrowingTree, rows: int = 0) -> CostTree:
    """Room for the costs of an empty tree, and for a log of `rows` edges."""
    room = len(tree.nodes)
    return CostTree(
        tree,
        np.empty(room),
        np.empty(room),
        np.empty(room, np.int64),
        np.empty(room, np.int64),
        np.empty((rows, 2), np.int64),
        np.zeros(1, np.int64),
    )


@inlined
def append_node(costs: CostTree, q: Array, parent: int, length: float) -> int:
    """Append a node below its parent; returns the node's number."""
    node = add(costs.tree, q, parent)
    costs.child[node], costs.sibling[node], costs.cost[node] = -1, -1, length
    if parent >= 0:
        attach(costs, node, parent, length)
        costs.cost[node] = costs.cost[parent] + length
    return node


@inlined
def attach(costs: CostTree, node: int, parent: int, length: float) -> None:
    """Make a node the first child of a parent, and log the edge where there is room."""
    costs.tree.parent[node], costs.length[node] = parent, length
    costs.sibling[node], costs.child[parent] = costs.child[parent], node
    if costs.attached[0] < len(costs.log):
        costs.log[costs.attached[0], 0], costs.log[costs.attached[0], 1] = node, parent
    costs.attached[0] += 1


@inlined
def rewire(costs: CostTree, node: int, parent: int, length: float) -> None:
    """Move a node, with its subtree, below another parent."""
    above = costs.tree.parent[node]
    if costs.child[above] == node:
        costs.child[above] = costs.sibling[node]
    else:
        before = costs.child[above]
        while costs.sibling[before] != node:
            before = costs.sibling[before]
        costs.sibling[before] = costs.sibling[node]
    attach(costs, node, parent, length)
    update_costs(costs, node)


@inlined
def update_costs(costs: CostTree, root: int) -> None:
    """Update the costs of a subtree, parents before children, in a walk without a stack."""
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
