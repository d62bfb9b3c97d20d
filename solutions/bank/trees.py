"""Wrong answers to the exercises of lesson 9.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import random
from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong

solutions = Solutions(Path(__file__).parents[1] / "09_trees.ipynb")
changed, varied = solutions.changed, solutions.varied
right = solutions.right


def nearest(problem, nodes, q):
    """Return the index of the nearest node."""
    return int(np.argmin([problem.distance(node, q) for node in nodes]))


def way_up(nodes, parent, node):
    """Return the nodes from a node to the root."""
    path = []
    while node >= 0:
        path.append(nodes[node])
        node = parent[node]
    return path


def free_samples(a, b, n):
    """Return an expression that checks n points of a motion."""
    return f"all(problem.is_free({a} + t * ({b} - {a})) for t in np.linspace(0, 1, {n}))"


# The tree roadmap

FREE = "problem.is_free_path(nodes[node], q)"

every_edge = changed("tree_roadmap", (FREE, "True"), slip="unchecked")
free_ends = changed("tree_roadmap", (FREE, "problem.is_free(q)"), slip="ends_only")
four_points = changed("tree_roadmap", (FREE, free_samples("nodes[node]", "q", 4)))
thirty_points = changed("tree_roadmap", (FREE, free_samples("nodes[node]", "q", 30)))
numbers_from_one = changed("tree_roadmap", ("append(node)", "append(node + 1)"), slip="from_one")
one_long_chain = changed("tree_roadmap", ("append(node)", "append(len(nodes) - 2)"), slip="chained")
everything_on_the_root = changed("tree_roadmap", ("append(node)", "append(0)"))
no_place_twice = changed(
    "tree_roadmap", (FREE, FREE + " and not any(np.array_equal(q, p) for p in nodes)")
)
stops_at_the_first_wall = changed(
    "tree_roadmap", ("append(node)", "append(node)\n        else:\n            break")
)
counts_nodes = changed(
    "tree_roadmap", ("for _ in range(iterations)", "while len(nodes) <= iterations")
)
new_chance_each_time = changed(
    "tree_roadmap",
    ("rng = np.random.default_rng(rng)", "seed = rng"),
    ("nodes, rng)", "nodes, np.random.default_rng(seed))"),
    slip="seeded_again",
)
touching = changed("tree_roadmap", (FREE, FREE.replace("free", "semi_free")), slip="touching")
no_root = changed("tree_roadmap", ("return nodes, parent", "return nodes[1:], parent[1:]"))


# RRT

FREE_STEP = "problem.is_free_path(nodes[near], q_new)"
FREE_LAST_STEP = "problem.is_free_path(nodes[-1], goal)"
NEAREST = "int(np.argmin([problem.distance(q, q_rand) for q in nodes]))"
STEP = "problem.steer(nodes[near], q_rand, step)"
SAMPLE = "problem.sample(rng)"
SEED = "default_rng(rng)"

last_edge_unchecked = changed("rrt", (FREE_LAST_STEP, "True"))
last_step_touches = changed("rrt", (FREE_LAST_STEP, FREE_LAST_STEP.replace("free", "semi_free")))
steps_touch = changed("rrt", (FREE_STEP, FREE_STEP.replace("free", "semi_free")))
points_for_edges = changed(
    "rrt", (FREE_STEP, "problem.is_free(q_new)"), (FREE_LAST_STEP, "problem.is_free(goal)")
)
ten_points_of_an_edge = changed(
    "rrt",
    (FREE_STEP, free_samples("nodes[near]", "q_new", 11)),
    (FREE_LAST_STEP, free_samples("nodes[-1]", "goal", 11)),
)
hundred_points_of_a_step = changed("rrt", (FREE_STEP, free_samples("nodes[near]", "q_new", 101)))
hundred_points_of_the_last_step = changed(
    "rrt", (FREE_LAST_STEP, free_samples("nodes[-1]", "goal", 101))
)
always_the_root = changed("rrt", (NEAREST, "0"))
root_with_long_steps = changed("rrt", (NEAREST, "0"), (STEP, "q_rand"))
farthest_for_nearest = changed("rrt", ("argmin", "argmax"))
nearest_by_straight_lines = changed(
    "rrt", (NEAREST, "int(np.argmin(np.linalg.norm(np.subtract(nodes, q_rand), axis=1)))")
)
the_last_node = changed("rrt", (NEAREST, "len(nodes) - 1"))
nearest_to_the_goal = changed("rrt", ("problem.distance(q, q_rand)", "problem.distance(q, goal)"))
whole_way_to_the_sample = changed("rrt", (STEP, "q_rand"))
unit_steps = changed(  # also past a sample that is nearer
    "rrt",
    (
        STEP,
        "nodes[near] + 1.2 * step * (q_rand - nodes[near])"
        " / max(problem.distance(nodes[near], q_rand), 1e-12)",
    ),
)
corner_samples = changed("rrt", (SAMPLE, "rng.random(2)"))
samples_near_the_start = changed("rrt", (SAMPLE, "0.7 * problem.sample(rng)"))
only_towards_the_goal = changed("rrt", ("rng.random() < goal_bias", "True"))
backwards = changed("rrt", ("path[::-1]", "path"))
nearly_there = changed(
    "rrt", ("nodes, parent, path[::-1]", "nodes[:-1], parent[:-1], path[::-1][:-1]")
)
no_rows_for_no_path = changed("rrt", ("parent, None", "parent, []"))
all_nodes_for_the_path = changed("rrt", ("path[::-1]", "nodes"))
start_left_out = changed("rrt", ("node >= 0", "parent[node] != -1"))
global_chance = changed("rrt", (SEED, "default_rng(np.random.randint(10**6))"))
never_the_same = changed("rrt", (SEED, "default_rng()"))
always_the_same = changed("rrt", (SEED, "default_rng(0)"))
last_digit_of_the_seed = changed("rrt", (SEED, "default_rng(rng % 10)"))
ignores_the_bias = changed("rrt", ("rng.random() < goal_bias", "False"))
asks_for_the_whole_way = changed("rrt", (FREE_STEP, "problem.is_free_path(nodes[near], q_rand)"))
waits_for_the_goal_as_a_sample = changed(
    "rrt", (FREE_LAST_STEP, "problem.distance(nodes[-1], goal) == 0")
)
half_a_step = changed("rrt", ("q_rand, step)", "q_rand, step / 2)"))
gives_up_soon = changed("rrt", ("goal, nodes", "iterations = 10\n    goal, nodes"))
goal_by_counting = changed(
    "rrt", ("rng.random() < goal_bias", "i % max(1, round(1 / goal_bias)) == 0")
)
coin_from_elsewhere = changed(
    "rrt",
    ("goal, nodes, parent = ", "coin = np.random.default_rng(0)\n    goal, nodes, parent = "),
    ("rng.random() < goal_bias", "coin.random() < goal_bias"),
)
goal_too_rarely = changed("rrt", ("rng.random() < goal_bias", "rng.random() < goal_bias**2"))
generator_made_anew = changed(
    "rrt",
    ("goal, nodes, parent = ", "seed = int(rng.integers(1000))\n    goal, nodes, parent = "),
    ("q_rand = goal if", "rng = np.random.default_rng(seed + i)\n        q_rand = goal if"),
)
one_sample_for_two = changed(
    "rrt",
    ("goal, nodes, parent = ", "sample, goal, nodes, parent = None, "),
    (
        "q_rand = goal if",
        "sample = problem.sample(rng) if i % 2 == 0 else sample\n        q_rand = goal if",
    ),
    ("goal_bias else " + SAMPLE, "goal_bias else sample"),
)
start_not_tried = changed("rrt", ("<= step and", "<= step * (len(nodes) > 1) and"))
ten_iterations_too_many = changed(
    "rrt", ("iterations + 1", "iterations + 11"), ("i < iterations and", "")
)
one_iteration_too_many = changed("rrt", ("i < iterations and ", ""))
one_iteration_too_few = changed("rrt", ("range(iterations + 1)", "range(iterations - 1)"))
nearer_than_a_step = changed("rrt", ("goal) <= step", "goal) < step"))
the_usual_step = changed("rrt", ("    goal, nodes", "    step = 1.0\n    goal, nodes"))
goal_within_the_usual_step = changed("rrt", ("goal) <= step", "goal) <= 1.0"))


@wrong("rrt")
def parents_from_one(problem, step, goal_bias, iterations, rng):
    """Returns parents that are one too large."""
    nodes, parent, path = right["rrt"](problem, step, goal_bias, iterations, rng)
    return nodes, [-1, *(p + 1 for p in parent[1:])], path


@wrong("rrt")
def straight_at_the_end(problem, step, goal_bias, iterations, rng):
    """Goes straight from the nearest node to the goal where no path was found."""
    nodes, parent, path = right["rrt"](problem, step, goal_bias, iterations, rng)
    if path is None:
        path = [*way_up(nodes, parent, nearest(problem, nodes, problem.goal))[::-1], problem.goal]
    return nodes, parent, path


@wrong("rrt")
def seeds_the_world(problem, step, goal_bias, iterations, rng):
    """Seeds and uses Python's global generator."""
    random.seed(rng)
    return right["rrt"](problem, step, goal_bias, iterations, random.randrange(10**6))


@wrong("rrt")
def many_nodes_at_once(problem, step, goal_bias, iterations, rng):
    """Extends as far as possible in every iteration."""
    rng = np.random.default_rng(rng)
    nodes, parent = [problem.start], [-1]
    for _ in range(iterations):
        q_rand = problem.sample(rng)
        near = nearest(problem, nodes, q_rand)
        while problem.distance(nodes[near], q_rand) > 0 and len(nodes) < 700:
            q_new = problem.steer(nodes[near], q_rand, step / 4)
            if not problem.is_free_path(nodes[near], q_new):
                break
            nodes.append(q_new)
            parent.append(near)
            near = nearest(problem, nodes, q_rand)
    return nodes, parent, None


# RRT-Connect

HALF = "way_to_root(*trees[1])"

bridge_unchecked = changed(
    "rrt_connect",
    ("if not problem", "if problem.distance(q_new, q) > 0 and not problem"),
    within="extend",
)
one_step_each = changed("rrt_connect", ("while q is not None and target", "if target"))
free_places = changed("rrt_connect", (FREE_STEP, "problem.is_free(q_new)"), within="extend")
from_the_newest = changed(
    "rrt_connect",
    ("int(np.argmin([problem.distance(node, q) for node in nodes]))", "len(nodes) - 1"),
    within="extend",
)
hundred_points_of_a_run = changed(
    "rrt_connect", (FREE_STEP, free_samples("nodes[near]", "q_new", 101)), within="extend"
)
connects_by_straight_lines = changed(
    "rrt_connect", ("problem.distance(node, q)", "np.linalg.norm(node - q)"), within="extend"
)
second_half_reversed = changed("rrt_connect", (HALF, HALF + "[::-1]"))
from_goal_to_start = changed("rrt_connect", ("*trees[1], path", "*trees[1], path[::-1]"))
up_to_the_meeting_place = changed("rrt_connect", (" + " + HALF, ""))
chance_without_seed = changed("rrt_connect", (SEED, "default_rng()"))
both_with_the_usual_step = changed("rrt_connect", ("    trees =", "    step = 1.0\n    trees ="))
one_seed_for_all = changed("rrt_connect", (SEED, "default_rng(7)"))
steps_twice_as_long = changed(
    "rrt_connect",
    ("sample(rng), step", "sample(rng), 2 * step"),
    ("target, step", "target, 2 * step"),
)
the_same_tree_always = changed(
    "rrt_connect", ("trees[turn % 2], trees[1 - turn % 2]", "trees[0], trees[1]")
)
turns_after_a_new_node = changed(
    "rrt_connect",
    (
        "trees[turn % 2], trees[1 - turn % 2]",
        "trees[len(trees[0][0]) > len(trees[1][0])], trees[len(trees[0][0]) <= len(trees[1][0])]",
    ),
)
ten_steps_at_most = changed(
    "rrt_connect",
    ("q = target\n", "q, steps = target, 0\n"),
    (
        "while q is not None and target",
        "while (steps := steps + 1) <= 10 and q is not None and target",
    ),
)
runs_in_every_second_turn = changed(
    "rrt_connect", ("while q is not None and", "while turn % 4 < 2 and q is not None and")
)
samples_until_free = changed(
    "rrt_connect",
    (
        "problem.sample(rng)",
        "next(q for q in iter(lambda: problem.sample(rng), 0) if problem.is_free(q))",
    ),
)
goal_now_and_then = changed(
    "rrt_connect",
    ("problem.sample(rng)", "problem.goal if rng.random() < 0.05 else problem.sample(rng)"),
)
a_generator_for_each_tree = changed(
    "rrt_connect",
    (
        "trees = [",
        "chance = [np.random.default_rng(k) for k in rng.integers(1000, size=2)]\n    trees = [",
    ),
    ("problem.sample(rng)", "problem.sample(chance[turn % 2])"),
)
trees_as_they_were_swapped = changed(
    "rrt_connect",
    (
        "    return *trees[0], *trees[1], None",
        "    first = iterations % 2\n    return *trees[first], *trees[1 - first], None",
    ),
)
nearly_there_is_there = changed(
    "rrt_connect", ("problem.distance(q, target) == 0", "problem.distance(q, target) < 0.05")
)
near_is_there = changed(
    "rrt_connect", ("problem.distance(q, target) == 0", "problem.distance(q, target) <= step")
)


turns_only_after_a_step = changed(
    "rrt_connect",
    ("for turn in range(iterations):", "turn = 0\n    for _ in range(iterations):"),
    ("        q = target\n", "        turn += target is not None\n        q = target\n"),
)


last_trees_named_by_their_turn = changed(
    "rrt_connect", ("return *trees[0], *trees[1], None", "return *here, *there, None")
)
no_path_where_start_is_goal = changed(
    "rrt_connect",
    (
        "    trees =",
        "    iterations *= problem.distance(problem.start, problem.goal) > 0\n    trees =",
    ),
)


@wrong("rrt_connect")
def swapped_after_a_turn(problem, step, iterations, rng):
    """Returns the goal's tree first."""
    a, b, c, d, path = right["rrt_connect"](problem, step, iterations, rng)
    return c, d, a, b, path


@wrong("rrt_connect")
def jump_across(problem, step, iterations, rng):
    """Joins the newest nodes of both trees at the end, whatever is between."""
    a, b, c, d, _ = right["rrt_connect"](problem, step, iterations, rng)
    return a, b, c, d, [*way_up(a, b, len(a) - 1)[::-1], *way_up(c, d, len(c) - 1)]


@wrong("rrt_connect")
def one_tree_alone(problem, step, iterations, rng):
    """Is an RRT, with only the goal as the other tree."""
    nodes, parent, path = right["rrt"](problem, step, 0.0, iterations, rng)
    return nodes, parent, [problem.goal], [-1], path


# One insertion of RRT*

PRICE = "lambda i: cost[i] + apart[i]"
FALLING = "for j in changed:"

nearest_parent = changed("insert", (PRICE, "lambda i: apart[i]"), slip="nearest")
parent_only = changed("insert", ("for i in near:", "for i in []:"), slip="no_rewiring")
cost_not_propagated = changed("insert", (FALLING, "for j in [i]:"), slip="not_below")
through_walls = changed(
    "insert", (" and problem.is_free_path(nodes[i], q_new)", ""), slip="unchecked"
)
children_but_not_theirs = changed(
    "insert", (FALLING, "for j in [i, *(k for k in range(n) if parent[k] == i)]:")
)
cheapest_node = changed("insert", (PRICE, "lambda i: cost[i]"))
straight_lines_for_distances = changed(
    "insert", ("problem.distance(q, q_new)", "np.linalg.norm(np.subtract(q, q_new))")
)
costs_not_updated = changed("insert", ("cost[j] -= gain", "pass"))
everybody_is_a_neighbour = changed("insert", ("apart[i] <= radius and ", ""))
nearer_than_the_radius = changed("insert", ("<= radius", "< radius"))
ten_thousand_for_infinity = changed(
    "insert",
    (
        "best = min(near, key=lambda i: cost[i] + apart[i])",
        "best, least = 0, 10**4\n    for i in near:\n        if cost[i] + apart[i] < least:\n"
        "            best, least = i, cost[i] + apart[i]",
    ),
)
ONE_PASS = """for k in range(1, n):
                        way = problem.distance(nodes[k], [*nodes, q_new][parent[k]])
                        cost[k] = cost[parent[k]] + way"""
three_passes = changed(
    "insert",
    ("for j in changed:  # grows as children are found", "for j in changed * 3:"),
    ("changed += [k for k in range(n) if parent[k] == j]", ONE_PASS),
    ("cost[j] -= gain", "cost[i] -= gain * (cost[i] > cost[n] + apart[i])"),
)


@wrong("insert")
def all_neighbours_rewired(problem, nodes, parent, cost, q_new, radius):
    """Rewires neighbours even where that is more expensive."""
    parents, costs = right["insert"](problem, nodes, parent, cost, q_new, radius)
    for i in range(1, len(nodes)):
        apart = problem.distance(nodes[i], q_new)
        if apart <= radius and i != parents[-1] and problem.is_free_path(nodes[i], q_new):
            parents[i], costs[i] = len(nodes), costs[-1] + apart
    return parents, costs


@wrong("insert")
def new_from_one(*given):
    """Counts the new node from 1."""
    parents, costs = right["insert"](*given)
    return [p + 1 if p == len(parents) - 1 else p for p in parents[:-1]] + [parents[-1] + 1], costs


@wrong("insert")
def costs_in_order_of_numbers(problem, nodes, parent, cost, q_new, radius):
    """Recomputes all costs in order, as if every parent came before its child."""
    parents, costs = cost_not_propagated.function(problem, nodes, parent, cost, q_new, radius)
    for i in range(len(nodes)):
        if 0 <= parents[i] < len(nodes):
            costs[i] = costs[parents[i]] + problem.distance(nodes[parents[i]], nodes[i])
    return parents, costs


@wrong("insert")
def neighbours_of_the_start(problem, nodes, parent, cost, q_new, radius):
    """Takes the distance to the start for the cost."""
    parents, costs = right["insert"](problem, nodes, parent, cost, q_new, radius)
    return parents, [*costs[:-1], problem.distance(nodes[0], q_new)]


# The stretch of a plan

PART = "problem.steer(a, b, horizon)"
SHORTER = "horizon -= problem.distance(a, b)"

on_to_the_next_corner = changed("follow", (PART, "b"), slip="to_the_corner")
trusts_the_plan = changed("follow", (" or not problem.is_free_path(a, q)", ""), slip="trusting")
horizon_for_each = changed(
    "follow", (SHORTER, "if (q != b).any():\n            break"), slip="each_within"
)
as_the_crow_flies = changed(
    "follow",
    (PART, "problem.steer(a, b, horizon - problem.distance(path[0], a))"),
    ("horizon <= 0", "problem.distance(path[0], a) >= horizon"),
    (SHORTER, ""),
)
whole_motion_asked = changed(
    "follow", ("is_free_path(a, q)", "is_free_path(a, b)"), slip="asking_beyond"
)
end_only = changed("follow", ("return gone", "return gone[-1:]"))
without_the_beginning = changed("follow", ("return gone", "return gone[1:]"))
same_row_again = changed(
    "follow", (PART, PART + " if horizon > 0 else a"), ("horizon <= 0 or ", "")
)
cut_away_from_the_horizon = changed("follow", (SHORTER, SHORTER.replace("b)", "q)")))
jumps_over_what_is_in_the_way = changed("follow", ("break", "continue"))


@wrong("follow", slip="before_the_corner")
def last_corner_before(problem, path, horizon):
    """Does not follow a part of a motion."""
    gone = [path[0]]
    for a, b in zip(path, path[1:]):
        horizon -= problem.distance(a, b)
        if horizon < -1e-12 or not problem.is_free_path(a, b):
            break
        gone.append(b)
    return gone


# Break it


@wrong("exposing_room")
def all_is_free():
    """Gives a triangle that is in no motion's way."""
    return (1, 1), (9, 9), [(4, 1), (6, 1), (5, 2)]


@wrong("exposing_room")
def goal_in_the_triangle():
    """Gives an invalid problem."""
    return (1, 1), (5, 5), [(4, 4), (6, 4), (5, 7)]


@wrong("exposing_room")
def thick_wall():
    """Gives a goal farther than a step from every reachable point."""
    return (1, 1), (9.5, 9.5), [(4, 12), (12, 4), (6, 6)]


@wrong("exposing_room")
def one_line():
    """Gives a triangle without an interior."""
    return (1, 1), (9, 1), [(5, 0), (5, 5), (5, 9)]


@wrong("exposing_room")
def round_the_end():
    """Blocks the straight motion, but not the path around the wall."""
    return (4.8, 5), (5.4, 5), [(5, 2), (5.2, 2), (5.1, 8)]


@wrong("exposing_room")
def outside():
    """Gives a goal outside the room."""
    return (1, 1), (11, 5), [(9, 4), (9.5, 4), (9.2, 6)]


# A thin wall, and contact

at_a_thousand_places = changed(
    "follow",
    (
        "problem.is_free_path(a, q)",
        "all(problem.is_free(a + s * (q - a)) for s in np.linspace(0, 1, 1000))",
    ),
)
follow_in_contact = changed(
    "follow", ("is_free_path(a, q)", "is_semi_free_path(a, q)"), slip="trusting"
)
insert_in_contact = changed("insert", ("is_free_path", "is_semi_free_path"))
no_short_stretch = changed("follow", ("horizon <= 0", "horizon < 0.01"))
lengths_of_straight_lines = changed(
    "follow", ("problem.distance(a, b)", "np.linalg.norm(np.subtract(a, b))")
)


# Variants

backwards_along_the_path = varied(
    "follow", "backwards", ("gone = [path[0]]", "path = path[::-1]\n    gone = [path[0]]")
)
backwards_unchecked = changed(
    "follow",
    ("gone = [path[0]]", "path = path[::-1]\n    gone = [path[0]]"),
    (" or not problem.is_free_path(a, q)", ""),
    variant="backwards",
    slip="trusting",
)
backwards_to_the_corner = changed(
    "follow",
    ("gone = [path[0]]", "path = path[::-1]\n    gone = [path[0]]"),
    ("problem.is_free_path(a, q)", "problem.is_free_path(a, b)"),
    variant="backwards",
    slip="asking_beyond",
)
turned_round_at_the_end = changed(
    "follow", ("return gone", "return gone[::-1]"), variant="backwards"
)
twice_the_horizon = varied(
    "follow", "double_speed", ("gone = [path[0]]", "gone, horizon = [path[0]], 2 * horizon")
)
twice_for_each_motion = changed(
    "follow",
    ("problem.steer(a, b, horizon)", "problem.steer(a, b, 2 * horizon)"),
    variant="double_speed",
)
twice_the_horizon_unchecked = changed(
    "follow",
    ("gone = [path[0]]", "gone, horizon = [path[0]], 2 * horizon"),
    (" or not problem.is_free_path(a, q)", ""),
    variant="double_speed",
    slip="trusting",
)
checks_whole_motions_at_double_speed = changed(
    "follow",
    ("gone = [path[0]]", "gone, horizon = [path[0]], 2 * horizon"),
    ("problem.is_free_path(a, q)", "problem.is_free_path(a, b)"),
    variant="double_speed",
    slip="asking_beyond",
)

GROWN = "    return nodes, parent"
root_is_its_own_parent = varied(
    "tree_roadmap",
    "own_parent",
    ("parent = [problem.start], [-1]", "parent = [problem.start], [0]"),
)
newest_node_first = varied(
    "tree_roadmap",
    "newest_first",
    (GROWN, "    return nodes[::-1], [len(nodes) - 1 - p if p >= 0 else p for p in parent[::-1]]"),
)
parents_not_renumbered = changed(
    "tree_roadmap", (GROWN, "    return nodes[::-1], parent[::-1]"), variant="newest_first"
)
every_parent_one_higher = changed(
    "tree_roadmap",
    (GROWN, "    return nodes, [p + 1 for p in parent]"),
    variant="own_parent",
    slip="from_one",
)
tree_path_reversed_in_place = changed("rrt", ("path[::-1]", "path.reverse()"))
INSERTED = "    return parent, cost"
new_node_first = varied(
    "insert",
    "new_first",
    (
        INSERTED,
        "    parent = [0 if p == n else p + 1 if p >= 0 else p for p in parent]\n"
        "    return [parent[n], *parent[:n]], [cost[n], *cost[:n]]",
    ),
)
APART, IN_REACH = "[problem.distance(q, q_new) for q in nodes]", "if apart[i] <= radius"
at_half_speed = varied(
    "insert",
    "half_speed",
    (APART, "[2 * problem.distance(q, q_new) for q in nodes]"),
    (IN_REACH, "if apart[i] <= 2 * radius"),
)
radius_as_a_time = changed(
    "insert", (APART, "[2 * problem.distance(q, q_new) for q in nodes]"), variant="half_speed"
)
new_first_but_old_parents = changed(
    "insert",
    (INSERTED, "    return [parent[n], *parent[:n]], [cost[n], *cost[:n]]"),
    variant="new_first",
)
