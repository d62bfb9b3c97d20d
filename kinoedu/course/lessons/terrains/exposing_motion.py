"""The exercise "break it" of lesson 10: a motion judged by samples half a cell apart goes through a
rock.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....words import say
from ...exercise import RIGHT, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Together
from ..geometry.lines import POINT
from .motions import crossed, cuts, fault_of_motion, length, samples_along

DEEP = 0.49  # of the half that samples are apart


class ExposeSampling(Exercise):
    """Break it: a terrain and a motion through a blocked cell that `is_free_by_samples` lets
    pass.
    """

    name = "exposing_motion"
    lesson = "10_terrains"
    kinds = ("valid", "exposes", "deepest")
    given = Record()
    answer = Together((Numbers(("rows", "columns")), POINT, POINT))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The same question three times: each asks more of the answer."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """A terrain with a motion; that is let pass; and goes through the rock for as long as can
        be.
        """
        rule = fault_of_motion(*value)
        if not rule and case.kind != "valid":
            rule = exposing_fault(*value)
        if not rule and case.kind == "deepest" and deepest(*value) < DEEP:
            rule = "deepest"
        return Verdict(0.0, rule, self.wanted(case)) if rule else RIGHT

    def wanted(self, case: Case) -> str:
        """What is asked for."""
        return say(f"exposing_motion.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The cells, the motion, and its samples."""
        from .pictures import draw_samples_on

        draw_samples_on(
            outcome.value if isinstance(outcome, Answer) else None, self.words("picture"), ax
        )


def is_free_by_samples(free: Array, a: Array, b: Array) -> bool:
    """Whether a motion is free, judged every half cell, much as the document does.

    It lets motions pass that go through rocks. Which?
    """
    return all(free[int(y), int(x)] for x, y in samples_along(a, b))


def exposing_fault(free: Array, a: Array, b: Array) -> str:
    """The rule that keeps it from exposing the samples, or ""."""
    if not is_free_by_samples(free, a, b):
        return "seen"
    return "" if deepest(free, a, b) > 0.0 else "exposes"


def deepest(free: Array, a: Array, b: Array) -> float:
    """The longest stretch of a motion inside one blocked cell."""
    pieces = np.diff(cuts(a, b)) * length(a, b)
    return max(
        (float(s) for s, (i, j) in zip(pieces, crossed(free, a, b)) if not free[j, i]), default=0.0
    )
