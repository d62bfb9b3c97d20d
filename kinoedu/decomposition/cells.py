"""Steps 6 and 7 of the sweep: close the cells that end at the line, open those that begin there.

Before them, crossing.py has listed both sides of a stretch of the line, from bottom to top: in
`ended` the cells that end on its left, as rows NODE, FLOOR, CEILING (their node of the status, and
the levels of their floor and ceiling); in `begun` the edges that go on to its right, as rows EDGE,
LEVEL. Edges 2 j and 2 j + 1 of `begun` are the floor and the ceiling of the j-th cell that begins.
"""

from typing import Any

from ..compiled import inlined
from .status import CELL, insert_above, remove

NODE, FLOOR, CEILING = range(3)  # columns of Sweep.ended
EDGE, LEVEL = range(2)  # columns of Sweep.begun
CELLS, CLOSED, WALLS, NODES = range(4)  # indices of Sweep.sizes: how many of each there are


@inlined
def replace_cells(sweep: Any, x: float, below: int, ending: int, beginning: int) -> bool:
    """Replace the cells that end at x by those that begin, above node `below` of the status.

    Returns whether this is possible: whether floors and ceilings alternate among the new edges.
    """
    sizes, ended, begun = sweep.sizes, sweep.ended, sweep.begun
    for k in range(2 * beginning):
        if sweep.floor[begun[k, EDGE]] != (k % 2 == 0):
            return False
    share_walls(sweep, x, ending, beginning)
    for i in range(ending):
        close_cell(sweep, x, i)  # 6: add the cells that end here to T
    for j in range(beginning):  # 7: update the status; new cells take the nodes of old ones
        if j < ending:
            node = ended[j, NODE]
        else:
            node = sizes[NODES]
            sizes[NODES] += 1
            insert_above(sweep.nodes, below, node)
        open_cell(sweep, x, node, j)
        below = node
    for i in range(beginning, ending):
        remove(sweep.nodes, ended[i, NODE])
    return True


@inlined
def share_walls(sweep: Any, x: float, ending: int, beginning: int) -> None:
    """Store the walls of positive length between cells that end and cells that begin.

    Both lists go from bottom to top, so they are merged in one pass.
    """
    ended, begun, sizes, heights = sweep.ended, sweep.begun, sweep.sizes, sweep.heights
    i = j = 0
    while i < ending and j < beginning:
        ceiling, other_ceiling = ended[i, CEILING], begun[2 * j + 1, LEVEL]
        low, high = max(ended[i, FLOOR], begun[2 * j, LEVEL]), min(ceiling, other_ceiling)
        if low < high:
            k = sizes[WALLS]
            sweep.pairs[k, 0] = sweep.nodes[ended[i, NODE], CELL]
            sweep.pairs[k, 1] = sizes[CELLS] + j
            sweep.walls[k, 0] = x
            sweep.walls[k, 1], sweep.walls[k, 2] = heights[low], heights[high]
            sizes[WALLS] += 1
        if ceiling <= other_ceiling:
            i += 1
        else:
            j += 1


@inlined
def close_cell(sweep: Any, x: float, i: int) -> None:
    """Close the i-th cell that ends: store its right wall."""
    ended, sizes, heights = sweep.ended, sweep.sizes, sweep.heights
    cell = sweep.nodes[ended[i, NODE], CELL]
    sweep.cells[cell, 1] = x
    sweep.cells[cell, 4] = heights[ended[i, FLOOR]]
    sweep.cells[cell, 5] = heights[ended[i, CEILING]]
    sweep.closed[sizes[CLOSED]] = cell
    sizes[CLOSED] += 1


@inlined
def open_cell(sweep: Any, x: float, node: int, j: int) -> None:
    """Open the j-th cell that begins, at a node of the status: store its left wall and edges."""
    begun, cell, heights = sweep.begun, sweep.sizes[CELLS], sweep.heights
    sweep.cells[cell, 0] = x
    sweep.cells[cell, 2] = heights[begun[2 * j, LEVEL]]
    sweep.cells[cell, 3] = heights[begun[2 * j + 1, LEVEL]]
    for k in range(2):
        edge = begun[2 * j + k, EDGE]
        sweep.sides[cell, k] = edge
        sweep.place[edge] = node
    sweep.nodes[node, CELL] = cell
    sweep.sizes[CELLS] += 1
