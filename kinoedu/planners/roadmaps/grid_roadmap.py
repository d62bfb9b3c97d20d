"""Fixed-resolution roadmaps: a grid of configurations, each joined to its neighbours.

Bullo & Smith, chapter 5; LaValle, section 5.4.2.
"""

from itertools import product

import numpy as np
from numpy.typing import NDArray

from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...problems import ProblemRecord, Roadmap
from ...problems.protocols import ProblemLike
from ...problems.recorder import unwrap_recorder
from ..exact.by_decomposition import check_edges
from ..problem_input import as_two_way_problem
from ..tuning import integer, positive
from .prm import free_among

MOST = 5_000_000  # pairs of neighbours at once


def grid_roadmap(
    problem: ProblemLike, *, spacing: float | None = None, neighbours: int | None = None
) -> Roadmap:
    """A roadmap on a grid: its free nodes, and an edge for each free motion between neighbours.

    It is complete for its resolution only: where it has no path, a finer grid may have one.

    Parameters
    ----------
    problem : a Problem in any space, or a Recorder of one. Where coordinates are angles, the grid
        wraps around.
    spacing : the side of the grid's cells, whose centres are the nodes. It is adjusted so that
        whole cells fill the space. By default a thirtieth of the largest extent of the space.
    neighbours : 2 d for straight moves only, in the plane 4, which is the default; or 3^d - 1 with
        diagonal moves, in the plane 8.

    Returns
    -------
    Roadmap, for `query`.

    Raises
    ------
    InvalidParameter
        Where `problem` is not a Problem, the robot only drives forward, a parameter is out of its
        range or there are too many nodes.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> box = [(1.2, 1.2), (1.8, 1.2), (1.8, 1.8), (1.2, 1.8)]
    >>> world = PolygonWorld([(0, 0), (4, 0), (4, 4), (0, 4)], [box])
    >>> roadmap = grid_roadmap(Problem(Point(), world, start=(1, 1), goal=(3, 3)), spacing=1)
    >>> len(roadmap.nodes), len(roadmap.edges)
    (15, 20)
    """
    problem = as_two_way_problem(problem, "a grid")
    inner = unwrap_recorder(problem)
    if not isinstance(inner, ProblemRecord):
        raise InvalidParameter("a grid needs a Problem, whose space it covers")
    lo, extent = inner.space.lo, inner.space.hi - inner.space.lo
    side = positive(extent.max() / 30.0 if spacing is None else spacing, "spacing")
    steps = moves(len(lo), neighbours)
    if np.prod(np.maximum(extent / side, 1.0)) * len(steps) > MOST:
        raise InvalidParameter(
            f"a spacing of {side:g} makes too many nodes for a space of extent {extent.tolist()}; "
            "choose a coarser one"
        )
    counts = np.maximum(np.rint(extent / side), 1).astype(np.int64)
    cells = np.indices(counts).reshape(len(lo), -1).T
    nodes = lo + (cells + 0.5) * (extent / counts)
    free = free_among(problem, nodes)
    wraps = getattr(inner.space, "wraps", np.zeros(len(lo), np.bool_))
    pairs = find_neighbours(cells, counts, steps, wraps)
    pairs = (np.cumsum(free) - 1)[pairs[free[pairs].all(axis=1)]]
    is_open, _ = check_edges(problem, nodes[free], pairs)
    return Roadmap(nodes[free], pairs[is_open])


def moves(d: int, neighbours: int | None) -> Array:
    """Half of the steps from a cell to its neighbours, (m, d): one of each two opposite steps."""
    count = 2 * d if neighbours is None else integer(neighbours, "neighbours", least=1)
    if count not in (2 * d, 3**d - 1):
        raise InvalidParameter(
            f"neighbours must be {2 * d} or {3**d - 1} in {d} dimensions, got {neighbours}"
        )
    if count == 2 * d:
        return np.eye(d, dtype=np.int64)
    return np.array([step for step in product((-1, 0, 1), repeat=d) if step > (0,) * d])


def find_neighbours(
    cells: Array, counts: NDArray[np.int64], steps: Array, wraps: NDArray[np.bool_]
) -> NDArray[np.int64]:
    """The pairs (m, 2) of cells one step apart, each once, also across a wrapped border."""
    pairs = []
    for step in steps:
        there = cells + step
        there = np.where(wraps, there % counts, there)
        inside = ((there >= 0) & (there < counts)).all(axis=1)
        pairs.append(
            np.column_stack([np.flatnonzero(inside), np.ravel_multi_index(there[inside].T, counts)])
        )
    both = np.sort(np.concatenate(pairs), axis=1)
    both = both[both[:, 0] != both[:, 1]]
    return np.unique(both, axis=0).astype(np.int64).reshape(-1, 2)
