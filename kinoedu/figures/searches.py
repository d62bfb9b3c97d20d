"""One moment of a search on a graph: expanded nodes, frontier and unseen nodes."""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.lines import Line2D

from ..graphs import Expansion, Graph
from . import palette
from .graphs import (
    MOST_LABELS,
    STATES,
    as_integers,
    axes_round,
    draw_links,
    draw_nodes,
    draw_parents,
    layout,
    node_size,
    write_beside,
    write_weights,
)
from .palette import Style
from .plane import title


def draw_search(
    moment: Expansion,
    graph: Graph,
    ax: Axes | None = None,
    *,
    weights: bool = False,
    costs: bool = False,
) -> list[Artist]:
    """Draw one moment of a search, as `bfs_expansions` and similar functions yield them.

    A black hexagon is the node being expanded, blue squares are expanded, yellow diamonds are in
    the frontier, white circles are unseen; arrows lead from parents to children. The nodes on the
    stack of a depth-first search are drawn as its frontier.

    costs : write each node's cost so far beside it.

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> from kinoedu.graphs import bfs_expansions
    >>> graph = Graph(nodes=[(0, 0), (1, 0), (0, 1)], edges=[(0, 1), (1, 2)])
    >>> artists = draw_search(list(bfs_expansions(graph, 0))[1], graph)
    >>> plt.close()
    """
    states = dict.fromkeys(graph, "unseen")
    states.update(dict.fromkeys(as_integers(moment.expanded), "expanded"))
    states.update(dict.fromkeys(as_integers(moment.frontier), "frontier"))
    states[moment.node] = "expanding"
    places = layout(graph)
    ax = axes_round(graph, places, ax)
    numbered = len(graph) <= MOST_LABELS
    gap = node_size(graph, numbered) / 2
    artists = draw_links(graph, places, ax, gap=gap)
    artists += draw_parents(graph, moment.parent, places, ax, gap=gap)
    if weights:
        artists += write_weights(graph, places, ax)
    artists += draw_nodes(graph, places, states, ax, numbered)
    if costs:
        for u in (u for u in graph if np.isfinite(moment.cost[u])):
            text = f"{moment.cost[u]:.3g}"
            artists.append(write_beside(places[u], text, ax, (0, gap + 3), palette.TREE, "center"))
    n = len(moment.frontier)
    waiting = ", ".join(map(str, moment.frontier)) if n <= 8 else f"{n} nodes"
    expanded = f"{len(moment.expanded)} nodes expanded, now node {moment.node}"
    artists.append(title(f"{expanded}; waiting: {waiting or 'none'}", ax))
    return [*artists, draw_legend(ax)]


def draw_legend(ax: Axes) -> Artist:
    """Draw the legend of a search's markers, below the picture."""
    marks = []
    for state in ("expanding", "expanded", "frontier", "unseen"):
        marker, factor, face, _ = STATES[state]
        look: Style = {"linestyle": "", "marker": marker, "markersize": 11 * factor}
        look |= {"markerfacecolor": face, "markeredgecolor": palette.INK}
        marks.append(Line2D([], [], label=state, **look))
    below: Style = {"loc": "upper center", "bbox_to_anchor": (0.5, -0.1), "ncols": 4}
    return ax.legend(handles=marks, frameon=False, fontsize=palette.TEXT_SIZE - 1, **below)
