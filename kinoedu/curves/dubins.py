"""Dubins' shortest curves: forward only. L. E. Dubins, "On curves of minimal length with a
constraint on average curvature, and with prescribed initial and terminal positions and tangents"
(1957); LaValle, section 15.3.1.
"""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import compiled
from ..geometry.checks import Array
from ..spaces.angles import FULL_TURN
from .curve import Curve, as_pose, as_radius, seen_from
from .tangents import lrl, lsl, lsr

WORDS = np.array([(1, 0, 1), (1, 0, -1), (1, -1, 1)])
# a later word must be shorter by this many radii, so that rounding does not choose between equals
TIE = 1e-10
SNAP = 1e-12  # a turn that is a whole one but for rounding is none


def dubins_path(q0: ArrayLike, q1: ArrayLike, radius: float) -> Curve:
    """The shortest way from pose q0 to pose q1, shapes (3,) as (x, y, theta), driven forward and
    turning no tighter than `radius`.

    One of six words: LSL, RSR, LSR, RSL, LRL, RLR. The length is good to 1e-9 of the radius.
    Raises InvalidPoint, InvalidParameter.

    >>> curve = dubins_path((0, 0, 0), (0, 4, np.pi), 2.0)
    >>> curve.word, round(curve.length / np.pi, 12), curve.at(curve.length).round(12)[:2]
    ('LSL', 2.0, array([0., 4.]))
    """
    start, end, rho = as_pose(q0, "q0"), as_pose(q1, "q1"), as_radius(radius)
    turns, lengths = shortest_forward(*seen_from(start, end, rho))
    return Curve(start, rho, turns, rho * lengths)


def every_word(q0: ArrayLike, q1: ArrayLike, radius: float) -> list[Curve]:
    """One curve for each of the six words that leads from q0 to q1; between near poses some have
    none. As in `dubins_path`.

    >>> [curve.word for curve in every_word((0, 0, 0), (10, 0, 0), 1.0)]
    ['LSL', 'RSR', 'LSR', 'RSL']
    """
    start, end, rho = as_pose(q0, "q0"), as_pose(q1, "q1"), as_radius(radius)
    x, y, phi = seen_from(start, end, rho)
    found = [
        (mirror * turns, forward(word, x, mirror * y, mirror * phi))
        for word, turns in enumerate(WORDS)
        for mirror in (1, -1)
    ]
    return [
        Curve(start, rho, turns, rho * np.array(lengths))
        for turns, (exists, *lengths) in found
        if exists
    ]


@compiled
def shortest_forward(x: float, y: float, phi: float) -> tuple[NDArray[np.int64], Array]:
    """The turns and lengths of the shortest word from (0, 0, 0) to (x, y, phi), radius 1: three
    pieces.
    """
    turns, lengths, best = np.zeros(3, np.int64), np.zeros(3), np.inf
    for word in range(len(WORDS)):
        for mirror in (1, -1):
            found, t, u, v = forward(word, x, mirror * y, mirror * phi)
            if found and t + u + v < best - TIE:
                best = t + u + v
                lengths[0], lengths[1], lengths[2] = t, u, v
                for i in range(3):
                    turns[i] = mirror * WORDS[word, i]
    return turns, lengths


@compiled
def forward(word: int, x: float, y: float, phi: float) -> tuple[bool, float, float, float]:
    """The pieces of one word, none of them negative."""
    if word == 2:  # an arc driven back is the rest of its circle driven forward
        found, t, u, v = lrl(x, y, phi)
        return found, round_left(t), u + FULL_TURN, round_left(v)
    found, t, u, v = lsl(x, y, phi) if word == 0 else lsr(x, y, phi)
    return found, round_left(t), u, round_left(v)


@compiled
def round_left(angle: float) -> float:
    """The same turn in [0, 2 pi)."""
    turn = angle - FULL_TURN * math.floor(angle / FULL_TURN)
    return 0.0 if turn > FULL_TURN - SNAP else turn
