"""The exercises of lesson 2: what a walk may choose at a wall, and each rule that it may break."""

import numpy as np
import pytest

from kinoedu.course.lessons import find
from kinoedu.geometry.leash import densify_path
from kinoedu.planners import bug1

EXERCISE = find("bug1")
MANY = next(case for case in EXERCISE.fixed_cases if case.kind == "many")
STEP = MANY.given["step"]
LEFT, RIGHT = (bug1(*MANY.given.values(), turn=turn).walk for turn in ("left", "right"))
WALK = densify_path(LEFT.points, STEP)


def judge_walk(points, variant=""):
    """The rule that a walk breaks in the world of two obstacles, or ""."""
    return find("bug1", variant).value_verdict(MANY, points).rule


@pytest.mark.parametrize(("first", "then"), [(LEFT, RIGHT), (RIGHT, LEFT)], ids=["left", "right"])
def test_the_turn_may_differ_from_wall_to_wall(first, then):
    """Where no contract names it: both turns of Bug 1 leave a wall at the same point."""
    points = np.vstack([first.points[: first.hit[1]], then.points[then.hit[1] :]])
    walk = densify_path(points, STEP)
    assert judge_walk(walk) == ""
    assert {judge_walk(walk, variant) for variant in EXERCISE.variants} == {"contract"}


@pytest.mark.parametrize(
    ("change", "rule"),
    [
        (lambda walk: walk, ""),
        (lambda walk: walk[:0], "start"),
        (lambda walk: walk[1:], "start"),
        (lambda walk: np.where(walk == walk[9], np.nan, walk), "start"),
        (lambda walk: np.repeat(walk[:1], 3, axis=0), "same"),
        (lambda walk: np.delete(walk, 5, axis=0), "jump"),
        (lambda walk: walk[:-2], "goal"),
        (lambda walk: walk[:-9], "unfinished"),
    ],
)
def test_a_walk_breaks_one_rule(change, rule):
    """From the start, in steps, to within a step of the goal, with nothing left out."""
    assert judge_walk(change(WALK)) == rule
