"""The sweep: a vertical line moves over a world from left to right and cuts it into cells.

Bullo & Smith, chapter 2, the sweeping trapezoidation algorithm; M. de Berg, O. Cheong, M. van
Kreveld, M. Overmars, Computational Geometry, sections 2.1 and 6.1.

    1: T := empty list of trapezoids; S := empty status
    2: sort the vertices p_1, ..., p_n by x
    3: for each p_i, from left to right:
    4:     find in S the edges just above and just below p_i
    5:     draw walls from p_i up and down to these edges, where that is free
    6:     add to T the cells that end at these walls
    7:     remove from S the edges that end in p_i, insert those that begin there
    8: return T

The status S is the sorted list of the edges that the line crosses. It is stored in pairs: a floor
and the ceiling above it, with an open cell between them (status.py). An *event* is all vertices of
one x. Steps 4 to 7 are in crossing.py and cells.py. They treat all types of vertices alike: the
numbers of cells that end and begin give the type (de Berg et al., section 3.2).

| edges of the vertex lead | cells that end | that begin | the vertex is | de Berg et al. |
|---|---|---|---|---|
| both right, free between them | 0 | 1 | the left end of a room | start vertex |
| both right, solid between them | 1 | 2 | the left end of an obstacle | split vertex |
| both left, free between them | 1 | 0 | the right end of a room | end vertex |
| both left, solid between them | 2 | 1 | the right end of an obstacle | merge vertex |
| one left, one right | 1 | 1 | a bend in a floor or a ceiling | regular vertex |

Vertical edges and obstacles that touch need no types of their own: see crossing.py.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled
from ..geometry.checks import Array
from .crossing import CROSSED, handle_event
from .status import NOBODY


class Sweep(NamedTuple):
    """The state of a sweep over n vertices; edge i begins at vertex i, with the solid to its left.

    The input:
    vertices : (n, 2).
    order : (n,), the vertices from left to right, and upwards for equal x.
    incoming : (n,), the edge that leads to each vertex.
    ends : (n, 4), the left end and the right end of each edge.
    floor : (n,), whether the free space is above the edge.

    The output T:
    cells : rows x_left, x_right, the heights of floor and ceiling on the left, and on the right.
    sides : the floor and the ceiling edge of each cell.
    closed : the cells in the order in which they were closed.
    pairs, walls : the two cells that share each wall; its x and the heights of its ends.

    The status S:
    nodes : the tree of open cells (status.py).
    place : (n,), for each edge in the status, the node of its cell.
    sizes : the numbers of cells, closed cells, walls and nodes.

    The two sides of the line at an event (crossing.py, cells.py):
    ended : the cells that end, as rows node, level of the floor, level of the ceiling.
    begun : the edges that go on, as rows edge, level.
    heights : the height of each level.
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
    ended: NDArray[np.int64]
    begun: NDArray[np.int64]
    heights: Array


@compiled
def new_sweep(edges: Array) -> Sweep:
    """The state before the sweep, steps 1 and 2, for edges (n, 5) of a world. O(n log n)."""
    n = len(edges)
    floor, ends = edges[:, 0] >= edges[:, 2], edges[:, :4].copy()
    for i in range(n):
        if floor[i]:
            ends[i, :2], ends[i, 2:] = edges[i, 2:4], edges[i, :2]
    order = np.argsort(edges[:, 1], kind="mergesort")
    order = order[np.argsort(edges[order, 0], kind="mergesort")]
    return Sweep(
        vertices=edges[:, :2].copy(),
        order=order,  # 2: sort the vertices by x
        incoming=edges_into_vertices(edges),
        ends=ends,
        floor=floor,
        cells=np.empty((2 * n, 6)),
        sides=np.empty((2 * n, 2), np.int64),
        closed=np.empty(2 * n, np.int64),
        pairs=np.empty((4 * n, 2), np.int64),
        walls=np.empty((4 * n, 3)),
        nodes=np.zeros((2 * n + 1, 6), np.int64),
        place=np.full(n, NOBODY, np.int64),
        sizes=np.array([0, 0, 0, 1]),
        ended=np.empty((n, 3), np.int64),
        begun=np.empty((n, 2), np.int64),
        heights=np.empty(2 * n + 1),
    )


@compiled
def edges_into_vertices(edges: Array) -> NDArray[np.int64]:
    """The edge that leads to each vertex, (n,): the previous one, cyclically in each ring."""
    incoming = np.empty(len(edges), np.int64)
    first = 0
    for i in range(len(edges)):
        incoming[i] = i - 1
        if edges[i, 2] == edges[first, 0] and edges[i, 3] == edges[first, 1]:
            incoming[first], first = i, i + 1
    return incoming


@compiled
def events(sweep: Sweep) -> Iterator[int]:
    """Move the line from event to event, steps 3 to 7.

    Yields the number of vertices met so far; or CROSSED where two edges cross, and then stops.
    """
    vertices, order, handled = sweep.vertices, sweep.order, 0
    while handled < len(order):  # 3: for each x, from left to right
        stop = handled + 1
        while stop < len(order) and vertices[order[stop], 0] == vertices[order[handled], 0]:
            stop += 1
        while handled < stop:  # upwards, from solid to solid
            handled = handle_event(sweep, handled, stop)  # 4 to 7
            if handled == CROSSED:
                yield CROSSED
                return
        yield handled
