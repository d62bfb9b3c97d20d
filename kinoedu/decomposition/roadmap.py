"""The roadmap that a decomposition makes: a node in each cell, a node on each wall. Bullo & Smith,
chapter 2.
"""

from typing import Any

import numpy as np

from ..problems import Roadmap
from .trapezoidation import Trapezoidation, trapezoidation
from .triangulation import Triangulation


def decomposition_roadmap(world: Any) -> Roadmap:
    """Join the centre of each cell to the middle of each wall that it shares with a neighbour.

    world : a PolygonWorld, cut into trapezoids here; or its `trapezoidation` or `triangulation`.

    For n cells, node i is the centre of cell i, node n + j the middle of wall j; wall j gives edges
    2j and 2j + 1. Cells are convex, so an edge stays in its cell, and walls have length, so it
    touches no obstacle. From every point of a cell there is a free motion to its centre, so the
    roadmap misses no connection: where it has no path, there is none. O(n log n) for n vertices.
    Raises InvalidWorld.

    >>> from kinoedu.worlds import PolygonWorld
    >>> roadmap = decomposition_roadmap(PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 2), (6, 2), (6, 4), (3, 4)]]))
    >>> len(roadmap.nodes), len(roadmap.edges)
    (8, 8)
    """
    cut = world if isinstance(world, Trapezoidation | Triangulation) else trapezoidation(world)
    centres, n = cut.centres, len(cut.areas)
    middle = n + np.arange(len(cut.adjacency))
    edges = np.column_stack([cut.adjacency[:, 0], middle, middle, cut.adjacency[:, 1]]).reshape(
        -1, 2
    )
    return Roadmap(np.concatenate([centres, cut.walls.sum(axis=1) / 2.0]), edges)
