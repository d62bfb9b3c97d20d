"""The exercise "break it" of lesson 10: a motion through a rock between two samples."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Together, Value
from ..geometry.lines import POINT
from .motions import find_crossed_cells, find_cuts, find_motion_fault, measure_length, sample_motion

DEEP = 0.49  # least length in the rock; samples are 0.5 apart


class Cells(Numbers):
    """The shape of a terrain: numbers, or truth values, which count as 1 and 0."""

    def encode(self, value: Value) -> object:
        """Encode an array, or nested lists, tuples and arrays that make one."""
        return super().encode(count_truths(value, 2))


def count_truths(value: Value, depth: int) -> Value:
    """A value with 1 and 0 for the truth values in it, in nested lists down to a depth."""
    if type(value) is np.ndarray and value.dtype == bool:
        return value.astype(int)
    if type(value) in (bool, np.bool_):
        return int(value)
    if depth and type(value) in (list, tuple):
        return [count_truths(one, depth - 1) for one in value]
    return value


class ExposeSampling(Exercise):
    """Give a terrain and a motion through a blocked cell that `is_free_by_samples` accepts."""

    name = "exposing_motion"
    lesson = "10_terrains"
    kinds = ("valid", "exposes", "deepest")
    given = Record()
    answer = Together((Cells(("rows", "columns")), POINT, POINT))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the same question three times; each time the answer must fulfil more."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that the motion is valid, is accepted, and how long it is in the rock."""
        rule = find_motion_fault(*value)
        if not rule and case.kind != "valid":
            rule = find_exposing_fault(*value)
        if not rule and case.kind == "deepest" and measure_deepest(*value) < DEEP:
            rule = "deepest"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer to a case must be."""
        return get_message(f"exposing_motion.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the cells, the motion and its samples."""
        from .pictures import draw_samples_on

        draw_samples_on(
            outcome.value if isinstance(outcome, Answer) else None, self.message("picture"), ax
        )


def is_free_by_samples(free: Array, a: Array, b: Array) -> bool:
    """Whether a motion is free at samples half a cell apart, much as the document does.

    The program accepts motions that go through rocks. Which?
    """
    return all(free[int(y), int(x)] for x, y in sample_motion(a, b))


def find_exposing_fault(free: Array, a: Array, b: Array) -> str:
    """Return the rule that keeps the motion from exposing the samples, or ""."""
    if not is_free_by_samples(free, a, b):
        return "seen"
    return "" if measure_deepest(free, a, b) > 0.0 else "exposes"


def measure_deepest(free: Array, a: Array, b: Array) -> float:
    """Return the greatest length of a motion inside one blocked cell."""
    pieces = np.diff(find_cuts(a, b)) * measure_length(a, b)
    return max(
        (float(s) for s, (i, j) in zip(pieces, find_crossed_cells(a, b)) if not free[j, i]),
        default=0.0,
    )
