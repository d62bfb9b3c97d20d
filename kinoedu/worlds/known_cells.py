"""Small cells known to be wholly free or wholly solid: most points of a world are located by looking up one of them.

Source: the bucket methods of F. P. Preparata and M. I. Shamos, "Computational Geometry" (1985), section 2.2.
"""

import numpy as np
from numpy.typing import NDArray

from ..compiled import body, compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import turn
from ..geometry.parts import Parts
from .parts_index import MARGIN, PartsIndex, clip

MIXED, FREE, SOLID = 0, 1, 2
FINE = 8  # small cells along the side of a cell of the index
NOTHING = np.zeros((0, 0), np.int8)
FAR, SMALL = 1e9, 1e-290  # farther out for its size, or smaller, rounding is no longer small beside a margin: nothing is known


def known_cells(hull: Array, parts: Parts, cells: PartsIndex, lo: Array, hi: Array) -> NDArray[np.int8]:
    """What each small cell wholly is, shape (FINE * rows, FINE * columns): FREE inside the hull and off all parts, SOLID, or MIXED.

    A cell counts with a margin round it, so that rounding cannot carry a point to a cell which it does not belong to. Empty for
    worlds too far out or too small to be cut up so.
    """
    size = (hi - lo).max()
    if size < SMALL or np.abs([lo, hi]).max() > FAR * size:
        return NOTHING
    known = np.empty((FINE * cells.rows, FINE * cells.columns), np.int8)
    fill_known_cells(known, hull, parts, cells)
    return known


@body
def fill_known_cells(known: NDArray[np.int8], hull: Array, parts: Parts, cells: PartsIndex) -> None:
    """Judge the small cells by the hull and by the parts that the index names there."""
    side = cells.cell / FINE
    for j in range(known.shape[0]):
        for i in range(known.shape[1]):
            x0, x1 = cells.x + (i - MARGIN) * side, cells.x + (i + 1.0 + MARGIN) * side
            y0, y1 = cells.y + (j - MARGIN) * side, cells.y + (j + 1.0 + MARGIN) * side
            found = FREE if box_in_polygon(x0, y0, x1, y1, hull, 0, len(hull)) == SOLID else MIXED
            cell = j // FINE * cells.columns + i // FINE
            for entry in range(cells.first[cell], cells.first[cell + 1]):
                part = box_in_part(x0, y0, x1, y1, parts, cells.parts[entry], cells.boxes)
                found = MIXED if part == MIXED else found
                if part == SOLID:
                    found = SOLID
                    break
            known[j, i] = found


@inlined
def box_in_part(x0: float, y0: float, x1: float, y1: float, parts: Parts, i: int, boxes: Array) -> int:
    """Whether a box is SOLID inside part i, FREE of it, or neither; a round part is not looked at closely."""
    if x1 < boxes[i, 0] or x0 > boxes[i, 2] or y1 < boxes[i, 1] or y0 > boxes[i, 3]:
        return FREE
    if parts.radius[i] > 0.0:
        return MIXED
    return box_in_polygon(x0, y0, x1, y1, parts.points, parts.first[i], parts.first[i + 1])


@compiled
def box_in_polygon(x0: float, y0: float, x1: float, y1: float, points: Array, begin: int, end: int) -> int:
    """Whether a box is SOLID strictly inside the convex polygon points[begin:end], FREE where an edge parts them, or neither.

    The box's corner farthest to the left of an edge and the one farthest to its right decide for all four.
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
def known_at(x: float, y: float, known: NDArray[np.int8], cells: PartsIndex) -> int:
    """What is known of the small cell that holds a point of the world's bounding box; MIXED where nothing is."""
    if len(known) == 0:
        return MIXED
    side = cells.cell / FINE
    return known[clip((y - cells.y) / side, known.shape[0] - 1), clip((x - cells.x) / side, known.shape[1] - 1)]
