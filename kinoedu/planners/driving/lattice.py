"""Lattices of a car: cells of poses, and the short drives from one to the next."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from ...compiled import compiled
from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...problems import ProblemRecord
from ..tuning import positive

LEVELS = 5  # lattices, if they are refined: moves from 3/8 of the wheelbase to 3/128
MOST_CELLS = 1e18  # that can be numbered


class Lattice(NamedTuple):
    """The cells of poses and the moves between them.

    Cells are squares of side `side` from (x, y), `rows` rows of `columns`, each divided into
    `headings` headings. moves (m, 2) are controls (v, phi); each is held for a drive of length
    `step_size`.
    """

    x: float
    y: float
    side: float
    rows: int
    columns: int
    headings: int
    moves: Array
    step_size: float


@compiled
def cell_of(lattice: Lattice, q: Array) -> int:
    """The number of the cell that a free pose lies in."""
    i = math.floor((q[0] - lattice.x) / lattice.side)
    j = math.floor((q[1] - lattice.y) / lattice.side)
    heading = math.floor((q[2] + math.pi) / (2.0 * math.pi) * lattice.headings) % lattice.headings
    return int((j * lattice.columns + i) * lattice.headings + heading)


def lattices_for(
    problem: ProblemRecord, spacing: float | None, step_size: float | None, angles: int
) -> list[Lattice]:
    """The lattice of a given spacing or step size; by default ever finer ones.

    A drive of length d forward to the left and one backward to the right move a car with the
    turning radius R sideways by about d^2 / R. A larger cell hides that, so where moves are halved,
    cells are quartered.

    Raises
    ------
    InvalidParameter
        Where a size is not positive, or there are too many cells to number them.
    """
    side = 0.25 * problem.robot.wheelbase if spacing is None else positive(spacing, "spacing")
    length = 1.5 * side if step_size is None else positive(step_size, "step_size")
    levels = LEVELS if spacing is None and step_size is None else 1
    lattices = [
        lattice_for(problem, side / 4.0**level, length / 2.0**level, angles)
        for level in range(levels)
    ]
    countable = [one for one in lattices if one.rows * one.columns * one.headings <= MOST_CELLS]
    if not countable:
        raise InvalidParameter(
            f"a spacing of {side:g} and a step size of {length:g} make too many cells to be "
            "counted; choose larger ones"
        )
    return countable


def lattice_for(problem: ProblemRecord, side: float, step_size: float, angles: int) -> Lattice:
    """The cells of side `side` that cover a world, and the car's moves."""
    car, (lo, hi) = problem.robot, (problem.space.lo, problem.space.hi)
    fastest = float(car.speeds.max())
    gears = [fastest, float(car.speeds.min())] if car.both_ways else [fastest]
    steering = np.linspace(-car.max_steering, car.max_steering, angles)
    moves = [(v, phi) for v in gears for phi in steering]
    with np.errstate(over="ignore"):  # what is infinite is refused
        cells = (hi - lo)[:2] / side + 1.0
    sizes = np.append(cells, max(1.0, 2.0 * math.pi * car.radius / step_size))
    columns, rows, headings = (math.ceil(size) for size in np.minimum(sizes, 2.0 * MOST_CELLS))
    x, y = float(lo[0]), float(lo[1])
    return Lattice(x, y, side, rows, columns, headings, np.array(moves), step_size)
