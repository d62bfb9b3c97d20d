"""RRT-Connect, RRT*, informed RRT* and the tree roadmap; shapely checks every path too."""

from itertools import pairwise

import numpy as np
import pytest
import shapely

import kinoedu as ke
from kinoedu.errors import InvalidParameter
from kinoedu.planners.trees.near import near_nodes
from kinoedu.planners.trees.rrt_star import sufficient_gamma
from kinoedu.spaces.buckets import add, empty_tree

SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
WALL = [(4, 0), (6, 0), (6, 8), (4, 8)]
ROOM = ([(7, 4), (9, 4), (9, 7), (7, 7)], [[(7.5, 4.5), (8.5, 4.5), (8.5, 6.5), (7.5, 6.5)]])
DISC = ((2, 5), 0.7)
SOLIDS = [
    shapely.Polygon(WALL),
    shapely.Polygon(ROOM[0], ROOM[1]),
    shapely.Point(DISC[0]).buffer(DISC[1], quad_segs=64),
]
WORLDS = {
    "polygons": ke.PolygonWorld(SQUARE, [WALL, DISC, ROOM]),
    "terrain": ke.Terrain(
        np.kron([[1, 0, 1, 1], [1, 0, 1, 0], [1, 1, 1, 1], [1, 0, 1, 1]], np.ones((5, 5))),
        resolution=0.5,
    ),
}
ROBOTS = {"point": ke.Point(), "disk": ke.Disk(0.3)}
PLANNERS = {
    "rrt_connect": ke.rrt_connect,
    "rrt_star": lambda problem, **given: ke.rrt_star(problem, **{"max_nodes": 800, **given}),
    "informed_rrt_star": lambda problem, **given: ke.informed_rrt_star(
        problem, **{"max_nodes": 800, **given}
    ),
    "tree_roadmap": lambda problem, **given: ke.tree_roadmap(
        problem, **{"max_nodes": 3000, **given}
    ),
}


def problem_of(world="polygons", robot="point"):
    """A problem from one side of a world to the other."""
    return ke.Problem(ROBOTS[robot], WORLDS[world], (1.0, 1.0), (9.0, 1.0))


def assert_free_by_shapely(path, radius):
    """The whole path keeps the robot's radius from obstacles and from the boundary."""
    line = shapely.LineString(path)
    assert all(line.distance(solid) > radius - 1e-3 * (solid is SOLIDS[2]) for solid in SOLIDS)
    assert shapely.Polygon(SQUARE).buffer(-radius).contains(line)


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("robot", ROBOTS)
@pytest.mark.parametrize("planner", PLANNERS)
def test_a_path_is_free_all_the_way(world, robot, planner):
    """From start to goal, judged again edge by edge and by shapely; its length is its cost; the
    same again by the same seed.
    """
    problem = problem_of(world, robot)
    plan = PLANNERS[planner](problem, rng=1)
    assert plan.path is not None, plan.reason
    assert np.array_equal(plan.path[0], problem.start) and np.array_equal(
        plan.path[-1], problem.goal
    )
    assert all(
        problem.is_free_path(a, b) and problem.is_free_path(b, a) for a, b in pairwise(plan.path)
    )
    assert plan.cost == pytest.approx(
        sum(problem.distance(a, b) for a, b in pairwise(plan.path)), rel=1e-12
    )
    assert np.array_equal(plan.path, PLANNERS[planner](problem, rng=1).path)
    if world == "polygons":
        assert_free_by_shapely(plan.path, ROBOTS[robot].radius)


@pytest.mark.parametrize("planner", PLANNERS)
def test_a_tree_is_made_of_free_steps(planner):
    """Every node has a parent by a free motion of at most a step; roots are start or goal."""
    problem = problem_of()
    tuning = (
        {"reach": 0.8, "expand": ke.rrt_expansion(0.8)}
        if planner == "tree_roadmap"
        else {"step_size": 0.8}
    )
    tree = PLANNERS[planner](problem, rng=3, **tuning).tree
    roots = np.flatnonzero(tree.parent < 0).tolist()
    assert roots == ([0, 1] if planner == "rrt_connect" else [0])
    for node in np.flatnonzero(tree.parent >= 0):
        parent = tree.parent[node]
        assert problem.is_free_path(tree.nodes[parent], tree.nodes[node])
        assert problem.distance(tree.nodes[parent], tree.nodes[node]) <= 0.8 * (1 + 1e-12)
        if planner in ("rrt_connect", "tree_roadmap"):
            assert parent < node


@pytest.mark.parametrize("planner", ["rrt_connect", "rrt_star", "informed_rrt_star"])
@pytest.mark.parametrize("world", WORLDS)
def test_compiled_interpreted_and_recorded_are_one(planner, world):
    """The same tree, path and counts, past the size from which buckets are used."""
    problem = problem_of(world, "disk")
    compiled = PLANNERS[planner](problem, rng=5, max_nodes=400, step_size=0.4)
    recorder = ke.Recorder(problem)
    recorded = PLANNERS[planner](recorder, rng=5, max_nodes=400, step_size=0.4)
    assert np.array_equal(compiled.tree.nodes, recorded.tree.nodes)
    assert np.array_equal(compiled.tree.parent, recorded.tree.parent)
    assert compiled.stats == recorded.stats
    assert compiled.cost == recorded.cost
    assert recorder.counts()["is_free_path"] == recorded.stats["checks"]


def test_the_tree_roadmap_with_the_expansion_of_rrt_is_rrt():
    """The two trees are equal, node for node."""
    problem = problem_of()
    generic, rrt = (
        ke.tree_roadmap(problem, ke.rrt_expansion(), max_nodes=10_000, rng=2),
        ke.rrt(problem, rng=2),
    )
    assert np.array_equal(generic.tree.nodes, rrt.tree.nodes) and np.array_equal(
        generic.tree.parent, rrt.tree.parent
    )
    assert generic.stats == rrt.stats


@pytest.mark.parametrize("most", [2, 3, 4, 11, 50])
def test_two_trees_have_no_more_nodes_together_than_asked(most):
    """Also where one of them has a long way towards the other."""
    plan = ke.rrt_connect(ke.Recorder(problem_of()), step_size=0.05, max_nodes=most, rng=0)
    assert len(plan.tree.nodes) == most and plan.path is None


def test_an_expansion_steps_as_far_as_asked():
    """From the start alone, with nothing in the way."""
    room = ke.PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)])
    problem = ke.Problem(ke.Point(), room, (5, 5), (9, 9))
    tree = empty_tree(4, problem.space.lo, problem.space.hi)
    add(tree, problem.start, -1)
    node, q = ke.rrt_expansion(0.25)(problem, tree, np.random.default_rng(0))
    assert node == 0 and problem.distance(problem.start, q) == pytest.approx(0.25)


def test_rrt_star_comes_near_the_shortest_path():
    """Among polygons, over seeds: never below the optimum, within 3 % of it, and nearer than with
    fewer nodes and than RRT.
    """
    world = ke.PolygonWorld(SQUARE, [WALL, ROOM])
    problem = ke.Problem(ke.Point(), world, (1, 1), (9, 1))
    least = ke.plan_by_visibility(problem).cost
    few, many, informed, rrt = (
        np.array([plan(seed).cost for seed in range(8)]) / least
        for plan in (
            lambda seed: ke.rrt_star(problem, max_nodes=1000, max_iterations=20_000, rng=seed),
            lambda seed: ke.rrt_star(problem, max_nodes=8000, rng=seed),
            lambda seed: ke.informed_rrt_star(problem, max_nodes=8000, rng=seed),
            lambda seed: ke.rrt(problem, rng=seed),
        )
    )
    assert min(few.min(), many.min(), informed.min()) >= 1.0
    assert many.max() < 1.03 and informed.max() < 1.03
    assert many.mean() < few.mean() < rrt.mean()


def test_costs_of_the_whole_tree_are_those_of_its_ways():
    """After any number of rewirings the kept costs equal the sums along the tree, node by node."""
    from kinoedu.planners.trees.cost_tree import empty_costs
    from kinoedu.planners.trees.informed import Everywhere
    from kinoedu.planners.trees.rrt_star import grow_shortest

    problem = problem_of()
    tree = empty_tree(801, problem.space.lo, problem.space.hi)
    costs = empty_costs(tree)
    grow_shortest(
        problem, costs, Everywhere(0.05), 1.0, np.full(803, 1.0), 5000, np.random.default_rng(0)
    )
    for node in range(1, tree.size[0]):
        way, at = 0.0, node
        while tree.parent[at] >= 0:
            way += problem.distance(tree.nodes[tree.parent[at]], tree.nodes[at])
            at = tree.parent[at]
        assert at == 0
        assert costs.cost[node] == pytest.approx(way, rel=1e-12)
    attached = [node for parent in range(tree.size[0]) for node in chain(costs, parent)]
    assert sorted(attached) == list(range(1, tree.size[0]))


def chain(costs, parent):
    """The children of a node."""
    node, found = costs.child[parent], []
    while node >= 0:
        found.append(int(node))
        node = costs.sibling[node]
    return found


def test_near_nodes_are_those_within_the_radius():
    """By buckets, against all distances, with nodes beyond the box too."""
    problem = problem_of()
    rng = np.random.default_rng(0)
    tree = empty_tree(500, problem.space.lo, problem.space.hi)
    for q in rng.uniform(-3, 13, (500, 2)):
        add(tree, q, -1)
    for radius in (0.0, 0.3, 2.0, 50.0):
        for q in rng.uniform(-3, 13, (30, 2)):
            expected = np.flatnonzero(((tree.nodes - q) ** 2).sum(axis=1) <= radius * radius)
            assert sorted(near_nodes(problem, tree, q, radius).tolist()) == expected.tolist()
    assert near_nodes(problem, tree, tree.nodes[7], 0.0).tolist() == [7]


class Ball:
    """A reader's own problem in three dimensions, round a ball."""

    start, goal = (0.0, 0.0, -2.0), (0.0, 0.0, 2.0)

    def sample(self, rng):
        """In a cube."""
        return rng.uniform(-3, 3, 3)

    def distance(self, a, b):
        """Euclidean."""
        return float(np.sqrt(((a - b) ** 2).sum()))

    def steer(self, a, b, step):
        """On the line."""
        return a + min(1.0, step / max(self.distance(a, b), 1e-300)) * (b - a)

    def is_free_path(self, a, b):
        """By the exact distance of the segment from the centre."""
        u = b - a
        t = np.clip(-(a @ u) / max(float(u @ u), 1e-300), 0.0, 1.0)
        return float(np.sqrt(((a + t * u) ** 2).sum())) > 1.0


@pytest.mark.parametrize("planner", PLANNERS)
def test_a_readers_own_problem_is_planned_on(planner):
    """The space is not in this package."""
    tuning = (
        {"reach": 0.7, "expand": ke.rrt_expansion(0.7)}
        if planner == "tree_roadmap"
        else {"step_size": 0.7, "max_nodes": 300}
    )
    plan = PLANNERS[planner](Ball(), rng=0, **tuning)
    assert plan.path is not None, plan.reason
    assert all(Ball().is_free_path(a, b) for a, b in pairwise(plan.path))


@pytest.mark.parametrize("planner", PLANNERS)
def test_no_path_is_an_answer_with_a_reason(planner):
    """A goal in a closed room has no path; where the start is the goal, the cost is 0."""
    closed = ke.Problem(ke.Point(), ke.PolygonWorld(SQUARE, [ROOM]), (1, 1), (8, 5.5))
    plan = PLANNERS[planner](closed, max_nodes=150, rng=0)
    assert plan.path is None and plan.cost == np.inf and plan.reason and len(plan.tree.nodes) == 150
    there = ke.Problem(ke.Point(), WORLDS["polygons"], (1, 1), (1, 1))
    assert PLANNERS[planner](there, rng=0).cost == 0.0


@pytest.mark.parametrize("planner", ["rrt_connect", "rrt_star", "informed_rrt_star"])
@pytest.mark.parametrize(
    "options",
    [
        {"step_size": 0},
        {"step_size": np.nan},
        {"max_nodes": 0},
        {"max_nodes": 2.5},
        {"max_iterations": -1},
        {"rng": -1},
    ],
    ids=str,
)
def test_tuning_outside_its_range_is_refused(planner, options):
    """An InvalidParameter names the argument."""
    with pytest.raises(InvalidParameter, match=next(iter(options))):
        getattr(ke, planner)(problem_of(), **{"rng": 0, **options})


@pytest.mark.parametrize("options", [{"gamma": 0}, {"gamma": np.inf}, {"goal_bias": 1.5}], ids=str)
def test_rrt_star_refuses_tuning_of_its_own(options):
    """An InvalidParameter names the argument."""
    with pytest.raises(InvalidParameter, match=next(iter(options))):
        ke.rrt_star(problem_of(), rng=0, **options)


def test_angles_of_an_expansion_are_wrapped():
    """So the nearest of many nodes is found by their buckets."""
    world = ke.PolygonWorld([(-5, -5), (5, -5), (5, 5), (-5, 5)], [[(2, -2), (3, -2), (3, 3)]])
    problem = ke.Problem(ke.TwoLinkArm(1.5, 1.5, 0.1), world, (1.6, 0.1), (-1.6, 0.3))

    def wander(problem, tree, rng):
        q, nodes = problem.sample(rng), tree.nodes[: tree.size[0]]
        apart = [problem.distance(node, q) for node in nodes]
        assert apart[problem.nearest(tree, q)] == min(apart)
        node = int(rng.integers(len(nodes)))
        return node, nodes[node] + rng.uniform(-1, 1, 2)

    plan = ke.tree_roadmap(problem, wander, reach=0.01, max_nodes=300, rng=0)
    assert len(plan.tree.nodes) > 200 and np.abs(plan.tree.nodes).max() <= np.pi


@pytest.mark.parametrize(
    "answer",
    [
        None,
        3,
        (0,),
        (-1, (1.0, 1.0)),
        (99, (1.0, 1.0)),
        (0, (1.0,)),
        (True, (1.0, 1.0)),
        (0, "here"),
    ],
)
def test_an_expansion_that_answers_wrongly_is_refused(answer):
    """A named error is raised, also where the expansion is not a function."""
    with pytest.raises(ke.errors.KinoeduError):
        ke.tree_roadmap(problem_of(), lambda problem, tree, rng: answer, rng=0)
    with pytest.raises(InvalidParameter, match="expand"):
        ke.tree_roadmap(problem_of(), 3, rng=0)


def test_gamma_grows_with_the_space():
    """2 sqrt(1 + 1/2) sqrt(area / pi) in the plane."""
    for side in (1.0, 10.0):
        room = ke.PolygonWorld([(0, 0), (side, 0), (side, side), (0, side)])
        problem = ke.Problem(ke.Point(), room, (side / 4, side / 2), (side / 2, side / 2))
        assert sufficient_gamma(problem) == pytest.approx(side * np.sqrt(6 / np.pi))
