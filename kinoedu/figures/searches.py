"""One moment of a search on a graph: what was expanded, what waits, what is unseen."""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from ..graphs import Expansion, Graph
from . import palette
from .graphs import (
    MOST_LABELS,
    STATES,
    axes_round,
    beside,
    draw_links,
    draw_nodes,
    draw_parents,
    layout,
    node_size,
    numbers,
    write_weights,
)
from .plane import title


def draw_search(
    moment: Expansion,
    graph: Graph,
    ax: Axes | None = None,
    *,
    weights: bool = False,
    costs: bool = False,
) -> list[Artist]:
    """Draw one moment of a search, as `bfs_expansions` and its like yield them.

    A black hexagon is the node that is being expanded, blue squares were expanded before it, yellow
    diamonds wait in the frontier, white circles are unseen; arrows lead from parents to children. A
    depth-first search comes back to the nodes on its stack: they are drawn as waiting. costs :
    write each node's cost so far beside it.

    >>> from matplotlib import pyplot as plt
    >>> from kinoedu.graphs import bfs_expansions
    >>> graph = Graph(nodes=[(0, 0), (1, 0), (0, 1)], edges=[(0, 1), (1, 2)])
    >>> artists = draw_search(list(bfs_expansions(graph, 0))[1], graph)
    >>> plt.close()
    """
    states = dict.fromkeys(graph, "unseen")
    for nodes, state in (
        (moment.expanded, "expanded"),
        (moment.frontier, "frontier"),
        ([moment.node], "expanding"),
    ):
        states.update(dict.fromkeys(numbers(nodes), state))
    places = layout(graph)
    ax = axes_round(graph, places, ax)
    numbered = len(graph) <= MOST_LABELS
    gap = node_size(graph, numbered) / 2
    artists = draw_links(graph, places, ax, gap=gap) + draw_parents(
        graph, moment.parent, places, ax, gap=gap
    )
    if weights:
        artists += write_weights(graph, places, ax)
    artists += draw_nodes(graph, places, states, ax, numbered)
    if costs:
        known = [u for u in graph if np.isfinite(moment.cost[u])]
        artists += [
            beside(places[u], f"{moment.cost[u]:.3g}", ax, (0, gap + 3), palette.TREE, "center")
            for u in known
        ]
    waiting = (
        ", ".join(map(str, moment.frontier))
        if len(moment.frontier) <= 8
        else f"{len(moment.frontier)} nodes"
    )
    artists.append(
        title(
            f"{len(moment.expanded)} nodes expanded, now node {moment.node}; waiting: "
            f"{waiting or 'none'}",
            ax,
        )
    )
    return [*artists, legend(ax)]


def legend(ax: Axes) -> Artist:
    """What the markers of a search mean, below the picture."""
    marks = [
        Line2D(
            [],
            [],
            linestyle="",
            marker=marker,
            markersize=11 * factor,
            markerfacecolor=face,
            markeredgecolor=palette.INK,
            label=state,
        )
        for state in ("expanding", "expanded", "frontier", "unseen")
        for marker, factor, face, _ in [STATES[state]]
    ]
    return ax.legend(
        handles=marks,
        loc="upper center",
        bbox_to_anchor=(0.5, -0.1),
        ncols=4,
        fontsize=palette.TEXT_SIZE - 1,
        frameon=False,
    )
