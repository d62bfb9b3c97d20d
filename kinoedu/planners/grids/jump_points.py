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
of a map is computed from its bits, 64 cells at once.

D. Harabor, A. Grastien, "Online graph pruning for pathfinding on grid maps" (2011), "Improving
jump point search" (2014); here diagonal moves need two free cells beside them.
"""

from functools import lru_cache, reduce
from operator import or_
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm, callable_from_compiled, compiled
from ...graphs.flat import degree, edge, edges_after
from .directions import COLUMN_STEP, ROW_STEP, SQRT2, STRAIGHT, moves_between

# the two sides to which a straight path may turn, and the two straight parts of a diagonal
SIDES = ((2, 3), (2, 3), (0, 1), (0, 1))
PARTS = ((0, 2), (1, 2), (0, 3), (1, 3))
ANY = 8  # at the start, which was reached in no direction

Words = NDArray[np.uint64]
WORD = 64  # bits
BYTES = np.arange(256, dtype=np.uint8).reshape(-1, 1)
SPREAD = np.unpackbits(BYTES, axis=1, bitorder="little").view(np.uint64).ravel()  # bits as bytes

# The bits of a cell in the table: bit k < 4, that a jump point lies ahead in the straight direction
# k; bit 4 <= k < 8, that the diagonal move k is free; the bits from TURNS[k], that a path that
# arrives in the straight direction k may turn to the first or to the second of its sides.
TURNS = (8, 10, 12, 14, 16, 16, 16, 16, 16)  # beyond the table where there are none
# the bits of a cell at which a jump in direction k stops
STOPS = (0x300, 0xC00, 0x3000, 0xC000, *(1 << a | 1 << b for a, b in PARTS))
ALL_STOP = reduce(or_, STOPS)  # the bits of a cell at which a jump in any direction stops


class JumpPoints(NamedTuple):
    """The graph of the jump points on a grid; its nodes are the cells.

    table : (nodes,), 16 bits of each cell; the goal is a jump point too.
    worth : (36,), of each direction of arrival and of each pair of turns there, the directions that
        are worth following, as 8 bits.
    listed : (256, 9), 8 bits as a list: how many are set, and which.
    """

    table: NDArray[np.uint16]
    side: float
    columns: int
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
    v, moves, stops = u, 0, STOPS[k]
    while table[v] >> k & 1:
        v, moves = v + step, moves + 1
        if table[v] & stops:
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
    across, up = moves_between(before, u, points.columns)
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
    return points_towards(goal, jump_table(bits, len(free), columns).copy(), free, side, columns)


@callable_from_compiled
def points_towards(
    goal: int, table: NDArray[np.uint16], free: NDArray[np.bool_], side: float, columns: int
) -> JumpPoints:
    """The jump points of a map's table, in which the goal is made to end every jump towards it."""
    for k in range(STRAIGHT):
        back = -COLUMN_STEP[k] - ROW_STEP[k] * columns
        u = goal + back
        while free[goal] and free[u]:
            table[u] |= np.uint16(1 << k)
            u += back
    table[goal] |= np.uint16(ALL_STOP)
    return JumpPoints(table, side, columns, WORTH.copy(), LISTED.copy())


@lru_cache(maxsize=2)
def jump_table(bits: bytes, size: int, columns: int) -> NDArray[np.uint16]:
    """The table of a map, from its free cells as bits, lowest first; it is kept."""
    words = np.zeros(-(-size // WORD), np.uint64)
    words.view(np.uint8)[: len(bits)] = np.frombuffer(bits, np.uint8)
    table = fill_table(words, size, columns)
    table.setflags(write=False)
    return table


@algorithm
def fill_table(free: Words, size: int, columns: int) -> NDArray[np.uint16]:
    """The table of a map with a blocked border, from its free cells as bits, lowest first. O(size).

    All cells are looked at together: cell u is bit u of a long row of words. Moved by a step, it
    holds at u whether the cell a step from u is free.
    """
    planes = np.zeros((16, len(free)), np.uint64)  # the bits of the table, each of all cells
    for k in range(STRAIGHT):
        step, ends = COLUMN_STEP[k] + ROW_STEP[k] * columns, np.zeros_like(free)
        for i in range(2):
            aside = COLUMN_STEP[SIDES[k][i]] + ROW_STEP[SIDES[k][i]] * columns
            turns = planes[TURNS[k] + i]
            for w in range(len(free)):
                beside, behind = bits_from(free, w, aside), bits_from(free, w, aside - step)
                turns[w] = free[w] & beside & ~behind
                ends[w] |= turns[w]
        look_ahead(free, ends, step, planes[k])
    for k in range(STRAIGHT, 8):
        a, b, ahead = COLUMN_STEP[k], ROW_STEP[k] * columns, planes[k]
        for w in range(len(free)):
            sides = bits_from(free, w, a) & bits_from(free, w, b)
            ahead[w] = free[w] & sides & bits_from(free, w, a + b)
    return cells_of(planes, size)


@compiled
def pack_bits(cells: NDArray[np.bool_]) -> Words:
    """Cells as bits of words, the first as the lowest, for code without numpy's packbits."""
    words = np.zeros(-(-len(cells) // WORD), np.uint64)
    for u in range(len(cells)):
        words[u // WORD] |= np.uint64(cells[u]) << np.uint64(u % WORD)
    return words


@compiled
def bits_from(words: Words, w: int, step: int) -> np.uint64:
    """What the bits of word w find a step further on; nothing beyond the ends."""
    at, part = w + (step >> 6), np.uint64(step & (WORD - 1))
    low = words[at] if 0 <= at < len(words) else np.uint64(0)
    if part == 0:
        return low
    high = words[at + 1] if 0 <= at + 1 < len(words) else np.uint64(0)
    return low >> part | high << (np.uint64(WORD) - part)


@compiled
def look_ahead(free: Words, ends: Words, step: int, seen: Words) -> None:
    """Fill in the free cells with one of `ends` ahead, by steps over free cells only.

    Words are visited from ahead backwards. Within a word each round looks twice as far.
    """
    for i in range(len(free)):
        w = len(free) - 1 - i if step > 0 else i
        bits = free[w] & (bits_from(ends, w, step) | bits_from(seen, w, step))
        through, far = free[w], abs(step)
        while far < WORD:
            ahead = np.uint64(far)
            bits |= through & (bits >> ahead if step > 0 else bits << ahead)
            through &= through >> ahead if step > 0 else through << ahead
            far *= 2
        seen[w] = bits


@compiled
def cells_of(planes: Words, size: int) -> NDArray[np.uint16]:
    """The 16 bits of each cell, (size,), from the planes of each bit, (16, words)."""
    halves = np.zeros((2, 8 * planes.shape[1]), np.uint64)  # a byte for each cell
    for bit in range(16):
        half, plane = halves[bit // 8], planes[bit].view(np.uint8)
        for i in range(len(half)):
            half[i] |= SPREAD[plane[i]] << np.uint64(bit % 8)
    cells = halves[1].view(np.uint8)[:size].astype(np.uint16)
    cells <<= np.uint16(8)  # in place: new memory costs more than the work on it
    cells |= halves[0].view(np.uint8)[:size]
    return cells


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


def lists_of_bits() -> NDArray[np.int64]:
    """The bits that are set in each byte, see `JumpPoints`."""
    listed = np.zeros((256, 9), np.int64)
    for byte in range(256):
        chosen = [k for k in range(8) if byte >> k & 1]
        listed[byte, : 1 + len(chosen)] = [len(chosen), *chosen]
    return listed


WORTH, LISTED = worth_following(), lists_of_bits()


@callable_from_compiled
def fill_in(nodes: NDArray[np.int64], columns: int) -> NDArray[np.int64]:
    """All cells (m,) along a path of jumps (k,), straight or diagonal."""
    across, up = np.diff(nodes % columns), np.diff(nodes // columns)
    moves = np.maximum(np.abs(across), np.abs(up))
    steps = np.sign(across) + np.sign(up) * columns
    return np.concatenate((nodes[:1], nodes[0] + np.cumsum(np.repeat(steps, moves))))
