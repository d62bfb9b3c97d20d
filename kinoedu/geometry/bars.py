"""The outline of a bar with rounded ends, such as the link of an arm."""

import math

import numpy as np

from ..compiled import compiled
from .checks import Array

ARC = 25  # points of half a circle


@compiled
def bar_outline(a: Array, b: Array, radius: float) -> Array:
    """The outline of the bar from a to b, shape (50, 2): half a circle about each end."""
    heading, outline = math.atan2(b[1] - a[1], b[0] - a[0]), np.empty((2 * ARC, 2))
    for k in range(ARC):
        angle = heading - 0.5 * math.pi + math.pi * k / (ARC - 1)
        x, y = radius * math.cos(angle), radius * math.sin(angle)
        outline[k, 0], outline[k, 1] = b[0] + x, b[1] + y
        outline[ARC + k, 0], outline[ARC + k, 1] = a[0] - x, a[1] - y
    return outline
