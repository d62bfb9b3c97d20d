"""Polygonal robots that translate, or translate and rotate.

Bullo & Smith, chapter 3; LaValle, section 4.2.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidRobot
from ..geometry.checks import Array, as_array
from ..geometry.convex import convex_parts
from ..geometry.parts import Parts, make_parts
from ..geometry.rings import as_ring
from ..support.constructors import Constructor, with_type_names
from ..support.text import shortened


@with_type_names
class TranslatingPolygonRobot(NamedTuple):
    """A polygon that translates without rotating.

    outline (n, 2) and its convex parts `shape` are relative to the reference point, the origin.
    """

    outline: Array
    shape: Parts


@with_type_names
class RigidPolygonRobot(NamedTuple):
    """A polygon that translates and rotates about its reference point, the origin of its outline.

    A rotation by one radian counts as the length turn_weight in distances.
    """

    outline: Array
    shape: Parts
    turn_weight: float


class TranslatingPolygon(TranslatingPolygonRobot, metaclass=Constructor):
    """A polygon robot that does not rotate; its configuration (x, y) is its reference point.

    Parameters
    ----------
    vertices : (n, 2), a simple polygon, convex or not. Its origin is the reference point.

    Returns
    -------
    TranslatingPolygonRobot

    Raises
    ------
    InvalidPolygon, InvalidPoint
        Where the vertices are not a simple polygon.

    Examples
    --------
    >>> robot = TranslatingPolygon([(0, 0), (2, 0), (0, 1)])
    >>> robot.shape.first
    array([0, 3])
    """

    def __new__(cls, vertices: ArrayLike) -> TranslatingPolygonRobot:  # type: ignore[misc]  # returns the record
        outline = as_ring(vertices, "the robot")
        return TranslatingPolygonRobot(outline, shape_of(outline))


class RigidPolygon(RigidPolygonRobot, metaclass=Constructor):
    """A polygon robot that translates and rotates; its configuration is (x, y, theta).

    (x, y) is the reference point and theta the heading in radians.

    Parameters
    ----------
    vertices : (n, 2), a simple polygon, convex or not, at heading 0. Its origin is the reference
        point, about which the robot rotates; it may lie outside the polygon.
    turn_weight : the length that a rotation by one radian counts in distances. The default is the
        distance of the farthest vertex from the reference point; then no point of the robot moves
        farther than sqrt(2) times the distance.

    Returns
    -------
    RigidPolygonRobot

    Raises
    ------
    InvalidPolygon, InvalidPoint
        Where the vertices are not a simple polygon.
    InvalidRobot
        Where turn_weight is not positive.

    Examples
    --------
    >>> RigidPolygon([(-1, -1), (3, -1), (3, 1), (-1, 1)]).turn_weight ** 2
    10.000000000000002
    """

    def __new__(cls, vertices: ArrayLike, *, turn_weight: float | None = None) -> RigidPolygonRobot:  # type: ignore[misc]  # returns the record
        outline = as_ring(vertices, "the robot")
        if turn_weight is None:
            weight = np.hypot(*outline.T).max()
        else:
            weight = as_array(turn_weight, "turn_weight")
            if weight.ndim or weight <= 0.0:
                raise InvalidRobot(
                    "turn_weight must be one positive length for each radian, got "
                    f"{shortened(turn_weight)}"
                )
        return RigidPolygonRobot(outline, shape_of(outline), float(weight))


def shape_of(outline: Array) -> Parts:
    """The convex parts of a polygon."""
    parts = convex_parts(outline)
    return make_parts(parts, [0.0] * len(parts))
