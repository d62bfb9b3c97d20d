"""Planners that drive a car: every trajectory is replayed from its controls and checked."""

import itertools
import math
import sys
import types
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import shapely

import kinoedu as ke
from kinoedu.collision import is_free_trajectory
from kinoedu.curves import integrators
from kinoedu.errors import InvalidParameter, InvalidPoint
from kinoedu.planners.driving.common import as_car_problem, begin_tree, closest_step, next_target
from kinoedu.planners.driving.parameters import GoalBiasRecord, RefinementRecord, as_drives
from kinoedu.planners.driving.sst import Sparse, add_witness, cheapest_near, nearest_witness
from kinoedu.planners.problem_input import new_tree
from kinoedu.spaces.angles import angle_difference

INSIDE = [(10, 10), (290, 10), (290, 290), (10, 290)]  # the map's walls are 10 thick
SQUARE = [(75, 75), (100, 75), (100, 100), (75, 100)]
SLANTED = [(125, 175), (225, 175), (235, 165), (135, 165)]
WORLD, CAR = ke.PolygonWorld(INSIDE, [SQUARE, SLANTED]), ke.Car(30, 10, 20)
PROBLEM = ke.Problem(CAR, WORLD, (250, 250, 0), (50, 50, np.pi / 2))
EASY = ke.Problem(CAR, ke.PolygonWorld(INSIDE), (60, 60, 0), (120, 90, 0.8))
SOLID = shapely.union_all(
    [
        shapely.box(-200, -200, 500, 500) - shapely.Polygon(INSIDE),
        *map(shapely.Polygon, (SQUARE, SLANTED)),
    ]
)


def apart(a: Any, b: Any) -> float:
    """The greatest difference of two poses in any coordinate."""
    return max(math.dist(a[:2], b[:2]), abs(angle_difference(a[2], b[2])))


def by_hand(
    start: Any, controls: Any, durations: Any, wheelbase: float, n: int = 200
) -> np.ndarray:
    """The poses (m, 3) of a drive, n for each control, by turning round the centre of each arc."""
    poses = [np.asarray(start, float)]
    for (v, phi), t in zip(controls, durations):
        x, y, theta = poses[-1]
        for part in np.linspace(0, t, n)[1:]:
            if phi == 0.0:
                poses.append(
                    np.array(
                        [x + v * part * math.cos(theta), y + v * part * math.sin(theta), theta]
                    )
                )
                continue
            r, turn = wheelbase / math.tan(phi), v * part * math.tan(phi) / wheelbase
            cx, cy = x - r * math.sin(theta), y + r * math.cos(theta)
            poses.append(
                np.array(
                    [cx + r * math.sin(theta + turn), cy - r * math.cos(theta + turn), theta + turn]
                )
            )
    return np.array(poses)


def bodies(poses: Any, car: Any = CAR) -> Any:
    """The car's outlines at many poses, as shapely's polygons."""
    cos, sin, (x, y) = np.cos(poses[:, 2:]), np.sin(poses[:, 2:]), car.outline.T
    return shapely.polygons(
        np.stack([poses[:, :1] + cos * x - sin * y, poses[:, 1:2] + sin * x + cos * y], axis=-1)
    )


def check_driven(plan: Any, problem: Any = PROBLEM, solid: Any = SOLID) -> None:
    """The controls, replayed without the library, lead along the path to the goal, steered and
    driven as the car can, and free.
    """
    there = plan.trajectory
    assert (np.abs(there.controls[:, 1]) <= CAR.max_steering).all() and np.isin(
        there.controls[:, 0], CAR.speeds
    ).all()
    assert (there.durations > 0.0).all()
    poses = by_hand(problem.start, there.controls, there.durations, CAR.wheelbase)
    assert apart(poses[-1], there.poses[-1]) < 1e-9 and np.array_equal(
        there.poses[0], problem.start
    )
    assert not shapely.intersects(bodies(poses), solid).any()
    assert is_free_trajectory(CAR, problem.world, there)
    if plan.path is None:
        assert plan.cost == np.inf and plan.reason
        return
    assert np.array_equal(plan.path, there.poses) and plan.cost == pytest.approx(there.length)
    assert math.dist(poses[-1][:2], problem.goal[:2]) <= 5 + 1e-9
    assert abs(angle_difference(poses[-1][2], problem.goal[2])) <= math.radians(15) + 1e-9


def test_twenty_of_twenty() -> None:
    """On the map of the project report, from its first start to its first goal, within 5,000
    iterations; every drive is checked.
    """
    for seed in range(20):
        plan = ke.kinodynamic_rrt(PROBLEM, max_iterations=5000, rng=seed)
        assert plan.path is not None
        check_driven(plan)


@pytest.mark.parametrize(
    "planner",
    [ke.kinodynamic_rrt, ke.kinodynamic_prm, ke.sst],
    ids=lambda planner: planner.__name__,
)
def test_what_was_built_is_driven(planner: Any) -> None:
    """Each node is where its control leads from its parent, and each drive is free; with a seed all
    is the same again.
    """
    plan, again = (planner(PROBLEM, rng=3) for _ in range(2))
    check_driven(plan)
    built = plan.roadmap or plan.tree
    edges = (
        built.edges
        if plan.roadmap
        else np.stack([built.parent, np.arange(len(built.nodes))], axis=1)[1:]
    )
    drives = zip(built.controls[-len(edges) :], built.durations[-len(edges) :])
    for (u, w), (control, t) in list(zip(edges, drives))[::7]:
        poses = by_hand(built.nodes[u], [control], [t], CAR.wheelbase, 40)
        assert apart(poses[-1], built.nodes[w]) < 1e-9
        assert not shapely.intersects(bodies(poses), SOLID).any()
    assert all(np.array_equal(one, other) for one, other in zip(built, again.roadmap or again.tree))


@pytest.mark.parametrize("planner", ["kinodynamic_rrt", "kinodynamic_prm", "sst"])
def test_interpreted_is_compiled(planner: str) -> None:
    """A Recorder runs the interpreted code: the tree is the same, and the log has every drive."""
    few = {
        "kinodynamic_rrt": {"max_iterations": 8},
        "kinodynamic_prm": {"n": 5},
        "sst": {"max_iterations": 60},
    }[planner]
    recorder = ke.Recorder(EASY)
    slow, fast = (getattr(ke, planner)(problem, rng=1, **few) for problem in (recorder, EASY))
    for one, other in zip(slow.roadmap or slow.tree, fast.roadmap or fast.tree):
        assert np.array_equal(one, other)
    assert recorder.counts()["is_free_drive"] == fast.stats["checks"] == slow.stats["checks"] > 0


def test_steps_passed_over_are_never_the_closest() -> None:
    """The closest step is that of simulating every one of the 150."""
    problem, rng = as_car_problem(PROBLEM, "a test", None), np.random.default_rng(5)
    drives, there = as_drives(problem, ke.Drives()), np.empty(3)
    assert (drives.steps, drives.time_step) == (150, pytest.approx(0.1))
    for _ in range(300):
        q, q_rand = problem.sample(rng), problem.sample(rng)
        if rng.random() < 0.7:
            q_rand = q + rng.normal(0, (8, 8, 0.5))
        v, phi = problem.control(rng)
        distances = []
        for k in range(1, 151):
            problem.drive(q, v, phi, k * drives.time_step, there)
            distances.append(problem.distance(there, q_rand))
        step, least = closest_step(problem, q, q_rand, v, phi, drives, np.inf, there)
        assert (step, least) == (1 + int(np.argmin(distances)), min(distances))


def test_same_place_other_heading() -> None:
    """The special case: turned round on the spot, which takes many moves."""
    problem = ke.Problem(CAR, ke.PolygonWorld(INSIDE), (150, 150, 0), (150, 150, np.pi))
    solid = shapely.box(-200, -200, 500, 500) - shapely.Polygon(INSIDE)
    for plan in (ke.kinodynamic_rrt(problem, max_iterations=5000, rng=0), ke.sst(problem, rng=0)):
        assert plan.path is not None
        check_driven(plan, problem, solid)
        assert plan.cost > 40.0


def test_there_already_and_never() -> None:
    """At the goal from the start: a path of one pose. Walled in: no path, a reason, and the drive
    that came nearest.
    """
    plan = ke.kinodynamic_rrt(ke.Problem(CAR, WORLD, (150, 100, 0), (152, 100, 0.1)), rng=0)
    assert (
        plan.path.shape == (1, 3)
        and plan.cost == 0.0
        and np.array_equal(plan.trajectory.at([0.0, 9.0]), plan.path[[0, 0]])
    )
    world = ke.PolygonWorld(INSIDE, [[(140, 10), (141, 10), (141, 290), (140, 290)]])
    problem = ke.Problem(CAR, world, (50, 50, 0), (250, 50, 0))
    for planner, few in (
        (ke.kinodynamic_rrt, {"max_iterations": 300}),
        (ke.kinodynamic_prm, {"n": 150}),
        (ke.sst, {}),
    ):
        plan = planner(problem, rng=0, **few)
        assert plan.path is None and "nearest one" in plan.reason
        check_driven(plan, problem, shapely.box(140, 10, 141, 290))
        assert plan.trajectory.poses[-1][0] > 90


def test_headings_wrap() -> None:
    """A goal a hair beyond half a turn away from a heading is as near as one a hair before it."""
    world = ke.PolygonWorld(INSIDE)
    for heading in (np.pi - 0.1, -np.pi + 0.1):
        plan = ke.kinodynamic_rrt(
            ke.Problem(CAR, world, (150, 150, np.pi - 1e-9), (152, 150, heading)), rng=0
        )
        assert len(plan.path) == 1


def test_longer_search_is_cheaper() -> None:
    """SST's tree is the same as far as it goes, so more iterations never cost more; each node keeps
    the cost of its drives.
    """
    costs = [ke.sst(EASY, max_iterations=n, rng=2).cost for n in (2000, 8000, 30_000)]
    assert costs[0] >= costs[1] >= costs[2] > 62
    assert costs[2] < 110


def test_a_finer_tree_reaches_a_tight_goal() -> None:
    """Nodes lie closer near the goal, drives are shorter, and more seeds find a path."""
    problem = ke.Problem(CAR, WORLD, (60, 240, 0), (180, 210, 0))
    finer = {"refinement": ke.Refinement()}
    found, near, longest = [], [], []
    for options in ({}, finer):
        plans = [ke.sst(problem, max_iterations=1000, rng=seed, **options) for seed in range(6)]
        trees = [plan.tree for plan in plans]
        from_goal = [np.hypot(*(tree.nodes[:, :2] - problem.goal[:2]).T) for tree in trees]
        found.append(sum(plan.path is not None for plan in plans))
        near.append(sum(int((d < 30.0).sum()) for d in from_goal))
        into = [tree.durations[1:][d[tree.parent[1:]] < 20.0] for tree, d in zip(trees, from_goal)]
        longest.append(np.concatenate(into).max())
        for plan in plans:
            check_driven(plan, problem, SOLID)
    assert found[1] > found[0] and near[1] > near[0]
    assert longest[1] <= 60.0 * 0.5 < longest[0]


@pytest.mark.parametrize("m", [1, 5, 300])
def test_the_nearest_witness_and_the_cheapest_node_near_it_are_what_brute_force_finds(m) -> None:
    """By buckets of any size; a node is within a radius of its witness. Near the goal the radius
    and the reach are smaller.
    """
    rng, problem = np.random.default_rng(m), as_car_problem(EASY, "sst", None)
    weight, finer = problem.space.weight[2], RefinementRecord(80.0, 0.2, 0.5)
    for radius, reach, buckets in ((90.0, 100.0, 1), (30.0, 60.0, m), (60.0, 1.0, 4 * m)):
        witnesses = np.array([problem.sample(rng) for _ in range(m)])
        off = 0.57 * radius * rng.uniform(-1, 1, (m, 3)) / (1, 1, weight)
        nodes, cost = witnesses + off, rng.random(m)
        growth = begin_tree(problem, m + 1)
        trees = new_tree(problem, m, buckets), np.zeros(m, np.int64)
        sparse = Sparse(*trees, cost, radius, reach, finer)
        growth.tree.nodes[:m] = nodes
        for node in range(m):
            add_witness(sparse, witnesses[node], node)
        for _ in range(60):
            q = problem.sample(rng)
            share = np.clip(problem.distance(q, problem.goal) / 80.0, 0.2, 1.0)
            apart = np.array([problem.distance(one, q) for one in nodes])
            within = np.where(apart <= share * reach, cost, np.inf)
            expected = within.argmin() if np.isfinite(within).any() else apart.argmin()
            assert cheapest_near(problem, growth, sparse, q) == expected
            apart = np.array([problem.distance(one, q) for one in witnesses])
            found = nearest_witness(problem, sparse, q)
            assert found == (apart.argmin() if apart.min() <= share * radius else -1)


@pytest.mark.parametrize("share", [0.6, 2 / 3, 0.4, 0.1, 1 / 150])
def test_no_drive_is_longer_than_its_duration(share):
    """Whatever the time step: a part of a step is left out, and rounding loses no step."""
    drives = as_drives(EASY, ke.Drives(duration=0.9, time_step=0.9 * share))
    assert drives.steps == int(1 / share + 1e-6)
    assert drives.steps * drives.time_step <= 0.9 * (1 + 1e-9)


def test_edges_are_directed() -> None:
    """A roadmap grown by a car without a reverse gear is searched forward only: replayed, every
    route still leads there.
    """
    problem = ke.Problem(
        ke.Car(30, 10, 20, speeds=(1,)), ke.PolygonWorld(INSIDE), (60, 150, 0), (220, 150, 0)
    )
    plan = ke.kinodynamic_prm(problem, n=600, rng=0)
    assert plan.path is not None and (plan.trajectory.controls[:, 0] == 1).all()
    check_driven(plan, problem, shapely.box(-200, -200, 500, 500) - shapely.Polygon(INSIDE))


def test_alternative_routes() -> None:
    """They differ, the first is the plan's own, and each holds by itself."""
    plan = ke.kinodynamic_prm(EASY, n=2000, rng=0)
    routes = ke.alternative_routes(plan, 3)
    assert len(routes) == 3 and routes[0].cost == plan.cost
    for one, other in pairwise(routes):
        assert one.cost <= other.cost and not np.array_equal(one.path, other.path)
    for one in routes:
        check_driven(one, EASY, shapely.box(-200, -200, 500, 500) - shapely.Polygon(INSIDE))
    curves = ke.prm(PROBLEM, n=150, rng=0)
    first, second = ke.alternative_routes(curves, 2, penalty=5)
    assert first.cost == pytest.approx(curves.cost) and second.cost > first.cost
    assert all(PROBLEM.is_free_path(a, b) for a, b in zip(second.path, second.path[1:]))
    assert ke.alternative_routes(ke.prm(PROBLEM, n=0, rng=0)) == []


def test_curves_as_controls() -> None:
    """A path of Reeds and Shepp's curves, given as controls, leads to the goal itself; a plan's own
    trajectory is kept.
    """
    plan = ke.rrt(PROBLEM, rng=0)
    there = ke.trajectory_along(plan)
    poses = by_hand(there.start, there.controls, there.durations, CAR.wheelbase)
    assert apart(poses[-1], PROBLEM.goal) < 1e-6 and there.length == pytest.approx(plan.cost)
    assert not shapely.intersects(bodies(poses), SOLID).any()
    assert is_free_trajectory(CAR, WORLD, there) and not is_free_trajectory(
        CAR, WORLD, there, 100.0
    )
    driving = ke.kinodynamic_rrt(EASY, rng=0)
    assert ke.trajectory_along(driving) is driving.trajectory
    with pytest.raises(InvalidParameter):
        ke.trajectory_along(ke.rrt(ke.Problem(ke.Point(), WORLD, (20, 20), (280, 280)), rng=0))


def test_best_within(monkeypatch: pytest.MonkeyPatch) -> None:
    """By a clock that gains a second at each look: as many plans as there is time for, and of them
    the cheapest.
    """
    ticks, costs = itertools.count(), iter([5.0, np.inf, 3.0, 4.0, 1.0])
    clock = types.SimpleNamespace(monotonic=lambda: next(ticks))
    monkeypatch.setattr(sys.modules["kinoedu.planners.best_within"], "time", clock)
    best = ke.best_within(12, lambda rng: ke.Plan(np.zeros((1, 2)), next(costs)), rng=0)
    assert (best.cost, best.stats["plans"]) == (3.0, 4)
    assert (
        ke.best_within(0.5, lambda rng: ke.Plan(None, np.inf, reason="none"), rng=0).stats["plans"]
        == 1
    )


def test_trajectories() -> None:
    """Any time on the way lies on the arcs; what cannot be driven is refused."""
    controls, durations = [(1, 0.3), (-1, -0.2), (1, 0.0)], [30.0, 0.0, 12.5]
    there = ke.Trajectory(CAR, (5, 6, 3), controls, durations)
    assert (there.duration, there.length) == (42.5, 42.5) and there.poses.shape == (4, 3)
    for t in (-1.0, 0.0, 7.0, 30.0, 30.1, 42.5, 99.0):
        held = min(max(t, 0.0), 42.5)
        expected = by_hand(
            (5, 6, 3), [(1, 0.3), (1, 0.0)], [min(held, 30.0), max(held - 30.0, 0.0)], 20
        )[-1]
        assert apart(there.at(t), expected) < 1e-9
    assert there.at([1.0, 2.0]).shape == (2, 3) and ke.Trajectory(CAR, (5, 6, 3), [], []).at(
        1.0
    ).tolist() == [5, 6, 3]
    for wrong in ([(1, 0, 0)], [1]), ([(1, 0)], [1, 2]), ([(1, 1)], [1]), ([(1, 0)], [-1]):
        with pytest.raises(InvalidParameter):
            ke.Trajectory(CAR, (0, 0, 0), *wrong)
    with pytest.raises(InvalidPoint):
        ke.Trajectory(CAR, (0, 0, np.nan), [(1, 0)], [1])
    with pytest.raises(InvalidParameter):
        ke.Trajectory(ke.Point(), (0, 0, 0), [(1, 0)], [1])


@pytest.mark.parametrize(
    ("rule", "order"),
    [(integrators.euler, 1), (integrators.runge_kutta, 4)],
    ids=("Euler", "Runge and Kutta"),
)
def test_error_orders(rule: Any, order: int) -> None:
    """Twice as many steps: half the error by Euler's rule, a sixteenth by Runge's and Kutta's; none
    in closed form.
    """
    pose, v, curvature, t = (1.0, 2.0, 0.5), -1.5, 0.4, 4.0
    end = by_hand(pose, [(v, math.atan(curvature))], [t], 1.0)[-1]
    errors = [math.dist(rule(pose, v, curvature, t, n)[-1][:2], end[:2]) for n in (20, 40, 80)]
    for coarse, fine in pairwise(errors):
        assert math.log2(coarse / fine) == pytest.approx(order, abs=0.1)
    for n in (1, 7):
        assert apart(integrators.exact(pose, v, curvature, t, n)[-1], end) < 1e-12


@pytest.mark.parametrize(
    "rule",
    [integrators.euler, integrators.runge_kutta, integrators.exact],
    ids=lambda f: f.__name__,
)
def test_headings_of_a_rule_are_wrapped(rule: Any) -> None:
    """A car that turns round three times has headings from -pi up to pi, each step's turn apart."""
    headings = rule((0.0, 0.0, 4.0), 1.0, 1.0, 6.0 * math.pi, 60)[:, 2]
    assert (headings >= -math.pi).all() and (headings < math.pi).all()
    turned = np.mod(np.diff(headings), 2.0 * math.pi)
    assert turned == pytest.approx(np.full(60, math.pi / 10))


def test_one_centre_for_all_wheels() -> None:
    """Ackermann: the axes of all four wheels meet in the point round which the car turns; driving
    straight there is none.
    """
    for pose, phi in (((0, 0, 0), 0.5), ((3, -2, 2.5), -0.7), ((1, 1, -3), 0.01)):
        centre = CAR.turning_centre(pose, phi)
        cos, sin = math.cos(pose[2]), math.sin(pose[2])
        wheels = [(0, 5, 0.0), (0, -5, 0.0), *zip((20, 20), (5, -5), CAR.wheel_angles(phi))]
        for along, aside, angle in wheels:
            x, y = pose[0] + cos * along - sin * aside, pose[1] + sin * along + cos * aside
            rolling = pose[2] + angle
            across = math.cos(rolling) * (centre[0] - x) + math.sin(rolling) * (centre[1] - y)
            assert abs(across) < 1e-9 * math.dist(centre, (x, y))
        moved = CAR.move(pose, 1, phi, 30)
        assert math.dist(moved[:2], centre) == pytest.approx(math.dist(pose[:2], centre))
    assert np.isinf(CAR.turning_centre((0, 0, 0), 0)).all() and CAR.wheel_angles(0) == (0, 0)


def test_nonsense_is_refused_by_name() -> None:
    """Arguments out of range, and robots that are not driven, are refused."""
    for record, name, value in (
        (ke.Drives, "trials", 0),
        (ke.Drives, "duration", 0),
        (ke.Drives, "time_step", -1),
        (ke.Drives, "batches", 0),
        (ke.GoalBias, "goal_every", -1),
        (ke.GoalBias, "region_every", 1.5),
        (ke.GoalBias, "region", -1),
        (ke.GoalBias, "region_turn", "wide"),
        (ke.GoalRegion, "tolerance", -1),
        (ke.GoalRegion, "turn_tolerance", np.nan),
        (ke.Sparsity, "radius", 0),
        (ke.Sparsity, "reach", np.nan),
        (ke.Refinement, "region", 0),
        (ke.Refinement, "radius", 0),
        (ke.Refinement, "duration", 1.01),
    ):
        with pytest.raises(InvalidParameter, match=f"^{name} must be"):
            record(**{name: value})
    for name, value, words in (
        ("drives", ke.Drives(time_step=99), "time_step 99 must not be longer than the duration 15"),
        ("drives", {"trials": 8}, r"drives must be Drives\(...\), got"),
        ("goal_bias", 0.05, r"goal_bias must be GoalBias\(...\), got 0.05"),
        ("goal_region", ke.Drives(), r"goal_region must be GoalRegion\(...\), got"),
        ("turn_weight", 0, "turn_weight must be"),
        ("max_iterations", 1.5, "max_iterations must be"),
    ):
        with pytest.raises(InvalidParameter, match=words):
            ke.kinodynamic_rrt(PROBLEM, rng=0, **{name: value})
    for name in ("sparsity", "refinement"):
        words = rf"{name} must be {name.capitalize()}\(...\), got 0.05"
        with pytest.raises(InvalidParameter, match=words):
            ke.sst(PROBLEM, rng=0, **{name: 0.05})
    for planner in (ke.kinodynamic_rrt, ke.kinodynamic_prm, ke.sst):
        with pytest.raises(InvalidParameter, match="Car"):
            planner(ke.Problem(ke.Point(), WORLD, (20, 20), (280, 280)), rng=0)
    for plan in (ke.rrt(PROBLEM, rng=0), None):
        with pytest.raises(InvalidParameter, match="roadmap"):
            ke.alternative_routes(plan)
    with pytest.raises(InvalidParameter, match="cannot be shortened"):
        ke.shortcut(ke.kinodynamic_rrt(EASY, rng=0), rng=0)


def test_targets_are_the_goal_or_near_it_as_often_as_asked():
    """In the region of the goal every second time, and the goal itself every third of the rest."""
    room = ke.PolygonWorld([(0, 0), (99, 0), (99, 99), (0, 99)])
    problem = ke.Problem(ke.Car(2, 1, 1.4), room, (9, 9, 0), (80, 70, 1))
    bias, rng = GoalBiasRecord(3, 2, 4.0, 0.5), np.random.default_rng(0)
    off = np.array([next_target(problem, bias, k, rng) - problem.goal for k in range(1, 601)])
    region, rest = off[1::2], off[::2]
    far = np.hypot(*region[:, :2].T)
    assert 3.9 < far.max() <= 4.0 and 0.4 < np.abs(region[:, 2]).max() <= 0.5
    assert np.abs(region[:, :2].mean(axis=0)).max() < 0.5
    assert not rest[1::3].any() and rest[0::3].any(axis=1).all() and rest[2::3].any(axis=1).all()
