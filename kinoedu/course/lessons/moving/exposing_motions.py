"""The exercise "break it" of lesson 14: motions that touch between sampled moments."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Together, Value
from .first_contact import find_relative_motion
from .pictures import draw_missed

FARTHEST, RADIUS, MOMENTS = 100.0, 1.0, 20
DEEP = 0.1 + 1e-9  # the farthest from the centre that is deep, rounding included


class ExposeMoments(Exercise):
    """Give motions of a point and a disc whose contact `touch_by_moments` does not see."""

    name = "exposing_motions"
    lesson = "14_moving_and_uncertain"
    kinds = ("valid", "exposes", "deep", "standing")
    given = Record()
    answer = Together((Numbers((2,)),) * 4)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the same question four times; each time the answer must fulfil more."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that the motions are valid and that their contact is not seen.

        Later cases also demand that the point passes the disc's centre, and that the point
        stands still.
        """
        p0, p1, c0, c1 = value
        rule = "" if is_valid(value) else "valid" if not is_in_range(value) else "apart"
        if not rule and case.kind != "valid":
            if find_least_distance(*value) >= RADIUS - 1e-9:
                rule = "exposes"
            elif touch_by_moments(p0, p1, c0, c1, RADIUS):
                rule = "seen"
            if not rule and case.kind != "exposes":
                rule = "deep" if find_least_distance(*value) > DEEP else ""
                rule = rule or ("standing" if case.kind == "standing" and (p0 != p1).any() else "")
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer to a case must be."""
        return get_message(f"exposing_motions.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the point's motion seen from the disc, with the moments that the program samples."""
        fits = isinstance(outcome, Answer) and is_valid(outcome.value)
        draw_missed(
            outcome.value if isinstance(outcome, Answer) and fits else None, RADIUS, MOMENTS, ax
        )


def is_valid(value: Value) -> bool:
    """Whether the coordinates are in range and point and disc do not touch at the beginning."""
    p0, _, c0, _ = value
    return is_in_range(value) and float((p0 - c0) @ (p0 - c0)) > RADIUS * RADIUS


def is_in_range(value: object) -> bool:
    """Whether all coordinates are in range."""
    return bool((np.abs(np.array(value)) <= FARTHEST).all())


def find_least_distance(p0: Array, p1: Array, c0: Array, c1: Array) -> float:
    """Return the least distance of the point from the disc's centre."""
    x, v = find_relative_motion(p0, p1, c0, c1)
    s = 0.0 if v @ v == 0.0 else min(max(-float(x @ v) / float(v @ v), 0.0), 1.0)
    return float(np.sqrt((x + s * v) @ (x + s * v)))


def touch_by_moments(p0: Array, p1: Array, c0: Array, c1: Array, r: float) -> bool:
    """Whether a point that moves from p0 to p1 touches a moving disc of radius r.

    The disc's centre moves from c0 to c1 in the same time. The program is wrong somewhere.
    Where?
    """
    for s in np.linspace(0, 1, 20):
        p, c = p0 + s * (p1 - p0), c0 + s * (c1 - c0)
        if np.hypot(*(p - c)) <= r:
            return True
    return False
