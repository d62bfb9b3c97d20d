"""Slope, roughness and clearance of a field of heights.

Each function returns one number for each cell. Together they give the cost of a terrain:
`Terrain(slope(h) < 1.0, cost=1.0 + 4.0 * slope(h) + 2.0 * roughness(h))`.
"""

from __future__ import annotations

from itertools import product

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidWorld
from ..geometry.checks import Array, as_array, integer, positive
from .terrain import Terrain


def as_heights(heights: ArrayLike) -> Array:
    """Check heights (rows, columns), at least 2 x 2.

    Raises
    ------
    InvalidWorld
        Where heights do not have that shape.
    InvalidPoint
        Where a height is not a finite number.
    """
    field = as_array(heights, "heights")
    if field.ndim != 2 or min(field.shape) < 2:
        raise InvalidWorld(
            f"heights must have shape (rows, columns), two or more of each, got shape {field.shape}"
        )
    return field


def slope(heights: ArrayLike, *, resolution: float = 1.0) -> Array:
    """The slope of the ground in each cell: rise over run, from the heights of its neighbours.

    Parameters
    ----------
    heights : (rows, columns), in the same unit as `resolution`, the side of a cell.

    Returns
    -------
    (rows, columns) array.

    Raises
    ------
    InvalidWorld, InvalidPoint
        Where heights do not have that shape, or are not finite.
    InvalidParameter
        Where `resolution` is not positive.

    Examples
    --------
    >>> slope([[0.0, 3.0, 6.0], [4.0, 7.0, 10.0]]).tolist()
    [[5.0, 5.0, 5.0], [5.0, 5.0, 5.0]]
    """
    up, across = np.gradient(as_heights(heights), positive(resolution, "resolution"))
    return np.sqrt(up * up + across * across)


def roughness(heights: ArrayLike, *, reach: int = 1) -> Array:
    """The standard deviation of the heights of (2 reach + 1)^2 cells about their best-fit plane.

    A smooth incline is steep but not rough. Beyond the edges of the field the heights are
    extrapolated by reflection. O(cells * reach^2).

    Returns
    -------
    (rows, columns) array.

    Raises
    ------
    InvalidWorld, InvalidPoint
        Where heights are not (rows, columns), are too few for `reach`, or are not finite.
    InvalidParameter
        Where `reach` is not an integer of at least 1.

    Examples
    --------
    >>> roughness([[0.0, 1.0, 2.0], [3.0, 4.0, 5.0], [6.0, 7.0, 8.0]]).max() < 1e-7
    np.True_
    """
    field, r = as_heights(heights), integer(reach, "reach", least=1)
    if r >= min(field.shape):
        raise InvalidWorld(f"reach {r} must be less than both sides of the heights, {field.shape}")
    padded = np.pad(field, r, mode="reflect", reflect_type="odd")
    rows, columns = field.shape
    steps = list(product(range(-r, r + 1), repeat=2))
    rise = [padded[r + v : r + v + rows, r + u : r + u + columns] - field for v, u in steps]
    mean = sum(rise) / len(steps)
    along = [
        sum(step[axis] * above for step, above in zip(steps, rise)) / len(steps) for axis in (0, 1)
    ]
    # the variances of the cells' rows (or columns), of their heights, and about the plane
    spread = sum(u * u for u, _ in steps) / len(steps)
    total = sum(above * above for above in rise) / len(steps) - mean * mean
    scatter = total - (along[0] ** 2 + along[1] ** 2) / spread
    return np.sqrt(np.maximum(scatter, 0.0))


def clearance_of_cells(free: ArrayLike, *, resolution: float = 1.0) -> Array:
    """The distance from the centre of each cell to the nearest centre of a blocked cell.

    It is 0 for a blocked cell; everything outside is blocked. O(cells), by scipy: C. R. Maurer, R.
    Qi, V. Raghavan, "A linear time algorithm for computing exact Euclidean distance transforms of
    binary images in arbitrary dimensions" (2003).

    Returns
    -------
    (rows, columns) array.

    Raises
    ------
    InvalidWorld
        Where `free` is not a bitmap.
    InvalidParameter
        Where `resolution` is not positive.

    Examples
    --------
    >>> clearance_of_cells([[1, 1, 1], [1, 1, 0], [1, 1, 1]]).tolist()
    [[1.0, 1.0, 1.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0]]
    """
    from scipy.ndimage import distance_transform_edt

    cells = Terrain(free).free
    return positive(resolution, "resolution") * distance_transform_edt(np.pad(cells, 1))[1:-1, 1:-1]
