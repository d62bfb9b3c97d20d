"""Edges that leave one point to the right, put in order of slope: heapsort (J. W. J. Williams,
1964), which needs no space.
"""

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled
from ..geometry.checks import Array
from ..geometry.exact import turn


@compiled
def line_up(
    begun: NDArray[np.int64], ends: Array, first: int, stop: int, x: float, y: float
) -> bool:
    """Put begun[first:stop, 0], edges from (x, y), in order from the lowest up; False where two
    overlap. O(d log d) for d edges.
    """
    for i in range((stop - first) // 2 - 1, -1, -1):
        sink(begun, ends, first, i, stop - first, x, y)
    for last in range(stop - first - 1, 0, -1):
        begun[first, 0], begun[first + last, 0] = begun[first + last, 0], begun[first, 0]
        sink(begun, ends, first, 0, last, x, y)
    for i in range(first + 1, stop):
        if above(ends, begun[i, 0], begun[i - 1, 0], x, y) == 0:
            return False
    return True


@compiled
def sink(
    begun: NDArray[np.int64], ends: Array, first: int, i: int, size: int, x: float, y: float
) -> None:
    """Let entry i of the heap begun[first:first + size] sink below those above it in slope."""
    while 2 * i + 1 < size:
        child = 2 * i + 1
        if (
            child + 1 < size
            and above(ends, begun[first + child + 1, 0], begun[first + child, 0], x, y) > 0
        ):
            child += 1
        if above(ends, begun[first + child, 0], begun[first + i, 0], x, y) <= 0:
            return
        begun[first + i, 0], begun[first + child, 0] = begun[first + child, 0], begun[first + i, 0]
        i = child


@compiled
def above(ends: Array, edge: int, other: int, x: float, y: float) -> int:
    """1 where an edge leaves (x, y) above the other, 0 where they overlap, -1 below. Exact."""
    return turn(x, y, ends[other, 2], ends[other, 3], ends[edge, 2], ends[edge, 3])
