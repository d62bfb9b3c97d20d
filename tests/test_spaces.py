"""Spaces: steering, sampling, and the nearest node by buckets against looking at every node."""

from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from kinoedu import Point, PolygonWorld, Problem, Terrain
from kinoedu.errors import InvalidParameter
from kinoedu.problems import as_generator
from kinoedu.spaces import RealSpace, distance, interpolate, nearest, sample
from kinoedu.spaces.buckets import SMALL, add, empty_tree
from kinoedu.spaces.closest import fill, k_closest_in_buckets

LAW = settings(derandomize=True, deadline=None, database=None, max_examples=200, suppress_health_check=list(HealthCheck))
KINDS = ["spread", "clumped", "lattice", "one place", "on a line", "beyond the box"]


def drawn_nodes(rng: np.random.Generator, kind: str, n: int, d: int) -> Any:
    """n configurations of d numbers for the box from -5 to 5, in many arrangements."""
    if kind == "clumped":
        return rng.uniform(-5, 5, (4, d))[rng.integers(4, size=n)] + rng.normal(0, 1e-3, (n, d))
    if kind == "lattice":
        return rng.integers(-5, 6, (n, d)).astype(float)
    if kind == "one place":
        return np.full((n, d), 1.25)
    if kind == "on a line":
        return np.linspace(-5, 5, n)[:, None] * np.eye(1, d)
    if kind == "beyond the box":
        return rng.normal(0, 20, (n, d))
    return rng.uniform(-5, 5, (n, d))


def first_nearest(nodes: Any, q: Any) -> int:
    """The first of the nearest nodes, its squares summed one after another as the library does."""
    total = np.zeros(len(nodes))
    for i in range(nodes.shape[1]):
        total += (nodes[:, i] - q[i]) * (nodes[:, i] - q[i])
    return int(total.argmin())


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("d", [1, 2, 3])
def test_the_nearest_node_is_what_brute_force_finds(kind: str, d: int) -> None:
    """From 1 to 3,000 nodes, with queries in the box, outside, far outside, and at nodes; ties go to the first node."""
    rng = np.random.default_rng(KINDS.index(kind) * 3 + d)
    nodes = drawn_nodes(rng, kind, 3000, d)
    space = RealSpace(np.full(d, -5.0), np.full(d, 5.0))
    tree = empty_tree(3000, space.lo, space.hi)
    checkpoints = {1, 2, 3, 10, 100, SMALL - 1, SMALL, SMALL + 1, SMALL + 2, 700, 1500, 3000}
    for n, node in enumerate(nodes, start=1):
        assert add(tree, node, n - 2) == n - 1
        if n in checkpoints:
            queries = [*rng.uniform(-6, 6, (25, d)), *rng.normal(0, 50, (8, d)), *nodes[rng.integers(n, size=8)]]
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
    """Thin, far away, flat and empty boxes; room for just these nodes or for far more."""
    rng = np.random.default_rng(7)
    space = RealSpace(np.array(lo, float), np.array(hi, float))
    nodes = rng.uniform(space.lo, space.hi, (500, 2))
    tree = empty_tree(capacity, space.lo, space.hi)
    for node in nodes:
        add(tree, node, -1)
    reach = (space.hi - space.lo).max() + 1.0
    for q in [*rng.uniform(space.lo, space.hi, (40, 2)), *rng.uniform(space.lo - reach, space.hi + reach, (40, 2)), *nodes[:10]]:
        assert nearest(space, tree, q) == first_nearest(nodes, q)


def box(d: int) -> Any:
    return st.lists(st.floats(-1e3, 1e3), min_size=d, max_size=d).map(np.array)


@LAW
@given(st.integers(1, 3).flatmap(lambda d: st.tuples(box(d), box(d), box(d))), st.floats(0, 1))
def test_distance_and_interpolation_obey_their_laws(points: Any, t: float) -> None:
    """A metric; the ends at 0 and 1; a fraction t of the way at t; halves are the same from both ends."""
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
    """Exactly to b where it is within a step, never farther than the step, always straight; what it returns is new."""
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
    [PolygonWorld([(-3, 1), (5, 1), (5, 2), (-3, 2)]), Terrain(np.ones((4, 9)), resolution=0.5, origin=(7, -3))],
    ids=["polygons", "terrain"],
)
def test_samples_fill_the_box_and_follow_the_seed(world: Any) -> None:
    """Uniform in each coordinate; the same seed draws the same samples, another seed others."""
    middle = 0.5 * (world.lo + world.hi)
    problem = Problem(Point(), world, middle, middle)
    first, again, other = (np.array([problem.sample(rng) for _ in range(2000)]) for rng in map(np.random.default_rng, (1, 1, 2)))
    assert (first == again).all()
    assert not (first == other).any()
    assert ((world.lo <= first) & (first < world.hi)).all()
    shares = (first - world.lo) / (world.hi - world.lo)
    for coordinate in shares.T:
        assert np.histogram(coordinate, 10, (0, 1))[0].min() > 140
    assert abs(np.corrcoef(shares.T)[0, 1]) < 0.1


def test_samples_are_one_random_number_for_each_coordinate() -> None:
    """So that the stream of a seed is spent as documented: lo + (hi - lo) u, coordinate by coordinate."""
    space = RealSpace(np.array([1.0, -2.0, 0.0]), np.array([3.0, 2.0, 0.5]))
    q, u = sample(space, np.random.default_rng(3)), np.random.default_rng(3).random(3)
    assert q.tolist() == (space.lo + (space.hi - space.lo) * u).tolist()


@pytest.mark.parametrize("bad", [-1, 1.5, True, None, "0"])
def test_a_bad_seed_is_refused(bad: Any) -> None:
    """InvalidParameter says what a seed is; a numpy integer is one, a Generator is used as it is."""
    with pytest.raises(InvalidParameter, match="seed"):
        as_generator(bad)
    generator = np.random.default_rng(0)
    assert as_generator(generator) is generator
    assert as_generator(np.int64(4)).random() == np.random.default_rng(4).random()


def test_a_space_without_answers_says_so() -> None:
    """The default of each question is an error in words, or brute force for the nearest node."""
    for ask in (lambda: distance("space", 1, 2), lambda: interpolate("space", 1, 2, 0.5), lambda: sample("space", 0)):
        with pytest.raises(TypeError, match="space"):
            ask()


@pytest.mark.parametrize("shape", [(2, 1), (40, 1), (2, 2), (300, 2), (900, 2)], ids=str)
@pytest.mark.parametrize("kind", ["spread", "lattice", "clumped", "one line", "one place"])
def test_k_closest_in_buckets_equals_brute_force(shape, kind):
    """The same distances in the same order, the first among equals, never the node itself."""
    rng = np.random.default_rng(5)
    nodes = {
        "spread": rng.random(shape),
        "lattice": rng.integers(0, 5, shape).astype(float),
        "clumped": 1e3 * rng.integers(0, 2, shape) + 1e-3 * rng.random(shape),
        "one line": np.repeat(rng.random((shape[0], 1)), shape[1], axis=1),
        "one place": np.ones(shape),
    }[kind]
    tree = empty_tree(len(nodes), nodes.min(axis=0), nodes.max(axis=0))
    fill(tree, nodes)
    for k in {1, min(7, len(nodes) - 1)}:
        found = k_closest_in_buckets(tree, k)
        apart = ((nodes[:, None] - nodes[None]) ** 2).sum(axis=2)
        np.fill_diagonal(apart, np.inf)
        assert np.array_equal(found, np.argsort(apart, axis=1, kind="stable")[:, :k])
