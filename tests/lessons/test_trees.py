"""The exercises of lesson 9: what the judge compares where nothing is random."""

import numpy as np
import pytest

from kinoedu.course import EXERCISES
from kinoedu.course.judging import run_case

EXERCISE = EXERCISES["rrt"]
STRAIGHT = [case for case in EXERCISE.fixed_cases if case.given["goal_bias"] == 1.0]


@pytest.mark.parametrize("case", STRAIGHT, ids=range(len(STRAIGHT)))
def test_with_goal_bias_1_every_node_is_compared(case):
    """A tree whose last step is a little too short is wrong, although it breaks no other rule."""

    def rrt(*given):
        nodes, parent, path = EXERCISE.source(*given)
        nodes, last = np.array(nodes), len(nodes) - (1 if path is None else 2)
        nodes[last] += 0.01 * (nodes[parent[last]] - nodes[last])
        return nodes, parent, None if path is None else nodes

    assert not EXERCISE.judge(case, run_case(EXERCISE, rrt, case)).is_right
