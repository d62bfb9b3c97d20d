"""The answers to the concept questions are true: the library computes them, and the wrong ones.

A test has the name of its question, and compares what was computed with the text of the choices.
"""

import math
import re
from itertools import pairwise

import numpy as np
import pytest
import shapely

import kinoedu as ke
from kinoedu.chances import wilson_interval
from kinoedu.course import find
from kinoedu.course.lessons.polygons_in_the_plane.exposing_obstacle import (
    chords_hit,
    swept_disk_hits,
)
from kinoedu.course.questions import lessons_with_questions, read_questions

QUESTIONS = {one.name: one for lesson in lessons_with_questions() for one in read_questions(lesson)}
# Definitions and rules of reasoning, of which nothing is to be computed.
ARGUED = {
    "nearer_than_the_hit",
    "why_convex",
    "a_wall_was_moved",
    "fixed_k",
    "the_next_random_point",
    "one_seed",
    "lengths_of_the_survivors",
    "heading_held",
    "two_intervals",
    "a_region_as_the_goal",
    "corners_made_round",
}
WALL = np.array([(0, 0), (6, 0), (6, 4), (4, 4), (4, 2), (2, 2), (2, 5), (0, 5)], float)
ROOM = [(0, 0), (10, 0), (10, 10), (0, 10)]


def texts(name):
    """The choices of a question by letter, and the letter of the right one first."""
    question = QUESTIONS[name]
    return question.right, {choice.letter: choice.text for choice in question.choices}


def line_up(name, **computed):
    """Compare numbers that were computed, by letter, with the first number of each choice.

    The right one must be among them.
    """
    right, choices = texts(name)
    assert right in computed
    for letter, value in computed.items():
        written = re.search(r"-?\d+(?:\.(\d+))?", choices[letter])
        half_unit = 0.5 * 10.0 ** -len(written[1] or "")
        assert abs(float(written[0]) - value) <= half_unit * 1.001, (name, letter, value)


def slip(exercise, key, *given):
    """What a program with a known misconception answers."""
    return next(one for one in find(exercise).slips if one.key == key).answer(*given)


def test_every_question_is_accounted_for():
    """Each is computed by the test of its name, or is named as one that is argued."""
    tested = {name.removeprefix("test_") for name in globals() if name.startswith("test_")}
    assert tested & set(QUESTIONS) == set(QUESTIONS) - ARGUED
    assert set(QUESTIONS) >= ARGUED


# 1 geometry


def test_segment_or_line():
    """The distances to the segment, to the line and to the end."""
    q, p1, p2 = np.array([(8, 5), (1, 1), (5, 1)], float)
    line_up(
        "segment_or_line",
        a=ke.geometry.point_line_distance(q, p1, p2),
        b=math.dist(q, p1),
        c=ke.geometry.point_segment_distance(q, p1, p2),
        d=np.abs(q - p2).sum(),
    )


def test_sign_of_the_distance():
    """The same line with either normal: negative is on the side to which it does not point."""
    for p1, p2 in (((0, 0), (1, 0)), ((1, 0), (0, 0))):
        a, b, c = ke.geometry.line_through_points(p1, p2)
        q = np.array([7.0, 0.0]) - 2 * np.array([a, b])
        assert a * q[0] + b * q[1] + c == -2
        assert ke.geometry.point_line_distance(q, p1, p2) == 2


def test_which_edges():
    """Each wrong rule is wrong somewhere; the right one nowhere."""
    rng = np.random.default_rng(0)
    points = [q for q in rng.uniform(-3, 9, (500, 2)) if not ke.geometry.point_in_polygon(q, WALL)]
    edges = [(WALL[i - 1], WALL[i]) for i in range(len(WALL))]
    vertex = {tuple(p): [e for e in edges if tuple(p) in map(tuple, e)] for p in WALL}
    segment, line = ke.geometry.point_segment_distance, ke.geometry.point_line_distance
    rules = {
        "a": lambda q: min(math.dist(q, p) for p in WALL),
        "b": lambda q: min(line(q, *edge) for edge in edges),
        "c": lambda q: min(
            segment(q, *e) for e in vertex[min(vertex, key=lambda p: math.dist(p, q))]
        ),
        "d": lambda q: min(segment(q, *edge) for edge in edges),
    }
    truth = [ke.geometry.point_polygon_distance(q, WALL) for q in points]
    right = {a for a, rule in rules.items() if np.allclose([rule(q) for q in points], truth)}
    assert right == {texts("which_edges")[0]}


def test_first_step_at_a_corner():
    """The tangent, and the three wrong ones."""
    box, q = np.array([(0, 0), (4, 0), (4, 2), (0, 2)], float), np.array([5.0, 3.0])
    right, choices = texts("first_step_at_a_corner")
    x, y = np.array([int(n) for n in re.findall(r"-?\d+", choices[right])[:2]]) / math.sqrt(2)
    assert np.allclose(ke.geometry.polygon_tangent(q, box), (x, y))
    assert np.allclose(slip("polygon_tangent", "clockwise", q, box), (-x, -y))
    assert np.allclose(
        slip("polygon_tangent", "towards", q, box), np.array([-1, -1]) / math.sqrt(2)
    )


def test_safe_to_move():
    """No motion of 1.5 comes nearer than 0.5; most end farther away."""
    rng = np.random.default_rng(0)
    q = rng.uniform(-4, 10, (2000, 2))
    q = q[np.abs(ke.geometry.point_polygon_distance(q, WALL) - 2) < 1e-1]
    before = ke.geometry.point_polygon_distance(q, WALL)
    turns = rng.uniform(0, 2 * np.pi, len(q))
    moved = q + 1.5 * np.column_stack([np.cos(turns), np.sin(turns)])
    change = ke.geometry.point_polygon_distance(moved, WALL) - before
    assert change.min() >= -1.5 - 1e-9
    assert len(q) > 50
    assert (change > -1).mean() > 0.5


# 2 bug algorithms


POCKET = [(0, 0), (6, 0), (6, 6), (0, 6), (0, 4), (1, 4), (1, 5), (5, 5), (5, 1), (1, 1), (1, 2)]
POCKET = [np.array([*POCKET, (0, 2)], float)]
BOX = [np.array([(3, -2), (6, -2), (6, 2), (3, 2)], float)]


def test_why_bug0_fails():
    """With either turn it repeats a hit; the other bugs arrive with the same sensor."""
    for turn in ("left", "right"):
        for step in (1.0, 0.01):
            assert (
                "same wall at the same point"
                in ke.bug0((3, 3), (9, 3.1), POCKET, step, turn=turn).reason
            )
        for bug in (ke.bug1, ke.bug2):
            assert bug((3, 3), (9, 3.1), POCKET, 1.0, turn=turn).path is not None


def test_bug1_along_one_wall():
    """The bound holds for many starts, and some walks come close to it."""
    p, most = 14.0, 0.0
    for y in np.linspace(-1.9, 1.9, 39):
        start, goal = np.array([-1, y]), np.array([11, -y / 2])
        walk = ke.bug1(start, goal, BOX, 1.0)
        hit = start + (goal - start) * (4 / 12)
        leave = np.array([6, goal[1]])  # of the box, the point nearest to the goal
        along = walk.cost - math.dist(start, hit) - math.dist(leave, goal)
        assert p <= along <= 1.5 * p + 1e-6
        most = max(most, along)
    assert most > 1.4 * p
    line_up("bug1_along_one_wall", c=1.5, d=2)


# The walls of a maze on a square of 4 x 4 places, from place to place: columns and rows.
MAZE = (
    "0010 0001 0111 0212 0203 0313 1020 1112 1222 1323 2030 2131 2333 3132 3233",
    (6.4, -0.1),
    (2.8, 5.9),
)


def build_maze(walls):
    """The outline of walls that are 0.6 thick, on places that are 2 apart."""
    bars = [
        shapely.box(2 * int(x0), 2 * int(y0), 2 * int(x1) + 0.6, 2 * int(y1) + 0.6)
        for x0, y0, x1, y1 in walls.split()
    ]
    return np.array(shapely.union_all(bars).exterior.coords)[:-1]


def test_which_bug_is_shorter():
    """Round a box Bug 2, in a maze Bug 1."""
    assert ke.bug2((0, 0), (9, 0.1), BOX, 1.0).cost < ke.bug1((0, 0), (9, 0.1), BOX, 1.0).cost
    walls, start, goal = MAZE
    one, two = (bug(start, goal, [build_maze(walls)], 1.0) for bug in (ke.bug1, ke.bug2))
    assert one.path is not None
    assert two.path is not None
    assert one.cost < two.cost


def test_blocked_at_the_best_point():
    """Bug 1 says that the goal cannot be reached where a wall encloses goal or robot."""
    ring = shapely.Polygon(POCKET[0]).union(shapely.box(0, 1, 1, 5))  # the pocket, closed
    inside, outside = (3, 3), (9, 3.1)
    walls = [np.array(ring.exterior.coords)[:-1]]
    assert ke.bug1(outside, (3, 3), walls, 1.0).path is None
    assert not ring.contains(shapely.Point(inside))


# 3 decomposition


TRIANGLES = [[(3, 2), (6, 2.5), (4, 3.5)], [(2.5, 7), (5.5, 7.5), (4.5, 9)]]


def test_where_a_wall_ends():
    """The walls of the lower triangle end below the upper one, or at the ceiling beside it."""
    cells = ke.trapezoidation(
        ke.PolygonWorld([(0, 0), (10, 0.5), (9.5, 10), (0.5, 9.5)], TRIANGLES)
    )
    walls = [(low, high) for low, high in cells.walls if low[0] == 4 and low[1] >= 3.5]
    assert len(walls) == 1
    triangle = shapely.Polygon(TRIANGLES[1])
    assert triangle.distance(shapely.Point(walls[0][1])) < 1e-9
    right_end = [high for low, high in cells.walls if low[0] == 6 and high[1] > 2.5]
    assert right_end[0][1] > 9  # beyond the upper triangle: the ceiling


def test_touching_in_a_point():
    """Two cells that touch in a corner of two boxes are not joined."""
    boxes = [[(2, 2), (5, 2), (5, 6), (2, 6)], [(5, 0.5), (8, 0.5), (8, 2), (5, 2)]]
    cells = ke.trapezoidation(ke.PolygonWorld(ROOM, boxes))
    (left,) = (i for i, t in enumerate(cells.trapezoids) if t[1] == 5 and t[5] == 2)
    (right,) = (i for i, t in enumerate(cells.trapezoids) if t[0] == 5 and t[2] == 2)
    assert [left, right] not in cells.adjacency.tolist()
    assert left in cells.adjacency
    assert right in cells.adjacency


def test_no_path_found():
    """Decomposition finds a gap that 300 samples miss, and knows when there is none."""
    for gap, is_open in ((1e-3, True), (0.0, False)):
        wall = [
            [(4, 0.5), (6, 0.5), (6, 5), (4, 5)],
            [(4, 5 + gap), (6, 5 + gap), (6, 9.5), (4, 9.5)],
        ]
        walls = [
            *wall,
            [(4, 0), (6, 0), (6, 0.5), (4, 0.5)],
            [(4, 9.5), (6, 9.5), (6, 10), (4, 10)],
        ]
        problem = ke.Problem(ke.Point(), ke.PolygonWorld(ROOM, walls), (1, 5), (9, 5))
        assert (ke.plan_by_decomposition(problem).path is not None) == is_open
        assert ke.prm(problem, n=300, rng=0).path is None


def test_which_path():
    """It is free without contact, and longer than the shortest."""
    world = ke.PolygonWorld(ROOM, TRIANGLES)
    problem = ke.Problem(ke.Point(), world, (1, 2.6), (9, 2.4))
    plan = ke.plan_by_decomposition(problem)
    assert all(problem.is_free_path(a, b) for a, b in pairwise(plan.path))
    assert plan.cost > 1.05 * ke.plan_by_visibility(problem).cost


# 4 graph search


def test_fewest_edges():
    """Breadth first takes the direct road, Dijkstra the shorter one."""
    graph = ke.Graph(3, [(0, 1), (1, 2), (0, 2)], [1, 1, 5])
    right, choices = texts("fewest_edges")
    assert choices[right] == ", ".join(map(str, ke.bfs_path(graph, 0, 2)))
    assert choices["b"] == ", ".join(map(str, ke.astar(graph, 0, 2)[0]))


def test_when_is_a_cost_final():
    """A goal that is seen first with cost 9, and costs 3."""
    graph = ke.Graph(4, [(0, 3), (0, 1), (1, 2), (2, 3)], [9, 1, 1, 1])
    assert ke.dijkstra(graph, 0).cost[3] == 3


def test_estimate_too_large():
    """On random graphs the factor is at most 2, sometimes more than 1, and a path is found."""
    rng, ratios = np.random.default_rng(0), []
    for _ in range(400):
        n = 8
        edges = [(i, j) for i in range(n) for j in range(i) if rng.random() < 0.5 or j == i - 1]
        graph = ke.Graph(n, edges, rng.integers(1, 10, len(edges)))
        rest = ke.dijkstra(graph, n - 1).cost
        path, search = ke.astar(graph, 0, n - 1, rest * rng.uniform(0, 2, n))
        assert path is not None
        ratios.append(search.cost[n - 1] / rest[0])
    assert 1.05 < max(ratios) <= 2


def search_marking_late(neighbours, start):
    """A breadth-first search with the mistake of the question."""
    parent, seen, queue = {start: -1}, set(), [start]
    while queue:
        v = queue.pop(0)
        if v in seen:
            continue
        seen.add(v)
        for u in neighbours[v]:
            if u not in seen:
                parent[u] = v
                queue.append(u)
    return parent


def test_marked_too_late():
    """It ends, reaches every node, and has paths with too many edges."""
    rng, longer = np.random.default_rng(0), 0
    for _ in range(200):
        n = 7
        edges = [(i, j) for i in range(n) for j in range(i) if rng.random() < 0.4 or j == i - 1]
        graph = ke.Graph(n, edges)
        near = [sorted({a + b - v for a, b in edges if v in (a, b)}) for v in range(n)]
        parent = search_marking_late(near, 0)
        assert set(parent) == set(range(n))
        path = [n - 1]
        while parent[path[-1]] >= 0:
            path.append(parent[path[-1]])
        longer += len(path) > len(ke.bfs_path(graph, 0, n - 1))
    assert longer > 0


def test_a_long_depth_first_path():
    """In a ring of 41 nodes a path of 40 edges leads to a neighbour."""
    ring = [(i, i + 1) for i in range(40)] + [(0, 40)]
    path = ke.dfs_path(ke.Graph(41, ring), 0, 40)
    assert len(path) - 1 in (1, 40)
    assert len(ke.bfs_path(ke.Graph(41, ring), 0, 40)) - 1 == 1
    longest = ke.dfs_path(ke.Graph(41, ring), 0, 40 if len(path) == 41 else 1)
    assert len(longest) - 1 == 40


# 5 configuration spaces


def test_ring_of_bars():
    """The count, and what two misconceptions give."""
    given = 3, [[0, 1], [1, 2], [2, 3], [3, 0]]
    reference = find("degrees_of_freedom").reference
    line_up(
        "ring_of_bars",
        a=reference(*given),
        b=reference(3, given[1][:3]),
        c=slip("degrees_of_freedom", "pins", *given),
        d=slip("degrees_of_freedom", "one", *given),
    )


def test_turn_then_move():
    """The displacement, and the mistakes."""
    right, choices = texts("turn_then_move")
    answers = {
        right: find("displacement").right_answer(3.0, 0.0, np.pi / 2),
        "a": slip("displacement", "move_first", 3.0, 0.0, np.pi / 2),
        "c": slip("displacement", "clockwise", 3.0, 0.0, np.pi / 2),
        "d": slip("displacement", "no_turn", 3.0, 0.0, np.pi / 2),
    }
    for letter, matrix in answers.items():
        x, y, _ = np.round(matrix @ np.array([1, 0, 1]), 9) + 0.0
        assert choices[letter] == f"({x:.0f}, {y:.0f})"


def test_short_way_round():
    """The circle distance in degrees, and two misconceptions."""
    a, b = np.radians([170, -150])
    line_up(
        "short_way_round",
        a=np.degrees(slip("circle_distance", "no_wrap", a, b)),
        c=np.degrees(slip("circle_distance", "half_turns", a, b)),
        d=np.degrees(ke.circle_distance(a, b)),
    )


def test_angle_of_link_two():
    """The tip, and three wrong ones."""
    right, choices = texts("angle_of_link_two")
    q = np.array([np.pi / 2, -np.pi / 2])
    tip = ke.TwoLinkArm(2, 1, 0.2).joints(q)[1]
    answers = {right: tip, "d": tip[::-1]}
    for letter, key in (("a", "absolute"), ("b", "difference")):
        answers[letter] = slip("forward_kinematics", key, 2.0, 1.0, q)[1]
    for letter, point in answers.items():
        x, y = np.round(point, 9) + 0.0
        assert choices[letter] == f"({x:.0f}, {y:.0f})"


def test_hole_in_the_reach():
    """One of the points has no configuration; two have one, and one has two."""
    right, choices = texts("hole_in_the_reach")
    arm = ke.TwoLinkArm(3, 1, 0.2)
    points = {a: [float(n) for n in re.findall(r"-?\d+(?:\.\d+)?", t)] for a, t in choices.items()}
    assert {a: len(arm.inverse(p)) for a, p in points.items()} == {"a": 0, "b": 1, "c": 2, "d": 1}
    assert right == "a"


# 6 sampling


def test_half_the_hole():
    """The dispersion of small Sukharev grids halves with 2^d times as many points."""
    for d in (1, 2, 3):
        few, many = ke.sukharev_grid(2**d, d), ke.sukharev_grid(4**d, d)
        if d == 2:
            assert math.isclose(ke.dispersion(few, np.inf), 2 * ke.dispersion(many, np.inf))
        assert len(many) == 2**d * len(few)
    line_up("half_the_hole", a=2**1, b=2**2, c=2 * 6, d=2**6)


def test_corners_or_centres():
    """In the sup norm, one hole is twice the other."""
    corner, centre = (ke.dispersion(g(25), np.inf) for g in (ke.corner_grid, ke.sukharev_grid))
    assert math.isclose(corner, 2 * centre)
    assert texts("corners_or_centres")[0] == "b"


def test_a_corridor_and_a_grid():
    """0 or 20 points, wherever the corridor lies."""
    y = ke.sukharev_grid(400)[:, 1]
    counts = {int(((low < y) & (y < low + 0.04)).sum()) for low in np.linspace(0, 0.96, 997)}
    assert counts == {0, 20}
    assert texts("a_corridor_and_a_grid")[1]["c"].startswith("0 or 20")
    assert 0.04 < 2 * ke.dispersion(ke.sukharev_grid(400), np.inf)


def test_one_more_point():
    """A finer grid keeps no or few points; the first Halton and random points stay."""
    coarse, fine = ke.sukharev_grid(100), ke.sukharev_grid(121)
    kept = sum(np.isclose(fine, p).all(axis=1).any() for p in coarse)
    assert kept <= 2
    assert np.array_equal(ke.halton(100), ke.halton(121)[:100])
    assert np.array_equal(ke.uniform_random(100, rng=0), ke.uniform_random(121, rng=0)[:100])


# 7 collision detection


def test_free_at_all_samples():
    """A motion that cuts off a corner by 0.03: tests every 0.1 may all be free."""
    world = ke.PolygonWorld(ROOM, [[(4, 4), (4.5, 4), (4.5, 4.5), (4, 4.5)]])
    way = np.array([1, -1]) / math.sqrt(2)
    missed = 0
    for start in (3.5, 4.52) + way * np.linspace(0, 0.1, 41)[:, None]:
        motion = ke.Problem(ke.Point(), world, start, start + 1.3 * way)
        tested = [start + t * way for t in np.linspace(0, 1.3, 14)]
        assert not motion.is_free_path(start, start + 1.3 * way)
        missed += all(map(motion.is_free, tested))
    assert 0 < missed < 41


def test_corners_become_round():
    """The area of the grown square, by another library; and the wrong areas."""
    grown = shapely.box(0, 0, 2, 2).buffer(1, quad_segs=512)
    line_up("corners_become_round", a=4.0**2, b=grown.area, c=4 + math.pi, d=3.0**2)


def test_mirrored_robot():
    """The Minkowski difference, and three wrong triangles."""
    robot, point = np.array([(0, 0), (2, 0), (0, 1)], float), np.array([5.0, 5.0])
    right, choices = texts("mirrored_robot")
    answers = {right: point - robot, "b": point + robot, "d": robot - point}
    for letter, corners in answers.items():
        named = re.findall(r"\((-?\d+), (-?\d+)\)", choices[letter])
        assert {tuple(map(int, pair)) for pair in named} == {tuple(p) for p in corners.tolist()}
    tiny = point + 1e-9 * np.array([(0, 0), (1, 0), (0, 1)])
    assert np.allclose(
        sorted(ke.geometry.minkowski_difference(tiny, robot).round(6).tolist())[0], (3, 5)
    )


def test_vertices_are_not_enough():
    """The program is right for polygons inside each other and for touching ones, not for bars."""
    square = np.array([(0, 0), (4, 0), (4, 4), (0, 4)], float)
    flat = np.array([(-5, 1), (5, 1), (5, 2), (-5, 2)], float)
    pairs = {
        "a": (square, square / 4 + 1),
        "b": (square, square + 4),
        "c": (flat, flat[:, ::-1][::-1]),
    }
    wrong = set()
    for letter, (one, other) in pairs.items():
        by_vertices = any(
            ke.geometry.point_in_convex_polygon(p, polygon)
            for points, polygon in ((one, other), (other, one))
            for p in points
        )
        assert ke.geometry.convex_polygons_intersect(one, other)
        wrong |= set() if by_vertices else {letter}
    assert wrong == {texts("vertices_are_not_enough")[0]}


def test_how_far_is_safe():
    """Distance over speed; and the two wrong computations."""
    line_up("how_far_is_safe", a=0.5 * 2, b=0.5 / 2, c=0.5)


# 8 roadmaps


def test_corners_that_count():
    """The nodes of the visibility roadmap, the vertices, the hull, and the reflex ones."""
    world = ke.PolygonWorld([(-9, -9), (9, -9), (9, 9), (-9, 9)], [WALL])
    nodes = ke.visibility_roadmap(world).nodes
    inside = [node for node in nodes if np.abs(node).max() < 8]
    line_up(
        "corners_that_count",
        a=len(WALL),
        b=len(inside),
        c=len(ke.geometry.convex_hull(WALL)),
        d=len(WALL) - len(inside),
    )


def test_how_many_edges():
    """At least 2, sometimes more than 2; at least 4 is not so."""
    problem = ke.Problem(ke.Point(), ke.PolygonWorld(ROOM, []), (1, 1), (9, 9))
    roadmap = ke.build_roadmap(problem, n=60, neighbours=ke.KClosest(2), rng=0)
    degree = np.bincount(roadmap.edges.ravel(), minlength=len(roadmap.nodes))
    assert degree.min() == 2
    assert degree.max() > 2


def test_a_finer_grid():
    """A door that a grid of spacing 1 passes and one of 0.8 misses; below 0.6 none misses it."""
    found = {}
    for low in np.linspace(3, 6, 31):
        walls = [[(4, 0), (6, 0), (6, low), (4, low)]]
        walls += [[(4, low + 0.6), (6, low + 0.6), (6, 10), (4, 10)]]
        problem = ke.Problem(ke.Point(), ke.PolygonWorld(ROOM, walls), (1, 5), (9, 5))
        for spacing in (1.0, 0.8, 0.55):
            reached = ke.plan_on_grid(problem, spacing=spacing).path is not None
            found.setdefault(spacing, []).append(reached)
    assert any(one and not two for one, two in zip(found[1.0], found[0.8]))
    assert all(found[0.55])


# 9 trees


def thin_wall(closed=True):
    """A room cut in two by a wall that is 0.1 thick; or one with a door at its end."""
    top = 10 if closed else 8
    return ke.PolygonWorld(ROOM, [[(5, 0), (5.1, 0), (5.1, top), (5, top)]])


def test_what_must_be_checked():
    """A tree that checks ends only passes a closed wall; the library's never does."""
    problem = ke.Problem(ke.Point(), thin_wall(), (1, 5), (9, 5))
    rng, tree = np.random.default_rng(0), [np.array([1.0, 5.0])]
    for _ in range(1500):
        target = problem.sample(rng)
        near = min(tree, key=lambda node: math.dist(node, target))
        new = problem.steer(near, target, 0.5)
        if problem.is_free(new):
            tree.append(new)
    assert max(node[0] for node in tree) > 5.1
    plan = ke.rrt(problem, step_size=0.5, max_nodes=800, max_iterations=1500, rng=0)
    assert plan.path is None
    assert plan.tree.nodes[:, 0].max() < 5


def test_which_node_grows():
    """The share of samples to which a node is the nearest is that of its region."""
    problem = ke.Problem(ke.Point(), ke.PolygonWorld(ROOM, []), (5, 5), (9.5, 9.5))
    nodes = ke.rrt(problem, goal_bias=0.0, step_size=0.4, max_nodes=100, rng=1).tree.nodes
    counts = []
    for seed in (0, 1):
        points = np.random.default_rng(seed).uniform(0, 10, (4000, 2))
        nearest = ((points[:, None] - nodes) ** 2).sum(axis=2).argmin(axis=1)
        counts.append(np.bincount(nearest, minlength=len(nodes)) / 4000)
    assert counts[0].max() > 3 / len(nodes)  # not all alike
    assert np.argmax(counts[0]) == np.argmax(counts[1])
    assert np.argmax(counts[0]) != len(nodes) - 1  # the newest


def test_always_towards_the_goal():
    """With bias 1 the tree ends at the wall; with 0.05 it goes round."""
    problem = ke.Problem(ke.Point(), thin_wall(closed=False), (1, 2), (9, 2))
    stuck = ke.rrt(problem, goal_bias=1.0, step_size=0.5, max_iterations=2000, rng=0)
    assert stuck.path is None
    assert np.ptp(stuck.tree.nodes[:, 1]) == 0
    assert ke.rrt(problem, goal_bias=0.05, step_size=0.5, rng=0).path is not None


def test_let_it_run_on():
    """The first nodes of a larger tree have the parents that they had."""
    problem = ke.Problem(ke.Point(), thin_wall(), (1, 5), (9, 5))
    few, many = (ke.rrt(problem, max_nodes=n, max_iterations=4 * n, rng=0).tree for n in (100, 400))
    n = min(len(few.nodes), 100) - 1
    assert np.array_equal(few.parent[:n], many.parent[:n])
    assert len(many.nodes) > len(few.nodes)


def test_cheaper_below():
    """The costs along the parents, before and after."""
    steps = {"u": 10, "w": 12 - 10, "x": 15 - 12}
    after = np.cumsum([7, steps["w"], steps["x"]])
    assert texts("cheaper_below")[1][texts("cheaper_below")[0]] == f"{after[1]} and {after[2]}"


# 10 terrains


def test_runs_that_fail():
    """Median and share, and two wrong reports."""
    lengths = [10, 11, 12, 100]
    line_up(
        "runs_that_fail",
        a=np.mean(lengths),
        b=np.median(lengths),
        c=np.median([*lengths, 0]),
        d=np.median(lengths),
    )


def test_cost_of_a_motion():
    """The integral of the cost, and three wrong sums."""
    cost = np.array([[1, 1, 1, 5]], float)
    world = ke.Terrain(np.ones((1, 4)), cost=cost)
    a, b = np.array([1e-9, 0.5]), np.array([4 - 1e-9, 0.5])
    problem = ke.Problem(ke.Point(), world, a, b)
    line_up("cost_of_a_motion", a=(1 + 5) / 2 * 4, b=1 + 5, c=4, d=problem.motion_cost(a, b))


def test_finer_cells():
    """In a direction where the path is 8 % longer, finer cells change nothing."""
    ratios = []
    for scale in (1, 10):
        ground = ke.Terrain(np.ones((6 * scale, 14 * scale)), resolution=1 / scale)
        start = np.array([0.5, 0.5]) / scale
        goal = start + np.array([12, 5])
        plan = ke.plan_on_grid(ke.Problem(ke.Point(), ground, start, goal))
        ratios.append(plan.cost / 13)
    assert math.isclose(*ratios)
    line_up("finer_cells", a=100 * (ratios[1] - 1))


# 11 polygons in the plane


STICK = ke.RigidPolygon([(-1.2, -0.3), (1.2, -0.3), (1.2, 0.3), (-1.2, 0.3)])


def test_both_ends_free():
    """A stick that stands across the gate between two free ends; and one that passes."""
    gate = [
        [(4.9, 0), (5.1, 0), (5.1, 4.4), (4.9, 4.4)],
        [(4.9, 5.6), (5.1, 5.6), (5.1, 10), (4.9, 10)],
    ]
    world = ke.PolygonWorld(ROOM, gate)
    for middle, passes in ((np.pi / 2, False), (0.0, True)):
        a, b = (2, 5, middle - 0.2), (8, 5, middle + 0.2)
        problem = ke.Problem(STICK, world, a, b)
        assert problem.is_free(np.array(a))
        assert problem.is_free(np.array(b))
        assert problem.is_free_path(np.array(a), np.array(b)) == passes


def test_eight_headings():
    """In a slanted gap all eight headings touch, and others are free."""
    wedges = [[(2, 0.4), (7.4, 2.9), (7.4, 0.4)], [(1.6, 1.6), (7, 4.1), (1.6, 5.4)]]
    world = ke.PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], wedges)
    place = (4.5, 2.25)
    tried = [(*place, np.radians(angle)) for angle in range(0, 360, 45)]
    assert not ke.collision.free_configurations(STICK, world, tried).any()
    assert len(ke.collision.free_headings(STICK, world, place)) > 0


def test_fewest_edges_or_shortest():
    """A roadmap on which the bound is attained."""
    graph = ke.Graph(
        5 + 3, [(0, 1), (1, 2), (2, 3), (3, 4), (0, 5), (5, 6), (6, 7), (7, 4)], [3] * 4 + [1] * 4
    )
    assert len(ke.bfs_path(graph, 0, 4)) - 1 == 4
    assert ke.dijkstra(graph, 0).cost[4] == 4
    line_up("fewest_edges_or_shortest", a=12, b=12 / 3 * 1, d=9)


def test_between_the_chords():
    """A convex stone that no chord meets and the disc hits."""
    stone = np.array([(3, 2.15), (5.5, 2.25), (4.4, 2.85)])
    a, b = np.array([1.5, 2]), np.array([7.5, 2])
    assert not chords_hit(a, b, stone)
    assert swept_disk_hits(a, b, stone)
    assert len(ke.geometry.convex_hull(stone)) == 3


# 12 the car


CAR = ke.Car(4, 2, 3)


def test_reversing_with_wheels_left():
    """The heading turns clockwise, at a constant rate."""
    turned = [CAR.move((0, 0, 0), -1, 0.5, t)[2] for t in (1, 2)]
    assert turned[0] < 0
    assert math.isclose(turned[1], 2 * turned[0])


def test_where_the_front_goes():
    """The distance of the front axle from the centre, all round."""
    phi = math.atan(3 / 4)
    for t in (0.0, 1.0, 5.0):
        x, y, theta = CAR.move((4, 0, np.pi / 2), 1, phi, t)
        assert math.isclose(math.hypot(x, y), 4)
        front = x + 3 * math.cos(theta), y + 3 * math.sin(theta)
        line_up("where_the_front_goes", d=math.hypot(*front), a=math.hypot(x, y))


def test_shorter_steps():
    """The error of Euler's rule, in proportion to that with 100 steps."""
    euler = find("euler").right_answer
    phi = math.atan(3 / 20)
    t = np.pi * 20
    end = CAR.move((0, 0, 0), 1, phi, t)
    errors = {
        n: math.dist(np.asarray(euler(np.zeros(3), 1.0, phi, t, 3.0, n))[-1][:2], end[:2])
        for n in (100, 200, 400)
    }
    line_up(
        "shorter_steps",
        a=0.4 * errors[400] / errors[100],
        b=0.4,
        c=0.4 / 4**2,
        d=0.4 * errors[200] / errors[100],
    )


def test_there_and_back():
    """Dubins' lengths differ in both directions, either way; Reeds and Shepp's do not."""
    rng = np.random.default_rng(0)
    differences = []
    for _ in range(50):
        a, b = (np.array([*rng.uniform(0, 30, 2), rng.uniform(-3, 3)]) for _ in range(2))
        there, back = ke.dubins_path(a, b, 5).length, ke.dubins_path(b, a, 5).length
        differences.append(there - back)
        both = ke.reeds_shepp_path(a, b, 5).length, ke.reeds_shepp_path(b, a, 5).length
        assert math.isclose(*both, rel_tol=1e-6)
    assert min(differences) < -1
    assert max(differences) > 1


def test_sideways_moves():
    """Half the angle, a quarter of the way; and 2 r α²."""
    aside = []
    for angle in (0.02, 0.01):
        pose = (0.0, 0.0, 0.0)
        for v, side in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
            pose = CAR.move(pose, v, side * math.atan(3 / 20), 20 * angle)
        assert abs(pose[2]) < 1e-9
        assert abs(pose[0]) < 1e-9
        aside.append(pose[1])
    assert math.isclose(aside[0] / aside[1], 4, rel_tol=1e-3)
    assert math.isclose(aside[0], 2 * 20 * 0.02**2, rel_tol=1e-3)


# 13 planning by driving


def test_same_heading():
    """The short way round is within the tolerance, the difference of the numbers is not."""
    assert ke.circle_distance(3.10, -3.10) < 0.25 < abs(-3.10 - 3.10)
    assert round(float(ke.circle_distance(3.10, -3.10)), 3) == 0.083


def test_back_again():
    """Of the controls only the one with the same wheels and the opposite speed leads back."""
    u = np.array([1.0, 2.0, 0.5])
    v = CAR.move(u, 1, 0.6, 30)
    right, choices = texts("back_again")
    leads_back = {
        letter: np.allclose(CAR.move(v, speed, phi, 30), u)
        for letter, speed, phi in (("a", 1, 0.6), ("b", -1, -0.6), ("d", -1, 0.6))
    }
    assert leads_back == {"a": False, "b": False, "d": True}
    assert (right, "(-1, 0.6)" in choices["d"]) == ("d", True)


def test_thirty_seeds():
    """Each share is in the other's interval; two coins differ by as much one time in three."""
    low, high = wilson_interval([17, 13], 30)
    assert low[0] < 13 / 30 < high[0]
    assert low[1] < 17 / 30 < high[1]
    assert np.round(100 * np.array([low, high])).T.tolist() == [[39, 73], [27, 61]]
    heads = np.array([math.comb(30, k) for k in range(31)]) / 2**30
    far = sum(heads[a] * heads[b] for a in range(31) for b in range(31) if abs(a - b) >= 4)
    assert far > 1 / 3


# 14 moving and uncertain obstacles


def test_when_do_they_touch():
    """First contact, nearest moment, last contact."""
    given = *np.array([(0, 0), (4, 0), (2, -2), (2, 2)], float), 1.0
    line_up(
        "when_do_they_touch",
        c=find("first_contact").right_answer(*given),
        a=slip("first_contact", "nearest", *given),
        b=slip("first_contact", "leaving", *given),
    )


def test_shares_of_a_chance():
    """The sum is attained by hits that exclude each other, and exceeds that of independent ones."""
    line_up("shares_of_a_chance", a=0.02, b=5 * 0.02, c=1 - 0.98**5)


def test_ten_times_safer():
    """The ratio of two margins, and that without the root."""
    margin = find("chance_margins").right_answer
    ratio = float(margin(np.array([1.0]), 0.01)[0] / margin(np.array([1.0]), 0.1)[0])
    line_up("ten_times_safer", a=ratio, b=10, c=ratio**2, d=math.sqrt(10))


def test_no_hit_in_a_hundred():
    """Wilson's interval contains 0.03, and the chances that the reasons name."""
    high = float(wilson_interval([0], 100)[1][0])
    assert 0.03 < high < 0.04
    line_up("no_hit_in_a_hundred", c=0.03)
    assert 0.99**100 > 1 / 3
    assert round(0.98**100, 2) == 0.13
    assert 4.5e9 < 1 / 0.8**100 < 5.5e9


@pytest.mark.parametrize("name", sorted(ARGUED))
def test_what_is_argued_has_four_reasons(name):
    """A question whose answer is not computed says why for each choice, in a sentence."""
    assert all(
        choice.why.endswith((".", "?")) and " " in choice.why for choice in QUESTIONS[name].choices
    )
