"""Jump points: the few cells at which A* must stop on a grid whose moves cost their length.

Where no cell is blocked nearby, many paths of straight and diagonal moves are equally short: the
same moves in another order. Of these it is enough to examine one, that which makes its diagonal
moves first. It need turn into a straight direction only

- past the end of a wall: it goes straight, the cell behind beside it is blocked, and the cell
  beside it is free. So it may turn to that side, straight or diagonally;
- from a diagonal, where a straight direction leads to such a cell, or to the goal.

These cells are the jump points. An edge leads from a cell in one of the eight directions to the
first jump point ahead; all cells between are skipped. From a jump point that was reached in some
direction, only the edges above are worth following. The search itself is A* and stays as it is.

A table has 16 bits for each cell, so that a jump looks only at the cells that it passes. The table
of a map is computed from its bits, all cells at once, as one long integer.

D. Harabor, A. Grastien, "Online graph pruning for pathfinding on grid maps" (2011), "Improving
jump point search" (2014); here diagonal moves need two free cells beside them.
"""

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import callable_from_compiled
from ...graphs.flat import degree, edge, edges_after
from .directions import COLUMN_STEP, ROW_STEP, SQRT2, STRAIGHT

# the two sides to which a straight path may turn, and the two straight parts of a diagonal
SIDES = ((2, 3), (2, 3), (0, 1), (0, 1))
PARTS = ((0, 2), (1, 2), (0, 3), (1, 3))
ANY = 8  # at the start, which was reached in no direction

# The bits of a cell in the table: bit k < 4, that a jump point lies ahead in the straight direction
# k; bit 4 <= k < 8, that the diagonal move k is free; the bits from TURNS[k], that a path that
# arrives in the straight direction k may turn to the first or to the second of its sides.
TURNS = (8, 10, 12, 14, 16, 16, 16, 16, 16)  # beyond the table where there are none
# the bits of a cell at which a jump in direction k stops
STOPS = (0x300, 0xC00, 0x3000, 0xC000, *(1 << a | 1 << b for a, b in PARTS))


class JumpPoints(NamedTuple):
    """The graph of the jump points on a grid; its nodes are the cells.

    table : (nodes,), 16 bits of each cell; `goal` is a jump point too.
    worth : (36,), of each direction of arrival and of each pair of turns there, the directions that
        are worth following, as 8 bits.
    listed : (256, 9), 8 bits as a list: how many are set, and which.
    """

    table: NDArray[np.uint16]
    side: float
    columns: int
    goal: int
    worth: NDArray[np.int64]
    listed: NDArray[np.int64]

    @property
    def size(self) -> int:
        """How many nodes there are."""
        return len(self.table)


@degree.register(JumpPoints)
def count_directions(points: JumpPoints, u: int) -> int:
    """Eight directions."""
    return 8


@edge.register(JumpPoints)
def jump(points: JumpPoints, u: int, k: int) -> tuple[int, float]:
    """The first jump point in direction k and its distance; -1 where there is none.

    Ahead of a straight path its bit says that there is one; a diagonal path looks at each cell.
    """
    table, step = points.table, COLUMN_STEP[k] + ROW_STEP[k] * points.columns
    v, moves = u, 0
    while table[v] >> k & 1:
        v, moves = v + step, moves + 1
        if v == points.goal or table[v] & STOPS[k]:
            return v, moves * (points.side if k < STRAIGHT else SQRT2 * points.side)
    return -1, np.inf


@edges_after.register(JumpPoints)
def directions_worth_following(points: JumpPoints, before: int, u: int) -> NDArray[np.int64]:
    """The directions in which a path by `before` and u may be the only shortest one."""
    cell = points.table[u]
    k = arrival(points, before, u)
    ways = points.worth[4 * k + (cell >> TURNS[k] & 3)] & cell
    return points.listed[ways, 1 : 1 + points.listed[ways, 0]]


@callable_from_compiled
def arrival(points: JumpPoints, before: int, u: int) -> int:
    """The direction from `before` to u."""
    if before < 0:
        return ANY
    # the halves keep a product from rounding below a whole row; a division takes ten times as long
    per_row = 1.0 / points.columns
    up = int((u + 0.5) * per_row) - int((before + 0.5) * per_row)
    across = u - before - up * points.columns
    if up == 0:
        return 1 if across > 0 else 0
    if across == 0:
        return 3 if up > 0 else 2
    return 4 + (1 if across > 0 else 0) + (2 if up > 0 else 0)


def jump_points(free: NDArray[np.bool_], side: float, columns: int, goal: int) -> JumpPoints:
    """The jump points of a grid with a blocked border; (nodes,) says which cells are free.

    A map's table is kept for the next query.
    """
    bits = np.packbits(free, bitorder="little").tobytes()
    table = jump_table(bits, len(free), columns).copy()
    for k in range(STRAIGHT):  # the goal ends every jump towards it
        back = -COLUMN_STEP[k] - ROW_STEP[k] * columns
        between = int(np.argmin(free[goal::back]))
        table[goal::back][1:between] |= np.uint16(1 << k)
    return JumpPoints(table, side, columns, goal, worth_following(), lists_of_bits())


@lru_cache(maxsize=2)
def jump_table(bits: bytes, size: int, columns: int) -> NDArray[np.uint16]:
    """The table of a map, from its free cells as bits. O(size log(rows + columns)).

    All cells are looked at together: the map is one long integer, its cell u bit u. Moved by a
    step, it holds at u whether the cell a step before u is free.
    """
    free = int.from_bytes(bits, "little")
    steps = [COLUMN_STEP[k] + ROW_STEP[k] * columns for k in range(8)]
    halves = np.zeros((2, size), np.uint8)  # of the table: bytes are combined faster
    for k in range(STRAIGHT):
        turns = [
            free & moved(free, -steps[side]) & ~moved(free, steps[k] - steps[side])
            for side in SIDES[k]
        ]
        mark(halves, k, look_ahead(free, turns[0] | turns[1], steps[k]))
        for i in range(2):
            mark(halves, TURNS[k] + i, turns[i])
    for k in range(STRAIGHT, 8):
        a, b = (moved(free, -steps[part]) for part in PARTS[k - STRAIGHT])
        mark(halves, k, free & a & b & moved(free, -steps[k]))
    table = halves[0] + (halves[1].astype(np.uint16) << np.uint16(8))
    table.setflags(write=False)
    return table


def moved(bits: int, step: int) -> int:
    """All bits moved up by a step, or down."""
    return bits << step if step > 0 else bits >> -step


def look_ahead(free: int, ends: int, step: int) -> int:
    """The free cells with one of `ends` ahead, by steps over free cells only.

    Each round looks twice as far.
    """
    seen, through = free & moved(ends, -step), free
    while through:
        seen |= through & moved(seen, -step)
        through &= moved(through, -step)
        step *= 2
    return seen


def mark(halves: NDArray[np.uint8], bit: int, cells: int) -> None:
    """Set one of 16 bits at some cells."""
    half = halves[bit // 8]
    packed = np.frombuffer(cells.to_bytes(len(half) // 8 + 1, "little"), np.uint8)
    chosen = np.unpackbits(packed, count=len(half), bitorder="little")
    half |= np.multiply(chosen, 1 << bit % 8, out=chosen)


@lru_cache(maxsize=1)
def worth_following() -> NDArray[np.int64]:
    """The directions that are worth following, see `JumpPoints`.

    A straight path goes on, and may turn past the end of a wall, straight or diagonally; a diagonal
    path goes on, and may turn into its two straight parts.
    """
    worth = np.full((9, 4), 0xFF)
    for k in range(STRAIGHT):
        for turns in range(4):
            sides = [side for i, side in enumerate(SIDES[k]) if turns >> i & 1]
            diagonals = [STRAIGHT + PARTS.index(tuple(sorted((k, side)))) for side in sides]
            worth[k, turns] = sum(1 << way for way in (k, *sides, *diagonals))
    for k in range(STRAIGHT, 8):
        worth[k] = sum(1 << way for way in (k, *PARTS[k - STRAIGHT]))
    return worth.ravel()


@lru_cache(maxsize=1)
def lists_of_bits() -> NDArray[np.int64]:
    """The bits that are set in each byte, see `JumpPoints`."""
    listed = np.zeros((256, 9), np.int64)
    for byte in range(256):
        chosen = [k for k in range(8) if byte >> k & 1]
        listed[byte, : 1 + len(chosen)] = [len(chosen), *chosen]
    return listed


def fill_in(nodes: NDArray[np.int64], columns: int) -> NDArray[np.int64]:
    """All cells (m,) along a path of jumps (k,), straight or diagonal."""
    across, up = np.diff(nodes % columns), np.diff(nodes // columns)
    moves = np.maximum(np.abs(across), np.abs(up))
    steps = np.sign(across) + np.sign(up) * columns
    return np.concatenate([nodes[:1], nodes[0] + np.cumsum(np.repeat(steps, moves))])
