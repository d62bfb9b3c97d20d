"""Graphs: nodes, edges, numbers, weights, paths and trees on them. A node's state shows by its
colour and by its marker.
"""

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.patches import FancyArrowPatch
from matplotlib.transforms import ScaledTranslation
from numpy.typing import ArrayLike, NDArray

from ..geometry.checks import Array
from ..graphs import Graph
from . import palette
from .drawing import HALO, draw_path
from .plane import frame

MOST_LABELS = 60  # numbers of more nodes than this would cover the graph
BEND = 0.16  # of the way between two nodes, where an edge leads each way
LINK = palette.OUTSIDE

# marker, its size against a circle's, face, ink of its number
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
    """Draw a graph where its nodes are, by their first two coordinates; one that is in no space on
    a circle.

    Parameters
    ----------
    labels : write each node's number in it; by default up to 60 nodes. weights : write each edge's
    weight beside it. highlight, highlight_edges : nodes (k,) and edges (j, 2) to be seen first.
    path : nodes (k,) along which a path is drawn.
    parents : (n,) as a search gives them, drawn as arrows from each parent to its child; -1 for
    none.
    frontier : nodes (k,) that are drawn as waiting.

    Directed edges are arrows. Returns the artists.

    >>> artists = draw_graph(Graph(nodes=[(0, 0), (1, 0), (0, 1)], edges=[(0, 1), (1, 2)]), path=[0, 1, 2])
    >>> plt.close()
    """
    states = dict.fromkeys(graph, "unseen")
    along = np.array([] if path is None else path, np.int64)
    states.update(dict.fromkeys(numbers(highlight) + along.tolist(), "marked"))
    states.update(dict.fromkeys(numbers(frontier), "frontier"))
    places = layout(graph)
    ax = axes_round(graph, places, ax)
    numbered = len(graph) <= MOST_LABELS if labels is None else labels
    artists = draw_links(graph, places, ax, gap=node_size(graph, numbered) / 2)
    if weights:
        artists += write_weights(graph, places, ax)
    if parents is not None:
        artists += draw_parents(
            graph, np.asarray(parents), places, ax, gap=node_size(graph, numbered) / 2
        )
    for u, v in np.asarray(highlight_edges, np.int64).reshape(-1, 2):
        artists += link(
            places[u],
            places[v],
            ax,
            palette.PATH,
            arrow=graph.directed,
            width=4.0,
            bend=bend(graph, u, v),
        )
    if len(along) > 1:
        artists += draw_path(places[along], ax)
    return artists + draw_nodes(graph, places, states, ax, numbered)


def layout(graph: Graph) -> Array:
    """Where nodes are drawn, shape (n, 2)."""
    if graph.space is None:
        angles = np.pi / 2 - 2 * np.pi * np.arange(graph.size) / max(graph.size, 1)
        return np.column_stack([np.cos(angles), np.sin(angles)])
    nodes = graph.nodes
    return nodes[:, :2] if nodes.shape[1] > 1 else np.column_stack([nodes, np.zeros(len(nodes))])


def numbers(nodes: ArrayLike) -> list[int]:
    """Nodes as a list of plain numbers."""
    return np.atleast_1d(np.asarray(nodes, np.int64)).tolist()


def axes_round(graph: Graph, places: Array, ax: Axes | None) -> Axes:
    """The axes given, or new ones that show all nodes; without scales where the places mean
    nothing.
    """
    if ax is None:
        _, ax = plt.subplots(figsize=(7.0, 5.0), dpi=72, layout="constrained")
        frame(places[list(graph)] if len(graph) else np.zeros((1, 2)), ax)
        if graph.space is None:
            ax.set_axis_off()
    return ax


def node_size(graph: Graph, numbered: bool) -> float:
    """The diameter of a node in points."""
    return float(
        np.clip(28.0 - 0.2 * len(graph), 16.0, 25.0)
        if numbered
        else np.clip(12.0 - 3.0 * np.log10(len(graph) + 1), 2.5, 9.0)
    )


def bend(graph: Graph, u: int, v: int) -> float:
    """How far an edge is bent aside: only where another leads back."""
    return BEND if graph.directed and u != v and graph.is_edge(v, u) else 0.0


def draw_links(graph: Graph, places: Array, ax: Axes, *, gap: float) -> list[Artist]:
    """The edges: lines, or arrows where they are directed; loops as rings above their node."""
    edges = graph.edges
    loops = np.unique(edges[edges[:, 0] == edges[:, 1], 0])
    aside = ax.transData + ScaledTranslation(0, gap / 72.0, ax.figure.dpi_scale_trans)
    artists: list[Artist] = [
        *ax.plot(
            *places[loops].T, "o", fillstyle="none", markersize=max(1.4 * gap, 4), color=LINK, markeredgewidth=1.8, zorder=2,
            transform=aside,
        )
    ]  # fmt: skip
    apart = edges[edges[:, 0] != edges[:, 1]]
    if not graph.directed:
        width = float(np.clip(2.6 - 0.4 * np.log10(len(edges) + 1), 0.5, 2.0))
        return [
            *artists,
            ax.add_collection(
                LineCollection(list(places[apart]), colors=LINK, linewidths=width, zorder=2),
                autolim=False,
            ),
        ]
    for u, v in apart:
        artists += link(
            places[u],
            places[v],
            ax,
            LINK,
            arrow=True,
            width=1.6,
            gap=gap,
            bend=bend(graph, u, v),
            zorder=2,
        )
    return artists


def link(
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
    """One edge, a gap in points short of its ends."""
    style = "-|>" if arrow else "-"
    curve = f"arc3,rad={bend}"
    patch = FancyArrowPatch(
        (a[0], a[1]), (b[0], b[1]), arrowstyle=style, connectionstyle=curve, color=colour, linewidth=width, shrinkA=gap,
        shrinkB=gap, mutation_scale=8.0 + 3.5 * width, zorder=zorder,
    )  # fmt: skip
    return [ax.add_patch(patch)]


def draw_parents(
    graph: Graph, parents: NDArray[np.int64], places: Array, ax: Axes, *, gap: float
) -> list[Artist]:
    """Arrows from parents to children; where there are many, lines."""
    children = np.flatnonzero(parents >= 0)
    if len(parents) > MOST_LABELS:
        segments = list(np.stack([places[parents[children]], places[children]], axis=1))
        return [
            ax.add_collection(
                LineCollection(segments, colors=palette.TREE, linewidths=2.0, zorder=3),
                autolim=False,
            )
        ]
    artists: list[Artist] = []
    for child in children.tolist():
        aside = bend(graph, int(parents[child]), child)
        artists += link(
            places[parents[child]],
            places[child],
            ax,
            palette.TREE,
            arrow=True,
            width=2.6,
            gap=gap,
            bend=aside,
        )
    return artists


def draw_nodes(
    graph: Graph, places: Array, states: dict[int, str], ax: Axes, numbered: bool
) -> list[Artist]:
    """Each node by its state, with its number in it: one over the other where they are near, number
    and all.
    """
    artists: list[Artist] = []
    size = node_size(graph, numbered)
    if not numbered:
        for state, (marker, factor, face, _) in STATES.items():
            here = [u for u in graph if states[u] == state]
            artists += dots(places[here], marker, factor * size, face, 0.6, 6, ax)
        return artists
    for rank, u in enumerate(graph):
        (x, y), (marker, factor, face, ink), zorder = (
            places[u],
            STATES[states[u]],
            6 + rank / len(graph),
        )
        artists += dots(places[u], marker, factor * size, face, 1.4, zorder, ax)
        artists.append(
            ax.text(
                x,
                y,
                str(u),
                color=ink,
                fontsize=palette.TEXT_SIZE,
                ha="center",
                va="center_baseline",
                zorder=zorder,
            )
        )
    return artists


def dots(
    at: Array, marker: str, size: float, face: str, rim: float, zorder: float, ax: Axes
) -> list[Artist]:
    """Markers at one place (2,) or several (k, 2)."""
    return [
        *ax.plot(
            *at.T,
            marker,
            markersize=size,
            markerfacecolor=face,
            markeredgecolor=palette.INK,
            markeredgewidth=rim,
            zorder=zorder,
        )
    ]


def write_weights(graph: Graph, places: Array, ax: Axes) -> list[Artist]:
    """Each edge's weight at its middle."""
    artists: list[Artist] = []
    for (u, v), weight in zip(graph.edges, graph.weights):
        along = places[v] - places[u]
        middle = (places[u] + places[v]) / 2 + bend(graph, u, v) / 2 * np.array(
            [along[1], -along[0]]
        )
        artists.append(
            beside(
                middle, f"{weight:.3g}", ax, (0, -5) if u != v else (0, 20), palette.INK, "center"
            )
        )
    return artists


def beside(
    at: Array, words: str, ax: Axes, offset: tuple[float, float], colour: str, ha: Any = "left"
) -> Artist:
    """Small words near a place, offset in points."""
    return ax.annotate(
        words, (at[0], at[1]), xytext=offset, textcoords="offset points", fontsize=palette.TEXT_SIZE - 1, color=colour, ha=ha,
        path_effects=HALO, zorder=8,
    )  # fmt: skip
