"""Decomposition of a polygonal world into triangles.

Bullo & Smith, chapter 2; de Berg et al., chapters 3 and 9. The constrained Delaunay triangulation,
which avoids slender triangles as far as the edges allow, is shapely's.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..geometry.checks import Array, as_point
from ..geometry.convex import corner_tuples, directed_edges, in_convex, triangulate_ring
from ..support.constructors import with_type_names
from ..worlds.polygon_world import PolygonWorldRecord
from .free_space import as_polygons, free_polygons


@with_type_names
class Triangulation(NamedTuple):
    """The free space of a world, decomposed into triangles.

    triangles : (n, 3, 2), counter-clockwise.
    adjacency : (m, 2), pairs (i, j), i < j, of triangles with a common edge, in increasing order.
    walls : (m, 2, 2), the ends of those edges.
    world : the world that was decomposed.
    """

    triangles: Array
    adjacency: NDArray[np.int64]
    walls: Array
    world: PolygonWorldRecord

    @property
    def areas(self) -> Array:
        """The area of each cell, (n,)."""
        first = self.triangles[:, 0]
        (ax, ay), (bx, by) = (self.triangles[:, 1] - first).T, (self.triangles[:, 2] - first).T
        return (ax * by - ay * bx) / 2.0

    @property
    def centres(self) -> Array:
        """The centroid of each cell, (n, 2)."""
        return self.triangles.sum(axis=1) / 3.0

    @property
    def outlines(self) -> Array:
        """The corners of each cell, counter-clockwise, (n, 3, 2)."""
        return self.triangles

    def cells_at(self, q: ArrayLike) -> NDArray[np.int64]:
        """The cells that contain the point q: none, one, or those on both sides of an edge.

        Exact, O(n). Raises InvalidPoint.
        """
        x, y = as_point(q, "q").tolist()
        return np.flatnonzero(rings_holding(self.triangles, x, y))


@compiled
def rings_holding(rings: Array, x: float, y: float) -> NDArray[np.bool_]:
    """Whether each convex ring (n, k, 2) contains a point, (n,)."""
    holds = np.empty(len(rings), np.bool_)
    for i in range(len(rings)):
        holds[i] = in_convex(x, y, rings[i])
    return holds


def triangulation(world: PolygonWorldRecord) -> Triangulation:
    """Decompose the free space of a PolygonWorld into triangles.

    It is a constrained Delaunay triangulation. The corners are vertices of the world, and the
    points where outlines of obstacles cross.

    Returns
    -------
    Triangulation

    Raises
    ------
    InvalidWorld
        For round obstacles and for terrains.

    Examples
    --------
    >>> from kinoedu.worlds import PolygonWorld
    >>> obstacle = [(3, 2), (6, 2), (6, 4), (3, 4)]
    >>> cut = triangulation(PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [obstacle]))
    >>> len(cut.triangles), len(cut.adjacency), float(cut.areas.sum())
    (8, 8, 48.0)
    """
    cells: list[Array] = []
    polygons, unit = free_polygons(as_polygons(world))
    for part in polygons:
        cells += triangulate_ring(
            np.array(part.exterior.coords)[:-1],
            [np.array(hole.coords)[:-1] for hole in part.interiors],
        )
    # two triangles share an edge where one of them has it in the opposite direction
    left_of = {
        edge: i for i, cell in enumerate(cells) for edge in directed_edges(corner_tuples(cell))
    }
    shared = sorted(
        (i, j, a, b) for (a, b), i in left_of.items() if i < (j := left_of.get((b, a), -1))
    )
    pairs = np.array([(i, j) for i, j, _, _ in shared], np.int64).reshape(-1, 2)
    walls = np.array([(a, b) for _, _, a, b in shared]).reshape(-1, 2, 2)
    return Triangulation(unit * np.array(cells).reshape(-1, 3, 2), pairs, unit * walls, world)
