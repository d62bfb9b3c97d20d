"""A search that can be scrubbed: expanded nodes, frontier and parents at each step."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ...browser.bodies import BODIES
from ...browser.search_layers import Posed, ShownSearch
from ...browser.searches import show_best_first, show_breadth_first, show_depth_first
from ...geometry.checks import Array
from ...graphs import Graph
from ...spaces import RealSpace
from ...support.json_fields import JsonObject
from ..core.drawing import Drawing
from ..core.shown import draw_shown
from .ground import Ground, has_length_weights

SEARCHES: dict[str, Callable[[Posed], ShownSearch]] = {
    "bfs": show_breadth_first,
    "dfs": show_depth_first,
    "dijkstra": lambda posed: show_best_first(posed, False),
    "astar": lambda posed: show_best_first(posed, True),
}
BODY = "search_{}"  # the name of the body of each


def draw_search(
    name: str,
    ground: Ground,
    graph: Graph,
    ends: tuple[int, int],
    here: Array,
    heuristic: Array | None,
) -> Drawing:
    """Draw a search from node to node; one step is one expansion.

    Parameters
    ----------
    name : one of SEARCHES.
    graph : that of the ground, with its nodes where they were dragged.
    ends : the nodes start and goal.
    here : (2, 2), where start and goal were dragged.
    heuristic : (n,), of A*.
    """
    there = np.isin(np.arange(graph.size), list(graph))
    bounds = np.zeros(graph.size) if heuristic is None else heuristic
    size = float(np.subtract(ground.scene["hi"], ground.scene["lo"]).max())
    shown = SEARCHES[name](
        Posed(graph.flat(), graph.nodes, there, *ends, here, bounds, ground.side, size)
    )
    status, *facts = shown.facts.tolist()
    return draw_shown(BODIES[BODY.format(name)], int(status), facts, shown)


def describe_live(ground: Ground, search: str) -> JsonObject | None:
    """What a page needs to answer a board itself, with any search; None where it cannot.

    Bodies measure distances in the plane only. All searches have the settings of the first.
    """
    graph = ground.graph
    if not isinstance(graph.space, RealSpace):
        return None
    nodes = np.zeros((graph.size, 3))
    nodes[list(graph)] = [(*graph.nodes[u], 1.0) for u in graph]
    edges = np.column_stack([graph.edges, graph.weights, has_length_weights(graph)])
    given: list[Any] = [ground.side, float(graph.directed), nodes.tolist(), edges.tolist()]
    first, *others = map(BODY.format, SEARCHES)
    return {
        "body": BODY.format(search),
        "seed": 0,
        "settings": {first: given, **dict.fromkeys(others, first)},
    }
