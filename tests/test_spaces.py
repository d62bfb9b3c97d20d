"""Spaces: steering, sampling, and nearest nodes by buckets compared with brute force."""

import math
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kinoedu import (
    Point,
    PolygonWorld,
    Problem,
    Recorder,
    Terrain,
    circle_distance,
    prm,
    rrt,
    torus_distance,
)
from kinoedu.collision import is_free, is_free_path
from kinoedu.compiled import COMPILED_FIRST, running
from kinoedu.errors import InvalidParameter, InvalidPoint
from kinoedu.geometry import configuration, displaced, displacement, inverse, rotation
from kinoedu.geometry.checks import as_generator
from kinoedu.planners.problem_input import new_tree, world_size
from kinoedu.planners.roadmaps.neighbours import k_closest
from kinoedu.problems import ProblemRecord
from kinoedu.robots.round import RoundRobot
from kinoedu.spaces import (
    SE2,
    Box,
    Circle,
    RealSpace,
    Torus,
    WrappingSpace,
    diameter,
    distance,
    interpolate,
    near,
    nearest,
    sample,
    wrapped_configuration,
)
from kinoedu.spaces.angles import FULL_TURN, angle_difference, wrap_angle
from kinoedu.spaces.buckets import add, empty_tree
from kinoedu.spaces.closest import add_nodes, k_closest_in_buckets
from kinoedu.spaces.rings import SMALL

LAW = settings(
    derandomize=True,
    deadline=None,
    database=None,
    max_examples=200,
    suppress_health_check=list(HealthCheck),
)
KINDS = ["spread", "clumped", "lattice", "one place", "on a line", "beyond the box", "in a corner"]


def drawn_nodes(rng: np.random.Generator, kind: str, n: int, d: int) -> Any:
    """n configurations of d numbers in the box from -5 to 5, in many arrangements."""
    if kind == "clumped":
        return rng.uniform(-5, 5, (4, d))[rng.integers(4, size=n)] + rng.normal(0, 1e-3, (n, d))
    if kind == "lattice":
        return rng.integers(-5, 6, (n, d)).astype(float)
    if kind == "in a corner":
        return rng.uniform(-5, -3, (n, d))
    if kind == "one place":
        return np.full((n, d), 1.25)
    if kind == "on a line":
        return np.linspace(-5, 5, n)[:, None] * np.eye(1, d)
    if kind == "beyond the box":
        return rng.normal(0, 20, (n, d))
    return rng.uniform(-5, 5, (n, d))


def first_nearest(nodes: Any, q: Any) -> int:
    """The first of the nearest nodes; squares are added in the same order as in the library."""
    total = np.zeros(len(nodes))
    for i in range(nodes.shape[1]):
        total += (nodes[:, i] - q[i]) * (nodes[:, i] - q[i])
    return int(total.argmin())


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("d", [1, 2, 3])
def test_the_nearest_node_is_what_brute_force_finds(kind: str, d: int) -> None:
    """1 to 3,000 nodes, queries inside, outside, far outside and at nodes; ties go to the first."""
    rng = np.random.default_rng(KINDS.index(kind) * 3 + d)
    nodes = drawn_nodes(rng, kind, 3000, d)
    space = RealSpace(np.full(d, -5.0), np.full(d, 5.0))
    tree = empty_tree(3000, space.lo, space.hi)
    checkpoints = {1, 2, 3, 10, 100, SMALL - 1, SMALL, SMALL + 1, SMALL + 2, 700, 1500, 3000}
    for n, node in enumerate(nodes, start=1):
        assert add(tree, node, n - 2) == n - 1
        if n in checkpoints:
            queries = [
                *rng.uniform(-6, 6, (25, d)),
                *rng.normal(0, 50, (8, d)),
                *nodes[rng.integers(n, size=8)],
            ]
            queries += list(rng.integers(-12, 13, (20, d)) / 2)
            for q in queries:
                assert nearest(space, tree, q) == first_nearest(nodes[:n], q)
    assert tree.size[0] == 3000
    assert (tree.nodes == nodes).all()
    assert tree.parent.tolist() == list(range(-1, 2999))


@pytest.mark.parametrize(
    ("lo", "hi"),
    [
        pytest.param((0, 0), (1, 1e-6), id="low"),
        pytest.param((0, 0), (1e-6, 1), id="narrow"),
        pytest.param((1e6, -1e6), (1e6 + 1, -1e6 + 1), id="far away"),
        pytest.param((0, 0), (1, 0), id="flat"),
        pytest.param((2, 2), (2, 2), id="a point"),
    ],
)
@pytest.mark.parametrize("capacity", [500, 10_000])
def test_the_nearest_node_in_odd_boxes(lo: Any, hi: Any, capacity: int) -> None:
    """Thin, distant, flat and empty boxes, with capacity for just these nodes or far more."""
    rng = np.random.default_rng(7)
    space = RealSpace(np.array(lo, float), np.array(hi, float))
    nodes = rng.uniform(space.lo, space.hi, (500, 2))
    tree = empty_tree(capacity, space.lo, space.hi)
    for node in nodes:
        add(tree, node, -1)
    reach = (space.hi - space.lo).max() + 1.0
    for q in [
        *rng.uniform(space.lo, space.hi, (40, 2)),
        *rng.uniform(space.lo - reach, space.hi + reach, (40, 2)),
        *nodes[:10],
    ]:
        assert nearest(space, tree, q) == first_nearest(nodes, q)


def box(d: int) -> Any:
    return st.lists(st.floats(-1e3, 1e3), min_size=d, max_size=d).map(np.array)


@LAW
@given(st.integers(1, 3).flatmap(lambda d: st.tuples(box(d), box(d), box(d))), st.floats(0, 1))
def test_distance_and_interpolation_obey_their_laws(points: Any, t: float) -> None:
    """The distance is a metric, and interpolation divides it in the ratio t : 1 - t."""
    a, b, c = points
    space = RealSpace(np.full(len(a), -1e3), np.full(len(a), 1e3))
    whole = distance(space, a, b)
    assert whole == distance(space, b, a) == pytest.approx(float(np.linalg.norm(b - a)), rel=1e-14)
    assert distance(space, a, a) == 0.0
    assert distance(space, a, c) <= (whole + distance(space, b, c)) * (1 + 1e-14)
    assert (interpolate(space, a, b, 0.0) == a).all()
    assert interpolate(space, a, b, 1.0) == pytest.approx(b, abs=1e-12)
    q = interpolate(space, a, b, t)
    assert distance(space, a, q) == pytest.approx(t * whole, abs=1e-12)
    assert distance(space, q, b) == pytest.approx((1 - t) * whole, abs=1e-12)
    assert interpolate(space, b, a, 1 - t) == pytest.approx(q, abs=1e-12)


@LAW
@given(box(2), box(2), st.floats(1e-3, 1e4))
def test_steering_goes_at_most_a_step_and_arrives(a: Any, b: Any, step: float) -> None:
    """The result is new, on the straight line, at most one step away, and b itself if b is near."""
    world = PolygonWorld([(-2e3, -2e3), (2e3, -2e3), (2e3, 2e3), (-2e3, 2e3)])
    problem = Problem(Point(), world, (0, 0), (1, 1))
    q, whole = problem.steer(a, b, step), problem.distance(a, b)
    if whole <= step:
        assert q.tolist() == b.tolist()
    else:
        assert problem.distance(a, q) == pytest.approx(step, rel=1e-9)
        assert problem.distance(a, q) + problem.distance(q, b) == pytest.approx(whole, rel=1e-12)
    assert not np.shares_memory(q, b)
    assert not np.shares_memory(q, a)


@pytest.mark.parametrize(
    "world",
    [
        PolygonWorld([(-3, 1), (5, 1), (5, 2), (-3, 2)]),
        Terrain(np.ones((4, 9)), resolution=0.5, origin=(7, -3)),
    ],
    ids=["polygons", "terrain"],
)
def test_samples_fill_the_box_and_follow_the_seed(world: Any) -> None:
    """Uniform in each coordinate; equal seeds give equal samples, other seeds others."""
    middle = 0.5 * (world.lo + world.hi)
    problem = Problem(Point(), world, middle, middle)
    first, again, other = (
        np.array([problem.sample(rng) for _ in range(2000)])
        for rng in map(np.random.default_rng, (1, 1, 2))
    )
    assert (first == again).all()
    assert not (first == other).any()
    assert ((world.lo <= first) & (first < world.hi)).all()
    shares = (first - world.lo) / (world.hi - world.lo)
    for coordinate in shares.T:
        assert np.histogram(coordinate, 10, (0, 1))[0].min() > 140
    assert abs(np.corrcoef(shares.T)[0, 1]) < 0.1


def test_samples_are_one_random_number_for_each_coordinate() -> None:
    """The stream of a seed is used as documented: lo + (hi - lo) u, coordinate by coordinate."""
    space = RealSpace(np.array([1.0, -2.0, 0.0]), np.array([3.0, 2.0, 0.5]))
    q, u = sample(space, np.random.default_rng(3)), np.random.default_rng(3).random(3)
    assert q.tolist() == (space.lo + (space.hi - space.lo) * u).tolist()


@pytest.mark.parametrize("bad", [-1, 1.5, True, None, "0"])
def test_a_bad_seed_is_refused(bad: Any) -> None:
    """InvalidParameter says what a seed is; numpy integers and Generators are allowed."""
    with pytest.raises(InvalidParameter, match="seed"):
        as_generator(bad)
    generator = np.random.default_rng(0)
    assert as_generator(generator) is generator
    assert as_generator(np.int64(4)).random() == np.random.default_rng(4).random()


def test_a_space_without_implementations_raises_errors() -> None:
    """The default of each operation is an error, or brute force for the nearest node."""
    for ask in (
        lambda: distance("space", 1, 2),
        lambda: interpolate("space", 1, 2, 0.5),
        lambda: sample("space", 0),
    ):
        with pytest.raises(TypeError, match="space"):
            ask()


@pytest.mark.parametrize("shape", [(2, 1), (40, 1), (2, 2), (300, 2), (900, 2)], ids=str)
@pytest.mark.parametrize("kind", ["spread", "lattice", "clumped", "one line", "one place"])
def test_k_closest_in_buckets_equals_brute_force(shape, kind):
    """The same distances in the same order, ties to the first, without the node itself."""
    rng = np.random.default_rng(5)
    nodes = {
        "spread": rng.random(shape),
        "lattice": rng.integers(0, 5, shape).astype(float),
        "clumped": 1e3 * rng.integers(0, 2, shape) + 1e-3 * rng.random(shape),
        "one line": np.repeat(rng.random((shape[0], 1)), shape[1], axis=1),
        "one place": np.ones(shape),
    }[kind]
    space = RealSpace(nodes.min(axis=0), nodes.max(axis=0))
    tree = empty_tree(len(nodes), space.lo, space.hi)
    add_nodes(tree, nodes)
    for k in {1, min(7, len(nodes) - 1)}:
        found = k_closest_in_buckets(space, tree, k)
        apart = ((nodes[:, None] - nodes[None]) ** 2).sum(axis=2)
        np.fill_diagonal(apart, np.inf)
        assert np.array_equal(found, np.argsort(apart, axis=1, kind="stable")[:, :k])


# ---- spaces with angles ------------------------------------------------------------------------

PI, TURN = math.pi, Fraction(FULL_TURN)
SPACES = {
    "circle": Circle(),
    "torus": Torus(),
    "torus of three": Torus(3),
    "SE(2)": SE2((-4, 1), (3, 2), turn_weight=0.7),
    "cylinder": WrappingSpace(
        np.array([0.0, -PI]), np.array([9.0, PI]), np.array([False, True]), np.array([0.4, 3.0])
    ),
}
ANGLES = st.one_of(
    st.floats(-PI, math.nextafter(PI, 0)),
    st.sampled_from(
        [0.0, -PI, math.nextafter(PI, 0), math.nextafter(-PI, 0), PI / 2, 5e-324, 1e-17]
    ),
    st.floats(0, 1e-9).map(lambda x: PI - x).filter(lambda x: x < PI),
    st.floats(0, 1e-9).map(lambda x: x - PI),
)


def arc(a: float, b: float) -> float:
    """The distance on the circle in exact arithmetic, rounded once."""
    apart = (Fraction(b) - Fraction(a)) % TURN
    return float(min(apart, TURN - apart))


@LAW
@given(
    st.one_of(ANGLES, st.floats(-1e6, 1e6), st.floats(-1e150, 1e150)),
    st.one_of(ANGLES, st.floats(-1e6, 1e6)),
)
def test_circle_distance_is_exact(a: float, b: float) -> None:
    """Equal to exact arithmetic rounded once, symmetric, and independent of full turns."""
    assert circle_distance(a, b) == circle_distance(b, a) == arc(a, b)
    assert circle_distance(a, a) == circle_distance(PI, -PI) == 0.0
    assert torus_distance((a, b), (b, a)) == pytest.approx(math.sqrt(2) * arc(a, b), rel=1e-14)


@LAW
@given(ANGLES, ANGLES, st.floats(0, 1))
def test_differences_of_angles_are_exact_and_short(a: float, b: float, t: float) -> None:
    """Its length is the circle distance, it leads from a to b, and its points are wrapped."""
    turn = angle_difference(a, b)
    assert (
        -PI <= turn < PI
        and abs(turn) == circle_distance(a, b)
        and turn == angle_difference.py_func(a, b)
    )
    assert circle_distance(a + turn, b) < 1e-15
    q = interpolate(Circle(), np.array([a]), np.array([b]), t)
    assert -PI <= q[0] < PI
    assert circle_distance(a, q[0]) == pytest.approx(t * abs(turn), abs=2e-15)


def test_distances_of_many_angles() -> None:
    """One with many and many with many; a number or an array; other shapes are refused."""
    a, b = np.array([0.0, 3.0, -3.0]), np.array([1.0, -3.0, 2.5])
    assert circle_distance(a, b).tolist() == [arc(x, y) for x, y in zip(a, b, strict=True)]
    assert circle_distance(3, b).tolist() == [arc(3, y) for y in b]
    assert isinstance(circle_distance(1, 2), float) and isinstance(
        torus_distance([1, 2], [3, 4]), float
    )
    assert (
        torus_distance([0, 0], [[0, 3], [3, 0]]).tolist()
        == torus_distance([[0, 3], [3, 0]], [0, 0]).tolist()
        == [3.0, 3.0]
    )
    for bad in (
        lambda: circle_distance(a, b[:2]),
        lambda: circle_distance([a], [b]),
        lambda: circle_distance(math.nan, 1),
        lambda: torus_distance(1, 2),
        lambda: torus_distance(a, b[:2]),
        lambda: torus_distance([], []),
        lambda: torus_distance([a], [b, b]),
        lambda: torus_distance("ab", [1, 2]),
    ):
        with pytest.raises(InvalidPoint):
            bad()


def around(space: Any, kind: str, rng: np.random.Generator, n: int) -> Any:
    """n configurations of a space, in many arrangements."""
    nodes = np.array([sample(space, rng) for _ in range(n)])
    if kind == "at the wrap":
        nodes = np.where(space.wraps, rng.normal(0, 0.03, nodes.shape) + PI, nodes)
    if kind == "lattice":
        nodes = np.where(space.wraps, rng.integers(-4, 4, nodes.shape) * (PI / 4), np.round(nodes))
    if kind == "one place":
        nodes[:] = nodes[0]
    return wrapped_configuration(space, nodes)


def squares_from(space: Any, nodes: Any, q: Any) -> Any:
    """Squared distances by the public functions for the circle."""
    total = np.zeros(len(nodes))
    for i in range(len(q)):
        apart = space.weight[i] * (
            circle_distance(nodes[:, i], q[i]) if space.wraps[i] else np.abs(nodes[:, i] - q[i])
        )
        total += apart * apart
    return total


@pytest.mark.parametrize("name", SPACES)
@pytest.mark.parametrize("kind", ["spread", "at the wrap", "lattice", "one place"])
def test_near_nodes_across_the_wrap_are_what_brute_force_finds(name: str, kind: str) -> None:
    """The nearest of 1 to 1,500 nodes, those within a radius, and the k nearest of 8 to 300, with
    ties to the first.
    """
    rng, space = np.random.default_rng(4), SPACES[name]
    nodes, tree = around(space, kind, rng, 1500), empty_tree(1500, space.lo, space.hi)
    for n, node in enumerate(nodes, start=1):
        add(tree, node, -1)
        if n in (1, 2, SMALL, SMALL + 1, 500, 1500):
            queries = [
                *around(space, "spread", rng, 20),
                *around(space, kind, rng, 20),
                *(around(space, "spread", rng, 5) + FULL_TURN),
            ]
            for q in queries:
                squares = squares_from(space, nodes[:n], wrapped_configuration(space, q))
                found = nearest(space, tree, wrapped_configuration(space, q))
                assert found == squares.argmin()
                assert distance(space, nodes[found], q) == pytest.approx(
                    math.sqrt(squares.min()), abs=1e-14
                )
                radius = rng.choice([0.1, 1.0, 9.0])
                within = near(space, tree, wrapped_configuration(space, q), radius)
                assert np.array_equal(np.sort(within), np.flatnonzero(squares <= radius * radius))
    free = ProblemRecord(
        RoundRobot(0.0), Band(0.0), space, nodes[0], nodes[1], 0.0, np.zeros(2, np.int64)
    )
    for n, k in ((8, 5), (12, 11), (30, 20), (300, 6)):
        some = nodes[:n]
        apart = np.array([squares_from(space, some, q) for q in some])
        np.fill_diagonal(apart, np.inf)
        nearest_first = np.argsort(apart, axis=1, kind="stable")[:, :k]
        assert np.array_equal(k_closest(free, some, k), nearest_first)


class Band(NamedTuple):
    """A world that forbids a band around 0 in the first coordinate."""

    width: float


@is_free.register(RoundRobot, Band)
def outside_the_band(robot: RoundRobot, world: Band, q: Any, clearance: float) -> bool:
    """Whether the configuration is outside the band."""
    return abs(q[0]) > world.width


@is_free_path.register(RoundRobot, Band)
def does_not_cross(robot: RoundRobot, world: Band, a: Any, b: Any, clearance: float) -> bool:
    """Whether the ends are on the same side, or the motion wraps around away from the band."""
    ends = abs(a[0]) > world.width and abs(b[0]) > world.width
    return ends and (a[0] * b[0] > 0.0 or abs(a[0] - b[0]) > PI)


@pytest.mark.parametrize("name", ["torus", "torus of three", "SE(2)"])
def test_planners_go_the_short_way_round(name: str) -> None:
    """RRT and PRM plan motions that wrap around; the interpreted planners return the same."""
    space = SPACES[name]
    turns = name != "SE(2)"
    start, goal = np.full(len(space.lo), 1.5), np.full(len(space.lo), 1.5)
    start[-1], goal[-1] = -3.0, 3.0
    if turns:
        start[0], goal[0] = -1.0, 1.0
    problem = ProblemRecord(
        RoundRobot(0.0), Band(0.5), space, start, goal, 0.0, np.zeros(2, np.int64)
    )
    for plan, again in (
        (rrt(problem, max_nodes=400, rng=1), rrt(Recorder(problem), max_nodes=400, rng=1)),
        (prm(problem, n=150, rng=1), prm(Recorder(problem), n=150, rng=1)),
    ):
        assert plan.path is not None, plan.reason
        assert np.array_equal(plan.path, again.path) and plan.stats == again.stats
        steps = [problem.distance(a, b) for a, b in zip(plan.path, plan.path[1:])]
        assert plan.cost == pytest.approx(sum(steps)) and plan.cost >= problem.distance(
            start, goal
        ) * (1 - 1e-12)
        if turns:
            assert (np.abs(np.diff(plan.path[:, 0])) > PI).sum() % 2 == 1


def test_a_wrapping_space_is_as_large_as_it_is_wide() -> None:
    """Its diameter is attained and never exceeded; a planner's default step is a fraction of it."""
    rng = np.random.default_rng(0)
    for space in SPACES.values():
        ends = np.array(
            [distance(space, sample(space, rng), sample(space, rng)) for _ in range(2000)]
        )
        assert 0.7 * diameter(space) < ends.max() <= diameter(space)
        opposite = np.where(space.wraps, 0.0, space.hi)
        assert distance(space, space.lo, opposite) == pytest.approx(diameter(space), rel=1e-14)
    assert diameter(Box((0, 0), (3, 4))) == 5.0
    problem = ProblemRecord(
        RoundRobot(0.0), Band(0.5), Torus(), np.ones(2), np.ones(2), 0.0, np.zeros(2, np.int64)
    )
    assert world_size(problem) == pytest.approx(PI * math.sqrt(2))
    assert new_tree(problem, 5).size[0] == 0


@pytest.mark.parametrize(
    "bad",
    [
        lambda: Torus(0),
        lambda: Torus(1.5),
        lambda: SE2((0, 0), (1, 1), turn_weight=0),
        lambda: SE2((0, 0), (1, 1), turn_weight=math.nan),
        lambda: SE2((0, 0, 0), (1, 1, 1), turn_weight=1),
        lambda: SE2((0, 0), (1, 0), turn_weight=1),
        lambda: Box((0,), (1, 2)),
        lambda: Box([], []),
        lambda: Box(0, 1),
        lambda: Box((1, 0), (0, 1)),
    ],
)
def test_invalid_spaces_are_refused(bad: Any) -> None:
    """No dimensions, no weight, bounds that are not bounds."""
    with pytest.raises((InvalidParameter, InvalidPoint)):
        bad()


def test_the_message_about_bounds_names_the_shape_that_they_need() -> None:
    """Empty bounds have the same length, which is not what is wrong with them."""
    with pytest.raises(InvalidPoint, match=r"shape \(n,\) with the same n >= 1, got \(0,\) and"):
        Box([], [])
    with pytest.raises(InvalidPoint, match=r"shape \(2,\), got \(3,\) and \(2,\)"):
        SE2((0, 0, 0), (1, 1), turn_weight=1)


def test_angles_are_wrapped() -> None:
    """To [-pi, pi), for one or many configurations; other coordinates are unchanged."""
    space = SE2((-4, 1), (3, 2), turn_weight=1)
    assert wrapped_configuration(space, (9, 9, PI)).tolist() == [9, 9, -PI]
    assert (
        wrapped_configuration(space, np.full((2, 3), -3 * PI)).tolist()
        == [[-3 * PI, -3 * PI, -PI]] * 2
    )
    for angle in (-1e6, -PI, 0.3, PI, 7.0, 1e6):
        assert -PI <= wrap_angle(angle) < PI
        assert circle_distance(wrap_angle(angle), angle) < 1e-9


def test_huge_angles_are_wrapped_alike_in_compiled_code() -> None:
    """Where whole turns are more than its integers can count."""
    with running(COMPILED_FIRST):
        for angle in (5.8e19, -5.9e19, 1e25, -1e40, 1e149):
            assert wrap_angle(angle) == wrap_angle.py_func(angle)


# ---- displacements -----------------------------------------------------------------------------


@LAW
@given(
    st.tuples(st.floats(-9, 9), st.floats(-9, 9), st.floats(-9, 9)),
    st.tuples(st.floats(-9, 9), st.floats(-9, 9), st.floats(-9, 9)),
)
def test_displacements_are_a_group_of_rigid_motions(p: Any, q: Any) -> None:
    """They preserve lengths, compose, have inverses, and return their configuration.

    A rotation by 0 is the identity.
    """
    a, b = displacement(*p), displacement(*q)
    corners = np.array([(0.0, 0.0), (3.0, 0.0), (0.0, 4.0)])
    moved = displaced(corners, a)
    assert np.linalg.norm(moved[1] - moved[2]) == pytest.approx(5.0, rel=1e-12)
    assert displaced(corners, a @ b) == pytest.approx(
        displaced(displaced(corners, b), a), abs=1e-12
    )
    assert inverse(a) @ a == pytest.approx(np.eye(3), abs=1e-12)
    assert configuration(a)[:2].tolist() == list(p[:2])
    assert circle_distance(configuration(a)[2], p[2]) < 1e-14
    assert displaced((1.0, 0.0), displacement(0, 0, p[2])) == pytest.approx(
        [math.cos(p[2]), math.sin(p[2])]
    )
    assert rotation(0.0).tolist() == [[1.0, 0.0], [0.0, 1.0]]
    assert displaced(corners, displacement(*p[:2], 0)).tolist() == (corners + p[:2]).tolist()


@pytest.mark.parametrize(
    "bad",
    [
        np.eye(2),
        np.ones((3, 3)),
        np.diag([1, -1, 1]),
        np.diag([2, 2, 1]),
        [[1, 0, 0], [0, 1, 0], [1, 0, 1]],
    ],
)
def test_matrices_that_are_not_displacements_are_refused(bad: Any) -> None:
    """Wrong shapes, reflections, scalings, perspective transformations."""
    for ask in (inverse, configuration, lambda matrix: displaced((0, 0), matrix)):
        with pytest.raises(InvalidPoint, match="displacement"):
            ask(bad)


def test_a_configuration_of_another_size_is_refused():
    for wrong in ((0.5,), 0.5, (0.1, 0.2, 0.3)):
        with pytest.raises(InvalidPoint, match="2 coordinates"):
            wrapped_configuration(Torus(2), wrong)
