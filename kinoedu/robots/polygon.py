"""Polygon robots: one that only moves, and one that turns as well. Bullo & Smith, chapter 3;
LaValle, section 4.2.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidRobot
from ..geometry.checks import Array, as_array
from ..geometry.convex import convex_parts
from ..geometry.parts import Parts, make_parts
from ..geometry.rings import as_ring


class TranslatingPolygonRobot(NamedTuple):
    """A polygon that moves without turning. outline (n, 2) and its convex parts stand round the
    reference point, the origin.
    """

    outline: Array
    shape: Parts


class RigidPolygonRobot(NamedTuple):
    """A polygon that moves and turns about its reference point, the origin of outline and shape; a
    radian is turn_weight long.
    """

    outline: Array
    shape: Parts
    turn_weight: float


def TranslatingPolygon(vertices: ArrayLike) -> TranslatingPolygonRobot:
    """A polygon robot that never turns. Its configuration (x, y) is where the origin of its
    vertices' frame is.

    vertices : (n, 2), a simple polygon, convex or not. Raises InvalidPolygon, InvalidPoint.

    >>> robot = TranslatingPolygon([(0, 0), (2, 0), (0, 1)])
    >>> robot.shape.first
    array([0, 3])
    """
    outline = as_ring(vertices, "the robot")
    return TranslatingPolygonRobot(outline, shape_of(outline))


def RigidPolygon(vertices: ArrayLike, *, turn_weight: float | None = None) -> RigidPolygonRobot:
    """A polygon robot that moves and turns. Its configuration is (x, y, theta): the reference point
    and the heading in radians.

    Parameters
    ----------
    vertices : (n, 2), a simple polygon, convex or not, at heading 0. The origin of their frame is
    the reference point, which the
        robot turns about; it may lie outside the polygon.
    turn_weight : how long a turn of one radian counts in distances, in lengths per radian; by
    default the distance of the farthest
        vertex from the reference point, so that no point of the robot moves farther than the
        distance says, times sqrt(2).

    Raises InvalidPolygon, InvalidPoint; InvalidRobot for a weight that is not positive.

    >>> RigidPolygon([(-1, -1), (3, -1), (3, 1), (-1, 1)]).turn_weight ** 2
    10.000000000000002
    """
    outline = as_ring(vertices, "the robot")
    if turn_weight is None:
        weight = np.hypot(*outline.T).max()
    else:
        weight = as_array(turn_weight, "turn_weight")
        if weight.ndim or weight <= 0.0:
            raise InvalidRobot(
                f"turn_weight must be one positive length for each radian, got {turn_weight!r}"
            )
    return RigidPolygonRobot(outline, shape_of(outline), float(weight))


def shape_of(outline: Array) -> Parts:
    """The convex parts of a polygon."""
    parts = convex_parts(outline)
    return make_parts(parts, [0.0] * len(parts))
