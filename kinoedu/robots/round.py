"""Round robots: a point, and a disk. Their configuration is the position (x, y) of their centre."""

from typing import NamedTuple

import numpy as np

from ..errors import InvalidRobot
from ..geometry.checks import as_array
from ..geometry.parts import Parts, make_parts


class RoundRobot(NamedTuple):
    """A body of one point with a radius, moved without turning."""

    radius: float

    @property
    def body(self) -> Parts:
        """The body as Parts, at the origin."""
        return make_parts([np.zeros((1, 2))], [self.radius])


def Point() -> RoundRobot:
    """A robot without size. Its motions are judged exactly; on a terrain where positions in cells
    are exact, as at resolution 1.
    """
    return RoundRobot(0.0)


def Disk(radius: float) -> RoundRobot:
    """A disk of the given radius, in the world's unit of length. Raises InvalidRobot unless it is
    positive and finite.

    >>> Disk(0.5).body.radius
    array([0.5])
    """
    size = as_array(radius, "radius")
    if size.ndim or size <= 0.0:
        raise InvalidRobot(
            f"a disk's radius must be one positive length, got {radius!r}; a robot without size "
            "is Point()"
        )
    return RoundRobot(float(size))
