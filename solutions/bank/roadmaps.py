"""Wrong answers to the exercises of lesson 8.

Each is a mistake that students make; `slip` is the misconception that a check must recognise.
"""

import heapq
import math
import random
from itertools import combinations
from pathlib import Path

import numpy as np
import shapely

from kinoedu.course.bank import Solutions, wrong

solutions = Solutions(Path(__file__).parents[1] / "08_roadmaps.ipynb")
changed, varied = solutions.changed, solutions.varied


def turns(ring):
    """Return twice the signed area at each vertex, positive for a left turn."""
    a, b = ring - np.roll(ring, 1, axis=0), np.roll(ring, -1, axis=0) - ring
    return a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]


def corners(problem, obstacles, keep=lambda turned: turned > 0):
    """Return start, goal and the vertices that `keep` accepts."""
    return [
        problem.start,
        problem.goal,
        *(v for ring in obstacles for v, good in zip(ring, keep(turns(ring))) if good),
    ]


def seen(nodes, sees):
    """Return the nodes with the pairs that see each other."""
    pairs = combinations(range(len(nodes)), 2)
    return np.array(nodes), [(i, j) for i, j in pairs if sees(nodes[i], nodes[j])]


# The visibility roadmap


@wrong("visibility_roadmap", slip="every_vertex")
def every_vertex_a_node(problem, obstacles):
    """Takes reflex vertices too."""
    return seen([problem.start, problem.goal, *np.vstack(obstacles)], problem.is_semi_free_path)


@wrong("visibility_roadmap", slip="not_reflex")
def straight_angles_kept(problem, obstacles):
    """Has >= instead of >."""
    return seen(corners(problem, obstacles, lambda turned: turned >= 0), problem.is_semi_free_path)


@wrong("visibility_roadmap", slip="no_contact")
def free_for_semi_free(problem, obstacles):
    """Demands free motions, but corners cannot be reached without contact."""
    return seen(corners(problem, obstacles), problem.is_free_path)


@wrong("visibility_roadmap", slip="no_ends")
def start_and_goal_alone(problem, obstacles):
    """Leaves start and goal without edges."""
    nodes, pairs = seen(corners(problem, obstacles), problem.is_semi_free_path)
    return nodes, [(i, j) for i, j in pairs if i > 1]


@wrong("visibility_roadmap", slip="between")
def never_along_an_obstacle(problem, obstacles):
    """Takes the edges of obstacles for blocked."""
    nodes = corners(problem, obstacles)
    owner = [
        -1,
        -2,
        *(k for k, ring in enumerate(obstacles) for turned in turns(ring) if turned > 0),
    ]
    found, pairs = seen(nodes, problem.is_semi_free_path)
    return found, [(i, j) for i, j in pairs if owner[i] != owner[j]]


flat_corners_left_out = changed("visibility_roadmap", ("(w[0] - v[0]) > 0", "(w[0] - v[0]) > 1e-3"))


@wrong("visibility_roadmap", slip="hull")
def corners_of_the_hull(problem, obstacles):
    """Takes the corners of the convex hull for the convex vertices."""
    hulls = [set(shapely.Polygon(ring).convex_hull.exterior.coords) for ring in obstacles]
    corners = [v for ring, hull in zip(obstacles, hulls) for v in ring if tuple(v.tolist()) in hull]
    return seen([problem.start, problem.goal, *corners], problem.is_semi_free_path)


@wrong("visibility_roadmap")
def reflex_for_convex(problem, obstacles):
    """Takes right turns instead of left turns."""
    return seen(corners(problem, obstacles, lambda turned: turned < 0), problem.is_semi_free_path)


@wrong("visibility_roadmap")
def goal_last(problem, obstacles):
    """Returns the nodes in the library's order."""
    nodes = corners(problem, obstacles)
    return seen([*nodes[2:], *nodes[:2]], problem.is_semi_free_path)


@wrong("visibility_roadmap")
def without_start_and_goal(problem, obstacles):
    """Returns the corners only."""
    return seen(corners(problem, obstacles)[2:], problem.is_semi_free_path)


@wrong("visibility_roadmap")
def pairs_both_ways(problem, obstacles):
    """Returns (i, j) and (j, i)."""
    nodes, pairs = seen(corners(problem, obstacles), problem.is_semi_free_path)
    return nodes, pairs + [(j, i) for i, j in pairs]


@wrong("visibility_roadmap")
def everything_joined(problem, obstacles):
    """Checks no motion."""
    return seen(corners(problem, obstacles), lambda a, b: True)


@wrong("visibility_roadmap")
def middles_only(problem, obstacles):
    """Checks only the midpoint of a motion."""
    return seen(corners(problem, obstacles), lambda a, b: problem.is_free((a + b) / 2))


@wrong("visibility_roadmap")
def last_vertex_forgotten(problem, obstacles):
    """Does not close the ring."""
    kept = lambda turned: (turned > 0) & (np.arange(len(turned)) < len(turned) - 1)  # noqa: E731
    return seen(corners(problem, obstacles, kept), problem.is_semi_free_path)


@wrong("visibility_roadmap")
def next_convex_vertex_unchecked(problem, obstacles):
    """Joins each convex vertex to the next one of its obstacle without asking."""
    nodes, edges = seen(corners(problem, obstacles), problem.is_semi_free_path)
    first, sides = 2, set(edges)
    for n in (int((turns(ring) > 0).sum()) for ring in obstacles):
        sides |= {tuple(sorted((first + i, first + (i + 1) % n))) for i in range(n)}
        first += n
    return nodes, sorted(sides)


# Motions that are asked about otherwise


def places_along(problem):
    """Replace the motion check by sampled points, between which thin obstacles fit."""
    return lambda a, b: all(problem.is_free(a + t * (b - a)) for t in np.linspace(0, 1, 100))


# The r-radius rule


def within(problem, nodes, near, free=None):
    asked = problem.is_free_path if free is None else free
    return [
        (i, j)
        for i, j in combinations(range(len(nodes)), 2)
        if near(nodes[i], nodes[j]) and asked(nodes[i], nodes[j])
    ]


@wrong("radius_neighbours", slip="strict")
def less_than_r(problem, nodes, r):
    """Has < instead of <=."""
    return within(problem, nodes, lambda a, b: problem.distance(a, b) < r)


@wrong("radius_neighbours", slip="blind")
def through_walls(problem, nodes, r):
    """Checks points instead of motions."""
    return within(
        problem,
        nodes,
        lambda a, b: problem.distance(a, b) <= r,
        lambda a, b: problem.is_free(a) and problem.is_free(b),
    )


@wrong("radius_neighbours", slip="twice")
def each_pair_twice(problem, nodes, r):
    """Has two loops over all nodes."""
    pairs = within(problem, nodes, lambda a, b: problem.distance(a, b) <= r)
    return pairs + [(j, i) for i, j in pairs]


@wrong("radius_neighbours", slip="itself")
def its_own_neighbour(problem, nodes, r):
    """Begins j at i."""
    pairs = within(problem, nodes, lambda a, b: problem.distance(a, b) <= r)
    return [*pairs, *((i, i) for i in range(len(nodes)))]


@wrong("radius_neighbours", slip="straight")
def across_the_page(problem, nodes, r):
    """Does not wrap angles."""
    return within(problem, nodes, lambda a, b: np.linalg.norm(a - b) <= r)


@wrong("radius_neighbours", slip="touching")
def semi_free_for_free(problem, nodes, r):
    """Allows contact."""
    return within(
        problem, nodes, lambda a, b: problem.distance(a, b) <= r, problem.is_semi_free_path
    )


@wrong("radius_neighbours", slip="sampled")
def a_hundred_places(problem, nodes, r):
    """Checks a hundred points of a motion that does not wrap angles."""
    return within(problem, nodes, lambda a, b: problem.distance(a, b) <= r, places_along(problem))


@wrong("radius_neighbours", slip="squared")
def the_square_of_the_distance(problem, nodes, r):
    """Forgets the root on one side."""
    return within(problem, nodes, lambda a, b: problem.distance(a, b) ** 2 <= r)


@wrong("radius_neighbours", slip="diameter")
def half_the_radius(problem, nodes, r):
    """Takes r for a diameter."""
    return within(problem, nodes, lambda a, b: problem.distance(a, b) <= r / 2)


@wrong("radius_neighbours")
def a_box_for_a_ball(problem, nodes, r):
    """Compares coordinate by coordinate."""
    return within(problem, nodes, lambda a, b: np.abs(a - b).max() <= r)


@wrong("radius_neighbours")
def in_a_row_only(problem, nodes, r):
    """Joins each node only to the next."""
    steps = [(i, i + 1) for i in range(len(nodes) - 1)]
    return [
        (i, j)
        for i, j in steps
        if problem.distance(nodes[i], nodes[j]) <= r and problem.is_free_path(nodes[i], nodes[j])
    ]


@wrong("radius_neighbours")
def coordinates_for_numbers(problem, nodes, r):
    """Returns coordinates instead of indices."""
    return [
        (*nodes[i], *nodes[j])
        for i, j in within(problem, nodes, lambda a, b: problem.distance(a, b) <= r)
    ]


@wrong("radius_neighbours", slip="blind")
def middles_for_motions(problem, nodes, r):
    """Checks one point of a motion."""
    return within(
        problem,
        nodes,
        lambda a, b: problem.distance(a, b) <= r,
        lambda a, b: problem.is_free((a + b) / 2),
    )


# The K-closest rule


def rows(problem, nodes, k, distance=None, sign=1, skip=1):
    apart = problem.distance if distance is None else distance
    order = [
        sorted(
            range(len(nodes)),
            key=lambda j: sign * apart(nodes[i], nodes[j]) if j != i else -math.inf,
        )
        for i in range(len(nodes))
    ]
    return [(i, j) for i in range(len(nodes)) for j in order[i][skip : k + skip]]


def joined(problem, nodes, pairs, free=None):
    once = {(min(i, j), max(i, j)) for i, j in pairs}
    return sorted((i, j) for i, j in once if (free or problem.is_free_path)(nodes[i], nodes[j]))


@wrong("k_closest", slip="farthest")
def the_farthest(problem, nodes, k):
    """Sorts in the wrong order."""
    return joined(problem, nodes, rows(problem, nodes, k, sign=-1))


@wrong("k_closest", slip="blind")
def close_through_walls(problem, nodes, k):
    """Checks points instead of motions."""
    return sorted({(min(i, j), max(i, j)) for i, j in rows(problem, nodes, k)})


@wrong("k_closest", slip="itself")
def itself_among_the_closest(problem, nodes, k):
    """Counts the node itself as its closest node."""
    return joined(problem, nodes, [(i, j) for i, j in rows(problem, nodes, k, skip=0) if i != j])


@wrong("k_closest")
def first_of_the_sorted_left_out(problem, nodes, k):
    """Leaves out the first of the sorted nodes, which is another one where two coincide."""
    pairs = []
    for i in range(len(nodes)):
        near = sorted(range(len(nodes)), key=lambda j: problem.distance(nodes[i], nodes[j]))
        pairs += [(i, j) for j in near[1 : k + 1] if j != i]
    return joined(problem, nodes, pairs)


@wrong("k_closest", slip="replaced")
def the_closest_free_ones(problem, nodes, k):
    """Checks motions before it takes the K closest."""
    pairs = []
    for i in range(len(nodes)):
        others = [
            j for j in range(len(nodes)) if j != i and problem.is_free_path(nodes[i], nodes[j])
        ]
        pairs += [
            (i, j) for j in sorted(others, key=lambda j: problem.distance(nodes[i], nodes[j]))[:k]
        ]
    return joined(problem, nodes, pairs)


@wrong("k_closest", slip="mutual")
def close_both_ways(problem, nodes, k):
    """Has `and` instead of `or`."""
    named = set(rows(problem, nodes, k))
    return joined(problem, nodes, [(i, j) for i, j in named if (j, i) in named])


@wrong("k_closest", slip="lost")
def seen_before(problem, nodes, k):
    """Takes (i, j) with j < i for a pair that was already checked."""
    return joined(problem, nodes, [(i, j) for i, j in rows(problem, nodes, k) if i < j])


@wrong("k_closest", slip="later")
def among_later_nodes(problem, nodes, k):
    """Loops over j from i + 1 on."""
    pairs = []
    for i in range(len(nodes)):
        later = sorted(range(i + 1, len(nodes)), key=lambda j: problem.distance(nodes[i], nodes[j]))
        pairs += [(i, j) for j in later[:k]]
    return joined(problem, nodes, pairs)


@wrong("k_closest", slip="straight")
def closest_on_the_page(problem, nodes, k):
    """Does not wrap angles."""
    return joined(
        problem, nodes, rows(problem, nodes, k, distance=lambda a, b: np.linalg.norm(a - b))
    )


@wrong("k_closest", slip="touching")
def closest_with_contact(problem, nodes, k):
    """Allows contact."""
    return joined(problem, nodes, rows(problem, nodes, k), problem.is_semi_free_path)


@wrong("k_closest", slip="sampled")
def closest_by_places(problem, nodes, k):
    """Checks sampled points of a motion that does not wrap angles."""
    return joined(problem, nodes, rows(problem, nodes, k), places_along(problem))


@wrong("k_closest", slip="one")
def the_nearest_alone(problem, nodes, k):
    """Ignores K."""
    return joined(problem, nodes, rows(problem, nodes, 1))


@wrong("k_closest")
def at_most_k_edges(problem, nodes, k):
    """Accepts no more edges at a node that has K."""
    degree, pairs = [0] * len(nodes), []
    for i, j in joined(problem, nodes, rows(problem, nodes, k)):
        if degree[i] < k and degree[j] < k:
            pairs.append((i, j))
            degree[i] += 1
            degree[j] += 1
    return pairs


@wrong("k_closest")
def last_of_equals(problem, nodes, k):
    """Breaks ties in favour of the higher index."""
    pairs = []
    for i in range(len(nodes)):
        others = [j for j in range(len(nodes) - 1, -1, -1) if j != i]
        pairs += [
            (i, j) for j in sorted(others, key=lambda j: problem.distance(nodes[i], nodes[j]))[:k]
        ]
    return joined(problem, nodes, pairs)


@wrong("k_closest")
def as_lists_of_neighbours(problem, nodes, k):
    """Returns a list for each node."""
    return [[j for a, j in rows(problem, nodes, k) if a == i] for i in range(len(nodes))]


# The component-wise rule


def by_components(problem, nodes, k, free=None, distance=None, goes_on=False, one=False):
    asked, apart = free or problem.is_free_path, distance or problem.distance
    components, pairs = [], []
    for i in range(len(nodes)):
        mine = {i}
        nearest_first = sorted(components, key=lambda c: min(apart(nodes[i], nodes[j]) for j in c))
        for component in nearest_first:
            closest = sorted(component, key=lambda j: (apart(nodes[i], nodes[j]), j))[:k]
            good = [j for j in closest if asked(nodes[j], nodes[i])]
            if good and not (one and len(mine) > 1):
                pairs += [(j, i) for j in (good if goes_on else good[:1])]
                mine |= component
        components = [c for c in components if not c & mine] + [mine]
    return pairs


@wrong("component_k_closest", slip="blind")
def components_through_walls(problem, nodes, k):
    """Checks points instead of motions."""
    return by_components(problem, nodes, k, free=lambda a, b: True)


@wrong("component_k_closest", slip="goes_on")
def all_k_of_a_component(problem, nodes, k):
    """Has no break."""
    return by_components(problem, nodes, k, goes_on=True)


@wrong("component_k_closest", slip="one_component")
def the_nearest_component(problem, nodes, k):
    """Stops after one component."""
    return by_components(problem, nodes, k, one=True)


@wrong("component_k_closest", slip="nearest_only")
def one_try_each(problem, nodes, k):
    """Ignores K."""
    return by_components(problem, nodes, 1)


@wrong("component_k_closest", slip="any_number")
def as_many_tries_as_it_takes(problem, nodes, k):
    """Tries more than K nodes."""
    return by_components(problem, nodes, len(nodes))


@wrong("component_k_closest", slip="closest")
def the_rule_before(problem, nodes, k):
    """Is the K-closest rule."""
    return joined(problem, nodes, rows(problem, nodes, k))


@wrong("component_k_closest", slip="straight")
def components_on_the_page(problem, nodes, k):
    """Does not wrap angles."""
    return by_components(problem, nodes, k, distance=lambda a, b: np.linalg.norm(a - b))


@wrong("component_k_closest", slip="touching")
def components_with_contact(problem, nodes, k):
    """Allows contact."""
    return by_components(problem, nodes, k, free=problem.is_semi_free_path)


@wrong("component_k_closest", slip="sampled")
def components_by_places(problem, nodes, k):
    """Checks sampled points of a motion that does not wrap angles."""
    return by_components(problem, nodes, k, free=places_along(problem))


@wrong("component_k_closest")
def never_merged(problem, nodes, k):
    """Adds each node to the first component that it joins, and never merges components."""
    components, pairs = [], []
    for i in range(len(nodes)):
        home = None
        for component in components:
            for j in sorted(component, key=lambda j: problem.distance(nodes[i], nodes[j]))[:k]:
                if problem.is_free_path(nodes[j], nodes[i]):
                    pairs.append((j, i))
                    home = home or component
                    break
        if home is None:
            components.append([i])
        else:
            home.append(i)
    return pairs


@wrong("component_k_closest", slip="one_component")
def k_closest_without_circles(problem, nodes, k):
    """Tries the K closest of all earlier nodes, not of each component."""
    part, pairs = list(range(len(nodes))), []
    for i in range(1, len(nodes)):
        for j in sorted(range(i), key=lambda j: problem.distance(nodes[i], nodes[j]))[:k]:
            if part[i] != part[j] and problem.is_free_path(nodes[j], nodes[i]):
                pairs.append((j, i))
                part = [part[i] if p == part[j] else p for p in part]
    return pairs


@wrong("component_k_closest")
def larger_number_first(problem, nodes, k):
    """Returns (i, j) with j < i."""
    return [(i, j) for j, i in by_components(problem, nodes, k)]


@wrong("component_k_closest")
def any_node_of_a_component(problem, nodes, k):
    """Tries the first nodes of a component, not the closest."""
    return by_components(problem, nodes, k, distance=lambda a, b: 0.0)


# The whole roadmap


def built(problem, n, k, rng, sample=None, keep=None):
    nodes = [problem.start, problem.goal]
    draw, good = sample or problem.sample, keep or problem.is_free
    while len(nodes) < n + 2:
        q = draw(rng)
        if good(q):
            nodes.append(q)
    return np.array(nodes)


@wrong("sampled_roadmap")
def samples_in_obstacles(problem, n, k, rng):
    """Does not check that a sample is free."""
    nodes = built(problem, n, k, np.random.default_rng(rng), keep=lambda q: True)
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def fewer_samples(problem, n, k, rng):
    """Draws n samples instead of n free samples."""
    chance = np.random.default_rng(rng)
    nodes = np.array(
        [
            problem.start,
            problem.goal,
            *(q for q in (problem.sample(chance) for _ in range(n)) if problem.is_free(q)),
        ]
    )
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def ends_checked_not_edges(problem, n, k, rng):
    """Checks the nodes, but not the edges."""
    nodes = built(problem, n, k, np.random.default_rng(rng))
    return nodes, sorted({(min(i, j), max(i, j)) for i, j in rows(problem, nodes, k)})


@wrong("sampled_roadmap")
def edges_that_touch(problem, n, k, rng):
    """Allows contact."""
    nodes = built(problem, n, k, np.random.default_rng(rng))
    return nodes, joined(problem, nodes, rows(problem, nodes, k), problem.is_semi_free_path)


@wrong("sampled_roadmap")
def edges_by_places(problem, n, k, rng):
    """Checks sampled points of a motion."""
    nodes = built(problem, n, k, np.random.default_rng(rng))
    return nodes, joined(problem, nodes, rows(problem, nodes, k), places_along(problem))


@wrong("sampled_roadmap")
def the_room_measured_by_eye(problem, n, k, rng):
    """Samples the room that the first cases show."""
    nodes = built(
        problem, n, k, np.random.default_rng(rng), sample=lambda rng: rng.uniform((0, 0), (16, 10))
    )
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def another_generator(problem, n, k, rng):
    """Uses a generator without a seed."""
    nodes = built(problem, n, k, np.random.default_rng())
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def always_the_same_seed(problem, n, k, rng):
    """Ignores rng."""
    nodes = built(problem, n, k, np.random.default_rng(0))
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def global_numbers(problem, n, k, rng):
    """Uses NumPy's global generator."""
    np.random.seed(rng)
    nodes = built(problem, n, k, rng, sample=lambda _: np.array([16, 10]) * np.random.random(2))
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def pythons_numbers(problem, n, k, rng):
    """Uses Python's global generator."""
    random.seed(rng)
    nodes = built(
        problem, n, k, rng, sample=lambda _: np.array([16 * random.random(), 10 * random.random()])
    )
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def a_generator_for_each_sample(problem, n, k, rng):
    """Draws the same sample again and again."""
    nodes = built(
        problem,
        n,
        k,
        rng,
        sample=lambda rng: problem.sample(np.random.default_rng(rng)),
        keep=lambda q: True,
    )
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def seeds_in_order(problem, n, k, rng):
    """Makes a new generator, of the next seed, for each sample."""
    seeds = iter(range(10**6))
    nodes = built(
        problem,
        n,
        k,
        rng,
        sample=lambda _: problem.sample(np.random.default_rng([rng, next(seeds)])),
    )
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def one_in_each_cell(problem, n, k, rng):
    """Takes one place in each cell of a grid, so that the samples are more even than chance."""
    chance, nodes = np.random.default_rng(rng), [problem.start, problem.goal]
    side = math.ceil(math.sqrt(n))
    cells = [(i, j) for i in range(side) for j in range(side)]
    while len(nodes) < n + 2:
        q = (cells[len(nodes) % len(cells)] + chance.random(2)) / side * problem.world.hi
        if problem.is_free(q):
            nodes.append(q)
    return np.array(nodes), joined(problem, nodes, rows(problem, np.array(nodes), k))


@wrong("sampled_roadmap")
def only_what_the_start_sees(problem, n, k, rng):
    """Keeps the samples that start or goal sees."""
    ends = problem.start, problem.goal
    nodes = built(
        problem,
        n,
        k,
        np.random.default_rng(rng),
        keep=lambda q: any(problem.is_free_path(end, q) for end in ends),
    )
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def in_one_half(problem, n, k, rng):
    """Samples only on the start's side."""
    nodes = built(
        problem, n, k, np.random.default_rng(rng), keep=lambda q: problem.is_free(q) and q[0] < 8
    )
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def start_and_goal_left_out(problem, n, k, rng):
    """Joins the samples only."""
    nodes = built(problem, n, k, np.random.default_rng(rng))
    pairs = joined(problem, nodes[2:], rows(problem, nodes[2:], k))
    return nodes, [(i + 2, j + 2) for i, j in pairs]


@wrong("sampled_roadmap")
def goal_at_the_end(problem, n, k, rng):
    """Returns start, samples, goal."""
    nodes = np.roll(built(problem, n, k, np.random.default_rng(rng)), -1, axis=0)
    nodes = np.vstack([nodes[-1:], nodes[1:-1], nodes[:1]])
    return nodes, joined(problem, nodes, rows(problem, nodes, k))


@wrong("sampled_roadmap")
def only_the_nearest(problem, n, k, rng):
    """Uses K = 1."""
    nodes = built(problem, n, k, np.random.default_rng(rng))
    return nodes, joined(problem, nodes, rows(problem, nodes, 1))


@wrong("sampled_roadmap")
def everybody_joined(problem, n, k, rng):
    """Joins all pairs."""
    nodes = built(problem, n, k, np.random.default_rng(rng))
    return nodes, joined(problem, nodes, combinations(range(len(nodes)), 2))


# The shortest path


def searched(nodes, edges, start, goal, weigh=None, estimate=None, one_way=False):
    """Find a path by Dijkstra's algorithm with given weights, and its cost."""
    cost_of = weigh or (lambda a, b: float(np.linalg.norm(a - b)))
    leads = {}
    for i, j in np.asarray(edges).tolist():
        for u, v in [(i, j)] if one_way else [(i, j), (j, i)]:
            leads.setdefault(u, []).append(v)
    cost, parent, heap, done = {start: 0.0}, {start: -1}, [(0.0, start)], set()
    while heap:
        _, u = heapq.heappop(heap)
        if u in done:
            continue
        done.add(u)
        for v in leads.get(u, []):
            c = cost[u] + cost_of(nodes[u], nodes[v])
            if c < cost.get(v, math.inf):
                cost[v], parent[v] = c, u
                heapq.heappush(heap, (c if estimate is None else estimate(nodes[v]), v))
    if goal not in cost:
        return None, math.inf
    path = [goal]
    while parent[path[-1]] >= 0:
        path.append(parent[path[-1]])
    return path[::-1], cost[goal]


def measured(nodes, path):
    """Return the length of a path."""
    return (
        math.inf
        if path is None
        else sum(float(np.linalg.norm(nodes[i] - nodes[j])) for i, j in zip(path, path[1:]))
    )


@wrong("shortest_path", slip="fewest")
def fewest_edges(nodes, edges, start, goal):
    """Is a breadth-first search."""
    path, _ = searched(nodes, edges, start, goal, weigh=lambda a, b: 1.0)
    return path, measured(nodes, path)


@wrong("shortest_path", slip="counted")
def edges_counted(nodes, edges, start, goal):
    """Returns the number of edges as the length."""
    return searched(nodes, edges, start, goal, weigh=lambda a, b: 1.0)


@wrong("shortest_path", slip="squared")
def squares_added(nodes, edges, start, goal):
    """Forgets the root."""
    return searched(nodes, edges, start, goal, weigh=lambda a, b: float(((a - b) ** 2).sum()))


@wrong("shortest_path", slip="one_way")
def edges_one_way(nodes, edges, start, goal):
    """Uses (i, j) in one direction only."""
    return searched(nodes, edges, start, goal, one_way=True)


@wrong("shortest_path", slip="plane")
def two_coordinates(nodes, edges, start, goal):
    """Uses only two coordinates."""
    return searched(nodes[:, :2], edges, start, goal)


@wrong("shortest_path", slip="straight")
def as_the_crow_flies(nodes, edges, start, goal):
    """Returns the distance from start to goal."""
    return searched(nodes, edges, start, goal)[0], float(np.linalg.norm(nodes[start] - nodes[goal]))


@wrong("shortest_path")
def from_goal_to_start(nodes, edges, start, goal):
    """Returns the path in reverse."""
    path, far = searched(nodes, edges, start, goal)
    return (None if path is None else path[::-1]), far


@wrong("shortest_path")
def empty_where_there_is_none(nodes, edges, start, goal):
    """Returns an empty path instead of None."""
    path, far = searched(nodes, edges, start, goal)
    return path or [], far


@wrong("shortest_path")
def zero_where_there_is_none(nodes, edges, start, goal):
    """Returns None with the length 0."""
    path, far = searched(nodes, edges, start, goal)
    return path, far if path else 0.0


@wrong("shortest_path")
def path_alone(nodes, edges, start, goal):
    """Returns one value instead of two."""
    return searched(nodes, edges, start, goal)[0]


@wrong("shortest_path")
def greedy(nodes, edges, start, goal):
    """Always goes to the neighbour nearest to the goal."""
    path, _ = searched(
        nodes, edges, start, goal, estimate=lambda q: float(np.linalg.norm(q - nodes[goal]))
    )
    return path, measured(nodes, path)


@wrong("shortest_path")
def straight_to_the_goal(nodes, edges, start, goal):
    """Leaves the roadmap."""
    return [start, goal], float(np.linalg.norm(nodes[start] - nodes[goal]))


@wrong("shortest_path")
def coordinates_of_the_path(nodes, edges, start, goal):
    """Returns coordinates instead of indices."""
    path, far = searched(nodes, edges, start, goal)
    return (None if path is None else nodes[path]), far


# Break it


@wrong("exposing_sight")
def a_square():
    """Gives a square, whose diagonal the program judges rightly."""
    return [[(0, 0), (4, 0), (4, 4), (0, 4)]]


@wrong("exposing_sight")
def three_in_a_line():
    """Exposes the program, but with eleven vertices."""
    return [
        [(0, 0), (2, 2), (0, 4), (-2, 2)],
        [(0, 10), (2, 12), (0, 14), (-2, 12)],
        [(0, 40), (1, 42), (-1, 42)],
    ]


@wrong("exposing_sight")
def a_square_and_a_triangle():
    """Exposes the program, but with seven vertices."""
    return [[(0, 0), (2, -2), (4, 0), (2, 2)], [(20, 0), (22, -1), (22, 1)]]


@wrong("exposing_sight")
def clockwise():
    """Gives the right polygon in clockwise order."""
    return [[(3, 2), (6, 0), (2, 0), (1, -1), (0, 0)]]


@wrong("exposing_sight")
def crossing_itself():
    """Gives a polygon that crosses itself."""
    return [[(0, 0), (4, 4), (4, 0), (0, 4), (-3, 2)]]


@wrong("exposing_sight")
def no_obstacles():
    """Gives no obstacles."""
    return []


@wrong("exposing_sight")
def halves():
    """Gives coordinates that are not whole numbers."""
    return [[(0, 0), (1, -1), (2, 0), (6.5, 0), (3, 2)]]


@wrong("exposing_sight")
def touching():
    """Gives two triangles that touch."""
    return [[(0, 0), (2, -2), (2, 2)], [(2, 0), (5, -2), (5, 2)]]


# Distances that are nearly equal, lengths that are large, free places that are rare

a_little_more_than_r = changed("radius_neighbours", ("<= r]", "<= r + 0.001]"))
rounded_distances = changed(
    "radius_neighbours",
    ("problem.distance(nodes[i], nodes[j])", "round(problem.distance(nodes[i], nodes[j]), 2)"),
)
ties_by_rounding = changed(
    "k_closest",
    ("problem.distance(nodes[i], nodes[j]))", "round(problem.distance(nodes[i], nodes[j]), 2))"),
)
first_of_its_own_order = changed(
    "k_closest",
    ("for j in range(len(nodes)) if j != i]", "for j in range(len(nodes))]"),
    ("others[:k]", "others[1 : k + 1]"),
)
shorter_than_a_million = changed("shortest_path", ("cost.get(v, math.inf)", "cost.get(v, 1e6)"))
ignores_little_gains = changed(
    "shortest_path", ("d < cost.get(v, math.inf)", "d < cost.get(v, math.inf) - 1e-4")
)
larger_estimates = changed(
    "shortest_path",
    ("c, u = heappop(heap)", "c, u = heappop(heap)\n        c = cost[u]"),
    ("heappush(heap, (d, v))", "heappush(heap, (d + 1.01 * math.dist(nodes[v], nodes[goal]), v))"),
)
found_again_by_no_other_way = changed(
    "shortest_path", ("d < cost.get(v, math.inf)", "v not in cost")
)
only_nodes_with_edges = changed(
    "shortest_path", ("while heap:", "while heap and start in np.asarray(edges):")
)
last_digit_of_the_seed = changed("sampled_roadmap", ("default_rng(rng)", "default_rng(rng % 10)"))
hundred_tries = changed(
    "sampled_roadmap",
    ("while len(nodes) < n + 2:", "for _ in range(10 * n):"),
    ("if problem.is_free(q):", "if problem.is_free(q) and len(nodes) < n + 2:"),
)


larger_of_two_equally_far = changed("component_k_closest", ("nodes[i]), j)", "nodes[i]), -j)"))
in_the_order_of_joining = changed(
    "component_k_closest",
    ("merged, rest = {i}, []", "merged, rest = [i], []"),
    ("merged |= component", "merged = merged[:-1] + component + [i]"),
    ("(problem.distance(nodes[j], nodes[i]), j))", "problem.distance(nodes[j], nodes[i]))"),
)
in_the_order_against_joining = changed(
    "component_k_closest",
    ("merged, rest = {i}, []", "merged, rest = [i], []"),
    ("merged |= component", "merged = component + merged"),
    ("(problem.distance(nodes[j], nodes[i]), j))", "problem.distance(nodes[j], nodes[i]))"),
)
rounds_distances = changed(
    "component_k_closest",
    (
        "(problem.distance(nodes[j], nodes[i]), j)",
        "(round(problem.distance(nodes[j], nodes[i]), 3), j)",
    ),
)
never_at_the_same_place = changed(
    "component_k_closest",
    (
        "if problem.is_free_path",
        "if problem.distance(nodes[j], nodes[i]) > 0 and problem.is_free_path",
    ),
)
components_not_merged = changed(
    "component_k_closest",
    ("merged, rest = {i}, []", "joined = False"),
    ("                rest.append(component)\n", "                continue\n"),
    ("merged |= component", "component.add(i)\n                joined = True"),
    ("components = [*rest, merged]", "components += [] if joined else [{i}]"),
)
first_obstacle_only = changed(
    "visibility_roadmap", ("for ring in obstacles:", "for ring in obstacles[:1]:")
)
one_list_for_all = changed("shortest_path", ("[[] for _ in nodes]", "[[]] * len(nodes)"))


# Variants

NEAR = "if problem.distance(nodes[i], nodes[j]) <= r]"
FREE_OF_NEAR = "[(i, j) for i, j in near if problem.is_free_path(nodes[i], nodes[j])]"
long_edges = varied("radius_neighbours", "long_edges", (NEAR, NEAR.replace("if", "if 0.75 * r <")))
far_from_start = varied(
    "radius_neighbours", "far_from_start", ("<= r]", "<= (2 * r if i == 0 else r)]")
)
long_edges_through_walls = changed(
    "radius_neighbours",
    (NEAR, NEAR.replace("if", "if 0.75 * r <")),
    (FREE_OF_NEAR, "near"),
    variant="long_edges",
    slip="blind",
)
all_far_from_each_other = changed(
    "radius_neighbours", ("<= r]", "<= 2 * r]"), variant="far_from_start"
)

NODES = "nodes = [problem.start, problem.goal]"
RETURNED = "pairs = combinations(range(len(nodes)), 2)"
ends_behind_the_corners = varied(
    "visibility_roadmap", "ends_last", (RETURNED, f"nodes = nodes[2:] + nodes[:2]\n    {RETURNED}")
)
goal_before_the_start = varied(
    "visibility_roadmap", "goal_first", (NODES, "nodes = [problem.goal, problem.start]")
)
goal_and_start_last = changed(
    "visibility_roadmap",
    (RETURNED, f"nodes = nodes[2:] + nodes[1::-1]\n    {RETURNED}"),
    variant="ends_last",
)
corners_before_the_ends_without_contact = changed(
    "visibility_roadmap",
    (NODES, "nodes = [problem.goal, problem.start]"),
    ("is_semi_free_path", "is_free_path"),
    variant="goal_first",
    slip="no_contact",
)
IN_ORDER, TIES, PAIR = "for i in range(len(nodes)):", "nodes[i]), j)", "edges.append((j, i))"
components_from_the_last = varied(
    "component_k_closest",
    "from_the_last",
    (IN_ORDER, "for i in reversed(range(len(nodes))):"),
    (TIES, "nodes[i]), -j)"),
    (PAIR, "edges.append((i, j))"),
)
pairs_larger_first = varied("component_k_closest", "larger_first", (PAIR, "edges.append((i, j))"))
ties_to_the_smaller_number = changed(
    "component_k_closest",
    (IN_ORDER, "for i in reversed(range(len(nodes))):"),
    (PAIR, "edges.append((i, j))"),
    variant="from_the_last",
)
larger_first_through_walls = changed(
    "component_k_closest",
    (PAIR, "edges.append((i, j))"),
    ("problem.is_free_path(nodes[j], nodes[i])", "True"),
    variant="larger_first",
    slip="blind",
)
PATH_AND_COST = "return path[::-1], c"
shortest_path_from_the_goal = varied(
    "shortest_path", "from_goal", (PATH_AND_COST, "return path, c")
)
length_of_the_detour = varied(
    "shortest_path",
    "detour",
    (PATH_AND_COST, PATH_AND_COST + " - math.dist(nodes[start], nodes[goal])"),
)
detour_as_a_factor = changed(
    "shortest_path",
    (PATH_AND_COST, PATH_AND_COST + " / max(math.dist(nodes[start], nodes[goal]), 1e-9)"),
    variant="detour",
)
fewest_edges_from_the_goal = changed(
    "shortest_path",
    (PATH_AND_COST, "return path, c"),
    ("d = c + math.dist(nodes[u], nodes[v])", "d = c + 1"),
    variant="from_goal",
    slip="counted",
)
