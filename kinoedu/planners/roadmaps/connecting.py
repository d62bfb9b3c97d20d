"""Connection rules: which pairs of nodes a roadmap tries to join. Bullo & Smith, chapter 5.

A rule is a record; `connect_nodes(rule, problem, nodes)` finds its edges. For a rule of your own,
register a function for its type.
"""

from functools import singledispatch
from heapq import heapify, heappop
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm, compiled
from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...problems.protocols import PlanningProblem
from ...spaces.buckets import GrowingTree
from ...spaces.closest import add_nodes
from ...support.text import shortened
from ..problem_input import new_tree
from ..trees.near import near_nodes
from ..tuning import integer, positive
from .neighbours import k_closest, visiting_order

Numbers = NDArray[np.int64]
Rule = object  # a record for whose type `connect_nodes` has a function, such as ClosestRule
MOST_PAIRS = 100_000_000  # that memory can hold


class ClosestRule(NamedTuple):
    """The rule that `KClosest` makes."""

    k: int


class RadiusRule(NamedTuple):
    """The rule that `Radius` makes."""

    r: float


class ComponentRule(NamedTuple):
    """The rule that `ComponentKClosest` makes."""

    k: int


def KClosest(k: int) -> ClosestRule:
    """Try to join each node to its k closest nodes.

    Returns
    -------
    ClosestRule, for `prm` and `connect_nodes`.

    Raises
    ------
    InvalidParameter
        Where `k` is not a positive integer.
    """
    return ClosestRule(integer(k, "k", least=1))


def Radius(r: float) -> RadiusRule:
    """Try to join each node to all nodes within a radius, in the unit of the problem's distance.

    Returns
    -------
    RadiusRule, for `prm` and `connect_nodes`.

    Raises
    ------
    InvalidParameter
        Where `r` is not a positive number.

    Examples
    --------
    >>> Radius(2).r
    2.0
    """
    return RadiusRule(positive(r, "r"))


def ComponentKClosest(k: int = 1) -> ComponentRule:
    """Try to join each node to up to k closest nodes of each earlier component, until one joins it.

    No edge closes a cycle, so the roadmap is a forest: it has the fewest edges that connect its
    components.

    Returns
    -------
    ComponentRule, for `prm` and `connect_nodes`.

    Raises
    ------
    InvalidParameter
        Where `k` is not a positive integer.
    """
    return ComponentRule(integer(k, "k", least=1))


@singledispatch
def connect_nodes(rule: Rule, problem: PlanningProblem, nodes: Array) -> tuple[Numbers, Array]:
    """Find the edges of a roadmap among nodes (n, d) by a rule.

    Returns
    -------
    The edges (m, 2) in the order in which they were found, and their costs (m,).

    Raises
    ------
    InvalidParameter
        Where `rule` is not a rule, or there are more pairs than memory can hold.
    """
    raise InvalidParameter(
        "expected a rule such as KClosest(10), Radius(1.5) or ComponentKClosest(1), got "
        f"{shortened(rule)}"
    )


@connect_nodes.register
def _(rule: ClosestRule, problem: PlanningProblem, nodes: Array) -> tuple[Numbers, Array]:
    n, k = len(nodes), min(rule.k, max(len(nodes) - 1, 0))
    if n * k > MOST_PAIRS:
        raise InvalidParameter(
            f"n * k must not exceed 100,000,000, got {n:,} * {k:,}; sample fewer nodes or join "
            "fewer"
        )
    if k == 0:
        return np.empty((0, 2), np.int64), np.empty(0)
    return join_pairs(problem, nodes, k * np.arange(n + 1), k_closest(problem, nodes, k).ravel())


@connect_nodes.register
def _(rule: RadiusRule, problem: PlanningProblem, nodes: Array) -> tuple[Numbers, Array]:
    tree = new_tree(problem, max(len(nodes), 1))
    add_nodes(tree, nodes)
    first, to = find_within(problem, tree, rule.r, MOST_PAIRS)
    if len(to) > MOST_PAIRS:
        raise InvalidParameter(
            f"more than 100,000,000 pairs lie within {rule.r:g}; sample fewer nodes, or choose a "
            "smaller radius"
        )
    return join_pairs(problem, nodes, first, to)


@connect_nodes.register
def _(rule: ComponentRule, problem: PlanningProblem, nodes: Array) -> tuple[Numbers, Array]:
    return join_components(problem, nodes, rule.k)


def join_pairs(
    problem: PlanningProblem, nodes: Array, first: Numbers, to: Numbers
) -> tuple[Numbers, Array]:
    """Join each node i to those of to[first[i]:first[i + 1]] that a free motion leads to.

    Each pair is checked once. Returns the edges (m, 2), in the order of the pairs, and their costs
    (m,).
    """
    return join_in_order(problem, nodes, first, to, visiting_order(problem, nodes))


@algorithm
def join_in_order(
    problem: PlanningProblem, nodes: Array, first: Numbers, to: Numbers, order: Numbers
) -> tuple[Numbers, Array]:
    """`join_pairs`, which visits the nodes in a given order."""
    cost_of_pair, size = np.full(len(to), -1.0), 0  # negative: not joined
    for i in order:
        for pair in range(first[i], first[i + 1]):
            j = to[pair]
            tried_before = j < i and i in to[first[j] : first[j + 1]]
            if not tried_before and problem.is_free_path(nodes[i], nodes[j]):
                cost_of_pair[pair] = problem.motion_cost(nodes[i], nodes[j])
                size += 1
    edges, costs, size = np.empty((size, 2), np.int64), np.empty(size), 0
    for i in range(len(nodes)):
        for pair in range(first[i], first[i + 1]):
            if cost_of_pair[pair] >= 0.0:
                edges[size, 0], edges[size, 1] = i, to[pair]
                costs[size] = cost_of_pair[pair]
                size += 1
    return edges, costs


@algorithm
def find_within(
    problem: PlanningProblem, tree: GrowingTree, radius: float, most: int
) -> tuple[Numbers, Numbers]:
    """For each node of a tree the other nodes within a radius, in increasing order, as flat rows.

    The search stops after `most` pairs.
    """
    first, to, size = np.zeros(tree.size[0] + 1, np.int64), np.empty(16, np.int64), 0
    for i in range(tree.size[0]):
        for j in np.sort(near_nodes(problem, tree, tree.nodes[i], radius)):
            if j != i and size <= most:
                if size == len(to):
                    to = np.concatenate((to, to))
                to[size] = j
                size += 1
        first[i + 1] = size
    return first, to[:size].copy()


@algorithm
def join_components(problem: PlanningProblem, nodes: Array, k: int) -> tuple[Numbers, Array]:
    """Join each node to the components of the nodes before it, with up to k tries for each.

    O(n^2) where few tries fail, O(n^2 log n) at most. Returns the edges (m, 2) and their costs
    (m,).
    """
    n = len(nodes)
    root, edges, costs, size = np.arange(n), np.empty((n, 2), np.int64), np.empty(n), 0
    for i in range(1, n):
        closest = [(problem.distance(nodes[i], nodes[j]), j) for j in range(i)]
        tries = np.zeros(n, np.int64)
        heapify(closest)
        components = i - size  # that may still be joined: each edge has made two into one
        while components > 0 and len(closest) > 0:
            j = heappop(closest)[1]
            component = root_of(root, j)
            if component == root_of(root, i) or tries[component] == k:
                continue
            tries[component] += 1
            joins = problem.is_free_path(nodes[i], nodes[j])
            if joins:
                root[component] = root_of(root, i)
                edges[size, 0], edges[size, 1] = i, j
                costs[size] = problem.motion_cost(nodes[i], nodes[j])
                size += 1
            if joins or tries[component] == k:
                components -= 1
    return edges[:size].copy(), costs[:size].copy()


@compiled
def count_components(n: int, edges: Numbers) -> Numbers:
    """The number of components of n nodes with the first k of m edges, for k = 0, ..., m."""
    root, count = np.arange(n), np.full(len(edges) + 1, n)
    for k in range(len(edges)):
        one, other = root_of(root, edges[k, 0]), root_of(root, edges[k, 1])
        root[one] = other
        count[k + 1] = count[k] - int(one != other)
    return count


@compiled
def root_of(root: Numbers, node: int) -> int:
    """The node that represents a component.

    Paths are halved on the way (R. E. Tarjan, J. van Leeuwen, 1984).
    """
    while root[node] != node:
        root[node] = root[root[node]]
        node = root[node]
    return node
