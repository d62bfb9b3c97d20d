"""Figures of graphs: nodes, edges, numbers, weights, paths and trees on them.

A node's colour and marker show its state.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import FancyArrowPatch
from matplotlib.transforms import ScaledTranslation
from numpy.typing import ArrayLike, NDArray

from ..geometry.checks import Array
from ..graphs import Graph
from . import palette
from .drawing import draw_edges, draw_path
from .names import HALO
from .palette import Style
from .plane import frame

MOST_LABELS = 60  # the numbers of more nodes than this would cover the graph
BEND = 0.16  # of two edges between the same nodes, as a fraction of their length
LINK = palette.OUTSIDE

# Marker, its size relative to a circle's, face colour, colour of the number.
STATES = {
    "unseen": ("o", 1.0, palette.FREE, palette.INK),
    "frontier": ("D", 0.85, palette.FRONTIER, palette.INK),
    "expanded": ("s", 0.9, palette.TREE, "white"),
    "expanding": ("H", 1.25, palette.INK, "white"),
    "marked": ("o", 1.15, palette.PATH, palette.INK),
}


def draw_graph(
    graph: Graph,
    ax: Axes | None = None,
    *,
    labels: bool | None = None,
    weights: bool = False,
    highlight: ArrayLike = (),
    highlight_edges: ArrayLike = (),
    path: ArrayLike | None = None,
    parents: ArrayLike | None = None,
    frontier: ArrayLike = (),
) -> list[Artist]:
    """Draw a graph at its nodes' first two coordinates, or on a circle if it has no space.

    Directed edges are arrows.

    Parameters
    ----------
    labels : write each node's number in it; by default up to 60 nodes.
    weights : write each edge's weight beside it.
    highlight : nodes (k,) to emphasize.
    highlight_edges : edges (j, 2) to emphasize.
    path : nodes (k,) along which a path is drawn.
    parents : (n,) from a search, drawn as arrows from each parent to its child; -1 for none.
    frontier : nodes (k,) that are drawn as the frontier.

    Returns
    -------
    list of artists

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> graph = Graph(nodes=[(0, 0), (1, 0), (0, 1)], edges=[(0, 1), (1, 2)])
    >>> artists = draw_graph(graph, path=[0, 1, 2])
    >>> plt.close()
    """
    states = dict.fromkeys(graph, "unseen")
    along = np.array([] if path is None else path, np.int64)
    states.update(dict.fromkeys(as_integers(highlight) + along.tolist(), "marked"))
    states.update(dict.fromkeys(as_integers(frontier), "frontier"))
    places = layout(graph)
    ax = axes_round(graph, places, ax)
    numbered = len(graph) <= MOST_LABELS if labels is None else labels
    gap = node_size(graph, numbered) / 2
    artists = draw_links(graph, places, ax, gap=gap)
    if weights:
        artists += write_weights(graph, places, ax)
    if parents is not None:
        artists += draw_parents(graph, np.asarray(parents), places, ax, gap=gap)
    for u, v in np.asarray(highlight_edges, np.int64).reshape(-1, 2):
        look: Style = {"arrow": graph.directed, "width": 4.0, "bend": bend(graph, u, v)}
        artists += draw_link(places[u], places[v], ax, palette.PATH, **look)
    if len(along) > 1:
        artists += draw_path(places[along], ax)
    return artists + draw_nodes(graph, places, states, ax, numbered)


def layout(graph: Graph) -> Array:
    """The positions at which nodes are drawn, shape (n, 2)."""
    if graph.space is None:
        angles = np.pi / 2 - 2 * np.pi * np.arange(graph.size) / max(graph.size, 1)
        return np.column_stack([np.cos(angles), np.sin(angles)])
    nodes = graph.nodes
    return nodes[:, :2] if nodes.shape[1] > 1 else np.column_stack([nodes, np.zeros(len(nodes))])


def as_integers(nodes: ArrayLike) -> list[int]:
    """Nodes as a list of Python integers."""
    return np.atleast_1d(np.asarray(nodes, np.int64)).tolist()


def axes_round(graph: Graph, places: Array, ax: Axes | None) -> Axes:
    """The axes given, or new ones that show all nodes.

    New axes have no scales where the positions mean nothing.
    """
    if ax is not None:
        return ax
    ax = palette.axes_or_new(None, (7.0, 5.0))
    frame(places[list(graph)] if len(graph) else np.zeros((1, 2)), ax)
    if graph.space is None:
        ax.set_axis_off()
    return ax


def node_size(graph: Graph, numbered: bool) -> float:
    """The diameter of a node in points."""
    if numbered:
        return float(np.clip(28.0 - 0.2 * len(graph), 16.0, 25.0))
    return float(np.clip(12.0 - 3.0 * np.log10(len(graph) + 1), 2.5, 9.0))


def bend(graph: Graph, u: int, v: int) -> float:
    """The bend of an edge: nonzero only where another edge leads back."""
    return BEND if graph.directed and u != v and graph.is_edge(v, u) else 0.0


def draw_links(graph: Graph, places: Array, ax: Axes, *, gap: float) -> list[Artist]:
    """Draw the edges: lines, or arrows where they are directed; loops as rings above their node."""
    edges = graph.edges
    loops = np.unique(edges[edges[:, 0] == edges[:, 1], 0])
    aside = ax.transData + ScaledTranslation(0, gap / 72.0, ax.figure.dpi_scale_trans)
    ring: Style = {"fillstyle": "none", "markersize": max(1.4 * gap, 4), "markeredgewidth": 1.8}
    artists: list[Artist] = [
        *ax.plot(*places[loops].T, "o", color=LINK, zorder=2, transform=aside, **ring)
    ]
    apart = edges[edges[:, 0] != edges[:, 1]]
    if not graph.directed:
        width = float(np.clip(2.6 - 0.4 * np.log10(len(edges) + 1), 0.5, 2.0))
        return [*artists, *draw_edges(places[apart], ax, LINK, width=width, zorder=2)]
    arrow: Style = {"arrow": True, "width": 1.6, "gap": gap, "zorder": 2}
    for u, v in apart:
        artists += draw_link(places[u], places[v], ax, LINK, bend=bend(graph, u, v), **arrow)
    return artists


def draw_link(
    a: Array,
    b: Array,
    ax: Axes,
    colour: str,
    *,
    arrow: bool,
    width: float,
    gap: float = 0.0,
    bend: float = 0.0,
    zorder: float = 3.0,
) -> list[Artist]:
    """Draw one edge, a gap in points short of its ends."""
    shape: Style = {
        "arrowstyle": "-|>" if arrow else "-",
        "connectionstyle": f"arc3,rad={bend}",
        "mutation_scale": 8.0 + 3.5 * width,
        "shrinkA": gap,
        "shrinkB": gap,
    }
    look: Style = {"color": colour, "linewidth": width, "zorder": zorder}
    return [ax.add_patch(FancyArrowPatch((a[0], a[1]), (b[0], b[1]), **shape, **look))]


def draw_parents(
    graph: Graph, parents: NDArray[np.int64], places: Array, ax: Axes, *, gap: float
) -> list[Artist]:
    """Draw arrows from parents to children; lines where there are many."""
    children = np.flatnonzero(parents >= 0)
    if len(parents) > MOST_LABELS:
        segments = np.stack([places[parents[children]], places[children]], axis=1)
        return draw_edges(segments, ax, palette.TREE, width=2.0, zorder=3)
    artists: list[Artist] = []
    for child in children.tolist():
        parent = int(parents[child])
        look: Style = {"arrow": True, "width": 2.6, "gap": gap, "bend": bend(graph, parent, child)}
        artists += draw_link(places[parent], places[child], ax, palette.TREE, **look)
    return artists


def draw_nodes(
    graph: Graph, places: Array, states: dict[int, str], ax: Axes, numbered: bool
) -> list[Artist]:
    """Draw each node by its state, with its number in it.

    Numbered nodes are drawn one after another, so that a near one covers both marker and number.
    """
    artists: list[Artist] = []
    size = node_size(graph, numbered)
    if not numbered:
        for state, (marker, factor, face, _) in STATES.items():
            here = [u for u in graph if states[u] == state]
            artists += draw_markers(places[here], marker, factor * size, face, 0.6, 6, ax)
        return artists
    for rank, u in enumerate(graph):
        marker, factor, face, ink = STATES[states[u]]
        zorder = 6 + rank / len(graph)
        artists += draw_markers(places[u], marker, factor * size, face, 1.4, zorder, ax)
        centred: Style = {"ha": "center", "va": "center_baseline", **palette.TEXT}
        x, y = places[u]
        artists.append(ax.text(x, y, str(u), color=ink, zorder=zorder, **centred))
    return artists


def draw_markers(
    at: Array, marker: str, size: float, face: str, rim: float, zorder: float, ax: Axes
) -> list[Artist]:
    """Draw markers at one place (2,) or several (k, 2)."""
    edge: Style = {"markeredgecolor": palette.INK, "markeredgewidth": rim, "color": face}
    return [*ax.plot(*at.T, marker, markersize=size, zorder=zorder, **edge)]


def write_weights(graph: Graph, places: Array, ax: Axes) -> list[Artist]:
    """Write each edge's weight at its midpoint."""
    artists: list[Artist] = []
    for (u, v), weight in zip(graph.edges, graph.weights):
        x, y = places[v] - places[u]
        middle = (places[u] + places[v]) / 2 + bend(graph, u, v) / 2 * np.array([y, -x])
        offset = (0, -5) if u != v else (0, 20)
        artists.append(write_beside(middle, f"{weight:.3g}", ax, offset, palette.INK, "center"))
    return artists


def write_beside(
    at: Array, text: str, ax: Axes, offset: tuple[float, float], colour: str, ha: Any = "left"
) -> Artist:
    """Write small words near a place, offset in points."""
    place: Style = {"xytext": offset, "textcoords": "offset points", "ha": ha}
    style: Style = {"fontsize": palette.TEXT_SIZE - 1, "color": colour, "path_effects": HALO}
    return ax.annotate(text, (at[0], at[1]), zorder=8, **place, **style)
