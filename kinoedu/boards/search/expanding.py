"""A search that can be scrubbed: expanded nodes, frontier and parents at each step."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...graphs import Expansion, Graph, extract_path
from ...messages import get_message
from ..core.drawing import Drawing, Layer, arrows, cells, dots, edges, labels, nodes, path
from ..core.notes import note, with_notes
from ..core.scene import Scene

Numbers = NDArray[np.int64]

UNSEEN, FRONTIER, EXPANDED, EXPANDING = range(4)
STATES = ("unseen", "frontier", "expanded", "expanding")  # their names
MOST_NUMBERED = 40  # the numbers of more nodes than this would cover the graph
WIDE = 600.0  # about the width of a board in pixels


def draw_search(
    graph: Graph,
    moments: Sequence[Expansion],
    ends: tuple[int, int],
    handles: Array,
    side: float,
    scene: Scene,
    heuristic: Array | None = None,
) -> Drawing:
    """Draw a search from node to node; one step is one expansion.

    Parameters
    ----------
    ends : the nodes start and goal.
    handles : (2, 2), where start and goal were dragged.
    side : the side of a grid's cells, 0 for a graph.
    heuristic : (n,), of A*.
    """
    (start, goal), places, total = ends, graph.nodes, len(moments)
    states, parents = states_at(moments, graph.size, start), parents_at(moments, graph.size)
    size = float(np.subtract(scene["hi"], scene["lo"]).max())
    radius = float(np.clip(11.0 - 0.06 * len(graph), 4.0, 10.0))
    if side:
        layers = [*draw_on_grid(places, states, side), draw_parents(places, parents, 0.25 * side)]
    else:
        edge_layer, *nodes = draw_on_graph(graph, states, radius)
        gap = (radius + 3.0) / WIDE * size
        layers = [edge_layer, draw_parents(places, parents, gap), *nodes]
    notes = note_nodes(places, moments, states, parents, heuristic)
    layers.append(notes._replace(width=max(0.7 * side / size, notes.width)))
    for node, here, colour in zip(ends, handles, ("start", "goal"), strict=True):
        layers.append(edges([[here, places[node]]], colour, width=2.0, dash=(4.0, 4.0)))
    counts = {"expanded": total, "nodes": len(graph), "frontier": len(moments[-1].frontier)}
    if moments[-1].node == goal:
        found = extract_path(moments[-1].parent, goal)
        layers.append(path(places[found], "path"))
        cost = sum(graph.weight(u, v) for u, v in pairwise(found.tolist()))
        text = get_message("search_board.found", **counts, edges=len(found) - 1, cost=f"{cost:.4g}")
    else:
        text = get_message("search_board.failed", **counts)
    if not side and len(graph) <= MOST_NUMBERED:
        text = get_message("search_board.between", start=start, goal=goal, outcome=text)
        layers.append(labels(places[list(graph)], [str(u) for u in graph], "ink"))
    unit, texts = get_message("search_board.unit"), describe_steps(moments, len(graph))
    return Drawing(layers, text=text, total=total, unit=unit, step_texts=texts)


def describe_steps(moments: Sequence[Expansion], nodes: int) -> list[str]:
    """The state of the search at each step, in words."""
    texts = [get_message("search_board.before", nodes=nodes)]
    for k, moment in enumerate(moments, start=1):
        counts = {"expanded": k, "nodes": nodes, "frontier": len(moment.frontier)}
        texts.append(get_message("search_board.growing", **counts, node=moment.node))
    return texts


def states_at(moments: Sequence[Expansion], n: int, start: int) -> NDArray[np.int64]:
    """The state of each node at each step from 0, (steps + 1, n).

    The frontier of a depth-first search is its stack.
    """
    states = np.full((len(moments) + 1, n), UNSEEN)
    states[0, start] = FRONTIER
    for k, moment in enumerate(moments, start=1):
        states[k, moment.expanded] = EXPANDED
        states[k, moment.frontier] = FRONTIER
        states[k, moment.node] = EXPANDING
    return states


def parents_at(moments: Sequence[Expansion], n: int) -> NDArray[np.int64]:
    """The parent of each node at each step from 0, (steps + 1, n)."""
    return np.concatenate([np.full((1, n), -1), *(moment.parent[None] for moment in moments)])


def note_nodes(
    places: Array,
    moments: Sequence[Expansion],
    states: Numbers,
    parents: Numbers,
    heuristic: Array | None,
) -> Layer:
    """What each node says at each step: its state, and its costs."""
    costs = np.array([np.where(states[0] == FRONTIER, 0.0, np.inf), *(m.cost for m in moments)])
    changed = np.zeros(states.shape, np.int64)
    for values in (states, parents, costs):
        changed[1:] |= values[1:] != values[:-1]
    node, _, when, until = find_runs(changed.cumsum(axis=0))
    g = costs[when, node]
    columns = {"node": node, "parent": parents[when, node], "which": states[when, node], "g": g}
    says = note("g", g=None)
    if heuristic is not None:
        says, h = note("gh", g=None, h=None, f=None), heuristic[node]
        columns |= {"h": h, "f": g + h}
    texts = [note(name, node=None, costs=says) for name in STATES]
    return with_notes(nodes(places[node], when=when, until=until), *texts, **columns)


def find_runs(values: Numbers) -> tuple[Numbers, Numbers, Numbers, Numbers]:
    """The runs of equal values in each column of values (steps, n), by the step of their begin.

    Returns four arrays: node, value, first step, and the step after the last.
    """
    changed = np.ones_like(values, dtype=bool)
    changed[1:] = values[1:] != values[:-1]
    node, when = np.nonzero(changed.T)  # node by node, in the order of time
    last = np.append(node[1:] != node[:-1], True)
    until = np.where(last, len(values), np.append(when[1:], 0))
    order = np.argsort(when, kind="stable")
    return node[order], values[when, node][order], when[order], until[order]


def draw_on_grid(places: Array, states: NDArray[np.int64], side: float) -> list[Layer]:
    """Cells in the colours of their states, and their outlines."""
    square = 0.5 * side * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    corners = places[:, None] + square
    node, state, when, until = find_runs(states)
    layers = []
    for which, colour in ((EXPANDED, "cell"), (FRONTIER, "frontier"), (EXPANDING, "ink")):
        these = state == which
        shapes = corners[node[these]]
        layers.append(cells(shapes, colour, when=when[these], until=until[these]))
    outlines = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2)
    return [*layers, edges(outlines, "outside", width=0.6)]


def draw_on_graph(graph: Graph, states: NDArray[np.int64], radius: float) -> list[Layer]:
    """The edges, and the nodes in the colours of their states."""
    places, there = graph.nodes, list(graph)
    node, state, when, until = find_runs(states)
    layers = [
        edges(places[graph.edges], "outside", width=1.5),
        dots(places[there], "ink", radius=radius + 1.5),
        dots(places[there], "free", radius=radius),
    ]
    looks = ("tree", radius), ("frontier", radius), ("ink", radius + 3.0)
    for which, (colour, size) in zip((EXPANDED, FRONTIER, EXPANDING), looks, strict=True):
        these = state == which
        span = {"when": when[these], "until": until[these]}
        layers.append(dots(places[node[these]], colour, radius=size, **span))
    return layers


def draw_parents(places: Array, parents: NDArray[np.int64], gap: float) -> Layer:
    """Arrows from parents to children, which end a gap before the child."""
    child, parent, when, until = find_runs(parents)
    led = parent >= 0
    begins, ends = places[parent[led]], places[child[led]]
    along = ends - begins
    length = np.maximum(np.sqrt((along * along).sum(axis=1)), 1e-300)
    shorter = along * np.maximum(1.0 - gap / length, 0.2)[:, None]
    return arrows(begins, shorter, "tree", width=2.0, when=when[led], until=until[led])
