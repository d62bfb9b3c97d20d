"""Shapes and small graphs of the exercises with weights: Dijkstra's algorithm and A*.

Bullo & Smith, chapter 2; LaValle, section 2.2.
"""

from ...shapes import Listed, Number
from ..shared.graph_slips import undirected, undirected_weights
from ..shared.random_graphs import Neighbours, Weights

WEIGHTS = Listed(Listed(Number()))
DETOUR = [(0, 1, 1), (1, 2, 1), (0, 2, 5)]
LATE_GAIN = [(0, 1, 1), (0, 2, 4), (1, 2, 2), (2, 3, 1)]


def make_undirected(neighbours: Neighbours, weights: Weights) -> tuple[Neighbours, Weights]:
    """Return the graph with every edge in both directions."""
    return undirected(neighbours), undirected_weights(neighbours, weights)
