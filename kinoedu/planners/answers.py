"""From what a planner built to the Plan it returns."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..compiled import body
from ..geometry.checks import Array
from ..graphs import extract_path
from ..problems import Plan, Tree
from ..spaces.buckets import GrowingTree
from .asking import body_for


@body
def path_cost(problem: Any, path: Array) -> float:
    """The length of a path, in the problem's own distance."""
    cost = 0.0
    for i in range(1, len(path)):
        cost += problem.distance(path[i - 1], path[i])
    return cost


def plan_along(problem: Any, nodes: Array, numbers: NDArray[np.int64] | None, reason: str, **built: Any) -> Plan:
    """A plan along numbered nodes, shape (k,), or without a path and with the reason why where there are none."""
    if numbers is None:
        return Plan(None, np.inf, reason=reason, problem=problem, **built)
    path = nodes[numbers]
    return Plan(path, float(body_for(problem, path_cost)(problem, path)), problem=problem, **built)


def plan_from_tree(planner: str, problem: Any, tree: GrowingTree, at_goal: int, reason: str, **stats: int) -> Plan:
    """A plan that goes from the tree's root to the node at the goal; -1 where there is none."""
    n = int(tree.size[0])
    grown = Tree(tree.nodes[:n].copy(), tree.parent[:n].copy())
    numbers = extract_path(grown.parent, at_goal) if at_goal >= 0 else None
    return plan_along(problem, grown.nodes, numbers, reason, planner=planner, tree=grown, stats={"nodes": n, **stats})
