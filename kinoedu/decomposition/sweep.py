"""A vertical line sweeps a polygonal world from left to right: where it meets vertices, cells end
and others begin.

Bullo & Smith, chapter 2, the sweeping trapezoidation algorithm; M. de Berg, O. Cheong, M. van
Kreveld, M. Overmars, Computational Geometry, sections 2.1 and 6.1. The line's status is the list S
of the edges that it crosses, here in pairs: a floor and the ceiling above it, with an open cell
between them.

An *event* is all the vertices of one x. Each sends a wall up and one down, as far as all is free.
What that does to the cells tells the type of the vertex (the six types of the book):

| its edges lead | closes | opens | the vertex is |
|---|---|---|---|
| both right, free between them | 0 | 1 | the left end of a room |
| both right, solid between them | 1 | 2 | the left end of an obstacle |
| both left, free between them | 1 | 0 | the right end of a room |
| both left, solid between them | 2 | 1 | the right end of an obstacle |
| one left, one right | 1 | 1 | a bend in a floor, or a bend in a ceiling |

Vertical edges and obstacles that touch need no types of their own: crossing.py.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled
from ..geometry.checks import Array
from .crossing import CROSSED, cross
from .status import NOBODY


class Sweep(NamedTuple):
    """The state of a sweep over n vertices; edge i leaves vertex i, with what is solid to its left.

    vertices (n, 2); order (n,), they from left to right, and upwards; incoming (n,), the edge that
    ends in each. ends (n, 4), each edge's left end and right end; floor (n,), whether it has the
    free space above it.

    cells, rows x_left, x_right, then the heights of floor and ceiling on the left and on the right;
    sides, each cell's floor and ceiling edge; closed, the cells in the order they were closed;
    pairs and walls, which cells share a wall, its x, its ends.

    nodes, the status (status.py); place (n,), the node of the cell that each edge in the status
    borders; sizes, how many cells, closed cells, walls and nodes there are.

    walk, ended, begun, heights: one stretch of the line (crossing.py): where the walk up is; the
    cells that end there, as rows node, level of the floor, level of the ceiling; the edges that
    lead on, with their levels; each level's height.
    """

    vertices: Array
    order: NDArray[np.int64]
    incoming: NDArray[np.int64]
    ends: Array
    floor: NDArray[np.bool_]
    cells: Array
    sides: NDArray[np.int64]
    closed: NDArray[np.int64]
    pairs: NDArray[np.int64]
    walls: Array
    nodes: NDArray[np.int64]
    place: NDArray[np.int64]
    sizes: NDArray[np.int64]
    walk: NDArray[np.int64]
    ended: NDArray[np.int64]
    begun: NDArray[np.int64]
    heights: Array


def new_sweep(edges: Array) -> Sweep:
    """A sweep that has not begun, over edges (n, 5) as a world has them. O(n log n)."""
    n = len(edges)
    order, rightward = np.lexsort((edges[:, 1], edges[:, 0])), edges[:, 0] < edges[:, 2]
    return Sweep(
        np.ascontiguousarray(edges[:, :2]),
        order,
        edges_into_vertices(edges),
        np.where(rightward[:, None], edges[:, :4], edges[:, [2, 3, 0, 1]]),
        ~rightward,
        cells=np.empty((2 * n, 6)),
        sides=np.empty((2 * n, 2), np.int64),
        closed=np.empty(2 * n, np.int64),
        pairs=np.empty((4 * n, 2), np.int64),
        walls=np.empty((4 * n, 3)),
        nodes=np.zeros((2 * n + 1, 6), np.int64),
        place=np.full(n, NOBODY, np.int64),
        sizes=np.array([0, 0, 0, 1]),
        walk=np.zeros(6, np.int64),
        ended=np.empty((n, 3), np.int64),
        begun=np.empty((n, 2), np.int64),
        heights=np.empty(2 * n + 1),
    )


@compiled
def edges_into_vertices(edges: Array) -> NDArray[np.int64]:
    """The edge that ends in each vertex, (n,): the one before it, but a ring's first vertex ends
    its last edge.
    """
    incoming = np.empty(len(edges), np.int64)
    first = 0
    for i in range(len(edges)):
        incoming[i] = i - 1
        if edges[i, 2] == edges[first, 0] and edges[i, 3] == edges[first, 1]:
            incoming[first], first = i, i + 1
    return incoming


@compiled
def events(sweep: Sweep) -> Iterator[int]:
    """Move the line from event to event; yields how many vertices it has met, or CROSSED, and then
    stops, where two edges cross.
    """
    vertices, order, met = sweep.vertices, sweep.order, 0
    while met < len(order):
        stop = met + 1
        while stop < len(order) and vertices[order[stop], 0] == vertices[order[met], 0]:
            stop += 1
        while met < stop:
            met = cross(sweep, met, stop)
            if met == CROSSED:
                yield CROSSED
                return
        yield met
