"""The contact and the distance between one convex piece and a robot in straight motion.

For a moving obstacle, or one with an uncertain position, coordinates are relative to the piece.
"""

import numpy as np

from ..compiled import generic
from ..geometry.checks import Array
from ..geometry.parts import Parts, motion_touches_part, segment_part_distance
from ..geometry.separation import pieces_distance
from ..robots.kinds import Robot
from ..robots.polygon import TranslatingPolygonRobot
from ..robots.round import RoundRobot
from .translating import hull_touches, swept_hull


@generic(1)
def touches(
    robot: Robot, ax: float, ay: float, bx: float, by: float, parts: Parts, j: int, margin: float
) -> bool:
    """Whether the robot comes within `margin` of part j on the way from (ax, ay) to (bx, by).

    The robot does not rotate.
    """
    raise TypeError("this robot cannot pass a moving or an uncertain obstacle")


@generic(1)
def gap(robot: Robot, a: Array, b: Array, parts: Parts, j: int) -> float:
    """The distance of the robot from part j on the way from a to b; 0 or less where they touch."""
    raise TypeError("this robot cannot pass a moving or an uncertain obstacle")


@touches.register(RoundRobot)
def touches_round(
    robot: RoundRobot,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    parts: Parts,
    j: int,
    margin: float,
) -> bool:
    """The segment that the centre sweeps, grown by both radii."""
    return motion_touches_part(ax, ay, bx, by, robot.radius + margin, parts, j)


@gap.register(RoundRobot)
def gap_round(robot: RoundRobot, a: Array, b: Array, parts: Parts, j: int) -> float:
    """The distance of the segment that the centre sweeps, less both radii."""
    return segment_part_distance(a[0], a[1], b[0], b[1], parts, j) - parts.radius[j] - robot.radius


@touches.register(TranslatingPolygonRobot)
def touches_polygon(
    robot: TranslatingPolygonRobot,
    ax: float,
    ay: float,
    bx: float,
    by: float,
    parts: Parts,
    j: int,
    margin: float,
) -> bool:
    """The convex hulls that the pieces sweep."""
    a, b = np.array([ax, ay]), np.array([bx, by])
    for i in range(len(robot.shape.radius)):
        if hull_touches(swept_hull(robot.shape, i, a, b), parts, j, margin):
            return True
    return False


@gap.register(TranslatingPolygonRobot)
def gap_polygon(robot: TranslatingPolygonRobot, a: Array, b: Array, parts: Parts, j: int) -> float:
    """The least distance of the convex hulls that the pieces sweep."""
    least = np.inf
    for i in range(len(robot.shape.radius)):
        hull = swept_hull(robot.shape, i, a, b)
        least = min(
            least,
            pieces_distance(hull, 0, len(hull), parts.points, parts.first[j], parts.first[j + 1]),
        )
    return least - parts.radius[j]
