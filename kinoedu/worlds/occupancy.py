"""Occupancy cells: small cells that are entirely free or solid answer most collision queries.

A free cell also stores its reach: how many cells around it are free. A motion that stays within the
reach is free, and no obstacle is examined. Only near the edges of obstacles an exact test is
needed.

Sources: M. Edahiro, I. Kokubo, T. Asano, "A new point-location algorithm and its practical
efficiency" (1984), for cells as buckets; H. Samet, "The quadtree and related hierarchical data
structures" (1984), for the subdivision; A. Rosenfeld and J. L. Pfaltz, "Sequential operations in
digital picture processing" (1966), for the reach.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import callable_from_compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import ROUNDING, SAFE
from ..geometry.parts import Parts
from .parts_index import FAR, MARGIN, PartsIndex, clip, has_margins

SOLID, RIM, MIXED, FREE = -2, -1, 0, 1  # in this order; FREE is also the least reach
FINE = 32  # the most occupancy cells along the side of a cell of the index
ALONG = 600  # the most occupancy cells along the longer side of a world
MOST = 16  # the largest reach that is stored
STEP = 4  # a block is divided into STEP * STEP at a time
AT_ONCE = 50_000  # blocks that are classified together
PIECES = 4  # a motion is divided into so many stretches, each looked up by itself


class Occupancy(NamedTuple):
    """The occupancy cells of a world: cell (i, j) covers (x, y) + (i, j) * side.

    per_unit is 1 / side. reach[j, i] is the state of the whole cell: SOLID; or FREE and its reach:
    1 if the cell itself is free, 2 if its eight neighbours are free too, and so on; or MIXED:
    inside the hull of the world, otherwise unknown; or RIM: unknown. Without information there are
    no cells.
    """

    x: float
    y: float
    side: float
    per_unit: float
    reach: NDArray[np.int8]


def make_occupancy(hull: Array, parts: Parts, cells: PartsIndex, lo: Array, hi: Array) -> Occupancy:
    """Build the occupancy cells of a world by subdividing the cells of its index.

    A cell is tested with a margin around it, so that rounding cannot assign a point to the wrong
    cell. Worlds without room for margins have no cells.
    """
    if not has_margins(lo, hi):
        return no_occupancy()
    fine = FINE
    while fine > 1 and fine * max(cells.rows, cells.columns) > ALONG:
        fine //= 2
    reach, divisions = np.full((cells.rows, cells.columns), RIM, np.int8), 1
    classify_blocks(reach, divisions, hull, parts, cells)
    while divisions < fine:
        step = min(STEP, fine // divisions)
        reach, divisions = reach.repeat(step, axis=0).repeat(step, axis=1), step * divisions
        classify_blocks(reach, divisions, hull, parts, cells)
    measure_reach(reach)
    return Occupancy(cells.x, cells.y, cells.cell / fine, fine / cells.cell, reach)


@callable_from_compiled
def no_occupancy() -> Occupancy:
    """Occupancy cells of a world about which nothing is known: none."""
    return Occupancy(0.0, 0.0, 1.0, 1.0, np.zeros((0, 0), np.int8))


class Boxes(NamedTuple):
    """Boxes x0 <= x <= x1, y0 <= y <= y1; each field has shape (n,)."""

    x0: Array
    y0: Array
    x1: Array
    y1: Array

    def take(self, places: NDArray[np.int64]) -> "Boxes":
        """The boxes at some places, which may repeat."""
        return Boxes(*(side[places] for side in self))


def classify_blocks(
    reach: NDArray[np.int8], divisions: int, hull: Array, parts: Parts, cells: PartsIndex
) -> None:
    """Classify the blocks that are MIXED or RIM; each side of an index cell has `divisions`."""
    all_rows, all_columns = np.nonzero((reach == MIXED) | (reach == RIM))
    side = cells.cell / divisions
    for begin in range(0, len(all_rows), AT_ONCE):
        j, i = all_rows[begin : begin + AT_ONCE], all_columns[begin : begin + AT_ONCE]
        x, y = i.astype(np.float64), j.astype(np.float64)
        boxes = Boxes(
            cells.x + (x - MARGIN) * side,
            cells.y + (y - MARGIN) * side,
            cells.x + (x + (1.0 + MARGIN)) * side,
            cells.y + (y + (1.0 + MARGIN)) * side,
        )
        # MIXED means that the block that was divided is inside the hull
        found, rim = np.full(len(j), FREE), np.flatnonzero(reach[j, i] == RIM)
        found[rim[boxes_in_hull(boxes.take(rim), hull) != SOLID]] = RIM
        cell = j // divisions * cells.columns + i // divisions
        box, entry = count_up(cells.first[cell], cells.first[cell + 1])
        part = cells.parts[entry]
        np.minimum.at(found, box, boxes_in_parts(boxes.take(box), part, parts, cells.boxes))
        reach[j, i] = found


def count_up(
    begin: NDArray[np.int64], end: NDArray[np.int64]
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """The numbers of all ranges begin..end, and before them the range of each.

    Examples
    --------
    >>> count_up(np.array([4, 9]), np.array([6, 10]))
    (array([0, 0, 1]), array([4, 5, 9]))
    """
    counts = end - begin
    which = np.repeat(np.arange(len(counts)), counts)
    return which, np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts - begin, counts)


def measure_reach(reach: NDArray[np.int8]) -> None:
    """Count for each FREE cell how many erosions by one layer it survives, up to MOST.

    The cells along the edge of the grid are never FREE: they are not entirely inside the hull.
    """
    free = reach == FREE
    for _ in range(FREE, MOST):
        free[:, 1:-1] &= free[:, :-2] & free[:, 2:]
        free[1:-1] &= free[:-2] & free[2:]
        reach += free


def boxes_in_parts(
    boxes: Boxes, part: NDArray[np.int64], parts: Parts, bounds: Array
) -> NDArray[np.int64]:
    """SOLID where a box is inside its part, FREE where it is outside, MIXED otherwise."""
    around, found = bounds[part].T, np.full(len(part), FREE)
    near = (boxes.x1 >= around[0]) & (boxes.x0 <= around[2])
    near &= (boxes.y1 >= around[1]) & (boxes.y0 <= around[3])
    is_round = parts.radius[part] > 0.0
    discs, polygons = np.flatnonzero(near & is_round), np.flatnonzero(near & ~is_round)
    disc, polygon = part[discs], part[polygons]
    found[discs] = boxes_in_discs(
        boxes.take(discs), parts.points[parts.first[disc]], parts.radius[disc]
    )
    found[polygons] = boxes_in_polygons(
        boxes.take(polygons), parts.points, parts.first[polygon], parts.first[polygon + 1]
    )
    return found


def boxes_in_discs(boxes: Boxes, centre: Array, radius: Array) -> NDArray[np.int64]:
    """SOLID where a box is strictly inside its disc, FREE where it is outside, MIXED otherwise.

    MIXED also for a disc that is too large for a margin.
    """
    left, right = centre[:, 0] - boxes.x0, boxes.x1 - centre[:, 0]
    below, above = centre[:, 1] - boxes.y0, boxes.y1 - centre[:, 1]
    farthest = np.hypot(np.maximum(left, right), np.maximum(below, above))
    nearest = np.hypot(
        np.maximum(np.maximum(-left, -right), 0.0), np.maximum(np.maximum(-below, -above), 0.0)
    )
    found = np.where(farthest < radius, SOLID, np.where(nearest > radius, FREE, MIXED))
    return np.where(radius > FAR * (boxes.x1 - boxes.x0), MIXED, found)


def boxes_in_hull(boxes: Boxes, hull: Array) -> NDArray[np.int64]:
    """`boxes_in_polygons` for one polygon (k, 2)."""
    begin = np.zeros(len(boxes.x0), np.int64)
    return boxes_in_polygons(boxes, hull, begin, begin + len(hull))


def boxes_in_polygons(
    boxes: Boxes, points: Array, begin: NDArray[np.int64], end: NDArray[np.int64]
) -> NDArray[np.int64]:
    """SOLID where a box is strictly inside its convex polygon, FREE to the right of an edge.

    MIXED otherwise, and where rounding leaves it open. The polygons are points[begin:end]. For each
    edge the corner farthest to its left and the corner farthest to its right decide for all four.
    """
    box, k = count_up(begin, end)
    p, q = points[np.where(k == begin[box], end[box], k) - 1].T, points[k].T
    around = boxes.take(box)
    up, forth = q[1] > p[1], q[0] > p[0]
    left = np.where(up, around.x0, around.x1), np.where(forth, around.y1, around.y0)
    right = np.where(up, around.x1, around.x0), np.where(forth, around.y0, around.y1)
    found = np.full(len(begin), SOLID)
    found[box[~is_to_the_left(p, q, right)]] = MIXED
    found[box[is_to_the_left(q, p, left)]] = FREE
    return found


def is_to_the_left(p: Array, q: Array, at: tuple[Array, Array]) -> NDArray[np.bool_]:
    """Whether places are to the left of the lines from p to q, and rounding leaves no doubt."""
    with np.errstate(over="ignore", under="ignore", invalid="ignore"):  # inf and nan leave a doubt
        one, other = (q[0] - p[0]) * (at[1] - p[1]), (q[1] - p[1]) * (at[0] - p[0])
        return np.asarray(one - other > ROUNDING * (np.abs(one) + np.abs(other)) + SAFE)


@inlined
def occupancy_at(x: float, y: float, radius: float, grid: Occupancy) -> int:
    """FREE where a disc is known to be free, SOLID where its centre is not; else RIM or MIXED.

    The centre must lie in the world's bounding box.
    """
    rows, columns = grid.reach.shape
    if rows == 0:
        return RIM
    reach = grid.reach[
        clip((y - grid.y) * grid.per_unit, rows - 1),
        clip((x - grid.x) * grid.per_unit, columns - 1),
    ]
    return FREE if reach > cells_in(radius, grid) else min(reach, MIXED)


@inlined
def occupancy_between(
    ax: float, ay: float, bx: float, by: float, radius: float, grid: Occupancy
) -> int:
    """The same for a disc that moves along a-b.

    A stretch of the motion is FREE where the reach of one end covers the other end and the disc.
    """
    rows, columns = grid.reach.shape
    if rows == 0:
        return RIM
    u, v = (ax - grid.x) * grid.per_unit, (ay - grid.y) * grid.per_unit
    s, t = (bx - grid.x) * grid.per_unit, (by - grid.y) * grid.per_unit
    i, j, k, m = clip(u, columns - 1), clip(v, rows - 1), clip(s, columns - 1), clip(t, rows - 1)
    at_a, at_b, spare = grid.reach[j, i], grid.reach[m, k], cells_in(radius, grid)
    if max(abs(k - i), abs(m - j)) + spare < max(at_a, at_b):
        return FREE
    found, rest = FREE, min(min(at_a, at_b), MIXED)
    for piece in range(1, PIECES + 1):
        k, m = (
            clip(u + piece / PIECES * (s - u), columns - 1),
            clip(v + piece / PIECES * (t - v), rows - 1),
        )
        at_b = grid.reach[m, k]
        if at_b == SOLID:
            return SOLID
        if max(abs(k - i), abs(m - j)) + spare >= max(at_a, at_b):
            found = rest
        i, j, at_a = k, m, at_b
    return found


@inlined
def cells_in(radius: float, grid: Occupancy) -> int:
    """The number of cells by which a disc may extend beyond the cell of its centre."""
    return int(min(np.ceil(radius * grid.per_unit), float(MOST))) if radius > 0.0 else 0
