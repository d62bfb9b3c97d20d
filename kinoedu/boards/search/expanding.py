"""A search drawn so that it can be scrubbed: at each step the nodes expanded, the frontier, and who
is whose parent.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...graphs import Expansion, Graph, extract_path
from ...words import say
from ..core.drawing import Drawing, Layer, arrows, cells, dots, edges, labels, path
from ..core.scene import Scene

UNSEEN, FRONTIER, EXPANDED, EXPANDING = range(4)
MOST_NUMBERED = 40  # numbers of more nodes than this would cover the graph
WIDE = 600.0  # about so many pixels a board is wide


def search_drawn(
    graph: Graph,
    moments: Sequence[Expansion],
    ends: tuple[int, int],
    handles: Array,
    side: float,
    scene: Scene,
) -> Drawing:
    """A search from node to node; side : of a grid's cells, 0 for a graph. A step is an
    expansion.
    """
    (start, goal), places, total = ends, graph.nodes, len(moments)
    states, parents = states_at(moments, graph.size, start), parents_at(moments, graph.size)
    size = float(np.subtract(scene["hi"], scene["lo"]).max())
    radius = float(np.clip(11.0 - 0.06 * len(graph), 4.0, 10.0))
    layers = on_grid(places, states, side) if side else on_graph(graph, states, radius)
    layers.insert(
        len(layers) if side else 1,
        who_led(places, parents, (radius + 3.0) / WIDE * size if not side else 0.25 * side),
    )
    for node, here, colour in zip(ends, handles, ("start", "goal"), strict=True):
        layers.append(edges([[here, places[node]]], colour, width=2.0, dash=(4.0, 4.0)))
    said = {"expanded": total, "nodes": len(graph), "frontier": len(moments[-1].frontier)}
    found = moments[-1].node == goal
    if found:
        way = extract_path(moments[-1].parent, goal)
        layers.append(path(places[way], "path"))
        cost = sum(
            graph.weight(u, v) for u, v in zip(way[:-1].tolist(), way[1:].tolist(), strict=True)
        )
        text = say("search_board.found", **said, edges=len(way) - 1, cost=f"{cost:.4g}")
    else:
        text = say("search_board.failed", **said)
    if not side and len(graph) <= MOST_NUMBERED:
        text = say("search_board.between", start=start, goal=goal, outcome=text)
        layers.append(labels(places[list(graph)], [str(u) for u in graph], "ink"))
    return Drawing(
        layers,
        text=text,
        total=total,
        unit=say("search_board.unit"),
        told=told_of(moments, len(graph)),
    )


def told_of(moments: Sequence[Expansion], nodes: int) -> list[str]:
    """What is so at each step, in words."""
    told = [say("search_board.before", nodes=nodes)]
    for k, moment in enumerate(moments, start=1):
        told.append(
            say(
                "search_board.growing",
                expanded=k,
                nodes=nodes,
                frontier=len(moment.frontier),
                node=moment.node,
            )
        )
    return told


def states_at(moments: Sequence[Expansion], n: int, start: int) -> NDArray[np.int64]:
    """The state of each node at each step from 0, (steps + 1, n). A depth-first search's stack is
    its frontier.
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


def spells(
    values: NDArray[np.int64],
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """For how long values (steps, n) stay the same: node, value, the step when it came, the step
    when it went; by their coming.
    """
    changed = np.ones_like(values, dtype=bool)
    changed[1:] = values[1:] != values[:-1]
    node, when = np.nonzero(changed.T)  # node by node, in the order of time
    last = np.append(node[1:] != node[:-1], True)
    until = np.where(last, len(values), np.append(when[1:], 0))
    order = np.argsort(when, kind="stable")
    return node[order], values[when, node][order], when[order], until[order]


def on_grid(places: Array, states: NDArray[np.int64], side: float) -> list[Layer]:
    """Cells in the colours of their states, and their outlines."""
    square = 0.5 * side * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    corners = places[:, None] + square
    node, state, when, until = spells(states)
    layers = [
        cells(
            corners[node[state == which]],
            colour,
            when=when[state == which],
            until=until[state == which],
        )
        for which, colour in ((EXPANDED, "cell"), (FRONTIER, "frontier"), (EXPANDING, "ink"))
    ]
    outlines = np.stack([corners, np.roll(corners, -1, axis=1)], axis=2)
    return [*layers, edges(outlines, "outside", width=0.6)]


def on_graph(graph: Graph, states: NDArray[np.int64], radius: float) -> list[Layer]:
    """The edges, and the nodes in the colours of their states."""
    places, there = graph.nodes, list(graph)
    node, state, when, until = spells(states)
    layers = [
        edges(places[graph.edges], "outside", width=1.5),
        dots(places[there], "ink", radius=radius + 1.5),
        dots(places[there], "free", radius=radius),
    ]
    for which, colour, more in (
        (EXPANDED, "tree", 0.0),
        (FRONTIER, "frontier", 0.0),
        (EXPANDING, "ink", 3.0),
    ):
        these = state == which
        layers.append(
            dots(
                places[node[these]],
                colour,
                radius=radius + more,
                when=when[these],
                until=until[these],
            )
        )
    return layers


def who_led(places: Array, parents: NDArray[np.int64], gap: float) -> Layer:
    """Arrows from parents to children, which end a gap before the child."""
    child, parent, when, until = spells(parents)
    led = parent >= 0
    begins, ends = places[parent[led]], places[child[led]]
    along = ends - begins
    length = np.maximum(np.sqrt((along * along).sum(axis=1)), 1e-300)
    return arrows(
        begins,
        along * np.maximum(1.0 - gap / length, 0.2)[:, None],
        "tree",
        width=2.0,
        when=when[led],
        until=until[led],
    )
