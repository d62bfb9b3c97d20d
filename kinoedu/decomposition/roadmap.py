"""The roadmap of a decomposition: a node in each cell and a node on each wall.

Bullo & Smith, chapter 2.
"""

import numpy as np

from ..problems import Roadmap
from ..worlds.polygon_world import PolygonWorldRecord
from .trapezoidation import Trapezoidation, trapezoidation
from .triangulation import Triangulation


def decomposition_roadmap(world: PolygonWorldRecord | Trapezoidation | Triangulation) -> Roadmap:
    """Join the centre of each cell to the midpoints of the walls that it shares with neighbours.

    For n cells, node i is the centre of cell i and node n + j the midpoint of wall j; wall j has
    the edges 2j and 2j + 1. Cells are convex, so an edge stays in its cell; walls have positive
    length, so it touches no obstacle, except where a wall is so short that its midpoint is rounded
    to one of its ends. From every point of a cell there is a free motion to its centre, so the
    roadmap is complete: where it has no path, there is none. O(n log n) for n vertices.

    Parameters
    ----------
    world : a PolygonWorld, for which the trapezoidation is computed; or its `trapezoidation` or
        `triangulation`.

    Returns
    -------
    Roadmap

    Raises
    ------
    InvalidWorld
        Where the world is not made of polygons.

    Examples
    --------
    >>> from kinoedu.worlds import PolygonWorld
    >>> obstacle = [(3, 2), (6, 2), (6, 4), (3, 4)]
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [obstacle])
    >>> roadmap = decomposition_roadmap(world)
    >>> len(roadmap.nodes), len(roadmap.edges)
    (8, 8)
    """
    cut = world if isinstance(world, Trapezoidation | Triangulation) else trapezoidation(world)
    left, right = cut.adjacency.T
    wall = len(cut.areas) + np.arange(len(cut.adjacency))
    nodes = np.concatenate([cut.centres, cut.walls.sum(axis=1) / 2.0])
    return Roadmap(nodes, np.column_stack([left, wall, wall, right]).reshape(-1, 2))
