"""Reeds and Shepp's curves: the shortest curves of a car that drives forward and backward.

Nine base words start with an arc to the left, driven forward. All other words are obtained from
them by reflection, by driving in the opposite direction, and by reversing the order of the pieces
(for words that are not symmetric). Sources: J. A. Reeds and L. A. Shepp, "Optimal paths for a car
that goes both forwards and backwards" (1990), section 8; LaValle, section 15.3.2.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..geometry.checks import Array
from ..spaces.angles import wrap_angle
from .curve import Curve, as_pose, as_radius, as_relative_pose
from .tangents import left_centre, lrl, lsl, lsr, right_centre

QUARTER = 0.5 * math.pi
TURNS = np.array(
    [
        (1, 0, 1, 0, 0),  # L S L
        (1, 0, -1, 0, 0),  # L S R
        (1, -1, 1, 0, 0),  # L | R | L and L | R L
        (1, -1, 1, -1, 0),  # L R | L R
        (1, -1, 1, -1, 0),  # L | R L | R
        (1, -1, 0, 1, 0),  # L | R quarter, S L
        (1, -1, 0, -1, 0),  # L | R quarter, S R
        (1, -1, 0, 1, -1),  # L | R quarter, S, L quarter | R
    ]
)
REVERSIBLE = np.array([False, False, True, False, False, True, True, False])
ROUNDING = 1e-12  # a piece shorter than this has length zero
# An angle is known less well where poses are near. A piece this short may be driven the other way:
# the curve reaches its end all the same, and counts in full.
NEAR_ZERO = 1e-6
TIE = 1e-10  # a later word must be shorter by this many radii


def reeds_shepp_path(q0: ArrayLike, q1: ArrayLike, radius: float) -> Curve:
    """The shortest curve from q0 to q1, forward and backward, that turns no tighter than `radius`.

    Pieces of negative length are driven backwards. The length is accurate to 1e-9 radii.

    Parameters
    ----------
    q0, q1 : (3,) poses (x, y, theta).

    Returns
    -------
    Curve

    Raises
    ------
    InvalidPoint
        Where a pose is not three finite numbers.
    InvalidParameter
        Where the radius is not positive, or the poses are more than 1e150 radii apart.

    Examples
    --------
    >>> curve = reeds_shepp_path((0, 0, 0), (-3, 0, 0), 1.0)
    >>> curve.word, curve.length, curve.lengths
    ('S', 3.0, array([-3.]))
    """
    start, end, rho = as_pose(q0, "q0"), as_pose(q1, "q1"), as_radius(radius)
    turns, lengths = shortest(*as_relative_pose(start, end, rho))
    is_driven = np.abs(lengths) > ROUNDING
    return Curve(start, rho, turns[is_driven], rho * lengths[is_driven])


@compiled
def shortest(x: float, y: float, phi: float) -> tuple[NDArray[np.int64], Array]:
    """Turns and signed lengths of the shortest word from (0, 0, 0) to (x, y, phi) for radius 1.

    There are five pieces; those that are not needed have length 0.
    """
    turns, lengths, best = np.zeros(5, np.int64), np.zeros(5), np.inf
    back_x, back_y = x * math.cos(phi) + y * math.sin(phi), x * math.sin(phi) - y * math.cos(phi)
    pieces = np.empty(5)
    for word in range(len(TURNS)):
        for reverse in range(1 + REVERSIBLE[word]):
            from_x, from_y = (back_x, back_y) if reverse else (x, y)
            for gear in (1, -1):
                for mirror in (1, -1):
                    found = solve_word(
                        word, gear * from_x, mirror * from_y, gear * mirror * phi, pieces
                    )
                    total = 0.0
                    for i in range(5):
                        total += abs(pieces[i])
                    if found and total < best - TIE:
                        best = total
                        write_pieces(word, gear, mirror, reverse, pieces, turns, lengths)
    return turns, lengths


@compiled
def write_pieces(
    word: int,
    gear: int,
    mirror: int,
    reverse: int,
    pieces: Array,
    turns: NDArray[np.int64],
    lengths: Array,
) -> None:
    """Write a word's turns and signed lengths in the order in which they are driven."""
    for i in range(5):
        j = 4 - i if reverse else i
        turns[i], lengths[i] = mirror * TURNS[word, j], gear * pieces[j]


@compiled
def solve_word(word: int, x: float, y: float, phi: float, pieces: Array) -> bool:
    """Write the signed lengths of one base word into `pieces` (5,); returns whether it exists."""
    pieces[:] = 0.0
    if word == 0:
        found, t, u, v = lsl(x, y, phi)
        return found and store_pieces(pieces, t, u, v, 1, 1)
    if word == 1:
        found, t, u, v = lsr(x, y, phi)
        return found and store_pieces(pieces, t, u, v, 1, 1)
    if word == 2:
        found, t, u, v = lrl(x, y, phi)
        return found and store_pieces(pieces, t, u, v, -1, 0)
    if word <= 4:
        return solve_four_arcs(word, x, y, phi, pieces)
    return solve_with_quarter(word, x, y, phi, pieces)


@compiled
def store_pieces(pieces: Array, t: float, u: float, v: float, u_sign: int, v_sign: int) -> bool:
    """Write three pieces; returns whether their signs are right: the first not negative.

    A sign of 0 allows both directions, and so does a piece of nearly no length.
    """
    t, v = without_rounding(wrap_angle(t)), without_rounding(wrap_angle(v))
    pieces[0], pieces[1], pieces[2] = t, u, v
    return t >= -NEAR_ZERO and u_sign * u >= -NEAR_ZERO and v_sign * v >= -NEAR_ZERO


@compiled
def without_rounding(angle: float) -> float:
    """The angle, but 0 where it is 0 up to rounding, and pi in place of -pi."""
    if abs(angle) < ROUNDING:
        return 0.0
    return -angle if angle < ROUNDING - math.pi else angle


@compiled
def solve_four_arcs(word: int, x: float, y: float, phi: float, pieces: Array) -> bool:
    """The words L R | L R and L | R L | R, formulas 8.7 and 8.8.

    The two middle arcs have equal lengths.
    """
    ex, ey = x + math.sin(phi), y - 1.0 - math.cos(phi)
    squared = ex * ex + ey * ey
    cosine = 0.25 * (2.0 + math.sqrt(squared)) if word == 3 else (20.0 - squared) / 16.0
    if cosine > 1.0 + ROUNDING or cosine < 0.0:
        return False
    size = math.acos(min(cosine, 1.0))
    second, third = (size, -size) if word == 3 else (-size, -size)
    turn = second - third
    a, b = math.sin(second) - math.sin(turn), math.cos(second) - math.cos(turn) - 1.0
    first = math.atan2(ey * a - ex * b, ex * a + ey * b)
    if 2.0 * (math.cos(turn) - math.cos(third) - math.cos(second)) + 3.0 < 0.0:
        first += math.pi
    last = first - second + third - phi
    found = store_pieces(pieces, first, second, last, 0, -1 if word == 3 else 1)
    pieces[2], pieces[3] = third, pieces[2]
    return found


@compiled
def solve_with_quarter(word: int, x: float, y: float, phi: float, pieces: Array) -> bool:
    """The words with a quarter arc, formulas 8.9 to 8.11.

    A straight piece is driven backwards, with a quarter arc before it or on both sides.
    """
    if word == 5:
        apart, direction = left_centre(x, y, phi)
        side = math.sqrt(max(apart * apart - 4.0, 0.0))
        first, straight = direction + math.atan2(side, -2.0), 2.0 - side
        last, last_sign = phi - QUARTER - first, -1
    elif word == 6:
        apart, direction = right_centre(x, y, phi)
        first, straight = direction + QUARTER, 2.0 - apart
        last, last_sign = first + QUARTER - phi, -1
    else:
        apart, _ = right_centre(x, y, phi)
        ex, ey = x + math.sin(phi), y - 1.0 - math.cos(phi)
        straight = 4.0 - math.sqrt(max(apart * apart - 4.0, 0.0))
        first = math.atan2((4.0 - straight) * ex - 2.0 * ey, -2.0 * ex + (straight - 4.0) * ey)
        last, last_sign = first - phi, 1
    found = apart >= 2.0 - ROUNDING and store_pieces(pieces, first, straight, last, -1, last_sign)
    last = pieces[2]
    pieces[1], pieces[2] = -QUARTER, straight
    if word == 7:
        pieces[3], pieces[4] = -QUARTER, last
    else:
        pieces[3] = last
    return found
