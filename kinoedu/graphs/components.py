"""Connected components: one breadth-first search from each node that none before has reached. Bullo
& Smith, chapter 2.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm
from .bfs import breadth_first


@algorithm
def component_labels(graph: Any, size: int) -> NDArray[np.int64]:
    """A number for each node, shape (n,), the same for nodes of one component: counted from 0 by
    least node. O(n + m).

    The edges of the graph must lead both ways.
    """
    labels, count = np.full(size, -1, np.int64), 0
    cost, parent, queue = (
        np.full(size, np.inf),
        np.full(size, -1, np.int64),
        np.empty(size, np.int64),
    )
    for u in range(size):
        if labels[u] < 0:
            for v in breadth_first(graph, u, -1, cost, parent, queue):
                labels[v] = count
            count += 1
    return labels
