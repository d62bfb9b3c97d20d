"""The judge of all planner exercises: it accepts the library's plans, and names what is wrong."""

import json

import numpy as np
import pytest

from kinoedu.course import EXERCISES
from kinoedu.course.feedback import Feedback
from kinoedu.course.judging import judge_case, judge_outcomes, run_case
from kinoedu.course.lessons.shared.planned import (
    TRAPS,
    ProblemShape,
    find_motion_off_tree,
    find_node_off_nearest,
    find_path_fault,
    find_tree_fault,
    problem_of,
)
from kinoedu.course.lessons.trees.exposing_room import is_connected
from kinoedu.course.watching import FAR, read_samples
from kinoedu.planners import rrt

WAYS = [name for name in TRAPS if name != "sealed"]


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", WAYS)
def test_what_the_library_builds_is_accepted(name, seed):
    """The path, the tree, the nearest node and the path along the tree are accepted."""
    problem = TRAPS[name]
    plan = rrt(problem.problem, step_size=1.0, goal_bias=0.1, max_iterations=5000, rng=seed)
    nodes, parent = plan.tree
    assert find_path_fault(problem, plan.path) is None
    assert find_tree_fault(problem, nodes, parent, 1.0) is None
    assert find_node_off_nearest(problem, nodes, parent) is None
    assert find_motion_off_tree(plan.path, nodes, parent) is None


@pytest.mark.parametrize("bits", [np.random.MT19937, np.random.Philox, np.random.SFC64])
def test_what_was_drawn_is_read_whatever_bits_a_generator_has(bits):
    """Some keep arrays in their states."""
    problem, rng = TRAPS["wall"].fresh_copy(), np.random.Generator(bits(3))
    samples = [problem.sample(rng) for _ in range(2)]
    run = read_samples(problem, 3)
    assert (run.samples.tolist(), run.generators) == (np.array(samples).tolist(), 1)
    assert run.others == 1, "only the first state is not that of the usual generator"


def test_a_wrong_path_is_named():
    """Each rule is broken by the least possible change."""
    problem = TRAPS["wall"]
    path = rrt(problem.problem, step_size=1.0, rng=0).path
    for rule, wrong in (
        ("start", path[1:]),
        ("goal", path[:-1]),
        ("start", path[::-1]),
        ("free", path[[0, -1]]),
        ("numbers", np.where(path == path[1], np.nan, path)),
        ("numbers", np.column_stack([path, path])),
        ("empty", path[:0]),
    ):
        assert find_path_fault(problem, wrong).rule == rule


def test_a_wrong_tree_is_named():
    """Each rule is broken by the least possible change."""
    problem = TRAPS["sealed"]
    nodes, parent = rrt(problem.problem, step_size=1.0, max_iterations=200, rng=0).tree
    assert find_tree_fault(problem, nodes, parent, 0.9).rule == "step"
    assert find_tree_fault(problem, nodes, parent + 1, 1.0).rule == "root"
    assert find_tree_fault(problem, nodes, parent[:-1], 1.0).rule == "parents"
    assert find_tree_fault(problem, nodes, np.maximum(parent, 0), 1.0).rule == "root"
    round_the_wall = rrt(TRAPS["wall"].problem, step_size=1.0, rng=0).tree.nodes
    star = np.where(np.arange(len(round_the_wall)) > 0, 0, -1)
    assert find_tree_fault(TRAPS["wall"], round_the_wall, star, 1e9).rule == "free"
    assert find_node_off_nearest(problem, nodes, np.where(parent < 0, -1, 0)).rule == "nearest"
    assert find_motion_off_tree(nodes[[0, 5]], nodes, np.arange(len(nodes)) - 1).rule == "along"


@pytest.mark.parametrize("name", list(TRAPS))
def test_a_problem_travels_and_reads_as_the_line_that_makes_it(name):
    """Through JSON, and through what a student copies; the copy has answered no query yet."""
    problem = TRAPS[name]
    sent = ProblemShape().decode(json.loads(json.dumps(ProblemShape().encode(problem))))
    copied = eval(repr(problem), {"problem_of": problem_of})
    assert (
        ProblemShape().encode(sent)
        == ProblemShape().encode(copied)
        == ProblemShape().encode(problem)
    )
    assert sent.counts() == {}


def test_whether_a_triangle_cuts_the_room():
    """Two parts, and one."""
    assert not is_connected((1, 1), (9.5, 9.5), [(8, 10.5), (10.5, 8), (10.5, 8.2)])
    assert is_connected((1, 1), (9.5, 9.5), [(8.5, 9.5), (10.5, 8), (10.5, 8.2)])


def judge_one(name, function):
    """Judge a program on a case with a wall."""
    exercise = EXERCISES[name]
    case = next(c for c in exercise.cases(np.random.default_rng(0)) if c.kind == "wall")
    return judge_case(exercise, case, run_case(exercise, function, case), 0).verdict


def test_a_sample_drawn_before_the_coin_or_with_all_the_others_is_right():
    """A program may draw a sample in every iteration, or draw all of them in advance."""

    class Replayed:
        """A problem with another method `sample`."""

        def __init__(self, problem):
            self.problem = problem

        def __getattr__(self, name):
            return getattr(self.problem, name)

    def in_advance(problem, step, iterations, rng):
        chance = np.random.default_rng(rng)
        samples = iter([problem.sample(chance) for _ in range(iterations)])
        replayed = Replayed(problem)
        replayed.sample = lambda rng: next(samples)
        return EXERCISES["rrt_connect"].right_answer(replayed, step, iterations, rng)

    assert judge_one("rrt_connect", in_advance).is_right

    def before_the_coin(problem, step, goal_bias, iterations, rng):
        chance = np.random.default_rng(rng)
        replayed = Replayed(problem)

        def sample(_):
            q = problem.sample(chance)
            return problem.goal if chance.random() < goal_bias else q

        replayed.sample = sample
        return EXERCISES["rrt"].right_answer(replayed, step, 0.0, iterations, rng)

    assert judge_one("rrt", before_the_coin).is_right


@pytest.mark.parametrize("name", ["rrt", "rrt_connect", "sampled_roadmap"])
def test_a_fault_of_the_third_call_is_shown_with_its_seed(name):
    """The seed that the student copies repeats the call that failed."""
    exercise = EXERCISES[name]
    case = next(c for c in exercise.cases(np.random.default_rng(0)) if c.kind == "wall")
    seed = case.given["rng"]

    def wrong_for_the_other_seed(*given):
        answer = list(exercise.right_answer(*given))
        if given[-1] == seed + FAR:
            answer[0] = np.array(answer[0])[:-1]
        return answer

    outcome = run_case(exercise, wrong_for_the_other_seed, case)
    assert not exercise.judge(case, outcome).is_right
    assert exercise.case_at_fault(case, outcome).given["rng"] == seed + FAR


def test_a_fault_of_the_third_calls_attempts_is_shown_with_its_seed():
    """The first call is right, and the third one gives up too early."""
    exercise = EXERCISES["rrt_on_terrain"]
    case = next(c for c in exercise.cases(np.random.default_rng(0)) if c.kind == "sealed")
    seed = case.given["rng"]

    def impatient_with_the_other_seed(*given):
        *others, failures, rng = given
        if rng == seed + FAR:
            failures //= 4
        return exercise.right_answer(*others, failures, rng)

    outcome = run_case(exercise, impatient_with_the_other_seed, case)
    assert exercise.judge(case, outcome).rule == "gave_up"
    assert exercise.case_at_fault(case, outcome).given["rng"] == seed + FAR


def test_nodes_of_one_number_have_a_picture():
    """Such nodes are no places, so the picture shows the problem alone."""
    exercise = EXERCISES["tree_roadmap"]
    case = next(one for one in exercise.fixed_cases if one.kind == "few")
    outcome = run_case(exercise, lambda *given: ([[1], [2]], [-1, 0]), case)
    feedback = Feedback(judge_outcomes(exercise, [case], [outcome]))
    assert not feedback.report.is_right
    assert feedback.picture() is not None
