"""Lesson 13: its exercises' problems and references against independent computations."""

import csv
import json
import math
from pathlib import Path

import numpy as np
import pytest
import shapely

from kinoedu.course.bank import Solutions
from kinoedu.course.drivable import REGION, DrivenProblemShape, DrivingProblem, drivable
from kinoedu.course.exercise import Case
from kinoedu.course.judging import judge_case, run_case
from kinoedu.course.lent_problem import PARAMETERS
from kinoedu.course.lessons import EXERCISES
from kinoedu.course.lessons.kinodynamic import (
    best_control,
    drives,
    fastest_drive,
    garages,
    heading_distance,
    kinodynamic_prm,
    kinodynamic_rrt,
)
from kinoedu.course.lessons.kinodynamic.driven_trees import find_drive_fault, find_near_goal
from kinoedu.curves.integrators import runge_kutta
from kinoedu.experiments import read_experiment
from kinoedu.robots.trajectory import DrivenTree
from kinoedu.spaces.angles import angle_difference, wrap_angle

HOUSE = Path(__file__).resolve().parent.parent.parent
EXPERIMENTS = HOUSE / "notebooks" / "experiments"
SOLUTION = HOUSE / "solutions" / "13_kinodynamic_planning.ipynb"


@pytest.mark.parametrize("name", garages.KINDS)
def test_a_problem_travels_and_reads_as_the_line_that_makes_it(name):
    """A problem survives JSON and `eval(repr(...))`, and `anew` resets its counts."""
    problem = garages.GARAGES[name]
    sent = DrivenProblemShape().decode(json.loads(json.dumps(DrivenProblemShape().encode(problem))))
    copied = eval(repr(problem), {"drivable": drivable})
    assert (
        DrivenProblemShape().encode(sent)
        == DrivenProblemShape().encode(copied)
        == DrivenProblemShape().encode(problem.fresh_copy())
    )
    problem.sample(np.random.default_rng(0))
    assert problem.fresh_copy().counts() == {}


def test_moves_agree_with_fine_steps_and_drives_are_cut_where_they_are_closest():
    """Moves agree with Runge-Kutta steps, and no step of a drive is closer than its cut."""
    problem, rng = garages.GARAGES["room"], np.random.default_rng(1)
    for _ in range(10):
        v, phi = problem.problem.control(rng)
        stepped = runge_kutta(problem.start, v, math.tan(phi) / 20, 7.0, 300)[-1]
        assert problem.move(problem.start, v, phi, 7.0) == pytest.approx(stepped, abs=1e-6)
        target = problem.near_goal(rng)
        assert math.dist(target[:2], problem.goal[:2]) <= REGION * 20
        v, phi, t = problem.best_drive(problem.start, target, rng)
        away = [
            problem.distance(problem.move(problem.start, v, phi, k * problem.longest / 30), target)
            for k in range(1, 31)
        ]
        assert problem.distance(problem.move(problem.start, v, phi, t), target) <= min(away) + 1e-9
        assert problem.is_free_drive(problem.start, v, phi, t)


def test_distances_of_poses_by_complex_numbers():
    """The difference of two headings is the angle of a quotient of complex numbers."""
    for case in heading_distance.HeadingDistance().cases(np.random.default_rng(5)):
        a, b, radian = case.given.values()
        turn = np.angle(np.exp(1j * (a[2] - b[2])))
        assert heading_distance.measure_distance(a, b, radian) == pytest.approx(
            np.linalg.norm([*(a - b)[:2], radian * turn])
        )


@pytest.mark.parametrize("seed", range(2))
def test_cases_of_the_best_control_are_as_stated(seed):
    """The reference agrees with brute force over all controls and steps."""
    for case in best_control.BestControl().cases(np.random.default_rng(seed)):
        problem, q, target, controls, t, n = case.given.values()
        away = np.array(
            [
                [problem.distance(problem.move(q, *u, k * t / n), target) for k in range(1, n + 1)]
                for u in controls
            ]
        )
        cuts = away.argmin(axis=1) + 1
        free = [problem.is_free_drive(q, *u, k * t / n) for u, k in zip(controls, cuts)]
        left = np.where(free, away.min(axis=1), np.inf)
        best = int(left.argmin())
        assert best_control.choose_best_control(*case.given.values()) == (
            (best, cuts[best]) if any(free) else None
        )


def test_fastest_drives_by_relaxing_again_and_again():
    """The reference agrees with the Bellman-Ford algorithm."""
    for case in fastest_drive.FastestDrive().cases(np.random.default_rng(3)):
        n, edges, _, durations, ends = case.given.values()
        time = np.where(np.arange(n) == 0, 0.0, np.inf)
        for _ in range(n):
            for (u, v), t in zip(edges, durations):
                time[v] = min(time[v], time[u] + t)
        way = fastest_drive.find_fastest(*case.given.values())
        least = time[ends].min(initial=np.inf)
        assert (way is None) == (least == np.inf)
        if way is not None:
            found = fastest_drive.measure_duration(way, edges, durations)
            assert found == pytest.approx(least)


def test_replayed_trees_touch_nothing():
    """Along every drive of a tree among posts the car touches none of them, by shapely."""
    problem = garages.GARAGES["thin"]
    parent, controls, durations, path = kinodynamic_rrt.grow_tree(problem, 80, 4)
    tree = DrivenTree(None, np.array(parent), np.array(controls), np.array(durations))
    fault, nodes = find_drive_fault(problem, tree)
    assert fault is None
    solid = shapely.union_all([shapely.Polygon(post) for post in garages.POSTS])
    for i in range(1, len(nodes)):
        for t in np.linspace(0.0, durations[i], 12):
            x, y, theta = problem.move(nodes[parent[i]], *controls[i], t)
            turn = np.array(
                [[math.cos(theta), math.sin(theta)], [-math.sin(theta), math.cos(theta)]]
            )
            assert not shapely.Polygon(garages.CAR.outline @ turn + (x, y)).intersects(solid)
    assert path[0] == 0
    assert [parent[b] for b in path[1:]] == list(path[:-1])


@pytest.mark.parametrize(
    ("change", "rule"),
    [
        ({"parent": []}, "lengths"),
        ({"controls": [(0.0, 0.0)]}, "lengths"),
        ({"durations": [0.0]}, "lengths"),
        ({"parent": [0, 0]}, "root"),
        ({"controls": [(2.0, 0.0), (2.0, 0.0)]}, "root"),
        ({"durations": [1.0, 1.0]}, "root"),
        ({"parent": [-1, -1]}, "parents"),
        ({"parent": [-1, 1]}, "parents"),
        ({"controls": [(0.0, 0.0), (1.0, 0.0)]}, "control"),
        ({"controls": [(0.0, 0.0), (2.0, 0.8)]}, "control"),
        ({"controls": [(0.0, 0.0), (2.0, math.nan)]}, "control"),
        ({"durations": [0.0, 0.0]}, "duration"),
        ({"durations": [0.0, -1.0]}, "duration"),
        ({"durations": [0.0, math.nan]}, "duration"),
        ({"durations": [0.0, 7.51]}, "duration"),
        ({}, None),
    ],
)
def test_a_drive_that_breaks_a_rule_is_told_which(change, rule):
    """One drive from the start: its number, its parent, its control or its duration is wrong."""
    tree = {"parent": [-1, 0], "controls": [(0.0, 0.0), (2.0, 0.0)], "durations": [0.0, 7.5]}
    lists = {name: np.array(value) for name, value in (tree | change).items()}
    fault, nodes = find_drive_fault(garages.GARAGES["far"], DrivenTree(None, **lists))
    assert (fault and fault.rule) == rule
    assert len(nodes) == (2 if rule is None else 1)


def test_near_enough_is_judged_across_pi():
    """A goal with the heading pi is reached from both sides."""
    problem = garages.GARAGES["seam"]
    x, y, _ = problem.goal
    poses = np.array(
        [
            (x, y, math.pi - 0.2),
            (x, y, -math.pi + 0.2),
            (x, y, math.pi - 0.3),
            (x + 5.1, y, math.pi),
        ]
    )
    assert find_near_goal(problem, poses).tolist() == [0, 1]
    assert abs(angle_difference(wrap_angle(math.pi - 0.2), -math.pi)) == pytest.approx(0.2)


@pytest.mark.parametrize("name", garages.OPEN)
def test_no_wall_can_be_reached_in_the_open(name):
    """All drives together are shorter than the distance to the nearest wall."""
    problem, world = garages.GARAGES[name], garages.GARAGES[name].problem.world
    reach = drives.ITERATIONS[name] * problem.longest * np.abs(garages.CAR.speeds).max() + 30.0
    assert (world.lo + reach < problem.start[:2]).all()
    assert (problem.start[:2] < world.hi - reach).all()


@pytest.mark.parametrize("name", garages.OPEN)
def test_goal_and_region_may_both_have_the_turns_of_both(name, monkeypatch):
    """In iterations 28, 56, ... the goal is as right a target as its region."""

    def goal_first(problem, turn, rng):
        if turn % 4 == 0:
            return problem.goal
        return problem.near_goal(rng) if turn % 7 == 0 else problem.sample(rng)

    for module in (kinodynamic_prm, kinodynamic_rrt):
        monkeypatch.setattr(module, "choose_target", goal_first)
    tree, roadmap = kinodynamic_rrt.KinodynamicRrt(), kinodynamic_prm.KinodynamicPrm()
    for exercise, more in ((tree, {}), (roadmap, {"k": 2})):
        case = Case(
            name,
            {
                "problem": garages.GARAGES[name],
                **more,
                "iterations": drives.ITERATIONS[name],
                "rng": 3,
            },
        )
        value = exercise.answer.encode(exercise.call(exercise.source, case.given))
        assert exercise.fault_of_three(case, exercise.answer.decode(value)) is None


@pytest.mark.parametrize(
    ("kind", "changes", "rule"),
    [
        ("same", ("[:k]", "[:1]"), "each"),
        ("same", ("[:k]", "[:k + 1]"), "iterations"),
        (
            "room",
            ("target, rng)\n", "target, rng) or problem.best_drive(nodes[near], target, rng)\n"),
            "twice",
        ),
    ],
)
def test_a_number_of_drives_that_is_not_k_has_a_rule_of_its_own(kind, changes, rule):
    """Too few drives in a turn, too many, and two from one node."""
    program = Solutions(SOLUTION).changed("kinodynamic_prm", changes).function
    exercise = EXERCISES["kinodynamic_prm"]
    case = next(one for one in exercise.fixed_cases if one.kind == kind)
    assert judge_case(exercise, case, run_case(exercise, program, case), 0).verdict.rule == rule


def test_the_stored_table_is_of_the_experiment_beside_it():
    """The table has the problems, planners and seeds of the experiment, and every run."""
    experiment = read_experiment(EXPERIMENTS / "driving.toml")
    with open(EXPERIMENTS / "driving.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    wanted = {
        (p, c.name, str(seed))
        for p in experiment.problems
        for c in experiment.contestants
        for seed in experiment.seeds
    }
    assert {(row["problem"], row["planner"], row["seed"]) for row in rows} == wanted
    assert {row["status"] for row in rows} == {"found", "no path"}


@pytest.mark.parametrize("name", ["driving_tuning", "driving_obstacles"])
def test_the_other_experiments_can_be_read(name):
    """Every file that an experiment names exists, and every argument is known."""
    assert len(read_experiment(EXPERIMENTS / f"{name}.toml").contestants) >= 2


def test_arguments_of_a_problems_methods_may_be_named():
    """By the names that the exercises use, as for a problem made in a cell; other names are not."""
    problem = garages.GARAGES["room"].fresh_copy()
    lent, q = problem.lend(), problem.start
    first, second = np.random.default_rng(1), np.random.default_rng(1)
    assert lent.best_drive(q=q, rng=first, target=lent.goal) == problem.best_drive(
        q, problem.goal, second
    )
    assert (lent.sample(rng=first) == problem.sample(second)).all()
    assert (lent.move([1, 2, 0], 2, phi=0, t=5) == [11, 2, 0]).all()
    assert lent.distance(b=lent.goal, a=q) == problem.distance(q, problem.goal)
    for given, named in (((q, 2, 0), {"time": 5}), ((q, 2), {"phi": 0}), ((q, 2, 0, 5, 1), {})):
        with pytest.raises(TypeError, match=r"problem.is_free_drive takes \(q, v, phi, t\)"):
            lent.is_free_drive(*given, **named)
    assert set(DrivingProblem.QUESTIONS) == set(PARAMETERS)
