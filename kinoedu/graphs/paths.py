"""What every search leaves behind: costs, parents, the order of expansion; and the path that they
hold.
"""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidGraph
from ..geometry.checks import Array
from ..support.text import shortened
from .flat import check_node, searchable


class Steps(NamedTuple):
    """The work of a search, in steps instead of seconds: nodes taken out of the frontier, and edges
    looked at.
    """

    nodes: int
    edges: int


class Search(NamedTuple):
    """The result of a search.

    cost (n,) : of the path found from the start, infinite for nodes not reached. Dijkstra's
    algorithm and A* add up weights, final
        for expanded nodes and else the least so far; breadth- and depth-first search count edges.
    parent (n,) : the node before on that path; -1 for the start and for nodes not reached, which
    the cost tells apart. expanded (k,) : the nodes in the order in which they were expanded, under
    A* some again where an estimate is not consistent.
    steps : how much work that was; None where it was not counted.
    """

    cost: Array
    parent: NDArray[np.int64]
    expanded: NDArray[np.int64]
    steps: Steps | None = None


class Expansion(NamedTuple):
    """One moment of a search: `node` has just been taken out, and its edges are looked at next.

    node : the node. expanded (i,) : the nodes taken out before it, in order. frontier (k,) : the
        nodes seen and waiting, in the order in which they will be taken out if nothing comes
        between: the queue of a breadth-first search, the stack of a depth-first one from its top,
        the priority queue of A* and Dijkstra. cost, parent (n,) : what is known so far, as in
        `Search`. Copies: they stay as they were at this moment.
    """

    node: int
    expanded: NDArray[np.int64]
    frontier: NDArray[np.int64]
    cost: Array
    parent: NDArray[np.int64]


def ends(graph: Any, start: int, goal: int | None) -> tuple[Any, int, int]:
    """The graph as a record, the start, and the goal or -1; InvalidGraph unless both are nodes."""
    flat = searchable(graph)
    return (
        flat,
        check_node(graph, start, "start"),
        -1 if goal is None else check_node(graph, goal, "goal"),
    )


def path_found(found: Search, goal: int) -> NDArray[np.int64] | None:
    """The path to the goal, or None where the search did not reach it."""
    return extract_path(found.parent, goal) if np.isfinite(found.cost[goal]) else None


def extract_path(parent: ArrayLike, goal: int) -> NDArray[np.int64]:
    """The nodes from the root to `goal` by following parents (n,), where the root's is -1; shape
    (k,). Bullo & Smith, chapter 2.

        P := [goal]
        while the first node of P has a parent: put that parent before it
        return P

    A node that a search did not reach has no parent either: its path is itself alone, and does not
    begin at the start.

    Raises InvalidGraph where the parents lead round in a circle or out of the graph, and where goal
    is not a node.

    >>> extract_path([-1, 0, 1, 1], 3)
    array([0, 1, 3])
    """
    parents = np.asarray(parent)
    if (
        parents.ndim != 1
        or isinstance(goal, bool)
        or not isinstance(goal, int | np.integer)
        or not 0 <= goal < len(parents)
    ):
        raise InvalidGraph(
            f"goal must be a node with a parent in an array of shape (n,), got {shortened(goal)} "
            f"of {parents.shape}"
        )
    path = [int(goal)]
    while 0 <= (above := int(parents[path[-1]])) < len(parents) and len(path) <= len(parents):
        path.append(above)
    if above != -1:
        raise InvalidGraph("these parents lead to no root")
    return np.array(path[::-1], np.int64)


def moments(
    expansions: Iterator[int], cost: Array, parent: NDArray[np.int64], frontier_at: Any
) -> Iterator[Expansion]:
    """Each expansion with copies of what is known then; frontier_at(node, how many before) tells
    which nodes wait.

    The expansions are the interpreted ones: the same lines and numbers, and a lesson need not wait
    for a compiler.
    """
    expanded: list[int] = []
    for node in expansions:
        waiting = np.array(frontier_at(node, len(expanded)), np.int64)
        yield Expansion(
            int(node), np.array(expanded, np.int64), waiting, cost.copy(), parent.copy()
        )
        expanded.append(int(node))
