"""Connected components of an undirected graph. Bullo & Smith, chapter 2.

One breadth-first search starts at each node that no earlier search has reached.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm
from .bfs import breadth_first


@algorithm
def label_components(graph: Any, size: int) -> NDArray[np.int64]:
    """The component of each node, (n,), numbered from 0 in the order of least nodes. O(n + m).

    Each edge of the graph must lead both ways.
    """
    labels, count = np.full(size, -1, np.int64), 0
    cost, parent = np.full(size, np.inf), np.full(size, -1, np.int64)
    queue = np.empty(size, np.int64)
    for u in range(size):
        if labels[u] < 0:
            for v in breadth_first(graph, u, -1, cost, parent, queue):
                labels[v] = count
            count += 1
    return labels
