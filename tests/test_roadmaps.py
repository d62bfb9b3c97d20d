"""Connection rules, samplers, queries, grids, shortcuts, properties, and receding horizons."""

from dataclasses import replace
from itertools import combinations, pairwise

import networkx
import numpy as np
import pytest
import shapely

import kinoedu as ke
from kinoedu.errors import (
    InvalidGoal,
    InvalidParameter,
    InvalidPoint,
    InvalidStart,
    InvalidWorld,
    KinoeduError,
)
from kinoedu.planners.exploring.seen_map import SeenMap
from kinoedu.planners.roadmaps.alternatives import edges_along
from kinoedu.planners.roadmaps.connecting import join_in_order
from kinoedu.planners.roadmaps.neighbours import k_closest, visiting_order
from kinoedu.problems import MOTIONS, ProblemRecord, Roadmap
from kinoedu.spaces import WrappingSpace

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
WALL = [(4, 0), (6, 0), (6, 8), (4, 8)]
ROOM = ([(7, 4), (9, 4), (9, 7), (7, 7)], [[(7.5, 4.5), (8.5, 4.5), (8.5, 6.5), (7.5, 6.5)]])
WORLD = ke.PolygonWorld(SQUARE, [WALL, ROOM])
SOLID = shapely.union_all([shapely.Polygon(WALL), shapely.Polygon(*ROOM)])
RULES = {"closest": ke.KClosest(6), "radius": ke.Radius(1.2), "components": ke.ComponentKClosest(2)}


def problem_of(start=(1.0, 1.0), goal=(9.0, 1.0), world=WORLD, robot=None):
    """A problem from one side of the wall to the other."""
    return ke.Problem(robot or ke.Point(), world, start, goal)


def distances(nodes):
    """Between all nodes, (n, n)."""
    return np.sqrt(((nodes[:, None] - nodes[None]) ** 2).sum(axis=2))


def assert_path_is_free(plan):
    """Check a path by shapely, which shares no code with this package."""
    line = shapely.LineString(plan.path)
    assert not line.intersects(SOLID) and shapely.Polygon(SQUARE).contains_properly(line)


@pytest.mark.parametrize("rule", RULES)
def test_every_rule_compiled_and_recorded(rule):
    """Free edges, none twice, none to itself; a free path; the same when recorded."""
    problem = problem_of()
    plan = ke.prm(problem, n=300, neighbours=RULES[rule], rng=1)
    recorder = ke.Recorder(problem)
    recorded = ke.prm(recorder, n=300, neighbours=RULES[rule], rng=1)
    assert (
        np.array_equal(plan.roadmap.edges, recorded.roadmap.edges)
        and plan.stats == recorded.stats
        and plan.cost == recorded.cost
    )
    nodes, edges = plan.roadmap
    assert len({frozenset(edge) for edge in edges.tolist()}) == len(edges)
    assert all(i != j and problem.is_free_path(nodes[i], nodes[j]) for i, j in edges)
    assert_path_is_free(plan)


def test_the_radius_rule_joins_all_pairs_within_it():
    """Exactly the pairs within the radius whose motion is free are joined."""
    problem = problem_of()
    nodes, edges = ke.prm(problem, n=150, neighbours=ke.Radius(1.5), rng=0).roadmap
    near = np.argwhere(np.triu(distances(nodes) <= 1.5, 1)).tolist()
    expected = {(i, j) for i, j in near if problem.is_free_path(nodes[i], nodes[j])}
    assert {tuple(sorted(edge)) for edge in edges.tolist()} == expected


def test_the_component_rule_makes_a_forest_that_joins_what_trying_all_pairs_in_a_row_would():
    """No circles; and with no limit to the tries the components are those of all free pairs."""
    problem = problem_of()
    nodes, edges = ke.prm(problem, n=80, neighbours=ke.ComponentKClosest(10_000), rng=0).roadmap
    forest = networkx.Graph(edges.tolist())
    assert networkx.is_forest(forest)
    whole = networkx.Graph(
        (i, j)
        for i, j in combinations(range(len(nodes)), 2)
        if problem.is_free_path(nodes[i], nodes[j])
    )
    assert {frozenset(c) for c in networkx.connected_components(forest)} == {
        frozenset(c) for c in networkx.connected_components(whole)
    }


def test_the_component_rule_tries_k_of_each_component():
    """The closest one is behind the wall, the next is not: K = 1 leaves them apart, K = 2 joins
    them.
    """
    problem = problem_of(start=(3, 7), goal=(3, 9.5))
    for k, edges in ((1, [(0, 1)]), (2, [(0, 1), (1, 2)])):
        plan = ke.prm(
            problem,
            n=1,
            neighbours=ke.ComponentKClosest(k),
            sampler=lambda n, d: np.array([(0.65, 0.79)]),
        )
        assert [tuple(sorted(edge)) for edge in plan.roadmap.edges.tolist()] == edges


def test_prm_is_prm_with_its_k_closest():
    """The parameter k means the rule KClosest(k)."""
    by_k, by_rule = (
        ke.prm(problem_of(), n=200, k=6, rng=0),
        ke.prm(problem_of(), n=200, neighbours=ke.KClosest(6), rng=0),
    )
    assert np.array_equal(by_k.roadmap.edges, by_rule.roadmap.edges)


def test_a_sampler_lays_its_points_over_the_space():
    """In proportion, those that are free, in their order."""
    points = np.array([(0.1, 0.1), (0.5, 0.5), (0.95, 0.9), (0.2, 0.3)])
    plan = ke.prm(problem_of(), n=4, sampler=lambda n, d: points[:n, :d])
    assert plan.roadmap.nodes[2:].tolist() == [[1.0, 1.0], [9.5, 9.0], [2.0, 3.0]]


def test_prm_star_comes_near_the_shortest_path():
    """Never below the optimum, and on the average within 4 % with 3,000 nodes, nearer than with
    300.
    """
    problem = problem_of()
    least = ke.plan_by_visibility(problem).cost
    few, many = (
        np.array([ke.prm_star(problem, n=n, rng=seed).cost for seed in range(4)]) / least
        for n in (300, 3000)
    )
    assert few.min() >= 1.0 and many.min() >= 1.0
    assert many.mean() < 1.04 and many.mean() < few.mean()


def test_one_roadmap_answers_many_queries():
    """Each path free and from end to end, compiled as recorded; no roadmap node changes its
    place.
    """
    problem = problem_of()
    roadmap = ke.build_roadmap(problem, n=400, rng=0)
    for start, goal in [((1, 1), (9, 1)), ((5, 9), (1, 1)), ((9, 9), (9, 9)), ((1, 9), (9.5, 5))]:
        plan = ke.query(problem, roadmap, start, goal)
        assert plan.path[0].tolist() == list(start) and plan.path[-1].tolist() == list(goal)
        assert plan.problem.start.tolist() == list(start)
        if start != goal:
            assert_path_is_free(plan)
        assert np.array_equal(plan.roadmap.nodes[2:], roadmap.nodes)
    recorded = ke.query(ke.Recorder(problem), roadmap)
    assert recorded.cost == ke.query(problem, roadmap).cost
    elsewhere = ke.query(ke.Recorder(problem), roadmap, (5, 9))
    assert elsewhere.problem.start.tolist() == [5, 9] and elsewhere.problem.log


def test_queries_that_cannot_be_answered():
    """A goal in a closed room is a reason; an end in contact or of another shape is refused; so is
    what is no roadmap.
    """
    problem = problem_of()
    roadmap = ke.build_roadmap(problem, n=100, rng=0)
    assert ke.query(problem, roadmap, goal=(8, 5.5)).reason
    assert ke.query(
        problem, ke.build_roadmap(problem, n=0, rng=0), (1, 1), (2, 2)
    ).cost == pytest.approx(2**0.5)
    with pytest.raises(InvalidStart):
        ke.query(problem, roadmap, start=(5, 5))
    with pytest.raises(InvalidGoal):
        ke.query(ke.Recorder(problem), roadmap, goal=(5, 5))
    with pytest.raises(KinoeduError):
        ke.query(problem, roadmap, start=(1, 1, 1))
    with pytest.raises(InvalidParameter, match="roadmap"):
        ke.query(problem, ke.prm(problem, n=10, rng=0))


@pytest.mark.parametrize(
    "ask",
    [
        lambda p: ke.prm(p, neighbours=6, rng=0),
        lambda p: ke.prm(p, neighbours=ke.Radius, rng=0),
        lambda p: ke.prm(p, n=10),
        lambda p: ke.prm(p, n=3, sampler=lambda n, d: np.full((n, d), 1.5)),
        lambda p: ke.prm(p, n=3, sampler=lambda n, d: np.full((n, d + 1), 0.5)),
        lambda p: ke.KClosest(0),
        lambda p: ke.Radius(0),
        lambda p: ke.Radius(np.inf),
        lambda p: ke.ComponentKClosest(1.5),
        lambda p: ke.grid_roadmap(p, spacing=0),
        lambda p: ke.grid_roadmap(p, spacing=1e-9),
        lambda p: ke.grid_roadmap(p, neighbours=6),
        lambda p: ke.grid_roadmap(object()),
        lambda p: ke.shortcut(p, rng=0),
        lambda p: ke.shortcut(ke.rrt(p, rng=0), tries=-1, rng=0),
        lambda p: ke.roadmap_properties(p, None, rng=0),
        lambda p: ke.receding_horizon(p, reach=0, rng=0),
        lambda p: ke.receding_horizon(object(), rng=0),
    ],
)
def test_wrong_tuning_is_refused(ask):
    """An InvalidParameter is raised."""
    with pytest.raises(InvalidParameter):
        ask(problem_of())


def test_a_grid_joins_straight_or_also_diagonal_neighbours():
    """In an open square of n x n cells there are 2 n (n - 1) straight pairs and 2 (n - 1)^2
    diagonal ones.
    """
    problem = problem_of(world=ke.PolygonWorld(SQUARE))
    straight, all_round = (ke.grid_roadmap(problem, spacing=1, neighbours=m) for m in (4, 8))
    assert len(straight.nodes) == 100 and len(straight.edges) == 180
    assert len(all_round.edges) == 180 + 2 * 81
    assert ke.query(problem, straight, (0.5, 0.5), (9.5, 9.5), k=1).cost == pytest.approx(18.0)
    assert ke.query(problem, all_round, (0.5, 0.5), (9.5, 9.5), k=1).cost == pytest.approx(
        9 * 2**0.5
    )


def test_a_grid_gives_no_answer_below_its_resolution():
    """A gap narrower than a cell is missed by a coarse grid and found by a fine one."""
    world = ke.PolygonWorld(
        SQUARE, [[(4, 0), (5, 0), (5, 4.6), (4, 4.6)], [(4, 4.9), (5, 4.9), (5, 10), (4, 10)]]
    )
    problem = problem_of(world=world)
    assert ke.query(problem, ke.grid_roadmap(problem, spacing=1)).path is None
    assert ke.query(problem, ke.grid_roadmap(problem, spacing=0.2)).path is not None


def test_a_grid_on_the_torus_closes_on_itself():
    """Every node has its four neighbours, across the seam too."""
    space = WrappingSpace(np.full(2, -np.pi), np.full(2, np.pi), np.ones(2, np.bool_), np.ones(2))
    world = ke.PolygonWorld([(-4, -4), (4, -4), (4, 4), (-4, 4)])
    q = np.array([0.1, 0.1])
    torus = ProblemRecord(ke.Point(), world, space, q, q, 0.0, np.zeros(2, np.int64))
    roadmap = ke.grid_roadmap(torus, spacing=2 * np.pi / 8, neighbours=4)
    assert len(roadmap.nodes) == 64
    assert np.bincount(roadmap.edges.ravel()).tolist() == [4] * 64


@pytest.mark.parametrize("seed", range(6))
def test_shortcuts_are_never_longer_and_stay_free(seed):
    """From every planner's path; compiled as recorded; what was built stays."""
    problem = problem_of()
    for plan in (
        ke.rrt(problem, rng=seed),
        ke.prm(problem, n=300, rng=seed),
        ke.rrt_connect(problem, rng=seed),
    ):
        shorter = ke.shortcut(plan, rng=seed)
        assert shorter.cost < plan.cost
        assert shorter.cost == pytest.approx(
            sum(problem.distance(a, b) for a, b in pairwise(shorter.path)), rel=1e-12
        )
        assert shorter.cost >= ke.plan_by_visibility(problem).cost
        assert np.array_equal(shorter.path[[0, -1]], plan.path[[0, -1]])
        assert all(problem.is_free_path(a, b) for a, b in pairwise(shorter.path))
        assert_path_is_free(shorter)
        assert shorter.tree is plan.tree and shorter.roadmap is plan.roadmap
    recorder = ke.Recorder(problem)
    assert np.array_equal(
        ke.shortcut(ke.rrt(recorder, rng=seed), rng=seed).path,
        ke.shortcut(ke.rrt(problem, rng=seed), rng=seed).path,
    )


def test_a_shortcut_joins_two_places_of_the_path():
    """One try adds no place that the path does not go through."""
    plan = ke.rrt(problem_of(), rng=0)
    way, shortened = shapely.LineString(plan.path), 0
    for seed in range(30):
        path = ke.shortcut(plan, tries=1, rng=seed).path
        assert shapely.distance(way, shapely.points(path)).max() < 1e-9
        shortened += not np.array_equal(path, plan.path)
    assert shortened > 3


def test_an_edge_is_used_either_way_but_not_a_driven_one():
    edges, numbers = np.array([(0, 1), (2, 1), (0, 2)]), np.array([0, 1, 2])
    assert edges_along(edges, numbers, directed=False).tolist() == [0, 1]
    assert edges_along(edges, numbers, directed=True).tolist() == [0]


def test_shortcuts_of_what_cannot_be_shortened():
    """Without a path, with a straight path or with no tries, the plan stays as it is."""
    none = ke.rrt(problem_of(goal=(8, 5.5)), max_nodes=50, rng=0)
    assert ke.shortcut(none, rng=0) is none
    straight = ke.plan_by_visibility(problem_of(goal=(1, 9)))
    assert ke.shortcut(straight, rng=0) is straight
    plan = ke.rrt(problem_of(), rng=0)
    assert ke.shortcut(plan, tries=0, rng=0) is plan


def test_a_shortcut_that_finds_nothing_counts_its_checks():
    """A shortest path stays, and its plan's checks grow by the questions that were asked."""
    problem = problem_of()
    plan = ke.plan_by_visibility(problem)
    before = int(problem.query_counts[0])
    same = ke.shortcut(plan, tries=50, rng=0)
    asked = int(problem.query_counts[0]) - before
    assert asked > 0 and same.stats["checks"] == plan.stats.get("checks", 0) + asked
    assert same.cost == plan.cost and np.array_equal(same.path, plan.path)


@pytest.mark.parametrize("planner", [ke.plan_by_visibility, ke.plan_by_decomposition])
def test_other_routes_of_exact_planners_lead_from_start_to_goal(planner):
    """Wherever start and goal are in the roadmap; the first route is the plan's own."""
    world = ke.PolygonWorld(SQUARE, [[(4, 2), (6, 2), (6, 7), (4, 7)]])
    problem = ke.Problem(ke.Point(), world, (1, 5), (9, 5))
    plan = planner(problem)
    routes = ke.alternative_routes(plan, 2, penalty=10)
    assert np.array_equal(routes[0].path, plan.path) and len(routes) == 2
    for route in routes:
        assert route.path[0].tolist() == [1, 5] and route.path[-1].tolist() == [9, 5]
        assert all(problem.is_semi_free_path(a, b) for a, b in pairwise(route.path))
    nowhere = replace(plan, path=plan.path + 0.1)
    with pytest.raises(InvalidParameter, match="no nodes of its roadmap"):
        ke.alternative_routes(nowhere)


def test_a_query_takes_angles_of_any_turn():
    """A start a full turn away is the same start, and the path keeps its angles in [-pi, pi)."""
    world = ke.PolygonWorld([(-5, -5), (5, -5), (5, 5), (-5, 5)], [[(2, -2), (3, -2), (3, 3)]])
    problem = ke.Problem(ke.TwoLinkArm(1.5, 1.5, 0.1), world, (1.6, 0.1), (-1.6, 0.3))
    roadmap = ke.build_roadmap(problem, n=50, rng=0)
    for asked in (problem, ke.Recorder(problem)):
        plan = ke.query(asked, roadmap, (1.6 + 2 * np.pi, 0.1), (-1.6, 0.3 - 2 * np.pi))
        assert plan.path[0] == pytest.approx([1.6, 0.1]) and np.abs(plan.path).max() <= np.pi
        assert plan.cost == pytest.approx(ke.query(problem, roadmap).cost)


def test_the_properties_of_known_roadmaps():
    """The visibility roadmap has all four, with delta = 1; an empty one has none; one in pieces is
    not connected.
    """
    world = ke.PolygonWorld(SQUARE, [WALL])
    problem = problem_of(world=world)

    def shortest(u, v):
        grown = ProblemRecord(problem.robot, world, problem.space, u, v, 0.0, np.zeros(2, np.int64))
        return ke.plan_by_visibility(grown).cost

    best = ke.roadmap_properties(problem, ke.visibility_roadmap(world), n=30, rng=0)
    assert best[:3] == (1.0, 1.0, True) and best.efficiency == pytest.approx(1.0)
    sampled = ke.roadmap_properties(
        problem, ke.build_roadmap(problem, n=200, rng=0), n=40, shortest=shortest, rng=0
    )
    assert sampled.connected and 1.0 <= sampled.efficiency < 3.0
    nothing = ke.roadmap_properties(
        problem, Roadmap(np.empty((0, 2)), np.empty((0, 2), np.int64)), n=10, rng=0
    )
    assert nothing[:3] == (0.0, 0.0, False) and np.isnan(nothing.efficiency)
    apart = ke.roadmap_properties(
        problem,
        Roadmap(np.array([(1.0, 1.0), (9.0, 1.0)]), np.empty((0, 2), np.int64)),
        n=30,
        rng=0,
    )
    assert not apart.connected and apart.efficiency == np.inf and 0.5 < apart.accessible < 1.0


@pytest.mark.parametrize("seed", range(10))
def test_a_scan_measures_what_shapely_measures(seed):
    """In every direction the distance to the first wall or disc, or none within reach."""
    rng = np.random.default_rng(seed)
    boxes = [
        [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)] for x, y in rng.integers(0, 9, (6, 2))
    ]
    world = ke.PolygonWorld(SQUARE, [*boxes, ((5.5, 5.5), 0.4)])
    walls = shapely.union_all([shapely.LinearRing(ring) for ring in [SQUARE, *boxes]])
    disc = shapely.Point(5.5, 5.5).buffer(0.4, quad_segs=2000)
    q = rng.uniform(0.1, 9.9, 2)
    seen = ke.scan(world, q, rays=37, reach=6.0)
    for angle, distance, hit in zip(seen.angles, seen.distances, seen.hit):
        ray = shapely.LineString([q, q + 6.0 * np.array([np.cos(angle), np.sin(angle)])])
        found = shapely.union(ray.intersection(walls), ray.intersection(disc))
        expected = found.distance(shapely.Point(q)) if not found.is_empty else None
        assert hit == (expected is not None)
        assert distance == pytest.approx(6.0 if expected is None else expected, abs=1e-6)


@pytest.mark.parametrize("seed", range(4))
def test_a_scan_from_inside_a_disc_sees_its_rim(seed):
    """As it sees a polygon's edges from inside."""
    rng = np.random.default_rng(seed)
    angle, off = rng.uniform(0, 2 * np.pi), rng.uniform(0, 0.99)
    q = np.array([5.0, 5.0]) + off * np.array([np.cos(angle), np.sin(angle)])
    seen = ke.scan(ke.PolygonWorld(SQUARE, [((5, 5), 1)]), q, rays=17)
    assert seen.hit.all()
    assert np.hypot(*(seen.points - 5.0).T) == pytest.approx(1.0, abs=1e-12)


def test_a_scan_refuses_what_it_cannot_see():
    """Terrains, places outside, ranges and rays that make no sense."""
    with pytest.raises(InvalidWorld):
        ke.scan(ke.Terrain([[1, 1], [1, 1]]), (1, 1))
    with pytest.raises(InvalidPoint):
        ke.scan(WORLD, (11, 1))
    reaches = [{"reach": reach} for reach in (0, -1.0, np.nan, -np.inf, "far", [1.0])]
    for wrong in (*reaches, {"rays": 0}, {"rays": 2.5}, {"rays": True}, {"rays": 10**7}):
        with pytest.raises(InvalidParameter):
            ke.scan(WORLD, (1, 1), **wrong)


def test_a_scan_has_no_limit_by_any_infinite_number():
    """In single precision too."""
    everything = ke.scan(WORLD, (1, 1), rays=8).distances
    assert np.array_equal(
        ke.scan(WORLD, (1, 1), rays=8, reach=np.float32(np.inf)).distances, everything
    )


@pytest.mark.parametrize("robot", [ke.Point(), ke.Disk(0.2)], ids=["point", "disk"])
def test_a_receding_horizon_finds_its_way_through_an_unknown_world(robot):
    """Every motion is free in the true world; nothing was known beforehand, so the way is not the
    shortest.
    """
    problem = problem_of(world=ke.PolygonWorld(SQUARE, [WALL]), robot=robot)
    plan = ke.receding_horizon(problem, rays=90, rng=1)
    assert plan.path is not None, plan.reason
    assert np.array_equal(plan.path[0], problem.start) and np.array_equal(
        plan.path[-1], problem.goal
    )
    assert all(problem.is_free_path(a, b) for a, b in pairwise(plan.path))
    assert shapely.LineString(plan.path).distance(shapely.Polygon(WALL)) > robot.radius
    assert (
        plan.cost >= ke.plan_by_visibility(problem_of(world=ke.PolygonWorld(SQUARE, [WALL]))).cost
    )
    assert plan.stats["looks"] == len(plan.tree.nodes) - 1  # the last node is the goal


def seen_walls(world, q, **sensor):
    """The walls that one scan adds to an empty map, as shapely's union of segments."""
    seen_map = SeenMap([], set())
    seen_map.add(ke.scan(world, q, **sensor))
    return shapely.union_all(shapely.linestrings(seen_map.triangles()[:, :2]))


def test_a_map_shows_walls_without_gaps_and_passages_without_walls():
    """All of a wall that is near is seen. Between a corner and the wall behind it there is room,
    although the rays that hit them are neighbours.
    """
    seen = seen_walls(ke.PolygonWorld(SQUARE, []), (2, 3), rays=180, reach=8)
    for wall in ([(0.3, 0), (8.7, 0)], [(0, 0.3), (0, 9.7)], [(0.3, 10), (5, 10)]):
        assert seen.buffer(1e-6).contains(shapely.LineString(wall))
    overhang = ke.PolygonWorld(SQUARE, [[(6, 1), (9, 2), (8, 5)]])
    for q in ((3, 4), (2, 6), (4, 4.5), (1, 3)):
        assert not seen_walls(overhang, q).intersects(shapely.LineString([(5, 0.4), (7, 0.4)]))


def test_a_receding_horizon_says_why_it_stops():
    """The reason is that the moves ran out; where the start is the goal, no move is needed."""
    problem = problem_of()
    plan = ke.receding_horizon(problem, max_moves=1, rng=0)
    assert plan.path is None and "moves" in plan.reason and plan.tree is not None
    assert ke.receding_horizon(problem_of(goal=(1, 1)), rng=0).cost == 0.0


@pytest.mark.parametrize("n", [0, 1, 700, 6000])
def test_the_order_in_which_nodes_are_visited_changes_no_edge(n):
    """The order is a permutation; edges, their costs and the number of checks are those of the
    order of growth.
    """
    problem, nodes = problem_of(), np.random.default_rng(0).uniform(0, 10, (n, 2))
    order = visiting_order(problem, nodes)
    assert sorted(order.tolist()) == list(range(n))
    k = min(5, max(n - 1, 0))
    first, to = k * np.arange(n + 1), np.empty(0, np.int64)
    if k:
        to = k_closest(problem, nodes, k).ravel()
    results, checks = [], []
    for turn in (np.arange(n), order, order[::-1].copy()):
        before = int(problem.query_counts[MOTIONS])
        results.append(join_in_order(problem, nodes, first, to, turn))
        checks.append(int(problem.query_counts[MOTIONS]) - before)
    for edges, costs in results[1:]:
        assert np.array_equal(edges, results[0][0]) and np.array_equal(costs, results[0][1])
    assert len(set(checks)) == 1


def test_nodes_that_lie_in_a_row_of_buckets_are_visited_together():
    """In a large set the next node visited is near: within a few buckets on average."""
    nodes = np.random.default_rng(0).uniform(0, 10, (20_000, 2))
    visited = nodes[visiting_order(problem_of(), nodes)]
    apart = np.linalg.norm(np.diff(visited, axis=0), axis=1)
    assert apart.mean() < 5 * 10 / np.sqrt(len(nodes))


def test_questions_to_a_recorder_come_in_the_order_of_growth():
    """Whoever watches a roadmap sees it grow node by node."""
    order = visiting_order(ke.Recorder(problem_of()), np.zeros((5000, 2)))
    assert order.tolist() == list(range(5000))
