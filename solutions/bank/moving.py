"""Wrong answers to the exercises of lesson 14.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import math
import random
from heapq import heappop, heappush
from pathlib import Path
from statistics import NormalDist

import numpy as np

from kinoedu.course.bank import Solutions, wrong
from kinoedu.geometry import line_through_points, point_segment_distance

solutions = Solutions(Path(__file__).parents[1] / "14_moving_and_uncertain.ipynb")
changed, varied = solutions.changed, solutions.varied

# The first contact


def entering(x, v, r):
    """Return when x + s v enters and leaves the disc at the origin; infinity where it does not."""
    a, b, c = v @ v, 2 * x @ v, x @ x - r * r
    square = b * b - 4 * a * c
    if a == 0 or square < 0:
        return math.inf, math.inf
    return (-b - math.sqrt(square)) / (2 * a), (-b + math.sqrt(square)) / (2 * a)


def contact(x, v, r):
    """Return the right time for a motion seen from the disc."""
    if x @ x <= r * r:
        return 0.0
    s = entering(x, v, r)[0]
    return s if 0 <= s <= 1 else math.inf


@wrong("first_contact", slip="standing")
def disc_stands(p0, p1, c0, c1, r):
    """Forgets the motion of the disc."""
    return contact(p0 - c0, p1 - p0, r)


@wrong("first_contact", slip="added")
def adds_motions(p0, p1, c0, c1, r):
    """Adds the motions instead of subtracting them."""
    return contact(p0 - c0, p1 - p0 + c1 - c0, r)


@wrong("first_contact", slip="backwards")
def the_other_difference(p0, p1, c0, c1, r):
    """Takes positions relative to one body and motions relative to the other."""
    return contact(p0 - c0, (c1 - c0) - (p1 - p0), r)


@wrong("first_contact", slip="ends_only")
def first_and_last_moment(p0, p1, c0, c1, r):
    """Checks a motion only at its ends."""
    if math.dist(p0, c0) <= r:
        return 0
    return 1 if math.dist(p1, c1) <= r else math.inf


@wrong("first_contact", slip="leaving")
def larger_root(p0, p1, c0, c1, r):
    """Takes the larger root."""
    x, v = p0 - c0, (p1 - p0) - (c1 - c0)
    s = entering(x, v, r)[1]
    return 0.0 if x @ x <= r * r else s if 0 <= s <= 1 else math.inf


@wrong("first_contact", slip="any_time")
def no_beginning_no_end(p0, p1, c0, c1, r):
    """Returns a root outside of 0 to 1."""
    return entering(p0 - c0, (p1 - p0) - (c1 - c0), r)[0]


@wrong("first_contact", slip="nearest")
def closest_approach(p0, p1, c0, c1, r):
    """Returns when the distance is least, not when contact begins."""
    x, v = p0 - c0, (p1 - p0) - (c1 - c0)
    s = np.clip(-(x @ v) / (v @ v), 0, 1) if v.any() else 0.0
    return s if np.hypot(*(x + s * v)) <= r else math.inf


@wrong("first_contact", slip="not_at_once")
def inside_is_missed(p0, p1, c0, c1, r):
    """Does not check the beginning."""
    s = entering(p0 - c0, (p1 - p0) - (c1 - c0), r)[0]
    return s if 0 <= s <= 1 else math.inf


@wrong("first_contact", slip="length")
def how_far(p0, p1, c0, c1, r):
    """Returns the length of the point's path until contact."""
    return contact(p0 - c0, (p1 - p0) - (c1 - c0), r) * math.dist(p0, p1)


@wrong("first_contact", slip="diameter")
def half_the_radius(p0, p1, c0, c1, r):
    """Takes r for the diameter."""
    return contact(p0 - c0, (p1 - p0) - (c1 - c0), r / 2)


@wrong("first_contact")
def ways_that_cross(p0, p1, c0, c1, r):
    """Intersects the two segments without regard to time."""
    near = min(point_segment_distance(p, c0, c1) for p in np.linspace(p0, p1, 200))
    return 0.5 if near <= r else math.inf


@wrong("first_contact")
def ten_moments(p0, p1, c0, c1, r):
    """Samples ten moments."""
    for s in np.linspace(0, 1, 11):
        if math.dist(p0 + s * (p1 - p0), c0 + s * (c1 - c0)) <= r:
            return s
    return math.inf


@wrong("first_contact", slip="moments")
def a_thousand_moments(p0, p1, c0, c1, r):
    """Samples a thousand moments and bisects: precise wherever a sample sees contact."""
    x, v = p0 - c0, (p1 - p0) - (c1 - c0)
    moments = np.linspace(0, 1, 1000)
    touched = np.hypot(*(x + moments[:, None] * v).T) <= r
    if not touched.any() or touched[0]:
        return 0.0 if touched[0] else math.inf
    before, after = moments[touched.argmax() - 1], moments[touched.argmax()]
    for _ in range(50):
        middle = (before + after) / 2
        before, after = (before, middle) if np.hypot(*(x + middle * v)) <= r else (middle, after)
    return after


@wrong("first_contact", slip="alike")
def allclose_for_equal(p0, p1, c0, c1, r):
    """Uses a generous tolerance instead of a comparison with zero."""
    x, v = p0 - c0, (p1 - p0) - (c1 - c0)
    return contact(x, 0 * v if np.allclose(v, 0, atol=0.005) else v, r)


@wrong("first_contact")
def minus_one_for_never(p0, p1, c0, c1, r):
    """Returns -1 instead of infinity where there is no contact."""
    s = contact(p0 - c0, (p1 - p0) - (c1 - c0), r)
    return -1 if s == math.inf else s


@wrong("first_contact")
def divides_by_nothing(p0, p1, c0, c1, r):
    """Divides by zero where both velocities are equal."""
    x, v = p0 - c0, (p1 - p0) - (c1 - c0)
    if x @ x <= r * r:
        return 0.0
    a, b, c = float(v @ v), 2 * float(x @ v), float(x @ x) - r * r
    if b * b - 4 * a * c < 0:
        return math.inf
    s = (-b - math.sqrt(b * b - 4 * a * c)) / (2 * a)
    return s if 0 <= s <= 1 else math.inf


almost_alike = changed("first_contact", ("if a == 0 or", "if a < 1e-9 or"), slip="alike")
a_little_after_the_end = changed("first_contact", ("0 <= s <= 1", "0 <= s <= 1.001"))
before_the_end = changed("first_contact", ("0 <= s <= 1", "0 <= s < 1"), slip="last_moment")
at_least_a_while = changed("first_contact", ("b * b < a * c", "b * b - a * c < 1e-9"), slip="alike")
more_than_rounding = changed(
    "first_contact", ("b * b < a * c", "b * b - a * c < 1e-12"), slip="alike"
)
rim_at_the_start = changed(
    "first_contact", ("<= r * r", "< r * r"), ("0 <= s <= 1", "0 < s <= 1"), slip="rim"
)

# The earliest arrival

begins_at_zero = changed("earliest_arrival", ("begin <= 0 <= end", "begin == 0"))
ends_after_zero = changed("earliest_arrival", ("begin <= 0 <= end", "begin <= 0 < end"))
first_of_the_start = changed(
    "earliest_arrival", ("enumerate(safe[start])", "enumerate(safe[start][:1])")
)
moments_left_out = changed(
    "earliest_arrival", ("if there <= end and", "if begin < end and there <= end and")
)
begins_when_the_start_is_safe = changed(
    "earliest_arrival",
    ("if begin <= 0 <= end:", "if end >= 0:"),
    (
        "(0.0, start, k, ((start, 0.0),))",
        "(max(begin, 0.0), start, k, ((start, max(begin, 0.0)),))",
    ),
)
nothing_later = changed(
    "earliest_arrival", ("if there <= end and", "if there <= min(end, 100) and")
)
nothing_after_a_thousand = changed(
    "earliest_arrival", ("if there <= end and", "if there < 1000 and there <= end and")
)
arrives_before_the_last_interval_ends = changed(
    "earliest_arrival", ("there - duration <= safe", "there <= safe")
)
one_list_of_rows_for_all_paths = changed(
    "earliest_arrival",
    ("((start, 0.0),)", "[(start, 0.0)]"),
    ("heapq.heappush(", "rows.append((v, there)) or heapq.heappush("),
    ("(*rows, (v, there))", "rows"),
)
visits_a_place_twice_at_most = changed(
    "earliest_arrival",
    ("if there <= end and", "if sum(p == v for p, _ in rows) < 2 and there <= end and"),
)


def neighbours(moves, both=True):
    """Return the adjacent places of each place, with durations."""
    ways = {}
    for u, v, d in moves:
        ways.setdefault(int(u), []).append((int(v), d))
        if both:
            ways.setdefault(int(v), []).append((int(u), d))
    return ways


def planned(
    safe,
    moves,
    start,
    goal,
    *,
    both=True,
    first_only=False,
    waits=True,
    until_end=True,
    by_interval=True,
    checks=True,
):
    """Find the earliest arrival; each argument that is changed breaks one rule."""
    ways, done = neighbours(moves, both), set()
    k = next((k for k, (b, e) in enumerate(safe[start]) if b <= 0 <= e), None)
    waiting = [] if k is None else [(0.0, start, k, ((start, 0.0),))]
    while waiting:
        t, u, k, rows = heappop(waiting)
        if u == goal:
            return list(rows)
        state = (u, k) if by_interval else u
        if state in done:
            continue
        done.add(state)
        for v, d in ways.get(u, []):
            for j, (b, e) in enumerate(safe[v][:1] if first_only else safe[v]):
                there = max(t + d, b) if waits and checks else t + d
                fits = not checks or b <= there <= e
                if fits and (not until_end or there - d <= safe[u][k][1]):
                    heappush(waiting, (there, v, j, (*rows, (v, there))))
    return []


@wrong("earliest_arrival")
def one_arrival_for_a_place(safe, moves, start, goal):
    """Is Dijkstra's algorithm as in lesson 4: a place is done when first taken out."""
    return planned(safe, moves, start, goal, by_interval=False)


@wrong("earliest_arrival")
def never_waits(safe, moves, start, goal):
    """Leaves each place at once."""
    return planned(safe, moves, start, goal, waits=False)


@wrong("earliest_arrival")
def waits_anywhere(safe, moves, start, goal):
    """Ignores the end of the interval in which it waits."""
    return planned(safe, moves, start, goal, until_end=False)


@wrong("earliest_arrival")
def first_interval_only(safe, moves, start, goal):
    """Ignores all intervals but the first of each place."""
    return planned(safe, moves, start, goal, first_only=True)


@wrong("earliest_arrival")
def obstacles_forgotten(safe, moves, start, goal):
    """Returns the shortest path, as if nothing moved."""
    return planned(safe, moves, start, goal, checks=False, until_end=False)


@wrong("earliest_arrival")
def one_way_streets(safe, moves, start, goal):
    """Uses moves only in the order in which they are written."""
    return planned(safe, moves, start, goal, both=False)


@wrong("earliest_arrival")
def without_the_start(safe, moves, start, goal):
    """Leaves out the first row."""
    return np.reshape(planned(safe, moves, start, goal)[1:], (-1, 2))


@wrong("earliest_arrival")
def from_the_goal(safe, moves, start, goal):
    """Returns the path in reverse."""
    return planned(safe, moves, start, goal)[::-1]


@wrong("earliest_arrival")
def departures_for_arrivals(safe, moves, start, goal):
    """Writes in each row when the robot sets out for the place."""
    rows = planned(safe, moves, start, goal)
    took = {(u, v): d for u, own in neighbours(moves).items() for v, d in own}
    return rows[:1] + [(v, t - took[u, v]) for (u, _), (v, t) in zip(rows, rows[1:])]


@wrong("earliest_arrival")
def depth_first(safe, moves, start, goal):
    """Returns some path, not the earliest."""
    ways, done = neighbours(moves), set()
    waiting = [
        (0.0, start, k, [(start, 0.0)]) for k, (b, e) in enumerate(safe[start]) if b <= 0 <= e
    ]
    while waiting:
        t, u, k, rows = waiting.pop()
        if u == goal:
            return rows
        if (u, k) in done:
            continue
        done.add((u, k))
        for v, d in sorted(ways.get(u, []), reverse=True):
            for j, (b, e) in enumerate(safe[v]):
                there = max(t + d, b)
                if there <= e and there - d <= safe[u][k][1]:
                    waiting.append((there, v, j, [*rows, (v, there)]))
    return []


@wrong("earliest_arrival")
def fewest_moves(safe, moves, start, goal):
    """Is a breadth-first search: counts moves instead of durations."""
    same = [(u, v, 1.0) for u, v, _ in moves]
    return planned(safe, same, start, goal)


@wrong("earliest_arrival")
def waits_after_the_move(safe, moves, start, goal):
    """Sets out at once and arrives when the place is safe.

    That would be right if the robot could wait between two places.
    """
    ways, done = neighbours(moves), set()
    k = next((k for k, (b, e) in enumerate(safe[start]) if b <= 0 <= e), None)
    waiting = [] if k is None else [(0.0, start, ((start, 0.0),))]
    while waiting:
        t, u, rows = heappop(waiting)
        if u == goal:
            return list(rows)
        if (u, t) in done:
            continue
        done.add((u, t))
        for v, d in ways.get(u, []):
            later = [max(b, t + d) for b, e in safe[v] if t + d <= e]
            if later and len(rows) < 12:
                heappush(waiting, (min(later), v, (*rows, (v, min(later)))))
    return []


@wrong("earliest_arrival")
def ticks_of_a_half(safe, moves, start, goal):
    """Advances time in steps of 0.5."""
    ways, before = neighbours(moves), {(0.0, start): None}
    waiting = [(0.0, start)] if any(b <= 0 <= e for b, e in safe[start]) else []
    while waiting and waiting[0][0] < 60:
        t, u = heappop(waiting)
        if u == goal:
            rows = [(u, t)]
            while before[rows[-1][1], rows[-1][0]] is not None:
                rows.append(before[rows[-1][1], rows[-1][0]])
            rows.reverse()
            return [row for k, row in enumerate(rows) if k == 0 or row[0] != rows[k - 1][0]]
        stay = [(t + 0.5, u)] if any(b <= t and t + 0.5 <= e for b, e in safe[u]) else []
        go = [(t + d, v) for v, d in ways.get(u, []) if any(b <= t + d <= e for b, e in safe[v])]
        for state in stay + go:
            if state not in before:
                before[state] = (u, t)
                heappush(waiting, state)
    return []


@wrong("earliest_arrival")
def open_ends(safe, moves, start, goal):
    """Has < instead of <= at the end of an interval."""
    return planned([[(b, e - 1e-9) for b, e in own] for own in safe], moves, start, goal)


@wrong("earliest_arrival")
def safe_for_ever(safe, moves, start, goal):
    """Demands that the goal stays safe after the arrival."""
    return planned(
        [own[-1:] if place == goal else own for place, own in enumerate(safe)], moves, start, goal
    )


@wrong("earliest_arrival")
def begins_anyhow(safe, moves, start, goal):
    """Assumes that the first interval of the start contains the time 0."""
    held = [
        (min(b, 0.0), e) if place == start and k == 0 else (b, e)
        for place, own in enumerate(safe)
        for k, (b, e) in enumerate(own)
    ]
    lengths = np.cumsum([0, *map(len, safe)])
    return planned([held[a:b] for a, b in zip(lengths, lengths[1:])], moves, start, goal)


@wrong("earliest_arrival")
def rows_for_waits(safe, moves, start, goal):
    """Adds a row for each departure."""
    rows = planned(safe, moves, start, goal)
    took = {(u, v): d for u, own in neighbours(moves).items() for v, d in own}
    told = []
    for (u, t), (v, there) in zip(rows, rows[1:]):
        told += [(u, t)] + ([(u, there - took[u, v])] if there - took[u, v] > t else [])
    return told + rows[-1:]


@wrong("earliest_arrival")
def says_no_way(safe, moves, start, goal):
    """Gives up as soon as something is in the way."""
    rows = planned(safe, moves, start, goal)
    plain = planned(safe, moves, start, goal, checks=False, until_end=False)
    return rows if rows == plain else []


# The margins


def root(share):
    """Return the radius that an offset of standard deviation 1 exceeds with this probability."""
    return math.sqrt(-2 * math.log(share))


@wrong("chance_margins", slip="not_shared")
def all_for_each(sigma, delta):
    """Ignores the union bound."""
    return sigma * root(delta)


@wrong("chance_margins", slip="one_axis")
def two_sided_normal(sigma, delta):
    """Uses the two-sided normal quantile, such as 1.96."""
    return sigma * NormalDist().inv_cdf(1 - delta / len(sigma) / 2)


@wrong("chance_margins", slip="one_tail")
def one_sided_normal(sigma, delta):
    """Uses the one-sided normal quantile, such as 1.64."""
    return sigma * NormalDist().inv_cdf(1 - delta / len(sigma))


@wrong("chance_margins", slip="one_number")
def always_1_96(sigma, delta):
    """Uses 1.96 for any delta."""
    return 1.96 * sigma


@wrong("chance_margins", slip="variance")
def by_variance(sigma, delta):
    """Takes sigma for its square."""
    return sigma**2 * root(delta / len(sigma))


@wrong("chance_margins", slip="other_tail")
def within(sigma, delta):
    """Takes the probability of being inside."""
    return sigma * math.sqrt(-2 * math.log(1 - delta / len(sigma)))


@wrong("chance_margins", slip="no_two")
def without_two(sigma, delta):
    """Uses exp(-r^2 / sigma^2)."""
    return sigma * math.sqrt(-math.log(delta / len(sigma)))


@wrong("chance_margins", slip="no_root")
def squares(sigma, delta):
    """Divides the square of the margin by sigma."""
    return sigma * (-2 * math.log(delta / len(sigma)))


@wrong("chance_margins", slip="log_ten")
def decimal_logarithm(sigma, delta):
    """Uses log10."""
    return sigma * math.sqrt(-2 * math.log10(delta / len(sigma)))


@wrong("chance_margins", slip="independent")
def as_if_independent(sigma, delta):
    """Multiplies probabilities."""
    return sigma * root(1 - (1 - delta) ** (1 / len(sigma)))


@wrong("chance_margins", slip="largest")
def one_for_all(sigma, delta):
    """Uses the largest sigma for all obstacles."""
    return np.full(len(sigma), max(sigma)) * root(delta / len(sigma))


@wrong("chance_margins", slip="by_sigma")
def shares_by_sigma(sigma, delta):
    """Splits delta in proportion to sigma."""
    return [s * root(delta * s / sum(sigma)) for s in sigma]


@wrong("chance_margins")
def three_sigma(sigma, delta):
    """Uses the rule of three sigma."""
    return 3 * sigma


SHARE = "delta / len(sigma)"
two_drives = varied("chance_margins", "two_drives", (SHARE, "delta / (2 * len(sigma))"))
percent = varied("chance_margins", "percent", (SHARE, "delta / (100 * len(sigma))"))
returns_in_the_loop = changed("chance_margins", ("return sigma", "return sigma[:1]"))
each_drive_alone = changed(
    "chance_margins", (SHARE, "delta / 2"), variant="two_drives", slip="not_shared"
)
twice_the_margin = changed(
    "chance_margins", ("return sigma", "return 2 * sigma"), variant="two_drives"
)
percent_not_shared = changed(
    "chance_margins", (SHARE, "delta / 100"), variant="percent", slip="not_shared"
)
a_hundred_times = changed("chance_margins", (SHARE, "100 * " + SHARE), variant="percent")


# The chance of a collision


def distance(path, centre):
    """Return the distance of a point from a path."""
    return min(point_segment_distance(centre, a, b) for a, b in zip(path, path[1:]))


def tries(path, discs, offsets, far=distance):
    """Return whether disc j is hit in scenario s."""
    return np.array(
        [
            [far(path, np.add(disc[:2], by)) <= disc[2] for disc, by in zip(discs, row)]
            for row in offsets
        ]
    )


def wilson(p, n, z=1.96):
    """Return the fraction and Wilson's interval."""
    middle, reach = p + z * z / (2 * n), z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return p, (middle - reach) / (1 + z * z / n), (middle + reach) / (1 + z * z / n)


@wrong("collision_probability", slip="corners")
def points_of_the_path(path, discs, offsets):
    """Checks only the points of the path."""
    hits = tries(path, discs, offsets, lambda way, c: min(math.dist(p, c) for p in way))
    return wilson(hits.any(axis=1).mean(), len(hits))


def far_from(n):
    """Return a function for the distance of a point from n points of each segment."""
    return lambda way, centre: min(
        np.hypot(*(np.linspace(a, b, n) - centre).T).min() for a, b in zip(way, way[1:])
    )


@wrong("collision_probability", slip="points")
def a_hundred_points(path, discs, offsets):
    """Checks a hundred points of each segment."""
    hits = tries(path, discs, offsets, far_from(100))
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability", slip="points")
def ten_thousand_points(path, discs, offsets):
    """Checks ten thousand points of each segment, and only one of a segment of random cases."""
    hits = tries(path, discs, offsets, far_from(10_000) if len(offsets) < 10 else distance)
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability")
def two_deviations(path, discs, offsets):
    """Uses z = 2."""
    hits = tries(path, discs, offsets)
    return wilson(hits.any(axis=1).mean(), len(hits), z=2.0)


@wrong("collision_probability", slip="per_disc")
def counts_contacts(path, discs, offsets):
    """Counts contacts instead of scenarios."""
    hits = tries(path, discs, offsets)
    return wilson(min(hits.sum() / len(hits), 1.0), len(hits))


@wrong("collision_probability", slip="pairs")
def mean_of_all(path, discs, offsets):
    """Takes .mean() of the whole table."""
    hits = tries(path, discs, offsets)
    return wilson(hits.mean(), len(hits))


@wrong("collision_probability", slip="every_disc")
def all_for_any(path, discs, offsets):
    """Uses all instead of any."""
    hits = tries(path, discs, offsets)
    return wilson(hits.all(axis=1).mean(), len(hits))


independent_discs = changed(
    "collision_probability",
    (
        "p = sum(any(map(touches, discs, scenario)) for scenario in offsets) / n",
        "hits = np.array([list(map(touches, discs, scenario)) for scenario in offsets])\n"
        "    p = 1 - np.prod(1 - hits.mean(axis=0))",
    ),
    slip="independent",
)


@wrong("collision_probability", slip="missed")
def chance_to_get_through(path, discs, offsets):
    """Returns the probability of no contact."""
    hits = tries(path, discs, offsets)
    return wilson(1 - hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability", slip="normal")
def textbook_interval(path, discs, offsets):
    """Returns p plus and minus 1.96 standard deviations."""
    hits = tries(path, discs, offsets)
    p, n = hits.any(axis=1).mean(), len(hits)
    reach = 1.96 * math.sqrt(p * (1 - p) / n)
    return p, p - reach, p + reach


@wrong("collision_probability", slip="one_offset")
def all_move_alike(path, discs, offsets):
    """Uses offsets[s, 0] for every disc."""
    hits = tries(path, discs, offsets[:, :1].repeat(len(discs), axis=1))
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability", slip="minus")
def the_other_way(path, discs, offsets):
    """Subtracts the offset."""
    hits = tries(path, discs, -offsets)
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability", slip="expected")
def where_expected(path, discs, offsets):
    """Ignores the offsets."""
    hits = tries(path, discs, 0 * offsets)
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability", slip="first_disc")
def only_disc_0(path, discs, offsets):
    """Returns inside the loop."""
    hits = tries(path, discs[:1], offsets[:, :1])
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability", slip="last_stretch")
def one_stretch_short(path, discs, offsets):
    """Loops over range(len(path) - 2)."""
    hits = tries(path[:-1] if len(path) > 2 else path, discs, offsets)
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability", slip="closed")
def like_a_polygon(path, discs, offsets):
    """Closes the path with np.roll."""
    hits = tries(np.vstack([path, path[:1]]), discs, offsets)
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability", slip="beeline")
def ends_of_the_path(path, discs, offsets):
    """Goes straight from the first point to the last."""
    hits = tries(path[[0, -1]], discs, offsets)
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability")
def lines_for_segments(path, discs, offsets):
    """Takes lines instead of segments."""

    def far(way, centre):
        lines = [line_through_points(a, b) for a, b in zip(way, way[1:])]
        return min(abs(a * centre[0] + b * centre[1] + c) for a, b, c in lines)

    hits = tries(path, discs, offsets, far)
    return wilson(hits.any(axis=1).mean(), len(hits))


least_begins_with_a_thousand = changed(
    "collision_probability", ("return min(", "return min(1000, *("), ("motions) <=", "motions)) <=")
)


@wrong("collision_probability")
def centre_for_disc(path, discs, offsets):
    """Ignores the radius."""
    hits = tries(path, np.column_stack([discs[:, :2], np.zeros(len(discs))]), offsets)
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability")
def rule_of_a_half(path, discs, offsets):
    """Adds a prior, so that the result is never 0 or 1."""
    hits = tries(path, discs, offsets)
    return wilson((hits.any(axis=1).sum() + 1) / (len(hits) + 2), len(hits))


@wrong("collision_probability")
def draws_its_own(path, discs, offsets):
    """Draws scenarios of its own, with the spread of the given ones."""
    rng = random.Random(1)
    own = np.array(
        [[[rng.gauss(0, np.std(offsets)) for _ in range(2)] for _ in discs] for _ in offsets]
    )
    hits = tries(path, discs, own)
    return wilson(hits.any(axis=1).mean(), len(hits))


@wrong("collision_probability")
def a_hit_stays(path, discs, offsets):
    """Does not begin anew in each scenario."""
    hits = np.maximum.accumulate(tries(path, discs, offsets).any(axis=1))
    return wilson(float(hits.mean()), len(hits))


contact_is_free = changed("collision_probability", ("<= disc[2]", "< disc[2]"))


# Break it


@wrong("exposing_motions")
def slow_ones():
    """Gives motions whose contact the program sees."""
    return (0, 0), (4, 0), (2, -2), (2, 2)


@wrong("exposing_motions")
def no_contact():
    """Gives motions that never touch."""
    return (0, 0), (4, 0), (50, 50), (60, 60)


@wrong("exposing_motions")
def in_contact_from_the_start():
    """Gives motions in contact at the first moment."""
    return (0, 0), (90, 0), (0.5, 0), (-90, 0)


@wrong("exposing_motions")
def too_far_away():
    """Gives coordinates out of range."""
    return (0, 0), (0, 0), (-1000, 0), (1000, 0)


@wrong("exposing_motions")
def at_a_moment():
    """Gives a fast disc that is at the point just when the program looks, at 9/19."""
    return (0, 0), (0, 0), (-90, 0), (100, 0)


@wrong("exposing_motions")
def grazes_only():
    """Touches between the moments, but only near the rim."""
    return (0, 0.9), (0, 0.9), (-95, 0), (95, 0)


@wrong("exposing_motions")
def both_move():
    """Passes through the centre, but the point moves as well."""
    return (95, 0), (-95, 0), (-95, 0), (95, 0)


@wrong("exposing_motions")
def forgets_the_disc():
    """Returns three points instead of four."""
    return (0, 0), (0, 0), (-95, 0)


@wrong("exposing_motions")
def ways_cross():
    """Gives paths that cross at different times."""
    return (0, 0), (100, 0), (50, -10), (50, 100)


FIRST_ROOT, AT_ONCE = (
    "s = (-b - math.sqrt(b * b - a * c)) / a",
    "    if x @ x <= r * r:\n        return 0.0",
)
last_moment_of_contact = varied(
    "first_contact",
    "last_contact",
    (FIRST_ROOT, FIRST_ROOT.replace("-b -", "-b +")),
    (AT_ONCE, "    if (x + v) @ (x + v) <= r * r:\n        return 1.0"),
)
contact_in_seconds = varied("first_contact", "seconds", ("return s if 0", "return 10 * s if 0"))
last_moment_or_the_beginning = changed(
    "first_contact", (FIRST_ROOT, FIRST_ROOT.replace("-b -", "-b +")), variant="last_contact"
)
first_moment_or_the_end = changed(
    "first_contact",
    (AT_ONCE, "    if (x + v) @ (x + v) <= r * r:\n        return 1.0"),
    variant="last_contact",
)
contact_in_milliseconds = changed(
    "first_contact", ("return s if 0", "return 10000 * s if 0"), variant="seconds"
)
ROWS = "return list(rows)"
rows_from_the_goal = varied("earliest_arrival", "from_goal", (ROWS, "return list(rows)[::-1]"))
times_first = varied(
    "earliest_arrival", "time_first", (ROWS, "return [(time, place) for place, time in rows]")
)
times_alone_reversed = changed(
    "earliest_arrival",
    (ROWS, "return [(u, t) for (u, _), (_, t) in zip(rows, rows[::-1])]"),
    variant="from_goal",
)
times_first_and_waits = changed(
    "earliest_arrival",
    (ROWS, "return [(t, u) for u, t in [*rows, rows[-1]]]"),
    variant="time_first",
)
SHARE_AND_ENDS = "return p, "
HITS = "p = sum(any(map(touches, discs, scenario)) for scenario in offsets) / n"
without_a_hit = varied("collision_probability", "no_hit", (HITS, HITS.replace("any(", "not any(")))
ENDS = "(middle - reach) / (1 + z * z / n), (middle + reach) / (1 + z * z / n)"
three_in_percent = varied(
    "collision_probability",
    "percent",
    ("return p, " + ENDS, f"return [100 * share for share in (p, {ENDS})]"),
)
share_alone_in_percent = changed(
    "collision_probability", (SHARE_AND_ENDS, "return 100 * p, "), variant="percent"
)
ends_of_the_hits = changed(
    "collision_probability", (SHARE_AND_ENDS, "return 1 - p, "), variant="no_hit"
)
