"""Wrong answers to the exercises of lesson 11.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import math
import random
from collections import deque
from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong

solutions = Solutions(Path(__file__).parents[1] / "11_polygons_in_the_plane.ipynb")
changed, varied = solutions.changed, solutions.varied


def turned_until_free(problem, x, y, headings):
    """Return the first of some headings that is free."""
    for theta in headings:
        if problem.is_free(np.array([x, y, theta])):
            return theta
    return None


# A free heading


@wrong("free_heading")
def never_turned(problem, x, y):
    """Tries one heading."""
    return turned_until_free(problem, x, y, [0.0])


@wrong("free_heading")
def degrees(problem, x, y):
    """Checks 360 headings in whole degrees, and returns degrees."""
    theta = turned_until_free(problem, x, y, np.radians(np.arange(0, 360, 5)))
    return None if theta is None else math.degrees(theta)


@wrong("free_heading")
def half_way_round(problem, x, y):
    """Tries half a turn, which is enough only for a symmetric robot."""
    return turned_until_free(problem, x, y, np.arange(0, np.pi, 0.1))


@wrong("free_heading")
def great_steps(problem, x, y):
    """Tries every 30 degrees, and so misses slots."""
    return turned_until_free(problem, x, y, np.arange(0, 2 * np.pi, np.pi / 6))


@wrong("free_heading")
def up_to_six(problem, x, y):
    """Takes 6 for a whole turn."""
    return turned_until_free(problem, x, y, np.arange(0, 6, 0.1))


@wrong("free_heading")
def thirty_headings(problem, x, y):
    """Tries headings at steps of a little more than 0.2."""
    return turned_until_free(problem, x, y, np.arange(30) * 2 * np.pi / 30)


@wrong("free_heading")
def steps_of_a_fifth_and_more(problem, x, y):
    """Tries headings at steps of 0.21."""
    return turned_until_free(problem, x, y, np.arange(0, 2 * np.pi, 0.21))


@wrong("free_heading")
def steps_from_minus_pi(problem, x, y):
    """Tries headings at steps of 0.22 from -pi on."""
    return turned_until_free(problem, x, y, np.arange(-np.pi, np.pi, 0.22))


@wrong("free_heading")
def a_few_at_random(problem, x, y):
    """Tries ten random headings and gives up."""
    return turned_until_free(problem, x, y, np.random.default_rng(0).uniform(-np.pi, np.pi, 10))


@wrong("free_heading")
def gives_the_last_one(problem, x, y):
    """Returns the last heading, free or not."""
    theta = turned_until_free(problem, x, y, np.arange(0, 2 * np.pi, 0.1))
    return 2 * math.pi if theta is None else theta


@wrong("free_heading")
def asks_nothing(problem, x, y):
    """Returns any heading unchecked."""
    return 0.0


@wrong("free_heading")
def zero_is_false(problem, x, y):
    """Takes the heading 0.0 for no heading."""
    return turned_until_free(problem, x, y, [0.0]) or None


@wrong("free_heading")
def turned_where_it_stands(problem, x, y):
    """Turns at the start, not at the given position."""
    return turned_until_free(problem, *problem.start[:2], np.arange(0, 2 * np.pi, 0.1))


@wrong("free_heading")
def a_truth_value(problem, x, y):
    """Returns whether a free heading exists, not which."""
    return bool(turned_until_free(problem, x, y, np.arange(0, 2 * np.pi, 0.1)) is not None)


# The adjacency matrix


def filled(nodes, joined):
    """Return a matrix with 1 where two different configurations are joined."""
    n = len(nodes)
    A = np.zeros((n, n))
    for i in range(n):
        for j in range(n):
            if i != j:
                A[i, j] = joined(nodes[i], nodes[j])
    return A


@wrong("adjacency_matrix", slip="ends_only")
def free_ends(problem, nodes):
    """Checks only the two configurations."""
    return filled(nodes, lambda a, b: problem.is_free(a) and problem.is_free(b))


@wrong("adjacency_matrix", slip="halfway")
def free_ends_and_middle(problem, nodes):
    """Checks three points of the motion."""
    return filled(
        nodes,
        lambda a, b: all(
            problem.is_free(problem.steer(a, b, t * problem.distance(a, b))) for t in (0, 0.5, 1)
        ),
    )


@wrong("adjacency_matrix")
def a_few_places(problem, nodes):
    """Checks twenty points of the motion."""
    return filled(
        nodes,
        lambda a, b: all(
            problem.is_free(problem.steer(a, b, t * problem.distance(a, b)))
            for t in np.linspace(0, 1, 20)
        ),
    )


@wrong("adjacency_matrix")
def a_hundred_places(problem, nodes):
    """Checks a hundred points of the motion, and still misses a thin wall."""
    return filled(
        nodes,
        lambda a, b: all(
            problem.is_free(problem.steer(a, b, t * problem.distance(a, b)))
            for t in np.linspace(0, 1, 100)
        ),
    )


@wrong("adjacency_matrix")
def every_hundredth(problem, nodes):
    """Checks points 0.01 apart, and still misses a very thin wall."""

    def is_joined(a, b):
        far = problem.distance(a, b)
        return all(problem.is_free(problem.steer(a, b, s)) for s in np.arange(0, far, 0.01))

    return filled(nodes, is_joined)


@wrong("adjacency_matrix", slip="one_side")
def below_the_diagonal(problem, nodes):
    """Writes each pair once, below the diagonal."""
    return np.tril(filled(nodes, problem.is_free_path))


@wrong("adjacency_matrix", slip="touching")
def touches_allowed(problem, nodes):
    """Checks for semi-free instead of free."""
    return filled(nodes, problem.is_semi_free_path)


@wrong("adjacency_matrix", slip="one_side")
def upper_half(problem, nodes):
    """Writes each pair once."""
    return np.triu(filled(nodes, problem.is_free_path))


@wrong("adjacency_matrix", slip="loops")
def joined_to_itself(problem, nodes):
    """Puts 1 on the diagonal, since staying is free."""
    return filled(nodes, problem.is_free_path) + np.eye(len(nodes))


@wrong("adjacency_matrix", slip="contact")
def ones_for_contact(problem, nodes):
    """Swaps 0 and 1."""
    return filled(nodes, lambda a, b: not problem.is_free_path(a, b))


@wrong("adjacency_matrix", slip="chained")
def each_to_the_next(problem, nodes):
    """Forgets all other pairs."""
    n = len(nodes)
    A = np.zeros((n, n))
    for i in range(n - 1):
        A[i, i + 1] = A[i + 1, i] = problem.is_free_path(nodes[i], nodes[i + 1])
    return A


@wrong("adjacency_matrix")
def only_the_ten_nearest(problem, nodes):
    """Joins each node to its ten nearest, as the lesson's roadmap does."""
    A = filled(nodes, problem.is_free_path)
    near = np.zeros_like(A)
    for i, a in enumerate(nodes):
        near[i, np.argsort([problem.distance(a, b) for b in nodes])[:11]] = 1
    return A * np.maximum(near, near.T)


@wrong("adjacency_matrix")
def last_one_forgotten(problem, nodes):
    """Loops over range(n - 1)."""
    A = filled(nodes, problem.is_free_path)
    A[-1, :] = A[:, -1] = 0
    return A


@wrong("adjacency_matrix")
def without_start(problem, nodes):
    """Counts from 1, and so has a row and a column too many."""
    return np.pad(filled(nodes, problem.is_free_path), ((1, 0), (1, 0)))


@wrong("adjacency_matrix")
def lengths_for_ones(problem, nodes):
    """Writes distances instead of ones."""
    return filled(nodes, lambda a, b: round(problem.distance(a, b)) * problem.is_free_path(a, b))


@wrong("adjacency_matrix")
def heading_left_out(problem, nodes):
    """Checks a translation without rotation."""
    return filled(nodes, lambda a, b: problem.is_free_path(a, np.array([*b[:2], *a[2:]])))


# Breadth-first search on a matrix


def searched(A, start, goal, take):
    """Search from the start, where `take` removes a node from the list, and return the path."""
    parent, waiting = {start: None}, deque([start])
    while waiting:
        u = take(waiting)
        for v in np.flatnonzero(A[u]).tolist():
            if v not in parent:
                parent[v] = u
                waiting.append(v)
    if goal not in parent:
        return None
    path = [goal]
    while parent[path[-1]] is not None:
        path.append(parent[path[-1]])
    return path[::-1]


def deep(A, start, goal):
    """Return a right depth-first path."""
    entered = set()

    def enter(u):
        entered.add(u)
        if u == goal:
            return [u]
        for v in np.flatnonzero(A[u]).tolist():
            if v not in entered:
                way = enter(v)
                if way:
                    return [u, *way]
        return None

    return enter(start)


@wrong("bfs_on_matrix", slip="deep")
def depth_first(A, start, goal):
    """Returns a depth-first path instead of a shortest one."""
    return deep(A, start, goal)


@wrong("bfs_on_matrix", slip="order")
def order_of_visit(A, start, goal):
    """Returns all nodes that were taken out before the goal."""
    seen, queue, order = {start}, deque([start]), []
    while queue:
        u = queue.popleft()
        order.append(u)
        if u == goal:
            return order
        for v in np.flatnonzero(A[u]).tolist():
            if v not in seen:
                seen.add(v)
                queue.append(v)
    return None


@wrong("bfs_on_matrix", slip="reversed")
def from_goal_to_start(A, start, goal):
    """Returns the path in reverse."""
    path = searched(A, start, goal, deque.popleft)
    return path and path[::-1]


@wrong("bfs_on_matrix")
def newest_first(A, start, goal):
    """Uses pop(), which makes a stack."""
    return searched(A, start, goal, deque.pop)


@wrong("bfs_on_matrix")
def empty_for_none(A, start, goal):
    """Returns an empty list instead of None."""
    return searched(A, start, goal, deque.popleft) or []


@wrong("bfs_on_matrix")
def without_the_start(A, start, goal):
    """Stops one node too early."""
    path = searched(A, start, goal, deque.popleft)
    return path and path[1:]


@wrong("bfs_on_matrix")
def always_straight(A, start, goal):
    """Checks one edge only."""
    return [start, goal] if A[start][goal] else None


@wrong("bfs_on_matrix")
def nowhere_to_go(A, start, goal):
    """Returns None where start and goal are the same."""
    return None if start == goal else searched(A, start, goal, deque.popleft)


@wrong("bfs_on_matrix")
def first_row_only(A, start, goal):
    """Begins with node 0, whatever the start is."""
    return searched(A, 0, goal, deque.popleft)


# Depth-first search on a matrix


@wrong("dfs_on_matrix", slip="order")
def as_entered(A, start, goal):
    """Returns dead ends too."""
    entered = []

    def enter(u):
        entered.append(u)
        return u == goal or any(enter(v) for v in np.flatnonzero(A[u]).tolist() if v not in entered)

    return entered if enter(start) else None


@wrong("dfs_on_matrix", slip="never_back")
def gives_up(A, start, goal):
    """Goes to the first new neighbour, and gives up in a dead end."""
    path = [start]
    while path[-1] != goal:
        new = [v for v in np.flatnonzero(A[path[-1]]).tolist() if v not in path]
        if not new:
            return None
        path.append(new[0])
    return path


@wrong("dfs_on_matrix", slip="reversed")
def deep_from_goal_to_start(A, start, goal):
    """Returns the path in reverse."""
    path = deep(A, start, goal)
    return path and path[::-1]


@wrong("dfs_on_matrix")
def deep_but_empty_for_none(A, start, goal):
    """Returns an empty list instead of None."""
    return deep(A, start, goal) or []


@wrong("dfs_on_matrix")
def deep_without_the_goal(A, start, goal):
    """Leaves the goal out."""
    path = deep(A, start, goal)
    return path and path[:-1]


@wrong("dfs_on_matrix")
def never_marked(A, start, goal):
    """Marks nothing, and so goes back and forth for ever."""

    def enter(u):
        if u == goal:
            return [u]
        for v in np.flatnonzero(A[u]).tolist():
            way = enter(v)
            if way:
                return [u, *way]
        return None

    return enter(start)


@wrong("dfs_on_matrix")
def path_of_the_call_not_returned(A, start, goal, seen=()):
    """Calls itself, and drops the path that this call finds."""
    if start == goal:
        return [*seen, goal]
    for v in np.flatnonzero(A[start]).tolist():
        if v not in seen:
            path_of_the_call_not_returned.function(A, v, goal, (*seen, start))
    return None


@wrong("dfs_on_matrix")
def parent_0_taken_for_none(A, start, goal):
    """Stops going back at node 0."""
    path = deep(A, start, goal)
    return path[path.index(0) + 1 :] if path and 0 in path[:-1] else path


@wrong("dfs_on_matrix")
def seen_on_this_way_only(A, start, goal):
    """Unmarks nodes when it goes back, and so tries all simple paths."""

    def enter(u, path):
        if u == goal:
            return path
        for v in np.flatnonzero(A[u]).tolist():
            way = None if v in path else enter(v, [*path, v])
            if way:
                return way
        return None

    return enter(start, [start])


@wrong("dfs_on_matrix")
def deep_from_zero(A, start, goal):
    """Begins with node 0, whatever the start is."""
    return deep(A, 0, goal)


# RRT for a polygon that turns


def grown(
    problem,
    step,
    goal_bias,
    iterations,
    rng,
    *,
    free=None,
    nearest=min,
    apart=None,
    last=None,
    chance=None,
    steer=None,
    turned=True,
):
    """Grow an RRT that is right except for what the arguments replace."""
    chance = chance or np.random.default_rng(rng)
    free, apart, steer = (
        free or problem.is_free_path,
        apart or problem.distance,
        steer or problem.steer,
    )
    nodes, parent = [problem.start], [-1]

    def way():
        i, path = len(nodes) - 1, []
        while i >= 0:
            path.append(nodes[i])
            i = parent[i]
        return np.array(path[::-1] if turned else path)

    def at_goal():
        if problem.distance(nodes[-1], problem.goal) > step or not (last or free)(
            nodes[-1], problem.goal
        ):
            return False
        nodes.append(problem.goal)
        parent.append(len(nodes) - 2)
        return True

    if at_goal():
        return np.array(nodes), parent, way()
    for _ in range(iterations):
        q = problem.goal if chance.random() < goal_bias else problem.sample(chance)
        i = nearest(range(len(nodes)), key=lambda k: apart(nodes[k], q))
        new = steer(nodes[i], q, step)
        if free(nodes[i], new):
            nodes.append(new)
            parent.append(i)
            if at_goal():
                return np.array(nodes), parent, way()
    return np.array(nodes), parent, None


@wrong("rrt_for_polygon")
def one_iteration_too_many(problem, step, goal_bias, iterations, rng):
    """Makes one iteration more than it is told."""
    return grown(problem, step, goal_bias, iterations + 1, rng)


the_usual_step = changed("rrt_for_polygon", ("q_rand, step)", "q_rand, 2.0)"))
goal_within_the_usual_step = changed("rrt_for_polygon", ("goal) <= step", "goal) <= 2.0"))


@wrong("rrt_for_polygon")
def asks_about_ends(problem, *given):
    """Checks only whether the new configuration is free."""
    return grown(problem, *given, free=lambda a, b: problem.is_free(b))


@wrong("rrt_for_polygon")
def asks_about_points(problem, *given):
    """Checks three configurations of the motion."""
    return grown(
        problem,
        *given,
        free=lambda a, b: all(
            problem.is_free(problem.steer(a, b, t * problem.distance(a, b))) for t in (0.5, 1)
        ),
    )


@wrong("rrt_for_polygon")
def last_edge_unasked(problem, *given):
    """Takes a node near the goal for the goal."""
    return grown(problem, *given, last=lambda a, b: True)


@wrong("rrt_for_polygon")
def farthest_for_nearest(problem, step, goal_bias, iterations, rng):
    """Uses max instead of min, with few iterations, since it gets nowhere."""
    return grown(problem, step, goal_bias, min(iterations, 60), rng, nearest=max)


@wrong("rrt_for_polygon")
def from_the_root(problem, *given):
    """Extends the start in every iteration."""
    return grown(problem, *given, nearest=lambda numbers, key: 0)


@wrong("rrt_for_polygon")
def headings_as_numbers(problem, *given):
    """Takes 3.1 and -3.1 for far apart."""
    return grown(problem, *given, apart=lambda a, b: np.linalg.norm(a - b))


@wrong("rrt_for_polygon")
def steered_as_numbers(problem, *given):
    """Interpolates headings as numbers, and so goes the long way round.

    The motion that it checks is therefore another one.
    """

    def straight(a, b, step):
        return a + (b - a) * min(1.0, step / (np.linalg.norm(b - a) or 1.0))

    return grown(problem, *given, steer=straight)


@wrong("rrt_for_polygon")
def own_chance(problem, step, goal_bias, iterations, rng):
    """Uses default_rng() without a seed."""
    return grown(problem, step, goal_bias, iterations, rng, chance=np.random.default_rng())


@wrong("rrt_for_polygon")
def chance_of_all(problem, step, goal_bias, iterations, rng):
    """Seeds and uses Python's global generator."""
    random.seed(rng)
    return grown(problem, step, goal_bias, iterations, int(random.random() * 1e9))


@wrong("rrt_for_polygon")
def path_from_the_goal(problem, *given):
    """Returns the path in reverse."""
    return grown(problem, *given, turned=False)


@wrong("rrt_for_polygon")
def asks_about_twenty_places(problem, *given):
    """Checks twenty points of the motion, and so misses a thin wall."""

    def seen(a, b):
        return all(
            problem.is_free(problem.steer(a, b, t * problem.distance(a, b)))
            for t in np.linspace(0, 1, 20)
        )

    return grown(problem, *given, free=seen, last=seen)


@wrong("rrt_for_polygon")
def half_steps(problem, step, goal_bias, iterations, rng):
    """Takes the step for a diameter, and so does not join a goal that is a step away."""
    return grown(problem, step / 2, goal_bias, iterations, rng)


@wrong("rrt_for_polygon")
def one_iteration_less(problem, step, goal_bias, iterations, rng):
    """Loops over range(1, iterations)."""
    return grown(problem, step, goal_bias, iterations - 1, rng)


@wrong("rrt_for_polygon")
def never_the_goal(problem, step, goal_bias, iterations, rng):
    """Ignores goal_bias."""
    return grown(problem, step, 0.0, iterations, rng)


steps_touch = changed(
    "rrt_for_polygon", ("is_free_path(nodes[near]", "is_semi_free_path(nodes[near]")
)
last_step_touches = changed(
    "rrt_for_polygon", ("is_free_path(nodes[last]", "is_semi_free_path(nodes[last]")
)
nearer_than_a_step = changed("rrt_for_polygon", ("goal) <= step", "goal) < step"))
twelve_iterations_too_many = changed("rrt_for_polygon", ("iterations + 1", "iterations + 13"))


# Four chords


@wrong("exposing_obstacle")
def no_triangle():
    """Gives three corners on a line."""
    return (0, 0), (4, 0), [(1, 1), (2, 2), (3, 3)]


@wrong("exposing_obstacle")
def beside_the_way():
    """Gives a triangle that the disk does not hit."""
    return (0, 0), (4, 0), [(1, 2), (3, 2), (2, 3)]


@wrong("exposing_obstacle")
def on_the_way():
    """Gives a triangle that a chord hits too."""
    return (0, 0), (4, 0), [(1, -0.5), (3, -0.5), (2, 0.5)]


@wrong("exposing_obstacle")
def a_thin_one():
    """Exposes the program, but with a thin triangle."""
    return (0, 0), (4, 0), [(1, 0.4), (3, 0.4), (2, 0.6)]


@wrong("exposing_obstacle")
def on_the_diagonal():
    """Moves diagonally, where the chords are closer to each other."""
    return (0, 0), (9, 9), [(3.1, 3.5), (6.0, 6.4), (4.4, 5.2)]


@wrong("exposing_obstacle")
def too_far_away():
    """Gives coordinates out of range."""
    return (0, 0), (1e6, 0), [(1, 0.1), (9, 0.1), (5, 0.9)]


@wrong("exposing_obstacle")
def corner_on_the_chord():
    """Fills the gap between two chords, and so touches one."""
    return (0, 0), (9, 0), [(-3, 0), (12, 0), (5, 1)]


# Variants

BOTH_HALVES = "A[i, j] = A[j, i] = "
above_the_diagonal = varied("adjacency_matrix", "upper_half", (BOTH_HALVES, "A[j, i] = "))
contacts = varied("adjacency_matrix", "contact", (BOTH_HALVES, BOTH_HALVES + "not "))
lower_half = changed("adjacency_matrix", (BOTH_HALVES, "A[i, j] = "), variant="upper_half")
contact_with_itself = changed(
    "adjacency_matrix",
    (BOTH_HALVES, BOTH_HALVES + "not "),
    ("np.zeros((n, n), int)", "np.eye(n, dtype=int)"),
    variant="contact",
)

FREE = "return theta"
heading_in_degrees = varied("free_heading", "degrees", (FREE, "return math.degrees(theta)"))
heading_clockwise = varied("free_heading", "clockwise", (FREE, "return -theta"))
degrees_for_the_robot = changed(
    "free_heading",
    ("np.arange(0, 2 * math.pi, 0.1)", "np.arange(0, 360, 5)"),
    variant="degrees",
)
heading_half_a_turn_off = changed(
    "free_heading", (FREE, "return math.pi - theta"), variant="clockwise"
)
matrix_by_breadth_reversed = varied(
    "bfs_on_matrix", "from_goal", ("return path[::-1]", "return path")
)
matrix_by_depth_reversed = varied(
    "dfs_on_matrix", "from_goal", ("return path or None", "return path[::-1] or None")
)
zeros_by_breadth = varied(
    "bfs_on_matrix",
    "contact",
    ("np.flatnonzero(A[u]).tolist()", "[v for v in range(len(A)) if v != u and A[u][v] == 0]"),
)
zeros_by_depth = varied(
    "dfs_on_matrix", "contact", ("np.flatnonzero(A[path[-1]])", "np.flatnonzero(A[path[-1]] == 0)")
)
zeros_by_breadth_reversed = changed(
    "bfs_on_matrix",
    ("np.flatnonzero(A[u])", "np.flatnonzero(A[u] == 0)"),
    ("return path[::-1]", "return path"),
    variant="contact",
    slip="reversed",
)
goal_put_first = changed(
    "dfs_on_matrix",
    ("return path or None", "return [path[-1], *path[:-1]] if path else None"),
    variant="from_goal",
)
