"""A search as it runs: what each node is at each step.

One step is one expansion. What a node is is kept as runs: rows node, state, parent, cost, the first
step, and the step after the last. They are in the order of their first steps.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import compiled
from ..geometry.checks import Array

Numbers = NDArray[np.int64]

UNSEEN, FRONTIER, EXPANDED, EXPANDING = range(4)
STATES = ("unseen", "frontier", "expanded", "expanding")  # their names


class Runs(NamedTuple):
    """The runs of a search, and its moments.

    rows : (r, 6), of which `counts[0]` are used.
    moments : (s, 3), rows expanded, waiting, node, of which `counts[1]` are used.
    counts : (3,), also of the nodes that wait.
    current : (n,), the row of each node.
    """

    rows: Array
    moments: Array
    counts: Numbers
    current: Numbers


@compiled
def begin_runs(n: int, start: int) -> Runs:
    """The runs before the first expansion."""
    rows = np.empty((4 * n, 6))
    for u in range(n):
        rows[u, 0], rows[u, 1], rows[u, 2] = u, UNSEEN, -1.0
        rows[u, 3], rows[u, 4], rows[u, 5] = np.inf, 0.0, 0.0
    rows[start, 1], rows[start, 3] = FRONTIER, 0.0
    return Runs(rows, np.empty((n, 3)), np.array([n, 0, 1]), np.arange(n))


@compiled
def with_room(runs: Runs) -> Runs:
    """The runs with room for one more moment, at which each node may change."""
    rows, moments, n = runs.rows, runs.moments, len(runs.current)
    if runs.counts[0] + n > len(rows):
        rows = np.concatenate((rows, np.empty_like(rows)))
    if runs.counts[1] == len(moments):
        moments = np.concatenate((moments, np.empty_like(moments)))
    return Runs(rows, moments, runs.counts, runs.current)


@compiled
def enter(runs: Runs, u: int, state: int, parent: int, cost: float) -> None:
    """Let node u have a state, a parent and a cost from the moment on that is to end next."""
    rows, at, step = runs.rows, runs.current[u], runs.counts[1] + 1
    if rows[at, 1] == state and rows[at, 2] == parent and rows[at, 3] == cost:
        return
    runs.counts[2] += int(state == FRONTIER) - int(rows[at, 1] == FRONTIER)
    if rows[at, 4] < step:
        rows[at, 5] = step
        at = runs.current[u] = runs.counts[0]
        runs.counts[0] += 1
        rows[at, 0], rows[at, 4] = u, step
    rows[at, 1], rows[at, 2], rows[at, 3] = state, parent, cost


@compiled
def end_moment(runs: Runs, node: int) -> None:
    """End the moment at which a node is expanded."""
    step = runs.counts[1]
    runs.moments[step, 0], runs.moments[step, 1] = step + 1, runs.counts[2]
    runs.moments[step, 2] = node
    runs.counts[1] += 1
