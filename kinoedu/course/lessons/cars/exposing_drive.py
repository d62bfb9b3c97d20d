"""The "break it" exercise of lesson 12: a drive on which phi in place of tan(phi) fails."""

import math
from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ....robots.trajectory import replay_controls
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record, Together, Value
from ..shared.car_pictures import draw_lost

WHEELBASE = 20.0
STEEPEST, LONGEST = math.pi / 4, 1000.0
SMALL = 0.1 + 1e-8  # the largest angle for the last case, rounding to float32 included


class ExposeSmallAngles(Exercise):
    """Find a steering angle and a time after which `move_by_angle` is off by more than 1."""

    name = "exposing_drive"
    lesson = "12_the_car"
    kinds = ("valid", "exposes", "small")
    given = Record()
    answer = Together((Number(), Number()))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The same question three times; each case demands more of the answer."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check that the drive is valid, that the program fails, and that the angle is small."""
        phi, t = value
        rule = "" if abs(phi) <= STEEPEST and 0.0 <= t <= LONGEST else "valid"
        if not rule and case.kind != "valid":
            rule = "" if off_after(phi, t) > 1.0 else "exposes"
            rule = rule or ("small" if case.kind == "small" and abs(phi) > SMALL else "")
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Description of what the case asks for."""
        return get_message(f"exposing_drive.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the car's path, and the path that the program computes."""
        value = outcome.value if isinstance(outcome, Answer) else None
        if value is not None and not self.value_verdict(Case("valid", {}), value).is_right:
            value = None
        draw_lost(value, WHEELBASE, ax)


def off_after(phi: float, t: float) -> float:
    """Distance between the program's position and the car's."""
    start = np.zeros(3)
    right = replay_controls(start, np.array([(1.0, phi)]), np.array([t]), WHEELBASE)[-1]
    return math.dist(right[:2], move_by_angle(start, 1.0, phi, t, WHEELBASE)[:2])


def move_by_angle(pose: Array, v: float, phi: float, t: float, L: float) -> Array:
    """Pose after driving for a time t with the speed v and the steering angle phi.

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
