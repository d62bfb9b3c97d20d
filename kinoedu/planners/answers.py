"""From what a planner built to the Plan it returns."""

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..geometry.checks import Array
from ..graphs import extract_path
from ..problems import Plan, Tree
from ..spaces.buckets import GrowingTree


def path_cost(problem: Any, path: Array) -> float:
    """The length of a path, in the problem's own distance."""
    return float(sum(problem.distance(a, b) for a, b in pairwise(path)))


def plan_along(problem: Any, nodes: Array, numbers: NDArray[np.int64] | None, reason: str, **built: Any) -> Plan:
    """A plan along numbered nodes, shape (k,), or without a path and with the reason why where there are none."""
    if numbers is None:
        return Plan(None, np.inf, reason=reason, problem=problem, **built)
    path = nodes[numbers]
    return Plan(path, path_cost(problem, path), problem=problem, **built)


def plan_from_tree(problem: Any, tree: GrowingTree, at_goal: int, reason: str, **stats: int) -> Plan:
    """A plan that goes from the tree's root to the node at the goal; -1 where there is none."""
    n = int(tree.size[0])
    grown = Tree(tree.nodes[:n].copy(), tree.parent[:n].copy())
    numbers = extract_path(grown.parent, at_goal) if at_goal >= 0 else None
    return plan_along(problem, grown.nodes, numbers, reason, tree=grown, stats={"nodes": n, **stats})
