"""The "break it" exercise of lesson 5: find where inverse kinematics by the law of sines fails."""

from collections.abc import Iterator
from math import acos, asin, atan2, hypot, sin

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ....robots import TwoLinkArm
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record, Together, Value
from .pictures import draw_missed

NEARLY = 1.1 + 1e-9  # the largest l2 / l1 for the last case, rounding included


class ExposeReach(Exercise):
    """Find an arm and a reachable target that `inverse_by_sines` misses."""

    name = "exposing_reach"
    lesson = "05_configuration_spaces"
    kinds = ("valid", "exposes", "narrow")
    given = Record()
    answer = Together((Number(), Number(), Numbers((2,))))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The same question three times; each case demands more of the answer."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check that the target is reachable, that the program misses it, and the link lengths."""
        l1, l2, p = value
        rule = arm_fault(l1, l2, p)
        if not rule and case.kind != "valid":
            rule = "exposes" if missed_by(l1, l2, p) <= 1e-6 * (l1 + l2) else ""
            rule = rule or ("narrow" if case.kind == "narrow" and l2 > NEARLY * l1 else "")
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Description of what the case asks for."""
        return get_message(f"exposing_reach.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the arm's reach, the target, and the arms at the program's angles."""
        value = (
            outcome.value if isinstance(outcome, Answer) and not arm_fault(*outcome.value) else None
        )
        draw_missed(value, [] if value is None else inverse_by_sines(*value), ax)


def arm_fault(l1: float, l2: float, p: Array) -> str:
    """Key of the rule that makes the input invalid, or ""."""
    distance = hypot(*p)
    if not (0.1 <= l1 <= 100.0 and 0.1 <= l2 <= 100.0):
        return "lengths"
    margin = 1e-3 * (l1 + l2)
    nearest = max(0.01, abs(l1 - l2) + margin)
    return "" if nearest <= distance <= l1 + l2 - margin else "valid"


def missed_by(l1: float, l2: float, p: Array) -> float:
    """Distance of the tip to the target, for the worse of the program's two answers."""
    arm = TwoLinkArm(l1, l2, 0.0)
    return max(float(np.hypot(*(arm.joints(q)[1] - p))) for q in inverse_by_sines(l1, l2, p))


def inverse_by_sines(l1: float, l2: float, p: Array) -> list[tuple[float, float]]:
    """Both configurations of an arm with its tip at p.

    The second angle is computed by the law of cosines, the angle at the base by the law of sines.

    It is wrong somewhere. Where?
    """
    distance, heading = hypot(p[0], p[1]), atan2(p[1], p[0])
    bend = acos((distance * distance - l1 * l1 - l2 * l2) / (2 * l1 * l2))
    lead = asin(min(1.0, l2 * sin(bend) / distance))
    return [(heading - lead, bend), (heading + lead, -bend)]
