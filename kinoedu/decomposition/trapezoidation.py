"""Trapezoidation: vertical walls at every vertex cut the free space into trapezoids.

Bullo & Smith, chapter 2; M. de Berg, O. Cheong, M. van Kreveld, M. Overmars, Computational
Geometry, sections 6.1 and 13.2. The algorithm is in sweep.py.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm, compiled
from ..errors import InvalidWorld
from ..geometry.checks import Array, as_point
from ..graphs.flat import counting_sort
from ..support.constructors import with_type_names
from ..worlds.polygon_world import PolygonWorldRecord
from .cells import CELLS, CLOSED, WALLS
from .crossing import CROSSED, side
from .free_space import candidate_edges
from .status import CELL, NOBODY, next_above
from .sweep import Sweep, events, new_sweep


@with_type_names
class Trapezoidation(NamedTuple):
    """The free space of a world, decomposed into trapezoids.

    They are in the order in which the sweep line enters them; of those that it enters together,
    first the one that it leaves first, then the lower one.

    trapezoids : (n, 6), rows x_left, x_right, the heights of floor and ceiling at x_left, and those
        at x_right. Where both heights of one side are equal, the cell is a triangle.
    adjacency : (m, 2), pairs (i, j) with a common wall of positive length, i on the left; in
        increasing order.
    walls : (m, 2, 2), the lower and upper ends of those walls. They are equal where a wall is
        shorter than floats can represent.
    sides : (n, 2), the floor and the ceiling of each cell, as rows of edges.
    edges : (k, 4), the edges of the free space, each from its left end to its right end.
    world : the world that was decomposed.
    """

    trapezoids: Array
    adjacency: NDArray[np.int64]
    walls: Array
    sides: NDArray[np.int64]
    edges: Array
    world: PolygonWorldRecord

    @property
    def areas(self) -> Array:
        """The area of each cell, (n,)."""
        x0, x1, low0, high0, low1, high1 = self.trapezoids.T
        return (x1 - x0) * ((high0 - low0) + (high1 - low1)) / 2.0

    @property
    def centres(self) -> Array:
        """A point inside each cell, (n, 2): the mean of both walls' x, and of the four heights."""
        x0, x1, low0, high0, low1, high1 = self.trapezoids.T
        return np.column_stack([(x0 + x1) / 2.0, (low0 + high0 + low1 + high1) / 4.0])

    @property
    def outlines(self) -> Array:
        """The corners of each cell, counter-clockwise from the lower left, (n, 4, 2)."""
        return corners_of(self.trapezoids)

    def cells_at(self, q: ArrayLike) -> NDArray[np.int64]:
        """The cells that contain the point q: none, one, or those on both sides of a wall.

        Exact, O(n). Raises InvalidPoint.
        """
        x, y = as_point(q, "q").tolist()
        return np.flatnonzero(cells_contain(self.trapezoids, self.sides, self.edges, x, y))


def corners_of(trapezoids: Array) -> Array:
    """The corners of trapezoids (n, 6), counter-clockwise from the lower left, (n, 4, 2)."""
    return trapezoids[:, [[0, 2], [1, 4], [1, 5], [0, 3]]]


@compiled
def cells_contain(
    trapezoids: Array, sides: NDArray[np.int64], edges: Array, x: float, y: float
) -> NDArray[np.bool_]:
    """Whether each closed cell contains a point, (n,)."""
    holds = np.zeros(len(sides), np.bool_)
    for i in range(len(sides)):
        if trapezoids[i, 0] <= x <= trapezoids[i, 1]:
            holds[i] = side(edges, sides[i, 0], x, y) >= 0 and side(edges, sides[i, 1], x, y) <= 0
    return holds


KINDS = {  # of a vertex, by the numbers of cells that end and begin there: the table in sweep.py
    (0, 1): "a room begins",
    (1, 2): "an obstacle begins",
    (1, 0): "a room ends",
    (2, 1): "an obstacle ends",
    (1, 1): "a bend",
}


@with_type_names
class Step(NamedTuple):
    """One event of the sweep, and the state after it.

    x : the position of the line.
    vertices : (k, 2), the vertices on it, from bottom to top.
    closed : (c, 6), the trapezoids that end here, from bottom to top, as rows of
        `Trapezoidation.trapezoids`.
    opened : (o, 3), the left walls of the cells that begin here: x, and the heights of floor and
        ceiling.
    status : (s, 4), the edges that cross the line just right of x, from bottom to top: floor,
        ceiling, floor, ceiling, ...; each from its left end to its right end.
    """

    x: float
    vertices: Array
    closed: Array
    opened: Array
    status: Array

    @property
    def kind(self) -> str:
        """The type of the vertex, in words; or the number of vertices, where it is not one."""
        if len(self.vertices) > 1:
            return f"{len(self.vertices)} vertices"
        return KINDS.get((len(self.closed), len(self.opened)), "a touch")


def trapezoidation(world: PolygonWorldRecord) -> Trapezoidation:
    """Decompose the free space of a PolygonWorld into trapezoids, by a sweep line.

    Obstacles may touch each other and the boundary. Where they overlap they are united first, and
    the points where their edges cross are rounded. Everything else is exact, except the heights of
    walls inside an edge, which are accurate to 1e-15 of the world's size. There is a wall at every
    vertex, also where the outline is straight. O(n log n) expected for n vertices.

    Returns
    -------
    Trapezoidation

    Raises
    ------
    InvalidWorld
        For round obstacles and for terrains.

    Examples
    --------
    >>> from kinoedu.worlds import PolygonWorld
    >>> obstacle = [(3, 2), (6, 2), (6, 4), (3, 4)]
    >>> cut = trapezoidation(PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [obstacle]))
    >>> cut.areas
    array([18.,  6.,  6., 18.])
    >>> cut.adjacency.tolist()
    [[0, 1], [0, 2], [1, 3], [2, 3]]
    """
    done, _ = sweep_world(world)
    cells, closed = done.cells[: done.sizes[CELLS]], done.closed[: done.sizes[CELLS]]
    walls, pairs = done.walls[: done.sizes[WALLS]], done.pairs[: done.sizes[WALLS]]
    cell_order, wall_order, pairs = sort_cells(cells, closed, pairs)
    ends = walls[wall_order][:, [[0, 1], [0, 2]]]
    return Trapezoidation(cells[cell_order], pairs, ends, done.sides[cell_order], done.ends, world)


def sweep(world: PolygonWorldRecord) -> Iterator[Step]:
    """Iterate over the events of the sweep line, from left to right: the steps of `trapezoidation`.

    Yields
    ------
    Step

    Raises
    ------
    InvalidWorld
        As `trapezoidation`, before the first step.

    Examples
    --------
    >>> from kinoedu.worlds import PolygonWorld
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 3), (6, 2), (5, 4)]])
    >>> for step in sweep(world):
    ...     step.x, len(step.closed), len(step.opened), len(step.status)
    (0.0, 0, 1, 2)
    (3.0, 1, 2, 4)
    (5.0, 1, 1, 4)
    (6.0, 2, 1, 2)
    (9.0, 1, 0, 0)
    """
    _, edges = sweep_world(world)
    return steps(new_sweep(edges))


def sweep_world(world: PolygonWorldRecord) -> tuple[Sweep, Array]:
    """The completed sweep of a world, and the edges that it swept."""
    for edges in candidate_edges(world):
        state = new_sweep(edges)
        if drain(state):
            return state, edges
    raise InvalidWorld(
        "the union of these overlapping obstacles could not be computed; move them a little, or "
        "unite them yourself"
    )


@algorithm
def drain(state: Sweep) -> bool:
    """Sweep to the end; False where edges cross."""
    for handled in events(state):
        if handled == CROSSED:
            return False
    return True


def steps(state: Sweep) -> Iterator[Step]:
    """The state of a sweep after each event."""
    handled = cells = closed = 0
    for now in events(state):
        vertices = state.vertices[state.order[handled:now]]
        ending = state.closed[closed : state.sizes[CLOSED]]
        opened = state.cells[cells : state.sizes[CELLS], [0, 2, 3]]
        status = state.ends[edges_on_line(state.nodes, state.sides)]
        yield Step(float(vertices[0, 0]), vertices, state.cells[ending], opened, status)
        handled, cells, closed = now, int(state.sizes[CELLS]), int(state.sizes[CLOSED])


def edges_on_line(nodes: NDArray[np.int64], sides: NDArray[np.int64]) -> NDArray[np.int64]:
    """The edges of the status, from bottom to top, (s,)."""
    found, node = [], next_above(nodes, NOBODY)
    while node != NOBODY:
        found.append(sides[nodes[node, CELL]])
        node = next_above(nodes, node)
    return np.array(found, np.int64).ravel()


@compiled
def sort_cells(
    cells: Array, closed: NDArray[np.int64], pairs: NDArray[np.int64]
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]:
    """Convert the order in which cells were opened to the final order.

    Returns the old numbers of the cells (n,) and of the walls (m,), in the new order, and the pairs
    (m, 2).
    """
    n = len(cells)
    entered = np.zeros(n, np.int64)
    for i in range(1, n):
        entered[i] = entered[i - 1] if cells[i, 0] == cells[i - 1, 0] else i
    _, cell_order = counting_sort(entered, closed, n)
    number = np.empty(n, np.int64)
    for i in range(n):
        number[cell_order[i]] = i
    renamed = np.empty_like(pairs)
    for k in range(len(pairs)):
        renamed[k, 0], renamed[k, 1] = number[pairs[k, 0]], number[pairs[k, 1]]
    _, by_right = counting_sort(renamed[:, 1], np.arange(len(pairs)), n)
    _, wall_order = counting_sort(renamed[:, 0], by_right, n)
    return cell_order, wall_order, renamed[wall_order]
