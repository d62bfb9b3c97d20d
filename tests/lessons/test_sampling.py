"""The exercises of lesson 6: each rule that a corridor or random points may break."""

import math

import numpy as np
import pytest

from kinoedu import dispersion
from kinoedu.course import EXERCISES
from kinoedu.course.exercise import Case

EDGE = 1 / 32  # the widest gap beside the outermost points of the grids


@pytest.mark.parametrize(
    ("corridor", "rule"),
    [
        ((float("nan"), 0, 1, 1), "valid"),
        ((-1e-8, 0, EDGE, 1), "valid"),
        ((0, -1e-8, EDGE, 1), "valid"),
        ((0, 0, EDGE, 1 + 1e-8), "valid"),
        ((0, 0, 1 + 1e-8, EDGE), "valid"),
        ((EDGE, 0, EDGE, 1), "valid"),
        ((0, EDGE, 1, EDGE), "valid"),
        ((0, 0, EDGE, 0.999), "across"),
        ((0, 0, 0.999, EDGE), "across"),
        ((0, 0, EDGE + 0.001, 1), "exposes"),
        ((0, 0, 1, EDGE + 0.001), "exposes"),
        ((1 - EDGE - 0.001, 0, 1, 1), "exposes"),
        ((0, 1 - EDGE - 0.001, 1, 1), "exposes"),
        ((0, 0, 0.0309, 1), "widest"),
        ((0, 0, 1, 0.0309), "widest"),
        ((0, 0, EDGE, 1), ""),
        ((1 - EDGE, 0, 1, 1), ""),
        ((0, 1 - EDGE, 1, 1), ""),
        ((0, -1e-10, 0.031, 1 + 1e-10), ""),
    ],
)
def test_a_corridor_breaks_one_rule(corridor, rule):
    """Inside the square, across it, missed by all grids, and wide; up to rounding."""
    verdict = EXERCISES["exposing_corridor"].value_verdict(Case("widest", {}), corridor)
    assert verdict.rule == rule


FIRST, OTHER, FAR = np.random.default_rng(0).random((3, 640, 2))
TOP = np.vstack([np.ones(2), FIRST[1:]])


@pytest.mark.parametrize(
    ("points", "rule"),
    [
        ((FIRST, FIRST, OTHER, FAR), ""),
        ((TOP, TOP, OTHER, FAR), ""),
        ((FIRST[1:], FIRST[1:], OTHER, FAR), "count"),
        ((FIRST, FIRST, OTHER, FAR[1:]), "count"),
        ((FIRST + 1, FIRST + 1, OTHER, FAR), "outside"),
        ((FIRST, FIRST, OTHER - 1, FAR), "outside"),
        ((FIRST, OTHER, FIRST, FAR), "again"),
        ((FIRST, FIRST, FIRST, FAR), "another"),
        ((FIRST, FIRST, OTHER, FIRST), "another"),
        ((FIRST, FIRST, FIRST[::-1], FAR), "shared"),
        ((FIRST, FIRST, OTHER, FIRST[::-1]), "shared"),
        ((FIRST, FIRST, OTHER, FIRST * (1, 0.9)), "shared"),
        ((FIRST, FIRST, FIRST * 0.9, FAR), "moved"),
        ((FIRST, FIRST, OTHER, FIRST * 0.9), "moved"),
        ((FIRST, FIRST, OTHER, np.column_stack([FIRST[:, 0] * 0.9, FAR[:, 1]])), "moved"),
    ],
)
def test_random_points_break_one_rule(points, rule):
    """Two calls with one seed and two with others; one of the others is enough to be wrong."""
    exercise = EXERCISES["uniform_random"]
    case = Case("plane", {"n": 640, "d": 2, "rng": 0})
    assert exercise.value_verdict(case, points).rule == rule


def test_bounds_that_are_those_of_the_largest_coordinate_are_named():
    """Also where the lower one is that dispersion itself, to the last bit."""
    exercise = EXERCISES["dispersion_bounds"]
    case = next(case for case in exercise.fixed_cases if case.kind == "inside")
    sup = dispersion(case.given["points"], math.inf)
    assert exercise.value_verdict(case, (sup, sup)).rule == "sup"
