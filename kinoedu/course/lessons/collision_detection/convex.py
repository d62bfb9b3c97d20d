"""Shared by the exercises on convex polygons: is a point in one, do two of them meet? Bullo &
Smith, chapter 4.
"""

import numpy as np

from ....geometry.checks import Array
from ...shapes import Numbers

RING = Numbers(("n", 2))


TRIANGLE = np.array([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)])


def heights(q: Array, P: Array) -> Array:
    """For each edge, the last one closing the polygon, twice the area of the triangle with q:
    positive on the left; shape (n,).
    """
    along, way = np.roll(P, -1, axis=0) - P, q - P
    return along[:, 0] * way[:, 1] - along[:, 1] * way[:, 0]
