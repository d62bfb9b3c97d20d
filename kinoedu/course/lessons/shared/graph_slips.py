"""Answers of programs with a known misconception about graph search."""

from collections.abc import Callable
from math import inf

import numpy as np
from numpy.typing import NDArray

from ....graphs import Graph
from .random_graphs import Neighbours, Weights

Search = Callable[[Neighbours, int], list[int]]
# the new cost of v: from the costs, the nodes taken out, and an edge u, v with its weight
Relax = Callable[[list[float], set[int], int, int, float], float]
# A* can take out a node again where the heuristic is inconsistent; a negative cycle never ends
MAX_TIMES = 100


def search_breadth_first(neighbours: Neighbours, start: int) -> list[int]:
    """Parents of breadth-first search, without a mistake."""
    parent, queue, seen = [-1] * len(neighbours), [start], {start}
    for u in queue:
        for v in neighbours[u]:
            if v not in seen:
                seen.add(v)
                parent[v] = u
                queue.append(v)
    return parent


def search_by_stack(neighbours: Neighbours, start: int) -> list[int]:
    """Parents of a search that takes the newest waiting node."""
    parent, stack, seen = [-1] * len(neighbours), [start], {start}
    while stack:
        u = stack.pop()
        for v in neighbours[u]:
            if v not in seen:
                seen.add(v)
                parent[v] = u
                stack.append(v)
    return parent


def search_marking_late(neighbours: Neighbours, start: int) -> list[int]:
    """Parents of a search that marks nodes when they are taken out, not when they are put in."""
    parent, queue, done = [-1] * len(neighbours), [start], set()
    for u in queue:
        if u not in done:
            done.add(u)
            for v in neighbours[u]:
                if v not in done:
                    parent[v] = u
                    queue.append(v)
    return parent


def visit_breadth_first(neighbours: Neighbours, start: int) -> list[int]:
    """Nodes in the order in which breadth-first search visits them."""
    order = [start]
    for u in order:
        order += [v for v in neighbours[u] if v not in order]
    return order


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


def tree_path(
    neighbours: Neighbours, start: int, goal: int, search: Search = search_breadth_first
) -> list[int] | None:
    """Path in the tree of a search, or None where it does not begin at the start."""
    path = followed(search(neighbours, start), goal)
    return path if path and path[0] == start else None


def depths(neighbours: Neighbours, start: int) -> list[int]:
    """Number of edges from the start to each node, -1 where it is not reachable."""
    return [len(tree_path(neighbours, start, u) or []) - 1 for u in range(len(neighbours))]


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


def improve(cost: list[float], done: set[int], u: int, v: int, weight: float) -> float:
    """The lower of the costs of v: the right rule."""
    return min(cost[v], cost[u] + weight)


def keep_first(cost: list[float], done: set[int], u: int, v: int, weight: float) -> float:
    """The first cost of v, also where a lower one is found."""
    return cost[u] + weight if cost[v] == inf else cost[v]


def keep_closed(cost: list[float], done: set[int], u: int, v: int, weight: float) -> float:
    """The lower cost, but nodes that were taken out keep theirs."""
    return cost[v] if v in done else improve(cost, done, u, v, weight)


def overwrite(cost: list[float], done: set[int], u: int, v: int, weight: float) -> float:
    """The last cost that was found before v was taken out, and lower ones after."""
    return improve(cost, done, u, v, weight) if v in done else cost[u] + weight


def count_last_edge(cost: list[float], done: set[int], u: int, v: int, weight: float) -> float:
    """The weight of the last edge alone, as in Prim's algorithm."""
    return cost[v] if v in done else min(cost[v], weight)


def best_first(
    neighbours: Neighbours,
    weights: Weights,
    estimate: list[float],
    start: int,
    goal: int,
    relax: Relax = improve,
) -> tuple[list[float], list[int]]:
    """Costs and parents of A*, with a rule for the new cost of a node.

    On a graph with a negative cycle it stops after `MAX_TIMES` rounds of all nodes.
    """
    cost, parent = [inf] * len(neighbours), [-1] * len(neighbours)
    waiting, done = {start}, set[int]()
    cost[start] = 0.0
    for _ in range(MAX_TIMES * len(neighbours)):
        u = min(waiting, key=lambda v: (cost[v] + estimate[v], v), default=goal)
        if u == goal:
            break
        waiting.remove(u)
        done.add(u)
        for v, weight in zip(neighbours[u], weights[u]):
            new = relax(cost, done, u, v, weight)
            if new != cost[v]:
                cost[v], parent[v] = new, u
                waiting.add(v)
    return cost, parent


def dijkstra_costs(
    neighbours: Neighbours, weights: Weights, start: int, relax: Relax = improve
) -> list[float]:
    """Costs of Dijkstra's algorithm, with a rule for the new cost of a node."""
    nowhere = -1
    return best_first(neighbours, weights, [0.0] * len(neighbours), start, nowhere, relax)[0]


def astar_path(
    neighbours: Neighbours,
    weights: Weights,
    estimate: list[float],
    start: int,
    goal: int,
    relax: Relax = improve,
) -> list[int] | None:
    """Path of A*, with a rule for the new cost of a node, or None."""
    path = followed(best_first(neighbours, weights, estimate, start, goal, relax)[1], goal)
    return path if path and path[0] == start else None


def greedy_path(
    neighbours: Neighbours, weights: Weights, estimate: list[float], start: int, goal: int
) -> list[int] | None:
    """Path of a search that takes the node of least heuristic: A* without weights."""
    none = [[0.0] * len(row) for row in weights]
    return astar_path(neighbours, none, estimate, start, goal)


def path_at_sight(
    neighbours: Neighbours, weights: Weights, estimate: list[float], start: int, goal: int
) -> list[int] | None:
    """Path of A* that stops when the goal is first seen: it is the next node taken out."""
    eager = [-inf if u == goal else h for u, h in enumerate(estimate)]
    return astar_path(neighbours, weights, eager, start, goal)


def path_pushed_once(
    neighbours: Neighbours, weights: Weights, estimate: list[float], start: int, goal: int
) -> list[int] | None:
    """Path of A* that does not push a waiting node again, so that it keeps its first priority."""
    cost, parent = [inf] * len(neighbours), [-1] * len(neighbours)
    cost[start], waiting = 0.0, {start: estimate[start]}
    while waiting:
        u = min(waiting, key=lambda v: (waiting[v], v))
        if u == goal:
            return followed(parent, goal)
        del waiting[u]
        for v, weight in zip(neighbours[u], weights[u]):
            if cost[u] + weight < cost[v]:
                cost[v], parent[v] = cost[u] + weight, u
                waiting.setdefault(v, cost[v] + estimate[v])
    return None


def fewest_edges(graph: Graph, start: int, goal: int) -> NDArray[np.int64] | None:
    """Path with the fewest edges; ties go to the lower index."""
    neighbours = [graph.neighbours(u).tolist() for u in range(graph.size)]
    ones = [[1.0] * len(row) for row in neighbours]
    path = astar_path(neighbours, ones, [0.0] * graph.size, start, goal)
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
    cost, order = [inf] * len(neighbours), visit_breadth_first(neighbours, start)
    cost[start] = 0.0
    for u in order:
        for v, weight in zip(neighbours[u], weights[u]):
            cost[v] = min(cost[v], cost[u] + weight)
    return cost
