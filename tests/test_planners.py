"""Every planner, for every robot in every world: a plan is what its docstring says."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import kinoedu as ke
from kinoedu.errors import InvalidParameter
from kinoedu.files.movingai import read_scenario
from kinoedu.planners.grids.grid import plan_on_grid

GRID = Path(__file__).parent / "data" / "grid"
SQUARE = [(0, 0), (10, 0), (10, 10), (0, 10)]
WALL = [(4, 0), (6, 0), (6, 8), (4, 8)]
ROOM = ([(7, 4), (9, 4), (9, 7), (7, 7)], [[(7.5, 4.5), (8.5, 4.5), (8.5, 6.5), (7.5, 6.5)]])
WORLDS = {
    "polygons": ke.PolygonWorld(SQUARE, [WALL, ((2, 5), 0.7), ROOM]),
    "terrain": ke.Terrain(
        np.kron([[1, 0, 1, 1], [1, 0, 1, 0], [1, 1, 1, 1], [1, 0, 1, 1]], np.ones((5, 5))),
        resolution=0.5,
    ),
}
ROBOTS = {"point": ke.Point(), "disk": ke.Disk(0.3)}
PLANNERS = {
    "rrt": lambda problem, seed: ke.rrt(problem, rng=seed),
    "prm": lambda problem, seed: ke.prm(problem, n=400, rng=seed),
    "grid": lambda problem, seed: ke.plan_on_grid(problem),
}


def problem_of(world, robot):
    """A problem from one side of a world to the other."""
    return ke.Problem(ROBOTS[robot], WORLDS[world], (1.0, 1.0), (9.0, 1.0))


def length(path):
    """The length of a path."""
    return sum(float(np.sqrt(((b - a) ** 2).sum())) for a, b in pairwise(path))


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("robot", ROBOTS)
@pytest.mark.parametrize("planner", PLANNERS)
@pytest.mark.parametrize("seed", [0, 1])
def test_a_path_is_free_all_the_way(world, robot, planner, seed):
    """A path joins start and goal by free motions, costs its length, and depends on the seed."""
    problem = problem_of(world, robot)
    plan = PLANNERS[planner](problem, seed)
    assert plan.path is not None, plan.reason
    assert np.array_equal(plan.path[0], problem.start)
    assert np.array_equal(plan.path[-1], problem.goal)
    assert all(
        problem.is_free_path(a, b) and problem.is_free_path(b, a) for a, b in pairwise(plan.path)
    )
    assert plan.cost == pytest.approx(length(plan.path), rel=1e-12)
    assert np.array_equal(plan.path, PLANNERS[planner](problem, seed).path)


@pytest.mark.parametrize("world", WORLDS)
@pytest.mark.parametrize("robot", ROBOTS)
def test_a_tree_is_a_tree_of_free_steps(world, robot):
    """Each node but the root has an earlier parent, by a free motion no longer than the step."""
    problem = problem_of(world, robot)
    plan = ke.rrt(problem, step_size=0.8, rng=3)
    assert plan.tree.parent[0] == -1
    for node, parent in enumerate(plan.tree.parent[1:], start=1):
        assert 0 <= parent < node
        assert problem.is_free_path(plan.tree.nodes[parent], plan.tree.nodes[node])
        assert problem.distance(plan.tree.nodes[parent], plan.tree.nodes[node]) <= 0.8 * (1 + 1e-12)


@pytest.mark.parametrize("world", WORLDS)
def test_a_roadmap_has_free_edges_to_close_nodes(world):
    """Edges are free, distinct and no loops, and the k closest nodes of every node were tried."""
    problem = problem_of(world, "point")
    plan = ke.prm(problem, n=150, k=6, rng=0)
    nodes, edges = plan.roadmap
    assert len({frozenset(edge) for edge in edges.tolist()}) == len(edges)
    assert all(i != j and problem.is_free_path(nodes[i], nodes[j]) for i, j in edges)
    joined = {frozenset(edge) for edge in edges.tolist()}
    apart = np.sqrt(((nodes[:, None] - nodes[None]) ** 2).sum(axis=2))
    np.fill_diagonal(apart, np.inf)
    for i, row in enumerate(apart):
        for j in np.argsort(row)[:6]:
            assert (frozenset((i, int(j))) in joined) == problem.is_free_path(nodes[i], nodes[j])


@pytest.mark.parametrize("name", sorted(path.stem for path in GRID.glob("*.map")))
def test_grid_plans_have_the_length_of_every_benchmark_query(name):
    """All queries of the scenario are solved, with the optimal octile length to 1e-6, by moves that
    are free.
    """
    world = ke.read_world(GRID / f"{name}.map")
    for query in read_scenario(GRID / f"{name}-even-1.scen"):
        problem = ke.Problem(ke.Point(), world, query.start, query.goal)
        plan = ke.plan_on_grid(problem)
        assert plan.cost == pytest.approx(query.length, abs=1e-6)
        assert all(problem.is_free_path(a, b) for a, b in pairwise(plan.path))


def test_cells_and_motions_allow_the_same_grid_moves():
    """A grid checked by cells alone gives the same lengths as a grid whose motions are checked."""
    world = ke.read_world(GRID / "random-32-32-20.map")
    for query in read_scenario(GRID / "random-32-32-20-even-1.scen")[:20]:
        problem = ke.Problem(ke.Point(), world, query.start, query.goal)
        shifted = ke.Problem(ke.Point(), world, query.start, query.goal, clearance=1e-9)
        assert ke.plan_on_grid(problem).cost == pytest.approx(ke.plan_on_grid(shifted).cost)


def test_no_path_is_an_answer_with_a_reason():
    """For a goal in a closed room every planner returns no path, a reason, and what it built."""
    closed = ke.PolygonWorld(SQUARE, [ROOM])
    problem = ke.Problem(ke.Point(), closed, (1, 1), (8, 5.5))
    for plan in (
        ke.rrt(problem, max_nodes=200, rng=0),
        ke.prm(problem, n=100, rng=0),
        ke.plan_on_grid(problem),
    ):
        assert plan.path is None
        assert plan.cost == np.inf
        assert plan.reason
        assert "no path" in repr(plan)
        assert plan.tree is not None or plan.roadmap is not None
    assert len(ke.rrt(problem, max_nodes=200, rng=0).tree.nodes) == 200


def test_a_grid_tree_grows_in_order():
    """Rounding in the heuristic expands no cell twice: each node has one row, after its parent."""
    for shape, start, goal in [
        ((30, 30), (1.5, 1.5), (28.5, 20.5)),
        ((40, 25), (3.5, 38.5), (22.5, 0.5)),
    ]:
        plan = ke.plan_on_grid(
            ke.Problem(ke.Point(), ke.Terrain(np.ones(shape, bool)), start, goal)
        )
        assert len(np.unique(plan.tree.nodes, axis=0)) == len(plan.tree.nodes)
        assert (plan.tree.parent < np.arange(len(plan.tree.parent))).all()


@pytest.mark.parametrize(
    "answers",
    [
        {"steer": lambda a, b, step: np.zeros(42)},
        {"steer": lambda a, b, step: None},
        {"steer": lambda a, b, step: 1.0},
        {"sample": lambda rng: "here"},
        {"sample": lambda rng: np.array([np.nan, 0.0])},
        {"distance": lambda a, b: np.nan},
        {"distance": lambda a, b: -1.0},
        {"goal": (1.0, 1.0, 1.0)},
        {"start": ((0.0, 0.0),)},
    ],
    ids=lambda answers: next(iter(answers)),
)
@pytest.mark.parametrize("recorded", [False, True])
def test_wrong_answers_of_a_readers_own_problem_are_refused(answers, recorded):
    """By a named error; nothing of the wrong shape comes near compiled code."""

    class Plane:
        start, goal = (0.0, 0.0), (9.0, 9.0)
        sample = staticmethod(lambda rng: rng.uniform(0, 9, 2).tolist())
        distance = staticmethod(lambda a, b: float(np.sqrt(((np.asarray(a) - b) ** 2).sum())))
        steer = staticmethod(
            lambda a, b, step: [a[0] + 0.1 * (b[0] - a[0]), a[1] + 0.1 * (b[1] - a[1])]
        )
        is_free_path = staticmethod(lambda a, b: True)

    own = type(
        "Own",
        (Plane,),
        {name: staticmethod(a) if callable(a) else a for name, a in answers.items()},
    )()
    good = Plane()
    assert (
        ke.rrt(ke.Recorder(good) if recorded else good, step_size=1.0, max_nodes=50, rng=0).tree
        is not None
    )
    with pytest.raises(ke.errors.KinoeduError):
        ke.rrt(ke.Recorder(own) if recorded else own, step_size=1.0, max_nodes=50, rng=0)


def test_start_at_the_goal():
    """A path of cost 0 is found."""
    problem = ke.Problem(ke.Point(), WORLDS["polygons"], (1, 1), (1, 1))
    for planner in PLANNERS.values():
        assert planner(problem, 0).cost == 0.0


def test_recorder_sees_every_question_and_changes_nothing():
    """The tree, the path and the counts equal those of the compiled run; the log holds every motion
    that was checked.
    """
    problem = problem_of("polygons", "disk")
    for planner in ("rrt", "prm"):
        recorder = ke.Recorder(problem)
        seen, unseen = PLANNERS[planner](recorder, 5), PLANNERS[planner](problem, 5)
        assert np.array_equal(seen.path, unseen.path)
        assert seen.stats == unseen.stats
        assert recorder.counts()["is_free_path"] == unseen.stats["checks"]


def test_a_readers_own_problem_is_planned_on():
    """An object with the same methods, in a three-dimensional space not in this package."""

    class Ball:
        start, goal = (0.0, 0.0, -2.0), (0.0, 0.0, 2.0)

        def sample(self, rng):
            return rng.uniform(-3, 3, 3)

        def distance(self, a, b):
            return float(np.sqrt(((a - b) ** 2).sum()))

        def steer(self, a, b, step):
            return a + min(1.0, step / max(self.distance(a, b), 1e-300)) * (b - a)

        def is_free(self, q):
            return float((q**2).sum()) > 1.0

        def is_free_path(self, a, b):
            return all(self.is_free(a + t * (b - a)) for t in np.linspace(0, 1, 50))

    for plan in (ke.rrt(Ball(), step_size=0.5, rng=0), ke.prm(Ball(), n=60, rng=0)):
        assert plan.path is not None
        assert all(Ball().is_free_path(a, b) for a, b in pairwise(plan.path))


def test_an_object_that_cannot_answer_is_refused_by_name():
    """What is missing is named."""
    with pytest.raises(InvalidParameter, match="lacks start, goal, sample"):
        ke.rrt(object(), rng=0)


@pytest.mark.parametrize(
    "options",
    [
        {"step_size": 0},
        {"step_size": -1.0},
        {"step_size": np.nan},
        {"step_size": np.inf},
        {"step_size": "1"},
        {"step_size": True},
        {"step_size": 10**400},
        {"goal_bias": 1.5},
        {"goal_bias": -0.1},
        {"goal_bias": np.nan},
        {"max_nodes": 0},
        {"max_nodes": 2.5},
        {"max_nodes": 10**12},
        {"max_iterations": -1},
        {"rng": -1},
        {"rng": 1.5},
        {"rng": True},
        {"rng": "0"},
        {"rng": None},
    ],
    ids=str,
)
def test_rrt_refuses_tuning_outside_its_range(options):
    """An InvalidParameter names the argument."""
    name = next(iter(options))
    with pytest.raises(InvalidParameter, match=name):
        ke.rrt(problem_of("polygons", "point"), **{"rng": 0, **options})


@pytest.mark.parametrize(
    "ask",
    [
        lambda p: ke.prm(p, n=-1, rng=0),
        lambda p: ke.prm(p, k=0, rng=0),
        lambda p: ke.prm(p, n=10**6, k=10**6, rng=0),
        lambda p: ke.plan_on_grid(p, spacing=10**400),
        lambda p: ke.plan_on_grid(p, spacing=1e300),
        lambda p: ke.plan_on_grid(p, spacing=1e-300),
        lambda p: ke.plan_on_grid(p, spacing=0),
        lambda p: ke.plan_on_grid(p, spacing=1e-9),
        lambda p: plan_on_grid(ke.Recorder(p)),
    ],
)
def test_prm_and_grid_refuse_tuning_outside_its_range(ask):
    """An InvalidParameter is raised."""
    with pytest.raises(InvalidParameter):
        ask(problem_of("polygons", "point"))


def test_prm_without_samples_joins_start_and_goal():
    """n = 0 leaves two nodes, which is enough where nothing is between them."""
    open_world = ke.PolygonWorld(SQUARE)
    assert ke.prm(
        ke.Problem(ke.Point(), open_world, (1, 1), (9, 9)), n=0, rng=0
    ).cost == pytest.approx(8 * 2**0.5)


def test_prm_with_many_samples_at_one_place():
    """Coinciding configurations do not disturb the search for neighbours."""
    tight = ke.PolygonWorld([(0, 0), (1e-3, 0), (1e-3, 1e-3), (0, 1e-3)])
    plan = ke.prm(ke.Problem(ke.Point(), tight, (5e-4, 5e-4), (5e-4, 5e-4)), n=30, k=5, rng=0)
    assert plan.path is not None


def test_a_finer_grid_comes_closer():
    """On polygons the spacing is the grid's; a finer one finds a path that is not longer by more
    than rounding.
    """
    problem = problem_of("polygons", "point")
    coarse, fine = ke.plan_on_grid(problem, spacing=0.5), ke.plan_on_grid(problem, spacing=0.1)
    assert fine.cost < coarse.cost + 1.0
