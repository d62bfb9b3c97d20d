"""Answers of programs with a known misconception about cells and their neighbours."""

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ..shared.random_worlds import edges_round
from .sweep_line import crossed_edges, heights

Pairs = NDArray[np.int64]


def slabs(boundary: Array, obstacles: list[Array]) -> Array:
    """Cells cut at every event, also where there is no wall."""
    edges = edges_round(boundary, obstacles)
    x = np.sort(edges[:, 0])
    rows = []
    for left, right in zip(x, x[1:]):
        status = edges[crossed_edges((left + right) / 2, edges)]
        low, high = heights(left, status), heights(right, status)
        rows += [
            (left, right, low[k], low[k + 1], high[k], high[k + 1])
            for k in range(0, len(status), 2)
        ]
    return np.array(rows)


def hollow(boundary: Array, obstacles: list[Array]) -> Array:
    """Trapezoids, also inside obstacles and bays."""
    edges = edges_round(boundary, obstacles)
    x = np.sort(edges[:, 0])
    rows, before = [], dict[tuple[int, int], float]()
    for i, left in enumerate(x):
        status = crossed_edges((left + x[i + 1]) / 2, edges).tolist() if i + 1 < len(x) else []
        now = {pair: before.get(pair, left) for pair in zip(status, status[1:])}
        for pair, begun in before.items():
            if pair not in now:
                sides = edges[list(pair)]
                rows.append((begun, left, *heights(begun, sides), *heights(left, sides)))
        before = now
    return np.array(rows)


def without_last(cells: Array) -> Array:
    """Cells except those that end at the last event."""
    return cells[cells[:, 1] < cells[:, 1].max()]


def without_triangles(cells: Array) -> Array:
    """Cells with four corners."""
    return cells[~np.isclose(cells[:, 2], cells[:, 3]) & ~np.isclose(cells[:, 4], cells[:, 5])]


def common_part(walls: Array, cells: Array) -> tuple[Array, Array]:
    """Lower and upper end of what walls (n, 2) have in common with the left walls of cells."""
    return np.maximum(walls[:, :1], cells[:, 2]), np.minimum(walls[:, 1:], cells[:, 3])


def adjoining(cells: Array) -> NDArray[np.bool_]:
    """Whether a cell (the row) ends at the x where another (the column) begins."""
    return np.equal(cells[:, None, 1], cells[:, 0])


def sorted_pairs(pairs: Pairs) -> Pairs:
    """Each pair once, with the smaller index first."""
    return np.unique(np.sort(pairs, axis=1), axis=0)


def left_cell_first(cells: Array) -> Pairs:
    """Pairs with the left cell first, whatever its index."""
    low, high = common_part(cells[:, 4:], cells)
    return np.argwhere(adjoining(cells) & (low < high))


def touching(cells: Array) -> Pairs:
    """Pairs of cells that share a wall: the right answer."""
    return sorted_pairs(left_cell_first(cells))


def touching_in_a_point(cells: Array) -> Pairs:
    """Pairs of cells that share a wall or a point of it."""
    low, high = common_part(cells[:, 4:], cells)
    return sorted_pairs(np.argwhere(adjoining(cells) & (low <= high)))


def left_walls(cells: Array) -> Pairs:
    """Pairs computed with the left wall of both cells."""
    low, high = common_part(cells[:, 2:4], cells)
    return sorted_pairs(np.argwhere(adjoining(cells) & (low < high)))


def right_walls(cells: Array) -> Pairs:
    """Pairs computed with the right wall of both cells."""
    low, high = (
        np.maximum(cells[:, None, 4], cells[:, 4]),
        np.minimum(cells[:, None, 5], cells[:, 5]),
    )
    return sorted_pairs(np.argwhere(adjoining(cells) & (low < high)))


def only_later(cells: Array) -> Pairs:
    """Pairs in which the left cell has the smaller index."""
    pairs = left_cell_first(cells)
    return pairs[pairs[:, 0] < pairs[:, 1]]


def nearly(cells: Array) -> Pairs:
    """Pairs whose walls are close to each other, whatever lies between."""
    low, high = common_part(cells[:, 4:], cells)
    pairs = np.argwhere(np.isclose(cells[:, None, 1], cells[:, 0]) & (low < high))
    return sorted_pairs(pairs[pairs[:, 0] != pairs[:, 1]])


def equal_walls(cells: Array) -> Pairs:
    """Pairs with equal walls."""
    equal = (
        adjoining(cells) & (cells[:, None, 4] == cells[:, 2]) & (cells[:, None, 5] == cells[:, 3])
    )
    return np.sort(np.argwhere(equal), axis=1)


def nested_walls(cells: Array) -> Pairs:
    """Pairs in which one wall contains the other."""
    low, high = cells[:, None, 4] - cells[:, 2], cells[:, None, 5] - cells[:, 3]
    pairs = left_cell_first(cells)
    return np.sort(pairs[low[*pairs.T] * high[*pairs.T] <= 0], axis=1)
