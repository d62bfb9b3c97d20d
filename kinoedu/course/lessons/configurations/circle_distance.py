"""The exercise `circle_distance`. Bullo & Smith, chapter 3."""

from collections.abc import Iterator
from math import pi

import numpy as np

from ....spaces import circle_distance
from ...exercise import Case, Slip
from ...shapes import Number, Record
from .angles import TURN, BetweenAngles


class CircleDistance(BetweenAngles):
    """The length of the shorter arc between two directions."""

    name = "circle_distance"
    kinds = ("near", "across", "opposite", "turns", "same")
    given = Record(a=Number(), b=Number())
    answer = Number()
    source = staticmethod(circle_distance)
    slips = (
        Slip("no_wrap", lambda a, b: abs(a - b)),
        Slip("one_way", lambda a, b: (b - a) % TURN),
        Slip("one_way", lambda a, b: (a - b) % TURN),
        Slip("signed", lambda a, b: (b - a + pi) % TURN - pi),
        Slip("signed", lambda a, b: (a - b + pi) % TURN - pi),
        Slip("one_side", lambda a, b: wrapped_above(b - a)),
        Slip("one_side", lambda a, b: wrapped_above(a - b)),
        Slip("half_turns", lambda a, b: abs(a - b) % pi),
        Slip("half_turns", lambda a, b: min((a - b) % pi, (b - a) % pi)),
        Slip("once", lambda a, b: min(abs(a - b), TURN - abs(a - b))),
        Slip("once", lambda a, b: min(abs(a - b), abs(TURN - abs(a - b)))),
        Slip("long", lambda a, b: TURN - circle_distance(a, b)),
        Slip("chord", lambda a, b: 2.0 * np.sin(circle_distance(a, b) / 2.0)),
        Slip("degrees", lambda a, b: np.degrees(circle_distance(a, b))),
        Slip("degrees", lambda a, b: min(abs(a - b) % 360.0, 360.0 - abs(a - b) % 360.0)),
        Slip("rounded", lambda a, b: round(float(circle_distance(a, b)), 2)),
        Slip("short_pi", lambda a, b: with_half_turn(3.14, a, b)),
        Slip("short_pi", lambda a, b: with_half_turn(3.1416, a, b)),
        Slip("short_pi", lambda a, b: with_half_turn(3.14159, a, b)),
    )
    reference = staticmethod(circle_distance)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Integers first; angles in [-pi, pi), then any angles."""
        for a, b in (
            (0, 1),
            (2, 0.5),
            (-1, 1),
            (3, -3),
            (-3, 2),
            (0, -pi),
            (pi / 2, -pi / 2),
            (1, 1),
        ):
            yield self.case(a, b)
        for a, b in (
            (0, TURN),
            (0, 7),
            (-7, 1),
            (20, -20),
            (-pi, pi),
            (0, 3 * pi),
            (10, 10.001),
            (0, 0),
            (95, -95),
            (25.5, 25.5),  # the dot product of its direction with itself is rounded to more than 1
        ):
            yield self.case(a, b)
        for _ in range(25):
            a, turn = np.round(rng.uniform(-3.1, 3.1), 2), np.round(rng.uniform(0.01, 2.9), 2)
            yield self.case(a, min(max(a + rng.choice([-1, 1]) * turn, -3.14), 3.14))
            yield self.case(
                np.round(rng.uniform(1.6, 3.14), 2), np.round(rng.uniform(-3.14, -1.6), 2)
            )
            yield self.case(
                np.round(rng.uniform(-3.14, -1.6), 2), np.round(rng.uniform(1.6, 3.14), 2)
            )
            yield self.case(a, a + pi if a < 0 else a - pi)
            yield self.case(
                a, np.round(a + turn + rng.integers(1, 15) * rng.choice([-TURN, TURN]), 2)
            )
            yield self.case(a, a + rng.integers(0, 3) * TURN)

    def case(self, a: float, b: float) -> Case:
        """Case of two angles, with its kind."""
        return Case(kind_of(float(a), float(b)), {"a": float(a), "b": float(b)})


def kind_of(a: float, b: float) -> str:
    """Kind of a pair of directions."""
    apart = float(circle_distance(a, b))
    if apart < 1e-9:
        return "same"
    if max(abs(a), abs(b)) > pi:
        return "turns"
    if pi - apart < 1e-9:
        return "opposite"
    return "near" if abs(a - b) < pi else "across"


def wrapped_above(turn: float) -> float:
    """Size of a turn, wrapped only above pi; a turn below -pi is not wrapped."""
    return abs(turn - TURN * np.ceil((turn - pi) / TURN)) if turn > pi else abs(turn)


def with_half_turn(half: float, a: float, b: float) -> float:
    """The distance where half a turn is written as a number of few digits."""
    turn = abs(a - b) % (2.0 * half)
    return min(turn, 2.0 * half - turn)
