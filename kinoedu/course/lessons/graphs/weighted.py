"""Shapes and small graphs of the exercises with weights: Dijkstra's algorithm and A*.

Bullo & Smith, chapter 5; LaValle, section 2.2.
"""

from collections.abc import Iterator

import numpy as np

from ...shapes import Listed, Number
from ..shared.graph_slips import undirected, undirected_weights
from ..shared.random_graphs import Neighbours, Weights, random_graphs

WEIGHTS = Listed(Listed(Number()))
DETOUR = [(0, 1, 1), (1, 2, 1), (0, 2, 5)]
LATE_GAIN = [(0, 1, 1), (0, 2, 4), (1, 2, 2), (2, 3, 1)]

# costs in the last unit exceed numbers that programs take for infinity, such as sys.maxsize
UNITS = (1.0, 0.737, 1e20)


def graphs_in_units(rng: np.random.Generator) -> Iterator[tuple[str, Neighbours, Weights]]:
    """Yield the random graphs with weights that are small, not whole, or very large, in turn."""
    for i, (shape, neighbours, weights) in enumerate(random_graphs(rng)):
        unit = UNITS[i % len(UNITS)]
        yield shape, neighbours, [[round(w * unit, 6) for w in row] for row in weights]


def reverse_weighted(neighbours: Neighbours, weights: Weights) -> tuple[Neighbours, Weights]:
    """Return for each node the nodes from which an edge leads to it, and the edges' weights."""
    turned = [list[tuple[int, float]]() for _ in neighbours]
    for u, row in enumerate(neighbours):
        for v, w in zip(row, weights[u], strict=True):
            turned[v].append((u, w))
    return [[u for u, _ in row] for row in turned], [[w for _, w in row] for row in turned]


def make_undirected(neighbours: Neighbours, weights: Weights) -> tuple[Neighbours, Weights]:
    """Return the graph with every edge in both directions."""
    return undirected(neighbours), undirected_weights(neighbours, weights)
