"""Angles, in radians: wrapped to [-pi, pi), and the short way between two. Bullo & Smith, section 3.2; LaValle, section 5.1."""

import math

from ..compiled import compiled

FULL_TURN = 2.0 * math.pi


@compiled
def wrapped(angle: float) -> float:
    """The same direction in [-pi, pi); an angle that is there already is left as it is."""
    if -math.pi <= angle < math.pi:
        return angle
    inside = angle - FULL_TURN * math.floor((angle + math.pi) / FULL_TURN)
    return inside if -math.pi <= inside < math.pi else -math.pi


@compiled
def short_way(a: float, b: float) -> float:
    """The turn from direction a to direction b, in [-pi, pi): half a turn goes clockwise."""
    return wrapped(b - a)
