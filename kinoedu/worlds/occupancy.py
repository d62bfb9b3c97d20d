"""Occupancy cells: small cells that are entirely free or solid answer most collision queries.

A free cell also stores its reach: how many cells around it are free. A motion that stays within the
reach is free, and no obstacle is examined. Only near the edges of obstacles an exact test is
needed.

Sources: M. Edahiro, I. Kokubo, T. Asano, "A new point-location algorithm and its practical
efficiency" (1984), for cells as buckets; J. D. Foley, A. van Dam, S. K. Feiner, J. F. Hughes,
"Computer graphics: principles and practice" (1990), for filling polygons row by row; A. Rosenfeld
and J. L. Pfaltz, "Sequential operations in digital picture processing" (1966), for the reach.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, callable_from_compiled, compiled, inlined
from ..geometry.checks import Array
from ..geometry.parts import Parts, box_of
from .parts_index import FAR, MARGIN, PartsIndex, clip, has_margins, stretch_in_band

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


def make_occupancy(hull: Array, parts: Parts, cells: PartsIndex, lo: Array, hi: Array) -> Occupancy:
    """Build the occupancy cells of a world row by row, as polygons are filled on a screen.

    A cell is tested with a margin around it, so that rounding cannot assign a point to the wrong
    cell. Worlds without room for margins have no cells. A box keeps its margin outside, since no
    point outside of it is looked up: all its cells may be free.
    """
    if not has_margins(lo, hi):
        return no_occupancy()
    grid = classify_cells(hull, parts, cells)
    measure_reach(grid.reach)
    return grid


@callable_from_compiled
def no_occupancy() -> Occupancy:
    """Occupancy cells of a world about which nothing is known: none."""
    return Occupancy(0.0, 0.0, 1.0, 1.0, np.zeros((0, 0), np.int8))


@algorithm
def classify_cells(hull: Array, parts: Parts, cells: PartsIndex) -> Occupancy:
    """The occupancy cells of a world, without reaches: FREE cells have the least."""
    fine = FINE
    while fine > 1 and fine * max(cells.rows, cells.columns) > ALONG:
        fine //= 2
    reach = np.full((fine * cells.rows, fine * cells.columns), RIM, np.int8)
    grid = Occupancy(cells.x, cells.y, cells.cell / fine, fine / cells.cell, reach)
    if is_box(hull):
        reach[:] = MIXED
        hull = grow_box(hull, 2.0 * MARGIN * grid.side)
    fill(stretches_of_polygon(hull, grid), FREE, grid)
    for i in range(len(parts.radius)):
        fill(stretches_of_part(parts, i, cells.boxes[i], grid), SOLID, grid)
    return grid


@compiled
def is_box(ring: Array) -> bool:
    """Whether a convex ring is its own bounding box."""
    lo, hi = box_of(ring)
    for x, y in ring:
        if (x != lo[0] and x != hi[0]) or (y != lo[1] and y != hi[1]):
            return False
    return len(ring) == 4


@compiled
def grow_box(box: Array, margin: float) -> Array:
    """A box whose sides are moved outwards by a margin."""
    lo, _ = box_of(box)
    return box + np.where(box == lo, -margin, margin)


class Stretches(NamedTuple):
    """Where a convex shape is in some rows of cells, the first of which is `row`.

    along (k, 4): in the row's band the shape touches x from along[:, 0] to along[:, 1] only, and
    the band from along[:, 2] to along[:, 3] is in the shape.
    """

    row: int
    along: Array


@compiled
def fill(stretches: Stretches, inside: int, grid: Occupancy) -> None:
    """Make the cells inside a shape `inside`, and others that it touches MIXED at most."""
    columns = grid.reach.shape[1]
    for k in range(len(stretches.along)):
        cells, along = grid.reach[stretches.row + k], stretches.along[k]
        touched = cells[
            cells_before(along[0], grid.x, grid.side, columns) : cells_until(
                along[1], grid.x, grid.side, columns
            )
        ]
        touched[:] = np.minimum(touched, np.int8(MIXED))
        cells[
            cells_until(along[2], grid.x, grid.side, columns) : cells_before(
                along[3], grid.x, grid.side, columns
            )
        ] = inside


@compiled
def cells_before(value: float, origin: float, side: float, count: int) -> int:
    """How many of `count` cells in a line end before a value, with their margins."""
    return clip(np.ceil((value - origin) / side - 1.0 - MARGIN), count)


@compiled
def cells_until(value: float, origin: float, side: float, count: int) -> int:
    """How many of `count` cells in a line begin at a value or before it, with their margins."""
    return clip((value - origin) / side + 1.0 + MARGIN, count)


@compiled
def band(j: int, grid: Occupancy) -> tuple[float, float]:
    """The least and greatest y of row j, with its margins."""
    return grid.y + (j - MARGIN) * grid.side, grid.y + (j + 1.0 + MARGIN) * grid.side


@compiled
def stretches_of_part(parts: Parts, i: int, box: Array, grid: Occupancy) -> Stretches:
    """The stretches of part i. It may touch all cells where margins are lost in rounding."""
    rows, columns = grid.reach.shape
    if max(max(-box[0], -box[1]), max(box[2], box[3])) > FAR * grid.side * max(rows, columns):
        return new_stretches(0, rows, np.array([-np.inf, np.inf, np.inf, -np.inf]))
    points = parts.points[parts.first[i] : parts.first[i + 1]]
    if parts.radius[i] > 0.0:
        return stretches_of_disc(points[0], parts.radius[i], grid)
    return stretches_of_polygon(points, grid)


@compiled
def new_stretches(begin: int, end: int, along: Array) -> Stretches:
    """Stretches of the rows begin to end - 1, all alike."""
    stretches = Stretches(begin, np.empty((max(end - begin, 0), 4)))
    stretches.along[:] = along
    return stretches


@compiled
def stretches_of_disc(centre: Array, radius: float, grid: Occupancy) -> Stretches:
    """The stretches of a disc: half its chords at the least and the greatest distance of a band."""
    x, y, rows = centre[0], centre[1], len(grid.reach)
    begin = cells_before(y - radius, grid.y, grid.side, rows)
    end = cells_until(y + radius, grid.y, grid.side, rows)
    stretches = new_stretches(begin, end, np.zeros(4))
    for j in range(begin, end):
        bottom, top = band(j, grid)
        outer = half_chord(radius, max(max(bottom - y, y - top), 0.0))
        inner = half_chord(radius, max(y - bottom, top - y))
        row = stretches.along[j - begin]
        row[0], row[1], row[2], row[3] = x - outer, x + outer, x - inner, x + inner
    return stretches


@compiled
def half_chord(radius: float, distance: float) -> float:
    """Half the length of a circle's chord at a distance from the centre; 0 outside the circle."""
    return np.sqrt(max(radius - distance, 0.0)) * np.sqrt(radius + distance)


@compiled
def stretches_of_polygon(ring: Array, grid: Occupancy) -> Stretches:
    """The stretches of a convex polygon, counter-clockwise.

    Edges that go down are on its left side, and edges that go up on its right side.
    """
    lo, hi = box_of(ring)
    y, side, rows = grid.y, grid.side, len(grid.reach)
    begin, end = cells_before(lo[1], y, side, rows), cells_until(hi[1], y, side, rows)
    stretches = new_stretches(begin, end, np.array([np.inf, -np.inf, -np.inf, np.inf]))
    last = len(ring) - 1
    for k in range(len(ring)):
        ax, ay, bx, by = ring[last, 0], ring[last, 1], ring[k, 0], ring[k, 1]
        last = k
        for j in range(
            cells_before(min(ay, by), y, side, rows), cells_until(max(ay, by), y, side, rows)
        ):
            bottom, top = band(j, grid)
            left, right = stretch_in_band(ax, ay, bx, by, bottom, top)
            row = stretches.along[j - begin]
            row[0], row[1] = min(row[0], left), max(row[1], right)
            if by < ay:
                row[2] = max(row[2], right)
            if by > ay:
                row[3] = min(row[3], left)
    stretches.along[: max(cells_until(lo[1], y, side, rows) - begin, 0), 2] = np.inf
    stretches.along[max(cells_before(hi[1], y, side, rows) - begin, 0) :, 2] = np.inf
    return stretches


def measure_reach(reach: NDArray[np.int8]) -> None:
    """Give each FREE cell its distance to the nearest other cell, in cells, up to MOST.

    Diagonal neighbours are at distance 1. The grid has a rim of cells that are not FREE here, so it
    does not matter that all cells are in one line, where the neighbour of a row's last cell is the
    first of the next.
    """
    free = (reach == FREE).view(np.int8)
    with_rim = np.zeros((len(reach) + 2, reach.shape[1] + 2), np.int8)
    cells = with_rim[1:-1, 1:-1]
    cells[:] = free * np.int8(MOST)
    far, columns, step = with_rim.reshape(-1), with_rim.shape[1], 1
    while step < MOST:
        near = least_within(least_within(far, step, 1), step, columns)
        near += np.int8(step)
        inner = far[step * (columns + 1) : -step * (columns + 1)]
        np.minimum(inner, near, out=inner)
        step *= 2
    reach += cells - free


def least_within(values: NDArray[np.int8], steps: int, stride: int) -> NDArray[np.int8]:
    """The least of the values up to `steps` strides before and behind each value.

    `steps` is a power of two. The first and the last `steps` strides of the array have no result,
    because values are missing there.
    """
    least, covered = values, stride
    while covered < 2 * steps * stride:
        least = np.minimum(least[:-covered], least[covered:])
        covered *= 2
    return np.minimum(least[:-stride], values[2 * steps * stride :])


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
    """The number of cells by which a disc may extend beyond the cell of its centre.

    With a margin, because free cells may end at the rim of a box, which a disc must not touch.
    """
    if radius == 0.0:
        return 0
    return int(min(np.ceil(radius * grid.per_unit + 2.0 * MARGIN), float(MOST)))
