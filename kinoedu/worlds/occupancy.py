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

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import length, orientation_sign
from ..geometry.parts import Parts
from .parts_index import FAR, MARGIN, PartsIndex, clip, has_margins

SOLID, RIM, MIXED, FREE = -2, -1, 0, 1  # in this order; FREE is also the least reach
FINE = 32  # the most occupancy cells along the side of a cell of the index
ALONG = 600  # the most occupancy cells along the longer side of a world
MOST = 16  # the largest reach that is stored
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


@compiled
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
    reach = np.full((fine * cells.rows, fine * cells.columns), RIM, np.int8)
    grid = Occupancy(cells.x, cells.y, cells.cell / fine, fine / cells.cell, reach)
    fill_occupancy(grid, fine, hull, parts, cells)
    measure_reach(grid.reach)
    return grid


@compiled
def no_occupancy() -> Occupancy:
    """Occupancy cells of a world about which nothing is known: none."""
    return Occupancy(0.0, 0.0, 1.0, 1.0, np.zeros((0, 0), np.int8))


@compiled
def fill_occupancy(
    grid: Occupancy, fine: int, hull: Array, parts: Parts, cells: PartsIndex
) -> None:
    """Classify the cells of the index, then recursively their quarters where they are mixed."""
    size = fine
    while size > 0:
        for j in range(0, grid.reach.shape[0], size):
            for i in range(0, grid.reach.shape[1], size):
                if grid.reach[j, i] == MIXED or grid.reach[j, i] == RIM:
                    cell = j // fine * cells.columns + i // fine
                    grid.reach[j : j + size, i : i + size] = classify_block(
                        i, j, size, grid, cell, hull, parts, cells
                    )
        size //= 2


@compiled
def classify_block(
    i: int,
    j: int,
    size: int,
    grid: Occupancy,
    cell: int,
    hull: Array,
    parts: Parts,
    cells: PartsIndex,
) -> int:
    """The state of a block of size * size cells, with its margin; by the hull and nearby parts."""
    x0, x1 = grid.x + (i - MARGIN) * grid.side, grid.x + (i + size + MARGIN) * grid.side
    y0, y1 = grid.y + (j - MARGIN) * grid.side, grid.y + (j + size + MARGIN) * grid.side
    # MIXED means that the four times larger block is inside the hull
    inside = (
        grid.reach[j, i] == MIXED or box_in_polygon(x0, y0, x1, y1, hull, 0, len(hull)) == SOLID
    )
    found = FREE if inside else RIM
    for entry in range(cells.first[cell], cells.first[cell + 1]):
        part = box_in_part(x0, y0, x1, y1, parts, cells.parts[entry], cells.boxes)
        if part == SOLID:
            return SOLID
        found = min(found, part)
    return found


@compiled
def measure_reach(reach: NDArray[np.int8]) -> None:
    """Count for each FREE cell how many erosions by one layer it survives, up to MOST.

    The cells along the edge of the grid are never FREE: they are not entirely inside the hull.
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
    """SOLID where a box is inside part i, FREE where it is outside, MIXED otherwise."""
    if x1 < boxes[i, 0] or x0 > boxes[i, 2] or y1 < boxes[i, 1] or y0 > boxes[i, 3]:
        return FREE
    if parts.radius[i] > 0.0:
        return box_in_disc(x0, y0, x1, y1, parts.points[parts.first[i]], parts.radius[i])
    return box_in_polygon(x0, y0, x1, y1, parts.points, parts.first[i], parts.first[i + 1])


@compiled
def box_in_disc(x0: float, y0: float, x1: float, y1: float, centre: Array, radius: float) -> int:
    """SOLID where a box is strictly inside a disc, FREE where it is outside, MIXED otherwise.

    MIXED also for a disc that is too large for a margin.
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
    """SOLID where a box is strictly inside a convex polygon, FREE to the right of an edge.

    MIXED otherwise. The polygon is points[begin:end]. For each edge the corner farthest to its left
    and the corner farthest to its right decide for all four.
    """
    found = SOLID
    px, py = points[end - 1, 0], points[end - 1, 1]
    for k in range(begin, end):
        qx, qy = points[k, 0], points[k, 1]
        left_x, right_x = (x0, x1) if qy > py else (x1, x0)
        left_y, right_y = (y1, y0) if qx > px else (y0, y1)
        if orientation_sign(px, py, qx, qy, left_x, left_y) < 0:
            return FREE
        if found == SOLID and orientation_sign(px, py, qx, qy, right_x, right_y) <= 0:
            found = MIXED
        px, py = qx, qy
    return found


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
