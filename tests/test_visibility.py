"""Visibility roadmaps against brute force, and shortest paths against networkx."""

from itertools import combinations, pairwise

import networkx
import numpy as np
import pytest
import shapely

import kinoedu as ke
from kinoedu.errors import (
    InvalidParameter,
    InvalidPolygon,
    InvalidStart,
    InvalidWorld,
    KinoeduError,
)
from kinoedu.geometry.rings import as_ring
from kinoedu.planners.exact.corners import corners_of
from kinoedu.planners.exact.visibility import pairs_in_sight

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
NOTCHED = [(0, 0), (10, 0), (10, 10), (6, 10), (5, 5), (4, 10), (0, 10)]
ROOM = ([(3, 3), (7, 3), (7, 7), (3, 7)], [[(4, 4), (6, 4), (6, 6), (4, 6)]])


def box(x, y, width=2, height=2):
    """A box by its lower left corner."""
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


WORLDS = {
    "nothing": ke.PolygonWorld(SQUARE),
    "a room": ke.PolygonWorld(SQUARE, [ROOM]),
    "a reflex boundary": ke.PolygonWorld(NOTCHED),
    "a common corner": ke.PolygonWorld(SQUARE, [box(2, 2), box(4, 4)]),
    "a common edge": ke.PolygonWorld(SQUARE, [box(2, 2), box(4, 2)]),
    "a common part of an edge": ke.PolygonWorld(SQUARE, [box(2, 2), box(4, 3)]),
    "a corner on an edge": ke.PolygonWorld(SQUARE, [box(2, 2), [(4, 3), (6, 2), (6, 4)]]),
    "a corner on the boundary": ke.PolygonWorld(SQUARE, [[(0, 5), (2, 4), (2, 6)]]),
    "beyond the boundary": ke.PolygonWorld(SQUARE, [box(-1, 4, 8, 2)]),
    "overlapping": ke.PolygonWorld(SQUARE, [box(2, 2, 4, 2), box(3, 1, 2, 4)]),
    "one in another": ke.PolygonWorld(SQUARE, [box(2, 2, 4, 4), box(3, 3)]),
    "twice the same": ke.PolygonWorld(SQUARE, [box(2, 2), box(2, 2)]),
    "four round a corner": ke.PolygonWorld(SQUARE, [box(3, 3), box(5, 3), box(3, 5), box(5, 5)]),
    "corners in a row": ke.PolygonWorld(
        SQUARE, [box(1, 1, 1, 1), box(3, 1, 1, 1), box(5, 1, 1, 1), box(3, 4, 1, 1)]
    ),
}


def random_world(seed):
    """A few obstacles with mostly integer coordinates, which often touch; and the generator."""
    rng = np.random.default_rng(seed)
    lattice, obstacles = rng.random() < 0.8, []
    for _ in range(rng.integers(1, 9)):
        corners = rng.integers(3, 6)
        offsets = rng.integers(-2, 3, (corners, 2)) if lattice else rng.uniform(-2, 2, (corners, 2))
        try:
            obstacles.append(as_ring(rng.integers(-1, 11, 2) + offsets))
        except InvalidPolygon:
            continue
    if rng.random() < 0.3:
        obstacles.append(ROOM)
    return ke.PolygonWorld(SQUARE if rng.random() < 0.5 else NOTCHED, obstacles), rng


def slides(world):
    """The library's test of semi-free motions, which does not use sweeps."""
    return ke.problems.ProblemRecord(
        ke.Point(),
        world,
        ke.spaces.RealSpace(world.lo, world.hi),
        world.lo,
        world.hi,
        0.0,
        np.zeros(2, np.int64),
    ).is_semi_free_path


def random_problem(seed):
    """A start and a goal in the free space of a random world, or None where there is hardly any."""
    world, rng = random_world(seed)
    for _ in range(50):
        try:
            return ke.Problem(ke.Point(), world, *rng.integers(1, 20, (2, 2)) / 2)
        except KinoeduError:
            continue
    return None


def shortest_by_brute_force(problem):
    """Dijkstra's algorithm by networkx over all vertices outside solids, with every pair tested."""
    vertices = np.unique(
        np.concatenate([problem.world.edges[:, :2], [problem.start, problem.goal]]), axis=0
    )
    free = [v for v in vertices if problem.is_semi_free_path(v, v)]
    graph = networkx.Graph()
    graph.add_nodes_from(tuple(v) for v in free)
    for a, b in combinations(free, 2):
        if problem.is_semi_free_path(a, b):
            graph.add_edge(tuple(a), tuple(b), weight=float(np.sqrt(((a - b) ** 2).sum())))
    try:
        return networkx.dijkstra_path_length(graph, tuple(problem.start), tuple(problem.goal))
    except networkx.NetworkXNoPath:
        return np.inf


def assert_all_pairs(world):
    """Assert that the edges of the roadmap are the semi-free motions between its nodes."""
    roadmap = ke.visibility_roadmap(world)
    judge = slides(world)
    expected = {
        (i, j)
        for i, j in combinations(range(len(roadmap.nodes)), 2)
        if judge(roadmap.nodes[i], roadmap.nodes[j])
    }
    assert {tuple(sorted(edge)) for edge in roadmap.edges.tolist()} == expected
    assert len(roadmap.edges) == len(expected)


@pytest.mark.parametrize("name", WORLDS)
def test_touching_and_overlapping_worlds_by_name(name):
    """Each way in which obstacles can touch, against brute force."""
    assert_all_pairs(WORLDS[name])


@pytest.mark.parametrize("seed", range(60))
def test_edges_are_those_of_brute_force(seed):
    """In random worlds, most of them degenerate."""
    assert_all_pairs(random_world(seed)[0])


@pytest.mark.parametrize("seed", range(100, 160))
def test_paths_are_the_shortest(seed):
    """As long as the shortest path over all vertices; never through an interior, by shapely."""
    problem = random_problem(seed)
    if problem is None:
        return
    plan = ke.plan_by_visibility(problem)
    assert plan.cost == pytest.approx(shortest_by_brute_force(problem), rel=1e-12)
    if plan.path is None:
        assert "no path" in plan.reason
        return
    assert np.array_equal(plan.path[0], problem.start) and np.array_equal(
        plan.path[-1], problem.goal
    )
    world = problem.world
    rings = ke.worlds.polygon_world.rings_of(world)
    solid = shapely.union_all([shapely.Polygon(outer, rooms) for outer, *rooms in rings[1:]])
    shrunk = solid.buffer(-1e-7)
    inside = shapely.Polygon(rings[0][0]).buffer(1e-7)
    for a, b in pairwise(plan.path):
        motion = shapely.LineString([a, b])
        assert not motion.intersects(shrunk) and inside.covers(motion)


def test_the_numbers_of_known_worlds():
    """Convex corners of obstacles, reflex corners of a boundary and a room, no straight ones."""
    assert len(ke.visibility_roadmap(WORLDS["nothing"]).nodes) == 0
    assert len(ke.visibility_roadmap(WORLDS["a reflex boundary"]).nodes) == 1
    assert len(ke.visibility_roadmap(WORLDS["a room"]).nodes) == 4
    assert len(ke.visibility_roadmap(WORLDS["a common edge"]).nodes) == 4
    assert len(ke.visibility_roadmap(WORLDS["a common corner"]).nodes) == 7
    around = ke.visibility_roadmap(ke.PolygonWorld(SQUARE, [box(4, 4)]))
    assert (len(around.nodes), len(around.edges)) == (4, 4)


@pytest.mark.parametrize("scale", [1e-100, 1e100])
def test_a_world_of_any_size(scale):
    """The edges are the same after scaling by a power far from one."""
    obstacles = [np.array(box(2, 2)) * scale, np.array(box(5, 3)) * scale]
    small = ke.visibility_roadmap(ke.PolygonWorld(np.array(SQUARE) * scale, obstacles))
    assert np.array_equal(
        small.edges, ke.visibility_roadmap(ke.PolygonWorld(SQUARE, [box(2, 2), box(5, 3)])).edges
    )


def test_compiled_and_interpreted_see_the_same():
    """The same pairs in the same order."""
    for name in ("a room", "overlapping", "four round a corner"):
        corners, _ = corners_of(WORLDS[name])
        assert np.array_equal(pairs_in_sight(corners), pairs_in_sight.py_func(corners))


def test_start_at_the_goal_and_in_sight():
    """Cost 0 where start is the goal; one straight motion where nothing is between them."""
    there = ke.plan_by_visibility(ke.Problem(ke.Point(), WORLDS["a room"], (1, 1), (1, 1)))
    assert there.cost == 0.0 and len(there.path) == 2
    assert ke.plan_by_visibility(
        ke.Problem(ke.Point(), WORLDS["a room"], (1, 1), (1, 9))
    ).path.tolist() == [[1, 1], [1, 9]]


def test_a_closed_room_is_out_of_reach_and_a_touching_corner_is_not():
    """Obstacles that meet in a point leave a path; a closed wall or a common edge does not."""
    closed = ke.plan_by_visibility(ke.Problem(ke.Point(), WORLDS["a room"], (1, 1), (5, 5)))
    assert (
        closed.path is None
        and closed.cost == np.inf
        and closed.reason
        and closed.roadmap is not None
    )
    for height, found in ((5, True), (6, False)):
        halves = [
            box(0, 5, 5, 1),
            [(5, 5), (10, 5), (10, height), (5, 6)] if height == 6 else [(5, 5), (10, 4), (10, 5)],
        ]
        plan = ke.plan_by_visibility(
            ke.Problem(ke.Point(), ke.PolygonWorld(SQUARE, halves), (5.5, 1), (7, 9))
        )
        assert (plan.path is not None) == found


def test_what_it_is_not_for_is_refused_by_name():
    """Discs, robots with a size, clearances, terrains, other objects."""
    round_world = ke.PolygonWorld(SQUARE, [((5, 5), 1)])
    with pytest.raises(InvalidWorld, match="round"):
        ke.visibility_roadmap(round_world)
    with pytest.raises(InvalidWorld, match="round"):
        ke.plan_by_visibility(ke.Problem(ke.Point(), round_world, (1, 1), (9, 9)))
    for problem in (
        ke.Problem(ke.Disk(0.1), WORLDS["a room"], (1, 1), (9, 9)),
        ke.Problem(ke.Point(), WORLDS["a room"], (1, 1), (9, 9), clearance=0.1),
        ke.Problem(ke.Point(), ke.Terrain([[1, 1], [1, 1]]), (0.5, 0.5), (1.5, 1.5)),
        None,
        42,
    ):
        for function in (ke.visibility_roadmap, ke.plan_by_visibility):
            with pytest.raises(InvalidParameter):
                function(problem)
    with pytest.raises(InvalidStart):
        ke.Problem(ke.Point(), WORLDS["a room"], (3, 3), (9, 9))


def test_between_obstacles_that_touch_in_a_point_only_a_semi_free_path_passes():
    """The docstrings of both exact planners say so: the free path goes round, or there is none."""
    left, right = [(0, 5.5), (5, 5), (0, 4.5)], [(5, 5), (9, 4.5), (9, 5.5)]
    closing = [(5, 5), (10, 4.5), (10, 5.5)]
    for other, free_path in ((right, True), (closing, False)):
        problem = ke.Problem(ke.Point(), ke.PolygonWorld(SQUARE, [left, other]), (5, 1), (5, 9))
        semi_free, free = ke.plan_by_visibility(problem), ke.plan_by_decomposition(problem)
        assert semi_free.path.tolist() == [[5, 1], [5, 9]] and semi_free.cost == 8.0
        assert (free.path is not None) == free_path and free.cost > 14.0
        assert not problem.is_free_path(problem.start, problem.goal)
        assert problem.is_semi_free_path(problem.start, problem.goal)
    for planner in (ke.plan_by_visibility, ke.plan_by_decomposition):
        assert "touch in a single" in " ".join(planner.__doc__.split())


@pytest.mark.parametrize("q", [(3, 3), (-1, 5), (11, 11)])
def test_an_end_that_is_not_free_is_no_path(q):
    """A Problem refuses such an end; a record whose end was replaced gets a reason."""
    problem = ke.Problem(ke.Point(), ke.PolygonWorld(SQUARE, [box(2, 2)]), (1, 1), (9, 9))
    for name in ("start", "goal"):
        plan = ke.plan_by_visibility(problem._replace(**{name: np.array(q, float)}))
        assert plan.path is None and plan.reason.startswith(f"the {name} is inside an obstacle or")
