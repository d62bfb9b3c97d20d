"""Wrong answers to the exercises of lesson 10.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import heapq
import random
from math import ceil, floor, hypot, isfinite
from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong

solutions = Solutions(Path(__file__).parents[1] / "10_terrains.ipynb")
changed, varied = solutions.changed, solutions.varied

# RRT on a terrain


def rrt(problem, step, spacing, goal_bias, failures, rng, **how):
    """Grow a right RRT, for wrong answers whose mistake is in one place."""
    chance = how.get("chance") or np.random.default_rng(rng)
    nodes, parent, failed = [problem.start], [-1], 0
    free = how.get("free", problem.is_free_path)
    ends = how.get("ends", problem.is_free_path)
    pick = how.get("pick", np.argmin)
    done = False
    while failed < failures:
        near = problem.distance(nodes[-1], problem.goal) <= how.get("reach", step)
        if len(nodes) > how.get("first", 0) and near and ends(nodes[-1], problem.goal):
            done = True
            break
        q_rand = (
            problem.goal
            if how.get("at_goal", chance.random() < goal_bias)
            else how.get("sample", problem.sample)(chance)
        )
        near = int(pick([problem.distance(q, q_rand) for q in nodes]))
        q_new = problem.steer(nodes[near], q_rand, how.get("stride", step))
        failed += 1
        apart = (
            problem.distance(nodes[near], q_new)
            if how.get("nearest_only")
            else min(problem.distance(q, q_new) for q in nodes)
        )
        if apart >= spacing * how.get("spaced", 1.0) and free(nodes[near], q_new):
            nodes.append(q_new)
            parent.append(near)
            failed = failed if how.get("in_all") else 0
    if not done:
        return nodes, parent, None
    nodes.append(problem.goal)
    parent.append(len(nodes) - 2)
    path, i = [], len(nodes) - 1
    while i >= 0:
        path.append(nodes[i])
        i = parent[i]
    return nodes, parent, path[::-1]


@wrong("rrt_on_terrain")
def last_edge_unchecked(*given):
    """Takes a node near the goal for the goal, as the document does."""
    return rrt(*given, ends=lambda a, b: True)


@wrong("rrt_on_terrain")
def nothing_checked(*given):
    """Checks no motion."""
    return rrt(*given, free=lambda a, b: True)


@wrong("rrt_on_terrain")
def ends_only(problem, *given):
    """Checks the new configuration, but not the motion to it."""
    return rrt(problem, *given, free=lambda a, b: problem.is_free(b))


@wrong("rrt_on_terrain")
def every_half_cell(problem, *given):
    """Checks samples half a cell apart, as the document does."""

    def sampled(a, b):
        n = int(problem.distance(a, b) / 2.5)
        return all(problem.is_free(a + (b - a) * k / max(n, 1)) for k in range(n + 1))

    return rrt(problem, *given, free=sampled, ends=sampled)


@wrong("rrt_on_terrain")
def farthest_node(*given):
    """Uses argmax instead of argmin."""
    return rrt(*given, pick=np.argmax)


@wrong("rrt_on_terrain")
def newest_node(*given):
    """Grows from the last node."""
    return rrt(*given, pick=lambda apart: len(apart) - 1)


@wrong("rrt_on_terrain")
def failures_in_all(*given):
    """Never resets the count of failures."""
    return rrt(*given, in_all=True)


@wrong("rrt_on_terrain")
def no_spacing(*given):
    """Ignores the spacing.

    Without a path such a tree would grow for ever, so it ends at the allowed number of nodes.
    """
    problem, step, _, goal_bias, _, rng = given
    return rrt(problem, step, 0.0, goal_bias, 8, rng)


half_a_step_for_the_spacing = changed("rrt_on_terrain", (">= spacing", ">= step / 2"))
the_usual_spacing = changed("rrt_on_terrain", (">= spacing", ">= 3.0"))
less_than_a_step = changed("rrt_on_terrain", ("goal) <= step", "goal) < step"))
last_step_touches = changed(
    "rrt_on_terrain", ("is_free_path(nodes[-1]", "is_semi_free_path(nodes[-1]")
)
hundred_points_of_the_last_step = changed(
    "rrt_on_terrain",
    (
        "problem.is_free_path(nodes[-1], goal)",
        "all(problem.is_free(nodes[-1] + t * (goal - nodes[-1])) for t in np.linspace(0, 1, 101))",
    ),
)
hundred_points_of_a_step = changed(
    "rrt_on_terrain",
    (
        "problem.is_free_path(nodes[near], q_new)",
        "all(problem.is_free(q_new + t * (nodes[near] - q_new)) for t in np.linspace(0, 1, 101))",
    ),
)
steps_touch = changed(
    "rrt_on_terrain", ("is_free_path(nodes[near]", "is_semi_free_path(nodes[near]")
)
farther_than_the_spacing = changed("rrt_on_terrain", (">= spacing", "> spacing"))


@wrong("rrt_on_terrain")
def half_spacing(*given):
    """Refuses only nodes nearer than half the spacing."""
    return rrt(*given, spaced=0.5)


@wrong("rrt_on_terrain")
def global_chance(problem, step, spacing, goal_bias, failures, rng):
    """Uses Python's global generator to decide when to try the goal."""

    class Chance:
        own = np.random.default_rng(rng)

        def __getattr__(self, name):
            return (
                random.random
                if name == "random" and random.random() < 2
                else getattr(self.own, name)
            )

    chance = Chance()
    return rrt(
        problem,
        step,
        spacing,
        goal_bias,
        failures,
        rng,
        chance=chance,
        sample=lambda _: problem.sample(chance.own),
    )


@wrong("rrt_on_terrain")
def one_seed_for_all(problem, step, spacing, goal_bias, failures, rng):
    """Uses default_rng(0), whatever rng is."""
    return rrt(problem, step, spacing, goal_bias, failures, 0)


@wrong("rrt_on_terrain")
def one_failure_more(problem, step, spacing, goal_bias, failures, rng):
    """Has <= instead of < in the loop over failures."""
    return rrt(problem, step, spacing, goal_bias, failures + 1, rng)


@wrong("rrt_on_terrain")
def half_the_failures(problem, step, spacing, goal_bias, failures, rng):
    """Gives up too early, after half of the failures."""
    return rrt(problem, step, spacing, goal_bias, failures // 2, rng)


@wrong("rrt_on_terrain")
def goal_too_seldom(problem, step, spacing, goal_bias, failures, rng):
    """Takes the goal half as often, except where it is always the target."""
    seldom = goal_bias if goal_bias == 1.0 else goal_bias / 2.0
    return rrt(problem, step, spacing, seldom, failures, rng)


@wrong("rrt_on_terrain")
def path_from_the_goal(*given):
    """Returns the path in reverse."""
    nodes, parent, path = rrt(*given)
    return nodes, parent, None if path is None else path[::-1]


@wrong("rrt_on_terrain")
def without_the_goal(*given):
    """Ends the path one node before the goal."""
    nodes, parent, path = rrt(*given)
    return nodes, parent, None if path is None else path[:-1]


@wrong("rrt_on_terrain")
def two_strides(*given):
    """Takes steps that are twice as long."""
    return rrt(*given, stride=2 * given[1])


@wrong("rrt_on_terrain")
def goal_not_tried_from_the_start(*given):
    """Tries the goal only after a node has been added."""
    return rrt(*given, first=1)


@wrong("rrt_on_terrain")
def never_draws_the_goal(*given):
    """Ignores goal_bias."""
    return rrt(*given, at_goal=False)


@wrong("rrt_on_terrain")
def bias_the_other_way(problem, step, spacing, goal_bias, failures, rng):
    """Has > instead of <."""
    return rrt(problem, step, spacing, 1.0 - goal_bias, failures, rng)


# PRM on a terrain


def prm(problem, n, rng, **how):
    """Build a right PRM, for wrong answers whose mistake is in one place."""
    chance, nodes = np.random.default_rng(rng), [problem.start, problem.goal]
    while len(nodes) < n + 2:
        q = how.get("sample", problem.sample)(chance)
        if how.get("is_free", problem.is_free)(q):
            nodes.append(q)
    free, tried = how.get("free", problem.is_free_path), how.get("tried", lambda i, j: True)
    pairs = [(i, j) for i in range(n + 2) for j in range(i + 1, n + 2)]
    edges = [(i, j) for i, j in pairs if tried(i, j) and free(nodes[i], nodes[j])]
    return nodes, edges, way(problem, nodes, edges, **how)


def way(problem, nodes, edges, one_way=False, weight=None, **_):
    """Find the path from node 0 to node 1 by Dijkstra's algorithm."""
    cost, parent, heap = {0: 0.0}, {0: None}, [(0.0, 0)]
    around = {i: [] for i in range(len(nodes))}
    for i, j in edges:
        around[i].append(j)
        if not one_way:
            around[j].append(i)
    while heap:
        _, i = heapq.heappop(heap)
        for j in around[i]:
            new = cost[i] + (weight or problem.distance)(nodes[i], nodes[j])
            if new < cost.get(j, np.inf):
                cost[j], parent[j] = new, i
                heapq.heappush(heap, (new, j))
    if 1 not in parent:
        return None
    path, i = [], 1
    while i is not None:
        path.append(nodes[i])
        i = parent[i]
    return path[::-1]


@wrong("prm_on_terrain")
def fewest_edges(*given):
    """Counts edges instead of lengths."""
    return prm(*given, weight=lambda a, b: 1.0)


no_rows_where_there_is_no_path = changed(
    "prm_on_terrain", ("if path[-1] == 0 else None", "if path[-1] == 0 else []")
)


@wrong("prm_on_terrain")
def edges_one_way(*given):
    """Uses an edge only from the smaller index to the larger."""
    return prm(*given, one_way=True)


@wrong("prm_on_terrain")
def nodes_unchecked(*given):
    """Keeps samples in rocks."""
    return prm(*given, is_free=lambda q: True)


@wrong("prm_on_terrain")
def free_ends_are_enough(*given):
    """Joins all nodes, since both ends are free."""
    return prm(*given, free=lambda a, b: True)


@wrong("prm_on_terrain")
def ten_closest(problem, n, rng):
    """Joins only near nodes."""
    return prm(
        problem,
        n,
        rng,
        free=lambda a, b: problem.distance(a, b) < 12.0 and problem.is_free_path(a, b),
    )


@wrong("prm_on_terrain")
def ends_joined_last(*given):
    """Forgets to join the start to the goal."""
    return prm(*given, tried=lambda i, j: (i, j) != (0, 1))


@wrong("prm_on_terrain")
def too_few_nodes(problem, n, rng):
    """Counts start and goal among the n samples."""
    return prm(problem, n - 2, rng)


@wrong("prm_on_terrain")
def goal_first(*given):
    """Makes the goal node 0."""
    nodes, edges, path = prm(*given)
    return [nodes[1], nodes[0], *nodes[2:]], edges, path


@wrong("prm_on_terrain")
def from_one(*given):
    """Numbers the nodes from 1."""
    nodes, edges, path = prm(*given)
    return nodes, [(i + 1, j + 1) for i, j in edges], path


@wrong("prm_on_terrain")
def each_pair_twice(*given):
    """Lists (i, j) and (j, i)."""
    nodes, edges, path = prm(*given)
    return nodes, edges + [(j, i) for i, j in edges], path


@wrong("prm_on_terrain")
def seedless(problem, n, rng):
    """Uses a generator without a seed."""
    return prm(problem, n, None)


@wrong("prm_on_terrain")
def lower_half(problem, n, rng):
    """Samples only one half of the terrain."""
    return prm(problem, n, rng, sample=lambda chance: problem.sample(chance) * (1.0, 0.5))


@wrong("prm_on_terrain")
def new_generator_for_each_sample(problem, n, rng):
    """Makes a generator inside the loop."""
    seeds = iter(range(rng, rng + 100_000))
    return prm(
        problem, n, rng, sample=lambda chance: problem.sample(np.random.default_rng(next(seeds)))
    )


@wrong("prm_on_terrain")
def moved_out_of_rocks(problem, n, rng):
    """Moves a sample that is not free towards the start until it is."""

    def sample(chance):
        q = problem.sample(chance)
        while not problem.is_free(q):
            q = (q + problem.start) / 2.0
        return q

    return prm(problem, n, rng, sample=sample)


@wrong("prm_on_terrain")
def spread_out(problem, n, rng):
    """Throws away samples near others."""
    kept = []

    def sample(chance):
        for _ in range(100):
            q = problem.sample(chance)
            if problem.is_free(q) and all(problem.distance(q, p) > 1.0 for p in kept):
                break
        kept.append(q)
        return q

    return prm(problem, n, rng, sample=sample)


@wrong("prm_on_terrain")
def gives_up_early(problem, n, rng):
    """Draws at most ten times as many samples as it needs."""
    tries = iter(range(10 * n))
    return prm(problem, n, rng, is_free=lambda q: problem.is_free(q) or next(tries, None) is None)


last_two_digits_of_the_seed = changed(
    "rrt_on_terrain", ("default_rng(rng)", "default_rng(rng % 100)")
)
ignores_little_gains = changed(
    "prm_on_terrain", ("new < cost.get(v, np.inf)", "new < cost.get(v, np.inf) - 0.05")
)
one_coin_until_a_node_comes = changed(
    "rrt_on_terrain",
    (
        "q_rand = goal if rng.random() < goal_bias",
        "coin = coin if failed else rng.random()\n        q_rand = goal if coin < goal_bias",
    ),
)
path_reversed_in_place = changed("rrt_on_terrain", ("path[::-1]", "path.reverse()"))
pairs_both_ways = changed(
    "prm_on_terrain", ("for j in range(i + 1, n + 2)]", "for j in range(n + 2) if i != j]")
)
edges_touch = changed("prm_on_terrain", ("problem.is_free_path", "problem.is_semi_free_path"))
last_digit_of_the_seed = changed("prm_on_terrain", ("default_rng(rng)", "default_rng(rng % 10)"))


# Repeated numbers


def all_repeats(table, same):
    """Return all (i, j, column) with i < j for which same(i, j, column) holds."""
    n, m = np.shape(table)
    return [(i, j, c) for i in range(n) for j in range(i + 1, n) for c in range(m) if same(i, j, c)]


@wrong("repeated_rows", slip="neighbours")
def next_row_only(table):
    """Compares each row only with the next."""
    return all_repeats(table, lambda i, j, c: j == i + 1 and table[i][c] == table[j][c])


@wrong("repeated_rows", slip="whole")
def whole_rows_only(table):
    """Reports only rows that are entirely equal."""
    return all_repeats(table, lambda i, j, c: (table[i] == table[j]).all())


@wrong("repeated_rows", slip="first_column")
def first_column_only(table):
    """Looks only at the lengths."""
    return all_repeats(table, lambda i, j, c: c == 0 and table[i][c] == table[j][c])


@wrong("repeated_rows", slip="from_one")
def counted_from_one(table):
    """Counts from 1."""
    return [
        (i + 1, j + 1, c + 1)
        for i, j, c in all_repeats(table, lambda i, j, c: table[i][c] == table[j][c])
    ]


@wrong("repeated_rows", slip="both_ways")
def every_pair_twice(table):
    """Reports i and j in both orders."""
    n, m = table.shape
    return [
        (i, j, c)
        for i in range(n)
        for j in range(n)
        for c in range(m)
        if i != j and table[i, c] == table[j, c]
    ]


@wrong("repeated_rows", slip="itself")
def with_itself(table):
    """Begins j at i."""
    n, m = table.shape
    return [
        (i, j, c)
        for i in range(n)
        for j in range(i, n)
        for c in range(m)
        if table[i, c] == table[j, c]
    ]


@wrong("repeated_rows", slip="missing")
def as_text(table):
    """Compares texts, in which nan equals nan."""
    return all_repeats(table, lambda i, j, c: str(table[i][c]) == str(table[j][c]))


@wrong("repeated_rows", slip="close")
def nearly_the_same(table):
    """Takes close numbers for equal."""
    return all_repeats(table, lambda i, j, c: abs(table[i][c] - table[j][c]) < 0.51)


@wrong("repeated_rows", slip="close")
def is_close(table):
    """Uses NumPy's tolerance."""
    return all_repeats(table, lambda i, j, c: np.isclose(table[i][c], table[j][c]))


@wrong("repeated_rows", slip="close")
def seven_digits(table):
    """Compares rounded texts."""
    return all_repeats(table, lambda i, j, c: f"{table[i][c]:.7g}" == f"{table[j][c]:.7g}" != "nan")


@wrong("repeated_rows", slip="one_each")
def a_triple_for_each_pair(table):
    """Stops at the first equal column."""
    n = len(table)
    shared = [
        (i, j, np.flatnonzero(table[i] == table[j])) for i in range(n) for j in range(i + 1, n)
    ]
    return [(i, j, columns[0]) for i, j, columns in shared if len(columns)]


@wrong("repeated_rows")
def first_of_each(table):
    """Remembers only the first row of a number, and reports only pairs with it."""
    first, found = {}, []
    for i, row in enumerate(table):
        for c, value in enumerate(row):
            if (c, value) in first:
                found.append((first[c, value], i, c))
            first.setdefault((c, value), i)
    return found


@wrong("repeated_rows")
def across_columns(table):
    """Compares every number of a row with every number of the other."""
    n, m = table.shape
    return [
        (i, j, c)
        for i in range(n)
        for j in range(i + 1, n)
        for c in range(m)
        if table[i, c] in table[j]
    ]


no_zeros = changed("repeated_rows", ("if table[i, c] ==", "if table[i, c] and table[i, c] =="))


three_columns = changed("repeated_rows", ("in range(m)", "in range(min(m, 3))"))


# Comparing planners


def asked(run, planners, seeds):
    """Return the lengths of all runs."""
    return [[run(planner, seed) for seed in seeds] for planner in planners]


def row(runs, found=None, quarters=(0.25, 0.5, 0.75)):
    """Return the statistics of a planner's runs."""
    found = [length for length in runs if isfinite(length)] if found is None else found
    return [
        sum(map(isfinite, runs)) / len(runs),
        *(np.quantile(found, quarters) if len(found) else [np.nan] * 3),
    ]


@wrong("compare_planners", slip="mean")
def mean_for_median(run, planners, seeds):
    """Takes the mean instead of the median."""
    rows = [row(runs) for runs in asked(run, planners, seeds)]
    for one, runs in zip(rows, asked(run, planners, seeds)):
        found = [length for length in runs if isfinite(length)]
        one[2] = np.mean(found) if found else np.nan
    return rows


@wrong("compare_planners", slip="with_failures")
def infinite_among_them(run, planners, seeds):
    """Takes quartiles of all runs, also of failures."""
    with np.errstate(all="ignore"):
        return [row(runs, found=runs) for runs in asked(run, planners, seeds)]


@wrong("compare_planners", slip="failures_are_zero")
def zero_for_none(run, planners, seeds):
    """Gives a failure the length 0."""
    return [
        row(runs, found=[x if isfinite(x) else 0.0 for x in runs])
        for runs in asked(run, planners, seeds)
    ]


@wrong("compare_planners", slip="percent")
def in_percent(run, planners, seeds):
    """Returns 100 for all seeds."""
    return [
        [100 * share, *rest] for share, *rest in (row(runs) for runs in asked(run, planners, seeds))
    ]


@wrong("compare_planners", slip="whole_spread")
def from_least_to_most(run, planners, seeds):
    """Returns the shortest and the longest path."""
    return [row(runs, quarters=(0, 0.5, 1)) for runs in asked(run, planners, seeds)]


@wrong("compare_planners", slip="deviation")
def standard_deviations(run, planners, seeds):
    """Returns the mean and one standard deviation to both sides."""
    rows = []
    for runs in asked(run, planners, seeds):
        found = [length for length in runs if isfinite(length)]
        m, s = (np.mean(found), np.std(found)) if found else (np.nan, np.nan)
        rows.append([len(found) / len(runs), m - s, m, m + s])
    return rows


@wrong("compare_planners", slip="one_seed")
def once_is_enough(run, planners, seeds):
    """Runs each planner once, as the document does."""
    return [row([run(planner, seeds[0])]) for planner in planners]


@wrong("compare_planners", slip="counts")
def how_many(run, planners, seeds):
    """Returns a count instead of a fraction."""
    return [
        [share * len(seeds), *rest]
        for share, *rest in (row(runs) for runs in asked(run, planners, seeds))
    ]


@wrong("compare_planners", slip="not_between")
def one_of_the_lengths(run, planners, seeds):
    """Does not interpolate."""
    rows = [row(runs) for runs in asked(run, planners, seeds)]
    for one, runs in zip(rows, asked(run, planners, seeds)):
        found = sorted(length for length in runs if isfinite(length))
        one[1:] = (
            [found[int(quarter * (len(found) - 1))] for quarter in (0.25, 0.5, 0.75)]
            if found
            else [np.nan] * 3
        )
    return rows


@wrong("compare_planners")
def seeds_from_zero(run, planners, seeds):
    """Uses range(len(seeds)) instead of the seeds."""
    return [row([run(planner, seed) for seed in range(len(seeds))]) for planner in planners]


@wrong("compare_planners")
def no_path_no_row(run, planners, seeds):
    """Leaves out planners that never find a path."""
    return [row(runs) for runs in asked(run, planners, seeds) if any(map(isfinite, runs))]


@wrong("compare_planners")
def share_of_found(run, planners, seeds):
    """Drops failures first, so that the fraction is always 1."""
    return [[1.0, *row(runs)[1:]] for runs in asked(run, planners, seeds)]


first_planner_only = changed(
    "compare_planners", ("for planner in planners:", "for planner in planners[:1]:")
)
two_or_more = changed("compare_planners", ("if len(found) else", "if len(found) > 1 else"))


# What a motion costs


def pieces(cost, a, b):
    """Return the cells of a motion with its length in each."""
    shares = {0.0, 1.0}
    for p, q in zip(a, b):
        if p != q:
            shares |= {
                (line - p) / (q - p) for line in range(ceil(min(p, q)), floor(max(p, q)) + 1)
            }
    shares = sorted(t for t in shares if 0 <= t <= 1)
    for t, s in zip(shares, shares[1:]):
        x, y = a + (b - a) * (s + t) / 2
        yield int(x), int(y), (s - t) * hypot(*(b - a))


@wrong("cost_along", slip="ends")
def mean_of_the_ends(cost, a, b):
    """Takes the mean of the costs at both ends."""
    return hypot(*(b - a)) * (cost[int(a[1]), int(a[0])] + cost[int(b[1]), int(b[0])]) / 2


@wrong("cost_along", slip="middle")
def at_the_middle(cost, a, b):
    """Looks up one cost, at the midpoint."""
    x, y = (a + b) / 2
    return hypot(*(b - a)) * cost[int(y), int(x)]


@wrong("cost_along", slip="start")
def at_the_start(cost, a, b):
    """Looks up one cost, at the start."""
    return hypot(*(b - a)) * cost[int(a[1]), int(a[0])]


@wrong("cost_along", slip="sampled")
def every_half_unit(cost, a, b):
    """Sums over samples."""
    whole, total, s = hypot(*(b - a)), 0.0, 0.0
    while s < whole:
        x, y = a + (b - a) * s / whole
        total, s = total + 0.5 * cost[int(y), int(x)], s + 0.5
    return total


@wrong("cost_along", slip="transposed")
def column_first(cost, a, b):
    """Reads cost[x, y]."""
    return sum(
        cost[i, j] * s for i, j, s in pieces(cost, a, b) if i < len(cost) and j < len(cost[0])
    )


@wrong("cost_along", slip="upside_down")
def from_the_top(cost, a, b):
    """Has row 0 on top, as in an image."""
    return sum(cost[len(cost) - 1 - j, i] * s for i, j, s in pieces(cost, a, b))


@wrong("cost_along", slip="length")
def only_the_length(cost, a, b):
    """Ignores the costs."""
    return hypot(*(b - a))


@wrong("cost_along", slip="share")
def cost_per_length(cost, a, b):
    """Returns the mean cost."""
    return sum(cost[j, i] * s for i, j, s in pieces(cost, a, b)) / (hypot(*(b - a)) or np.nan)


@wrong("cost_along", slip="cells")
def sum_of_cells(cost, a, b):
    """Counts every cell once, however short the motion in it is."""
    return (
        sum(cost[j, i] for i, j, s in pieces(cost, a, b))
        if (a != b).any()
        else cost[int(a[1]), int(a[0])]
    )


@wrong("cost_along", slip="first_end")
def where_a_piece_begins(cost, a, b):
    """Looks up the cell at a piece's beginning instead of its midpoint."""
    shares = {0.0, 1.0}
    for p, q in zip(a, b):
        shares |= {
            (line - p) / (q - p) for line in range(ceil(min(p, q)), floor(max(p, q)) + 1) if p != q
        }
    shares, total = sorted(shares), 0.0
    for t, s in zip(shares, shares[1:]):
        x, y = a + (b - a) * t
        total += (s - t) * hypot(*(b - a)) * cost[int(y), int(x)]
    return total


@wrong("cost_along", slip="whole_x_only")
def cut_at_columns_only(cost, a, b):
    """Does not cut at whole y."""
    shares = [0.0, 1.0]
    if a[0] != b[0]:
        shares += [
            (x - a[0]) / (b[0] - a[0])
            for x in range(ceil(min(a[0], b[0])), floor(max(a[0], b[0])) + 1)
        ]
    shares, total = sorted(shares), 0.0
    for t, s in zip(shares, shares[1:]):
        x, y = a + (b - a) * (s + t) / 2
        total += (s - t) * hypot(*(b - a)) * cost[int(y), int(x)]
    return total


@wrong("cost_along")
def forward_only(cost, a, b):
    """Loops over range(ceil(a), ...), which is empty for motions to the left."""
    shares = [0.0, 1.0]
    for p, q in zip(a, b):
        shares += [(line - p) / (q - p) for line in range(ceil(p), floor(q) + 1) if p != q]
    shares, total = sorted(shares), 0.0
    for t, s in zip(shares, shares[1:]):
        x, y = a + (b - a) * (s + t) / 2
        total += (s - t) * hypot(*(b - a)) * cost[int(y), int(x)]
    return total


# Break it


@wrong("exposing_motion")
def ones_for_rocks():
    """Takes 1 for a blocked cell."""
    return [[0, 1], [0, 0]], (0.9985, 0.6485), (1.5, 1.15)


@wrong("exposing_motion")
def a_motion_that_is_seen():
    """Gives a motion with a sample in the rock."""
    return [[1, 0, 1]], (0.5, 0.5), (2.5, 0.5)


@wrong("exposing_motion")
def a_free_motion():
    """Gives a motion that misses the rock."""
    return [[1, 1], [1, 0]], (0.5, 0.5), (1.5, 0.5)


@wrong("exposing_motion")
def a_shallow_cut():
    """Cuts off a very small corner."""
    return [[1, 0], [1, 1]], (0.95, 0.85), (1.5, 1.4)


@wrong("exposing_motion")
def outside_the_terrain():
    """Ends the motion on the rim."""
    return [[1, 1], [1, 0]], (0.5, 0.5), (2.0, 1.5)


@wrong("exposing_motion")
def grey_cells():
    """Gives cells that are neither free nor blocked."""
    return [[1, 0.5]], (0.5, 0.5), (1.5, 0.5)


@wrong("exposing_motion")
def a_large_terrain():
    """Gives too many cells."""
    return np.ones((100, 100)), (0.5, 0.5), (1.5, 0.5)


@wrong("exposing_motion")
def a_middling_cut():
    """Cuts nearly deep enough."""
    return [[1, 0], [1, 1]], (0.98, 0.68), (1.5, 1.2)


# Short pieces, fractions, steep motions

short_pieces_left_out = changed(
    "cost_along",
    (
        "        x, y = a",
        "        if (s - t) * hypot(*(b - a)) < 0.01:\n            continue\n        x, y = a",
    ),
)
only_up_and_right = changed(
    "cost_along", ("range(ceil(min(p, q)), floor(max(p, q)) + 1)", "range(ceil(p), floor(q) + 1)")
)
cuts_not_sorted = changed("cost_along", ("    shares.sort()\n", ""))
last_piece_left_out = changed("cost_along", ("shares = [0.0, 1.0]", "shares = [0.0]"))
whole_costs = changed("cost_along", ("cost[int(y), int(x)]", "int(cost[int(y), int(x)])"))
nearly_in_place = changed(
    "cost_along",
    (
        "    shares = [0.0, 1.0]",
        "    if hypot(*(b - a)) < 1e-3:\n        return 0.0\n    shares = [0.0, 1.0]",
    ),
)
flat_is_level = changed(
    "cost_along", ("cost[int(y),", "cost[int(y if abs(b[1] - a[1]) > 0.001 else a[1]),")
)


@wrong("cost_along")
def rows_and_columns_exchanged_in_cuts(cost, a, b):
    """Cuts at as many whole x as there are rows, and at as many whole y as there are columns."""
    shares = {0.0, 1.0}
    for p, q, lines in zip(a, b, cost.shape):
        shares |= {(line - p) / (q - p) for line in range(lines + 1) if p != q}
    shares = sorted(t for t in shares if 0 <= t <= 1)
    total = 0.0
    for t, s in zip(shares, shares[1:]):
        x, y = a + (b - a) * (t + s) / 2
        total += (s - t) * hypot(*(b - a)) * cost[int(y), int(x)]
    return total


steep_is_upright = changed("cost_along", ("int(x)]", "int(x if abs(b[0] - a[0]) > 0.1 else a[0])]"))


# Variants

by_speed = varied("cost_along", "speed", ("* cost[int(y), int(x)]", "/ cost[int(y), int(x)]"))
squared_costs = varied(
    "cost_along", "squared", ("cost[int(y), int(x)]", "cost[int(y), int(x)] ** 2")
)
nearly_upright_is_upright = changed("cost_along", ("if p != q]", "if not np.isclose(p, q)]"))
speed_of_the_transposed = changed(
    "cost_along",
    ("* cost[int(y), int(x)]", "/ cost.T[int(y) % len(cost.T), int(x) % len(cost)]"),
    variant="speed",
)
speed_from_the_top = changed(
    "cost_along",
    ("* cost[int(y), int(x)]", "/ cost[::-1][int(y), int(x)]"),
    variant="speed",
    slip="upside_down",
)
square_of_the_whole = changed("cost_along", ("return total", "return total**2"), variant="squared")

TRIPLE = "[(i, j, c) for"
later_row_first = varied("repeated_rows", "later_first", (TRIPLE, "[(j, i, c) for"))
column_before_the_rows = varied("repeated_rows", "column_first", (TRIPLE, "[(c, i, j) for"))
column_before_the_later_row = changed(
    "repeated_rows", (TRIPLE, "[(c, j, i) for"), variant="column_first"
)
later_first_among_neighbours = changed(
    "repeated_rows",
    (TRIPLE, "[(j, i, c) for"),
    ("range(i + 1, n)", "range(i + 1, min(i + 2, n))"),
    variant="later_first",
    slip="neighbours",
)
