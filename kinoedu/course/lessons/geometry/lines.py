"""Shared parts of the exercises on lines. Bullo & Smith, chapter 1."""

import numpy as np

from ....geometry.checks import Array
from ...exercise import Case, ValueExercise, Verdict
from ...outcomes import Outcome, Raised
from ...shapes import Numbers, Value

POINT = Numbers((2,))
LEVEL, UPRIGHT = np.eye(2)
# added to 1 it gives a number that `math.isclose` takes for 1; products with it are not rounded
NEXT = 2.0**-35
NEAR = 1.0  # points nearer than this may have been taken for the same point


class LineExercise(ValueExercise):
    """An exercise in which a ValueError is right only where two points coincide."""

    def judge(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge an outcome; a ValueError for near points breaks a rule of its own."""
        verdict = super().judge(case, outcome)
        return (
            verdict._replace(rule="distinct")
            if verdict.rule == "raised"
            and isinstance(outcome, Raised)
            and "ValueError" in outcome.kinds
            and is_short(case.given["p1"], case.given["p2"])
            else verdict
        )


class DistanceExercise(ValueExercise):
    """An exercise whose answer is a distance."""

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Compare a distance with the true one; zero breaks a rule of its own."""
        verdict = super().value_verdict(case, value)
        return verdict if verdict.is_right or value != 0 else verdict._replace(rule="zero")


def is_short(p1: Array, p2: Array) -> bool:
    """Whether two points are near each other."""
    return bool(np.linalg.norm(p2 - p1) < NEAR)
