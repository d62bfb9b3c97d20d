"""The cost of a motion: its length, or the integral of a terrain's costs along it.

J. S. B. Mitchell, C. H. Papadimitriou, "The weighted region problem: finding shortest paths through
a weighted planar subdivision" (1991).
"""

from __future__ import annotations

import math

import numpy as np

from ..compiled import compiled, generic
from ..errors import InvalidParameter
from ..geometry.checks import Array
from ..geometry.polygons import locate_point
from ..robots.kinds import Robot
from ..robots.polygon import TranslatingPolygonRobot
from ..robots.round import RoundRobot
from ..spaces import distance
from ..spaces.interface import Space
from ..worlds.checks import World
from ..worlds.terrain import TerrainRecord
from .round_terrain import in_cells

ROUND = 1e-12  # of a motion: a shorter stretch in a blocked cell is a rounding error


@generic(2)
def motion_cost(robot: Robot, world: World, space: Space, a: Array, b: Array) -> float:
    """The cost of the straight motion from a to b, free or not: its length."""
    return distance(space, a, b)


@motion_cost.register(RoundRobot, TerrainRecord)
@motion_cost.register(TranslatingPolygonRobot, TerrainRecord)
def cost_on_terrain(robot: Robot, world: TerrainRecord, space: Space, a: Array, b: Array) -> float:
    """The integral of the cells' costs at the robot's centre or reference point."""
    if world.cost.size == 0:
        return distance(space, a, b)
    return world.resolution * integral(world.cost, *in_cells(world, a, b))


def check_cost(robot: Robot, world: World) -> None:
    """Check that a robot can be used on a terrain with costs.

    Raises
    ------
    InvalidParameter
        Where the terrain has costs and the robot has no single point of its body at which they are
        evaluated.
    """
    has_costs = isinstance(world, TerrainRecord) and world.cost.size
    if not has_costs or isinstance(robot, RoundRobot):
        return
    if not isinstance(robot, TranslatingPolygonRobot):
        raise InvalidParameter(
            "a terrain with costs needs Point(), Disk(r) or TranslatingPolygon(...); use a terrain "
            "without cost="
        )
    if locate_point(0.0, 0.0, robot.outline) < 0:
        raise InvalidParameter(
            "a terrain's costs are those at the robot's reference point, which must be part of its "
            "body; give TranslatingPolygon vertices around (0, 0)"
        )


@compiled
def integral(cost: Array, ax: float, ay: float, bx: float, by: float) -> float:
    """The integral of the cells' costs along the segment a-b; O(cells crossed).

    Along the common side of two cells the lower cost counts, so that cheapest paths exist. Outside
    the cells the integral is infinite. J. Amanatides, A. Woo, "A fast voxel traversal algorithm for
    ray tracing" (1987).
    """
    dx, dy = bx - ax, by - ay
    if dx == 0.0 and dy == 0.0:
        return 0.0
    if is_far_out(cost, ax, ay) or is_far_out(cost, bx, by):
        return np.inf
    i, j, t, total = first_cell(ax, dx), first_cell(ay, dy), 0.0, 0.0
    while t < 1.0:
        leaves_column, leaves_row = crossing(ax, dx, i), crossing(ay, dy, j)
        after = min(leaves_column, leaves_row, 1.0)
        if after > t:
            here = cheapest(cost, i, j, dx == 0.0 and ax == i, dy == 0.0 and ay == j)
            if here < np.inf or after - t > ROUND:
                total += (after - t) * here
            t = after
        if leaves_column <= after:
            i += 1 if dx > 0.0 else -1
        if leaves_row <= after:
            j += 1 if dy > 0.0 else -1
    return total * math.sqrt(dx * dx + dy * dy)


@compiled
def is_far_out(cost: Array, x: float, y: float) -> bool:
    """Whether a point is more than a cell outside, where no cells need to be crossed to know it."""
    rows, columns = cost.shape
    return not (-1.0 <= x <= columns + 1.0 and -1.0 <= y <= rows + 1.0)


@compiled
def first_cell(x: float, dx: float) -> int:
    """The number of the column in which a motion from x begins."""
    cell = math.floor(x)
    return int(cell) - 1 if dx < 0.0 and x == cell else int(cell)


@compiled
def crossing(x: float, dx: float, i: int) -> float:
    """The fraction of a motion at which it leaves column i; 1 or more where it ends there."""
    if dx == 0.0:
        return np.inf
    return (i + 1 - x) / dx if dx > 0.0 else (i - x) / dx


@compiled
def cheapest(cost: Array, i: int, j: int, on_left: bool, on_bottom: bool) -> float:
    """The cost of cell (i, j), or the lowest cost of the cells beside a motion along a side."""
    rows, columns = cost.shape
    least = np.inf
    for row in range(j - 1 if on_bottom else j, j + 1):
        for column in range(i - 1 if on_left else i, i + 1):
            if 0 <= row < rows and 0 <= column < columns:
                least = min(least, cost[row, column])
    return least
