"""Dispersion: the radius of the largest ball without a point, centred in the unit cube.

The points are reflected in the walls of the cube. The image of a point is nowhere nearer, inside
the cube, than the point itself, so images change no distance to the nearest point. With them, an
empty ball that touches a wall is like any other.

Sources: H. Niederreiter, "Random number generation and quasi-Monte Carlo methods", chapter 6; Bullo
& Smith, chapter 4; LaValle, section 5.2.3.
"""

from __future__ import annotations

import math
from itertools import product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import Array, as_array, is_real
from ..support.constructors import with_type_names
from ..support.text import shortened
from .empty_square import largest_empty_square
from .grids import sukharev_grid


@with_type_names
class EmptyBall(NamedTuple):
    """A ball without points inside, by its centre, shape (d,), and its radius.

    In the sup norm it is a square.
    """

    centre: Array
    radius: float


def dispersion(points: ArrayLike, norm: float = 2) -> float:
    """The largest distance from a place of the unit cube to the nearest of the points.

    It is accurate to 1e-12 and available on the line in both norms, in the plane in both norms, and
    in space in the Euclidean norm. The Euclidean dispersion uses a Voronoi diagram, O(n log n) in
    the plane. The sup norm takes O(n^(3/2)) for evenly spread points, O(n^2) at worst.

    Parameters
    ----------
    points : (n, d) points of the unit cube.
    norm : 2, or math.inf for the sup norm.

    Raises
    ------
    InvalidPoint
        Where a point lies outside the unit cube, or there are none.
    InvalidParameter
        Where the norm is neither 2 nor math.inf, or the dimension is too large.

    Examples
    --------
    >>> dispersion(sukharev_grid(16), math.inf), round(dispersion(sukharev_grid(16)), 12)
    (0.125, 0.176776695297)
    """
    return largest_empty_ball(points, norm).radius


def largest_empty_ball(points: ArrayLike, norm: float = 2) -> EmptyBall:
    """A largest ball without points that is centred in the unit cube; its radius is the dispersion.

    Parameters and errors are those of `dispersion`.

    Returns
    -------
    EmptyBall

    Examples
    --------
    >>> largest_empty_ball([(0, 0)])
    EmptyBall(centre=array([1., 1.]), radius=1.4142135623730951)
    """
    cloud = as_cube_points(points)
    d = cloud.shape[1]
    if not is_real(norm) or norm not in (2, math.inf):
        raise InvalidParameter(f"norm must be 2 or math.inf, got {shortened(norm)}")
    if d == 1:
        return largest_gap(cloud)
    if norm == 2 and d <= 3:
        return largest_empty_disc(cloud)
    if norm == math.inf and d == 2:
        x, y, radius = largest_empty_square(reflect_points(cloud))
        return EmptyBall(np.array([x, y]), float(radius))
    most = 3 if norm == 2 else 2
    raise InvalidParameter(
        f"dispersion in this norm is available up to {most} dimensions, got points of {d}"
    )


def as_cube_points(points: ArrayLike) -> Array:
    """The distinct points among one or more points of the closed unit cube, shape (n, d)."""
    cloud = as_array(points, "points")
    if cloud.ndim != 2 or cloud.size == 0:
        raise InvalidPoint(
            f"points must have shape (n, d), with one point or more, got {cloud.shape}"
        )
    outside = ((cloud < 0.0) | (cloud > 1.0)).any(axis=1)
    if outside.any():
        raise InvalidPoint(
            f"points must lie in the unit cube, from 0 to 1, got {cloud[outside][0].tolist()}; "
            "scale them to it"
        )
    return np.unique(cloud, axis=0)


def reflect_points(cloud: Array) -> Array:
    """The points and their images in all walls, edges and corners, each once, shape (m, d)."""
    images = [
        np.choose(np.array(sides)[None, :], [-cloud, cloud, 2.0 - cloud])
        for sides in product(range(3), repeat=cloud.shape[1])
    ]
    return np.unique(np.concatenate(images) + 0.0, axis=0)


def largest_gap(cloud: Array) -> EmptyBall:
    """The largest empty interval on the line, centred in [0, 1]."""
    places = np.sort(cloud[:, 0])
    places = np.concatenate([-places[:1], places, 2.0 - places[-1:]])
    i = int(np.argmax(np.diff(places)))
    left, right = places[i : i + 1], places[i + 1 : i + 2]
    return EmptyBall((left + right) / 2, float(right[0] - left[0]) / 2)


def largest_empty_disc(cloud: Array) -> EmptyBall:
    """The largest empty Euclidean ball, for two or three dimensions.

    Its centre is a vertex of the Voronoi diagram of the points and their images (M. I. Shamos, D.
    Hoey, 1975).
    """
    from scipy.spatial import Voronoi, cKDTree

    d, cells = cloud.shape[1], math.ceil(len(cloud) ** (1 / cloud.shape[1]))
    tree = cKDTree(cloud)
    coarse, _ = tree.query(sukharev_grid(cells**d, d))
    reach = float(coarse.max()) + math.sqrt(d) / cells  # no empty ball is larger
    images = reflect_points(cloud)
    is_near = ((images >= -reach) & (images <= 1.0 + reach)).all(axis=1)
    vertices: Any = Voronoi(images[is_near]).vertices
    is_inside = ((vertices > -1e-9) & (vertices < 1.0 + 1e-9)).all(axis=1)
    centres = np.clip(vertices[is_inside], 0.0, 1.0)
    radii, _ = tree.query(centres)
    best = int(np.argmax(radii))
    return EmptyBall(centres[best], float(radii[best]))
