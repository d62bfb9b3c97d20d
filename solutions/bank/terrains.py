"""Wrong answers to the exercises of lesson 10. Each is one that students give; the slip is what a
check must recognise in it.
"""

import heapq
import random
from math import ceil, floor, hypot, isfinite

import numpy as np

from kinoedu.course.bank import wrong

# RRT on a terrain


def rrt(problem, step, spacing, goal_bias, failures, rng, **how):
    """A right RRT, for those that go wrong in one place."""
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
    """The document's own mistake: near the goal is taken for there."""
    return rrt(*given, ends=lambda a, b: True)


@wrong("rrt_on_terrain")
def nothing_checked(*given):
    """No motion is asked for."""
    return rrt(*given, free=lambda a, b: True)


@wrong("rrt_on_terrain")
def ends_only(problem, *given):
    """The new configuration is free; the motion to it may not be."""
    return rrt(problem, *given, free=lambda a, b: problem.is_free(b))


@wrong("rrt_on_terrain")
def every_half_cell(problem, *given):
    """The document's check, edges sampled every half cell, with long gaps."""

    def sampled(a, b):
        n = int(problem.distance(a, b) / 2.5)
        return all(problem.is_free(a + (b - a) * k / max(n, 1)) for k in range(n + 1))

    return rrt(problem, *given, free=sampled, ends=sampled)


@wrong("rrt_on_terrain")
def farthest_node(*given):
    """argmax for argmin."""
    return rrt(*given, pick=np.argmax)


@wrong("rrt_on_terrain")
def newest_node(*given):
    """Grows from the last node."""
    return rrt(*given, pick=lambda apart: len(apart) - 1)


@wrong("rrt_on_terrain")
def failures_in_all(*given):
    """The count is never set back to zero."""
    return rrt(*given, in_all=True)


@wrong("rrt_on_terrain")
def no_spacing(*given):
    """New nodes may be anywhere; where there is no way it grows for ever, so it ends with the nodes
    it may have.
    """
    problem, step, _, goal_bias, _, rng = given
    return rrt(problem, step, 0.0, goal_bias, 8, rng)


@wrong("rrt_on_terrain")
def half_spacing(*given):
    """Refuses only what is nearer than half the spacing."""
    return rrt(*given, spaced=0.5)


@wrong("rrt_on_terrain")
def global_chance(problem, step, spacing, goal_bias, failures, rng):
    """Decides by Python's own random numbers when to try the goal."""

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
    """default_rng(0), whatever rng is."""
    return rrt(problem, step, spacing, goal_bias, failures, 0)


@wrong("rrt_on_terrain")
def path_from_the_goal(*given):
    """The path is not turned round."""
    nodes, parent, path = rrt(*given)
    return nodes, parent, None if path is None else path[::-1]


@wrong("rrt_on_terrain")
def without_the_goal(*given):
    """Stops at the node before it."""
    nodes, parent, path = rrt(*given)
    return nodes, parent, None if path is None else path[:-1]


@wrong("rrt_on_terrain")
def two_strides(*given):
    """Steps twice as long as asked for."""
    return rrt(*given, stride=2 * given[1])


@wrong("rrt_on_terrain")
def goal_not_tried_from_the_start(*given):
    """The goal is looked for after a node has been added."""
    return rrt(*given, first=1)


@wrong("rrt_on_terrain")
def never_draws_the_goal(*given):
    """goal_bias is not used."""
    return rrt(*given, at_goal=False)


@wrong("rrt_on_terrain")
def bias_the_other_way(problem, step, spacing, goal_bias, failures, rng):
    """> for <."""
    return rrt(problem, step, spacing, 1.0 - goal_bias, failures, rng)


# PRM on a terrain


def prm(problem, n, rng, **how):
    """A right PRM, for those that go wrong in one place."""
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
    """Dijkstra's algorithm from node 0 to node 1."""
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
    """Breadth-first search counts edges."""
    return prm(*given, weight=lambda a, b: 1.0)


@wrong("prm_on_terrain")
def edges_one_way(*given):
    """Goes along an edge from the smaller number to the larger only."""
    return prm(*given, one_way=True)


@wrong("prm_on_terrain")
def nodes_unchecked(*given):
    """Samples in rocks are nodes too."""
    return prm(*given, is_free=lambda q: True)


@wrong("prm_on_terrain")
def free_ends_are_enough(*given):
    """Joins all nodes: both ends are free."""
    return prm(*given, free=lambda a, b: True)


@wrong("prm_on_terrain")
def ten_closest(problem, n, rng):
    """Joins only what is near."""
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
    """n tries, not n free samples: start and goal are among the n."""
    return prm(problem, n - 2, rng)


@wrong("prm_on_terrain")
def goal_first(*given):
    """The goal is node 0."""
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
    """A generator without a seed."""
    return prm(problem, n, None)


@wrong("prm_on_terrain")
def lower_half(problem, n, rng):
    """Samples one half of the terrain."""
    return prm(problem, n, rng, sample=lambda chance: problem.sample(chance) * (1.0, 0.5))


# Repeated numbers


def all_repeats(table, same):
    n, m = np.shape(table)
    return [(i, j, c) for i in range(n) for j in range(i + 1, n) for c in range(m) if same(i, j, c)]


@wrong("repeated_rows", slip="neighbours")
def next_row_only(table):
    """Compares each row with the one after it."""
    return all_repeats(table, lambda i, j, c: j == i + 1 and table[i][c] == table[j][c])


@wrong("repeated_rows", slip="whole")
def whole_rows_only(table):
    """Reports rows that are the same as a whole."""
    return all_repeats(table, lambda i, j, c: (table[i] == table[j]).all())


@wrong("repeated_rows", slip="first_column")
def first_column_only(table):
    """Looks at the lengths only."""
    return all_repeats(table, lambda i, j, c: c == 0 and table[i][c] == table[j][c])


@wrong("repeated_rows", slip="from_one")
def counted_from_one(table):
    """As a person counts."""
    return [
        (i + 1, j + 1, c + 1)
        for i, j, c in all_repeats(table, lambda i, j, c: table[i][c] == table[j][c])
    ]


@wrong("repeated_rows", slip="both_ways")
def every_pair_twice(table):
    """i and j in either order."""
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
    """j begins at i."""
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
    """Compares what is printed: nan looks like nan."""
    return all_repeats(table, lambda i, j, c: str(table[i][c]) == str(table[j][c]))


@wrong("repeated_rows", slip="close")
def nearly_the_same(table):
    """Takes near numbers for equal."""
    return all_repeats(table, lambda i, j, c: abs(table[i][c] - table[j][c]) < 0.51)


@wrong("repeated_rows", slip="close")
def is_close(table):
    """numpy's own idea of equal."""
    return all_repeats(table, lambda i, j, c: np.isclose(table[i][c], table[j][c]))


@wrong("repeated_rows", slip="close")
def seven_digits(table):
    """Compares what is printed, rounded."""
    return all_repeats(table, lambda i, j, c: f"{table[i][c]:.7g}" == f"{table[j][c]:.7g}" != "nan")


@wrong("repeated_rows", slip="one_each")
def a_triple_for_each_pair(table):
    """Stops at the first column that is the same."""
    n = len(table)
    shared = [
        (i, j, np.flatnonzero(table[i] == table[j])) for i in range(n) for j in range(i + 1, n)
    ]
    return [(i, j, columns[0]) for i, j, columns in shared if len(columns)]


@wrong("repeated_rows")
def first_of_each(table):
    """Remembers where a number was first, and reports pairs with that only."""
    first, found = {}, []
    for i, row in enumerate(table):
        for c, value in enumerate(row):
            if (c, value) in first:
                found.append((first[c, value], i, c))
            first.setdefault((c, value), i)
    return found


@wrong("repeated_rows")
def across_columns(table):
    """Compares every number of a row with every one of the other."""
    n, m = table.shape
    return [
        (i, j, c)
        for i in range(n)
        for j in range(i + 1, n)
        for c in range(m)
        if table[i, c] in table[j]
    ]


# Comparing planners


def asked(run, planners, seeds):
    return [[run(planner, seed) for seed in seeds] for planner in planners]


def row(runs, found=None, quarters=(0.25, 0.5, 0.75)):
    found = [length for length in runs if isfinite(length)] if found is None else found
    return [
        sum(map(isfinite, runs)) / len(runs),
        *(np.quantile(found, quarters) if len(found) else [np.nan] * 3),
    ]


@wrong("compare_planners", slip="mean")
def mean_for_median(run, planners, seeds):
    """The mean in the middle."""
    rows = [row(runs) for runs in asked(run, planners, seeds)]
    for one, runs in zip(rows, asked(run, planners, seeds)):
        found = [length for length in runs if isfinite(length)]
        one[2] = np.mean(found) if found else np.nan
    return rows


@wrong("compare_planners", slip="with_failures")
def infinite_among_them(run, planners, seeds):
    """Quartiles of all, failures as well."""
    with np.errstate(all="ignore"):
        return [row(runs, found=runs) for runs in asked(run, planners, seeds)]


@wrong("compare_planners", slip="failures_are_zero")
def zero_for_none(run, planners, seeds):
    """A failure has length 0."""
    return [
        row(runs, found=[x if isfinite(x) else 0.0 for x in runs])
        for runs in asked(run, planners, seeds)
    ]


@wrong("compare_planners", slip="percent")
def in_percent(run, planners, seeds):
    """100 for all."""
    return [
        [100 * share, *rest] for share, *rest in (row(runs) for runs in asked(run, planners, seeds))
    ]


@wrong("compare_planners", slip="whole_spread")
def from_least_to_most(run, planners, seeds):
    """The shortest and the longest path."""
    return [row(runs, quarters=(0, 0.5, 1)) for runs in asked(run, planners, seeds)]


@wrong("compare_planners", slip="deviation")
def standard_deviations(run, planners, seeds):
    """Mean, and one standard deviation to both sides."""
    rows = []
    for runs in asked(run, planners, seeds):
        found = [length for length in runs if isfinite(length)]
        m, s = (np.mean(found), np.std(found)) if found else (np.nan, np.nan)
        rows.append([len(found) / len(runs), m - s, m, m + s])
    return rows


@wrong("compare_planners", slip="one_seed")
def once_is_enough(run, planners, seeds):
    """One run each: the document's way."""
    return [row([run(planner, seeds[0])]) for planner in planners]


@wrong("compare_planners", slip="counts")
def how_many(run, planners, seeds):
    """A count for a share."""
    return [
        [share * len(seeds), *rest]
        for share, *rest in (row(runs) for runs in asked(run, planners, seeds))
    ]


@wrong("compare_planners", slip="not_between")
def one_of_the_lengths(run, planners, seeds):
    """No interpolation."""
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
    """range(len(seeds)) for the seeds."""
    return [row([run(planner, seed) for seed in range(len(seeds))]) for planner in planners]


@wrong("compare_planners")
def no_path_no_row(run, planners, seeds):
    """A planner that never finds a path has no row."""
    return [row(runs) for runs in asked(run, planners, seeds) if any(map(isfinite, runs))]


@wrong("compare_planners")
def share_of_found(run, planners, seeds):
    """The share is always 1: failures were thrown away first."""
    return [[1.0, *row(runs)[1:]] for runs in asked(run, planners, seeds)]


# What a motion costs


def pieces(cost, a, b):
    """The cells of a motion and the length in each."""
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
    """Half the sum of the costs at both ends."""
    return hypot(*(b - a)) * (cost[int(a[1]), int(a[0])] + cost[int(b[1]), int(b[0])]) / 2


@wrong("cost_along", slip="middle")
def at_the_middle(cost, a, b):
    """One look, halfway."""
    x, y = (a + b) / 2
    return hypot(*(b - a)) * cost[int(y), int(x)]


@wrong("cost_along", slip="start")
def at_the_start(cost, a, b):
    """One look, at the beginning."""
    return hypot(*(b - a)) * cost[int(a[1]), int(a[0])]


@wrong("cost_along", slip="sampled")
def every_half_unit(cost, a, b):
    """A sum over samples."""
    whole, total, s = hypot(*(b - a)), 0.0, 0.0
    while s < whole:
        x, y = a + (b - a) * s / whole
        total, s = total + 0.5 * cost[int(y), int(x)], s + 0.5
    return total


@wrong("cost_along", slip="transposed")
def column_first(cost, a, b):
    """cost[x, y]."""
    return sum(
        cost[i, j] * s for i, j, s in pieces(cost, a, b) if i < len(cost) and j < len(cost[0])
    )


@wrong("cost_along", slip="upside_down")
def from_the_top(cost, a, b):
    """Row 0 on top, as in a picture."""
    return sum(cost[len(cost) - 1 - j, i] * s for i, j, s in pieces(cost, a, b))


@wrong("cost_along", slip="length")
def only_the_length(cost, a, b):
    """The ground does not count."""
    return hypot(*(b - a))


@wrong("cost_along", slip="share")
def cost_per_length(cost, a, b):
    """The mean on the way."""
    return sum(cost[j, i] * s for i, j, s in pieces(cost, a, b)) / (hypot(*(b - a)) or np.nan)


@wrong("cost_along", slip="cells")
def sum_of_cells(cost, a, b):
    """Every cell counts once, however short the way through it."""
    return (
        sum(cost[j, i] for i, j, s in pieces(cost, a, b))
        if (a != b).any()
        else cost[int(a[1]), int(a[0])]
    )


@wrong("cost_along", slip="first_end")
def where_a_piece_begins(cost, a, b):
    """The cell of a piece's first end, not of its middle."""
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
    """Forgets the whole y."""
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
    """range(ceil(a), ...) is empty on the way back."""
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
def a_motion_that_is_seen():
    """A sample stands in the rock."""
    return [[1, 0, 1]], (0.5, 0.5), (2.5, 0.5)


@wrong("exposing_motion")
def a_free_motion():
    """Past the rock."""
    return [[1, 1], [1, 0]], (0.5, 0.5), (1.5, 0.5)


@wrong("exposing_motion")
def a_shallow_cut():
    """A corner, cut off by very little."""
    return [[1, 0], [1, 1]], (0.95, 0.85), (1.5, 1.4)


@wrong("exposing_motion")
def outside_the_terrain():
    """b lies on the rim."""
    return [[1, 1], [1, 0]], (0.5, 0.5), (2.0, 1.5)


@wrong("exposing_motion")
def grey_cells():
    """Cells are free or blocked."""
    return [[1, 0.5]], (0.5, 0.5), (1.5, 0.5)


@wrong("exposing_motion")
def a_large_terrain():
    """Too many cells to look at."""
    return np.ones((100, 100)), (0.5, 0.5), (1.5, 0.5)


@wrong("exposing_motion")
def a_middling_cut():
    """Nearly deep enough."""
    return [[1, 0], [1, 1]], (0.98, 0.68), (1.5, 1.2)
