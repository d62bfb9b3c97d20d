"""The result of a graph search, and the path that its parents describe."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidGraph
from ..geometry.checks import Array, is_integer
from ..support.constructors import with_type_names
from ..support.text import shortened
from .checks import holds_integers
from .flat import Searchable, as_searchable, check_node


@with_type_names
class Steps(NamedTuple):
    """The work of a search, counted in steps: nodes that left the frontier, and edges examined."""

    nodes: int
    edges: int


@with_type_names
class Search(NamedTuple):
    """The result of a search.

    cost : (n,), of the path found from the start, infinite for nodes that were not reached.
        Dijkstra's algorithm and A* add weights; the cost is final for expanded nodes and otherwise
        the least so far. Breadth- and depth-first search count edges.
    parent : (n,), the node before on that path; -1 for the start and for nodes that were not
        reached.
    expanded : (k,), the nodes in the order of expansion. A* may expand a node again where its
        heuristic is not consistent.
    steps : the work; None where it was not counted.
    """

    cost: Array
    parent: NDArray[np.int64]
    expanded: NDArray[np.int64]
    steps: Steps | None = None


@with_type_names
class Expansion(NamedTuple):
    """One moment of a search: `node` has just left the frontier, and its edges are examined next.

    node : the node.
    expanded : (i,), the nodes expanded before it, in order.
    frontier : (k,), the nodes that were seen and wait, in the order in which they would be expanded
        if no other node were inserted: the queue of a breadth-first search, the stack of a
        depth-first search from its top, the priority queue of Dijkstra's algorithm and A*.
    cost, parent : (n,), as in `Search`, at this moment.

    The arrays are copies.
    """

    node: int
    expanded: NDArray[np.int64]
    frontier: NDArray[np.int64]
    cost: Array
    parent: NDArray[np.int64]


def check_ends(graph: Searchable, start: int, goal: int | None) -> tuple[Any, int, int]:
    """The graph as a record, the start, and the goal or -1.

    Raises
    ------
    InvalidGraph
        Where `start` or `goal` is not a node of the graph.
    """
    flat = as_searchable(graph)
    return (
        flat,
        check_node(graph, start, "start"),
        -1 if goal is None else check_node(graph, goal, "goal"),
    )


def path_or_none(found: Search, goal: int) -> NDArray[np.int64] | None:
    """The path to the goal, or None where the search did not reach it."""
    return extract_path(found.parent, goal) if np.isfinite(found.cost[goal]) else None


def extract_path(parent: ArrayLike, goal: int) -> NDArray[np.int64]:
    """The path from the root to `goal`, by an array of parents. Bullo & Smith, chapter 2.

        P := [goal]
        while the first node of P has a parent: insert that parent before it
        return P

    A node that a search did not reach has no parent either: its path is that node alone.

    Parameters
    ----------
    parent : (n,), the parent of each node, -1 for the root.

    Returns
    -------
    (k,) array of node numbers, the root first.

    Raises
    ------
    InvalidGraph
        Where `goal` is not a node, or the parents are not whole numbers, form a cycle or leave the
        graph.

    Examples
    --------
    >>> extract_path([-1, 0, 1, 1], 3)
    array([0, 1, 3])
    """
    parents = np.asarray(parent)
    if parents.ndim != 1 or not is_integer(goal) or not 0 <= goal < len(parents):
        raise InvalidGraph(
            f"goal must be a node with a parent in an array of shape (n,), got {shortened(goal)} "
            f"of {parents.shape}"
        )
    if not holds_integers(parents):
        raise InvalidGraph(
            f"parents must be whole numbers, -1 where there is none, got {shortened(parent)}"
        )
    path = [int(goal)]
    while 0 <= (above := int(parents[path[-1]])) < len(parents) and len(path) <= len(parents):
        path.append(above)
    if above != -1:
        where = "form a cycle" if 0 <= above < len(parents) else f"lead to {above}, no node"
        raise InvalidGraph(
            f"the parents must lead from node {goal} to a root, whose parent is -1, but {where}"
        )
    return np.array(path[::-1], np.int64)


def yield_moments(
    expansions: Iterator[int], cost: Array, parent: NDArray[np.int64], frontier_at: Any
) -> Iterator[Expansion]:
    """Yield an Expansion, with copies of the arrays, for each node of an interpreted search.

    frontier_at(node, number of earlier expansions) gives the nodes that wait. The search is
    interpreted, so a lesson does not wait for a compiler; the results are the same.
    """
    expanded: list[int] = []
    for node in expansions:
        waiting = np.array(frontier_at(node, len(expanded)), np.int64)
        yield Expansion(
            int(node), np.array(expanded, np.int64), waiting, cost.copy(), parent.copy()
        )
        expanded.append(int(node))
