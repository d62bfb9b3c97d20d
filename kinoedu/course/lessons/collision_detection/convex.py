"""Shared parts of the exercises on convex polygons. Bullo & Smith, chapter 4."""

import numpy as np

from ....geometry.checks import Array
from ...shapes import Numbers

RING = Numbers(("n", 2))
TRIANGLE = np.array([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)])


def edge_areas(q: Array, P: Array) -> Array:
    """Twice the signed area of the triangle of each edge and q, positive on the left; (n,).

    The closing edge comes last.
    """
    along, way = np.roll(P, -1, axis=0) - P, q - P
    return along[:, 0] * way[:, 1] - along[:, 1] * way[:, 0]
