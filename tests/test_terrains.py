"""Terrains with costs: integrals along motions, plans, landscapes, heights, and changing worlds."""

from fractions import Fraction

import numpy as np
import pytest

import kinoedu as ke
from kinoedu.collision.costs import integral
from kinoedu.errors import InvalidParameter, InvalidWorld
from kinoedu.files import read_heights
from kinoedu.worlds import LANDSCAPES, clearance_of_cells, hills, landscape, roughness, slope
from kinoedu.worlds.landscapes import GOAL, START


def exact_integral(cost, a, b):
    """The integral in rational arithmetic, over its length; along a side the lower cost counts.

    The motion is divided at every integer x and y.
    """
    (ax, ay), (bx, by) = [tuple(map(Fraction, p)) for p in (a, b)]
    shares = {Fraction(0), Fraction(1)}
    for p, q in ((ax, bx), (ay, by)):
        if p != q:
            shares |= {t for k in range(20) if 0 < (t := (k - p) / (q - p)) < 1}
    shares, total = sorted(shares), Fraction(0)
    for t, s in zip(shares, shares[1:]):
        x, y = (p + (q - p) * (s + t) / 2 for p, q in ((ax, bx), (ay, by)))
        columns = {int(x)} | ({int(x) - 1} if x == int(x) else set())
        rows = {int(y)} | ({int(y) - 1} if y == int(y) else set())
        beside = [
            cost[j, i]
            for j in rows
            for i in columns
            if 0 <= j < len(cost) and 0 <= i < len(cost[0])
        ]
        total += (s - t) * Fraction(float(min(beside)))
    return float(total) * float(np.hypot(float(bx - ax), float(by - ay)))


@pytest.mark.parametrize("body", [integral, integral.py_func])
def test_the_integral_is_exact(body):
    """On random motions, and on motions through corners, along sides, and in one cell."""
    rng = np.random.default_rng(0)
    cost = rng.integers(1, 9, (7, 11)).astype(float)
    for number in range(400):
        a, b = rng.uniform((0.01, 0.01), (10.99, 6.99), (2, 2))
        if number % 4 == 1:
            a, b = np.rint(2 * a) / 2, np.rint(2 * b) / 2  # corners and sides
        elif number % 4 == 2:
            b[number // 4 % 2] = a[number // 4 % 2]
        elif number % 4 == 3:
            a, b = np.rint(4 * a) / 4, np.rint(4 * b) / 4
        a, b = np.clip(a, 0.25, (10.75, 6.75)), np.clip(b, 0.25, (10.75, 6.75))
        assert body(cost, *a, *b) == pytest.approx(exact_integral(cost, a, b), rel=1e-12)


@pytest.mark.parametrize("body", [integral, integral.py_func])
@pytest.mark.parametrize("far", [2.0, 1e6, 1e15, 1e19, 1e140])
def test_a_motion_far_outside_costs_infinitely_much_at_once(body, far):
    """No matter how many cells it would cross."""
    cost = np.ones((2, 3))
    for a, b in (((0.5, 0.5), (3.0 + far, 1.0)), ((-far, 0.5), (-1.5 * far, 0.7))):
        assert body(cost, *a, *b) == body(cost, *b, *a) == np.inf
    assert body(cost, far, far, far, far) == 0.0


def test_the_integral_is_additive_and_no_less_than_the_length():
    """RRT* and A* rely on these laws."""
    rng = np.random.default_rng(1)
    terrain = ke.Terrain(
        np.ones((20, 30)), cost=1.0 + rng.exponential(3.0, (20, 30)), resolution=0.5, origin=(-3, 4)
    )
    problem = ke.Problem(ke.Point(), terrain, (0, 5), (10, 13))
    for _ in range(200):
        a, b = rng.uniform(terrain.lo, terrain.hi, (2, 2))
        whole, c = problem.motion_cost(a, b), a + rng.random() * (b - a)
        assert problem.motion_cost(a, c) + problem.motion_cost(c, b) == pytest.approx(
            whole, rel=1e-9
        )
        assert problem.motion_cost(b, a) == pytest.approx(whole, rel=1e-12)
        assert whole >= problem.distance(a, b) * (1 - 1e-12)


def test_a_cost_of_one_is_the_length_and_without_costs_nothing_changes():
    """Trees and costs are the same as on a terrain without costs."""
    plain = landscape("rocks", 3)
    level = ke.Terrain(plain.free, cost=np.ones_like(plain.free, float))
    problems = [ke.Problem(ke.Point(), world, START, GOAL) for world in (plain, level)]
    for planner in (ke.rrt_star, ke.prm):
        how = {"max_nodes": 400} if planner is ke.rrt_star else {"n": 200}
        one, other = (planner(problem, rng=5, **how) for problem in problems)
        assert other.cost == pytest.approx(one.cost, rel=1e-9)
        np.testing.assert_array_equal(one.path, other.path)
    assert ke.plan_on_grid(problems[1]).cost == pytest.approx(
        ke.plan_on_grid(problems[0]).cost, rel=1e-12
    )


def ford():
    """A band of mud with a dry crossing at its left end."""
    cost = np.ones((40, 40))
    cost[15:25, 6:] = 9.0
    return ke.Problem(
        ke.Point(), ke.Terrain(np.ones((40, 40)), cost=cost), (35.5, 5.5), (35.5, 35.5)
    )


def test_planners_go_round_where_that_costs_less():
    """A*, PRM and RRT* find the crossing, and the cost of each plan is the cost of its path.

    The straight path costs more.
    """
    problem = ford()
    straight = ke.path_cost(problem, [problem.start, problem.goal])
    assert straight == pytest.approx(20 + 10 * 9)
    best = 2 * np.hypot(29.5, 9.5) + 10
    plans = [
        ke.plan_on_grid(problem),
        ke.prm(problem, n=600, rng=0),
        ke.rrt_star(problem, max_nodes=3000, rng=0),
    ]
    for plan, factor in zip(plans, (1.0824, 1.15, 1.15)):
        assert best * (1 - 1e-9) <= plan.cost <= best * factor + 1.5, plan.planner
        assert plan.cost == pytest.approx(ke.path_cost(problem, plan.path))
        assert plan.path[:, 0].min() < 7.0
    rough = ke.rrt(problem, rng=0)
    assert ke.shortcut(rough, rng=0).cost <= rough.cost


def test_a_disk_pays_at_its_centre_and_other_robots_are_refused():
    """Robots without a single reference position raise InvalidParameter."""
    assert (
        ke.plan_on_grid(ke.Problem(ke.Disk(1.0), ford().world, (35.5, 5.5), (35.5, 35.5))).cost < 80
    )
    square = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    with pytest.raises(InvalidParameter, match="costs"):
        ke.Problem(ke.RigidPolygon(square), ford().world, (35.5, 5.5, 0), (35.5, 35.5, 0))


@pytest.mark.parametrize(
    "cost",
    [
        np.zeros((2, 2)),
        np.full((2, 2), np.nan),
        np.ones((3, 2)),
        [[1, 2], [3]],
        "mud",
        np.full((2, 2), 1e12),
    ],
)
def test_costs_that_make_no_sense_are_refused(cost):
    """Below one, not a number, of another shape, infinite."""
    with pytest.raises(InvalidWorld):
        ke.Terrain(np.ones((2, 2)), cost=cost)


def test_costs_are_those_of_a_point_of_the_body():
    """A polygon beside its reference point is refused where cells have costs, and only there."""
    free = np.ones((6, 6), bool)
    free[2, 2] = False
    beside = ke.TranslatingPolygon([(1.0, -0.2), (1.4, -0.2), (1.2, 0.2)])
    around = ke.TranslatingPolygon([(-0.2, -0.2), (0.2, -0.2), (0.0, 0.2)])
    costs = ke.Terrain(free, cost=np.ones((6, 6)))
    with pytest.raises(InvalidParameter, match=r"vertices around \(0, 0\)"):
        ke.Problem(beside, costs, (-0.5, 4.5), (3.5, 4.5))
    assert ke.rrt(ke.Problem(beside, ke.Terrain(free), (-0.5, 4.5), (3.5, 4.5)), rng=0).cost < 9
    assert ke.rrt(ke.Problem(around, costs, (0.5, 4.5), (4.5, 0.5)), rng=0).cost < 12


def test_scenes_keep_costs(tmp_path):
    """Costs are written and read back."""
    problem = ford()
    ke.write_scene(problem, tmp_path / "mud.json")
    np.testing.assert_array_equal(
        ke.read_scene(tmp_path / "mud.json").world.cost, problem.world.cost
    )


@pytest.mark.parametrize("kind", LANDSCAPES)
def test_landscapes_are_reproducible_and_have_a_way(kind):
    """Equal for equal seeds, different for others; A* finds a path on each."""
    one, again, other = (landscape(kind, seed).free for seed in (0, 0, 1))
    np.testing.assert_array_equal(one, again)
    assert (one != other).any()
    for seed in range(4):
        assert (
            ke.plan_on_grid(ke.Problem(ke.Point(), landscape(kind, seed), START, GOAL)).path
            is not None
        )


@pytest.mark.parametrize("kind", ["mountains", ["rocks"], None])
def test_an_unknown_landscape_is_refused(kind):
    """The message names the landscapes that there are, whatever the kind is."""
    with pytest.raises(InvalidParameter, match="kind must be one of rocks, craters"):
        landscape(kind)


@pytest.mark.parametrize("highest", [-1, np.nan, "high", None])
def test_hills_of_no_height_are_refused(highest):
    """The highest hill must be a number of zero or more."""
    with pytest.raises(InvalidParameter, match="highest must be a number, zero or more"):
        hills(highest=highest)


def test_slope_and_roughness_of_known_ground():
    """A plane has its slope and no roughness; noise has its standard deviation."""
    y, x = np.indices((30, 40)) * 0.5
    plane = 3.0 * x - 4.0 * y + 7.0
    np.testing.assert_allclose(slope(plane, resolution=0.5), 5.0, rtol=1e-12)
    np.testing.assert_allclose(roughness(plane, reach=2), 0.0, atol=1e-6)
    noise = np.random.default_rng(0).normal(0.0, 2.0, (60, 60))
    assert np.mean(roughness(noise, reach=4)[8:-8, 8:-8]) == pytest.approx(2.0, rel=0.05)
    with pytest.raises(InvalidWorld):
        slope([1.0, 2.0])
    with pytest.raises(InvalidWorld):
        roughness(plane, reach=30)
    with pytest.raises(InvalidParameter):
        slope(plane, resolution=0)


def test_roughness_is_the_scatter_about_the_fitted_plane():
    """By least squares in each window."""
    ground = hills(2)[:12, :15]
    columns = np.column_stack([np.ones(25), *np.mgrid[-2:3, -2:3].reshape(2, -1)])
    found = roughness(ground, reach=2)
    for j, i in ((2, 2), (5, 7), (9, 12)):
        window = ground[j - 2 : j + 3, i - 2 : i + 3].ravel()
        rest = window - columns @ np.linalg.lstsq(columns, window, rcond=None)[0]
        assert found[j, i] == pytest.approx(np.sqrt(np.mean(rest**2)), rel=1e-6)


def test_clearance_of_cells_by_brute_force():
    """The nearest centre of a blocked cell, including cells outside."""
    free = np.random.default_rng(3).random((9, 12)) > 0.15
    blocked = np.argwhere(~np.pad(free, 1)) - 1
    for (j, i), far in np.ndenumerate(clearance_of_cells(free, resolution=2.0)):
        assert far == pytest.approx(2.0 * np.sqrt(((blocked - (j, i)) ** 2).sum(axis=1).min()))


def test_heights_from_a_picture(tmp_path):
    """Black is low, white is high, row 0 is the lowest."""
    (tmp_path / "h.pgm").write_text("P2 2 2 255 0 255 51 102")
    np.testing.assert_allclose(
        read_heights(tmp_path / "h.pgm", highest=10.0), [[2.0, 4.0], [0.0, 10.0]]
    )


def test_a_changed_roadmap_is_the_one_built_anew():
    """After any change, the retested edges and the kept ones equal a test of all edges."""
    rng = np.random.default_rng(4)
    for robot in (ke.Point(), ke.Disk(1.5)):
        free = np.ones((50, 50), bool)
        problem = ke.Problem(robot, ke.Terrain(free), (3, 3), (47, 47))
        roadmap = ke.changing_roadmap(problem, n=150, k=6, rng=0)
        for _ in range(6):
            free = np.ones((50, 50), bool)
            for x, y in rng.integers(6, 36, (2, 2)):
                free[y : y + 8, x : x + 8] = False
            after = ke.Problem(robot, ke.Terrain(free), (3, 3), (47, 47))
            before = problem.world
            changed = ke.after_change(after, roadmap, *ke.changed_box(before, after.world))
            whole = ke.after_change(after, roadmap, (0, 0), (50, 50))
            np.testing.assert_array_equal(changed.is_open, whole.is_open)
            assert changed.judged < whole.judged
            plan = ke.query(after, changed.roadmap())
            assert plan.path is None or all(
                after.is_free_path(a, b) for a, b in zip(plan.path, plan.path[1:])
            )
            problem, roadmap = after, changed


def test_an_unchanged_world_asks_for_nearly_nothing():
    """Where no cell differs, only the origin is compared."""
    problem = ke.Problem(ke.Point(), ke.Terrain(np.ones((20, 20))), (3, 3), (17, 17))
    roadmap = ke.changing_roadmap(problem, n=50, rng=0)
    recorded = ke.changing_roadmap(ke.Recorder(problem), n=50, rng=0)
    assert np.array_equal(recorded.pairs, roadmap.pairs)
    assert (
        ke.after_change(problem, roadmap, *ke.changed_box(problem.world, problem.world)).judged == 0
    )
    with pytest.raises(InvalidParameter):
        ke.changed_box(problem.world, ke.Terrain(np.ones((20, 21))))


def test_the_parameters_of_the_document():
    """Step 20, goal bias one half, at most 10,000 consecutive failures; PRM with all pairs."""
    problem = ke.Problem(ke.Point(), landscape("rocks", 0), START, GOAL)
    plan = ke.rrt(
        problem,
        step_size=20,
        goal_bias=0.5,
        spacing=19.999,
        max_failures=10_000,
        max_iterations=10**6,
        rng=1,
    )
    assert plan.path is not None
    nodes = plan.tree.nodes[:-1]
    apart = np.sqrt(((nodes[:, None] - nodes) ** 2).sum(axis=2)) + 1e9 * np.eye(len(nodes))
    assert apart.min() >= 19.999
    walled = np.ones((40, 40), bool)
    walled[:, 20] = False
    sealed = ke.Problem(ke.Point(), ke.Terrain(walled), (5, 5), (35, 35))
    failed = ke.rrt(sealed, step_size=6, spacing=3, max_failures=200, max_iterations=10**6, rng=0)
    assert failed.path is None and failed.stats["iterations"] < 50_000
    roadmap = ke.prm(problem, n=30, k=32, rng=0).roadmap
    free = {
        (i, j)
        for i in range(32)
        for j in range(i + 1, 32)
        if problem.is_free_path(roadmap.nodes[i], roadmap.nodes[j])
    }
    assert {tuple(sorted(edge)) for edge in roadmap.edges.tolist()} == free
    with pytest.raises(InvalidParameter, match="spacing"):
        ke.rrt(problem, step_size=5, spacing=5, rng=0)


def test_a_plan_prints_what_its_cost_is():
    """A length, or a cost where cells have costs; and no end of a sentence without counts."""
    ends = (0.5, 0.5), (3.5, 0.5)
    plain, dear = ke.Terrain(np.ones((2, 4))), ke.Terrain(np.ones((2, 4)), cost=np.full((2, 4), 3))
    for world, measure in ((plain, "length 3;"), (dear, "cost 9;")):
        assert measure in repr(ke.plan_on_grid(ke.Problem(ke.Point(), world, *ends)))
    assert repr(ke.problems.Plan(None, np.inf, reason="no way")) == "<Plan: no path: no way>"
