"""What a stretch of the sweep line leaves behind: cells that end, cells that begin, and the walls
that they share.
"""

from typing import Any

from ..compiled import inlined
from .status import CELL, insert_above, remove

CELLS, CLOSED, WALLS, NODES = range(4)  # what Sweep.sizes counts


@inlined
def settle(sweep: Any, x: float, below: int, ending: int, beginning: int) -> bool:
    """Put so many new cells in the place of so many old ones, above node `below`; False where
    floors and ceilings take no turns.
    """
    sizes, nodes, ended, begun = sweep.sizes, sweep.nodes, sweep.ended, sweep.begun
    for j in range(2 * beginning):
        if sweep.floor[begun[j, 0]] != (j % 2 == 0):
            return False
    share_walls(sweep, x, ending, beginning)
    for i in range(ending):
        close_cell(sweep, x, i)
    for j in range(beginning):
        if j < ending:
            node = ended[j, 0]
        else:
            node = sizes[NODES]
            sizes[NODES] += 1
            insert_above(nodes, below, node)
        open_cell(sweep, x, node, j)
        below = node
    for i in range(beginning, ending):
        remove(nodes, ended[i, 0])
    return True


@inlined
def share_walls(sweep: Any, x: float, ending: int, beginning: int) -> None:
    """Note which cells that end share a wall of positive length with which that begin: both from
    bottom to top, side by side.
    """
    ended, begun, sizes = sweep.ended, sweep.begun, sweep.sizes
    i = j = 0
    while i < ending and j < beginning:
        low, high = max(ended[i, 1], begun[2 * j, 1]), min(ended[i, 2], begun[2 * j + 1, 1])
        if low < high:
            wall = sizes[WALLS]
            sweep.pairs[wall, 0], sweep.pairs[wall, 1] = (
                sweep.nodes[ended[i, 0], CELL],
                sizes[CELLS] + j,
            )
            sweep.walls[wall, 0], sweep.walls[wall, 1], sweep.walls[wall, 2] = (
                x,
                sweep.heights[low],
                sweep.heights[high],
            )
            sizes[WALLS] += 1
        if ended[i, 2] <= begun[2 * j + 1, 1]:
            i += 1
        else:
            j += 1


@inlined
def close_cell(sweep: Any, x: float, i: int) -> None:
    """Close the i-th cell that ends."""
    cell, sizes = sweep.nodes[sweep.ended[i, 0], CELL], sweep.sizes
    sweep.cells[cell, 1] = x
    sweep.cells[cell, 4], sweep.cells[cell, 5] = (
        sweep.heights[sweep.ended[i, 1]],
        sweep.heights[sweep.ended[i, 2]],
    )
    sweep.closed[sizes[CLOSED]] = cell
    sizes[CLOSED] += 1


@inlined
def open_cell(sweep: Any, x: float, node: int, j: int) -> None:
    """Open the j-th cell that begins, at a node of the status."""
    begun, cell = sweep.begun, sweep.sizes[CELLS]
    sweep.cells[cell, 0] = x
    sweep.cells[cell, 2], sweep.cells[cell, 3] = (
        sweep.heights[begun[2 * j, 1]],
        sweep.heights[begun[2 * j + 1, 1]],
    )
    for k in range(2):
        edge = begun[2 * j + k, 0]
        sweep.sides[cell, k] = edge
        sweep.place[edge] = node
    sweep.nodes[node, CELL] = cell
    sweep.sizes[CELLS] += 1
