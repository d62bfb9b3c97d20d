"""The layers of a search, of a graph or of a grid."""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled
from ..geometry.checks import Array
from ..graphs.flat import GraphRecord, degree, edge
from .search_runs import EXPANDED, EXPANDING, FRONTIER, Numbers, Runs

MOST_NUMBERED = 40  # the numbers of more nodes than this would cover the graph
WIDE = 600.0  # about the width of a board in pixels
FOUND, FAILED, NUMBERED = 0, 1, 2  # the status; NUMBERED is added where nodes have numbers


class Posed(NamedTuple):
    """A search that is to be run and shown.

    nodes, there : (n, 2) places, (n,) whether a node is there.
    ends : the nodes start and goal; here : (2, 2), where their handles are.
    heuristic : (n,), zeros where the search has none.
    size : of the world.
    """

    graph: GraphRecord
    nodes: Array
    there: NDArray[np.bool_]
    start: int
    goal: int
    here: Array
    heuristic: Array
    side: float
    size: float


class ShownSearch(NamedTuple):
    """What is shown of a search; of a grid and of a graph different layers.

    facts : (13,), the status, the numbers of expansions, nodes and waiting nodes, cost and edges of
        the path, start, goal, steps, and sizes: of a dot, its rim and the one being expanded, and
        how near a pointer must come.
    expanded, waiting, now : (m, 10), cells by state, rows of corners, first step, step after.
    outlines : (m, 4), of a grid's cells; lines : (m, 4), a graph's edges.
    parents : (m, 6), rows x, y, dx, dy, first step, step after.
    spots : (n, 2), a graph's nodes; expanded_spots, waiting_spots, spot_now : (m, 4), by state.
    notes : (m, 8), rows x, y, node, parent, state, cost, first step, step after; with a heuristic
        (m, 10), h and f after the cost.
    from_start, from_goal : (1, 4), from handles to nodes.
    path : (k, 2).
    numbers : (n, 3), rows x, y, node.
    moments : (s, 5), rows which text, nodes, expanded, waiting, node.
    """

    facts: Array
    expanded: Array
    waiting: Array
    now: Array
    outlines: Array
    lines: Array
    parents: Array
    spots: Array
    expanded_spots: Array
    waiting_spots: Array
    spot_now: Array
    notes: Array
    from_start: Array
    from_goal: Array
    path: Array
    numbers: Array
    moments: Array


@compiled
def show_runs(posed: Posed, runs: Runs, informed: bool) -> ShownSearch:
    """All layers of a search."""
    rows, moments = runs.rows[: runs.counts[0]], runs.moments[: runs.counts[1]]
    total = len(moments)
    for at in runs.current:
        rows[at, 5] = total + 1
    nodes, there, side = posed.nodes, np.flatnonzero(posed.there), posed.side
    radius = min(max(11.0 - 0.06 * len(there), 4.0), 10.0)
    gap = 0.25 * side if side > 0.0 else (radius + 3.0) / WIDE * posed.size
    path, is_numbered = path_of(posed, runs), side == 0.0 and len(there) <= MOST_NUMBERED
    facts = np.array(
        [
            (FOUND if len(path) else FAILED) + (NUMBERED if is_numbered else 0),
            total,
            len(there),
            moments[total - 1, 1],
            cost_of(posed.graph, path),
            len(path) - 1,
            posed.start,
            posed.goal,
            total,
            radius,
            radius + 1.5,
            radius + 3.0,
            max(0.7 * side / posed.size, 0.02),
        ]
    )
    expanded, waiting = runs_in(rows, EXPANDED), runs_in(rows, FRONTIER)
    now, grid = runs_in(rows, EXPANDING), there if side > 0.0 else there[:0]
    places = there if side == 0.0 else there[:0]
    return ShownSearch(
        facts,
        cells_of(nodes, expanded, side),
        cells_of(nodes, waiting, side),
        cells_of(nodes, now, side),
        outlines_of(nodes, grid, side),
        lines_of(posed),
        arrows_of(nodes, rows, gap),
        nodes[places],
        dots_of(nodes, expanded, side),
        dots_of(nodes, waiting, side),
        dots_of(nodes, now, side),
        notes_of(posed, rows, informed),
        link_of(posed.here[0], nodes[posed.start]),
        link_of(posed.here[1], nodes[posed.goal]),
        nodes[path],
        numbers_of(nodes, there if is_numbered else there[:0]),
        texts_of(moments, len(there)),
    )


@compiled
def path_of(posed: Posed, runs: Runs) -> Numbers:
    """The nodes of the path, none where the goal was not expanded."""
    rows, current = runs.rows, runs.current
    path, size = np.empty(len(current), np.int64), 0
    if rows[current[posed.goal], 1] != EXPANDING:
        return path[:0]
    u = posed.goal
    while u >= 0:
        path[size], size = u, size + 1
        u = int(rows[current[u], 2])
    return path[:size][::-1].copy()


@compiled
def cost_of(graph: GraphRecord, path: Numbers) -> float:
    """The weights along a path, of parallel edges the least."""
    cost = 0.0
    for i in range(len(path) - 1):
        least = np.inf
        for k in range(degree(graph, path[i])):
            v, weight = edge(graph, path[i], k)
            if v == path[i + 1]:
                least = min(least, weight)
        cost += least
    return cost


@compiled
def runs_in(rows: Array, state: int) -> Array:
    """The runs of a state."""
    return rows[rows[:, 1] == state]


@compiled
def cells_of(nodes: Array, runs: Array, side: float) -> Array:
    """The cells of runs; none in a graph."""
    cells = np.empty((len(runs) if side > 0.0 else 0, 10))
    for i in range(len(cells)):
        u = int(runs[i, 0])
        for corner in range(4):
            right, up = corner in (1, 2), corner >= 2
            cells[i, 2 * corner] = nodes[u, 0] + (0.5 * side if right else -0.5 * side)
            cells[i, 2 * corner + 1] = nodes[u, 1] + (0.5 * side if up else -0.5 * side)
        cells[i, 8], cells[i, 9] = runs[i, 4], runs[i, 5]
    return cells


@compiled
def outlines_of(nodes: Array, there: Numbers, side: float) -> Array:
    """The sides of cells."""
    lines = np.empty((4 * len(there), 4))
    for i in range(len(there)):
        x, y = nodes[there[i], 0], nodes[there[i], 1]
        for k in range(4):
            dx, dy = (-1.0, 1.0, 1.0, -1.0)[k], (-1.0, -1.0, 1.0, 1.0)[k]
            lines[4 * i + k, 0], lines[4 * i + k, 1] = x + 0.5 * side * dx, y + 0.5 * side * dy
            lines[4 * i + k, 2], lines[4 * i + k, 3] = x - 0.5 * side * dy, y + 0.5 * side * dx
    return lines


@compiled
def lines_of(posed: Posed) -> Array:
    """The edges of a graph; none of a grid."""
    pairs, nodes = posed.graph.edges, posed.nodes
    lines = np.empty((len(pairs) if posed.side == 0.0 else 0, 4))
    for e in range(len(lines)):
        u, v = pairs[e, 0], pairs[e, 1]
        lines[e, 0], lines[e, 1] = nodes[u, 0], nodes[u, 1]
        lines[e, 2], lines[e, 3] = nodes[v, 0], nodes[v, 1]
    return lines


@compiled
def arrows_of(nodes: Array, rows: Array, gap: float) -> Array:
    """Arrows from parents to children, which end a gap before the child."""
    led = rows[rows[:, 2] >= 0.0]
    arrows = np.empty((len(led), 6))
    for i in range(len(led)):
        child, parent = int(led[i, 0]), int(led[i, 2])
        dx, dy = nodes[child, 0] - nodes[parent, 0], nodes[child, 1] - nodes[parent, 1]
        length = max(math.sqrt(dx * dx + dy * dy), 1e-300)
        part = max(1.0 - gap / length, 0.2)
        arrows[i, 0], arrows[i, 1] = nodes[parent, 0], nodes[parent, 1]
        arrows[i, 2], arrows[i, 3] = part * dx, part * dy
        arrows[i, 4], arrows[i, 5] = led[i, 4], led[i, 5]
    return arrows


@compiled
def dots_of(nodes: Array, runs: Array, side: float) -> Array:
    """The dots of runs; none in a grid."""
    dots = np.empty((len(runs) if side == 0.0 else 0, 4))
    for i in range(len(dots)):
        dots[i, 0], dots[i, 1] = nodes[int(runs[i, 0]), 0], nodes[int(runs[i, 0]), 1]
        dots[i, 2], dots[i, 3] = runs[i, 4], runs[i, 5]
    return dots


@compiled
def notes_of(posed: Posed, rows: Array, informed: bool) -> Array:
    """What each node says at each step: its state, and its costs."""
    nodes = posed.nodes
    notes = np.empty((len(rows), 10 if informed else 8))
    for i in range(len(rows)):
        u = int(rows[i, 0])
        notes[i, 0], notes[i, 1], notes[i, 2] = nodes[u, 0], nodes[u, 1], u
        notes[i, 3], notes[i, 4], notes[i, 5] = rows[i, 2], rows[i, 1], rows[i, 3]
        if informed:
            notes[i, 6], notes[i, 7] = posed.heuristic[u], rows[i, 3] + posed.heuristic[u]
        notes[i, -2], notes[i, -1] = rows[i, 4], rows[i, 5]
    return notes[posed.there[rows[:, 0].astype(np.int64)]]


@compiled
def link_of(here: Array, node: Array) -> Array:
    """A line from a handle to a node."""
    return np.array([here[0], here[1], node[0], node[1]]).reshape(1, 4)


@compiled
def numbers_of(nodes: Array, there: Numbers) -> Array:
    """The numbers of nodes."""
    numbers = np.empty((len(there), 3))
    for i in range(len(there)):
        u = there[i]
        numbers[i, 0], numbers[i, 1], numbers[i, 2] = nodes[u, 0], nodes[u, 1], u
    return numbers


@compiled
def texts_of(moments: Array, nodes: int) -> Array:
    """The numbers of the text at each step from 0, on which only the start waits."""
    texts = np.zeros((len(moments) + 1, 5))
    for k in range(len(texts)):
        texts[k, 1] = nodes
        if k > 0:
            texts[k, 0], texts[k, 2] = 1.0, moments[k - 1, 0]
            texts[k, 3], texts[k, 4] = moments[k - 1, 1], moments[k - 1, 2]
    return texts
