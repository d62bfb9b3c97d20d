"""The largest empty square among points, found by way of empty rectangles.

A largest empty square is as wide as an empty rectangle that has a point on its left side and one on
its right side, and is at least as high as wide; or the same holds with the axes exchanged. From
each point, a sweep to the right finds all such rectangles with this point on their left side. Each
point that is passed reduces the height, and the sweep ends when the height is less than the width.
Source: A. Naamad, D. T. Lee, W.-L. Hsu, "On the maximum empty rectangle problem" (1984).
"""

import numpy as np

from ..compiled import compiled
from ..geometry.checks import Array

ROUNDING = 1e-15  # images are inexact, because 2 - x is rounded


def largest_empty_square(points: Array) -> tuple[float, float, float]:
    """The centre (x, y) and half the side of a largest empty square centred in the unit square.

    The points, shape (m, 2), are those of the unit square with their images in its sides and
    corners.
    """
    x, y, across = find_widest_square(points[np.lexsort(points.T[::-1])])
    turned = points[:, ::-1]
    v, u, up = find_widest_square(turned[np.lexsort(turned.T[::-1])])
    return (x, y, across) if across >= up else (u, v, up)


@compiled
def find_widest_square(points: Array) -> tuple[float, float, float]:
    """The largest empty square with a point on its left side and one on its right side.

    The points, shape (m, 2), are sorted by x, then y. Returns the centre (x, y) and half the side.
    """
    best_x, best_y, best = 0.5, 0.5, 0.0
    for i in range(len(points)):
        left, y = points[i, 0], points[i, 1]
        bottom, top = -np.inf, np.inf
        for j in range(i + 1, len(points)):
            right = points[j, 0]
            width, height = right - left, top - bottom
            is_beyond = left + right > 2.0 + ROUNDING  # the centre is outside the unit square
            if width > height or height <= 2.0 * best or is_beyond:
                break
            if right == left or not bottom < points[j, 1] < top:
                continue
            half = width / 2.0
            lowest, highest = max(bottom + half, 0.0), min(top - half, 1.0)
            if half > best and left + right >= -ROUNDING and lowest <= highest:
                best_x, best_y = min(max(left + half, 0.0), 1.0), (lowest + highest) / 2.0
                best = half
            if points[j, 1] >= y:
                top = points[j, 1]
            if points[j, 1] <= y:
                bottom = points[j, 1]
    return best_x, best_y, best
