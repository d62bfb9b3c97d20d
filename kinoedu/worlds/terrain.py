"""A terrain: a bitmap of free and blocked cells."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidWorld
from ..geometry.checks import LIMIT, Array, as_array, as_point


class TerrainRecord(NamedTuple):
    """What `Terrain` makes. Cell free[j, i] covers origin + resolution * ([i, i + 1) x [j, j + 1)); lo and hi are the corners."""

    free: NDArray[np.bool_]
    resolution: float
    origin: Array
    lo: Array
    hi: Array


def Terrain(free: ArrayLike, *, resolution: float = 1.0, origin: ArrayLike = (0.0, 0.0)) -> TerrainRecord:
    """A world made of square cells.

    Parameters
    ----------
    free : (rows, columns), true where a cell is free. x goes right and y up: free[j, i] is the cell i to the right and j up, so
        row 0 is the lowest. A picture's array, whose row 0 is the top, goes in as `Terrain(picture[::-1])`; the readers of
        `read_world` do so.
    resolution : the side of a cell, in the world's unit of length.
    origin : the lower left corner, (x, y).

    Blocked cells are closed: their edges and corners are not free. Nor is the rim of the terrain. Raises InvalidWorld.

    >>> Terrain([[True, False], [True, True]]).hi
    array([2., 2.])
    """
    try:
        cells = np.array(free)
    except ValueError as error:
        raise InvalidWorld("a terrain needs a bitmap of shape (rows, columns), got rows of different lengths") from error
    if cells.ndim != 2 or cells.size == 0:
        raise InvalidWorld(f"a terrain needs a bitmap of shape (rows, columns), got shape {cells.shape}")
    if cells.dtype != np.bool_ and not np.isin(cells, (0, 1)).all():
        raise InvalidWorld(f"a terrain's cells must be true (free) or false, got values of type {cells.dtype}")
    side = as_array(resolution, "resolution")
    if side.ndim or side <= 0.0:
        raise InvalidWorld(f"a terrain's resolution must be one positive length, got {resolution}")
    corner = as_point(origin, "origin")
    extent = float(side) * np.array(cells.shape[::-1], np.float64)
    if not (corner + float(side) > corner).all() or not (np.abs(corner + extent) <= LIMIT).all():
        raise InvalidWorld(f"cells of {float(side):g} cannot be told apart at {tuple(corner.tolist())}, or reach beyond 1e150")
    return TerrainRecord(np.ascontiguousarray(cells, np.bool_), float(side), corner, corner, corner + extent)
