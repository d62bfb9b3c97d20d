"""A uniform grid as an index of parts: a motion is tested against nearby parts only."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import orientation_sign
from ..geometry.parts import Parts, motion_touches_part, part_boxes

MARGIN = 0.01  # of a cell: boxes are grown by it, so that rounding of cell numbers loses no part
ROUNDING = 1e-9  # of a cell: the world may extend beyond its cells by this
# margins are lost in rounding for a box farther out than FAR times its size, or smaller than SMALL
FAR, SMALL = 1e9, 1e-290


class PartsIndex(NamedTuple):
    """A grid of buckets: cell (i, j) covers (x, y) + (i, j) * cell.

    It holds parts[first[j * columns + i] : first[j * columns + i + 1]]. boxes (k, 4) are the
    bounding boxes of all parts. per_unit is 1 / cell, or 0 where one cell holds everything, because
    a quotient could be too large. There are few arrays, because compiled code counts a reference to
    each of them in every call.
    """

    x: float
    y: float
    cell: float
    per_unit: float
    columns: int
    rows: int
    first: NDArray[np.int64]
    parts: NDArray[np.int64]
    boxes: Array


@compiled
def has_margins(lo: Array, hi: Array) -> bool:
    """Whether the box lo..hi can be divided into cells with margins larger than rounding errors."""
    size = max(hi[0] - lo[0], hi[1] - lo[1])
    farthest = max(max(-lo[0], -lo[1]), max(hi[0], hi[1]))
    return size >= SMALL and farthest <= FAR * size


@compiled
def index_parts(parts: Parts, lo: Array, hi: Array) -> PartsIndex:
    """Build the index of parts over the box lo..hi: about four cells for each part.

    One cell where a margin would be lost in rounding. A counting sort by cells: the parts of a cell
    are in increasing order.
    """
    boxes = part_boxes(parts)
    width, height = hi[0] - lo[0], hi[1] - lo[1]
    divisions = max(1, int(np.ceil(2.0 * np.sqrt(len(boxes))))) if has_margins(lo, hi) else 1
    cell = max(width, height) / divisions
    columns = max(int(np.ceil(width / cell - ROUNDING)), 1)
    rows = max(int(np.ceil(height / cell - ROUNDING)), 1)
    low, high = np.empty((len(boxes), 2), np.int64), np.empty((len(boxes), 2), np.int64)
    at = np.zeros(columns * rows + 2, np.int64)
    for i in range(len(boxes)):
        for axis, last in ((0, columns - 1), (1, rows - 1)):
            low[i, axis] = clip((boxes[i, axis] - lo[axis]) / cell - MARGIN, last)
            high[i, axis] = clip((boxes[i, 2 + axis] - lo[axis]) / cell + MARGIN, last)
        for j in range(low[i, 1], high[i, 1] + 1):
            at[j * columns + low[i, 0] + 2 : j * columns + high[i, 0] + 3] += 1
    for k in range(1, len(at)):
        at[k] += at[k - 1]
    parts_by_cell = np.empty(at[-1], np.int64)
    for i in range(len(boxes)):
        for j in range(low[i, 1], high[i, 1] + 1):
            for k in range(j * columns + low[i, 0], j * columns + high[i, 0] + 1):
                parts_by_cell[at[k + 1]] = i
                at[k + 1] += 1
    x, y, side = float(lo[0]), float(lo[1]), float(cell)
    per_unit = 1.0 / side if columns * rows > 1 else 0.0
    return PartsIndex(x, y, side, per_unit, columns, rows, at[:-1].copy(), parts_by_cell, boxes)


@compiled
def stretch_in_band(
    ax: float, ay: float, bx: float, by: float, low: float, high: float
) -> tuple[float, float]:
    """The least and greatest x of the part of a-b with low <= y <= high, to rounding.

    a-b must enter the band.
    """
    if ay == by:
        return min(ax, bx), max(ax, bx)
    if ay > by:
        ax, ay, bx, by = bx, by, ax, ay
    x0 = ax if ay >= low else ax + (low - ay) / (by - ay) * (bx - ax)
    x1 = bx if by <= high else ax + (high - ay) / (by - ay) * (bx - ax)
    return min(x0, x1), max(x0, x1)


@compiled
def clip(value: float, high: int) -> int:
    """The integer part of a value, clipped to 0..high."""
    return int(min(max(value, 0.0), float(high)))


@inlined
def motion_touches_any(
    ax: float, ay: float, bx: float, by: float, radius: float, parts: Parts, cells: PartsIndex
) -> bool:
    """Whether a disc moved along a-b touches a part; row by row, by the cells it crosses."""
    ox, oy, cell, per_unit = cells.x, cells.y, cells.cell, cells.per_unit
    y0, y1 = min(ay, by) - radius, max(ay, by) + radius
    row, last = (
        clip((y0 - oy) * per_unit, cells.rows - 1),
        clip((y1 - oy) * per_unit, cells.rows - 1),
    )
    for j in range(row, last + 1):
        bottom, top = oy + (j - MARGIN) * cell, oy + (j + 1.0 + MARGIN) * cell
        left, right = stretch_in_band(ax, ay, bx, by, bottom - radius, top + radius)
        begin = clip((left - radius - ox) * per_unit - MARGIN, cells.columns - 1)
        end = clip((right + radius - ox) * per_unit + MARGIN, cells.columns - 1)
        for entry in range(
            cells.first[j * cells.columns + begin], cells.first[j * cells.columns + end + 1]
        ):
            i = cells.parts[entry]
            if may_touch(ax, ay, bx, by, radius, cells.boxes, i) and motion_touches_part(
                ax, ay, bx, by, radius, parts, i
            ):
                return True
    return False


@inlined
def may_touch(
    ax: float, ay: float, bx: float, by: float, radius: float, boxes: Array, i: int
) -> bool:
    """Whether the bounding box of a disc moved along a-b meets the bounding box of part i."""
    return (
        max(ax, bx) + radius >= boxes[i, 0]
        and min(ax, bx) - radius <= boxes[i, 2]
        and max(ay, by) + radius >= boxes[i, 1]
        and min(ay, by) - radius <= boxes[i, 3]
    )


@inlined
def point_touches_any(x: float, y: float, parts: Parts, cells: PartsIndex) -> bool:
    """Whether a point of the indexed box lies in a part; exact except for round parts.

    Its cell lists all parts that may contain it.
    """
    boxes = cells.boxes
    row = clip((y - cells.y) * cells.per_unit, cells.rows - 1)
    cell = row * cells.columns + clip((x - cells.x) * cells.per_unit, cells.columns - 1)
    for entry in range(cells.first[cell], cells.first[cell + 1]):
        i = cells.parts[entry]
        if x < boxes[i, 0] or x > boxes[i, 2] or y < boxes[i, 1] or y > boxes[i, 3]:
            continue
        if (
            motion_touches_part(x, y, x, y, 0.0, parts, i)
            if parts.radius[i] > 0.0
            else is_left_of_edges(x, y, parts, i)
        ):
            return True
    return False


@inlined
def is_left_of_edges(x: float, y: float, parts: Parts, i: int) -> bool:
    """Whether a point of its bounding box lies in part i, a convex polygon."""
    points, begin, end = parts.points, parts.first[i], parts.first[i + 1]
    last = end - 1
    for k in range(begin, end):
        if orientation_sign(points[last, 0], points[last, 1], points[k, 0], points[k, 1], x, y) < 0:
            return False
        last = k
    return True
