"""Contacts between a path and discs in scenarios."""

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....geometry.segments import point_segment_distance
from ...withheld import withheld

Hits = NDArray[np.bool_]


def measure_gaps(path: Array, discs: Array, offsets: Array) -> Array:
    """Return the distance from the path to the rim of each disc in each scenario, (n, m).

    Distances are negative where the path enters the disc.
    """
    centres = discs[:, :2] + offsets
    flat = centres.reshape(-1, 2)
    far = np.min([point_segment_distance(flat, a, b) for a, b in zip(path, path[1:])], axis=0)
    return np.asarray(far.reshape(centres.shape[:2]) - discs[:, 2])


@withheld
def find_contacts(path: Array, discs: Array, offsets: Array) -> Hits:
    """Return whether the path touches each disc in each scenario, (n, m)."""
    return np.asarray(measure_gaps(path, discs, offsets) <= 0.0)
