"""Driving along an arc, in closed form. LaValle, Planning Algorithms, section 13.1.2."""

import math

from ..compiled import compiled
from ..spaces.angles import wrapped


@compiled
def driven(
    x: float, y: float, theta: float, distance: float, curvature: float
) -> tuple[float, float, float]:
    """Where a distance driven along an arc of a curvature ends, backwards where it is negative.

    The end lies along the arc's chord, whose heading is halfway between the two headings; with
    curvature 0 the chord is the way.
    """
    half = 0.5 * curvature * distance
    chord = distance if half == 0.0 else distance * (math.sin(half) / half)
    return (
        x + chord * math.cos(theta + half),
        y + chord * math.sin(theta + half),
        wrapped(theta + 2.0 * half),
    )
