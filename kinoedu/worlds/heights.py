"""What a field of heights says of the ground: how steep it is, how rough, how far from what blocks
the way.

Each is an array with a number for each cell, made to be put together into a terrain's cost:
`Terrain(slope(h) < 1.0, cost=1.0 + 4.0 * slope(h) + 2.0 * roughness(h))`.
"""

from itertools import product

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidWorld
from ..geometry.checks import Array, as_array, positive, whole
from .terrain import Terrain


def as_heights(heights: ArrayLike) -> Array:
    """Heights (rows, columns), two or more either way, or InvalidWorld."""
    field = as_array(heights, "heights")
    if field.ndim != 2 or min(field.shape) < 2:
        raise InvalidWorld(
            f"heights must have shape (rows, columns), two or more of each, got shape {field.shape}"
        )
    return field


def slope(heights: ArrayLike, *, resolution: float = 1.0) -> Array:
    """How steep the ground is in each cell: rise over run, by the heights of the cells on both
    sides; shape (rows, columns).

    heights : (rows, columns), in the unit in which `resolution`, the side of a cell, is given.
        Raises InvalidWorld.

    >>> slope([[0.0, 3.0, 6.0], [4.0, 7.0, 10.0]]).tolist()
    [[5.0, 5.0, 5.0], [5.0, 5.0, 5.0]]
    """
    up, across = np.gradient(as_heights(heights), positive(resolution, "resolution"))
    return np.sqrt(up * up + across * across)


def roughness(heights: ArrayLike, *, reach: int = 1) -> Array:
    """How far the heights of (2 reach + 1)^2 cells scatter about the plane that fits them best, as
    a standard deviation.

    A smooth incline is steep, and not rough. Beyond the rim the ground is taken to go on as it
    came. O(cells * reach^2). Raises InvalidWorld, InvalidParameter.

    >>> roughness([[0.0, 1.0, 2.0], [3.0, 4.0, 5.0], [6.0, 7.0, 8.0]]).max() < 1e-7
    np.True_
    """
    field, r = as_heights(heights), whole(reach, "reach", least=1)
    if r >= min(field.shape):
        raise InvalidWorld(f"reach {r} must be less than both sides of the heights, {field.shape}")
    wide = np.pad(field, r, mode="reflect", reflect_type="odd")
    rows, columns = field.shape
    steps = list(product(range(-r, r + 1), repeat=2))
    rise = [wide[r + v : r + v + rows, r + u : r + u + columns] - field for v, u in steps]
    mean = sum(rise) / len(steps)
    along = [
        sum(step[axis] * above for step, above in zip(steps, rise)) / len(steps) for axis in (0, 1)
    ]
    spread = sum(u * u for u, _ in steps) / len(
        steps
    )  # of the cells' own columns, and of their rows
    scatter = (
        sum(above * above for above in rise) / len(steps)
        - mean * mean
        - (along[0] ** 2 + along[1] ** 2) / spread
    )
    return np.sqrt(np.maximum(scatter, 0.0))


def clearance_of_cells(free: ArrayLike, *, resolution: float = 1.0) -> Array:
    """How far each cell's centre is from the nearest centre of a blocked cell, 0 there; all outside
    is blocked. (rows, columns)

    A. Meijster, J. B. T. M. Roerdink, W. H. Hesselink, "A general algorithm for computing distance
    transforms in linear time" (2000). O(cells). Raises InvalidWorld.

    >>> clearance_of_cells([[1, 1, 1], [1, 1, 0], [1, 1, 1]]).tolist()
    [[1.0, 1.0, 1.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0]]
    """
    from scipy.ndimage import distance_transform_edt

    cells = Terrain(free).free
    return positive(resolution, "resolution") * distance_transform_edt(np.pad(cells, 1))[1:-1, 1:-1]
