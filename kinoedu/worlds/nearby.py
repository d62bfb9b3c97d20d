"""Generic functions of a world: its convex boundary, and the convex obstacles near a box.

Every kind of world registers both, so that the collision tests work for all of them.
"""

import math

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled, generic
from ..geometry.checks import Array
from ..geometry.parts import Parts
from .checks import World
from .parts_index import MARGIN, PartsIndex, clip
from .polygon_world import PolygonWorldRecord
from .terrain import TerrainRecord


@generic(1)
def rim(world: World) -> Array:
    """The convex ring (n, 2), counter-clockwise, outside of which everything is solid."""
    raise TypeError("this world has no rim")


@generic(1)
def obstacles_near(
    world: World, x0: float, y0: float, x1: float, y1: float
) -> tuple[Parts, NDArray[np.int64]]:
    """The obstacles as convex parts, and the numbers of those near a box, each once.

    Near are the parts whose bounding boxes meet the box from (x0, y0) to (x1, y1).
    """
    raise TypeError("this world has no obstacles")


@rim.register(PolygonWorldRecord)
def rim_of_polygons(world: PolygonWorldRecord) -> Array:
    """The hull of the boundary; the region between boundary and hull is part of the obstacles."""
    return world.hull


@obstacles_near.register(PolygonWorldRecord)
def polygons_near(
    world: PolygonWorldRecord, x0: float, y0: float, x1: float, y1: float
) -> tuple[Parts, NDArray[np.int64]]:
    """Search the index of parts."""
    return world.obstacles, parts_near(world.cells, x0, y0, x1, y1)


@compiled
def parts_near(cells: PartsIndex, x0: float, y0: float, x1: float, y1: float) -> NDArray[np.int64]:
    """The numbers of the parts whose bounding boxes meet a box.

    A part in several cells is reported at the first of them that is searched.
    """
    found, size = np.empty(len(cells.boxes), np.int64), 0
    i0, i1 = column_of(cells, x0, -MARGIN), column_of(cells, x1, MARGIN)
    j0, j1 = row_of(cells, y0, -MARGIN), row_of(cells, y1, MARGIN)
    for j in range(j0, j1 + 1):
        for i in range(i0, i1 + 1):
            for entry in range(
                cells.first[j * cells.columns + i], cells.first[j * cells.columns + i + 1]
            ):
                part = cells.parts[entry]
                left, bottom, right, top = cells.boxes[part]
                if x1 < left or x0 > right or y1 < bottom or y0 > top:
                    continue
                if i == max(i0, column_of(cells, left, -MARGIN)) and j == max(
                    j0, row_of(cells, bottom, -MARGIN)
                ):
                    found[size] = part
                    size += 1
    return found[:size]


@compiled
def column_of(cells: PartsIndex, x: float, margin: float) -> int:
    """The column of the index in which x lies."""
    return clip(math.floor((x - cells.x) / cells.cell + margin), cells.columns - 1)


@compiled
def row_of(cells: PartsIndex, y: float, margin: float) -> int:
    """The row of the index in which y lies."""
    return clip(math.floor((y - cells.y) / cells.cell + margin), cells.rows - 1)


@rim.register(TerrainRecord)
def rim_of_terrain(world: TerrainRecord) -> Array:
    """The corners of the bitmap."""
    (x0, y0), (x1, y1) = (world.lo[0], world.lo[1]), (world.hi[0], world.hi[1])
    return np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])


@obstacles_near.register(TerrainRecord)
def blocked_near(
    world: TerrainRecord, x0: float, y0: float, x1: float, y1: float
) -> tuple[Parts, NDArray[np.int64]]:
    """Rectangles of blocked cells."""
    side, ox, oy = world.resolution, world.origin[0], world.origin[1]
    rows, columns = world.free.shape
    i0 = clip((x0 - ox) / side - MARGIN, columns - 1)
    i1 = clip((x1 - ox) / side + MARGIN, columns - 1)
    j0, j1 = clip((y0 - oy) / side - MARGIN, rows - 1), clip((y1 - oy) / side + MARGIN, rows - 1)
    runs = blocked_runs(world.free, i0, i1, j0, j1)
    points = np.empty((4 * len(runs), 2))
    for k in range(len(runs)):
        row, begin, end = runs[k, 0], runs[k, 1], runs[k, 2]
        left, right = ox + side * begin, ox + side * end
        bottom, top = oy + side * row, oy + side * (row + 1)
        points[4 * k, 0], points[4 * k, 1] = left, bottom
        points[4 * k + 1, 0], points[4 * k + 1, 1] = right, bottom
        points[4 * k + 2, 0], points[4 * k + 2, 1] = right, top
        points[4 * k + 3, 0], points[4 * k + 3, 1] = left, top
    return Parts(points, 4 * np.arange(len(runs) + 1), np.zeros(len(runs))), np.arange(len(runs))


@compiled
def blocked_runs(free: NDArray[np.bool_], i0: int, i1: int, j0: int, j1: int) -> NDArray[np.int64]:
    """The runs of blocked cells in columns i0..i1 of rows j0..j1: row, first and end column."""
    runs, size = np.empty(((j1 - j0 + 1) * ((i1 - i0) // 2 + 1), 3), np.int64), 0
    for j in range(j0, j1 + 1):
        begin = -1
        for i in range(i0, i1 + 2):
            blocked = i <= i1 and not free[j, i]
            if blocked and begin < 0:
                begin = i
            elif not blocked and begin >= 0:
                runs[size, 0], runs[size, 1], runs[size, 2] = j, begin, i
                begin, size = -1, size + 1
    return runs[:size]
