"""The map that a robot with a range sensor draws: walls between the hits of neighbouring rays."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import compress
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...geometry.exact import orientation_sign
from ...worlds.range_sensor import Scan

FACING = 2.0  # times the distance of two rays' hits on a wall that faces them
GRAZING = 6.0  # the same, for hits that are in line with the one before or after them
IN_LINE = 0.995  # at least this cosine of the turn at a hit
STRAIGHT = 1.0 - 1e-12  # the same, on one straight wall
THICKNESS = 0.1  # of the distance of two hits

T = TypeVar("T", bound=np.generic)


class SeenMap(NamedTuple):
    """The walls seen so far, as thin triangles between hits, behind the wall as the sensor sees it.

    Where an earlier scan has seen a wall, later ones add none: `squares` has the size of each piece
    between neighbouring hits (a power of two), and its square of a grid of half that size.
    """

    walls: list[Array]
    squares: set[tuple[int, ...]]

    def add(self, measured: Scan) -> None:
        """Add the walls between hits of a scan; neighbouring pieces of a straight wall are one."""
        points, origin = measured.points, measured.origin
        apart, turn = measure_steps(points)
        middle = 0.5 * (points + next_of(points))
        size = np.frexp(apart)[1][:, None]
        rows = np.hstack([size, np.floor(middle / 2.0 ** (size - 1)).astype(int)])
        squares = list(map(tuple, rows.tolist()))
        is_new = are_joined(measured, apart, turn) & [
            square not in self.squares for square in squares
        ]
        self.squares.update(compress(squares, is_new))
        for first, last in find_runs(is_new, turn >= STRAIGHT):
            a, b = points[first], points[(last + 1) % len(points)]
            away = 0.5 * (a + b) - origin
            depth = THICKNESS * min(apart[first], apart[last]) / np.sqrt((away**2).sum())
            wall = np.array([b, a, 0.5 * (a + b) + depth * away])
            if orientation_sign(*wall.ravel().tolist()) > 0:
                self.walls.append(wall)

    def triangles(self) -> Array:
        """The walls seen so far, each counter-clockwise, shape (k, 3, 2)."""
        return np.array(self.walls).reshape(-1, 3, 2)


def next_of(ring: NDArray[T]) -> NDArray[T]:
    """For each row of a ring the next one; a fifth of the time of `np.roll`."""
    return np.concatenate([ring[1:], ring[:1]])


def before(ring: NDArray[T]) -> NDArray[T]:
    """For each row of a ring the one before."""
    return np.concatenate([ring[-1:], ring[:-1]])


def measure_steps(points: Array) -> tuple[Array, Array]:
    """The distance from each point of a ring (n, 2) to the next, and the cosine of the turn there.

    The cosine is 0 where a point and its neighbour are the same.
    """
    step = next_of(points) - points
    apart = np.sqrt((step**2).sum(axis=1))
    lengths = apart * before(apart)
    along = (step * before(step)).sum(axis=1)
    return apart, np.divide(along, lengths, out=np.zeros_like(along), where=lengths > 0.0)


def are_joined(measured: Scan, apart: Array, turn: Array) -> NDArray[np.bool_]:
    """Whether each hit of a scan and the next one are on one wall, shape (n,).

    They are if they are near each other, for their distance from the sensor. Hits on a wall that
    the rays only graze are farther apart, but in line with their neighbours. Else there may be a
    passage between them. `apart` and `turn` are those of `measure_steps`.
    """
    hit = measured.hit
    both = hit & next_of(hit)
    in_line = (turn >= IN_LINE) & both & before(hit)  # at each hit
    limit = np.where(in_line | next_of(in_line), GRAZING, FACING)
    farther = np.maximum(measured.distances, next_of(measured.distances))
    near = apart <= limit * farther * (2.0 * np.pi / len(measured.angles))
    return both & near & (apart > 0.0)


def find_runs(pieces: NDArray[np.bool_], straight: NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
    """The first and the last piece of each run in a ring.

    Piece i leads to piece i + 1; both are in one run if the ring is straight between them.

    Examples
    --------
    >>> list(find_runs(np.array([1, 1, 0, 1, 1]) > 0, np.array([1, 0, 1, 1, 1]) > 0))
    [(1, 1), (3, 0)]
    """
    goes_on = before(pieces) & straight & pieces  # from the piece before
    firsts = np.flatnonzero(pieces & ~goes_on)
    lasts = np.flatnonzero(pieces & ~next_of(goes_on))
    around = len(firsts) > 0 and lasts[0] < firsts[0]
    return zip(firsts.tolist(), np.roll(lasts, -1 if around else 0).tolist())
