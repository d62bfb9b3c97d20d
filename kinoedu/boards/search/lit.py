"""The lines of a search that its board shows as they run."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...graphs import Graph
from ...graphs.bfs import breadth_first, search_breadth_first
from ...graphs.dfs import depth_first, search_depth_first
from ...graphs.radix_heap import RadixHeap, list_in_order
from ...graphs.search import begin_search, expand, search
from ..core.drawing import Layer, edges, labels
from ..tracing.code_run import CodeRun, Look, trace_lines

BLIND = {  # function, the search that calls it, what waits, the number of expansions
    "bfs": (
        breadth_first,
        search_breadth_first,
        {"queue": "queue[retrieved:inserted].tolist()"},
        "retrieved",
    ),
    "dfs": (
        depth_first,
        search_depth_first,
        {"stack": "stack[:height].tolist()"},
        "np.isfinite(cost).sum()",
    ),
}
ARRAYS = ("heuristic", "expanded", "cost", "parent", "settled", "examined")  # over all nodes
BEST = {
    "queue": "order_queue(queue, cost, heuristic, settled)",
    "g": "cost[u]",
    "h": "heuristic[u]",
    "g + h": "cost[u] + heuristic[u]",
}


def trace_search(
    name: str, graph: Graph, ends: tuple[int, int], heuristic: Array | None
) -> CodeRun:
    """The first lines of a search from node to node: "bfs", "dfs", "dijkstra" or "astar"."""
    flat, nodes = graph.flat(), graph.nodes
    if name in BLIND:
        function, whole, points, progress = BLIND[name]
        look = Look(points, draw=mark_edge(nodes, flat, "v", "u"), progress=progress, hidden=ARRAYS)
        call: Callable[[CodeRun], Any] = lambda _: whole(flat, flat.size, *ends)  # noqa: E731
        return trace_lines(function, look, call, whole)
    bounds = np.zeros(flat.size) if heuristic is None else heuristic
    look = Look(
        BEST,
        draw=mark_edge(nodes, flat, "u", "v"),
        names={"order_queue": order_queue},
        progress="n",
        hidden=ARRAYS,
    )
    start, goal = ends
    labels, queue = begin_search(flat.size, start, bounds)
    return trace_lines(expand, look, lambda _: search(flat, goal, bounds, labels, queue), search)


def mark_edge(
    nodes: Array, flat: Any, one: str, other: str
) -> Callable[[dict[str, Any]], list[Layer]]:
    """Draw the edge that is examined, and the names of the two variables that are its ends."""

    def draw(variables: dict[str, Any]) -> list[Layer]:
        u, v = variables.get(one), variables.get(other)
        if u is None or v is None or u < 0 or v not in flat.neighbours(u):
            return []
        ends = nodes[[u, v]]
        return [edges([ends], "ink", width=5.0), labels(ends, [one, other], "ink")]

    return draw


def order_queue(
    queue: RadixHeap, cost: Array, heuristic: Array, settled: NDArray[np.bool_]
) -> dict[int, float]:
    """The waiting nodes in the order in which they will be removed, each with its g + h."""
    waiting = dict.fromkeys(int(v) for v in list_in_order(queue) if not settled[v])
    return {v: float(cost[v] + heuristic[v]) for v in waiting}
