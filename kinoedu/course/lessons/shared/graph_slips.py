"""Answers of programs with a known misconception about graph search."""

from collections.abc import Callable
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....graphs import Graph
from .random_graphs import Neighbours, Weights

Answer = Callable[..., Any]


def first_in(
    neighbours: Neighbours, start: int, *, at: int = 0, late: bool = False
) -> tuple[list[int], list[int]]:
    """Parents and order of visit of a search with a queue or a stack.

    Parameters
    ----------
    at : 0 takes the oldest waiting node, -1 the newest.
    late : mark nodes when they are taken out, not when they are put in.
    """
    parent, order, waiting, seen = [-1] * len(neighbours), [], [start], {start}
    while waiting:
        u = waiting.pop(at)
        if u in order:
            continue
        order.append(u)
        for v in neighbours[u]:
            if v not in (order if late else seen):
                seen.add(v)
                parent[v] = u
                waiting.append(v)
    return parent, order


def undirected(neighbours: Neighbours) -> Neighbours:
    """The same edges in both directions."""
    n = len(neighbours)
    return [[v for v in range(n) if v in neighbours[u] or u in neighbours[v]] for u in range(n)]


def undirected_weights(neighbours: Neighbours, weights: Weights) -> Weights:
    """The weights for `undirected`; of two opposite edges the smaller weight."""
    leads = [dict(zip(row, beside)) for row, beside in zip(neighbours, weights)]
    both = undirected(neighbours)
    return [
        [min(leads[u].get(v, inf), leads[v].get(u, inf)) for v in row] for u, row in enumerate(both)
    ]


def followed(parent: list[int], goal: int) -> list[int] | None:
    """Path from the root to the goal, or None where the parents form a cycle."""
    path = [goal]
    while parent[path[-1]] != -1:
        path.append(parent[path[-1]])
        if len(path) > len(parent):
            return None
    return path[::-1]


def tree_path(neighbours: Neighbours, start: int, goal: int, **how: Any) -> list[int] | None:
    """Path of `first_in`, or None where it does not begin at the start."""
    path = followed(first_in(neighbours, start, **how)[0], goal)
    return path if path and path[0] == start else None


def depths(neighbours: Neighbours, start: int) -> list[int]:
    """Number of edges from the start to each node, -1 where it is not reachable."""
    parent, order = first_in(neighbours, start)
    return [
        len(followed(parent, u) or []) - 1 if u in order else -1 for u in range(len(neighbours))
    ]


def dfs_order(neighbours: Neighbours, start: int, goal: int) -> list[int]:
    """Nodes in the order in which a depth-first search enters them, dead ends included."""
    order: list[int] = []

    def visit(u: int) -> bool:
        order.append(u)
        return u == goal or any(visit(v) for v in neighbours[u] if v not in order)

    visit(start)
    return order


def dfs_walk(neighbours: Neighbours, start: int, goal: int) -> list[int] | None:
    """Walk of a depth-first search that steps back out of dead ends."""
    walk, seen = [], set()

    def visit(u: int) -> bool:
        seen.add(u)
        walk.append(u)
        if u == goal:
            return True
        for v in neighbours[u]:
            if v not in seen:
                if visit(v):
                    return True
                walk.append(u)
        return False

    return walk if visit(start) else None


def never_back(neighbours: Neighbours, start: int, goal: int) -> list[int] | None:
    """Path to the first unvisited neighbour each time, without backtracking."""
    path = [start]
    while path[-1] != goal:
        new = [v for v in neighbours[path[-1]] if v not in path]
        if not new:
            return None
        path.append(new[0])
    return path


def best_first(
    neighbours: Neighbours,
    weights: Weights,
    start: int,
    goal: int = -1,
    *,
    estimate: list[float] | None = None,
    cost_counts: float = 1.0,
    improves: bool = True,
    reopens: bool = True,
    overwrites: bool = False,
    at_sight: bool = False,
    from_node: bool = True,
) -> tuple[list[float], list[int]]:
    """Costs and parents of Dijkstra's algorithm or A*, with a built-in mistake.

    Parameters
    ----------
    cost_counts : 0 orders nodes by the heuristic alone.
    improves : False keeps the first cost of a node.
    reopens : False keeps the cost of a node that was taken out.
    overwrites : True replaces a cost also by a greater one.
    at_sight : True stops when the goal is first seen.
    from_node : False counts only the last edge.
    """
    cost, parent = [inf] * len(neighbours), [-1] * len(neighbours)
    left, waiting, done = estimate or [0.0] * len(neighbours), [start], set()
    cost[start] = 0.0
    while waiting:
        u = min(waiting, key=lambda v: (cost_counts * cost[v] + left[v], v))
        waiting.remove(u)
        done.add(u)
        if u == goal:
            break
        for v, weight in zip(neighbours[u], weights[u]):
            through = (cost[u] if from_node else 0.0) + weight
            fixed = (v in done and not reopens) or (cost[v] < inf and not improves)
            if fixed or not (through < cost[v] or (overwrites and v not in done)):
                continue
            cost[v], parent[v] = through, u
            if at_sight and v == goal:
                return cost, parent
            if v not in waiting:
                waiting.append(v)
    return cost, parent


def best_path(
    neighbours: Neighbours,
    weights: Weights,
    estimate: list[float],
    start: int,
    goal: int,
    **how: Any,
) -> Any:
    """Path of `best_first`, or None."""
    parent = best_first(neighbours, weights, start, goal, estimate=estimate, **how)[1]
    path = followed(parent, goal)
    return path if path and path[0] == start else None


def fewest_edges(graph: Graph, start: int, goal: int) -> NDArray[np.int64] | None:
    """Path with the fewest edges; ties go to the lower index."""
    neighbours = [graph.neighbours(u).tolist() for u in range(graph.size)]
    path = best_path(
        neighbours, [[1] * len(row) for row in neighbours], [0.0] * graph.size, start, goal
    )
    return None if path is None else np.array(path, np.int64)


def lightest_first(neighbours: Neighbours, weights: Weights, start: int) -> list[float]:
    """Costs where the lightest edge comes first, whatever the cost so far.

    Each node is expanded once.
    """
    cost, waiting, done = [inf] * len(neighbours), [(0.0, start)], set()
    cost[start] = 0.0
    while waiting:
        least, u = min(waiting)
        waiting.remove((least, u))
        for v, weight in zip(neighbours[u], weights[u]) if u not in done else ():
            if cost[u] + weight < cost[v]:
                cost[v] = cost[u] + weight
                waiting.append((weight, v))
        done.add(u)
    return cost


def queue_costs(neighbours: Neighbours, weights: Weights, start: int) -> list[float]:
    """Costs where nodes leave a queue in the order of arrival, each once."""
    cost, order = [inf] * len(neighbours), first_in(neighbours, start)[1]
    cost[start] = 0.0
    for u in order:
        for v, weight in zip(neighbours[u], weights[u]):
            cost[v] = min(cost[v], cost[u] + weight)
    return cost
