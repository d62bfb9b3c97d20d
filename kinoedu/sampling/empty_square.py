"""The largest empty square: in the largest empty rectangle as far as squares go. After A. Naamad,
D. T. Lee, W.-L. Hsu, "On the maximum empty rectangle problem" (1984).

A square without points that is as large as can be is as wide as an empty rectangle that has a point
on its left side and one on its right, and that is at least as high as wide; or the same with the
axes exchanged. From each point, a sweep to the right finds all such rectangles of which it is the
left side: the points passed take from the height, until it is less than the width.
"""

import numpy as np

from ..compiled import compiled
from ..geometry.checks import Array

ROUNDING = 1e-15  # an image is a little off: 2 - x is rounded


def largest_empty_square(points: Array) -> tuple[float, float, float]:
    """The centre (x, y) and half the side of a largest square with its centre in the unit square
    and none of the points inside.

    The points, shape (m, 2), are those of the unit square with their images in its sides and
    corners.
    """
    x, y, across = widest(points[np.lexsort(points.T[::-1])])
    turned = points[:, ::-1]
    v, u, up = widest(turned[np.lexsort(turned.T[::-1])])
    return (x, y, across) if across >= up else (u, v, up)


@compiled
def widest(points: Array) -> tuple[float, float, float]:
    """The largest of the empty squares with a point on the left side and one on the right; points
    (m, 2) sorted by x, then y.
    """
    best_x, best_y, best = 0.5, 0.5, 0.0
    for i in range(len(points)):
        left, y = points[i, 0], points[i, 1]
        bottom, top = -np.inf, np.inf
        for j in range(i + 1, len(points)):
            right = points[j, 0]
            if (
                right - left > top - bottom
                or top - bottom <= 2.0 * best
                or left + right > 2.0 + ROUNDING
            ):
                # it would be wider than high, not larger, or have its centre beyond the unit square
                break
            if right == left or not bottom < points[j, 1] < top:
                continue
            half = (right - left) / 2.0
            lowest, highest = max(bottom + half, 0.0), min(top - half, 1.0)
            if half > best and left + right >= -ROUNDING and lowest <= highest:
                best_x, best_y, best = (
                    min(max(left + half, 0.0), 1.0),
                    (lowest + highest) / 2.0,
                    half,
                )
            if points[j, 1] >= y:
                top = points[j, 1]
            if points[j, 1] <= y:
                bottom = points[j, 1]
    return best_x, best_y, best
