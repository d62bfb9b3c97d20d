"""The distance of poses that the exercises on driving use."""

import math
from typing import Any


def distance_of_poses(a: Any, b: Any, radian: float) -> Any:
    """Distance between poses, with heading differences wrapped; coordinates may be arrays.

    radian : the length that a radian of heading counts as.
    """
    turn = (b[2] - a[2] + math.pi) % (2.0 * math.pi) - math.pi
    return ((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2 + (radian * turn) ** 2) ** 0.5
