"""A terrain: a bitmap of free and blocked cells, and optionally a cost for each cell."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import InvalidWorld
from ..geometry.checks import LIMIT, Array, as_array, as_floats, as_point
from ..support.constructors import Constructor, with_type_names
from ..support.text import shortened

MOST_COST = 1e9


@with_type_names
class TerrainRecord(NamedTuple):
    """The record that `Terrain` returns.

    free : (rows, columns); cell free[j, i] covers origin + resolution * ([i, i + 1) x [j, j + 1)).
    lo, hi : the corners of the bounding box.
    cost : (rows, columns), the cost of a unit of length in each cell, infinite where it is blocked;
        shape (0, 0) where the cost of a motion is its length.
    """

    free: NDArray[np.bool_]
    resolution: float
    origin: Array
    lo: Array
    hi: Array
    cost: Array


class Terrain(TerrainRecord, metaclass=Constructor):
    """A world of square cells.

    Blocked cells are closed: their edges and corners are not free. The border of the terrain is not
    free either.

    Parameters
    ----------
    free : (rows, columns), true where a cell is free. x points right and y up: free[j, i] is the
        cell i to the right and j up, so row 0 is the lowest. For a picture, whose row 0 is the top,
        pass `Terrain(picture[::-1])`, as the readers of `read_world` do.
    cost : (rows, columns), the cost of a unit of length in each cell, at least 1. So no path costs
        less than its length; heuristics and early termination rely on this. Values in blocked cells
        are ignored. By default the cost of a motion is its length. See `kinoedu.worlds.heights` for
        costs from slopes and roughness.
    resolution : the side of a cell, in the world's unit of length.
    origin : the lower left corner, (x, y).

    Returns
    -------
    TerrainRecord

    Raises
    ------
    InvalidWorld
        Where the bitmap or the cost is not valid, or the resolution is not one positive length.
    InvalidPoint
        Where the origin is not a point, or the resolution is not finite numbers.

    Examples
    --------
    >>> Terrain([[True, False], [True, True]]).hi
    array([2., 2.])
    """

    def __new__(  # type: ignore[misc]  # returns the record
        cls,
        free: ArrayLike,
        *,
        cost: ArrayLike | None = None,
        resolution: float = 1.0,
        origin: ArrayLike = (0.0, 0.0),
    ) -> TerrainRecord:
        try:
            cells = np.array(free)
        except ValueError as error:
            raise InvalidWorld(
                "a terrain needs a bitmap of shape (rows, columns), got rows of different lengths"
            ) from error
        if isinstance(free, np.ma.MaskedArray):
            raise InvalidWorld(
                "a terrain needs a bitmap without a mask; free.filled(False) blocks hidden cells"
            )
        if cells.ndim != 2 or cells.size == 0:
            raise InvalidWorld(
                f"a terrain needs a bitmap of shape (rows, columns), got shape {cells.shape}"
            )
        if cells.dtype != np.bool_ and not np.isin(cells, (0, 1)).all():
            raise InvalidWorld(
                f"a terrain's cells must be true (free) or false, got values of type {cells.dtype}"
            )
        side = as_array(resolution, "resolution")
        if side.ndim or side <= 0.0:
            raise InvalidWorld(
                f"a terrain's resolution must be one positive length, got {shortened(resolution)}"
            )
        corner = as_point(origin, "origin")
        extent = float(side) * np.array(cells.shape[::-1], np.float64)
        if (
            not (corner + float(side) > corner).all()
            or not (np.abs(corner + extent) <= LIMIT).all()
        ):
            raise InvalidWorld(
                f"cells of {float(side):g} are lost in rounding at {tuple(corner.tolist())}, or "
                "extend beyond 1e150"
            )
        open_cells = np.ascontiguousarray(cells, np.bool_)
        return TerrainRecord(
            open_cells, float(side), corner, corner, corner + extent, cell_costs(cost, open_cells)
        )


def cell_costs(cost: ArrayLike | None, free: NDArray[np.bool_]) -> Array:
    """Check the cost of each cell; infinite where blocked, shape (0, 0) without costs."""
    if cost is None:
        return np.empty((0, 0))
    costs = as_floats(cost)
    if costs is None:
        raise InvalidWorld(
            f"a terrain's cost must be one number for each of its cells, shape {free.shape}"
        )
    if costs.shape != free.shape:
        raise InvalidWorld(
            f"a terrain's cost must have its bitmap's shape {free.shape}, got {costs.shape}"
        )
    if not ((costs >= 1.0) & (costs <= MOST_COST))[free].all():
        raise InvalidWorld("the cost of a free cell must be from 1 to 1e9; scale the costs")
    return np.where(free, costs, np.inf)
