"""The body of the sweep's board: the cells that a vertical line has left, and what it crosses."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled
from ..decomposition.cells import CELLS, CLOSED, WALLS
from ..decomposition.crossing import height_at
from ..decomposition.status import CELL, NOBODY, next_above
from ..decomposition.sweep import Sweep, events, new_sweep
from ..decomposition.trapezoidation import KINDS, drain
from ..geometry.checks import Array
from ..geometry.rings import SIMPLE
from ..worlds.polygon_world import edges_of_rings
from .nearest import NoSettings
from .scenes import REFUSED, SceneArrays, find_fault, no_four, no_rows, refuse_ring, rings_of_scene

BEFORE, NOW, ENDED = 0, 1, 2  # the status
OVERLAP = REFUSED  # the first reason for which nothing is shown
TOUCH, SEVERAL = 5, 6  # the events after the five types
TYPES = tuple(KINDS)  # the numbers of cells that end and begin, for each type of a vertex
MOST_JOINED = 6  # the most neighbours of a cell that it names
GAP = 0.045  # between the names of edges, as a fraction of the world's size

Numbers = NDArray[np.int64]


class ShownSweep(NamedTuple):
    """What is shown of a sweep up to a line.

    facts : (4,), the status, x of the line or of its last event, numbers of closed and open cells.
    closed : (c, 18), rows of corners, number of neighbours, number, x of both walls, neighbours.
    closed_sides, open_sides : (m, 4), the sides of closed and open cells.
    numbers : (c, 3), rows x, y, number of a closed cell.
    line : (1, 4), the sweep line.
    floors, ceilings : (k, 4), the edges that the line crosses.
    met, now : (m, 2), the vertices met so far, and at the last event.
    crossings : (2 k, 2), where the line crosses edges.
    floor_names, ceiling_names : (k, 3), rows x, y, number of the edge.
    event : (1, 2), the kind of the last event, and the number of its vertices.
    status : (2 k, 1), the numbers of the edges from bottom to top.
    """

    facts: Array
    closed: Array
    closed_sides: Array
    open_sides: Array
    numbers: Array
    line: Array
    floors: Array
    ceilings: Array
    met: Array
    now: Array
    crossings: Array
    floor_names: Array
    ceiling_names: Array
    event: Array
    status: Array


@algorithm
def show_sweep(scene: SceneArrays, settings: NoSettings, rng: np.random.Generator) -> ShownSweep:
    """The sweep up to the first handle, in a scene of polygons."""
    ring, fault = find_fault(scene)
    if fault.kind != SIMPLE:
        return show_line(refuse_ring(ring, fault), no_rows())
    edges = edges_of_rings(rings_of_scene(scene))
    return show_cut(edges, scene.handles[0, 0], scene.lo, scene.hi)


@algorithm
def show_cut(edges: Array, x: float, lo: Array, hi: Array) -> ShownSweep:
    """The sweep of edges (n, 5) up to a line at x, in a picture from lo to hi."""
    line = np.array([x, lo[1], x, hi[1]]).reshape(1, 4)
    if not drain(new_sweep(edges)):
        return show_line(np.array([OVERLAP, x, 0.0, 0.0]), line[:0].copy())
    state = new_sweep(edges)
    size, vertices = max(hi[0] - lo[0], hi[1] - lo[1]), state.vertices[state.order]
    if vertices[0, 0] > x:
        return show_line(np.array([BEFORE, x, 0.0, 0.0]), line)
    before = after = closed = opened = ended = begun = 0
    for handled in events(state):
        before, after = after, handled
        ended, begun = state.sizes[CLOSED] - closed, state.sizes[CELLS] - opened
        closed, opened = state.sizes[CLOSED], state.sizes[CELLS]
        if after == len(vertices) or vertices[after, 0] > x:
            break
    done, crossed = state.closed[: state.sizes[CLOSED]].copy(), open_cells(state)
    sides = state.sides[crossed].copy().reshape(-1)
    heights, places = np.empty(len(sides)), np.empty((len(sides), 2))
    for k in range(len(sides)):
        heights[k] = height_at(state.ends, sides[k], x)
        places[k, 0], places[k, 1] = x, heights[k]
    corners, number = corners_of_closed(state, done), number_edges(state.ends)[sides]
    names = np.column_stack((places, number.astype(np.float64)))
    names[:, 1] = spread_heights(heights, GAP * size)
    rows, now = state.ends[sides], vertices[before:after].copy()
    kind = SEVERAL if len(now) > 1 else type_of(ended, begun)
    where, last = NOW if len(sides) > 0 else ENDED, vertices[before, 0]
    return ShownSweep(
        np.array([where, last, len(done), len(crossed)], np.float64),
        with_neighbours(state, done, corners),
        sides_of(corners),
        sides_of(corners_of_open(state, crossed, heights, x)),
        numbers_in(corners, 0.024 * size),
        line,
        rows[::2].copy(),
        rows[1::2].copy(),
        vertices[:after].copy(),
        now,
        places,
        names[::2].copy(),
        names[1::2].copy(),
        np.array([kind, len(now)], np.float64).reshape(1, 2),
        number.astype(np.float64).reshape(-1, 1),
    )


@compiled
def show_line(facts: Array, line: Array) -> ShownSweep:
    """The answer where no cell is shown."""
    a, b, c, d = no_four()
    return ShownSweep(facts, a, b, c, d, line, no_rows(), *no_four(), *no_four())


@compiled
def type_of(ended: int, begun: int) -> int:
    """The kind of an event at one vertex, by the numbers of cells that end and begin there."""
    for kind in range(len(TYPES)):
        if TYPES[kind][0] == ended and TYPES[kind][1] == begun:
            return kind
    return TOUCH


@compiled
def open_cells(state: Sweep) -> Numbers:
    """The cells that the line crosses, from bottom to top."""
    found, size = np.empty(state.sizes[CELLS], np.int64), 0
    node = next_above(state.nodes, NOBODY)
    while node != NOBODY:
        found[size], size = state.nodes[node, CELL], size + 1
        node = next_above(state.nodes, node)
    return found[:size].copy()


@compiled
def number_edges(ends: Array) -> Numbers:
    """A number for each edge that a line can cross; -1 for the vertical ones.

    They are numbered from left to right by their left ends, lower ones first.
    """
    slopes = np.full(len(ends), np.inf)
    for i in range(len(ends)):
        if ends[i, 0] < ends[i, 2]:
            slopes[i] = (ends[i, 3] - ends[i, 1]) / (ends[i, 2] - ends[i, 0])
    order = np.argsort(slopes, kind="mergesort")
    order = order[np.argsort(ends[order, 1], kind="mergesort")]
    order = order[np.argsort(ends[order, 0], kind="mergesort")]
    number, size = np.full(len(ends), -1, np.int64), 0
    for i in order:
        if ends[i, 0] < ends[i, 2]:
            number[i], size = size, size + 1
    return number


@compiled
def corners_of_closed(state: Sweep, done: Numbers) -> Array:
    """The corners of closed cells, counter-clockwise from the lower left, (c, 8)."""
    corners = np.empty((len(done), 8))
    for i in range(len(done)):
        left, right, low, high, low_right, high_right = state.cells[done[i]]
        write_corners(corners[i], left, right, (low, high), (low_right, high_right))
    return corners


@compiled
def corners_of_open(state: Sweep, crossed: Numbers, heights: Array, x: float) -> Array:
    """The corners of the part of each open cell that lies left of the line, (k, 8)."""
    corners = np.empty((len(crossed), 8))
    for i in range(len(crossed)):
        cell = state.cells[crossed[i]]
        right = heights[2 * i], heights[2 * i + 1]
        write_corners(corners[i], cell[0], x, (cell[2], cell[3]), right)
    return corners


@compiled
def write_corners(
    row: Array,
    left: float,
    right: float,
    at_left: tuple[float, float],
    at_right: tuple[float, float],
) -> None:
    """Write the corners of a trapezoid, counter-clockwise from the lower left."""
    row[0], row[1], row[2], row[3] = left, at_left[0], right, at_right[0]
    row[4], row[5], row[6], row[7] = right, at_right[1], left, at_left[1]


@compiled
def sides_of(corners: Array) -> Array:
    """The sides of quadrangles (n, 8), (4 n, 4)."""
    sides = np.empty((4 * len(corners), 4))
    for i in range(len(corners)):
        for k in range(4):
            for axis in range(2):
                sides[4 * i + k, axis] = corners[i, 2 * k + axis]
                sides[4 * i + k, 2 + axis] = corners[i, (2 * k + 2 + axis) % 8]
    return sides


@compiled
def numbers_in(corners: Array, aside: float) -> Array:
    """The number of each closed cell, from 1, a little below and left of its middle."""
    numbers = np.empty((len(corners), 3))
    for i in range(len(corners)):
        for axis in range(2):
            total = 0.0
            for k in range(4):
                total += corners[i, 2 * k + axis]
            numbers[i, axis] = total / 4.0 - aside
        numbers[i, 2] = i + 1
    return numbers


@compiled
def with_neighbours(state: Sweep, done: Numbers, corners: Array) -> Array:
    """The closed cells with what they say: number, x of both walls, the cells they are joined to.

    Of more than MOST_JOINED neighbours the first ones are named.
    """
    n = len(done)
    number, joined = np.full(state.sizes[CELLS], -1, np.int64), np.zeros((n, n), np.bool_)
    for i in range(n):
        number[done[i]] = i
    for k in range(state.sizes[WALLS]):
        i, j = number[state.pairs[k, 0]], number[state.pairs[k, 1]]
        if i >= 0 and j >= 0:
            joined[i, j] = joined[j, i] = True
    rows = np.zeros((n, 12 + MOST_JOINED))
    for i in range(n):
        rows[i, :8] = corners[i]
        rows[i, 9], rows[i, 10], rows[i, 11] = i + 1, corners[i, 0], corners[i, 2]
        count = 0
        for j in np.flatnonzero(joined[i]):
            if count < MOST_JOINED:
                rows[i, 12 + count] = j + 1
            count += 1
        rows[i, 8] = min(count, MOST_JOINED + 1)
    return rows


@compiled
def spread_heights(heights: Array, gap: float) -> Array:
    """Heights in increasing order, pushed up where they are closer than a gap."""
    places = heights.copy()
    for k in range(1, len(places)):
        places[k] = max(places[k], places[k - 1] + gap)
    return places
