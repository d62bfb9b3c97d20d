"""Small cells known to be wholly free or wholly solid: most questions are answered by looking up a
few of them.

A free cell also knows how far freedom reaches round it, in cells; a motion that stays within that
is free without a look at any obstacle. What is left, near the obstacles' edges, has to be judged
exactly.

Sources: M. Edahiro, I. Kokubo, T. Asano, "A new point-location algorithm and its practical
efficiency" (1984), for cells as buckets; H. Samet, "The quadtree and related hierarchical data
structures" (1984), for halving them; A. Rosenfeld and J. L. Pfaltz, "Sequential operations in
digital picture processing" (1966), for the reach.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import length, turn
from ..geometry.parts import Parts
from .parts_index import FAR, MARGIN, PartsIndex, clip, has_margins

SOLID, RIM, MIXED, FREE = -2, -1, 0, 1  # the less, the worse; FREE is the least reach as well
FINE, ALONG = (
    32,
    600,
    # small cells along the side of a cell of the index, and along the longer side of a world, at
    # most
)
MOST = 16  # the greatest reach that is counted
PIECES = 4  # of a motion, looked up one by one


class KnownCells(NamedTuple):
    """Cell (i, j) covers (x, y) + (i, j) * side, with per_unit = 1 / side; reach[j, i] says what
    all of it is.

    SOLID; or FREE, and then how far: 1 if the cell itself is, 2 if its eight neighbours are too,
    and so on. MIXED: inside the world's hull, no more is known. RIM: not even that. Where nothing
    is known, there are no cells.
    """

    x: float
    y: float
    side: float
    per_unit: float
    reach: NDArray[np.int8]


def known_cells(hull: Array, parts: Parts, cells: PartsIndex, lo: Array, hi: Array) -> KnownCells:
    """The small cells of a world: the cells of the index, halved and halved again as long as they
    are not too many.

    A cell counts with a margin round it, so that rounding cannot carry a point to a cell which it
    does not belong to. No cells for worlds that have no room for margins.
    """
    if not has_margins(lo, hi):
        return nothing_known()
    fine = FINE
    while fine > 1 and fine * max(cells.rows, cells.columns) > ALONG:
        fine //= 2
    reach = np.full((fine * cells.rows, fine * cells.columns), RIM, np.int8)
    known = KnownCells(cells.x, cells.y, cells.cell / fine, fine / cells.cell, reach)
    fill_known_cells(known, fine, hull, parts, cells)
    measure_reach(known.reach)
    return known


def nothing_known() -> KnownCells:
    """No cells."""
    return KnownCells(0.0, 0.0, 1.0, 1.0, np.zeros((0, 0), np.int8))


@algorithm
def fill_known_cells(
    known: KnownCells, fine: int, hull: Array, parts: Parts, cells: PartsIndex
) -> None:
    """Judge cells of the index, then their quarters where that does not tell, and so on down to the
    small cells.
    """
    size = fine
    while size > 0:
        for j in range(0, known.reach.shape[0], size):
            for i in range(0, known.reach.shape[1], size):
                if known.reach[j, i] == MIXED or known.reach[j, i] == RIM:
                    cell = j // fine * cells.columns + i // fine
                    known.reach[j : j + size, i : i + size] = judged_block(
                        i, j, size, known, cell, hull, parts, cells
                    )
        size //= 2


@compiled
def judged_block(
    i: int,
    j: int,
    size: int,
    known: KnownCells,
    cell: int,
    hull: Array,
    parts: Parts,
    cells: PartsIndex,
) -> int:
    """What size * size small cells wholly are, with the margin of one: by the hull, and by the
    parts in their cell of the index.
    """
    x0, x1 = known.x + (i - MARGIN) * known.side, known.x + (i + size + MARGIN) * known.side
    y0, y1 = known.y + (j - MARGIN) * known.side, known.y + (j + size + MARGIN) * known.side
    # what the block was a quarter of is MIXED if it is inside the hull
    inside = (
        known.reach[j, i] == MIXED or box_in_polygon(x0, y0, x1, y1, hull, 0, len(hull)) == SOLID
    )
    found = FREE if inside else RIM
    for entry in range(cells.first[cell], cells.first[cell + 1]):
        part = box_in_part(x0, y0, x1, y1, parts, cells.parts[entry], cells.boxes)
        if part == SOLID:
            return SOLID
        found = min(found, part)
    return found


def measure_reach(reach: NDArray[np.int8]) -> None:
    """Count for each FREE cell how many peelings it outlives, up to MOST. Each takes the outermost
    layer of what is free.

    The cells along the grid's edge are never FREE: they are not wholly inside the hull.
    """
    free = reach == FREE
    for _ in range(FREE, MOST):
        free[:, 1:-1] &= free[:, :-2] & free[:, 2:]
        free[1:-1] &= free[:-2] & free[2:]
        reach += free


@inlined
def box_in_part(
    x0: float, y0: float, x1: float, y1: float, parts: Parts, i: int, boxes: Array
) -> int:
    """Whether a box is SOLID inside part i, FREE of it, or neither."""
    if x1 < boxes[i, 0] or x0 > boxes[i, 2] or y1 < boxes[i, 1] or y0 > boxes[i, 3]:
        return FREE
    if parts.radius[i] > 0.0:
        return box_in_disc(x0, y0, x1, y1, parts.points[parts.first[i]], parts.radius[i])
    return box_in_polygon(x0, y0, x1, y1, parts.points, parts.first[i], parts.first[i + 1])


@compiled
def box_in_disc(x0: float, y0: float, x1: float, y1: float, centre: Array, radius: float) -> int:
    """Whether a box is SOLID strictly inside a disc, FREE of it, or neither; MIXED for one too
    large for a margin.
    """
    left, right, below, above = centre[0] - x0, x1 - centre[0], centre[1] - y0, y1 - centre[1]
    if radius > FAR * (x1 - x0):
        return MIXED
    if length(max(left, right), max(below, above)) < radius:
        return SOLID
    return FREE if length(max(-left, -right, 0.0), max(-below, -above, 0.0)) > radius else MIXED


@compiled
def box_in_polygon(
    x0: float, y0: float, x1: float, y1: float, points: Array, begin: int, end: int
) -> int:
    """Whether a box is SOLID strictly inside the convex polygon points[begin:end], FREE to the
    right of an edge, or neither.

    The box's corner farthest to the left of an edge and the one farthest to its right decide for
    all four.
    """
    found = SOLID
    px, py = points[end - 1, 0], points[end - 1, 1]
    for k in range(begin, end):
        qx, qy = points[k, 0], points[k, 1]
        left_x, right_x = (x0, x1) if qy > py else (x1, x0)
        left_y, right_y = (y1, y0) if qx > px else (y0, y1)
        if turn(px, py, qx, qy, left_x, left_y) < 0:
            return FREE
        if found == SOLID and turn(px, py, qx, qy, right_x, right_y) <= 0:
            found = MIXED
        px, py = qx, qy
    return found


@inlined
def known_at(x: float, y: float, radius: float, known: KnownCells) -> int:
    """Whether a disc with its centre in the world's bounding box is known to be FREE, or its centre
    SOLID; else RIM or MIXED.
    """
    rows, columns = known.reach.shape
    if rows == 0:
        return RIM
    reach = known.reach[
        clip((y - known.y) * known.per_unit, rows - 1),
        clip((x - known.x) * known.per_unit, columns - 1),
    ]
    return FREE if reach > cells_in(radius, known) else min(reach, MIXED)


@inlined
def known_between(
    ax: float, ay: float, bx: float, by: float, radius: float, known: KnownCells
) -> int:
    """The same for a disc moved along a-b. A piece of the way is FREE where the reach of one end
    holds the other and the disc.
    """
    rows, columns = known.reach.shape
    if rows == 0:
        return RIM
    u, v = (ax - known.x) * known.per_unit, (ay - known.y) * known.per_unit
    s, t = (bx - known.x) * known.per_unit, (by - known.y) * known.per_unit
    i, j, k, m = clip(u, columns - 1), clip(v, rows - 1), clip(s, columns - 1), clip(t, rows - 1)
    at_a, at_b, spare = known.reach[j, i], known.reach[m, k], cells_in(radius, known)
    if max(abs(k - i), abs(m - j)) + spare < max(at_a, at_b):
        return FREE
    found, rest = FREE, min(min(at_a, at_b), MIXED)
    for piece in range(1, PIECES + 1):
        k, m = (
            clip(u + piece / PIECES * (s - u), columns - 1),
            clip(v + piece / PIECES * (t - v), rows - 1),
        )
        at_b = known.reach[m, k]
        if at_b == SOLID:
            return SOLID
        if max(abs(k - i), abs(m - j)) + spare >= max(at_a, at_b):
            found = rest
        i, j, at_a = k, m, at_b
    return found


@inlined
def cells_in(radius: float, known: KnownCells) -> int:
    """How many cells a disc may stick out of the one that holds its centre."""
    return int(min(np.ceil(radius * known.per_unit), float(MOST))) if radius > 0.0 else 0
