"""A robot that moves straight past one convex piece: whether it touches it, and how near it comes.

What moves, and what is not quite where it was expected, is passed in its own frame: there the robot
moves and the piece stands.
"""

from typing import Any

import numpy as np

from ..compiled import generic
from ..geometry.checks import Array
from ..geometry.parts import Parts, motion_touches_part, segment_part_distance
from ..geometry.separation import pieces_distance
from ..robots.polygon import TranslatingPolygonRobot
from ..robots.round import RoundRobot
from .translating import hull_touches, swept_hull


@generic(1)
def touches(
    robot: Any, ax: float, ay: float, bx: float, by: float, parts: Parts, j: int, margin: float
) -> bool:
    """Whether the robot, moved from (ax, ay) to (bx, by) without turning, comes as near to part j
    as a margin.
    """
    raise TypeError("this robot cannot pass a moving or an uncertain obstacle")


@generic(1)
def gap(robot: Any, a: Array, b: Array, parts: Parts, j: int) -> float:
    """How near the robot comes to part j on the way from a to b; 0 or less where they touch."""
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
    """The segment of its centre, and both radii."""
    return motion_touches_part(ax, ay, bx, by, robot.radius + margin, parts, j)


@gap.register(RoundRobot)
def gap_round(robot: RoundRobot, a: Array, b: Array, parts: Parts, j: int) -> float:
    """The same."""
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
    """The hulls that its pieces sweep."""
    a, b = np.array([ax, ay]), np.array([bx, by])
    for i in range(len(robot.shape.radius)):
        if hull_touches(swept_hull(robot.shape, i, a, b), parts, j, margin):
            return True
    return False


@gap.register(TranslatingPolygonRobot)
def gap_polygon(robot: TranslatingPolygonRobot, a: Array, b: Array, parts: Parts, j: int) -> float:
    """The least of its pieces' hulls."""
    least = np.inf
    for i in range(len(robot.shape.radius)):
        hull = swept_hull(robot.shape, i, a, b)
        least = min(
            least,
            pieces_distance(hull, 0, len(hull), parts.points, parts.first[j], parts.first[j + 1]),
        )
    return least - parts.radius[j]
