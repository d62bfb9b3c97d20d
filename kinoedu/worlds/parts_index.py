"""A grid of cells that tells which parts are near: a motion is judged against those few instead of
all.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import turn
from ..geometry.parts import Parts, motion_touches_part, part_boxes

MARGIN = (
    0.01  # of a cell: boxes are grown by it, so that no rounding of a cell's number loses a part
)
ROUNDING = 1e-9  # of a cell: by no more may the world stick out of its cells
FAR, SMALL = (
    1e9,
    1e-290,
)  # farther out than FAR times its size, or smaller than SMALL, a margin would be lost in rounding


class PartsIndex(NamedTuple):
    """Cell (i, j) covers (x, y) + (i, j) * cell and holds parts[first[j * columns + i] : first[j *
    columns + i + 1]].

    boxes (k, 4) are the bounding boxes of all parts. Few arrays: compiled code counts a reference
    to each at every call.
    """

    x: float
    y: float
    cell: float
    columns: int
    rows: int
    first: NDArray[np.int64]
    parts: NDArray[np.int64]
    boxes: Array


def has_margins(lo: Array, hi: Array) -> bool:
    """Whether the box lo..hi can be cut into cells whose margins are more than rounding."""
    size = (hi - lo).max()
    return bool(size >= SMALL and np.abs([lo, hi]).max() <= FAR * size)


def index_parts(parts: Parts, lo: Array, hi: Array) -> PartsIndex:
    """About four cells for each part over the box lo..hi; one where a margin would be lost."""
    boxes = part_boxes(parts)
    divisions = max(1, int(np.ceil(2.0 * np.sqrt(len(boxes))))) if has_margins(lo, hi) else 1
    cell = float((hi - lo).max() / divisions)
    columns, rows = np.maximum(np.ceil((hi - lo) / cell - ROUNDING), 1).astype(int).tolist()
    low = np.clip(np.floor((boxes[:, :2] - lo) / cell - MARGIN), 0, [columns - 1, rows - 1]).astype(
        int
    )
    high = np.clip(
        np.floor((boxes[:, 2:] - lo) / cell + MARGIN), 0, [columns - 1, rows - 1]
    ).astype(int)
    wide, tall = (high - low + 1).T
    part = np.repeat(np.arange(len(boxes)), wide * tall)
    k = np.arange(len(part)) - np.repeat(
        np.cumsum(wide * tall) - wide * tall, wide * tall
    )  # which of its part's cells
    held = (low[part, 1] + k // wide[part]) * columns + low[part, 0] + k % wide[part]
    first = np.append(0, np.cumsum(np.bincount(held, minlength=columns * rows)))
    return PartsIndex(
        float(lo[0]),
        float(lo[1]),
        cell,
        columns,
        rows,
        first,
        part[np.argsort(held, kind="stable")],
        boxes,
    )


@compiled
def stretch_in_band(
    ax: float, ay: float, bx: float, by: float, low: float, high: float
) -> tuple[float, float]:
    """The least and greatest x of the part of a-b with low <= y <= high, to rounding; a-b is known
    to enter the band.
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
    """The whole number below value, kept within 0..high."""
    return int(min(max(value, 0.0), float(high)))


@inlined
def motion_touches_any(
    ax: float, ay: float, bx: float, by: float, radius: float, parts: Parts, cells: PartsIndex
) -> bool:
    """Whether a disc moved along a-b touches a part. Row by row, the cells that the motion passes
    are looked up.
    """
    ox, oy, cell = cells.x, cells.y, cells.cell
    y0, y1 = min(ay, by) - radius, max(ay, by) + radius
    for j in range(
        clip((y0 - oy) / cell, cells.rows - 1), clip((y1 - oy) / cell, cells.rows - 1) + 1
    ):
        bottom, top = oy + (j - MARGIN) * cell, oy + (j + 1.0 + MARGIN) * cell
        left, right = stretch_in_band(ax, ay, bx, by, bottom - radius, top + radius)
        begin = clip((left - radius - ox) / cell - MARGIN, cells.columns - 1)
        end = clip((right + radius - ox) / cell + MARGIN, cells.columns - 1)
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
    """Whether the box round a disc moved along a-b meets part i's box."""
    return (
        max(ax, bx) + radius >= boxes[i, 0]
        and min(ax, bx) - radius <= boxes[i, 2]
        and max(ay, by) + radius >= boxes[i, 1]
        and min(ay, by) - radius <= boxes[i, 3]
    )


@inlined
def point_touches_any(x: float, y: float, parts: Parts, cells: PartsIndex) -> bool:
    """Whether a point of the indexed box lies in a part. Its cell names all that may hold it; exact
    but where a part is round.
    """
    boxes = cells.boxes
    cell = clip((y - cells.y) / cells.cell, cells.rows - 1) * cells.columns + clip(
        (x - cells.x) / cells.cell, cells.columns - 1
    )
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
    """Whether a point of its box lies in part i, a convex polygon."""
    points, begin, end = parts.points, parts.first[i], parts.first[i + 1]
    last = end - 1
    for k in range(begin, end):
        if turn(points[last, 0], points[last, 1], points[k, 0], points[k, 1], x, y) < 0:
            return False
        last = k
    return True
