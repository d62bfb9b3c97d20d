"""Collision detection for round robots on terrains, in units of cells.

For a point it is exact where positions in units of cells are exact.
"""

import math

import numpy as np

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..geometry.exact import orientation_sign
from ..geometry.segments import segments_distance
from ..robots.round import RoundRobot
from ..worlds.parts_index import stretch_in_band
from ..worlds.terrain import TerrainRecord
from .interface import is_free_path, is_semi_free_path

ROUNDING = 1e-12  # of a radius: a disc that slides may be nearer by this fraction
SLACK = 1e-3  # of a cell: rows are searched a little beyond the motion


@is_free_path.register(RoundRobot, TerrainRecord)
def is_free_path_on_terrain(
    robot: RoundRobot, world: TerrainRecord, a: Array, b: Array, clearance: float
) -> bool:
    """Whether the robot stays inside the terrain and touches no blocked cell, not even a corner."""
    ax, ay, bx, by = in_cells(world, a, b)
    radius = (robot.radius + clearance) / world.resolution
    rows, columns = world.free.shape
    if not (
        min(ax, bx) > radius
        and max(ax, bx) < columns - radius
        and min(ay, by) > radius
        and max(ay, by) < rows - radius
    ):
        return False
    return not meets_blocked(world.free, ax, ay, bx, by, radius, True)


@is_semi_free_path.register(RoundRobot, TerrainRecord)
def is_semi_free_path_on_terrain(
    robot: RoundRobot, world: TerrainRecord, a: Array, b: Array, clearance: float
) -> bool:
    """Whether the robot enters no blocked cell.

    A point does not pass between two blocked cells that share an edge either.
    """
    ax, ay, bx, by = in_cells(world, a, b)
    radius = (robot.radius + clearance) / world.resolution * (1.0 - ROUNDING)
    rows, columns = world.free.shape
    if not (
        min(ax, bx) >= radius
        and max(ax, bx) <= columns - radius
        and min(ay, by) >= radius
        and max(ay, by) <= rows - radius
    ):
        return False
    if meets_blocked(world.free, ax, ay, bx, by, radius, False):
        return False
    if radius == 0.0 and ax == bx and ay == by:
        return has_free_neighbour(world.free, ax, ay)
    return radius > 0.0 or not (
        runs_in_wall(world.free, ax, bx, ay, by) or runs_in_wall(world.free.T, ay, by, ax, bx)
    )


@inlined
def in_cells(world: TerrainRecord, a: Array, b: Array) -> tuple[float, float, float, float]:
    """Two positions in units of cells from the lower left corner."""
    ox, oy, side = world.origin[0], world.origin[1], world.resolution
    return (a[0] - ox) / side, (a[1] - oy) / side, (b[0] - ox) / side, (b[1] - oy) / side


@compiled
def meets_blocked(
    free: np.ndarray, ax: float, ay: float, bx: float, by: float, radius: float, closed: bool
) -> bool:
    """Whether a disc moved along a-b meets a blocked cell; every cell within reach is examined.

    Where `closed`, cells include their edges and corners; otherwise only their interiors.
    """
    rows, columns = free.shape
    low, high = min(ay, by) - radius, max(ay, by) + radius
    for j in range(max(math.ceil(low) - 1, 0), min(math.floor(high), rows - 1) + 1):
        left, right = stretch_in_band(ax, ay, bx, by, j - radius - SLACK, j + 1 + radius + SLACK)
        begin = max(math.floor(left - radius) - 1, 0)
        end = min(math.floor(right + radius) + 1, columns - 1)
        for i in range(begin, end + 1):
            if not free[j, i] and meets_cell(ax, ay, bx, by, radius, i, j, closed):
                return True
    return False


@compiled
def meets_cell(
    ax: float, ay: float, bx: float, by: float, radius: float, i: int, j: int, closed: bool
) -> bool:
    """Whether a disc moved along a-b meets the cell [i, i + 1] x [j, j + 1].

    Exact for a point, to rounding for a disc.
    """
    if radius > 0.0:
        gap = cell_distance(ax, ay, bx, by, i, j)
        return gap <= radius if closed else gap < radius
    x0, x1, y0, y1 = min(ax, bx), max(ax, bx), min(ay, by), max(ay, by)
    if closed:
        if x1 < i or x0 > i + 1 or y1 < j or y0 > j + 1:
            return False
    elif x1 <= i or x0 >= i + 1 or y1 <= j or y0 >= j + 1:
        return False
    if ax == bx or ay == by:
        return True
    # the corners farthest to either side of the motion's line
    rising = (bx > ax) == (by > ay)
    lower = orientation_sign(ax, ay, bx, by, i + 1.0 if rising else float(i), float(j))
    upper = orientation_sign(ax, ay, bx, by, float(i) if rising else i + 1.0, j + 1.0)
    return lower * upper <= 0 if closed else lower * upper < 0


@compiled
def cell_distance(ax: float, ay: float, bx: float, by: float, i: int, j: int) -> float:
    """The distance between the segment a-b and the cell [i, i + 1] x [j, j + 1]."""
    if (i <= ax <= i + 1 and j <= ay <= j + 1) or (i <= bx <= i + 1 and j <= by <= j + 1):
        return 0.0
    x0, y0, x1, y1 = float(i), float(j), i + 1.0, j + 1.0
    across = min(
        segments_distance(ax, ay, bx, by, x0, y0, x1, y0),
        segments_distance(ax, ay, bx, by, x0, y1, x1, y1),
    )
    upright = min(
        segments_distance(ax, ay, bx, by, x0, y0, x0, y1),
        segments_distance(ax, ay, bx, by, x1, y0, x1, y1),
    )
    return min(across, upright)


@compiled
def runs_in_wall(free: np.ndarray, ax: float, bx: float, ay: float, by: float) -> bool:
    """Whether a motion along a grid line y = const has blocked cells on both sides somewhere.

    The outside counts as blocked. For a line x = const call it with free.T, and y for x.
    """
    if ay != by or ay != math.floor(ay) or ax == bx:
        return False
    rows, columns = free.shape
    j = int(ay)
    for i in range(max(math.floor(min(ax, bx)), 0), min(math.ceil(max(ax, bx)), columns)):
        if (j == 0 or not free[j - 1, i]) and (j == rows or not free[j, i]):
            return True
    return False


@compiled
def has_free_neighbour(free: np.ndarray, x: float, y: float) -> bool:
    """Whether one of the up to four cells that hold a point is free."""
    rows, columns = free.shape
    for j in range(max(math.ceil(y) - 1, 0), min(math.floor(y), rows - 1) + 1):
        for i in range(max(math.ceil(x) - 1, 0), min(math.floor(x), columns - 1) + 1):
            if free[j, i]:
                return True
    return False
