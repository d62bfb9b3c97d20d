"""Typical wrong answers of students to the exercises of lesson 3.

A check must recognise the named misconception.
"""

from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong

solutions = Solutions(Path(__file__).parents[1] / "03_decomposition.ipynb")
changed, varied = solutions.changed, solutions.varied


def height(x, edge):
    ax, ay, bx, by = edge
    return ay + (x - ax) / (bx - ax) * (by - ay)


def crossed(x, edges):
    return [i for i, (ax, _, bx, _) in enumerate(edges) if min(ax, bx) < x < max(ax, bx)]


def status(x, edges):
    return sorted(crossed(x, edges), key=lambda i: height(x, edges[i]))


def all_edges(boundary, obstacles):
    return np.vstack(
        [np.hstack([ring, np.roll(ring, -1, axis=0)]) for ring in [boundary, *obstacles]]
    )


# The status


@wrong("crossings", slip="unsorted")
def in_the_order_given(x, edges):
    """Does not sort."""
    return crossed(x, edges)


@wrong("crossings", slip="top_down")
def from_the_top(x, edges):
    """Sorts the other way."""
    return status(x, edges)[::-1]


@wrong("crossings", slip="rightward")
def rightward_only(x, edges):
    """Tests ax < x < bx."""
    return [i for i in status(x, edges) if edges[i, 0] < x < edges[i, 2]]


@wrong("crossings", slip="middles")
def by_middles(x, edges):
    """Sorts by the middles."""
    return sorted(crossed(x, edges), key=lambda i: edges[i, 1] + edges[i, 3])


@wrong("crossings", slip="first_ends")
def by_first_ends(x, edges):
    """Sorts by the first ends."""
    return sorted(crossed(x, edges), key=lambda i: edges[i, 1])


@wrong("crossings", slip="lines")
def endless_lines(x, edges):
    """Treats edges as infinite lines."""
    return sorted(range(len(edges)), key=lambda i: height(x, edges[i]))


@wrong("crossings")
def heights_for_numbers(x, edges):
    """Returns the heights."""
    return sorted(height(x, edges[i]) + 0.5**9 for i in crossed(x, edges))


@wrong("crossings")
def by_lower_ends(x, edges):
    """Sorts by the lower ends."""
    return sorted(crossed(x, edges), key=lambda i: min(edges[i, 1], edges[i, 3]))


@wrong("crossings")
def lowest_and_highest(x, edges):
    """Keeps the first and the last."""
    return status(x, edges)[:1] + status(x, edges)[-1:]


@wrong("crossings", slip="renumbered")
def places_among_the_crossed(x, edges):
    """Numbers only the crossed edges."""
    return np.argsort([height(x, edges[i]) for i in crossed(x, edges)])


@wrong("crossings")
def none_for_an_empty_list(x, edges):
    """Returns None where nothing is crossed."""
    return status(x, edges) or None


@wrong("crossings")
def numbers_from_one(x, edges):
    """Counts from 1, as MATLAB does."""
    return [i + 1 for i in status(x, edges)]


steep_edges_left_out = changed(
    "crossings",
    ("!= (edges[i][2] < x)", "!= (edges[i][2] < x) and abs(edges[i][2] - edges[i][0]) > 0.01"),
)
rounded_heights = changed("crossings", ("height(edges[i], x)", "round(height(edges[i], x), 6)"))


@wrong("crossings")
def by_rounded_heights(x, edges):
    """Rounds the heights before it compares them."""
    return sorted(crossed(x, edges), key=lambda i: round(height(x, edges[i]), 3))


# The free intervals


def levels(x, boundary, obstacles):
    edges = all_edges(boundary, obstacles)
    return [height(x, edges[i]) for i in status(x, edges)]


@wrong("free_intervals", slip="hollow")
def every_gap(x, boundary, obstacles):
    """Returns solid intervals as well."""
    found = levels(x, boundary, obstacles)
    return list(zip(found, found[1:]))


@wrong("free_intervals", slip="solid")
def the_solid_ones(x, boundary, obstacles):
    """Begins with the second crossing."""
    found = levels(x, boundary, obstacles)[1:-1]
    return list(zip(found[::2], found[1::2]))


@wrong("free_intervals", slip="no_obstacles")
def empty_world(x, boundary, obstacles):
    """Forgets the obstacles."""
    return np.reshape(levels(x, boundary, []), (-1, 2))


@wrong("free_intervals", slip="outer")
def lowest_to_highest(x, boundary, obstacles):
    """Returns one interval."""
    found = levels(x, boundary, obstacles)
    return [(found[0], found[-1])]


@wrong("free_intervals", slip="top_down")
def topmost_first(x, boundary, obstacles):
    """Returns the intervals from top to bottom."""
    return np.reshape(levels(x, boundary, obstacles), (-1, 2))[::-1]


@wrong("free_intervals", slip="upside_down")
def upper_end_first(x, boundary, obstacles):
    """Returns ceiling, floor."""
    return np.reshape(levels(x, boundary, obstacles), (-1, 2))[:, ::-1]


@wrong("free_intervals")
def two_decimals(x, boundary, obstacles):
    """Rounds its answer."""
    return np.round(np.reshape(levels(x, boundary, obstacles), (-1, 2)), 2)


@wrong("free_intervals")
def flat(x, boundary, obstacles):
    """Returns one list of heights, not pairs."""
    return levels(x, boundary, obstacles)


@wrong("free_intervals")
def unclosed_rings(x, boundary, obstacles):
    """Forgets the edge that closes a ring."""
    edges = np.vstack([np.hstack([ring[:-1], ring[1:]]) for ring in [boundary, *obstacles]])
    found = [height(x, edges[i]) for i in status(x, edges)]
    return list(zip(found[::2], found[1::2]))


@wrong("free_intervals")
def one_ring_after_the_other(x, boundary, obstacles):
    """Does not sort the heights of different rings."""
    return np.vstack([np.reshape(levels(x, ring, []), (-1, 2)) for ring in [boundary, *obstacles]])


thin_stretches_left_out = changed(
    "free_intervals",
    (
        "list(zip(levels[::2], levels[1::2]))",
        "[(a, b) for a, b in zip(levels[::2], levels[1::2]) if b - a > 0.05]",
    ),
)
at_least_a_thousandth = changed(
    "free_intervals",
    (
        "list(zip(levels[::2], levels[1::2]))",
        "[(a, b) for a, b in zip(levels[::2], levels[1::2]) if b - a > 1e-3]",
    ),
)


# Trapezoids


def cells(
    boundary, obstacles, *, hollow=False, last=True, every_event=False, key=lambda pair: pair
):
    edges = all_edges(boundary, obstacles)
    events = sorted(edges[:, 0])
    done, before = [], {}

    def close(pair, begun, x):
        done.append([begun, x, *(height(t, edges[i]) for t in (begun, x) for i in pair)])

    for left, right in zip(events, events[1:]):
        now = status((left + right) / 2, edges)
        pairs = list(zip(now, now[1:]))[:: 1 if hollow else 2]
        known = {} if every_event else {key(pair): (pair, begun) for pair, begun in before.items()}
        after = {pair: known[key(pair)][1] if key(pair) in known else left for pair in pairs}
        for pair, begun in before.items():
            if every_event or key(pair) not in map(key, pairs):
                close(pair, begun, left)
        before = after
    if last:
        for pair, begun in before.items():
            close(pair, begun, events[-1])
    return np.array(done).reshape(-1, 6)


@wrong("trapezoidation", slip="slabs")
def never_merged(boundary, obstacles):
    """Cuts everything at every event."""
    return cells(boundary, obstacles, every_event=True)


@wrong("trapezoidation", slip="hollow")
def solid_cells_too(boundary, obstacles):
    """Returns cells inside obstacles as well."""
    return cells(boundary, obstacles, hollow=True)


@wrong("trapezoidation", slip="last")
def never_closes_the_last(boundary, obstacles):
    """Closes no cells after the loop."""
    return cells(boundary, obstacles, last=False)


@wrong("trapezoidation", slip="columns")
def floors_then_ceilings(boundary, obstacles):
    """Returns the columns in another order."""
    return cells(boundary, obstacles)[:, [0, 1, 2, 4, 3, 5]]


@wrong("trapezoidation", slip="no_obstacles")
def boundary_only(boundary, obstacles):
    """Forgets the obstacles."""
    return cells(boundary, [])


@wrong("trapezoidation", slip="rectangles")
def level_floors(boundary, obstacles):
    """Uses the heights of the left side on both sides."""
    return cells(boundary, obstacles)[:, [0, 1, 2, 3, 2, 3]]


@wrong("trapezoidation", slip="no_triangles")
def four_corners_only(boundary, obstacles):
    """Leaves out triangles."""
    found = cells(boundary, obstacles)
    return found[~np.isclose(found[:, 2], found[:, 3]) & ~np.isclose(found[:, 4], found[:, 5])]


@wrong("trapezoidation")
def by_the_floor_alone(boundary, obstacles):
    """Continues a cell while its floor stays the same."""
    return cells(boundary, obstacles, key=lambda pair: pair[0])


@wrong("trapezoidation")
def by_the_ceiling_alone(boundary, obstacles):
    """Continues a cell while its ceiling stays the same."""
    return cells(boundary, obstacles, key=lambda pair: pair[1])


@wrong("trapezoidation")
def events_of_obstacles_only(boundary, obstacles):
    """Draws no walls at the boundary's vertices."""
    found = cells(boundary, obstacles)
    inner = [x for ring in obstacles for x in ring[:, 0]]
    return found[np.isin(found[:, 0], inner) | np.isin(found[:, 1], inner)] if inner else found[:1]


@wrong("trapezoidation")
def whole_numbers(boundary, obstacles):
    """Rounds to whole numbers."""
    return np.round(cells(boundary, obstacles))


@wrong("trapezoidation")
def no_cells_at_all(boundary, obstacles):
    """Returns an empty list."""
    return []


a_little_after_each_event = changed(  # beyond the next event, where that one is near
    "trapezoidation", ("(x + after) / 2", "x + 1e-6")
)
x_to_three_digits = changed(
    "trapezoidation", ("cells.append((x0, x,", "cells.append((round(x0, 3), round(x, 3),")
)


# Neighbours


def overlap(a, b):
    return min(a[5], b[3]) - max(a[4], b[2])


def pairs_if(trapezoids, ask):
    n = range(len(trapezoids))
    return [
        (i, j)
        for i in n
        for j in n
        if i < j and (ask(trapezoids[i], trapezoids[j]) or ask(trapezoids[j], trapezoids[i]))
    ]


def joined(a, b):
    return a[1] == b[0] and overlap(a, b) > 0


@wrong("neighbours", slip="point")
def touching_counts(trapezoids):
    """Uses >= in place of >."""
    return pairs_if(trapezoids, lambda a, b: a[1] == b[0] and overlap(a, b) >= 0)


@wrong("neighbours", slip="same_x")
def only_x(trapezoids):
    """Forgets the heights."""
    return pairs_if(trapezoids, lambda a, b: a[1] == b[0])


@wrong("neighbours", slip="right_wall")
def right_walls(trapezoids):
    """Uses the right wall of the right cell."""
    return pairs_if(trapezoids, lambda a, b: a[1] == b[0] and min(a[5], b[5]) > max(a[4], b[4]))


@wrong("neighbours", slip="left_wall")
def left_walls(trapezoids):
    """Uses the left wall of the left cell."""
    return pairs_if(trapezoids, lambda a, b: a[1] == b[0] and min(a[3], b[3]) > max(a[2], b[2]))


@wrong("neighbours", slip="reversed")
def larger_first(trapezoids):
    """Returns j, i."""
    return [(j, i) for i, j in pairs_if(trapezoids, joined)] or np.empty((0, 2))


@wrong("neighbours", slip="twice")
def both_ways(trapezoids):
    """Returns i, j and j, i."""
    found = pairs_if(trapezoids, joined)
    return found + [(j, i) for i, j in found]


@wrong("neighbours", slip="left_first")
def left_then_right(trapezoids):
    """Returns the left cell first."""
    n = range(len(trapezoids))
    return [(i, j) for i in n for j in n if joined(trapezoids[i], trapezoids[j])]


@wrong("neighbours", slip="in_a_row")
def one_after_another(trapezoids):
    """Connects neighbours in the list."""
    return [(i, i + 1) for i in range(len(trapezoids) - 1)]


@wrong("neighbours", slip="whole_wall")
def equal_walls(trapezoids):
    """Requires equal walls."""
    return pairs_if(trapezoids, lambda a, b: a[1] == b[0] and a[4] == b[2] and a[5] == b[3])


@wrong("neighbours", slip="nearly")
def nearly_the_same_x(trapezoids):
    """Uses np.isclose in place of ==, which passes over a thin cell between."""
    return pairs_if(trapezoids, lambda a, b: np.isclose(a[1], b[0]) and overlap(a, b) > 0)


@wrong("neighbours", slip="nested")
def one_wall_holds_the_other(trapezoids):
    """Requires that one wall contains the other."""
    return pairs_if(trapezoids, lambda a, b: joined(a, b) and (a[4] - b[2]) * (a[5] - b[3]) <= 0)


@wrong("neighbours", slip="only_later")
def only_later_ones(trapezoids):
    """Looks for cells to the right only among larger indices."""
    n = range(len(trapezoids))
    return [(i, j) for i in n for j in n if i < j and joined(trapezoids[i], trapezoids[j])]


@wrong("neighbours")
def an_end_inside(trapezoids):
    """Finds an overlap only if an end of the right wall lies inside the left one."""
    return pairs_if(
        trapezoids, lambda a, b: a[1] == b[0] and (a[4] < b[2] < a[5] or a[4] < b[3] < a[5])
    )


OVERLAP = "max(left[4], right[2]) < min(left[5], right[3])"
touching_from_above = changed(
    "neighbours", (OVERLAP, f"({OVERLAP} or left[4] == right[3])"), slip="point"
)
triangles_left_out = changed("neighbours", (OVERLAP, f"{OVERLAP} and left[2] < left[3]"))
triangles_on_the_right_left_out = changed(
    "neighbours", (OVERLAP, f"{OVERLAP} and right[4] < right[5]")
)
short_walls_left_out = changed("neighbours", (OVERLAP, OVERLAP.replace("<", "+ 1e-6 <")))


# The path


def search(start, trapezoids, pairs, goal_cell, *, both=True):
    parents, waiting = {start: None}, [start]
    while waiting:
        cell = waiting.pop(0)
        for i, j in pairs:
            for a, b in ((i, j), (j, i)) if both else ((i, j),):
                if a == cell and b not in parents:
                    parents[b] = cell
                    waiting.append(b)
    if goal_cell not in parents:
        return None
    chain = [goal_cell]
    while parents[chain[-1]] is not None:
        chain.append(parents[chain[-1]])
    return chain[::-1]


def cell_of(q, trapezoids):
    for i, (x0, x1, low0, high0, low1, high1) in enumerate(trapezoids):
        t = (q[0] - x0) / (x1 - x0)
        if 0 <= t <= 1 and low0 + t * (low1 - low0) < q[1] < high0 + t * (high1 - high0):
            return i
    return None


def centre(cell):
    return np.array([(cell[0] + cell[1]) / 2, cell[2:].mean()])


def middle(a, b):
    a, b = (a, b) if a[1] == b[0] else (b, a)
    return np.array([a[1], (max(a[4], b[2]) + min(a[5], b[3])) / 2])


def wall_of_left(a, b):
    a = a if a[1] == b[0] else b
    return np.array([a[1], (a[4] + a[5]) / 2])


def shorter_wall(a, b):
    a, b = (a, b) if a[1] == b[0] else (b, a)
    low, high = min(a[4:6], b[2:4], key=lambda wall: wall[1] - wall[0])
    return np.array([a[1], (low + high) / 2])


def plan(start, goal, trapezoids, pairs, *, both=True, centres=True, middles=True, wall=middle):
    chain = search(
        cell_of(start, trapezoids), trapezoids, pairs, cell_of(goal, trapezoids), both=both
    )
    if chain is None:
        return None
    path = [start]
    for i, j in zip(chain, chain[1:]):
        path += [centre(trapezoids[i])] * centres + [wall(trapezoids[i], trapezoids[j])] * middles
    return np.array([*path, *[centre(trapezoids[chain[-1]])] * centres, goal])


@wrong("plan_by_decomposition")
def straight_to_the_goal(start, goal, trapezoids, pairs):
    """Goes straight without a test."""
    return [start, goal]


@wrong("plan_by_decomposition")
def centres_only(start, goal, trapezoids, pairs):
    """From centre to centre, without the walls."""
    return plan(start, goal, trapezoids, pairs, middles=False)


@wrong("plan_by_decomposition")
def walls_only(start, goal, trapezoids, pairs):
    """From wall to wall, without the centres: along a wall at a tip."""
    return plan(start, goal, trapezoids, pairs, centres=False)


@wrong("plan_by_decomposition")
def middle_of_the_left_cells_wall(start, goal, trapezoids, pairs):
    """Uses the middle of the whole right side, not of the common part."""
    return plan(start, goal, trapezoids, pairs, wall=wall_of_left)


@wrong("plan_by_decomposition")
def middle_of_the_shorter_wall(start, goal, trapezoids, pairs):
    """Uses the middle of the shorter wall: right where one wall contains the other."""
    return plan(start, goal, trapezoids, pairs, wall=shorter_wall)


@wrong("plan_by_decomposition")
def centre_of_the_left_wall_heights(start, goal, trapezoids, pairs):
    """Takes the mean of the heights at the left wall for the height of the centre."""
    path = plan(start, goal, trapezoids, pairs)
    means = {
        tuple(centre(cell)): ((cell[0] + cell[1]) / 2, cell[2:4].mean()) for cell in trapezoids
    }
    return path if path is None else np.array([means.get(tuple(q), q) for q in path])


@wrong("plan_by_decomposition")
def always_to_the_right(start, goal, trapezoids, pairs):
    """Assumes that the next cell is on the right."""
    return plan(
        start,
        goal,
        trapezoids,
        pairs,
        wall=lambda a, b: np.array([a[1], (max(a[4], b[2]) + min(a[5], b[3])) / 2]),
    )


@wrong("plan_by_decomposition")
def one_way_streets(start, goal, trapezoids, pairs):
    """Uses a pair only from i to j."""
    return plan(start, goal, trapezoids, pairs, both=False)


@wrong("plan_by_decomposition")
def without_the_ends(start, goal, trapezoids, pairs):
    """From the centre of the first cell to that of the last."""
    path = plan(start, goal, trapezoids, pairs)
    return None if path is None else path[1:-1]


@wrong("plan_by_decomposition")
def without_the_goal(start, goal, trapezoids, pairs):
    """Ends at the last centre."""
    path = plan(start, goal, trapezoids, pairs)
    return None if path is None else path[:-1]


@wrong("plan_by_decomposition")
def empty_for_none(start, goal, trapezoids, pairs):
    """Returns an empty list where there is no way."""
    path = plan(start, goal, trapezoids, pairs)
    return [] if path is None else path


@wrong("plan_by_decomposition")
def never_none(start, goal, trapezoids, pairs):
    """Goes straight where it found no way."""
    path = plan(start, goal, trapezoids, pairs)
    return [start, goal] if path is None else path


@wrong("plan_by_decomposition")
def numbers_of_cells(start, goal, trapezoids, pairs):
    """Returns the chain of cells."""
    return search(cell_of(start, trapezoids), trapezoids, pairs, cell_of(goal, trapezoids))


@wrong("plan_by_decomposition")
def gives_up_beyond_the_neighbour(start, goal, trapezoids, pairs):
    """Tests only the neighbours of the start's cell."""
    path = plan(start, goal, trapezoids, pairs)
    return path if path is not None and len(path) <= 5 else None


only_from_cell_to_cell = changed(
    "plan_by_decomposition", ("if cells is None:", "if cells is None or len(cells) < 2:")
)
middles_to_three_digits = changed(
    "plan_by_decomposition",
    ("(left[1], (low + high) / 2)", "(left[1], round((low + high) / 2, 3))"),
)


# Break it


@wrong("exposing_world")
def a_box():
    """One cell has no neighbour."""
    return [(0, 0), (4, 0), (4, 3), (0, 3)]


@wrong("exposing_world")
def a_bay():
    """Not convex, but one wall contains the other."""
    return [(0, 0), (10, -4), (6, 1), (9, 6)]


@wrong("exposing_world")
def nearly_the_same_place():
    """The two corners are not at the same x, so that a third cell lies between."""
    return [(0, 2), (5, 0), (5.1, 3), (9, 5), (5.1, 9), (5, 4)]


@wrong("exposing_world")
def overlap_that_holds_the_middle():
    """Neither wall contains the other, but the middle of the shorter one is on both."""
    return [(0, 2), (5, 0), (5, 1), (9, 5), (5, 9), (5, 4)]


@wrong("exposing_world")
def square_corners():
    """The program is wrong, but there are eight vertices."""
    return [(0, 0), (5, 0), (5, 3), (9, 3), (9, 9), (5, 9), (5, 4), (0, 4)]


@wrong("exposing_world")
def no_gap():
    """The walls meet in a point, and the boundary touches itself."""
    return [(0, 2), (5, 0), (5, 4), (9, 5), (5, 9), (5, 4)]


@wrong("exposing_world")
def with_an_obstacle():
    """A boundary and a list, where one polygon is required."""
    return [(0, 0), (9, 0), (9, 9), (0, 9)], [[(3, 3), (6, 3), (5, 6)]]


@wrong("exposing_world")
def beyond_the_range():
    """The coordinates are too large."""
    return [(0, 2e6), (5, 0), (5, 3e6), (9, 5e6), (5, 9e6), (5, 4e6)]


# Variants

BOTH_ENDS = "zip(levels[::2], levels[1::2])"
top_down = varied("free_intervals", "top_down", (f"list({BOTH_ENDS})", f"list({BOTH_ENDS})[::-1]"))
each_from_above = varied(
    "free_intervals", "upper_end_first", (BOTH_ENDS, "zip(levels[1::2], levels[::2])")
)
all_from_the_top = changed(
    "free_intervals",
    (f"list({BOTH_ENDS})", "list(zip(levels[:-1], levels[1:]))[::-1]"),
    variant="top_down",
    slip="hollow",
)
upper_ends_of_all = changed(
    "free_intervals",
    (BOTH_ENDS, "zip(levels[1:], levels[:-1])"),
    variant="upper_end_first",
    slip="hollow",
)

ALL_EDGES, ROW = "edges = all_edges(boundary, obstacles)", "(x0, x, *left, *right)"
level_walls = varied(
    "trapezoidation",
    "level",
    (ALL_EDGES, "edges = all_edges(boundary[:, ::-1], [ring[:, ::-1] for ring in obstacles])"),
)
floors_first = varied(
    "trapezoidation", "heights", (ROW, "(x0, x, left[0], right[0], left[1], right[1])")
)
level_walls_of_the_boundary = changed(
    "trapezoidation",
    (ALL_EDGES, "edges = all_edges(boundary[:, ::-1], [])"),
    variant="level",
    slip="no_obstacles",
)
ceilings_first = changed(
    "trapezoidation",
    (ROW, "(x0, x, left[1], right[1], left[0], right[0])"),
    variant="heights",
    slip="columns",
)
SORTED = "(min(i, j), max(i, j))"
left_one_first = varied("neighbours", "left_first", (SORTED, "(i, j)"))
larger_one_first = varied("neighbours", "larger_first", (SORTED, "(max(i, j), min(i, j))"))
right_one_first = changed("neighbours", (SORTED, "(j, i)"), variant="left_first")
left_one_for_larger = changed("neighbours", (SORTED, "(i, j)"), variant="larger_first")
WHOLE_PATH = "return np.array([*path, ((last[0] + last[1]) / 2, last[2:].mean()), goal])"
path_from_the_goal = varied(
    "plan_by_decomposition", "from_goal", (WHOLE_PATH, WHOLE_PATH[:-1] + "[::-1])")
)
path_without_its_start = varied(
    "plan_by_decomposition", "without_start", (WHOLE_PATH, WHOLE_PATH[:-1] + "[1:])")
)
path_without_its_ends = changed(
    "plan_by_decomposition", (WHOLE_PATH, WHOLE_PATH[:-1] + "[1:-1])"), variant="without_start"
)
only_its_ends_exchanged = changed(
    "plan_by_decomposition", ("path = [start]", "path = [goal]"), variant="from_goal"
)
