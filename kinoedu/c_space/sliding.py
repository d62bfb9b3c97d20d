"""A convex robot slides round a convex obstacle: its reference point traces the C-obstacle.

LaValle, section 4.3.2.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidParameter
from ..geometry.checks import Array, as_array
from ..geometry.minkowski import as_convex_corners, corner_pairs
from ..support.constructors import with_type_names
from ..support.text import shortened


@with_type_names
class Slide(NamedTuple):
    """The motion of a convex robot round a convex obstacle, counter-clockwise, by stretches.

    corners : (k, 2), the position of the reference point where stretch i begins; it ends where the
        next one begins.
    kind : (k,), the type of contact, named as in LaValle: "EV", an edge of the robot slides along a
        vertex of the obstacle (Latombe's type A); "VE", a vertex of the robot slides along an edge
        of the obstacle (type B); "EE", an edge slides along an edge.
    robot_part, obstacle_part : (k,), the number of that vertex or edge; edge i begins at vertex i.
    robot, obstacle : the vertices that these numbers count, counter-clockwise; the reference point
        of the robot is the origin.
    """

    corners: Array
    kind: NDArray[np.str_]
    robot_part: NDArray[np.int64]
    obstacle_part: NDArray[np.int64]
    robot: Array
    obstacle: Array

    @property
    def lengths(self) -> Array:
        """The length of each stretch, (k,)."""
        along = np.roll(self.corners, -1, axis=0) - self.corners
        return np.sqrt((along * along).sum(axis=1))

    def at(self, fraction: float) -> tuple[Array, int]:
        """The position of the reference point after a fraction of the whole way, and its stretch.

        Parameters
        ----------
        fraction : from 0 to 1.

        Returns
        -------
        (2,) array and the number of the stretch.

        Raises
        ------
        InvalidParameter
            Where `fraction` is not one number from 0 to 1.
        """
        value = as_array(fraction, "fraction")
        if value.ndim or not 0.0 <= value <= 1.0:
            raise InvalidParameter(
                f"fraction must be one number from 0 to 1, got {shortened(fraction)}"
            )
        ends = np.cumsum(self.lengths)
        i = min(int(np.searchsorted(ends, value * ends[-1], side="right")), len(ends) - 1)
        rest = (ends[i] - value * ends[-1]) / (self.lengths[i] or 1.0)
        here, there = self.corners[i], self.corners[(i + 1) % len(self.corners)]
        return there + rest * (here - there), i


def slide(robot_vertices: ArrayLike, obstacle: ArrayLike) -> Slide:
    """The motion of a convex robot that slides once round a convex obstacle without rotating.

    The reference point follows the outline of their `minkowski_difference`; each of its edges is an
    edge of the obstacle or of the robot. O(n + m), after a check that both polygons are simple.

    Parameters
    ----------
    robot_vertices : (n, 2), a convex polygon, a segment or a point, with its reference point at the
        origin.
    obstacle : (m, 2), a convex polygon, a segment or a point.

    Returns
    -------
    Slide

    Raises
    ------
    InvalidPolygon, InvalidPoint
        Where a polygon is not valid.
    InvalidParameter
        Where both are points.

    Examples
    --------
    >>> way = slide([(0, 0), (1, 0), (0, 1)], [(2, 2), (4, 2), (4, 3), (2, 3)])
    >>> way.kind.tolist()
    ['EV', 'VE', 'EE', 'EE', 'VE']
    """
    solid = as_convex_corners(obstacle, "obstacle")
    # checked again, so that the mirrored corners begin at the leftmost one, too
    mirrored = as_convex_corners(-as_convex_corners(robot_vertices, "robot"), "robot")
    i, j = corner_pairs(solid, mirrored).T
    if len(i) < 2:
        raise InvalidParameter(
            "a point cannot slide round a point; give the robot or the obstacle a second vertex"
        )
    along_obstacle, along_robot = np.roll(i, -1) != i, np.roll(j, -1) != j
    kind = np.where(along_obstacle, np.where(along_robot, "EE", "VE"), "EV")
    return Slide(solid[i] + mirrored[j], kind, j.copy(), i.copy(), -mirrored, solid)
