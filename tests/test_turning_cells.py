"""Scattered worlds, free headings, and plans by cells with headings, against brute force."""

import numpy as np
import pytest

import kinoedu as ke
from kinoedu.collision import free_configurations, free_heading, free_headings
from kinoedu.errors import InvalidParameter, InvalidPoint
from kinoedu.planners import dijkstra_path
from kinoedu.worlds import scattered
from kinoedu.worlds.polygon_world import rings_of

BAR = ke.RigidPolygon([(-1.0, -0.4), (2.0, -0.4), (2.0, 0.4), (-1.0, 0.4)])
HOOK = ke.RigidPolygon([(-1, -1), (2, -1), (2, -0.4), (-0.4, -0.4), (-0.4, 2), (-1, 2)])
STICK = ke.RigidPolygon([(-1.2, -0.3), (1.2, -0.3), (1.2, 0.3), (-1.2, 0.3)])


def within(rows, theta):
    """Whether angles lie in one of the intervals."""
    inside = np.zeros(len(theta), bool)
    for low, high in rows:
        inside |= np.mod(theta - low, 2 * np.pi) < high - low
    return inside


def drawn_world(seed):
    """Polygons, round obstacles, or a bitmap."""
    rng = np.random.default_rng(seed)
    if seed % 3 == 0:
        discs = [((x, y), r) for x, y, r in rng.uniform((0, 0, 0.3), (20, 20, 2), (12, 3))]
        return ke.PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], discs)
    return scattered(15, rng=rng) if seed % 3 == 1 else ke.Terrain(rng.random((20, 20)) > 0.12)


@pytest.mark.parametrize("seed", range(12))
def test_free_headings_equal_asking_for_thousands(seed):
    """A random heading is free exactly where it lies in an interval.

    For random robots, worlds and positions.
    """
    world, rng = drawn_world(seed), np.random.default_rng(seed)
    for place in rng.uniform(1, 19, (6, 2)):
        for robot in (BAR, HOOK):
            rows = free_headings(robot, world, place)
            theta = rng.uniform(-np.pi, np.pi, 1000)
            far = (
                np.abs(np.mod(theta[:, None] - rows.ravel() + np.pi, 2 * np.pi) - np.pi).min(
                    axis=1, initial=1.0
                )
                > 1e-6
            )
            truth = free_configurations(
                robot, world, np.column_stack([np.tile(place, (1000, 1)), theta])
            )
            assert (within(rows, theta) == truth)[far].all()
            assert ((rows[:, 0] < rows[:, 1]) & (-np.pi <= rows[:, 0]) & (rows[:, 0] < np.pi)).all()


def test_a_heading_that_only_a_narrow_gap_leaves_is_found():
    """In a slot wider than the robot by 1e-4, which samples at every degree would miss."""
    gap = ke.PolygonWorld([(0, 0), (20, 0), (20, 0.8001), (0, 0.8001)])
    rows = free_headings(BAR, gap, (10, 0.40005))
    assert len(rows) == 2
    assert (np.diff(rows) < 1e-3).all()
    assert free_configurations(
        BAR, gap, [(10, 0.40005, free_heading(BAR, gap, (10, 0.40005)))]
    ).all()


def test_no_heading_and_every_heading():
    """None in an obstacle, outside the world or too near a wall; all in the open, as one row."""
    world = ke.PolygonWorld(
        [(0, 0), (20, 0), (20, 20), (0, 20)], [[(4, 4), (6, 4), (6, 6), (4, 6)]]
    )
    for place in ((5, 5), (-3, 2), (1e9, 0), (4, 5)):
        assert free_heading(BAR, world, place) is None
    assert free_headings(BAR, world, (12, 12)).tolist() == [[-np.pi, np.pi]]
    assert free_heading(BAR, world, (12, 12)) == 0.0


def test_what_does_not_turn_has_no_free_headings():
    """Robots that do not rotate and invalid positions raise named errors."""
    world = ke.PolygonWorld([(0, 0), (9, 0), (9, 9)])
    with pytest.raises(InvalidParameter):
        free_headings(ke.Disk(1), world, (2, 1))
    with pytest.raises(InvalidPoint):
        free_headings(BAR, world, (np.nan, 1))


@pytest.mark.parametrize("seed", range(5))
def test_scattered_obstacles_keep_their_distance(seed):
    """By shapely: apart by the gap, off `keep_free`, inside the square, and convex."""
    import shapely

    world = scattered(12, radius=1.2, gap=0.3, keep_free=[(2, 2, 1.5)], rng=seed)
    polygons = [shapely.Polygon(ring) for (ring,) in rings_of(world)[1:]]
    assert len(polygons) == 12
    assert min(a.distance(b) for i, a in enumerate(polygons) for b in polygons[:i]) >= 0.3 - 1e-12
    assert all(p.distance(shapely.Point(2, 2)) > 1.5 and p.equals(p.convex_hull) for p in polygons)
    assert all(shapely.box(0, 0, 20, 20).contains(p) for p in polygons)
    few = scattered(7, radius=1.2, gap=0.3, keep_free=[(2, 2, 1.5)], rng=seed)
    assert all(np.array_equal(a, b) for (a,), (b,) in zip(rings_of(few), rings_of(world)))


@pytest.mark.parametrize(
    "wrong",
    [
        {"n": -1},
        {"n": 2.0},
        {"n": 3, "radius": 30},
        {"n": 3, "gap": -1},
        {"n": 500, "gap": 1.0},
        {"n": 1, "keep_free": [(1, 1, -1)]},
        {"n": 1, "keep_free": 5},
        {"n": 1, "side": 0},
    ],
)
def test_worlds_that_cannot_be_scattered_are_refused(wrong):
    """By named errors; also where there is no room."""
    with pytest.raises(InvalidParameter):
        scattered(**wrong, rng=0)


def test_every_search_finds_a_path_of_free_motions_or_none_does():
    """On one roadmap; breadth-first search has the fewest motions."""
    found = 0
    for seed in range(6):
        world = scattered(10, radius=2.2, keep_free=[(2, 2, 1.6), (18, 18, 1.6)], rng=seed)
        problem = ke.Problem(STICK, world, (2, 2, 0), (18, 18, 0))
        roadmap = ke.cells_with_headings(problem, neighbours=ke.Radius(6))
        plans = [
            ke.plan_on_roadmap(problem, roadmap, search)
            for search in (dijkstra_path, ke.bfs_path, ke.dfs_path)
        ]
        assert len({plan.path is None for plan in plans}) == 1
        if plans[0].path is not None:
            found += 1
            assert plans[0].cost <= min(plan.cost for plan in plans) + 1e-9
            assert len(plans[1].path) == min(len(plan.path) for plan in plans)
            assert all(
                problem.is_free_path(a, b)
                for plan in plans
                for a, b in zip(plan.path, plan.path[1:])
            )
        assert all(problem.is_free(q) for q in roadmap.nodes)
        assert all(free_heading(STICK, world, place) is None for place in roadmap.empty)
    assert found > 0


def test_cells_with_headings_have_other_routes_too():
    """On the other side of an obstacle."""
    world = ke.PolygonWorld(
        [(0, 0), (9, 0), (9, 9), (0, 9)], [[(4, 3.5), (5, 3.5), (5, 6), (4, 6)]]
    )
    bar = ke.RigidPolygon([(-0.3, -0.1), (0.3, -0.1), (0.3, 0.1), (-0.3, 0.1)])
    plan = ke.plan_by_cells_with_headings(ke.Problem(bar, world, (1, 5, 0), (8, 5, 0)))
    first, second = ke.alternative_routes(plan, 2, penalty=10)
    assert first.cost == plan.cost < second.cost


def test_a_recorder_and_the_problem_get_the_same_roadmap():
    """Interpreted and compiled."""
    world = ke.PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    problem = ke.Problem(STICK, world, (1.5, 1.5, 0), (7.5, 1.5, 0))
    for a, b in zip(
        ke.cells_with_headings(problem, headings=3),
        ke.cells_with_headings(ke.Recorder(problem), headings=3),
    ):
        assert np.array_equal(a, b)


def test_cells_with_headings_are_for_turning_polygons():
    """A point, a clearance and a bitmap raise named errors."""
    square = ke.PolygonWorld([(0, 0), (9, 0), (9, 9), (0, 9)])
    for problem in (
        ke.Problem(ke.Point(), square, (1, 1), (2, 2)),
        ke.Problem(STICK, square, (4, 4, 0), (5, 5, 0), clearance=0.1),
        ke.Problem(STICK, ke.Terrain(np.ones((9, 9), bool)), (4, 4, 0), (5, 5, 0)),
    ):
        with pytest.raises(InvalidParameter):
            ke.cells_with_headings(problem)
