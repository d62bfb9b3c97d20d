"""The exercises of lesson 10: each rule that a motion on a terrain may break."""

import numpy as np
import pytest

from kinoedu.course import EXERCISES
from kinoedu.course.exercise import Case
from kinoedu.course.lessons.terrains.prm_on_terrain import find_sample_fault
from kinoedu.course.watching import Run

FREE, ROCK = np.ones((2, 2)), np.array([[1, 1], [1, 0]])
CORNER = np.array([[1, 0], [1, 1]])
ROOM = np.ones((12, 12))


@pytest.mark.parametrize(
    ("free", "a", "b", "rule"),
    [
        (np.empty((0, 2)), (0.5, 0.5), (1.5, 0.5), "valid"),
        (np.ones((13, 1)), (0.5, 0.5), (0.5, 1.5), "valid"),
        (np.ones((1, 13)), (0.5, 0.5), (1.5, 0.5), "valid"),
        (ROCK * 0.5, (0.5, 0.5), (1.5, 0.5), "valid"),
        (FREE, (0.0, 0.5), (1.5, 0.5), "inside"),
        (FREE, (0.5, 0.0), (1.5, 0.5), "inside"),
        (FREE, (0.5, 0.5), (2.0, 0.5), "inside"),
        (FREE, (0.5, 0.5), (0.5, 2.0), "inside"),
        (np.ones((1, 3)), (0.5, 0.5), (0.5, 1.5), "inside"),
        (FREE, (np.nan, 0.5), (1.5, 0.5), "inside"),
        (ROCK, (0.5, 0.5), (1.5, 1.5), "seen"),
        (ROCK, (1.5, 1.5), (1.5, 1.5), "seen"),
        (FREE, (0.5, 0.5), (1.5, 1.5), "exposes"),
        (FREE, (0.5, 0.5), (0.5, 0.5), "exposes"),
        (ROOM, (0.5, 0.5), (11.5, 11.5), "exposes"),
        (CORNER, (0.95, 0.85), (1.5, 1.4), "deepest"),
        (CORNER, (0.999, 0.6485), (1.5, 1.1495), ""),
    ],
)
def test_an_exposing_motion_breaks_one_rule(free, a, b, rule):
    """A small terrain, ends inside, samples that see no rock, and a long way through one."""
    answer = (free, np.array(a), np.array(b))
    assert EXERCISES["exposing_motion"].value_verdict(Case("deepest", {}), answer).rule == rule


OPEN = next(case for case in EXERCISES["prm_on_terrain"].fixed_cases if case.kind == "open")
PROBLEM = OPEN.given["problem"]
ENDS = np.array([PROBLEM.start, PROBLEM.goal])
OUTSIDE = np.full((1, 2), -1.0)


@pytest.mark.parametrize(
    ("samples", "generators", "rule"),
    [
        (ENDS, 1, ""),
        (np.vstack([OUTSIDE, ENDS[:1], OUTSIDE, ENDS[1:], ENDS]), 1, ""),
        (ENDS, 2, "generator"),
        (ENDS[::-1], 1, "samples"),
        (ENDS[:1], 1, "samples"),
    ],
)
def test_nodes_are_the_first_free_samples(samples, generators, rule):
    """In their order; nodes that were never drawn are none of them."""
    fault = find_sample_fault(PROBLEM, ENDS, Run(samples, generators, 0))
    assert (fault.rule if fault else "") == rule
