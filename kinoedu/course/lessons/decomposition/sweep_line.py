"""Shared parts of the exercises on one position of the sweep line. Bullo & Smith, chapter 2."""

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ...withheld import withheld


@withheld
def crossed_edges(x: float, edges: Array) -> NDArray[np.int64]:
    """Indices of the edges that a vertical line crosses, from bottom to top, (k,)."""
    hit = np.flatnonzero((edges[:, 0] < x) != (edges[:, 2] < x))
    return hit[np.argsort(heights(x, edges[hit]))]


def heights(x: float, edges: Array) -> Array:
    """Height of each edge (n, 4) at x, (n,)."""
    slope = (edges[:, 3] - edges[:, 1]) / (edges[:, 2] - edges[:, 0])
    return edges[:, 1] + (x - edges[:, 0]) * slope
