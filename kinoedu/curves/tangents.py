"""Words of three pieces from the pose (0, 0, 0) to (x, y, phi), for turning radius 1.

Each function starts with an arc to the left; the other words are mirror images. Angles are not
wrapped. Each returns whether the word exists and its three lengths. Source: J. A. Reeds and L. A.
Shepp, "Optimal paths for a car that goes both forwards and backwards" (1990), formulas 8.1 to 8.4.
"""

import math

from ..compiled import compiled

SLACK = 1e-12  # circles that touch up to rounding have a tangent


@compiled
def left_centre(x: float, y: float, phi: float) -> tuple[float, float]:
    """Distance and direction from the centre of the first left circle to that of the last."""
    ex, ey = x - math.sin(phi), y - 1.0 + math.cos(phi)
    return math.sqrt(ex * ex + ey * ey), math.atan2(ey, ex)


@compiled
def right_centre(x: float, y: float, phi: float) -> tuple[float, float]:
    """The same as `left_centre` where the last circle is a right one."""
    ex, ey = x + math.sin(phi), y - 1.0 - math.cos(phi)
    return math.sqrt(ex * ex + ey * ey), math.atan2(ey, ex)


@compiled
def lsl(x: float, y: float, phi: float) -> tuple[bool, float, float, float]:
    """Left, straight along the outer tangent, left."""
    apart, direction = left_centre(x, y, phi)
    return True, direction, apart, phi - direction


@compiled
def lsr(x: float, y: float, phi: float) -> tuple[bool, float, float, float]:
    """Left, straight along the inner tangent, right. It exists where the circles do not overlap."""
    apart, direction = right_centre(x, y, phi)
    if apart < 2.0 - SLACK:
        return False, 0.0, 0.0, 0.0
    straight = math.sqrt(max(apart * apart - 4.0, 0.0))
    first = direction + math.atan2(2.0, straight)
    return True, first, straight, first - phi


@compiled
def lrl(x: float, y: float, phi: float) -> tuple[bool, float, float, float]:
    """Left, right backwards by less than half a circle, left. It exists where the circles are near.

    The middle circle touches the other two.
    """
    apart, direction = left_centre(x, y, phi)
    if apart > 4.0 + SLACK:
        return False, 0.0, 0.0, 0.0
    middle = -2.0 * math.asin(min(0.25 * apart, 1.0))
    first = direction + 0.5 * middle + math.pi
    return True, first, middle, phi - first + middle
