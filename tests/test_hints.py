"""Hints are true of the answer: to a variant as well, and where it is a small slip of the pen."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from judged_programs import take_few_cases

from kinoedu.course import EXERCISES
from kinoedu.course.bank import Solutions, read_bank
from kinoedu.course.exercise import CONTRACT, Exercise, ValueExercise
from kinoedu.course.feedback import Feedback
from kinoedu.course.judging import judge_outcomes, judge_until_failure, run_case
from kinoedu.course.lessons import find
from kinoedu.course.lessons.polygons_in_the_plane.matrices import swap_entries
from kinoedu.course.outcomes import Answer, Raised
from kinoedu.figures.plane import plane_figure
from kinoedu.geometry import point_line_distance, point_polygon_distance, polygon_tangent
from kinoedu.sampling import dispersion, sukharev_grid, van_der_corput

HOUSE = Path(__file__).resolve().parent.parent
TREE = Solutions(HOUSE / "solutions" / "09_trees.ipynb").right["tree_roadmap"]
UPRIGHT_CELLS = Solutions(HOUSE / "solutions" / "03_decomposition.ipynb").right["trapezoidation"]
CHANCE = EXERCISES["collision_probability"].right_answer
CHANGED = [
    find(exercise.name, change.key)
    for exercise in EXERCISES.values()
    for change in exercise.changes
    if isinstance(exercise, ValueExercise)
]


@np.errstate(all="ignore")
def outcome_of_slip(exercise, slip, case):
    """What a program with a misconception does."""
    found = exercise.mistaken_answer(slip, case)
    if isinstance(found, Exception):
        return Raised([type(found).__name__], str(found), [], exercise.name)
    return Answer(exercise.answer.decode(json.loads(json.dumps(exercise.answer.encode(found)))))


@pytest.mark.parametrize("exercise", CHANGED, ids=lambda one: f"{one.name}-{one.variant}")
def test_a_misconception_that_is_the_usual_form_has_a_message_of_its_own(exercise: Exercise):
    """What is a misconception in the usual form is right there where it is asked for.

    A program of the usual form with one more mistake must not be told the contrary.
    """
    cases = take_few_cases(exercise)
    for slip in exercise.slips:
        outcomes = [outcome_of_slip(exercise, slip, case) for case in cases]
        report = judge_outcomes(exercise, cases, outcomes)
        if report.failure is not None and report.failure.verdict.rule == CONTRACT:
            table = exercise.table_with(f"slips.{slip.key}")
            assert table.endswith(f".{exercise.variant}"), slip.key


def test_an_iteration_too_few_is_not_a_wrong_goal_bias():
    """A tree that goes straight to the goal, and ends early, is told that iterations are left."""
    exercise = EXERCISES["rrt_for_polygon"]
    solutions = Solutions(HOUSE / "solutions" / "11_polygons_in_the_plane.ipynb")
    change = ("range(iterations + 1)", "range(iterations)")
    program = solutions.run_changed(exercise.name, [change])[exercise.name]
    (case,) = (
        case
        for case in exercise.fixed_cases
        if case.kind == "room" and case.given["goal_bias"] == 1.0 and case.given["iterations"] < 20
    )
    assert exercise.judge(case, run_case(exercise, program, case)).rule == "missed"


def test_sorted_random_points_are_not_called_moved_ones():
    """Sorted points of two seeds are alike, but they are not the same points, moved."""
    exercise = EXERCISES["uniform_random"]
    case = next(case for case in exercise.fixed_cases if case.kind == "line")

    def draw_sorted(n, d, rng):
        return np.sort(np.random.default_rng(rng).random((n, d)), axis=0)

    assert exercise.judge(case, run_case(exercise, draw_sorted, case)).rule == "sorted"


def test_dots_with_other_angles_are_in_place():
    """Dots from -pi to pi that are all red have wrong colours; the message says nothing else."""
    exercise = EXERCISES["plot_configuration_space"]
    case = next(case for case in exercise.fixed_cases if (exercise.truth(case)[:, 2] != 2).any())

    def plot_configuration_space(samples, lengths, width, discs, ax):
        ax.scatter(*(2 * np.pi * (samples - (samples > 0.5))).T, c="red")

    outcome = run_case(exercise, plot_configuration_space, case)
    assert exercise.judge(case, outcome).rule == "colours"


def turned(vector, quarters):
    """A vector turned to the left by quarter turns."""
    for _ in range(quarters):
        vector = np.array([-vector[1], vector[0]])
    return vector


def number_from_the_newest(more):
    """A program that numbers a tree from the newest node, with parents that are off by `more`."""

    def tree_roadmap(*given):
        nodes, parent = map(np.asarray, TREE(*given))
        later = np.where(parent < 0, -1, len(nodes) - 1 - parent + more)
        return nodes[::-1], later[::-1]

    return tree_roadmap


def walk(turns_ahead):
    """A program for `euler` that looks so many turns of a step ahead for its direction."""

    def euler(pose, v, phi, t, length, n):
        poses = [np.array(pose, float)]
        turn = v * np.tan(phi) / length * t / n
        for _ in range(n):
            x, y, theta = poses[-1]
            ahead = theta + turns_ahead * turn
            step = v * t / n * np.array([np.cos(ahead), np.sin(ahead)])
            poses.append(np.array([x + step[0], y + step[1], theta + turn]))
        return poses

    return euler


def within_a_box(q, polygon):
    """A wrong test of whether a point is inside: zero in the bounding box."""
    is_inside = (polygon.min(axis=0) < q).all() and (q < polygon.max(axis=0)).all()
    return 0.0 if is_inside else point_polygon_distance(q, polygon)


def stand_still(start, controls, *others):
    """A program for `replay` that never moves."""
    return [start] * (len(controls) + 1)


def with_a_rounded_quantile(path, discs, offsets):
    """A program for `collision_probability`, without a hit, that rounds 1.96 to 2."""
    share, n, z = 1.0 - CHANCE(path, discs, offsets)[0], len(offsets), 2.0
    middle = share + z * z / (2 * n)
    reach = z * np.sqrt(share * (1 - share) / n + z * z / (4 * n * n))
    return share, (middle - reach) / (1 + z * z / n), (middle + reach) / (1 + z * z / n)


def find_cheap_nodes(neighbours, weights, start):
    """A program for `dijkstra` in which 10**6 stands for infinity."""
    costs = np.array(EXERCISES["dijkstra"].right_answer(neighbours, weights, start))
    return np.where(costs < 10**6, costs, np.inf)


def join_near_nodes(form=np.asarray):
    """A program for `adjacency_matrix` that misses motions longer than 4."""

    def program(problem, nodes):
        pairs = [[(a, b) for b in nodes] for a in nodes]
        near = [
            [problem.is_free_path(*p) and problem.distance(*p) < 4 for p in row] for row in pairs
        ]
        return form(np.array(near, int) * (1 - np.eye(len(nodes), dtype=int)))

    return program


def print_for_no_grid(n, d):
    """A right grid, and a printed message where there is none."""
    try:
        return sukharev_grid(n, d)
    except ValueError:
        print("no grid")


def without_a_root(points):
    """Bounds of the square of the dispersion."""
    square = dispersion(points) ** 2
    return square - 0.02, square - 0.01


@pytest.mark.parametrize(
    ("name", "variant", "program", "said"),
    [
        ("point_line_distance", "right", lambda *p: -point_line_distance(*p), "never positive"),
        ("point_polygon_distance", "boundary", within_a_box, "Only on the boundary"),
        ("polygon_tangent", "clockwise", lambda *p: turned(polygon_tangent(*p), 3), "points away"),
        ("polygon_tangent", "clockwise", lambda *p: turned(polygon_tangent(*p), 1), "towards the"),
        ("tree_roadmap", "newest_first", number_from_the_newest(-1), "one too small"),
        ("euler", "midpoint", walk(1.5), "half of what it adds"),
        ("euler", "new_heading", walk(2.0), "turns twice"),
        ("bfs_path", "incoming", lambda *given: None, "u in neighbours[v]"),
        ("replay", "degrees", stand_still, "np.radians(phi)"),
        ("collision_probability", "no_hit", with_a_rounded_quantile, "1.2302"),
        ("dijkstra", "", find_cheap_nodes, "math.inf"),
        ("point_in_convex_polygon", "", lambda *given: True, "is the same for every q"),
        ("point_in_convex_polygon", "", lambda *given: False, "is the same for every q"),
        ("point_in_convex_polygon", "outside", lambda *given: True, "is the same for every q"),
        ("point_in_convex_polygon", "outside", lambda *given: False, "is the same for every q"),
        ("sukharev_grid", "", print_for_no_grid, "raise ValueError"),
        ("dispersion_bounds", "", without_a_root, "root of the squared distance"),
        ("trapezoidation", "level", UPRIGHT_CELLS, "Your contract asks for another answer"),
        ("radius_neighbours", "long_edges", lambda *given: [], "3 r / 4 is too near"),
        ("adjacency_matrix", "", join_near_nodes(), "Some are missing from your matrix; the ones"),
        (
            "adjacency_matrix",
            "upper_half",
            join_near_nodes(np.triu),
            "the ones that it has are right",
        ),
        (
            "adjacency_matrix",
            "contact",
            join_near_nodes(swap_entries),
            "the zeros that it has are right",
        ),
    ],
)
def test_a_hint_is_true_of_the_answer_to_a_variant(name, variant, program, said):
    """Programs with a mistake of their own, which would be another one in the usual form."""
    exercise = find(name, variant)
    cases = list(exercise.fixed_cases)
    report = judge_outcomes(exercise, cases, [run_case(exercise, program, one) for one in cases])
    assert said in repr(Feedback(report))


CLOSED = [(0, 0), (4, 0), (4, 4), (0, 4), (0, 0)]


@pytest.mark.parametrize(
    ("name", "answer"),
    [
        ("exposing_case", ((1, 1), CLOSED)),
        ("exposing_problem", ((-1, 1), (9, 1), [CLOSED])),
        ("exposing_world", CLOSED),
        ("exposing_sight", [CLOSED]),
        ("overlooked_gap", (CLOSED, CLOSED[:4])),
    ],
)
def test_a_polygon_whose_first_vertex_comes_again_is_told_so(name, answer):
    """It is simple in the picture, so the rule for polygons alone does not help."""
    exercise = find(name, "")
    cases = list(exercise.fixed_cases)
    report = judge_outcomes(exercise, cases, [run_case(exercise, lambda: answer, c) for c in cases])
    assert report.failure.verdict.rule == "valid"
    assert "again at the end" in repr(Feedback(report))


@pytest.mark.parametrize("name", ["rrt", "rrt_for_polygon"])
def test_a_goal_exactly_one_step_away_is_joined_to_the_start(name):
    """A planner that joins only a nearer goal is told so; rows of another length are no nodes."""
    exercise = EXERCISES[name]

    def is_one_step(case):
        problem, step = case.given["problem"], case.given["step"]
        return case.given["goal_bias"] == 1.0 and problem.distance(*ends(problem)) == step

    def ends(problem):
        return problem.start, problem.goal

    case = next(filter(is_one_step, exercise.fixed_cases))
    start, goal = ends(case.given["problem"])
    nodes = np.array([start, goal, goal])
    for rows, rule in ((nodes, "returned"), (np.pad(nodes, ((0, 0), (0, 1))), "numbers")):
        fault = exercise.fault_of_run(case, (rows, np.array([-1, 0, 1]), rows), None)
        assert fault.rule == rule


def nearly_level(x, edges):
    """The crossed edges in the order of heights that are rounded."""
    heights = edges[:, 1] + (x - edges[:, 0]) / (edges[:, 2] - edges[:, 0]) * (
        edges[:, 3] - edges[:, 1]
    )
    crossed = np.flatnonzero((edges[:, 0] < x) != (edges[:, 2] < x))
    return crossed[np.argsort(np.round(heights[crossed], 3), kind="stable")]


def by_pythagoras(q, p1, p2):
    """The distance to a line by a difference of squares."""
    if (p1 == p2).all():
        raise ValueError("one point")
    along = np.dot(q - p1, p2 - p1) / np.linalg.norm(p2 - p1)
    return np.sqrt(max(0.0, ((q - p1) ** 2).sum() - along**2))


def by_its_slope(p1, p2):
    """A line from its slope, which an upright line does not have."""
    slope = (p2[1] - p1[1]) / (p2[0] - p1[0])
    size = np.sqrt(slope**2 + 1)
    return slope / size, -1 / size, (p1[1] - slope * p1[0]) / size


@np.errstate(all="ignore")
@pytest.mark.parametrize(
    ("name", "program", "said"),
    [
        ("line_through_points", by_its_slope, "Where do you divide by a difference of x?"),
        ("crossings", nearly_level, "Order the edges by their heights at x"),
        ("point_line_distance", by_pythagoras, "Each loses digits"),
    ],
)
def test_the_rule_is_the_one_that_the_answer_breaks(name, program, said):
    """It follows from the answer, not only from the kind of input."""
    exercise = EXERCISES[name]
    cases = list(exercise.fixed_cases)
    report = judge_outcomes(exercise, cases, [run_case(exercise, program, c) for c in cases])
    assert said in repr(Feedback(report))


@pytest.mark.parametrize(
    ("name", "lesson", "change", "said"),
    [
        (
            "compare_planners",
            "10_terrains",
            (" if len(found) else [np.nan] * 3", ""),
            "if it gets no lengths at all",
        ),
        ("cost_along", "10_terrains", ("int(y), int(x)", "int(x), int(y)"), "the row comes first"),
        ("csc_length", "12_the_car", ("if d < 2 * r", "if d < 0"), "no inner tangent?"),
    ],
)
def test_an_error_that_an_exercise_invites_has_a_hint_of_its_own(name, lesson, change, said):
    """It comes before the advice that every exercise gives for such an error."""
    exercise = EXERCISES[name]
    wrong = Solutions(HOUSE / "solutions" / f"{lesson}.ipynb").changed(name, change).function
    outcomes = [run_case(exercise, wrong, case) for case in exercise.fixed_cases]
    report = judge_outcomes(exercise, exercise.fixed_cases, outcomes)
    assert isinstance(report.failure.outcome, Raised)
    assert said in repr(Feedback(report))


def test_a_step_beyond_the_sample_is_named_where_its_node_is_another_ones_neighbour():
    """A step that is always whole puts a node beside another one, which seems to be its parent."""
    exercise = EXERCISES["rrt"]
    whole = "nodes[near] + step * (q_rand - nodes[near]) / problem.distance(nodes[near], q_rand)"
    rrt = Solutions(HOUSE / "solutions" / "09_trees.ipynb").changed(
        "rrt", ("problem.steer(nodes[near], q_rand, step)", whole)
    )
    cases = [case for case in exercise.fixed_cases if case.kind == "room"][:4]
    outcomes = [run_case(exercise, rrt.function, case) for case in cases]
    said = repr(Feedback(judge_outcomes(exercise, cases, outcomes)))
    assert "does your step end at the sample where that is nearer" in said


@pytest.mark.parametrize(
    ("lesson", "program", "said"),
    [
        ("decomposition", "only_from_cell_to_cell", "One cell is a way too"),
        ("roadmaps", "in_the_order_of_joining", "by their numbers where two are equally far"),
        ("kinodynamic", "from_nodes_of_the_same_turn", "before you add any"),
        ("trees", "no_path_where_start_is_goal", "There is a way, and this number of iterations"),
        ("terrains", "less_than_a_step", "exactly `step` away is within a step"),
        ("cars", "curve_of_two_digits", "round only when you print"),
        ("cars", "pi_of_two_digits", "or write 3.14 for π?"),
        ("configurations", "cosine_of_two_digits", "such as the cosine of θ₂"),
        ("roadmaps", "components_not_merged", "two of your components have the same node"),
        ("roadmaps", "first_obstacle_only", "Are the vertices of all obstacles looked at?"),
        ("roadmaps", "one_list_for_all", "[[] for _ in nodes] makes one for each"),
        ("terrains", "path_reversed_in_place", "path.reverse() returns None"),
        ("terrains", "pairs_both_ways", "List each pair once"),
        ("terrains", "only_up_and_right", "If b is smaller than a"),
        ("terrains", "cuts_not_sorted", "and sort the cuts"),
        ("terrains", "last_piece_left_out", "from t = 0 to t = 1"),
        ("terrains", "ones_for_rocks", "1 is free, 0 is blocked"),
        ("trees", "tree_path_reversed_in_place", "path.reverse() returns None"),
        ("terrains", "first_planner_only", "in a loop, which it then ends?"),
        ("moving", "returns_in_the_loop", "in a loop, which it then ends?"),
        ("moving", "arrives_before_the_last_interval_ends", "next arrival minus the duration"),
        ("moving", "one_list_of_rows_for_all_paths", "a list of its own"),
        ("moving", "a_hit_stays", "begin anew"),
        ("moving", "begins_when_the_start_is_safe", "contains the time 0?"),
        ("configurations", "complains_when_too_far", "acos got a cosine beyond 1"),
        ("configurations", "angle_between_directions", "Take the difference of the angles"),
        ("kinodynamic", "phi_for_tan", "The message lists all that this problem has"),
        ("kinodynamic", "drives_in_contact_set_the_least", "Only a free drive may set the least"),
        ("polygons_in_the_plane", "path_of_the_call_not_returned", "do you return the path that"),
        ("polygons_in_the_plane", "parent_0_taken_for_none", "compare with None"),
        ("trees", "turns_only_after_a_step", "also after one that added nothing"),
        ("terrains", "one_coin_until_a_node_comes", "Is the target chosen anew in each attempt"),
        ("roadmaps", "larger_of_two_equally_far", "the lower number comes first"),
        ("roadmaps", "found_again_by_no_other_way", "it should be: ([0, 2, 3], 4), or another"),
    ],
)
def test_the_answer_to_a_wrong_program_of_the_bank_leads_to_its_mistake(lesson, program, said):
    """The hint names what is wrong, and the case shows it by more than a rounding error."""
    items = read_bank(HOUSE / "solutions" / "bank" / f"{lesson}.py")
    (item,) = (item for item in items if item.name == program)
    exercise = find(item.exercise, item.variant)
    report = judge_until_failure(
        exercise, exercise.fixed_cases, lambda case: run_case(exercise, item.function, case)
    )
    assert said in repr(Feedback(report))


def test_a_run_that_never_ends_is_asked_where_it_ends(monkeypatch):
    exercise = EXERCISES["rrt_connect"]
    monkeypatch.setattr(type(exercise), "seconds", 0.5)
    (item,) = (
        item
        for item in read_bank(HOUSE / "solutions" / "bank" / "trees.py")
        if item.name == "connects_by_straight_lines"
    )
    cases = exercise.fixed_cases[-3:-1]  # those of the arm
    report = judge_until_failure(
        exercise, cases, lambda case: run_case(exercise, item.function, case)
    )
    assert "Does every run end?" in repr(Feedback(report))


def failure_picture(name, program):
    """The axes of the picture of the first case on which a program fails."""
    exercise = EXERCISES[name]
    report = judge_until_failure(
        exercise, exercise.fixed_cases, lambda case: run_case(exercise, program, case)
    )
    figure, ax = plane_figure()
    exercise.draw(report.failure.case, report.failure.outcome, ax)
    figure.canvas.draw()
    return ax


def test_a_tree_that_ends_too_early_has_no_wrong_node_in_its_picture():
    """The title promises no X, and says what is missing."""
    ax = failure_picture("tree_roadmap", lambda problem, *others: ([problem.start], [-1]))
    assert ax.get_title() == "The nodes are right, but there are more to come"
    ax = failure_picture("tree_roadmap", lambda problem, *others: 1 / 0)
    assert ax.get_title() == "The tree begins at the start"


def test_the_note_of_two_distances_fits_into_the_picture():
    """It was cut off where both distances have ten digits."""
    ax = failure_picture(
        "heading_distance",
        lambda a, b, radian: np.hypot(math.dist(a[:2], b[:2]), radian * (abs(a[2] - b[2]) % np.pi)),
    )
    right = max(text.get_window_extent().x1 for text in ax.texts)
    assert right <= ax.figure.bbox.x1
    assert ax.get_window_extent().width > 0.6 * ax.figure.bbox.width


def test_the_title_of_a_mirrored_number_is_not_cut_off():
    """The words in the axes pushed it out of the picture."""
    ax = failure_picture("radical_inverse", lambda i, base: round(van_der_corput(1, base, i)[0], 6))
    assert ax.title.get_window_extent().y1 <= ax.figure.bbox.y1


def test_a_title_separates_the_answers_from_what_is_seen():
    """In the picture of a motion's costs."""
    ax = failure_picture("cost_along", lambda cost, a, b: 0.0)
    assert ax.get_title().startswith("Inside one cell\nshould be")
