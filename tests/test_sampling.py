"""Sampling: grids, Halton's sequence and dispersion, compared with exact values."""

import json
import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import kinoedu as ke
from kinoedu.errors import InvalidParameter, InvalidPoint
from kinoedu.sampling import (
    corner_grid,
    dispersion,
    halton,
    largest_empty_ball,
    sukharev_bound,
    sukharev_grid,
    uniform_random,
    van_der_corput,
)

DATA = Path(__file__).parent / "data" / "lowdisc"
CASES = json.loads((DATA / "cases_expected.json").read_text(encoding="utf-8"))["cases"]
PRIMES = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29)
NORMS = (2, math.inf)


def both_ends(n: int, d: int) -> Any:
    """The points i/(k-1), a grid that the library does not offer."""
    k = round(n ** (1 / d))
    return np.stack(np.meshgrid(*[np.arange(k) / (k - 1)] * d, indexing="ij"), axis=-1).reshape(
        -1, d
    )


GRIDS = {"corner": corner_grid, "sukharev": sukharev_grid, "both_ends": both_ends}


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["id"])
def test_shared_cases(case):
    """Halton's fractions are exact; dispersions agree with closed forms, or to nine digits."""
    expected = case["expected"]
    if case["kind"] == "halton":
        points = halton(case["n"], PRIMES[: case["dim"]], case["start"])
        assert points.tolist() == [[float(Fraction(x)) for x in row] for row in expected["exact"]]
        return
    if case["kind"] == "grid":
        points, close = GRIDS[case["type"]](case["k"] ** case["dim"], case["dim"]), 1e-13
        assert len(points) == expected["n_points"]
    else:
        points, close = np.array(case["points"]), 1e-8
        assert sukharev_bound(*points.shape) == expected["sukharev_bound_Linf"]
    assert dispersion(points) == pytest.approx(expected["L2"], abs=close)
    if points.shape[1] < 3:
        assert dispersion(points, math.inf) == pytest.approx(expected["Linf"], abs=close)


@pytest.mark.parametrize("d", [1, 2, 5, 10])
def test_halton_agrees_with_the_tables_of_ompl(d):
    """The first point has number 1; six digits agree."""
    table = np.loadtxt(DATA / f"halton_{d}d.txt", ndmin=2)
    assert np.abs(halton(len(table), PRIMES[:d]) - table).max() < 1e-6


def exact_mirrored(i: int, base: int) -> Fraction:
    """The digits of i reflected at the radix point."""
    value, scale = Fraction(0), Fraction(1, base)
    while i:
        value, scale, i = value + scale * (i % base), scale / base, i // base
    return value


@pytest.mark.parametrize(
    ("base", "start"),
    [
        (2, 1),
        (2, 4095),
        (3, 0),
        (5, 12_345),
        (6, 36),
        (7, 10**9),
        (10, 99),
        (4099, 4000),
        (9_999_991, 9_990_000),
        (2, 2**52),
    ],
)
def test_van_der_corput_is_the_float_nearest_to_the_fraction(base, start):
    """Across blocks, for large indices, in small, composite and large bases, from any start."""
    numbers = van_der_corput(9000, base, start)
    for i in (0, 1, 2, 95, 96, 4095, 4096, 4097, 8191, 8192, 8999):
        assert numbers[i] == float(exact_mirrored(start + i, base))
    assert numbers[5000:].tolist() == van_der_corput(4000, base, start + 5000).tolist()
    assert ((0 <= numbers) & (numbers < 1)).all()


def test_the_sequence_has_each_fraction_once():
    """The first 3^7 points are the fractions with denominator 3^7, each once."""
    assert np.array_equal(np.sort(van_der_corput(3**7, 3, start=0)), np.arange(3**7) / 3**7)


@pytest.mark.parametrize(
    ("primes", "words"),
    [
        ((2, 4), "4 = 2 \\* 2"),
        ((3, 91), "91 = 7 \\* 13"),
        ((2, 3, 2), "2 twice"),
        ((), "one prime"),
        (5, "one prime"),
        ((1,), "prime"),
        ((2.0,), "prime"),
        ((True,), "prime"),
    ],
)
def test_bases_that_are_not_prime_are_refused(primes, words):
    """The message names the number and its factors."""
    with pytest.raises(InvalidParameter, match=words):
        halton(5, primes)


@pytest.mark.parametrize(
    "call",
    [
        lambda: halton(0),
        lambda: halton(2.0),
        lambda: halton(5, start=-1),
        lambda: halton(5, start=2**53),
        lambda: van_der_corput(5, 1),
        lambda: van_der_corput(5, 2, 2**53 - 2),
        lambda: uniform_random(3, 0, rng=0),
        lambda: uniform_random(3, rng=-1),
        lambda: sukharev_bound(0),
        lambda: dispersion([[0.5, 0.5]], 1),
        lambda: dispersion(np.full((1, 3), 0.5), math.inf),
        lambda: dispersion(np.full((1, 4), 0.5)),
    ],
)
def test_bad_parameters_are_refused(call):
    """Each raises InvalidParameter."""
    with pytest.raises(InvalidParameter):
        call()


@pytest.mark.parametrize(
    "bad", [[], [[]], [0.5], [[0.5, 1.1]], [[-1e-9, 0]], [[np.nan, 0]], "ab", [[[0.5]]]]
)
def test_bad_points_are_refused(bad):
    """InvalidPoint for no points, a wrong shape, points outside the cube and numbers not finite."""
    for norm in NORMS:
        with pytest.raises(InvalidPoint):
            dispersion(bad, norm)


@pytest.mark.parametrize("grid", [corner_grid, sukharev_grid])
def test_grids_say_which_sizes_they_have(grid):
    """Only perfect powers are allowed; the message names the nearest."""
    with pytest.raises(InvalidParameter, match="perfect square, got 10; the nearest are 9 and 16"):
        grid(10)
    with pytest.raises(
        InvalidParameter, match="perfect cube, got 999; the nearest are 729 and 1,000"
    ):
        grid(999, 3)
    for k, d in ((1, 1), (1, 7), (10, 2), (10, 3), (2, 20), (3000, 2)):
        assert grid(k**d, d).shape == (k**d, d)
    assert grid(7, 1).shape == (7, 1)


def test_grids_stand_at_corners_and_centres():
    """i/k and (i + 1/2)/k, each the nearest float; the last coordinate changes fastest."""
    for k in (1, 3, 10, 49):
        assert corner_grid(k, 1)[:, 0].tolist() == [float(Fraction(i, k)) for i in range(k)]
        assert sukharev_grid(k, 1)[:, 0].tolist() == [
            float(Fraction(2 * i + 1, 2 * k)) for i in range(k)
        ]
    assert corner_grid(9)[:4].tolist() == [[0, 0], [0, 1 / 3], [0, 2 / 3], [1 / 3, 0]]


def test_random_points_follow_the_seed():
    """Equal seeds give equal points, a Generator continues its stream, and the cube is filled."""
    points = uniform_random(4000, 3, rng=5)
    assert np.array_equal(points, uniform_random(4000, 3, rng=np.random.default_rng(5)))
    assert min(np.histogram(coordinate, 10, (0, 1))[0].min() for coordinate in points.T) > 330


def drawn(kind: str, rng: np.random.Generator) -> Any:
    """A few points of the square, in many arrangements."""
    n = int(rng.integers(1, 40))
    points = rng.random((n, 2))
    if kind == "lattice":
        return rng.integers(0, 5, (n, 2)) / 4
    if kind == "upright":
        points[:, 0] = points[0, 0]
    if kind == "in a corner":
        points *= 1e-9
    if kind == "corners":
        return np.round(points)
    if kind == "nearly a lattice":
        return np.clip(np.round(points, 1) + rng.normal(0, 1e-14, (n, 2)), 0, 1)
    return points


@pytest.mark.parametrize("norm", NORMS)
@pytest.mark.parametrize(
    "kind", ["spread", "lattice", "upright", "in a corner", "corners", "nearly a lattice"]
)
def test_the_largest_empty_ball_is_what_a_fine_lattice_finds(kind, norm):
    """Empty, centred in the square, and at most one cell larger than the best ball of a lattice."""
    from scipy.spatial import cKDTree

    rng, side = np.random.default_rng(3), 201
    places = np.stack(np.meshgrid(*[np.linspace(0, 1, side)] * 2), axis=-1).reshape(-1, 2)
    for _ in range(30):
        points = drawn(kind, rng)
        ball = largest_empty_ball(points, norm)
        assert ((0 <= ball.centre) & (ball.centre <= 1)).all()
        assert np.linalg.norm(points - ball.centre, ord=norm, axis=1).min() == pytest.approx(
            ball.radius, abs=1e-13
        )
        least = cKDTree(points).query(places, p=norm)[0].max()
        assert (
            least - 1e-13
            <= ball.radius
            <= least + (math.sqrt(0.5) if norm == 2 else 0.5) / (side - 1)
        )
        if norm == math.inf:
            assert ball.radius >= sukharev_bound(len(points)) * (1 - 1e-14)


@pytest.mark.parametrize("norm", NORMS)
def test_dispersion_keeps_the_symmetries_of_the_square(norm):
    """Invariant under symmetries, order and repetition; another point never increases it."""
    points = halton(60)
    radius = dispersion(points, norm)
    for same in (points[::-1], points[:, ::-1], 1 - points, np.vstack([points, points[:7]])):
        assert dispersion(same, norm) == pytest.approx(radius, rel=1e-13)
    assert dispersion(np.vstack([points, largest_empty_ball(points, norm).centre]), norm) <= radius


def test_dispersion_on_the_line_and_in_space():
    """Half the largest gap, or a whole gap at an end; in space the opposite corner is farthest."""
    for norm in NORMS:
        assert dispersion([[0.5], [0.2]], norm) == 0.5
        assert largest_empty_ball([[0.1], [0.9]], norm) == (np.array([0.5]), 0.4)
    assert dispersion(np.zeros((1, 3))) == pytest.approx(math.sqrt(3), rel=1e-13)


def test_evenly_spread_points_beat_random_ones():
    """In the sup norm at n = 400: Sukharev's grid meets its bound, Halton is within three times it.

    Random points are worse.
    """
    bound = sukharev_bound(400)
    assert dispersion(sukharev_grid(400), math.inf) == pytest.approx(bound, rel=1e-12)
    assert (
        bound
        < dispersion(halton(400), math.inf)
        < 3 * bound
        < dispersion(uniform_random(400, rng=0), math.inf)
    )


def test_sampling_functions_are_public():
    """The public names are available as kinoedu.name."""
    assert (ke.halton, ke.corner_grid, ke.sukharev_grid) == (halton, corner_grid, sukharev_grid)
    assert (ke.uniform_random, ke.dispersion) == (uniform_random, dispersion)


def test_figures_show_points_holes_and_rates():
    """Points, the empty ball in both norms, cells and labelled curves; shapes are checked."""
    from matplotlib import pyplot as plt

    from kinoedu.figures import draw_dispersion, draw_samples

    points = halton(25)
    _, ax = plt.subplots()
    draw_samples(points, ax, upto=9, cells=3, norm=math.inf)
    assert len(ax.lines[-1].get_xdata()) == 9
    assert ax.get_title() == f"sup-norm dispersion {dispersion(points[:9], math.inf):.3f}"
    assert [text.get_text() for text in ax.texts] == [str(i) for i in range(1, 10)]
    for norm in (2, None):
        draw_samples(points, norm=norm)
    draw_samples(points, upto=0, norm=2)
    with pytest.raises(InvalidPoint, match="shape"):
        draw_samples([0.5, 0.5])
    _, ax = plt.subplots()
    draw_dispersion([4, 9], {"one": [0.3, 0.2], "other": [0.3, 0.2]}, ax)
    named = [text.get_text() for text in ax.texts]
    assert sorted(named) == ["like n^(-1/2)", "one", "other"]
    heights = sorted(text.xy[1] for text in ax.texts)
    assert min(np.diff(heights)) > 0
    with pytest.raises(InvalidPoint, match="shape"):
        draw_dispersion([4, 9], {"one": [0.3]})
    plt.close("all")
