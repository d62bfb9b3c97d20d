"""Wrong answers to the exercises of lesson 13.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import heapq
import math
import random
from math import hypot, pi, sqrt
from pathlib import Path

import numpy as np

from kinoedu.course.bank import Solutions, wrong
from kinoedu.curves.arcs import drive_arc
from kinoedu.geometry import point_in_polygon
from kinoedu.worlds.polygon_world import rings_of

solutions = Solutions(Path(__file__).parents[1] / "13_kinodynamic_planning.ipynb")
changed, varied = solutions.changed, solutions.varied

# How far poses are apart


def short_way(a, b):
    """Return the difference of two headings, the short way."""
    return (b - a + pi) % (2 * pi) - pi


def off(a, b, turn):
    """Return the distance of two poses whose headings contribute `turn`."""
    return hypot(b[0] - a[0], b[1] - a[1], turn)


@wrong("heading_distance", slip="no_wrap")
def no_wrap(a, b, radian):
    """Takes the plain difference of the headings."""
    return off(a, b, radian * (b[2] - a[2]))


@wrong("heading_distance", slip="one_way")
def always_left(a, b, radian):
    """Takes the difference modulo 2 pi, but not the short way."""
    return off(a, b, radian * ((b[2] - a[2]) % (2 * pi)))


@wrong("heading_distance", slip="once")
def one_turn_taken_off(a, b, radian):
    """Is right only for headings in [-pi, pi)."""
    turn = abs(b[2] - a[2])
    return off(a, b, radian * min(turn, 2 * pi - turn))


@wrong("heading_distance", slip="half_turns")
def headings_as_lines(a, b, radian):
    """Takes the difference modulo pi."""
    return off(a, b, radian * (abs(b[2] - a[2]) % pi))


@wrong("heading_distance", slip="no_radian")
def radians_as_lengths(a, b, radian):
    """Forgets what a radian is worth."""
    return off(a, b, short_way(a[2], b[2]))


@wrong("heading_distance", slip="divided")
def worth_divided(a, b, radian):
    """Divides by what a radian is worth."""
    return off(a, b, short_way(a[2], b[2]) / radian)


@wrong("heading_distance", slip="degrees")
def in_degrees(a, b, radian):
    """Converts radians to degrees."""
    return off(a, b, radian * math.degrees(short_way(a[2], b[2])))


@wrong("heading_distance", slip="root")
def worth_outside_the_square(a, b, radian):
    """Computes radian * turn^2."""
    return sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2 + radian * short_way(a[2], b[2]) ** 2)


@wrong("heading_distance", slip="place")
def places_only(a, b, radian):
    """Forgets the heading."""
    return off(a, b, 0)


@wrong("heading_distance", slip="sum")
def added(a, b, radian):
    """Adds instead of taking the root of the sum of squares."""
    return off(a, b, 0) + radian * abs(short_way(a[2], b[2]))


@wrong("heading_distance", slip="square")
def squared(a, b, radian):
    """Forgets the root."""
    return off(a, b, radian * short_way(a[2], b[2])) ** 2


@wrong("heading_distance")
def rounded(a, b, radian):
    """Rounds the result."""
    return round(off(a, b, radian * short_way(a[2], b[2])), 2)


@wrong("heading_distance", slip="chord")
def chord(a, b, radian):
    """Measures the chord between the tips of two arrows: it needs no wrap, but it is no angle."""
    return off(a, b, radian * 2 * math.sin(short_way(a[2], b[2]) / 2))


# The best of some controls


def best(
    problem,
    q,
    target,
    controls,
    t,
    n,
    *,
    apart=None,
    free=None,
    first=1,
    better=lambda a, b: a < b,
    move=None,
    cut=None,
):
    """Choose the best control; each argument that is given replaces a part."""
    apart, move, cut = apart or problem.distance, move or problem.move, cut or np.argmin
    choice, least = None, None
    for i, (v, phi) in enumerate(controls):
        away = [apart(move(q, v, phi, k * t / n), target) for k in range(first, n + 1)]
        k = first + int(cut(away))
        if (least is None or better(away[k - first], least)) and (free or problem.is_free_drive)(
            q, v, phi, k * t / n
        ):
            choice, least = (i, k), away[k - first]
    return choice


@wrong("best_control", slip="last")
def ends_compared(problem, q, target, controls, t, n):
    """Cuts only at the last moment."""
    choice = best(problem, q, target, controls, t, 1)
    return choice and (choice[0], n)


@wrong("best_control", slip="unchecked")
def nothing_checked(*given):
    """Never checks for contact."""
    return best(*given, free=lambda *_: True)


@wrong("best_control", slip="picked")
def picked_then_checked(problem, q, target, controls, t, n):
    """Takes the closest of all, or nothing."""
    i, k = best(problem, q, target, controls, t, n, free=lambda *_: True)
    return (i, k) if problem.is_free_drive(q, *controls[i], k * t / n) else None


@wrong("best_control", slip="whole")
def beyond_the_cut(problem, q, target, controls, t, n):
    """Demands that the whole drive is free."""
    return best(
        problem,
        q,
        target,
        controls,
        t,
        n,
        free=lambda q, v, phi, _: problem.is_free_drive(q, v, phi, t),
    )


@wrong("best_control", slip="end_only")
def endpoint_only(problem, q, target, controls, t, n):
    """Checks only the pose at the cut."""
    return best(
        problem,
        q,
        target,
        controls,
        t,
        n,
        free=lambda q, v, phi, t: problem.is_free(problem.move(q, v, phi, t)),
    )


@wrong("best_control", slip="place")
def nearest_place(*given):
    """Ignores the heading."""
    return best(*given, apart=lambda a, b: math.dist(a[:2], b[:2]))


@wrong("best_control", slip="no_wrap")
def heading_not_wrapped(problem, *given):
    """Takes the plain difference of the headings."""
    return best(problem, *given, apart=lambda a, b: off(a, b, problem.radian * (b[2] - a[2])))


@wrong("best_control", slip="dip")
def stops_when_it_gets_worse(*given):
    """Stops at the first dip, and so cuts a control that comes round again too soon."""
    return best(
        *given,
        cut=lambda away: next(
            (k for k in range(len(away) - 1) if away[k + 1] > away[k]), len(away) - 1
        ),
    )


@wrong("best_control", slip="shorter")
def closest_free_step(problem, q, target, controls, t, n):
    """Cuts a control before its first contact instead of leaving it out."""
    choice, least = None, math.inf
    for i, (v, phi) in enumerate(controls):
        for k in range(1, n + 1):
            away = problem.distance(problem.move(q, v, phi, k * t / n), target)
            if away < least and problem.is_free_drive(q, v, phi, k * t / n):
                choice, least = (i, k), away
    return choice


@wrong("best_control", slip="closer")
def must_be_closer_than_q(problem, q, target, controls, t, n):
    """Starts its minimum with the distance of q."""
    choice = best(problem, q, target, controls, t, n)
    if choice is None:
        return None
    end = problem.move(q, *controls[choice[0]], choice[1] * t / n)
    return choice if problem.distance(end, target) < problem.distance(q, target) else None


drives_in_contact_set_the_least = changed(
    "best_control",
    (
        "if away[k - 1] < least and problem.is_free_drive(q, v, phi, k * t / n):\n"
        "            best, least = (i, k), away[k - 1]",
        "if away[k - 1] < least:\n            least = away[k - 1]\n"
        "            best = (i, k) if problem.is_free_drive(q, v, phi, k * t / n) else best",
    ),
)
minimum_from_a_thousand = changed(
    "best_control", ("best, least = None, math.inf", "best, least = None, 1000"), slip="finite"
)
minimum_from_ten_thousand = changed(
    "best_control", ("best, least = None, math.inf", "best, least = None, 10**4"), slip="finite"
)


@wrong("best_control", slip="standing")
def may_stand_still(*given):
    """Counts step 0."""
    return best(*given, first=0)


@wrong("best_control", slip="counted")
def index_for_step(*given):
    """Forgets the 1 after argmin."""
    choice = best(*given)
    return choice and (choice[0], choice[1] - 1)


@wrong("best_control", slip="farthest")
def farthest_control(*given):
    """Has a minus sign too many."""
    problem = given[0]
    return best(*given, apart=lambda a, b: -problem.distance(a, b))


@wrong("best_control")
def phi_for_tan(problem, *given):
    """Moves by phi / L instead of tan(phi) / L."""
    return best(
        problem,
        *given,
        move=lambda q, v, phi, t: np.array(drive_arc(*q, v * t, phi / problem.robot.wheelbase)),
    )


@wrong("best_control")
def corners_only(problem, q, target, controls, t, n):
    """Checks four corners at ten moments."""
    rings = [ring for rings in rings_of(problem.world)[1:] for ring in rings]

    def free(q, v, phi, t):
        for s in np.linspace(0, t, 10):
            x, y, theta = problem.move(q, v, phi, s)
            for a, b in problem.robot.outline:
                corner = (
                    x + a * math.cos(theta) - b * math.sin(theta),
                    y + a * math.sin(theta) + b * math.cos(theta),
                )
                if any(point_in_polygon(corner, ring) for ring in rings) or not (
                    0 < corner[0] < 200 and 0 < corner[1] < 200
                ):
                    return False
        return True

    return best(problem, q, target, controls, t, n, free=free)


@wrong("best_control")
def first_free(problem, q, target, controls, t, n):
    """Takes the first free control, not the best."""
    return best(problem, q, target, controls, t, n, better=lambda a, b: False)


@wrong("best_control")
def last_free(problem, q, target, controls, t, n):
    """Never updates its minimum."""
    return best(problem, q, target, controls, t, n, better=lambda a, b: True)


# A tree, and a roadmap, of drives


def is_there(problem, q, wrap=True, heading=True):
    """Whether a pose is near enough to the goal; the flags turn parts of the test off."""
    turn = short_way(q[2], problem.goal[2]) if wrap else q[2] - problem.goal[2]
    near = math.dist(q[:2], problem.goal[:2]) <= problem.tolerance
    return near and (not heading or abs(turn) <= problem.turn_tolerance)


def place(problem, turn, rng, goal_every=4, region_every=7):
    """Return the target of an iteration."""
    if region_every and turn % region_every == 0:
        return problem.near_goal(rng)
    return problem.goal if goal_every and turn % goal_every == 0 else problem.sample(rng)


def grown(
    problem, iterations, rng, *, k=1, there=is_there, where=place, choose=None, drive=None, **more
):
    """Grow a tree or a roadmap; each argument that is given replaces a part.

    Returns nodes, parents, controls, durations, and the nodes at which the path may end.
    """
    first, stop, closest, seed = (
        more.get(*one) for one in (("first", 1), ("stop", True), ("closest", True), ("seed", None))
    )
    rng = np.random.default_rng(rng if seed is None else seed)
    nodes, parent, controls, durations = [problem.start], [-1], [(0, 0)], [0]
    for turn in range(first, iterations + first):
        if stop and there(problem, nodes[-1]):
            break
        target = where(problem, turn, rng)
        order = np.argsort(
            [more.get("apart", problem.distance)(q, target) for q in nodes], kind="stable"
        )
        for near in order[:k] if choose is None else choose(order, k):
            found = (drive or problem.best_drive)(nodes[near], target, rng)
            if found is not None:
                v, phi, t = found
                nodes.append(problem.move(nodes[near], v, phi, t))
                parent.append(int(near))
                controls.append((v, phi))
                durations.append(t)
    arrived = [i for i, q in enumerate(nodes) if there(problem, q)]
    nearest = (
        int(np.argmin([problem.distance(q, problem.goal) for q in nodes]))
        if closest
        else len(nodes) - 1
    )
    return nodes, parent, controls, durations, arrived or [nearest]


def path_to(parent, node):
    """Return the path from the root to a node."""
    path = [node]
    while parent[path[-1]] >= 0:
        path.append(parent[path[-1]])
    return path[::-1]


def rrt(*given, **options):
    """Return an RRT in the form of the exercise."""
    _, parent, controls, durations, ends = grown(*given, **options)
    return parent, controls, durations, path_to(parent, ends[0])


def prm(problem, k, iterations, rng, **options):
    """Return a PRM in the form of the exercise."""
    _, parent, controls, durations, ends = grown(
        problem, iterations, rng, **{"k": k, "stop": False, **options}
    )
    times = [0.0]
    for p, t in zip(parent[1:], durations[1:]):
        times.append(times[p] + t)
    edges = [(p, i) for i, p in enumerate(parent)][1:]
    return edges, controls[1:], durations[1:], path_to(parent, min(ends, key=lambda i: times[i]))


@wrong("kinodynamic_rrt")
def goal_test_without_wrap(*given):
    """Does not wrap the heading in the goal test."""
    return rrt(*given, there=lambda problem, q: is_there(problem, q, wrap=False))


@wrong("kinodynamic_rrt")
def goal_test_of_places(*given):
    """Accepts any heading at the goal."""
    return rrt(*given, there=lambda problem, q: is_there(problem, q, heading=False))


@wrong("kinodynamic_rrt")
def either_way_round(*given):
    """Accepts a car that points the opposite way."""

    def there(problem, q):
        turn = (q[2] - problem.goal[2] + math.pi / 2) % math.pi - math.pi / 2
        return is_there(problem, q, heading=False) and abs(turn) <= problem.turn_tolerance

    return rrt(*given, there=there)


@wrong("kinodynamic_rrt")
def end_without_wrap(*given):
    """Ends a path that does not arrive at the node nearest to the goal by plain headings."""
    problem = given[0]
    nodes, parent, controls, durations, ends = grown(*given)
    if not is_there(problem, nodes[ends[0]]):
        weights = np.array([1.0, 1.0, problem.radian])
        ends = [np.linalg.norm((np.array(nodes) - problem.goal) * weights, axis=1).argmin()]
    return parent, controls, durations, path_to(parent, int(ends[0]))


@wrong("kinodynamic_rrt")
def no_region(*given):
    """Ignores the region bias."""
    return rrt(*given, where=lambda problem, turn, rng: place(problem, turn, rng, region_every=0))


@wrong("kinodynamic_rrt")
def no_goal_bias(*given):
    """Never takes the goal as the target."""
    return rrt(*given, where=lambda problem, turn, rng: place(problem, turn, rng, goal_every=0))


@wrong("kinodynamic_rrt")
def always_the_goal(*given):
    """Is greedy: always takes the goal as the target."""
    return rrt(*given, where=lambda problem, turn, rng: problem.goal)


last_turn_left_out = changed("kinodynamic_rrt", ("iterations + 1", "iterations"))
last_turn_of_the_roadmap_left_out = changed("kinodynamic_prm", ("iterations + 1", "iterations"))
from_nodes_of_the_same_turn = changed(
    "kinodynamic_prm",
    (
        "        for near in np.argsort([problem.distance(q, target) for q in nodes])[:k]:\n",
        """        tried = set()
        while len(tried) < min(k, len(nodes)):
            off = [problem.distance(q, target) for q in nodes]
            near = min(set(range(len(nodes))) - tried, key=off.__getitem__)
            tried.add(near)
""",
    ),
)


@wrong("kinodynamic_rrt")
def turns_from_zero(*given):
    """Loops over range(iterations), so that region and goal come one iteration late."""
    return rrt(*given, first=0)


@wrong("kinodynamic_rrt")
def from_the_root(*given):
    """Always drives from the start."""
    return rrt(*given, choose=lambda order, k: [0])


@wrong("kinodynamic_rrt")
def from_the_farthest(*given):
    """Uses argmax."""
    return rrt(*given, choose=lambda order, k: order[-1:])


@wrong("kinodynamic_rrt")
def from_the_nearest_place(*given):
    """Ignores the heading when it looks for the nearest node."""
    return rrt(*given, apart=lambda a, b: math.dist(a[:2], b[:2]))


@wrong("kinodynamic_rrt")
def no_path_without_a_goal(*given):
    """Returns an empty path where no node is near enough."""
    nodes, parent, controls, durations, ends = grown(*given)
    return (
        parent,
        controls,
        durations,
        path_to(parent, ends[0]) if is_there(given[0], nodes[ends[0]]) else [],
    )


@wrong("kinodynamic_rrt")
def from_the_newest(*given):
    """Always drives from the newest node, which gives a chain."""
    return rrt(*given, choose=lambda order, k: [len(order) - 1])


@wrong("kinodynamic_rrt")
def one_control_unchecked(problem, *given):
    """Takes a random control and never checks for contact."""

    def drive(q, target, rng):
        v, phi = problem.control(rng)
        return v, phi, problem.longest

    return rrt(problem, *given, drive=drive)


@wrong("kinodynamic_rrt")
def driven_to_the_end(problem, *given):
    """Ignores the cut.

    The control is applied for the longest time, and what comes after the cut is not checked.
    """

    def drive(q, target, rng):
        found = problem.best_drive(q, target, rng)
        return found and (*found[:2], problem.longest)

    return rrt(problem, *given, drive=drive)


@wrong("kinodynamic_rrt")
def endpoint_checked(problem, *given):
    """Checks only the end of a drive."""

    def drive(q, target, rng):
        v, phi = problem.control(rng)
        return (
            (v, phi, problem.longest)
            if problem.is_free(problem.move(q, v, phi, problem.longest))
            else None
        )

    return rrt(problem, *given, drive=drive)


@wrong("kinodynamic_rrt")
def corners_checked(problem, *given):
    """Checks four corners at ten moments, and only against the walls of the room."""

    def drive(q, target, rng):
        v, phi = problem.control(rng)
        for s in np.linspace(0, problem.longest, 10):
            x, y, theta = problem.move(q, v, phi, s)
            for a, b in problem.robot.outline:
                corner = (
                    x + a * math.cos(theta) - b * math.sin(theta),
                    y + a * math.sin(theta) + b * math.cos(theta),
                )
                if not (
                    0 < corner[0] < problem.world.hi[0] and 0 < corner[1] < problem.world.hi[1]
                ):
                    return None
        return v, phi, problem.longest

    return rrt(problem, *given, drive=drive)


@wrong("kinodynamic_rrt")
def random_by_the_clock(*given):
    """Uses a generator without a seed."""
    return rrt(*given, seed=random.SystemRandom().randrange(2**32))


@wrong("kinodynamic_rrt")
def global_chance(problem, iterations, rng):
    """Seeds NumPy's global generator."""
    np.random.seed(rng)
    return rrt(problem, iterations, int(np.random.randint(10**6)))


@wrong("kinodynamic_rrt")
def one_seed_for_all(problem, iterations, rng):
    """Uses default_rng(0)."""
    return rrt(problem, iterations, 0)


@wrong("kinodynamic_rrt")
def path_from_the_goal(*given):
    """Returns the path in reverse."""
    parent, controls, durations, path = rrt(*given)
    return parent, controls, durations, path[::-1]


@wrong("kinodynamic_rrt")
def path_to_the_last(*given):
    """Returns the path to the last node, not to the nearest, on failure."""
    return rrt(*given, closest=False)


@wrong("kinodynamic_rrt")
def goes_on_at_the_goal(*given):
    """Never stops."""
    return rrt(*given, stop=False)


@wrong("kinodynamic_rrt")
def times_since_the_start(*given):
    """Adds the durations up."""
    _, parent, controls, durations, ends = grown(*given)
    clock = list(durations)
    for i, p in enumerate(parent[1:], 1):
        clock[i] += clock[p]
    return parent, controls, clock, path_to(parent, ends[0])


@wrong("kinodynamic_rrt")
def phi_in_degrees(*given):
    """Converts the angle to degrees."""
    parent, controls, durations, path = rrt(*given)
    return parent, [(v, math.degrees(phi)) for v, phi in controls], durations, path


@wrong("kinodynamic_rrt")
def from_the_nearest_without_wrap(problem, *given):
    """Looks for the nearest node by headings that it does not wrap."""

    def apart(a, b):
        return math.hypot(a[0] - b[0], a[1] - b[1], problem.radian * (a[2] - b[2]))

    return rrt(problem, *given, apart=apart)


@wrong("kinodynamic_rrt")
def drawn_until_free(*given):
    """Draws samples until a car that stands there touches nothing."""

    def where(problem, turn, rng):
        target = place(problem, turn, rng)
        while turn % 4 and turn % 7 and not problem.is_free(target):
            target = problem.sample(rng)
        return target

    return rrt(*given, where=where)


@wrong("kinodynamic_rrt")
def tried_again(problem, *given):
    """Computes a second drive where there is no first."""

    def drive(q, target, rng):
        return problem.best_drive(q, target, rng) or problem.best_drive(q, target, rng)

    return rrt(problem, *given, drive=drive)


@wrong("kinodynamic_rrt")
def one_pose_of_the_region(problem, iterations, rng):
    """Draws the pose near the goal once, before the loop."""
    near = problem.near_goal(np.random.default_rng(rng))

    def where(problem, turn, chance):
        return near if turn % 7 == 0 else place(problem, turn, chance)

    return rrt(problem, iterations, rng, where=where)


@wrong("kinodynamic_rrt")
def a_generator_in_each_turn(problem, iterations, rng):
    """Makes a new generator for each drive, from the seed and the turn."""
    count = iter(range(iterations))

    def drive(q, target, chance):
        return problem.best_drive(q, target, np.random.default_rng(rng + next(count)))

    return rrt(problem, iterations, rng, drive=drive)


@wrong("kinodynamic_rrt")
def goal_in_early_turns(*given):
    """Takes the goal as the target up to turn 100 only."""
    return rrt(
        *given, where=lambda problem, turn, rng: place(problem, turn, rng, 4 * (turn <= 100))
    )


@wrong("kinodynamic_rrt")
def newest_for_samples(problem, iterations, rng):
    """Drives from the newest node, except towards the goal and its region."""
    turns = iter(range(1, iterations + 1))

    def choose(order, k):
        turn = next(turns)
        return order[:1] if turn % 4 == 0 or turn % 7 == 0 else [len(order) - 1]

    return rrt(problem, iterations, rng, choose=choose)


@wrong("kinodynamic_prm")
def first_that_arrives(*given):
    """Takes the oldest node near the goal."""
    problem, k, iterations, rng = given
    _, parent, controls, durations, ends = grown(problem, iterations, rng, k=k, stop=False)
    return (
        [(p, i) for i, p in enumerate(parent)][1:],
        controls[1:],
        durations[1:],
        path_to(parent, ends[0]),
    )


@wrong("kinodynamic_prm")
def closest_not_fastest(problem, k, iterations, rng):
    """Takes the node nearest to the goal, not the one reached first."""
    nodes, parent, controls, durations, _ = grown(problem, iterations, rng, k=k, stop=False)
    nearest = int(np.argmin([problem.distance(q, problem.goal) for q in nodes]))
    return (
        [(p, i) for i, p in enumerate(parent)][1:],
        controls[1:],
        durations[1:],
        path_to(parent, nearest),
    )


@wrong("kinodynamic_prm")
def fewest_drives(problem, k, iterations, rng):
    """Is a breadth-first search."""
    _, parent, controls, durations, ends = grown(problem, iterations, rng, k=k, stop=False)
    edges = [(p, i) for i, p in enumerate(parent)][1:]
    return edges, controls[1:], durations[1:], min((path_to(parent, i) for i in ends), key=len)


@wrong("kinodynamic_prm")
def edges_turned(*given):
    """Stores edges as (to, from)."""
    edges, *others = prm(*given)
    return [(b, a) for a, b in edges], *others


@wrong("kinodynamic_prm")
def only_the_nearest(problem, k, iterations, rng):
    """Ignores k."""
    return prm(problem, 1, iterations, rng)


@wrong("kinodynamic_prm")
def the_farthest(*given):
    """Takes the last k of the order."""
    return prm(*given, choose=lambda order, k: order[-k:])


@wrong("kinodynamic_prm")
def from_new_ones(problem, k, iterations, rng):
    """Sorts again after each drive.

    The second drive may then start where the first has just ended.
    """
    rng = np.random.default_rng(rng)
    nodes, edges, controls, durations, times = [problem.start], [], [], [], [0.0]
    for turn in range(1, iterations + 1):
        target = place(problem, turn, rng)
        for i in range(min(k, len(nodes))):
            near = int(np.argsort([problem.distance(q, target) for q in nodes], kind="stable")[i])
            found = problem.best_drive(nodes[near], target, rng)
            if found is not None:
                edges.append((near, len(nodes)))
                nodes.append(problem.move(nodes[near], *found))
                controls.append(found[:2])
                durations.append(found[2])
                times.append(times[near] + found[2])
    ends = [i for i, q in enumerate(nodes) if is_there(problem, q)]
    ends = ends or [int(np.argmin([problem.distance(q, problem.goal) for q in nodes]))]
    return (
        edges,
        controls,
        durations,
        path_to([-1, *(u for u, _ in edges)], min(ends, key=lambda i: times[i])),
    )


@wrong("kinodynamic_prm")
def roadmap_without_region(*given):
    """Ignores the region bias."""
    return prm(*given, where=lambda problem, turn, rng: place(problem, turn, rng, region_every=0))


@wrong("kinodynamic_prm")
def roadmap_without_wrap(*given):
    """Does not wrap the heading in the goal test."""
    return prm(*given, there=lambda problem, q: is_there(problem, q, wrap=False))


@wrong("kinodynamic_prm")
def stops_at_the_goal(*given):
    """Stops at the goal as a tree does, and so has fewer paths to choose from."""
    return prm(*given, stop=True)


@wrong("kinodynamic_prm")
def from_the_nearest_places(*given):
    """Ignores the heading when it looks for the nearest nodes."""
    return prm(*given, apart=lambda a, b: math.dist(a[:2], b[:2]))


@wrong("kinodynamic_prm")
def one_too_many(problem, k, *given):
    """Takes order[: k + 1]."""
    return prm(problem, k + 1, *given)


@wrong("kinodynamic_prm")
def a_target_for_each_drive(problem, k, *given):
    """Draws a new sample for each of the k drives."""

    def drive(q, target, rng):
        near = np.allclose(q, problem.start)
        return problem.best_drive(q, target if near else problem.sample(rng), rng)

    return prm(problem, k, *given, drive=drive)


@wrong("kinodynamic_prm")
def nearest_without_wrap(problem, *given):
    """Looks for the nearest nodes by headings that it does not wrap."""

    def apart(a, b):
        return math.hypot(a[0] - b[0], a[1] - b[1], problem.radian * (a[2] - b[2]))

    return prm(problem, *given, apart=apart)


@wrong("kinodynamic_prm")
def roadmap_by_the_clock(*given):
    """Uses a generator without a seed."""
    return prm(*given, seed=random.SystemRandom().randrange(2**32))


@wrong("kinodynamic_prm")
def start_left_out(*given):
    """Leaves node 0 out of the path."""
    edges, controls, durations, path = prm(*given)
    return edges, controls, durations, path[1:] or [len(edges)]


# The fastest drive


def dijkstra(n, edges, controls, durations, ends, *, rows=None):
    """Return the fastest path, by Dijkstra's algorithm."""
    rows = [(*pair, t) for pair, t in zip(edges, durations)] if rows is None else rows
    far, parent, queue = {0: 0.0}, {0: -1}, [(0.0, 0)]
    while queue:
        d, u = heapq.heappop(queue)
        for a, b, t in rows:
            if a == u and d + t < far.get(b, math.inf):
                far[b], parent[b] = d + t, u
                heapq.heappush(queue, (d + t, int(b)))
    reached = [int(end) for end in ends if end in far]
    if not reached:
        return None
    path = [min(reached, key=far.get)]
    while parent[path[-1]] >= 0:
        path.append(int(parent[path[-1]]))
    return path[::-1]


@wrong("fastest_drive", slip="undirected")
def both_ways(n, edges, controls, durations, ends):
    """Uses the edges in both directions."""
    rows = [(*pair, t) for pair, t in zip(edges, durations)]
    return dijkstra(
        n, edges, controls, durations, ends, rows=rows + [(b, a, t) for a, b, t in rows]
    )


@wrong("fastest_drive", slip="fewest")
def breadth_first(n, edges, controls, durations, ends):
    """Counts each drive as one."""
    return dijkstra(n, edges, controls, np.ones(len(edges)), ends)


@wrong("fastest_drive", slip="length")
def shortest_not_fastest(n, edges, controls, durations, ends):
    """Adds lengths instead of durations."""
    return dijkstra(
        n, edges, controls, [abs(v) * t for (v, _), t in zip(controls, durations)], ends
    )


@wrong("fastest_drive", slip="first_end")
def one_end(n, edges, controls, durations, ends):
    """Uses ends[0] only."""
    return dijkstra(n, edges, controls, durations, ends[:1])


@wrong("fastest_drive", slip="doubles")
def last_of_two_rows(n, edges, controls, durations, ends):
    """Keeps the edges in a dictionary, and so only the last of parallel ones."""
    rows = {(int(a), int(b)): t for (a, b), t in zip(edges, durations)}
    return dijkstra(
        n, edges, controls, durations, ends, rows=[(*pair, t) for pair, t in rows.items()]
    )


@wrong("fastest_drive", slip="passes")
def relaxed_three_times(n, edges, controls, durations, ends):
    """Is a Bellman-Ford with too few rounds: right where the rows stand in a good order."""
    far, parent = {0: 0.0}, {0: -1}
    for _ in range(3):
        for (a, b), t in zip(edges.tolist(), durations):
            if a in far and far[a] + t < far.get(b, math.inf):
                far[b], parent[b] = far[a] + t, a
    reached = [end for end in ends.tolist() if end in far]
    return path_to(parent, min(reached, key=far.get)) if reached else None


@wrong("fastest_drive", slip="against")
def against_the_arrows(n, edges, controls, durations, ends):
    """Reads edges as (to, from)."""
    return dijkstra(
        n, edges, controls, durations, ends, rows=[(b, a, t) for (a, b), t in zip(edges, durations)]
    )


@wrong("fastest_drive", slip="backwards")
def from_the_end(*given):
    """Returns the path in reverse."""
    path = dijkstra(*given)
    return path and path[::-1]


@wrong("fastest_drive", slip="no_start")
def without_the_start(*given):
    """Leaves node 0 out."""
    path = dijkstra(*given)
    return path if path is None else path[1:]


@wrong("fastest_drive", slip="no_end")
def without_the_end(*given):
    """Leaves the end out."""
    path = dijkstra(*given)
    return path if path is None else path[:-1]


@wrong("fastest_drive")
def empty_for_none(*given):
    """Returns an empty list where there is no drive."""
    return dijkstra(*given) or []


@wrong("fastest_drive")
def greedy(n, edges, controls, durations, ends):
    """Takes the quickest drive from each node."""
    path = [0]
    while path[-1] not in ends:
        on = [(t, int(b)) for (a, b), t in zip(edges, durations) if a == path[-1] and b not in path]
        if not on:
            return None
        path.append(min(on)[1])
    return path


# Many turns, long drives

five_turns_at_most = changed(
    "heading_distance",
    (
        "(b[2] - a[2] + math.pi) % (2 * math.pi) - math.pi",
        "min((b[2] - a[2] + 2 * math.pi * k for k in range(-5, 6)), key=abs)",
    ),
)
less_than_a_thousand = changed("fastest_drive", ("time.get(v, math.inf)", "time.get(v, 1000.0)"))
TOLERANCE = "problem.tolerance"
a_little_less_than_the_tolerance = changed(
    "kinodynamic_rrt", (TOLERANCE, "0.98 * problem.tolerance")
)
a_little_more_than_the_tolerance = changed(
    "kinodynamic_rrt", (TOLERANCE, "1.02 * problem.tolerance")
)
less_than_the_tolerance_in_a_roadmap = changed("kinodynamic_prm", (TOLERANCE, "4.9"))
more_than_the_tolerance_in_a_roadmap = changed("kinodynamic_prm", (TOLERANCE, "5.1"))
turn_counts_in_the_tolerance = changed(
    "kinodynamic_rrt", ("math.dist(q[:2], goal[:2])", "problem.distance(q, goal)")
)
two_digits_of_the_seed = changed("kinodynamic_rrt", ("default_rng(rng)", "default_rng(rng % 100)"))
even_or_odd_seed = changed("kinodynamic_prm", ("default_rng(rng)", "default_rng(rng % 2)"))
ignores_little_gains = changed(
    "fastest_drive", ("< time.get(v, math.inf)", "< time.get(v, math.inf) - 1e-4")
)


# Variants

WHOLE = "math.sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2 + (radian * turn) ** 2)"
sum_of_parts = varied(
    "heading_distance", "sum", (WHOLE, "math.dist(a[:2], b[:2]) + abs(radian * turn)")
)
larger_part = varied(
    "heading_distance", "larger", (WHOLE, "max(math.dist(a[:2], b[:2]), abs(radian * turn))")
)
sum_with_signs = changed(
    "heading_distance", (WHOLE, "math.dist(a[:2], b[:2]) + radian * turn"), variant="sum"
)
larger_without_wrap = changed(
    "heading_distance",
    (WHOLE, "max(math.dist(a[:2], b[:2]), radian * abs(b[2] - a[2]))"),
    variant="larger",
    slip="no_wrap",
)

CHOICE = "best, least = (i, k), away[k - 1]"
steps_that_are_cut_off = varied(
    "best_control", "steps_left", (CHOICE, CHOICE.replace("k)", "n - k)"))
)
controls_from_the_last = varied(
    "best_control", "from_last", (CHOICE, CHOICE.replace("(i,", "(len(controls) - 1 - i,"))
)
steps_cut_off_and_one_more = changed(
    "best_control",
    (CHOICE, CHOICE.replace("k)", "n - k + 1)")),
    variant="steps_left",
    slip="counted",
)
controls_from_the_last_and_one = changed(
    "best_control", (CHOICE, CHOICE.replace("(i,", "(len(controls) - i,")), variant="from_last"
)
