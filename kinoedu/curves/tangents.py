"""Between two turning circles of radius 1: how words of three pieces join the pose (0, 0, 0) to a
pose (x, y, phi).

Each begins with an arc to the left; the others are their mirror images. Angles come back as they
are computed, not wrapped. J. A. Reeds and L. A. Shepp, "Optimal paths for a car that goes both
forwards and backwards" (1990), formulas 8.1 to 8.4.
"""

import math

from ..compiled import compiled

SLACK = 1e-12  # circles that touch to rounding have their tangent


@compiled
def left_centre(x: float, y: float, phi: float) -> tuple[float, float]:
    """The distance and direction from the first circle's centre to that of the last, both to the
    left.
    """
    ex, ey = x - math.sin(phi), y - 1.0 + math.cos(phi)
    return math.sqrt(ex * ex + ey * ey), math.atan2(ey, ex)


@compiled
def right_centre(x: float, y: float, phi: float) -> tuple[float, float]:
    """The same for a last circle to the right."""
    ex, ey = x + math.sin(phi), y - 1.0 - math.cos(phi)
    return math.sqrt(ex * ex + ey * ey), math.atan2(ey, ex)


@compiled
def lsl(x: float, y: float, phi: float) -> tuple[bool, float, float, float]:
    """Left, straight along the outer tangent, left."""
    apart, direction = left_centre(x, y, phi)
    return True, direction, apart, phi - direction


@compiled
def lsr(x: float, y: float, phi: float) -> tuple[bool, float, float, float]:
    """Left, straight along the inner tangent, right: where the circles do not cross."""
    apart, direction = right_centre(x, y, phi)
    if apart < 2.0 - SLACK:
        return False, 0.0, 0.0, 0.0
    straight = math.sqrt(max(apart * apart - 4.0, 0.0))
    first = direction + math.atan2(2.0, straight)
    return True, first, straight, first - phi


@compiled
def lrl(x: float, y: float, phi: float) -> tuple[bool, float, float, float]:
    """Left, right round a circle that touches both, backwards and less than half of it, left: where
    the two are near.
    """
    apart, direction = left_centre(x, y, phi)
    if apart > 4.0 + SLACK:
        return False, 0.0, 0.0, 0.0
    middle = -2.0 * math.asin(min(0.25 * apart, 1.0))
    first = direction + 0.5 * middle + math.pi
    return True, first, middle, phi - first + middle
