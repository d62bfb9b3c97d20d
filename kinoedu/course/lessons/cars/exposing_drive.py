"""The exercise "break it" of lesson 12: a drive on which a car that takes phi for tan(phi) is
lost.
"""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....words import say
from ...exercise import RIGHT, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record, Together
from ..shared.car_pictures import draw_lost
from ..shared.driving import moved

WHEELBASE = 20.0
STEEPEST, LONGEST, SMALL = math.pi / 4, 1000.0, 0.1


class ExposeSmallAngles(Exercise):
    """Break it: a steering angle and a time after which `move_by_angle` is more than 1 off."""

    name = "exposing_drive"
    lesson = "12_the_car"
    kinds = ("valid", "exposes", "small")
    given = Record()
    answer = Together((Number(), Number()))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The same question three times: each asks more of the answer."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """A drive; after which the program is off; with the wheels hardly turned."""
        phi, t = value
        rule = "" if abs(phi) <= STEEPEST and 0.0 <= t <= LONGEST else "valid"
        if not rule and case.kind != "valid":
            rule = "" if off_after(phi, t) > 1.0 else "exposes"
            rule = rule or ("small" if case.kind == "small" and abs(phi) > SMALL else "")
        return Verdict(0.0, rule, self.wanted(case)) if rule else RIGHT

    def wanted(self, case: Case) -> str:
        """What is asked for."""
        return say(f"exposing_drive.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The way that the car drives, and the way that the program believes in."""
        fits = (
            isinstance(outcome, Answer)
            and self.value_verdict(Case("valid", {}), outcome.value).is_right
        )
        draw_lost(outcome.value if isinstance(outcome, Answer) and fits else None, WHEELBASE, ax)


def off_after(phi: float, t: float) -> float:
    """How far the program's place is from the car's."""
    start = np.zeros(3)
    return math.dist(
        moved(start, 1.0, phi, t, WHEELBASE)[:2], move_by_angle(start, 1.0, phi, t, WHEELBASE)[:2]
    )


def move_by_angle(pose: Array, v: float, phi: float, t: float, L: float) -> Array:
    """The pose after driving for a time t with the speed v and the steering angle phi.

    It is wrong somewhere. Where?
    """
    x, y, theta = pose
    turn, distance = v * t * phi / L, v * t
    chord = distance if turn == 0 else distance * math.sin(turn / 2) / (turn / 2)
    return np.array(
        [
            x + chord * math.cos(theta + turn / 2),
            y + chord * math.sin(theta + turn / 2),
            theta + turn,
        ]
    )
