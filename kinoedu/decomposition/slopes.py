"""Heapsort of edges that leave one point to the right, by slope (J. W. J. Williams, 1964).

It sorts in place.
"""

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled
from ..geometry.checks import Array
from ..geometry.exact import orientation_sign


@compiled
def sort_by_slope(
    begun: NDArray[np.int64], ends: Array, first: int, stop: int, x: float, y: float
) -> bool:
    """Sort begun[first:stop, 0], edges from (x, y), by slope; False where two of them overlap.

    O(d log d) for d edges.
    """
    size = stop - first
    for i in range(size // 2 - 1, -1, -1):
        sift_down(begun, ends, first, i, size, x, y)
    for last in range(size - 1, 0, -1):
        begun[first, 0], begun[first + last, 0] = begun[first + last, 0], begun[first, 0]
        sift_down(begun, ends, first, 0, last, x, y)
    for i in range(first + 1, stop):
        if compare_slopes(ends, begun[i, 0], begun[i - 1, 0], x, y) == 0:
            return False
    return True


@compiled
def sift_down(
    begun: NDArray[np.int64], ends: Array, first: int, i: int, size: int, x: float, y: float
) -> None:
    """Restore the heap begun[first:first + size]: move entry i below its steeper children."""
    while 2 * i + 1 < size:
        child = 2 * i + 1
        if child + 1 < size:
            left, right = begun[first + child, 0], begun[first + child + 1, 0]
            child += compare_slopes(ends, right, left, x, y) > 0
        if compare_slopes(ends, begun[first + child, 0], begun[first + i, 0], x, y) <= 0:
            return
        begun[first + i, 0], begun[first + child, 0] = begun[first + child, 0], begun[first + i, 0]
        i = child


@compiled
def compare_slopes(ends: Array, edge: int, other: int, x: float, y: float) -> int:
    """1 where an edge leaves (x, y) above another one, 0 where they overlap, -1 below. Exact."""
    return orientation_sign(x, y, ends[other, 2], ends[other, 3], ends[edge, 2], ends[edge, 3])
