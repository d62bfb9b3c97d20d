"""The exercises of lesson 11: each rule that a motion and a triangle may break."""

import numpy as np
import pytest

from kinoedu.course import EXERCISES
from kinoedu.course.exercise import Case

BETWEEN = np.array([(1, 0.01), (29, 0.01), (15, 0.99)])  # the chords of a disk that moves along x


@pytest.mark.parametrize(
    ("b", "triangle", "rule"),
    [
        ((10001, 0), BETWEEN, "range"),
        ((30, 0), BETWEEN * np.nan, "range"),
        ((30, 0), BETWEEN * (1, 0), "valid"),
        ((30, 0), BETWEEN - (0, -1), "hits"),
        ((30, 0), BETWEEN - (0, -0.02), "exposes"),
        ((30, 0), BETWEEN - (0, 0.02), "exposes"),
        ((30, 0), BETWEEN * (1, -1) - (0, 0.02), "exposes"),
        ((0, 30), BETWEEN[:, ::-1] - (-0.02, 0), "exposes"),
        ((0, 30), BETWEEN[:, ::-1] * (-1, 1) - (0.02, 0), "exposes"),
        ((1, 0), BETWEEN * 1000 - (15000, 300), "range"),
        ((1, 0), BETWEEN * 100 - (1500, 30), "exposes"),
        ((30, 0), BETWEEN * (1, 0.9), "thickest"),
        ((30, 0), BETWEEN, ""),
        ((10000, 0), BETWEEN[::-1], ""),
        ((30, 0), BETWEEN * (1, -1), ""),
        ((0, 30), BETWEEN[:, ::-1], ""),
        ((0, 30), BETWEEN[:, ::-1] * (-1, 1), ""),
    ],
)
def test_an_exposing_obstacle_breaks_one_rule(b, triangle, rule):
    """A triangle in range that the disk hits between all chords, and that is thick."""
    answer = (np.zeros(2), np.array(b, float), triangle)
    assert EXERCISES["exposing_obstacle"].value_verdict(Case("thickest", {}), answer).rule == rule
