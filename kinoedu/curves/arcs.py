"""Driving along an arc, in closed form. Source: LaValle, Planning Algorithms, section 13.1.2."""

import math

from ..compiled import compiled
from ..spaces.angles import wrap_angle


@compiled
def drive_arc(
    x: float, y: float, theta: float, distance: float, curvature: float
) -> tuple[float, float, float]:
    """The pose after a distance driven along an arc of constant curvature.

    A negative distance is driven backwards. The position moves along the chord of the arc, whose
    direction is halfway between the two headings. The heading of the result is wrapped.
    """
    half = 0.5 * curvature * distance
    chord = distance if half == 0.0 else distance * (math.sin(half) / half)
    return (
        x + chord * math.cos(theta + half),
        y + chord * math.sin(theta + half),
        wrap_angle(theta + 2.0 * half),
    )
