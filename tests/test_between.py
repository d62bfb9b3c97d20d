"""Samples of an ellipse, in any space: they lie in it, and are uniform; numpy says what that is."""

import math
from typing import Any

import numpy as np
import pytest

from kinoedu.spaces import SE2, Box, RealSpace, Torus
from kinoedu.spaces import between as file
from kinoedu.spaces.between import sample_between

TEN = Box((0, 0), (10, 10))
CASES = {
    "interval": (Box((0,), (10,)), (4,), (5,), 3.0),
    "ellipse": (TEN, (3, 4), (7, 6), 6.0),
    "circle": (TEN, (5, 5), (5, 5), 3.0),
    "in a corner": (TEN, (0.1, 0.1), (2, 0.5), 3.0),
    "larger than the box": (TEN, (1, 1), (9, 9), 16.0),
    "in a corridor": (Box((0, 0), (10, 0.1)), (4, 0.05), (5, 0.05), 3.0),
    "four dimensions": (Box((0,) * 4, (1,) * 4), (0.3, 0.4, 0.5, 0.4), (0.7, 0.5, 0.5, 0.6), 0.7),
    "turning": (SE2((0, 0), (10, 10), turn_weight=2.0), (4, 4, 3), (6, 5, -3), 4.0),
    "every heading": (SE2((0, 0), (10, 10), turn_weight=0.2), (4, 4, 3), (6, 5, 0), 3.0),
    "torus": (Torus(2), (3, 0), (-3, 1), 2.5),
    "whole torus": (Torus(2), (3, 0), (-1, 1), 6.0),
}


def span(space: Any, a: np.ndarray, q: np.ndarray) -> np.ndarray:
    """The distances (n,) from a to the rows of q, by numpy."""
    apart = np.abs(q - a)
    if isinstance(space, RealSpace):
        return np.linalg.norm(apart, axis=1)
    turned = np.minimum(apart, 2 * math.pi - apart)
    return np.linalg.norm(np.where(space.wraps, turned, apart) * space.weight, axis=1)


@pytest.mark.parametrize("name", CASES)
def test_samples_are_uniform(name: str) -> None:
    """As many lie beyond planes, and near the edge, as of the points of the space by rejection."""
    space, a, b, length = CASES[name]
    a, b, rng = np.array(a, float), np.array(b, float), np.random.default_rng(1)
    n = 1000
    drawn = np.array([sample_between(space, a, b, length, rng) for _ in range(n)])
    assert (span(space, a, drawn) + span(space, b, drawn) < length * (1 + 1e-12)).all()
    assert (drawn >= space.lo).all() and (drawn <= space.hi).all()
    every = rng.uniform(space.lo, space.hi, (200_000, len(a)))
    every = every[span(space, a, every) + span(space, b, every) < length]
    assert len(every) > 1_000
    marks = [lambda q: span(space, a, q) + span(space, b, q), lambda q: span(space, a, q)]
    marks += [lambda q, i=i: q[:, i] for i in range(len(a))]
    marks += [lambda q, i=i: q[:, i] - q[:, 0] for i in range(1, len(a))]
    for mark in marks:
        expected, found = mark(every), mark(drawn)
        for level in np.quantile(expected, (0.1, 0.3, 0.5, 0.7, 0.9)):
            share = (expected < level).mean()
            apart = (found < level).mean() - share
            deviation = math.sqrt(share * (1 - share) * (1 / n + 1 / len(every)))
            assert abs(apart) <= 4.5 * deviation, (level, share, apart)


@pytest.mark.parametrize("d", [2, 3, 6])
def test_however_thin_an_ellipse_is_it_is_hit(d: int) -> None:
    """Where rejection would need 10^12 draws or more."""
    space, rng = Box((0,) * d, (10,) * d), np.random.default_rng(0)
    a, b = np.full(d, 2.0), np.arange(3.0, 3.0 + d)
    apart = float(np.linalg.norm(b - a))
    for more in (1e-3, 1e-9, 1e-15):
        length = apart * (1.0 + more)
        q = np.array([sample_between(space, a, b, length, rng) for _ in range(50)])
        assert len(np.unique(q, axis=0)) > 45
        assert (span(space, a, q) + span(space, b, q) <= length * (1 + 1e-15)).all()


def test_a_space_may_have_many_dimensions() -> None:
    """In 400 the gamma function of the ball's volume has no float."""
    space, a, b = Box((0,) * 400, (1,) * 400), np.full(400, 0.2), np.full(400, 0.8)
    q = sample_between(space, a, b, 14.0, np.random.default_rng(0))
    assert np.linalg.norm(q - a) + np.linalg.norm(b - q) < 14.0


def test_few_draws_are_rejected(monkeypatch: pytest.MonkeyPatch) -> None:
    """At most four for each sample in the plane, eight in space, though the ends lie in a corner;
    along a narrow corridor no more than two.
    """
    draws = [0]

    def counted(draw: Any) -> Any:
        def call(*given: Any) -> Any:
            draws[0] += 1
            return draw(*given)

        return call

    monkeypatch.setattr(file, "draw_in_ellipsoid", counted(file.draw_in_ellipsoid))
    monkeypatch.setattr(file, "draw_in_box", counted(file.draw_in_box))
    rng = np.random.default_rng(0)
    for space, most in (
        (TEN, 4.0),
        (Box((0,) * 3, (10,) * 3), 8.0),
        (Box((0, 0), (1e6, 1e-3)), 2.0),
    ):
        d = len(space.lo)
        a, b = np.zeros(d), np.zeros(d)
        b[0] = 1.0
        draws[0] = 0
        for _ in range(500):
            sample_between(space, a, b, 1.5, rng)
        assert draws[0] < 1.2 * most * 500


def test_where_nothing_fits_the_middle_is_returned() -> None:
    """An unknown distance rejects; a length that is hardly longer leaves only the middle."""
    q = sample_between.__wrapped__(
        TEN, np.array([2.0, 2]), np.array([8.0, 2]), 6.0 + 1e-12, np.random.default_rng(0)
    )
    assert q.tolist() == [5, 2]
