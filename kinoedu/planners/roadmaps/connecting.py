"""Which nodes of a roadmap are tried with which: the connection rules. Bullo & Smith, chapter 5.

A rule is a record; `joined(rule, problem, nodes)` gives the edges that it leads to. A rule of your
own is a record with an answer registered for its type.
"""

from functools import singledispatch
from heapq import heapify, heappop
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm, compiled
from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...spaces.closest import fill
from ...support.text import shortened
from ..problem_input import new_tree
from ..trees.near import near_nodes
from ..tuning import positive, whole
from .neighbours import k_closest

Numbers = NDArray[np.int64]
MOST_PAIRS = 100_000_000  # what memory holds


class ClosestRule(NamedTuple):
    """What `KClosest` makes."""

    k: int


class RadiusRule(NamedTuple):
    """What `Radius` makes."""

    r: float


class ComponentRule(NamedTuple):
    """What `ComponentKClosest` makes."""

    k: int


def KClosest(k: int) -> ClosestRule:
    """Each node is tried with its K closest ones. Raises InvalidParameter."""
    return ClosestRule(whole(k, "k", least=1))


def Radius(r: float) -> RadiusRule:
    """Each node is tried with all within a radius, in the unit of the problem's distance. Raises
    InvalidParameter.

    >>> Radius(2).r
    2.0
    """
    return RadiusRule(positive(r, "r"))


def ComponentKClosest(k: int = 1) -> ComponentRule:
    """Each node in turn is tried with up to K closest ones of every component that the nodes before
    it make, until one joins it.

    No edge closes a circle: the roadmap is a forest, with the fewest edges that connect what they
    can. Raises InvalidParameter.
    """
    return ComponentRule(whole(k, "k", least=1))


@singledispatch
def joined(rule: Any, problem: Any, nodes: Array) -> tuple[Numbers, Array]:
    """The edges (m, 2) that a rule leads to among nodes (n, d), in the order they were found, and
    their costs (m,).
    """
    raise InvalidParameter(
        "expected a rule such as KClosest(10), Radius(1.5) or ComponentKClosest(1), got "
        f"{shortened(rule)}"
    )


@joined.register
def _(rule: ClosestRule, problem: Any, nodes: Array) -> tuple[Numbers, Array]:
    n, k = len(nodes), min(rule.k, max(len(nodes) - 1, 0))
    if n * k > MOST_PAIRS:
        raise InvalidParameter(
            f"n * k must not exceed 100,000,000, got {n:,} * {k:,}; sample fewer nodes or join "
            "fewer"
        )
    if k == 0:
        return np.empty((0, 2), np.int64), np.empty(0)
    return join(problem, nodes, k * np.arange(n + 1), k_closest(problem, nodes, k).ravel())


@joined.register
def _(rule: RadiusRule, problem: Any, nodes: Array) -> tuple[Numbers, Array]:
    tree = new_tree(problem, max(len(nodes), 1))
    fill(tree, nodes)
    first, to = within(problem, tree, rule.r, MOST_PAIRS)
    if len(to) > MOST_PAIRS:
        raise InvalidParameter(
            f"more than 100,000,000 pairs lie within {rule.r:g}; sample fewer nodes, or choose a "
            "smaller radius"
        )
    return join(problem, nodes, first, to)


@joined.register
def _(rule: ComponentRule, problem: Any, nodes: Array) -> tuple[Numbers, Array]:
    return join_components(problem, nodes, rule.k)


@algorithm
def join(problem: Any, nodes: Array, first: Numbers, to: Numbers) -> tuple[Numbers, Array]:
    """The edges (m, 2) from each node i to its neighbours to[first[i]:first[i + 1]] whose motion is
    free, each pair asked once, and what they cost (m,).
    """
    edges, costs, size = np.empty((len(to), 2), np.int64), np.empty(len(to)), 0
    for i in range(len(nodes)):
        for j in to[first[i] : first[i + 1]]:
            asked_before = j < i and np.any(to[first[j] : first[j + 1]] == i)
            if not asked_before and problem.is_free_path(nodes[i], nodes[j]):
                edges[size, 0], edges[size, 1] = i, j
                costs[size] = problem.motion_cost(nodes[i], nodes[j])
                size += 1
    return edges[:size].copy(), costs[:size].copy()


@algorithm
def within(problem: Any, tree: Any, radius: float, most: int) -> tuple[Numbers, Numbers]:
    """For each node of a tree those within a radius, itself left out, in the order of their
    numbers; given up past `most`.
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
def join_components(problem: Any, nodes: Array, k: int) -> tuple[Numbers, Array]:
    """The edges (m, 2) that join each node to the components of those before it, and their costs
    (m,). O(n^2) where few tries are in vain, O(n^2 log n) at most.
    """
    n = len(nodes)
    root, edges, costs, size = np.arange(n), np.empty((n, 2), np.int64), np.empty(n), 0
    for i in range(1, n):
        closest, tries = (
            [(problem.distance(nodes[i], nodes[j]), j) for j in range(i)],
            np.zeros(n, np.int64),
        )
        heapify(closest)
        components = i - size  # that may still be joined: each edge so far made one of two
        while components > 0 and len(closest) > 0:
            j = heappop(closest)[1]
            component = root_of(root, j)
            if component == root_of(root, i) or tries[component] == k:
                continue
            tries[component] += 1
            joins = problem.is_free_path(nodes[i], nodes[j])
            if joins:
                root[component] = root_of(root, i)
                edges[size, 0], edges[size, 1], costs[size] = (
                    i,
                    j,
                    problem.motion_cost(nodes[i], nodes[j]),
                )
                size += 1
            if joins or tries[component] == k:
                components -= 1
    return edges[:size].copy(), costs[:size].copy()


@compiled
def components_as_joined(n: int, edges: Numbers) -> Numbers:
    """How many components n nodes make with the first k of some edges (m, 2), for k from 0 to m, (m
    + 1,).
    """
    root, count = np.arange(n), np.full(len(edges) + 1, n)
    for k in range(len(edges)):
        one, other = root_of(root, edges[k, 0]), root_of(root, edges[k, 1])
        root[one] = other
        count[k + 1] = count[k] - int(one != other)
    return count


@compiled
def root_of(root: Numbers, node: int) -> int:
    """The node that stands for a component; the way there is halved (R. E. Tarjan, J. van Leeuwen,
    1984).
    """
    while root[node] != node:
        root[node] = root[root[node]]
        node = root[node]
    return node
