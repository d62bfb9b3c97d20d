"""Dubins curves: the shortest curves of a car that drives forward only.

Sources: L. E. Dubins, "On curves of minimal length with a constraint on average curvature, and with
prescribed initial and terminal positions and tangents" (1957); LaValle, section 15.3.1.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled, inlined
from ..geometry.checks import Array
from ..spaces.angles import FULL_TURN
from .curve import Curve, as_pose, as_radius, as_relative_pose
from .tangents import lrl, lsl, lsr

WORDS = np.array([(1, 0, 1), (1, 0, -1), (1, -1, 1)])
# A later word must be shorter by this many radii, so that rounding does not break ties.
TIE = 1e-10
SNAP = 1e-12  # an angle nearer than this to a full turn is 0
ROUGH = 1e-3  # the same between near poses, where leaving the arc out moves the end less than SNAP


def dubins_path(q0: ArrayLike, q1: ArrayLike, radius: float) -> Curve:
    """The shortest curve from q0 to q1, driven forward, that turns no tighter than `radius`.

    Its word is one of six: LSL, RSR, LSR, RSL, LRL, RLR. The length is accurate to 1e-9 radii
    for a pose within 1e-12 radii of q1: where LSR or RSL begins to exist, the shortest length may
    jump, and rounding must not hide these words.

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
    >>> curve = dubins_path((0, 0, 0), (0, 4, np.pi), 2.0)
    >>> curve.word, round(curve.length / np.pi, 12), curve.at(curve.length).round(12)[:2]
    ('LSL', 2.0, array([0., 4.]))
    """
    start, end, rho = as_pose(q0, "q0"), as_pose(q1, "q1"), as_radius(radius)
    turns, lengths = shortest_forward(*as_relative_pose(start, end, rho))
    return Curve(start, rho, turns, rho * lengths)


def all_dubins_curves(q0: ArrayLike, q1: ArrayLike, radius: float) -> list[Curve]:
    """The curves from q0 to q1 for all of the six words that exist between them.

    LSR and RSL do not exist between near poses, LRL and RLR not between far ones. Parameters and
    errors are those of `dubins_path`.

    Examples
    --------
    >>> [curve.word for curve in all_dubins_curves((0, 0, 0), (10, 0, 0), 1.0)]
    ['LSL', 'RSR', 'LSR', 'RSL']
    """
    start, end, rho = as_pose(q0, "q0"), as_pose(q1, "q1"), as_radius(radius)
    x, y, phi = as_relative_pose(start, end, rho)
    found = [
        (mirror * turns, solve_word(word, x, mirror * y, mirror * phi))
        for word, turns in enumerate(WORDS)
        for mirror in (1, -1)
    ]
    return [
        Curve(start, rho, turns, rho * np.array(lengths))
        for turns, (exists, *lengths) in found
        if exists
    ]


@inlined
def shortest_forward(x: float, y: float, phi: float) -> tuple[NDArray[np.int64], Array]:
    """Turns and lengths of the shortest word from (0, 0, 0) to (x, y, phi) for radius 1."""
    turns, lengths, best = np.zeros(3, np.int64), np.zeros(3), np.inf
    for word in range(len(WORDS)):
        for mirror in (1, -1):
            found, t, u, v = solve_word(word, x, mirror * y, mirror * phi)
            if found and t + u + v < best - TIE:
                best = t + u + v
                lengths[0], lengths[1], lengths[2] = t, u, v
                for i in range(3):
                    turns[i] = mirror * WORDS[word, i]
    return turns, lengths


@inlined
def solve_word(word: int, x: float, y: float, phi: float) -> tuple[bool, float, float, float]:
    """Whether a word exists, and the lengths of its three pieces, none of them negative."""
    if word == 2:  # an arc driven back is replaced by the rest of its circle
        found, t, u, v = lrl(x, y, phi)
        return found, positive_angle(t), u + FULL_TURN, positive_angle(v)
    found, t, u, v = lsl(x, y, phi) if word == 0 else lsr(x, y, phi)
    t, v = positive_angle(t), positive_angle(v)
    if word == 0 and is_left_out(t, u):
        return found, 0.0, u, positive_angle(phi)
    if word == 0 and is_left_out(v, u):
        return found, positive_angle(phi), u, 0.0
    return found, t, u, v


@compiled
def is_left_out(arc: float, straight: float) -> bool:
    """Whether one arc of the word LSL is a full turn only by rounding; the other turns for both."""
    missing = FULL_TURN - arc
    return missing < ROUGH and missing * straight < SNAP


@compiled
def positive_angle(angle: float) -> float:
    """The angle of the same left turn in [0, 2 pi)."""
    inside = angle - FULL_TURN * math.floor(angle / FULL_TURN)
    return 0.0 if inside > FULL_TURN - SNAP else inside
