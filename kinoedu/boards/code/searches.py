"""The state of a search on a graph, as layers for `code_board`."""

from typing import Any

import numpy as np

from ..core.drawing import Layer, arrows, dots, edges, labels


def draw_search_state(variables: dict[str, Any]) -> list[Layer]:
    """Draw a search from its variables: `draw=` of a code board whose argument is `graph`.

    Parameters
    ----------
    variables : of these, those that the function has: `graph`, embedded in the plane; `cost`, inf
        for a node that was not seen; `parent`, -1 for none; `waiting`, the nodes of the frontier;
        `u`, the node that is expanded; `v`, the neighbour that is looked at.

    Returns
    -------
    A list of layers: costs beside their nodes, expanded nodes blue, waiting nodes yellow, the edge
    that is looked at black.
    """
    graph = variables.get("graph")
    if graph is None or "cost" not in variables:
        return []
    nodes, cost = graph.nodes, np.asarray(variables["cost"], float)
    waiting = [int(w) for w in variables.get("waiting", ())]
    u, v, layers = variables.get("u"), variables.get("v"), list[Layer]()
    parent = np.asarray(variables.get("parent", np.full(len(nodes), -1)))
    child = np.flatnonzero(parent >= 0)
    begins = nodes[parent[child]]
    layers.append(arrows(begins, 0.75 * (nodes[child] - begins), "tree", width=2.0))
    if u is not None and v is not None:
        layers.append(edges([[nodes[u], nodes[v]]], "ink", width=4.0))
    seen = np.flatnonzero(np.isfinite(cost))
    settled = [k for k in seen if k not in waiting and k != u]
    layers += [
        dots(nodes[these], colour, radius=12.0)
        for these, colour in (
            (settled, "tree"),
            (waiting, "frontier"),
            ([] if u is None else [u], "path"),
        )
        if len(these)
    ]
    layers.append(labels(nodes[seen], [f"{cost[k]:.1f}" for k in seen], "ink"))
    return layers
