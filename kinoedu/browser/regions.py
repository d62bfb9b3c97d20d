"""Where the regions of a painted configuration space are widest, for their names."""

import math

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled
from ..geometry.checks import Array

LINKS = 3  # colours of an image: free, link 1 hits, link 2 hits
COARSE = 6  # names are placed on every sixth cell only
SMALL = 0.03  # a region whose half width is a smaller fraction of the square has no name
ROOM = 1.3  # of a name, up to the right side


@algorithm
def name_regions(image: NDArray[np.int8]) -> Array:
    """For each region that is wide enough rows x, y, link: where its name begins."""
    coarse = image[COARSE // 2 :: COARSE, COARSE // 2 :: COARSE].copy()
    rows, size, side = np.empty((LINKS, 3)), 0, 2.0 * math.pi / len(coarse)
    for link in range(LINKS):
        row, column = find_widest(coarse == link)
        if row >= 0:
            x, y = (column + 0.5) * side - math.pi, (row + 0.5) * side - math.pi
            rows[size, 0], rows[size, 1] = min(x, math.pi - ROOM) - 0.3, y - 0.2
            rows[size, 2] = link
            size += 1
    return rows[:size].copy()


@compiled
def find_widest(region: NDArray[np.bool_]) -> tuple[int, int]:
    """The cell that is farthest from the rim of a region, in a stripe the middle one.

    (-1, -1) where the region is too small. O(n^3) for n^2 cells.
    """
    n, up = len(region), steps_to_rim(region)
    depth, most = np.zeros((n, n)), 0.0
    for i in range(n):
        for j in range(n):
            squared = min((j + 1) * (j + 1), (n - j) * (n - j)) if region[i, j] else 0
            for k in range(n):
                squared = min(squared, (j - k) * (j - k) + up[i, k] * up[i, k])
            depth[i, j] = math.sqrt(squared)
            most = max(most, depth[i, j])
    row, column, least = -1, -1, np.inf
    for i in range(n):
        for j in range(n):
            aside = abs(i - n / 2) + abs(j - n / 2)
            if depth[i, j] > most - 0.5 and aside < least:
                row, column, least = i, j, aside
    return (row, column) if most > 0.0 and depth[row, column] >= SMALL * n else (-1, -1)


@compiled
def steps_to_rim(region: NDArray[np.bool_]) -> NDArray[np.int64]:
    """The steps from each cell, up or down, to the first one outside of a region."""
    n = len(region)
    steps = np.zeros((n, n), np.int64)
    for j in range(n):
        for i in range(n):
            if region[i, j]:
                steps[i, j] = (steps[i - 1, j] if i > 0 else 0) + 1
        for i in range(n - 1, -1, -1):
            if region[i, j]:
                steps[i, j] = min(steps[i, j], (steps[i + 1, j] if i < n - 1 else 0) + 1)
    return steps
