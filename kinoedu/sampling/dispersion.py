"""Dispersion: the radius of the largest ball without a point, its centre in the unit cube. H.
Niederreiter, "Random number generation and quasi-Monte Carlo methods", chapter 6; Bullo & Smith,
chapter 4; LaValle, section 5.2.3.

The walls are mirrors. A point's image in a wall is as far from the wall as the point, and farther
from all of the cube: images change no distance inside, and with them a hole that touches a wall is
a hole like any other.
"""

import math
from itertools import product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import Array, as_array
from .empty_square import largest_empty_square
from .grids import sukharev_grid


class EmptyBall(NamedTuple):
    """The ball of all places nearer to the centre, shape (d,), than the radius; in the sup norm it
    is a square.
    """

    centre: Array
    radius: float


def dispersion(points: ArrayLike, norm: float = 2) -> float:
    """How far a place of the unit cube can be from the nearest of the points (n, d); norm is 2, or
    math.inf for the sup norm.

    Good to 1e-12. On the line for both norms; Euclidean in the plane and in space, by a Voronoi
    diagram, O(n log n) in the plane; sup norm in the plane, O(n^(3/2)) for points spread evenly,
    O(n^2) at worst. Raises InvalidPoint, InvalidParameter.

    >>> dispersion(sukharev_grid(16), math.inf), round(dispersion(sukharev_grid(16)), 12)
    (0.125, 0.176776695297)
    """
    return largest_empty_ball(points, norm).radius


def largest_empty_ball(points: ArrayLike, norm: float = 2) -> EmptyBall:
    """A largest ball with its centre in the unit cube and no point inside: its radius is the
    dispersion.

    >>> largest_empty_ball([(0, 0)])
    EmptyBall(centre=array([1., 1.]), radius=1.4142135623730951)
    """
    cloud = points_of_cube(points)
    d = cloud.shape[1]
    if norm not in (2, math.inf) or isinstance(norm, bool):
        raise InvalidParameter(f"norm must be 2 or math.inf, got {norm!r}")
    if d == 1:
        return largest_gap(cloud)
    if norm == 2 and d <= 3:
        return largest_empty_disc(cloud)
    if norm == math.inf and d == 2:
        x, y, radius = largest_empty_square(mirrored(cloud))
        return EmptyBall(np.array([x, y]), float(radius))
    most = 3 if norm == 2 else 2
    raise InvalidParameter(
        f"dispersion in this norm is known up to {most} dimensions, got points of {d}"
    )


def points_of_cube(points: ArrayLike) -> Array:
    """One point or more of the closed unit cube, each once, shape (n, d)."""
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


def mirrored(cloud: Array) -> Array:
    """The points and their images in all walls, edges and corners of the cube, each once, shape (m,
    d).
    """
    images = [
        np.choose(np.array(sides)[None, :], [-cloud, cloud, 2.0 - cloud])
        for sides in product(range(3), repeat=cloud.shape[1])
    ]
    return np.unique(np.concatenate(images) + 0.0, axis=0)


def largest_gap(cloud: Array) -> EmptyBall:
    """On the line: half the longest way between neighbours, an end's neighbour being its image."""
    places = np.sort(cloud[:, 0])
    places = np.concatenate([-places[:1], places, 2.0 - places[-1:]])
    i = int(np.argmax(np.diff(places)))
    return EmptyBall(
        (places[i : i + 1] + places[i + 1 : i + 2]) / 2, float(places[i + 1] - places[i]) / 2
    )


def largest_empty_disc(cloud: Array) -> EmptyBall:
    """Its centre is a vertex of the Voronoi diagram of the points and their images (M. I. Shamos,
    D. Hoey, 1975).
    """
    from scipy.spatial import Voronoi, cKDTree

    d, cells = cloud.shape[1], math.ceil(len(cloud) ** (1 / cloud.shape[1]))
    tree = cKDTree(cloud)
    coarse, _ = tree.query(sukharev_grid(cells**d, d))
    reach = (
        float(coarse.max()) + math.sqrt(d) / cells
    )  # no hole is larger, so images farther away than that touch none
    images = mirrored(cloud)
    centres: Any = Voronoi(
        images[((images >= -reach) & (images <= 1.0 + reach)).all(axis=1)]
    ).vertices
    centres = np.clip(centres[((centres > -1e-9) & (centres < 1.0 + 1e-9)).all(axis=1)], 0.0, 1.0)
    radii, _ = tree.query(centres)
    best = int(np.argmax(radii))
    return EmptyBall(centres[best], float(radii[best]))
