"""A share of the ten thousand random problems of benchmarks/validity.py, and whether its judge
would see an invalid path.
"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import kinoedu as ke

sys.path.append(str(Path(__file__).resolve().parent.parent / "benchmarks"))

from certify import is_valid
from optimality import crowded, gaps
from random_problems import WORLDS
from validity import KINDS, outcome

# Last digits of the seeds of problems that are solved after few nodes: two for each robot in each
# world, and the cars that kinodynamic RRT and hybrid A* drive. Without a path nothing is judged.
# fmt: off
SOLVED = [
    1, 2, 3, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 18, 20, 21, 22, 23, 24, 26, 27, 28, 29, 32, 33,
    34, 53, 54, 58, 60, 66, 67, 71, 77, 169, 181,
]
# fmt: on
DRIVEN = {
    "kinodynamic RRT": (3, 33, 129, 327, 387, 399),
    "hybrid A*": (3, 27, 39, 63, 69, 81, 93, 99, 111, 159, 195, 213),
}


@pytest.mark.parametrize("planner", ["RRT", "RRT-Connect"])
def test_no_path_is_invalid(planner):
    """All robots, all worlds."""
    outcomes = [outcome(1_000_000 + k, [planner]) for k in SOLVED]
    assert len({one.setting for one in outcomes}) == KINDS
    assert [one for one in outcomes if not (one.solved and one.valid)] == []


def test_no_exact_path_is_invalid():
    """A point among polygons that lie over each other; visibility's paths may touch."""
    outcomes = [
        outcome(seed, ["visibility", "decomposition"]) for seed in range(0, 100 * KINDS, KINDS)
    ]
    assert [one for one in outcomes if not one.valid] == []
    assert sum(one.solved for one in outcomes) > 50


@pytest.mark.parametrize("planner", DRIVEN)
def test_no_drive_of_a_car_is_invalid(planner):
    """Cars that go both ways, and some that only go forward, in all worlds."""
    outcomes = [outcome(2_000_000 + k, [planner]) for k in DRIVEN[planner]]
    assert len({one.setting for one in outcomes}) == len(WORLDS)
    assert [one for one in outcomes if not (one.solved and one.valid)] == []


SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
HAIR = [(5, 0), (5 + 1e-8, 0), (5 + 1e-8, 8), (5, 8)]
SLIVER = [(2, 4), (3, 4), (2, 4 + 1e-8)]  # within the arm's reach on one side
L_SHAPE = [(-0.5, -0.2), (0.6, -0.2), (0.6, 0.1), (-0.2, 0.1), (-0.2, 0.7), (-0.5, 0.7)]
ROBOTS = [
    (ke.Point(), (1, 1), (9, 1)),
    (ke.Disk(0.4), (1, 1), (9, 1)),
    (ke.TranslatingPolygon(L_SHAPE), (1, 1), (9, 1)),
    (ke.RigidPolygon(L_SHAPE), (1, 1, 0), (9, 1, 3)),
    (ke.TwoLinkArm(1.5, 1, 0.1, base=(4, 4)), (2.0, 0.3), (-2.0, -0.3)),
]


@pytest.mark.parametrize(
    ("robot", "start", "goal"), ROBOTS, ids=["point", "disk", "sliding", "turning", "arm"]
)
def test_the_judge_sees_a_wall_a_hair_thin(robot, start, goal):
    """The straight motion through it, which no fixed step would find, and a cost or an end that is
    not the plan's own.
    """
    world = ke.PolygonWorld(SQUARE, [SLIVER if hasattr(robot, "lengths") else HAIR])
    problem = ke.Problem(robot, world, start, goal)
    straight = ke.Plan(
        np.array([problem.start, problem.goal]),
        problem.distance(problem.start, problem.goal),
        problem=problem,
    )
    assert not is_valid(straight)
    free = ke.rrt_connect(problem, rng=0)
    assert is_valid(free)
    assert not is_valid(replace(free, cost=free.cost * 1.001))
    assert not is_valid(replace(free, path=free.path[:-1]))


def test_the_judge_sees_what_is_wrong_with_a_drive():
    """Through a wall a hair thin; not as long as it says; another way than its controls lead; a
    goal that it does not reach.
    """
    car, world = ke.Car(1.2, 0.5, 0.8), ke.PolygonWorld(SQUARE, [HAIR])
    problem, open_problem = (
        ke.Problem(car, place, (1, 1, 0), (8, 1, 0)) for place in (world, ke.PolygonWorld(SQUARE))
    )
    through, free = ke.hybrid_astar(open_problem), ke.hybrid_astar(problem)
    assert is_valid(through) and is_valid(free) and is_valid(ke.rrt(problem, rng=0))
    assert not is_valid(replace(through, problem=problem))
    assert not is_valid(replace(free, cost=free.cost * 1.001))
    assert not is_valid(replace(free, path=free.path + np.array([0.0, 1e-3, 0.0])))
    assert not is_valid(replace(free, problem=ke.Problem(car, world, (1, 1, 0), (8, 1, 0.1))))
    assert not is_valid(
        replace(
            free,
            problem=ke.Problem(ke.Car(1.2, 0.5, 0.8, speeds=[2.0]), world, (1, 1, 0), (8, 1, 0)),
        )
    )


def test_touching_is_semi_free_and_not_free():
    """Along a wall's edge and round its corner; through its inside is neither."""
    world = ke.PolygonWorld(SQUARE, [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    plan = ke.plan_by_visibility(ke.Problem(ke.Point(), world, (1, 1), (9, 1)))
    assert is_valid(plan, semi_free=True) and not is_valid(plan)
    lower = plan.path - [(0, 0), (0, 1e-6), (0, 1e-6), (0, 0)]
    cost = float(np.sqrt((np.diff(lower, axis=0) ** 2).sum(axis=1)).sum())
    assert not is_valid(replace(plan, path=lower, cost=cost), semi_free=True)


def test_more_samples_come_closer_to_the_shortest_path():
    """RRT* over a few worlds: never below the visibility roadmap's, and its median gap shrinks."""
    cases = [crowded(seed) for seed in range(3)]
    few, many = (np.median(gaps("RRT*", n, cases, range(4))) for n in (300, 2000))
    assert 0.0 <= many < few and many < 0.1
