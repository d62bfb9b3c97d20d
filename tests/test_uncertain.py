"""Uncertain obstacles: margins, bounds and estimates, against quadrature, scipy and shapely."""

import numpy as np
import pytest

from kinoedu import (
    Disk,
    Point,
    PolygonWorld,
    Problem,
    TranslatingPolygon,
    UncertainWorld,
    collision_bound,
    collision_probability,
    prm,
)
from kinoedu.collision import path_clearances
from kinoedu.collision.probability import hit_scenarios, part_gaps
from kinoedu.errors import InvalidParameter, InvalidPoint, InvalidWorld
from kinoedu.worlds import chance_margins, inflated, scenario_world, scenarios

BOX = [(0, 0), (12, 0), (12, 8), (0, 8)]
L_SHAPE = [(7, 1), (10, 1), (10, 2), (8, 2), (8, 4), (7, 4)]
OBSTACLES = [((3, 4), 0.8), L_SHAPE, [(4, 6), (6, 6), (5, 7.2)]]
PATH = [(1, 1), (5.5, 4), (11, 5.6)]
ROBOTS = [Point(), Disk(0.3), TranslatingPolygon([(-0.3, -0.2), (0.4, -0.2), (0, 0.4)])]


def test_a_margin_is_the_quantile_of_chi_square():
    """The square of the offset over the variance has two degrees of freedom.

    Each uncertain obstacle has an equal fraction of the probability.
    """
    from scipy.stats import chi2

    for delta in (0.5, 0.05, 1e-6):
        sigma = np.array([0.1, 0.0, 0.3])
        assert chance_margins(sigma, delta) == pytest.approx(
            sigma * np.sqrt(chi2.ppf(1 - delta / 2, 2))
        )


def test_one_disc_and_one_segment_by_quadrature():
    """The probability is the Gaussian's integral over the points near the segment."""
    from scipy.integrate import quad
    from scipy.stats import norm

    sigma, radius, centre, (x0, x1, y0) = 0.7, 1.0, np.array([6.0, 4.0]), (5.0, 8.0, 2.2)

    def across(y):
        half = np.sqrt(max(radius**2 - (y - y0) ** 2, 0.0))
        wide = norm.cdf((x1 + half - centre[0]) / sigma) - norm.cdf((x0 - half - centre[0]) / sigma)
        return norm.pdf((y - centre[1]) / sigma) / sigma * wide

    truth = quad(across, y0 - radius, y0 + radius)[0]
    world = UncertainWorld(BOX, [(centre, radius)], sigma)
    chance = collision_probability(Point(), world, [(x0, y0), (x1, y0)], n=40_000, rng=1)
    assert abs(chance.estimate - truth) < 4 * np.sqrt(truth * (1 - truth) / 40_000)
    assert chance.low < truth < chance.high
    assert collision_bound(Point(), world, [(x0, y0), (x1, y0)]) > truth
    reached = [
        collision_probability(Point(), world, [(x0, y0), (x1, y0)], n=400, rng=seed)
        for seed in range(200)
    ]
    assert (
        np.mean([c.low <= truth <= c.high for c in reached]) > 0.9
    )  # 95 percent of the intervals hold it


@pytest.mark.parametrize("robot", ROBOTS, ids=range(len(ROBOTS)))
def test_each_scenario_is_a_world(robot):
    """A scenario has a collision exactly where the path is not free in its world."""
    world, path = UncertainWorld(BOX, OBSTACLES, [0.5, 0.4, 0.6]), np.array(PATH)
    offsets = scenarios(world, 150, rng=3)
    gaps = part_gaps(robot, world.parts, path)
    hit = hit_scenarios(robot, world.parts, world.owner, gaps, path, offsets)
    for offset, was_hit in zip(offsets, hit):
        shapes = [
            (np.add((3, 4), offset[0]), 0.8),
            np.add(L_SHAPE, offset[1]),
            np.add(OBSTACLES[2], offset[2]),
        ]
        for scenario in (
            PolygonWorld([(-9, -9), (30, -9), (30, 30), (-9, 30)], shapes),
            scenario_world(world, offset),
        ):
            ask = Problem(robot, scenario, path[0], path[0]) if not was_hit else None
            free = ask and all(ask.is_free_path(a, b) for a, b in zip(path, path[1:]))
            assert free or was_hit
        if was_hit:
            lone = PolygonWorld([(-9, -9), (30, -9), (30, 30), (-9, 30)], shapes)
            ask = Problem(robot, lone, (-8, -8), (-8, -8))
            assert not all(ask.is_free_path(a, b) for a, b in zip(path, path[1:]))
    assert 10 < hit.sum() < 140
    assert np.array_equal(
        hit, hit_scenarios.py_func(robot, world.parts, world.owner, gaps, path, offsets)
    )


@pytest.mark.parametrize("robot", ROBOTS[:2], ids=("point", "disk"))
@pytest.mark.parametrize("delta", [0.3, 0.05])
def test_a_path_that_is_free_with_the_margins_is_hit_as_seldom_as_promised(robot, delta):
    """A path that is free in the inflated world collides with probability at most delta.

    And at most as often as the bound says.
    """
    world = UncertainWorld(BOX, OBSTACLES, [0.1, 0.2, 0.15])
    for seed in range(4):
        plan = prm(Problem(robot, inflated(world, delta), (1, 1), (11, 7)), n=150, rng=seed)
        bound = collision_bound(robot, world, plan.path)
        chance = collision_probability(robot, world, plan.path, n=10_000, rng=seed)
        assert chance.estimate <= bound <= delta
        assert chance.high <= delta


def test_the_inflated_world_holds_all_that_is_within_the_margin():
    """Points within the margin of an obstacle are not free; points one percent farther out are."""
    import shapely

    world = UncertainWorld(BOX, OBSTACLES, [0.1, 0.2, 0.0])
    margins = chance_margins(world.sigma, 0.1)
    shapes = [
        shapely.Point(3, 4).buffer(0.8, 256),
        shapely.Polygon(L_SHAPE),
        shapely.Polygon(OBSTACLES[2]),
    ]
    ask = Problem(Point(), inflated(world, 0.1), (0.2, 0.2), (0.2, 0.2))
    for x, y in np.random.default_rng(0).uniform((0, 0), (12, 8), (3000, 2)):
        over = [
            shape.distance(shapely.Point(x, y)) - margin for shape, margin in zip(shapes, margins)
        ]
        if min(over) <= 0.0:
            assert not ask.is_free(np.array([x, y]))
        elif min(over) > 0.006 * max(margins) + 1e-4:
            assert ask.is_free(np.array([x, y]))


def test_scenarios_are_common_random_numbers():
    """The same seed draws the same offsets; the nearer path collides more often."""
    world = UncertainWorld(BOX, OBSTACLES, [0.1, 0.2, 0.0])
    offsets = scenarios(world, 20_000, rng=4)
    assert np.array_equal(offsets, scenarios(world, 20_000, rng=np.random.default_rng(4)))
    assert np.std(offsets, axis=(0, 2)) == pytest.approx([0.1, 0.2, 0.0], rel=0.02)
    single = UncertainWorld(BOX, [((6, 4), 1)], 0.6)
    near, far = (
        collision_probability(Point(), single, [(1, y), (11, y)], n=500, rng=9).hits
        for y in (2.4, 2.2)
    )
    assert near >= far


def test_certain_obstacles_and_the_boundary():
    """With sigma 0 a path collides always or never; a path that leaves the boundary always does."""
    world = UncertainWorld(BOX, [((6, 4), 1)], 0.0)
    assert collision_probability(Point(), world, [(1, 1), (11, 1)], n=50, rng=0)[:1] == (0.0,)
    assert collision_probability(Point(), world, [(1, 3), (11, 3)], n=50, rng=0).estimate == 1.0
    assert collision_bound(Point(), world, [(1, 1), (11, 1)]) == 0.0
    assert collision_bound(Point(), world, [(1, 3), (11, 3)]) == 1.0
    uncertain = UncertainWorld(BOX, [((6, 4), 1)], 0.3)
    for path in ([(1, 0), (11, 0)], [(1, 1), (11, 9)], [(0, 1)]):  # along, across and on a wall
        assert collision_bound(Point(), uncertain, path) == 1.0
        assert collision_probability(Point(), uncertain, path, n=9, rng=0).estimate == 1.0
    assert collision_bound(Disk(1.0), uncertain, [(2, 1.5), (10, 1.5)]) < 1.0
    assert collision_bound(Disk(1.0), uncertain, [(2, 1), (10, 1)]) == 1.0
    assert (
        collision_probability(
            Point(), UncertainWorld(BOX, [], 1.0), [(1, 1), (13, 1)], n=7, rng=0
        ).hits
        == 7
    )
    assert (
        collision_probability(Point(), UncertainWorld(BOX, [], 1.0), [(1, 1)], n=7, rng=0).hits == 0
    )
    assert path_clearances(Disk(0.5), world, [(1, 1), (11, 1)]) == pytest.approx([1.5])
    assert path_clearances(Disk(0.5), world, [(6, 4)]) == pytest.approx([0.0])


def test_what_makes_no_sense_is_refused_by_name():
    """Negative sigma, invalid probabilities, invalid paths, robots that rotate."""
    world = UncertainWorld(BOX, OBSTACLES, 0.1)
    for error, call in (
        (InvalidWorld, lambda: UncertainWorld(BOX, OBSTACLES, -0.1)),
        (InvalidWorld, lambda: UncertainWorld(BOX, OBSTACLES, [0.1, 0.2])),
        (InvalidPoint, lambda: UncertainWorld(BOX, OBSTACLES, np.nan)),
        (InvalidParameter, lambda: inflated(world, 0.0)),
        (InvalidParameter, lambda: inflated(world, 1.0)),
        (InvalidParameter, lambda: chance_margins([0.1], np.nan)),
        (InvalidParameter, lambda: collision_probability(Point(), world, PATH, n=0, rng=0)),
        (InvalidPoint, lambda: collision_probability(Point(), world, np.empty((0, 2)), rng=0)),
        (InvalidPoint, lambda: collision_probability(Point(), world, [(1, 1, 0)], rng=0)),
        (InvalidParameter, lambda: collision_probability("point", world, PATH, rng=0)),
    ):
        with pytest.raises(error):
            call()
