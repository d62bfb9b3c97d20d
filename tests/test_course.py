"""The exercises: what check() says about right and wrong answers, and the encoding of both."""

import contextlib
import gc
import json
import linecache
import random
import re
import shutil
import sys
import threading
import tomllib
from fractions import Fraction
from html import escape
from pathlib import Path

import numpy as np
import pytest

from kinoedu import messages
from kinoedu.course import EXERCISES, ValueExercise, check, outcomes
from kinoedu.course.advice import COMMON_ERRORS
from kinoedu.course.bank import Solutions
from kinoedu.course.feedback import Feedback, fold_line, html_entry
from kinoedu.course.judging import judge_outcomes, run_case
from kinoedu.course.lent_problem import LentProblem
from kinoedu.course.outcomes import (
    Answer,
    Changed,
    Late,
    Misshapen,
    Raised,
    decode_outcome,
    encode_outcome,
)
from kinoedu.course.tasks import scene_of
from kinoedu.errors import InvalidParameter
from kinoedu.sampling import dispersion

HOUSE = Path(__file__).resolve().parent.parent


@pytest.fixture(autouse=True, scope="module")
def short_time():
    """Stop programs that never end after a short time."""
    with pytest.MonkeyPatch.context() as patch:
        for exercise in EXERCISES.values():
            patch.setattr(type(exercise), "seconds", 2.0)
        yield


def judged(exercise, function, seed=0):
    """Report on a function of the course, which may look behind what a problem lends."""

    def called(*given):
        return function(
            *(one._ask.__self__ if isinstance(one, LentProblem) else one for one in given)
        )

    cases = list(exercise.cases(np.random.default_rng(seed)))
    return judge_outcomes(exercise, cases, (run_case(exercise, called, case) for case in cases))


@pytest.mark.parametrize(
    "exercise", [e for e in EXERCISES.values() if e.source], ids=lambda e: e.name
)
def test_the_reference_is_accepted_and_every_kind_is_asked(exercise):
    """The library's own function passes, and every kind of input has many cases.

    Other seeds are tried on the solutions, in test_release.py.
    """
    report = judged(exercise, exercise.right_answer)
    assert report.is_right, report.failure
    assert report.score == 1.0
    assert min(report.survived.values()) >= (10 if isinstance(exercise, ValueExercise) else 2)


@pytest.mark.parametrize("exercise", EXERCISES.values(), ids=list(EXERCISES))
def test_cases_are_the_same_for_the_same_seed_and_others_for_another(exercise):
    """Cases depend on the seed alone."""
    first, again, other = (
        [
            json.dumps([case.kind, exercise.given.encode(case.given)])
            for case in exercise.cases(np.random.default_rng(seed))
        ]
        for seed in (1, 1, 2)
    )
    assert first == again
    assert first != other or not exercise.given.fields


def test_what_a_function_of_an_exercise_answers_to_a_case_is_computed_once():
    """Also where it refuses; a case with equal arguments is another case."""
    exercise, asked = EXERCISES["point_line_distance"], []

    def ask(q, p1, p2):
        asked.append(q)
        if (p1 == p2).all():
            raise ValueError("one point")
        return len(asked)

    cases = exercise.fixed_cases
    answers = [exercise.answer_of(ask, case, ValueError) for case in (*cases, *cases)]
    assert answers[: len(cases)] == answers[len(cases) :]
    assert len(asked) == len(cases) and {type(answer) for answer in answers} == {int, ValueError}
    exercise.answer_of(ask, cases[0]._replace(), ValueError)
    assert len(asked) == len(cases) + 1


def test_a_problem_is_built_once_and_every_call_has_its_own_log():
    """Decoding a case again gives the same problem, in which nothing has been asked."""
    exercise = EXERCISES["rrt"]
    case = exercise.fixed_cases[0]
    data = exercise.given.encode(case.given)
    first, again = (exercise.given.decode(data)["problem"] for _ in range(2))
    first.sample(np.random.default_rng(0))
    assert first.problem is again.problem
    assert (len(first.draws), len(again.draws)) == (1, 0)
    assert first.counts() == {"sample": 1} and again.counts() == {}


ALSO_RIGHT = {
    "line_through_points": [
        lambda p1, p2: -np.array(EXERCISES["line_through_points"].source(p1, p2)),
        lambda p1, p2: list(EXERCISES["line_through_points"].source(p2, p1)),
    ],
    "point_segment_distance": [
        lambda *given: np.array(EXERCISES["point_segment_distance"].source(*given))
    ],
    "polygon_tangent": [
        lambda *given: list(map(np.float32, EXERCISES["polygon_tangent"].source(*given)))
    ],
    "free_heading": [
        lambda problem, x, y: next(
            (t for t in np.arange(0, 2 * np.pi, 0.199) if problem.is_free(np.array([x, y, t]))),
            None,
        )
    ],
    "bfs_tree": [
        lambda neighbours, start: EXERCISES["bfs_tree"].source(
            [row[::-1] for row in neighbours], start
        ),
        lambda neighbours, start: np.array(tree_of_last_parents(neighbours, start)),
    ],
    "extract_path": [
        lambda parent, goal: EXERCISES["extract_path"].source(tuple(parent), np.int64(goal))
    ],
    "bfs_path": [
        lambda neighbours, start, goal: EXERCISES["bfs_path"].source(
            [row[::-1] for row in neighbours], start, goal
        )
    ],
    "dfs_path": [lambda *given: EXERCISES["bfs_path"].source(*given)],
    "dijkstra": [
        lambda *given: relaxed_again_and_again(*given),
        lambda *given: np.array(EXERCISES["dijkstra"].source(*given)),
    ],
    "astar": [
        lambda n, w, estimate, start, goal: EXERCISES["astar"].source(
            n, w, [0.0] * len(n), start, goal
        )
    ],
    "misleading_estimate": [
        lambda: ([[1, 2], [2], []], [[1, 3], [1], []], [0, 3, 0], 0, 2),
        lambda: (
            [[1, 2], [0, 2], [0, 1]],
            [[4.5, 1], [4.5, 1], [1, 1]],
            np.array([0.0, 0.0, 9.0]),
            np.int64(0),
            1,
        ),
    ],
    "exposing_problem": [
        lambda: ((-4, 0.5), (10, 0), [[(8, 5), (0, 3), (6, 3), (6, -2)]]),
        lambda: (np.array([-9, 1]), [10, 0], (np.array([(6, -2), (6, 3), (0, 3), (8, 5)]),)),
    ],
    "exposing_world": [
        lambda: [(0, 2), (5, 0), (5, 3), (9, 5), (5, 9), (5, 4)],
        lambda: np.array([(0, 0), (10, -1), (5, 3), (10, 9), (0, 10), (5, 4)])[::-1],
    ],
    "degrees_of_freedom": [
        lambda bodies, joints: np.int64(EXERCISES["degrees_of_freedom"].source(bodies, joints))
    ],
    "rotation": [lambda theta: np.array(EXERCISES["rotation"].source(theta - 2 * np.pi)).tolist()],
    "displacement": [lambda *given: tuple(map(tuple, EXERCISES["displacement"].source(*given)))],
    "forward_kinematics": [
        lambda *given: [tuple(place) for place in EXERCISES["forward_kinematics"].source(*given)]
    ],
    "inverse_kinematics": [
        lambda *given: [
            tuple(q) for q in EXERCISES["inverse_kinematics"].source(*given)[::-1] + 2 * np.pi
        ],
        lambda *given: [
            *EXERCISES["inverse_kinematics"].source(*given),
            *EXERCISES["inverse_kinematics"].source(*given) - 2 * np.pi,
        ],
    ],
    "circle_distance": [
        lambda a, b: np.arccos(np.cos(a - b)),
        lambda a, b: abs(np.angle(np.exp(1j * (a - b)))),
    ],
    "torus_distance": [lambda a, b: np.linalg.norm(np.remainder(a - b + np.pi, 2 * np.pi) - np.pi)],
    "exposing_reach": [
        lambda: [1, 1.1, (0, 0.4)],
        lambda: (np.float64(50.0), 55, np.array([-9.0, 3.0])),
        lambda: (1.13, 1.243, (0.3, 0.2)),  # a tenth longer, as the numbers are written
    ],
    "corner_grid": [lambda n, d: EXERCISES["corner_grid"].source(n, d)[::-1].tolist()],
    "sukharev_grid": [
        lambda n, d: tuple(map(tuple, EXERCISES["sukharev_grid"].source(n, d)[:, ::-1]))
    ],
    "uniform_random": [
        lambda n, d, rng: [
            [chance.random() for _ in range(d)] for chance in [random.Random(rng)] for _ in range(n)
        ],
        lambda n, d, rng: np.random.RandomState(rng).uniform(size=(d, n)).T,
    ],
    "radical_inverse": [
        lambda i, base: np.float64(EXERCISES["radical_inverse"].right_answer(i, base))
    ],
    "halton": [lambda n, primes: EXERCISES["halton"].source(n, tuple(primes)).tolist()],
    "dispersion_bounds": [
        lambda points: bounds_by_probes(points, 36),
        lambda points: np.array(bounds_by_probes(points, 100)),
        lambda points: (np.nextafter(dispersion(points), 2.0), dispersion(points)),
    ],
    "exposing_corridor": [lambda: [0, 1 / 32, 1, 1 / 16], lambda: np.array([31 / 32, 0, 1, 1])],
    "segment_intersection": [
        lambda *given: EXERCISES["segment_intersection"].source(*given)[::-1],
        lambda *given: EXERCISES["segment_intersection"].source(*given).tolist(),
    ],
    "point_in_convex_polygon": [
        lambda q, P: np.bool_(EXERCISES["point_in_convex_polygon"].source(q, P))
    ],
    "c_obstacle": [
        lambda *given: EXERCISES["c_obstacle"].source(*given)[::-1].tolist(),
        lambda *given: with_straight_angles(
            np.roll(EXERCISES["c_obstacle"].source(*given), 2, axis=0)
        ),
    ],
    "link_in_contact": [lambda *given: np.int64(EXERCISES["link_in_contact"].source(*given))],
    "plot_environment": [
        lambda *given: drawn_in_pieces(*given),
        lambda *given: drawn_link_by_link(*given),
        lambda *given: drawn_by_transforms(*given),
    ],
    "plot_configuration_space": [
        lambda *given: scattered_dots(*given),
        lambda *given: dots_by_numbers(*given),
    ],
    "rrt": [
        lambda *given: tuple(
            None if part is None else np.array(part).tolist()
            for part in EXERCISES["rrt"].source(*given)
        )
    ],
    "insert": [
        lambda *given: [np.array(numbers) for numbers in EXERCISES["insert"].source(*given)]
    ],
    "follow": [lambda *given: [tuple(q) for q in EXERCISES["follow"].source(*given)]],
    "move": [
        lambda *given: [
            *EXERCISES["move"].source(*given)[:2],
            np.float64(EXERCISES["move"].source(*given)[2] - 4 * np.pi),
        ]
    ],
    "exposing_motions": [lambda: ((0, 1), (0, 1), (-95, 1.1), (95, 1.1))],
    "exposing_drive": [
        lambda: [-0.1, np.float64(700)],
        lambda: (np.array(0.08), 1000),
        lambda: np.array([0.1, 1000], np.float32),
    ],
    "exposing_room": [
        lambda: [(1, 1), np.array([9.5, 9.5]), np.array([(8, 10.5), (10.5, 8), (10.5, 8.2)])]
    ],
    "overlooked_gap": [lambda: (np.array([(0, 0), (-1, -4), (-1, 4)]), [(1, -9), (9, 0), (1, 9)])],
    "compare_planners": [
        lambda *given: EXERCISES["compare_planners"].right_answer(*given).tolist()
    ],
    "repeated_rows": [
        lambda table: np.array(EXERCISES["repeated_rows"].source(table)[::-1]).reshape(-1, 3)
    ],
    "cost_along": [lambda cost, a, b: np.float64(EXERCISES["cost_along"].source(cost, b, a))],
    "rrt_on_terrain": [
        lambda *given: rrt_with_test(f"({ARRIVES}).all()").function(*given),
        lambda *given: rrt_with_test(f"{IS_NEAR} and ({ARRIVES}).all()").function(*given),
        lambda *given: rrt_with_test(
            f"({IS_NEAR} if len(nodes) == 1 else ({ARRIVES}).all())"
        ).function(*given),
    ],
    "prm_on_terrain": [
        lambda *given: [
            np.array(x)[:, ::-1] if i == 1 else x for i, x in enumerate(prm_answer(*given))
        ]
    ],
    "exposing_motion": [
        lambda: (np.array([[1, 0], [1, 1]], bool), [0.9985, 0.6485], np.array([1.5, 1.15])),
        lambda: ([(True, False), (True, 1)], (0.9985, 0.6485), (1.5, 1.15)),
        lambda: (list(np.array([[2, 0], [1, 1]]) > 0), (0.9985, 0.6485), (1.5, 1.15)),
        lambda: ([[*row] for row in np.array([[2, 0], [1, 1]]) > 0], (0.9985, 0.6485), (1.5, 1.15)),
    ],
    "visibility_roadmap": [lambda *given: seen_in_another_order(*given)],
    "radius_neighbours": [
        lambda *given: [tuple(pair) for pair in EXERCISES["radius_neighbours"].source(*given)[::-1]]
    ],
    "k_closest": [lambda *given: EXERCISES["k_closest"].source(*given)[::-1].tolist()],
    "component_k_closest": [
        lambda *given: tuple(map(tuple, EXERCISES["component_k_closest"].source(*given)[::-1]))
    ],
    "sampled_roadmap": [
        lambda *given: [
            list(part[::-1]) if i else part
            for i, part in enumerate(EXERCISES["sampled_roadmap"].source(*given))
        ]
    ],
    "shortest_path": [lambda *given: EXERCISES["shortest_path"].source(*given)],
    "exposing_sight": [
        lambda: [np.array([(6, 0), (3, 2), (0, 0), (1, -1), (2, 0)])],
        lambda: ([[-9, 0], [-7, -1], [-6, 0], [0, 0], [-3, 2]],),
    ],
    "exposing_case": [
        lambda: (np.array([1, 2]), np.array([(4, 2), (0, 4), (0, 0)])),
        lambda: ([1, 2], [[0, 4], [4, 2], [0, 0]]),
    ],
}


IS_NEAR = "problem.distance(nodes[-1], goal) <= step"
ARRIVES = "problem.steer(nodes[-1], goal, step) == goal"


def rrt_with_test(test, *changes):
    """The RRT on a terrain with another test whether the goal is within a step, such as a steer."""
    solutions = Solutions(HOUSE / "solutions" / "10_terrains.ipynb")
    return solutions.changed("rrt_on_terrain", (IS_NEAR, test), *changes)


@pytest.mark.parametrize(
    ("change", "rule"),
    [
        ((">= spacing", ">= 1.3 * spacing"), "left_out"),
        (("failed < failures", "failed < 2 * failures"), "went_on"),
    ],
)
@pytest.mark.parametrize("near", ["", f"{IS_NEAR} and "])
def test_a_tree_that_steers_to_test_for_the_goal_is_still_judged(near, change, rule):
    """The targets of its samples are known, and all that it leaves out of these."""
    exercise = EXERCISES["rrt_on_terrain"]
    case = next(one for one in exercise.cases(np.random.default_rng(0)) if one.kind == "sealed")
    program = rrt_with_test(f"{near}({ARRIVES}).all()", change).function
    assert exercise.judge(case, run_case(exercise, program, case)).rule == rule


def prm_answer(*given):
    """The course's own roadmap, with nodes and edges as lists."""
    return EXERCISES["prm_on_terrain"].source(*given)


def bounds_by_probes(points, m):
    """The distance of the farthest of m x m probes, and half the diagonal of a cell more."""
    along = (np.arange(m) + 0.5) / m
    probes = np.stack(np.meshgrid(along, along), axis=-1).reshape(-1, 1, 2)
    low = np.sqrt(((probes - points) ** 2).sum(axis=2)).min(axis=1).max()
    return low, low + np.sqrt(2) / (2 * m)


def with_straight_angles(ring):
    """A polygon with an additional vertex in the middle of each edge."""
    return np.column_stack([ring, (ring + np.roll(ring, -1, axis=0)) / 2]).reshape(-1, 2)


def drawn_in_pieces(q, lengths, width, discs, ax):
    """A drawing with links of a rectangle and two circles, disc patches, and separate joints."""
    from matplotlib.patches import Circle, Rectangle

    start, heading = np.zeros(2), 0.0
    ax.plot(0, 0, "rs", label="joints")
    for number, (angle, size) in enumerate(zip(q, lengths), 1):
        heading += angle
        along = np.array([np.cos(heading), np.sin(heading)])
        corner, degrees = start + width / 2 * np.array([along[1], -along[0]]), np.degrees(heading)
        ax.add_patch(Rectangle(corner, size, width, angle=degrees, label=f"link {number}"))
        for end in (start, start + size * along):
            ax.add_patch(Circle(end, width / 2, label=f"link {number}"))
        start = start + size * along
        ax.plot(*start, "rs", label="joints")
    for x, y, r in discs:
        ax.add_patch(Circle((x, y), r, label="disc"))


def drawn_by_transforms(q, lengths, width, discs, ax):
    """A drawing of shapes along the x-axis that matplotlib turns and moves to their places."""
    from matplotlib.patches import Circle, Rectangle
    from matplotlib.transforms import Affine2D

    place = Affine2D()
    ax.plot(0, 0, "rs", label="joints")
    for number, (angle, size) in enumerate(zip(q, lengths), 1):
        place = Affine2D().rotate(angle) + place
        placed = {"label": f"link {number}", "transform": place + ax.transData}
        ax.add_patch(Rectangle((0, -width / 2), size, width, **placed))
        for end in (0, size):
            ax.add_patch(Circle((end, 0), width / 2, **placed))
        place = Affine2D().translate(size, 0) + place
        ax.plot(0, 0, "rs", label="joints", transform=place + ax.transData)
    for x, y, r in discs:
        moved = Affine2D().translate(x, y) + ax.transData
        ax.add_patch(Circle((0, 0), r, label="disc", transform=moved))


def scattered_dots(samples, lengths, width, discs, ax):
    """One scatter plot of all dots, with angles from -pi to pi, in other shades."""
    q = 2 * np.pi * samples
    links = [EXERCISES["link_in_contact"].source(one, lengths, width, discs) for one in q]
    ax.scatter(
        *np.where(q > np.pi, q - 2 * np.pi, q).T,
        c=[("tab:blue", "k", "#c00000")[link] for link in links],
    )


def drawn_link_by_link(q, lengths, width, discs, ax):
    """A drawing with joints that are dots on lines, in which each link draws both of its ends."""
    drawn_in_pieces(q, lengths, width, discs, ax)
    base, elbow, tip = [dot.get_xydata()[0] for dot in ax.lines]
    for dot in list(ax.lines):
        dot.remove()
    for ends in ((base, elbow), (elbow, tip)):
        ax.plot(*np.transpose(ends), "o-", label="joints")


def dots_by_numbers(samples, lengths, width, discs, ax):
    """One scatter plot with a number for each dot and a map from numbers to colours."""
    from matplotlib.colors import ListedColormap

    q = 2 * np.pi * samples
    links = [EXERCISES["link_in_contact"].source(one, lengths, width, discs) for one in q]
    ax.scatter(*q.T, c=links, cmap=ListedColormap(["blue", "black", "red"]), vmin=0, vmax=2)


def seen_in_another_order(problem, obstacles):
    """The corners from the last to the first."""
    nodes, pairs = EXERCISES["visibility_roadmap"].source(problem, obstacles)
    order = np.array([0, 1, *range(len(nodes) - 1, 1, -1)])
    return nodes[order].tolist(), np.sort(np.argsort(order)[pairs], axis=1)[::-1]


def tree_of_last_parents(neighbours, start):
    """A breadth-first tree that prefers the parent seen last."""
    far, level = {start: 0}, [start]
    parent = [-1] * len(neighbours)
    while level:
        new = []
        for v in level:
            for u in neighbours[v]:
                if u not in far:
                    far[u] = far[v] + 1
                    new.append(u)
                if far[u] == far[v] + 1:
                    parent[u] = v
        level = new
    return parent


def relaxed_again_and_again(neighbours, weights, start):
    """The costs by the Bellman-Ford algorithm, which is right as well."""
    if min((w for row in weights for w in row), default=0.0) < 0:
        raise ValueError("negative")
    cost = [np.inf] * len(neighbours)
    cost[start] = 0
    for _ in neighbours:
        for u, row in enumerate(neighbours):
            for v, w in zip(row, weights[u], strict=True):
                cost[v] = min(cost[v], cost[u] + w)
    return cost


@pytest.mark.parametrize(
    ("name", "number"),
    [(name, i) for name, programs in ALSO_RIGHT.items() for i in range(len(programs))],
)
def test_other_right_answers_are_accepted(name, number):
    """A line of either sign, tuples, lists, numpy's numbers, and either orientation are right."""
    assert judged(EXERCISES[name], ALSO_RIGHT[name][number]).is_right


def test_what_a_student_reads():
    """Feedback shows the call, both values, the rule, the hint and the section.

    After a right answer it shows what the function passed.
    """

    def point_segment_distance(q, p1, p2):
        return EXERCISES["point_line_distance"].source(q, p1, p2) if (p1 != p2).any() else 0.0

    text = repr(check(point_segment_distance))
    assert "q = np.array([7.0, 4.0])" in text
    assert "point_segment_distance(q, p1, p2)" in text
    assert "yours gives: 4" in text
    assert "it should be: 5" in text
    assert "You measure to the whole line" in text
    assert "section 3" in text
    right = repr(check(EXERCISES["point_segment_distance"].source))
    assert "right, for all" in right
    assert "A question to think about" in right


def test_an_error_shows_the_students_line_and_nothing_of_ours():
    """Feedback shows the student's own line, the error and its message, but no library line."""

    def point_line_distance(q, p1, p2):
        return helper(q)

    def helper(q):
        return np.linalg.norm(q) / [][0]

    text = repr(check(point_line_distance))
    assert "IndexError: list index out of range" in text
    assert "return np.linalg.norm(q) / [][0]" in text
    assert "return helper(q)" in text
    assert "within" not in text.split("in your lines")[1].split("Hint")[0]


def test_an_unwritten_answer_is_not_reported_as_wrong():
    """NotImplementedError means that the function is not written yet: no picture, no rule."""

    def polygon_tangent(q, polygon):
        raise NotImplementedError

    feedback = check(polygon_tangent)
    assert "not answered yet" in repr(feedback)
    assert feedback.picture() is None
    assert feedback.report.score == 0.0


def test_a_hang_ends_with_a_message():
    """check() stops an endless loop, also one that catches every exception."""

    def polygon_tangent(q, polygon):
        while True:
            pass

    def deaf(q, polygon):
        while True:
            with contextlib.suppress(BaseException):
                sum(range(10))

    assert "It was stopped" in repr(check(polygon_tangent))
    assert "no answer after" in repr(check(deaf, "polygon_tangent"))
    assert check(EXERCISES["polygon_tangent"].source).report.is_right


@pytest.mark.parametrize(("used", "is_idle"), [(0.0, True), (5.1, False)])
def test_a_program_that_got_no_time_to_compute_is_asked_to_try_again(used, is_idle):
    """A time-out in which a program computed next to nothing has no hint about the program."""
    exercise = EXERCISES["polygon_tangent"]
    case = exercise.fixed_cases[0]
    report = judge_outcomes(exercise, [case], [Late(False, used, 5.0, 20.0)])
    assert ("Try again" in repr(Feedback(report))) == is_idle


def test_a_hang_inside_callbacks_is_not_reported_as_lost():
    """Nothing is printed where the time-out occurs inside a callback of the garbage collector."""

    def callback(*_):
        sum(range(50))

    def polygon_tangent(q, polygon):
        while True:
            gc.collect(0)

    lost, before = [], sys.unraisablehook
    sys.unraisablehook = lost.append
    gc.callbacks.append(callback)
    others = set(threading.enumerate())
    try:
        assert "no answer after" in repr(check(polygon_tangent))
        for thread in set(threading.enumerate()) - others:
            thread.join(60)  # on a busy computer it ends later
    finally:
        gc.callbacks.remove(callback)
        sys.unraisablehook = before
    assert lost == []


def test_feedback_can_be_staged(monkeypatch):
    """First the rule, then the case, the picture and the hint; a repeated failure adds nothing."""
    from kinoedu.course import feedback

    monkeypatch.setattr(feedback, "TRIES", {})

    def check_constant(value):
        def point_segment_distance(q, p1, p2):
            return value

        return check(point_segment_distance, staged=True)

    first = check_constant(1.0)
    assert "The rule" in repr(first)
    assert "smallest case" not in repr(first)
    assert "smallest case" not in repr(check_constant(1.0))
    second = check_constant(3.0)
    assert "smallest case" in repr(second)
    assert second.picture() is None
    third = check_constant(4.0)
    assert third.picture() is not None
    assert "Hint" not in repr(third)
    assert "Hint" in repr(check_constant(5.0))


def test_a_program_that_changes_its_input_is_reported():
    """Each call gets its own copy of the arguments, and a change of them is reported."""

    def point_polygon_distance(q, polygon):
        answer = EXERCISES["point_polygon_distance"].source(q, polygon)
        polygon[:] = 0.0
        return answer

    feedback = check(point_polygon_distance)
    assert "a change of its arguments: polygon" in repr(feedback)
    assert feedback.report.score == 0.0


def test_what_a_program_prints_is_shown_for_the_smallest_case_only(capsys):
    """The output of two hundred calls does not hide the feedback."""

    def point_line_distance(q, p1, p2):
        print("foot at", p1)
        return 0.0

    assert repr(check(point_line_distance)).count("foot at [0. 0.]") == 1
    assert capsys.readouterr().out == ""


def test_feedback_names_the_unwritten_function_that_is_called():
    """Feedback names the function that is not written yet."""

    def point_segment_distance(q, p1, p2):
        raise NotImplementedError

    def point_polygon_distance(q, polygon):
        return point_segment_distance(q, polygon[0], polygon[1])

    assert "calls point_segment_distance, which is not written yet" in repr(
        check(point_polygon_distance)
    )


def complaint(code):
    """Key of the advice for a function with this body."""
    source = f"def point_line_distance(q, p1, p2):\n    {code}"
    linecache.cache["student.py"] = (len(source), None, source.splitlines(True), "student.py")
    names = {"np": np}
    exec(compile(source, "student.py", "exec"), names)
    return repr(check(names["point_line_distance"]))


@pytest.mark.parametrize(
    ("code", "advice"),
    [
        ("return 0 if p1 == p2 else 1", "np.array_equal"),
        ("return (q ^ 2)", "In Python the power is **"),
        ("return (q[0] > 1) - (q[0] < 1)", "numpy does not subtract truth values"),
        ("return -(q > 1)", "numpy does not subtract truth values"),
        ("return 0 if q in [p1, p2] else 1", "np.array_equal(p1, p2), not ==, `in`"),
        ("return p1[2]", "The last of n items"),
        ("return [].pop()", "What should your function return when there are none left"),
        ("import heapq\n    return heapq.heappop([])", "while queue:"),
        ("return set().pop()", "while queue:"),
        ("return {}[0]", "A dictionary has nothing under this key"),
        ("return {q: 0}", "tuple(q) makes one"),
        ("for value in set(range(3)): return len(q[0])", "Is it the number i of a node"),
        ("for i in len(q): return 0", "for i in range(n)"),
        ("found = {1}\n    for value in found: found.add(2)", "must not grow or shrink"),
        ("return [1] + 2", "path.append(u)"),
        ("return q(0)", "square ones take an item"),
        ("return q.sum[0]", "Round brackets call a function"),
        ("return point_line_distance(q)", "Compare the call"),
        ("return (3).random()", "np.random.default_rng(rng)"),
        ("return [1].append(2).sort()", "so do append, sort and reverse"),
        ("rows = [[1, 2]]\n    return rows[0, 1]", "A list takes one index at a time"),
        ("return p1[0.0]", "2, and not 2.0 or an array"),
        ("return [1, 2][p1[0]]", "2, and not 2.0 or an array"),
        ("return [1, 2][q]", "2, and not 2.0 or an array"),
        ("return sum(range(p1[0]))", "2, and not 2.0 or an array"),
        ("return lenght(q)", "Python does not know this name"),
        ("import math\n    return math.arctan2(1, 2)", "Python does not know this name"),
        ("return point_line_distance(q, p1, p2)", "calls itself without end"),
        ("return ValueError('no line')", "raised, not returned"),
        ("return None + 1", "A value is None"),
        ("return 1 / 0", "Which number is zero"),
        ("import math\n    return math.sqrt(-len(q))", "A negative number has no root"),
        ("import math\n    return math.log(0)", "no logarithm"),
        ("return max(0, (-len(q)) ** 0.5)", "A negative number has no root"),
        ("return [q].shape", "A list is no array"),
        ("return np.zeros(3).index(0)", "An array is no list"),
        ("return np.array([q, [1]])", "All rows of an array have the same length"),
        ("return [1].index(2)", "The list does not hold this item"),
        ("return int(float('inf'))", "A number is infinite here"),
        ("return int(float('nan'))", "A number is infinite here"),
        ("return zip(q, q)[0]", "list(...) makes a list"),
        ("return next(x for x in q if x > 1e9)", "next(...) found no item"),
        ("return min([])", "Which list is empty"),
        ("return q[0][1]", "one number. Is it an item of a row already?"),
        ("return len(q)[0]", "one number. Is it an item of a row already?"),
        ("import math\n    return math.cos(q)", "np.sqrt take arrays"),
        ("q.append(1)", "An array has no append"),
        ("return q + np.zeros(3)", "Print the .shape of both"),
        ("return q @ np.zeros(3)", "Print the .shape of both"),
        ("return np.cross(q[:1], p1[:1])", "np.cross is for vectors of three numbers"),
        ("a, b = p1, p2, q", "as many values as names"),
        ("a, b, c = q", "as many values as names"),
        ("a, b = 3.0", "as many values as names"),
        ("a, b = None", "A value is None"),
        ("return [1] + None", "A value is None"),
        ("return np.zeros(2, 2)", "two pairs of brackets"),
        ("return (1, 2) - (0, 1)", "np.array(point) makes an array"),
        ("return [1, 2] * 0.5", "np.array(point) makes an array"),
        (
            "from kinoedu.geometry import orientation as o\n    o((1, 2, 3, 4), q, q)",
            "np.array(point)",
        ),
        ("return np.min([])", "Which list is empty"),
        ("return np.argmin([])", "Which list is empty"),
        ("return {1, 2}", "list(...) makes a list"),
        ("return map(float, p1)", "list(...) makes a list"),
        ("yield 1", "list(...) makes a list"),
        ("if q[0] > 1e9: d = 1\n    return d", "before it has a value"),
        ("max = max(q)\n    return max", "has it the name of a function"),
        ("raise ValueError('too far')", "A line of your own raises this error"),
        ("if len(q) == 2: raise KeyError(q)", "A line of your own raises this error"),
        ("if q[9] > 0: raise ValueError('too far')", "The last of n items"),
    ],
)
def test_common_complaints_of_python_are_explained(code, advice):
    """Common errors of Python are explained for beginners."""
    assert advice in complaint(code)


def test_a_default_value_that_keeps_what_earlier_calls_put_in_is_named():
    """Each case alone would be right, so no hint on the search could help."""

    def dfs_path(neighbours, start, goal, seen=set()):  # noqa: B006 (the mistake)
        seen.add(start)
        if start == goal:
            return [goal]
        for u in neighbours[start]:
            way = dfs_path(neighbours, u, goal, seen) if u not in seen else None
            if way:
                return [start, *way]
        return None

    assert "is made only once: all calls of your function share it" in repr(check(dfs_path))


def test_a_program_that_moves_a_problems_start_is_told_that_it_stays():
    def tree_roadmap(problem, expand, iterations, rng):
        problem.start += 1.0

    assert "The start and the goal of a problem stay as they are" in repr(check(tree_roadmap))


def test_an_exercise_may_have_its_own_hint_for_an_error_of_the_students_own():
    """Dijkstra's algorithm is refused for negative weights, and not for zero."""

    def dijkstra(neighbours, weights, start):
        raise ValueError("no weight may be zero")

    assert "Is the error your own ValueError? Zero is not negative." in repr(check(dijkstra))


def test_the_hint_on_one_of_several_values_does_not_speak_of_a_missing_return():
    """The line with `return` is right; one value in the list is not."""

    def bfs_tree(neighbours, start):
        return [None] * len(neighbours)

    feedback = repr(check(bfs_tree))
    assert "at index 0: expected a whole number, got None" in feedback
    assert "the message names its place" in feedback


def endless_message():
    """An exception whose message never ends."""

    class Loud(Exception):
        def __str__(self):
            while True:
                pass

    return Loud()


def strange_class():
    """An exception of a class without a usable name."""

    class Meta(type):
        @property
        def __mro__(cls):
            raise RuntimeError

        @property
        def __name__(cls):
            raise RuntimeError

        def __eq__(cls, other):
            raise RuntimeError

        __hash__ = type.__hash__

    class Strange(Exception, metaclass=Meta):
        pass

    return Strange("x")


@pytest.mark.parametrize(
    "make",
    [endless_message, strange_class, KeyboardInterrupt, SystemExit, GeneratorExit, StopIteration],
)
def test_whatever_a_program_raises_is_an_outcome(make):
    """Messages and classes of exceptions run within the time limit, and an exit is an outcome."""

    def point_line_distance(q, p1, p2):
        raise make()

    assert not check(point_line_distance).report.is_right


@pytest.mark.parametrize("value", [3e6, 1e12, -5.0, float("nan")])
def test_a_picture_of_any_number_is_drawn_soon(value):
    """A circle much larger than the picture is described in words."""

    def point_line_distance(q, p1, p2):
        return value

    feedback = check(point_line_distance)
    assert feedback.picture().startswith(b"\x89PNG")
    assert "nan" in repr(feedback) or value == value


@pytest.mark.parametrize("name", ["bug_base", "bug1", "bug2"])
def test_a_picture_of_no_walk_does_not_speak_of_one(name):
    """Where a program returns nothing, no path begins anywhere."""
    from matplotlib.figure import Figure

    exercise, ax = EXERCISES[name], Figure().subplots()
    case = next(exercise.cases(np.random.default_rng(0)))
    exercise.draw(case, Misshapen("expected an array, got None"), ax)
    assert ax.get_title() == "Straight to the goal"


@pytest.mark.parametrize("wrong_use", ["point_line_distance", 3.0, None, lambda q: q, 10**60])
def test_a_check_of_something_else_says_what_it_takes(wrong_use):
    """A name in quotes, a result, and a function of another name are rejected with a message."""
    with pytest.raises(InvalidParameter):
        check(wrong_use)


class AlwaysEqual:
    """An answer that equals everything."""

    def __eq__(self, other):
        return True

    def __array__(self, *_, **__):
        raise SystemExit


@pytest.mark.parametrize(
    "value",
    [
        AlwaysEqual(),
        None,
        "5",
        True,
        [1, 2, 3],
        float("nan"),
        float("inf"),
        1e400,
        10**400,
        1j,
        {"a": 1},
        np.array([[5.0]]),
        [[[]]],
        object,
    ],
    ids=lambda value: type(value).__name__ + str(value)[:8].strip("<"),
)
def test_strange_answers_are_wrong_answers(value):
    """Whatever a program returns, check() says what was expected."""

    def point_line_distance(q, p1, p2):
        return value

    feedback = check(point_line_distance)
    assert not feedback.report.is_right
    assert "it should be" in repr(feedback)
    assert "<script" not in feedback._repr_html_()


def test_what_a_program_says_is_escaped():
    """Text from a student's program cannot become markup; the course's words show code as code."""

    def point_line_distance(q, p1, p2):
        raise RuntimeError("<script>alert(1)</script>\ud800 `mine`")

    html = check(point_line_distance)._repr_html_()
    assert "<script>" not in html and "`mine`" in html
    assert "<code>a &lt; b</code>" in html_entry("Hint", "Use `a < b`.")


def test_a_long_line_opens_on_a_click():
    """A long line shows its beginning and expands on a click; a short one is unchanged."""
    line = "problem = '" + "<" * 500 + "'"
    folded = fold_line(line, escape)
    assert folded.startswith("<details") and folded.count("&lt;") > 500
    assert fold_line("n = '<'", escape) == escape("n = '<'")


def test_every_word_is_there_and_used():
    """Each exercise has messages for its kinds, rules, hints, slips and pictures, and no others."""
    files = [*messages.HERE.glob("en/*.toml"), *messages.LESSONS.glob("*/*.toml")]
    tables = [tomllib.loads(file.read_text(encoding="utf-8")) for file in files]
    table = {name: rows for one in tables for name, rows in one.items()}
    assert sum(map(len, tables)) == len(table)  # no table is in two files
    assert set(table["exercise"]["rules"]) == set(table["exercise"]["hints"])
    for exercise in EXERCISES.values():
        mine = table[exercise.name]
        lent = [table[other] for other in exercise.shared]
        assert set(mine.get("kinds", {})).union(*(other.get("kinds", {}) for other in lent)) >= set(
            exercise.kinds
        )
        assert set(mine.get("kinds", {})) <= set(exercise.kinds)
        assert set(mine.get("slips", {})) == {slip.key for slip in exercise.slips}
        assert set(mine.get("advice", {})) <= {key for key, _, _ in COMMON_ERRORS}
        rules, hints = set(mine.get("rules", {})), set(mine.get("hints", {}))
        assert rules <= hints <= rules.union(*(other["rules"] for other in lent))
        assert all(messages.has_message(f"advice.{key}") for key, _, _ in COMMON_ERRORS)
        assert any("section" in one for one in (mine, *lent))
        assert mine["wonder"]
    files = [*(HOUSE / "kinoedu").rglob("*.[pj][ys]"), *(HOUSE / "docs").glob("*.py")]
    sources = "".join(file.read_text(encoding="utf-8") for file in files)
    for name, rows in table.items():
        elsewhere = name in ("exercise", "advice", "board")  # their keys are composed
        computed = f'f"{name}.{{' in sources or elsewhere
        if name not in EXERCISES and not computed:
            for key, text in rows.items():
                if name in {
                    other for exercise in EXERCISES.values() for other in exercise.shared
                } and key in ("section", "wonder"):
                    continue
                assert not isinstance(text, str) or re.search(
                    rf'"{name}\.{key}|"{name}\.", ?"{key}"|{name}_{key}', sources
                ), f"{name}.{key}"


def test_a_translation_replaces_words_and_falls_back(monkeypatch, tmp_path):
    """KINOEDU_LANGUAGE selects another catalogue, with English where a message is missing."""
    shutil.copytree(HOUSE / "kinoedu" / "messages" / "en", tmp_path / "en")
    (tmp_path / "xx").mkdir()
    (tmp_path / "xx" / "some.toml").write_text('[check]\nhint = "Wink"\n')
    monkeypatch.setattr(messages, "HERE", tmp_path)
    monkeypatch.setenv("KINOEDU_LANGUAGE", "xx")
    messages.catalogue.cache_clear()
    try:
        assert messages.get_message("check.hint") == "Wink"
        assert messages.get_message("check.rule") == "The rule"
    finally:
        messages.catalogue.cache_clear()


LATE = encode_outcome(Late(False, 5.2, 5.0, 7.5, []), None)
NO_SECONDS = (5, True, None, "5", "nan", float("nan"), float("inf"), -1.0, 1e9, [1.0])


@pytest.mark.parametrize(
    ("value", "came"),
    [
        ((True, False), "got a tuple of length 2 with True in it"),
        ([1, None], "got a list of length 2 with None in it"),
        ([1, "2"], "got a list of length 2 with '2' in it"),
        ([1, 2j], "got a list of length 2 with a complex in it"),
        ([1, 2, None], "got a list of length 3"),
        (np.array([True, False]), "got an array of shape (2,) of bool"),
        ((10**400, 1), "got a tuple of length 2"),
        (np.float64(0.5), "got 0.5"),
    ],
)
def test_what_is_no_number_is_named(value, came):
    """Where the length is right, the reason is another one."""
    from kinoedu.course.plain import WrongShape
    from kinoedu.course.shapes import Numbers

    with pytest.raises(WrongShape) as caught:
        Numbers((2,)).encode(value)
    assert str(caught.value) == f"expected an array of numbers of shape (2,), {came}"


@pytest.mark.parametrize(
    ("dimensions", "value", "made"),
    [
        ((2, 2), (0.5, 1.5), "a tuple of length 2, which makes an array of shape (2,)"),
        ((2,), [[1, 2], [3, 4]], "a list of length 2, which makes an array of shape (2, 2)"),
        (("n", 2), [[1, 2, 3]], "a list of length 1, which makes an array of shape (1, 3)"),
    ],
)
def test_the_shape_that_a_list_makes_is_named(dimensions, value, made):
    """Its length alone may be the right one."""
    from kinoedu.course.plain import WrongShape
    from kinoedu.course.shapes import Numbers

    with pytest.raises(WrongShape) as caught:
        Numbers(dimensions).encode(value)
    assert str(caught.value).endswith(f", got {made}")


def test_of_several_values_the_one_that_does_not_fit_is_named():
    """By its place in what one call returns; places of several calls mean nothing to students."""
    from kinoedu.course.plain import WrongShape
    from kinoedu.course.shapes import Listed, Numbers, Together
    from kinoedu.course.whole_shapes import Integer

    wanted = Together((Numbers((2,)), Listed(Integer())))
    fault = "value 2 of those that you return: at index 1: expected a whole number, got None"
    with pytest.raises(WrongShape, match=f"^{fault}$"):
        wanted.encode(((0, 1), [3, None]))
    with pytest.raises(WrongShape, match=f"^{fault}$"):
        Together((wanted, wanted), is_returned=False).encode([((0, 1), [3, None])] * 2)


def test_what_is_no_whole_number_is_named():
    """Heights in place of indices: the first that is not whole is shown."""
    from kinoedu.course.plain import WrongShape
    from kinoedu.course.whole_shapes import Integers

    with pytest.raises(WrongShape, match=r"got a list of length 2 with 0\.25 in it"):
        Integers(("k",)).encode([1, 0.25])


def test_values_of_different_shapes_are_listed_one_by_one():
    """A path or None, and a length: the two are not read as three."""
    assert EXERCISES["shortest_path"].answer.description == (
        "2 values, in this order: an array of whole numbers of shape (k,), or None; a number"
    )


def test_exact_numbers_are_numbers():
    """A fraction, and an integer that no array of integers holds, become the nearest float."""
    from kinoedu.course.plain import WrongShape
    from kinoedu.course.shapes import Number, Numbers

    assert Number().encode(Fraction(1, 3)) == 1 / 3 and Number().encode(10**20) == 1e20
    assert Numbers(("n", 2)).encode([(Fraction(1, 4), 1), (0.5, 10**20)]) == [
        [0.25, 1],
        [0.5, 1e20],
    ]
    assert Numbers((2,)).encode([Fraction(1, 4), np.float64(0.5)]) == [0.25, 0.5]
    assert Numbers((2,)).encode(np.array([np.float64(1), np.int64(2)], object)) == [1.0, 2.0]

    class Own(Fraction):
        """Would run code of its own where it is converted."""

    for value in (Own(1, 3), Fraction(10**400)):
        with pytest.raises(WrongShape):
            Number().encode(value)


def test_outcomes_that_are_none_are_refused():
    """Data that no call can have produced are not accepted as an outcome."""
    from kinoedu.course.plain import WrongShape
    from kinoedu.course.shapes import Number, Numbers

    deep = 1.0
    for _ in range(900):
        deep = [deep]
    values = ("5", 10**400, True, None, [1.0], {"a": 1})
    for data in (
        None,
        [],
        {},
        {"kind": "Answer"},
        {"kind": "Late"},
        *(LATE | {name: value} for name in ("used", "passed") for value in NO_SECONDS),
        LATE | {"lines": ["line 1: x"] * 100},
        LATE | {"left_running": 1},
        {"kind": "x"},
        *({"kind": "Answer", "value": v} for v in values),
    ):
        with pytest.raises(WrongShape):
            decode_outcome(data, Number())
    for value in (deep, [[1, 2], [3]], [[10**400, 1]], [["nan", "NaN"]], 5, [[True, False]]):
        with pytest.raises(WrongShape):
            decode_outcome({"kind": "Answer", "value": value}, Numbers(("n", 2)))
    with pytest.raises(WrongShape):
        decode_outcome(
            {"kind": "Raised", "kinds": ["x"] * 10_000, "message": "", "lines": [], "function": ""},
            Number(),
        )
    for outcome in (
        Answer(float("nan")),
        Misshapen("m"),
        Raised(["ValueError"], "m", ["line 1: x"], "f"),
        Changed(["q"]),
        Late(False, 0.0, 0.0, 0.0, []),
        Late(True, 5.2, 5.0, 7.5, ["line 2: while True:"]),
    ):
        assert repr(
            decode_outcome(json.loads(json.dumps(encode_outcome(outcome, Number()))), Number())
        ) == repr(outcome)


@pytest.mark.parametrize("name", ["point_polygon_distance", "polygon_tangent"])
def test_a_star_without_room_for_a_question_is_replaced(name):
    """Where a star-shaped polygon leaves no room for a kind of point, another is drawn.

    In a sharp star no inside point may be clearly nearest to one edge; such seeds once looped
    forever.
    """
    for seed in (26, 30, 32):
        cases = list(EXERCISES[name].cases(np.random.default_rng(seed)))
        assert {case.kind for case in cases} == set(EXERCISES[name].kinds)


@pytest.mark.parametrize(("name", "least"), [("trapezoidation", 3), ("visibility_roadmap", 2)])
def test_a_failing_world_is_shown_without_the_obstacles_that_do_not_matter(name, least):
    """The program forgets what it does with few obstacles; just enough of them remain."""
    exercise = EXERCISES[name]
    seen = []

    def forgetful(*given):
        given = [one._ask.__self__ if isinstance(one, LentProblem) else one for one in given]
        seen.append(len(given[1]))
        answer = exercise.right_answer(*given)
        return answer if seen[-1] < least else type(answer)(part[:1] for part in answer)

    failure = check(forgetful, name).report.failure
    assert len(failure.case.given["obstacles"]) == least <= max(seen)
    if "problem" in failure.case.given:
        assert len(scene_of(failure.case.given["problem"].problem)["world"]["obstacles"]) == least


def test_what_is_shown_as_printed_is_printed_for_the_case_that_is_shown():
    """Without the obstacles that do not matter, the program prints something else."""
    exercise = EXERCISES["trapezoidation"]

    def forgetful(boundary, obstacles):
        print("obstacles:", len(obstacles))
        answer = exercise.right_answer(boundary, obstacles)
        return answer[1:] if len(obstacles) > 2 else answer

    feedback = check(forgetful, "trapezoidation")
    assert len(feedback.report.failure.case.given["obstacles"]) == 3
    assert feedback.printed == "obstacles: 3\n"


def test_a_file_beside_the_package_is_a_students():
    """Such as kinoedu_answers.py, whose name begins with that of the package's folder."""
    package = Path(outcomes.__file__).resolve().parent.parent
    assert outcomes.is_students(f"{package}_answers.py")
    assert not outcomes.is_students(str(package / "course" / "outcomes.py"))
    assert not outcomes.is_students(json.__file__)
