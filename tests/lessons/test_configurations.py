"""The exercises of lesson 5: each rule that an arm and its target may break."""

import pytest

from kinoedu.course import EXERCISES
from kinoedu.course.exercise import Case


@pytest.mark.parametrize(
    ("answer", "rule"),
    [
        ((0.09, 0.1, (0.1, 0.0)), "lengths"),
        ((100.0, 101.0, (5.0, 0.0)), "lengths"),
        ((0.1, 0.1, (0.009, 0.0)), "valid"),
        ((1.0, 1.1, (2.1, 0.0)), "valid"),
        ((1.0, 1.1, (0.0, 0.1)), "valid"),
        ((1.0, 1.1, (float("nan"), 0.0)), "valid"),
        ((1.0, 1.1, (2.0, 0.0)), "exposes"),
        ((1.0, 1.2, (0.3, 0.0)), "narrow"),
        ((1.0, 1.1, (0.3, 0.0)), ""),
        ((0.1, 0.1, (0.01, 0.0)), "exposes"),
        ((100.0, 100.0, (199.0, 0.0)), "exposes"),
    ],
)
def test_an_arm_and_its_target_break_one_rule(answer, rule):
    """Lengths, a target clearly in reach, one that the program misses, and links nearly equal."""
    verdict = EXERCISES["exposing_reach"].value_verdict(Case("narrow", {}), answer)
    assert verdict.rule == rule
