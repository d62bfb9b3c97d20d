"""Trees in the forms in which variants of exercises ask for them, and in the usual form again."""

from typing import Any

import numpy as np

from ....geometry.checks import Array
from ...shapes import Value

Insertion = tuple[list[int], list[float]]


def put_new_first(tree: Insertion, *given: Value) -> Insertion:
    """Return the tree with the last node as number 0, and all others one number higher."""
    last = len(tree[0]) - 1
    parents = [0 if p == last else p + 1 if p >= 0 else p for p in tree[0]]
    return [*parents[-1:], *parents[:-1]], [*tree[1][-1:], *tree[1][:-1]]


def put_new_last(tree: Insertion, *given: Value) -> Insertion:
    """Return the tree with node 0 as the last one, and all others one number lower."""
    last = len(tree[0]) - 1
    parents = [last if p == 0 else p - 1 if p > 0 else p for p in tree[0]]
    return [*parents[1:], *parents[:1]], [*tree[1][1:], *tree[1][:1]]


def double_costs(tree: Insertion, *given: Value) -> Insertion:
    """Return the tree with twice the costs."""
    return tree[0], [2.0 * cost for cost in tree[1]]


def halve_costs(tree: Insertion, *given: Value) -> Insertion:
    """Return the tree with half the costs."""
    return tree[0], [cost / 2.0 for cost in tree[1]]


def double_cost(problem: Value, nodes: Array, parent: Array, cost: Array, *new: Value) -> Any:
    """Return the arguments with twice the costs."""
    return problem, nodes, parent, 2.0 * cost, *new


def halve_cost(problem: Value, nodes: Array, parent: Array, cost: Array, *new: Value) -> Any:
    """Return the arguments with half the costs."""
    return problem, nodes, parent, cost / 2.0, *new


def make_root_its_parent(tree: Value, *given: Value) -> Value:
    """Return the tree whose first node is its own parent."""
    return tree[0], np.append(0, tree[1][1:]).astype(np.int64)


def make_root_parentless(tree: Value, *given: Value) -> Value:
    """Return the tree whose first node has the parent -1 where it was its own, and 0 otherwise."""
    root = 0 if len(tree[1]) and tree[1][0] != 0 else -1
    return tree[0], np.append(root, tree[1][1:]).astype(np.int64)[: len(tree[1])]


def number_backwards(tree: Value, *given: Value) -> Value:
    """Return the tree whose nodes are numbered from the last to the first."""
    nodes, parent = tree[0][::-1], np.asarray(tree[1])[::-1]
    return nodes, np.where(parent < 0, parent, len(nodes) - 1 - parent)
