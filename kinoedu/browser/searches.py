"""The bodies of the search board: a search on a graph or a grid, expansion by expansion."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled
from ..geometry.checks import Array
from ..graphs.bfs import breadth_first
from ..graphs.checks import compute_distances
from ..graphs.dfs import depth_first
from ..graphs.flat import GraphRecord, compress_rows, degree, edge
from ..graphs.radix_heap import NONE, enlarge, has_room
from ..graphs.search import begin_search, expand, first_unsettled
from ..spaces import RealSpace
from ..spaces.interface import distance
from .scenes import SceneArrays
from .search_layers import Posed, ShownSearch, show_runs
from .search_runs import (
    EXPANDED,
    EXPANDING,
    FRONTIER,
    Numbers,
    Runs,
    begin_runs,
    end_moment,
    enter,
    with_room,
)

ENDS = 2  # the handles before those of the nodes: start and goal


class SearchSettings(NamedTuple):
    """The graph of a search board.

    side : the side of a grid's cells, 0 for a graph.
    directed : 1 or 0.
    nodes : (n, 3), rows x, y, and 0 for a deleted node.
    edges : (m, 4), rows u, v, weight, and 1 where the weight is the length.
    """

    side: float
    directed: float
    nodes: Array
    edges: Array


@algorithm
def show_bfs(scene: SceneArrays, settings: SearchSettings, rng: np.random.Generator) -> ShownSearch:
    """A breadth-first search."""
    return show_breadth_first(pose_search(scene, settings, False))


@algorithm
def show_dfs(scene: SceneArrays, settings: SearchSettings, rng: np.random.Generator) -> ShownSearch:
    """A depth-first search."""
    return show_depth_first(pose_search(scene, settings, False))


@algorithm
def show_dijkstra(
    scene: SceneArrays, settings: SearchSettings, rng: np.random.Generator
) -> ShownSearch:
    """Dijkstra's algorithm."""
    return show_best_first(pose_search(scene, settings, False), False)


@algorithm
def show_astar(
    scene: SceneArrays, settings: SearchSettings, rng: np.random.Generator
) -> ShownSearch:
    """A*, with the distance to the goal."""
    return show_best_first(pose_search(scene, settings, True), True)


# ---- the search of a scene


@compiled
def pose_search(scene: SceneArrays, settings: SearchSettings, informed: bool) -> Posed:
    """The search between the nodes that are nearest to start and goal.

    Where nodes have handles they are there, and weights that are lengths follow.
    """
    nodes, there = settings.nodes[:, :2].copy(), settings.nodes[:, 2] > 0.0
    numbers = np.flatnonzero(there)
    for k in range(ENDS, len(scene.handles)):
        nodes[numbers[k - ENDS], 0] = scene.handles[k, 0]
        nodes[numbers[k - ENDS], 1] = scene.handles[k, 1]
    space = RealSpace(scene.lo, scene.hi)
    pairs, weights = settings.edges[:, :2].astype(np.int64), settings.edges[:, 2].copy()
    for e in range(len(pairs)):
        if settings.edges[e, 3] > 0.0:
            weights[e] = distance(space, nodes[pairs[e, 0]], nodes[pairs[e, 1]])
    first, to, weight = compress_rows(len(nodes), pairs, weights, 1 if settings.directed else 2)
    graph = GraphRecord(len(nodes), pairs, weights, first, to, weight)
    here = scene.handles[:ENDS, :2].copy()
    start = int(np.argmin(distances_to(space, nodes, there, here[0])))
    goal = int(np.argmin(distances_to(space, nodes, there, here[1])))
    heuristic = np.zeros(len(nodes))
    if informed:
        apart = distances_to(space, nodes, there, nodes[goal])
        heuristic = lower_bounds(nodes, pairs, weights, apart)
    size = max(scene.hi[0] - scene.lo[0], scene.hi[1] - scene.lo[1])
    return Posed(graph, nodes, there, start, goal, here, heuristic, settings.side, size)


@compiled
def distances_to(space: RealSpace, nodes: Array, there: NDArray[np.bool_], q: Array) -> Array:
    """The distance of each node to q, infinite for those that are not there."""
    apart = compute_distances(space, nodes, q)
    apart[~there] = np.inf
    return apart


@compiled
def lower_bounds(nodes: Array, pairs: Numbers, weights: Array, apart: Array) -> Array:
    """Lower bounds (n,) on the cost to a node, by the distances to it, infinite for no node.

    They are scaled down where an edge costs less than its length.
    """
    rate = 1.0
    for e in range(len(pairs)):
        u, v = pairs[e, 0], pairs[e, 1]
        dx, dy = nodes[v, 0] - nodes[u, 0], nodes[v, 1] - nodes[u, 1]
        length = math.sqrt(dx * dx + dy * dy)
        if length > 0.0:
            rate = min(rate, weights[e] / length)
    bounds = rate * apart
    bounds[apart == np.inf] = 0.0
    return bounds


# ---- the searches, with their runs


@algorithm
def show_breadth_first(posed: Posed) -> ShownSearch:
    """A breadth-first search as it is shown."""
    n = posed.graph.size
    cost, parent, queue = np.full(n, np.inf), np.full(n, -1, np.int64), np.empty(n, np.int64)
    settled, before, runs = np.zeros(n, np.bool_), -1, begin_runs(n, posed.start)
    for v in breadth_first(posed.graph, posed.start, posed.goal, cost, parent, queue):
        runs = with_room(runs)
        come_to(runs, posed.graph, before, v, cost, parent, settled)
        settled[v], before = True, v
    return show_runs(posed, runs, False)


@algorithm
def show_best_first(posed: Posed, informed: bool) -> ShownSearch:
    """A* as it is shown, or Dijkstra's algorithm with a heuristic of zeros."""
    n, graph = posed.graph.size, posed.graph
    labels, queue = begin_search(n, posed.start, posed.heuristic)
    one, before, runs, done = np.empty(1, np.int64), -1, begin_runs(n, posed.start), False
    while not done:
        u = first_unsettled(queue, labels.settled)
        if u == NONE:
            break
        runs = with_room(runs)
        come_to(runs, graph, before, u, labels.cost, labels.parent, labels.settled)
        if not has_room(queue, degree(graph, u)):
            queue = enlarge(queue, degree(graph, u))
        _, done = expand(graph, posed.goal, posed.heuristic, labels, queue, one, 0)
        before = u
    return show_runs(posed, runs, informed)


@algorithm
def show_depth_first(posed: Posed) -> ShownSearch:
    """A depth-first search as it is shown; its frontier is the stack below the newest node."""
    n = posed.graph.size
    cost, parent = np.full(n, np.inf), np.full(n, -1, np.int64)
    stack, examined = np.empty(n, np.int64), np.zeros(n, np.int64)
    above, runs = -1, begin_runs(n, posed.start)
    for v in depth_first(posed.graph, posed.start, posed.goal, cost, parent, stack, examined):
        runs = with_room(runs)
        while above >= 0 and above != parent[v]:
            enter(runs, above, EXPANDED, parent[above], cost[above])
            above = parent[above]
        if above >= 0:
            enter(runs, above, FRONTIER, parent[above], cost[above])
        enter(runs, v, EXPANDING, parent[v], cost[v])
        end_moment(runs, v)
        above = v
    return show_runs(posed, runs, False)


@compiled
def come_to(
    runs: Runs,
    graph: GraphRecord,
    before: int,
    u: int,
    cost: Array,
    parent: Numbers,
    settled: NDArray[np.bool_],
) -> None:
    """The moment at which u is expanded, after a node `before`, -1 for none."""
    if before >= 0:
        enter(runs, before, EXPANDED, parent[before], cost[before])
        for k in range(degree(graph, before)):
            v, _ = edge(graph, before, k)
            if cost[v] < np.inf and not settled[v]:
                enter(runs, v, FRONTIER, parent[v], cost[v])
    enter(runs, u, EXPANDING, parent[u], cost[u])
    end_moment(runs, u)
