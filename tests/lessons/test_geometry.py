"""The exercises of lesson 1: each rule that an answer may break."""

import numpy as np
import pytest

from kinoedu.course import EXERCISES
from kinoedu.course.exercise import Case

TRIANGLE = np.array([(0, 0), (4, 0), (0, 3)], float)
INSIDE, AT_VERTEX = np.array((1.0, 1.0)), np.array((1.0, 2.0))


@pytest.mark.parametrize(
    ("q", "polygon", "rule"),
    [
        (INSIDE, TRIANGLE * np.nan, "range"),
        (INSIDE * np.inf, TRIANGLE, "range"),
        (INSIDE, TRIANGLE * 2501, "range"),
        (INSIDE, np.empty((0, 2)), "valid"),
        (INSIDE, TRIANGLE[[0, 1, 0]], "valid"),
        (INSIDE, TRIANGLE, "exposes"),
        (np.array((5.0, 1.5)), TRIANGLE, "exposes"),
        (np.array((2.1, 1.5)), TRIANGLE, "exposes"),
        (AT_VERTEX, np.array([(0, 0), (4, 0), (4, 2), (0, 4)], float), "smallest"),
        (AT_VERTEX, np.array([(0, 0), (4, 2), (0, 4)], float), ""),
        (AT_VERTEX * 2500, np.array([(0, 0), (4, 2), (0, 4)], float) * 2500, ""),
    ],
)
def test_an_exposing_case_breaks_one_rule(q, polygon, rule):
    """Numbers in range, a simple polygon, one that the program is wrong for, and a triangle."""
    verdict = EXERCISES["exposing_case"].value_verdict(Case("smallest", {}), (q, polygon))
    assert verdict.rule == rule


@pytest.mark.parametrize(("kind", "rule"), [("upright", "slope"), ("slanted", "unit")])
def test_a_line_without_numbers_is_of_a_slope_only_where_there_is_none(kind, rule):
    """Elsewhere its normal has no length of 1."""
    exercise = EXERCISES["line_through_points"]
    case = next(case for case in exercise.fixed_cases if case.kind == kind)
    assert exercise.value_verdict(case, np.full(3, np.nan)).rule == rule
