"""Round robots: a point and a disk. Their configuration is the position (x, y) of the centre."""

from typing import NamedTuple

import numpy as np

from ..errors import InvalidRobot
from ..geometry.checks import as_array
from ..geometry.parts import Parts, make_parts
from ..support.constructors import Constructor
from ..support.text import shortened


class RoundRobot(NamedTuple):
    """A disc, or a point where the radius is 0."""

    radius: float

    @property
    def body(self) -> Parts:
        """The disc as Parts, at the origin."""
        return make_parts([np.zeros((1, 2))], [self.radius])


class Point(RoundRobot, metaclass=Constructor):
    """A robot without size.

    Collision tests of its motions are exact among polygons. On a terrain they are exact if
    positions divided by the resolution are exact floats, as at resolution 1 with origin (0, 0).

    Returns
    -------
    RoundRobot, with radius 0.
    """

    @classmethod
    def _makes(cls, thing: RoundRobot) -> bool:
        """Whether this class could have made the record."""
        return thing.radius == 0.0

    def __new__(cls) -> RoundRobot:  # type: ignore[misc]  # returns the record
        return RoundRobot(0.0)


class Disk(RoundRobot, metaclass=Constructor):
    """A disk with a radius in the world's unit of length.

    Returns
    -------
    RoundRobot

    Raises
    ------
    InvalidRobot
        Where the radius is not positive, or not one number.
    InvalidPoint
        Where it is not finite real numbers.

    Examples
    --------
    >>> Disk(0.5).body.radius
    array([0.5])
    """

    @classmethod
    def _makes(cls, thing: RoundRobot) -> bool:
        """Whether this class could have made the record."""
        return thing.radius > 0.0

    def __new__(cls, radius: float) -> RoundRobot:  # type: ignore[misc]  # returns the record
        size = as_array(radius, "radius")
        if size.ndim or size <= 0.0:
            raise InvalidRobot(
                f"a disk's radius must be one positive length, got {shortened(radius)}; a robot "
                "without size is Point()"
            )
        return RoundRobot(float(size))
