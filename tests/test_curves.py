"""Dubins and Reeds-Shepp curves reach the goal, are shortest, and respect symmetries."""

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from kinoedu.curves import Curve, dubins_path, reeds_shepp_path
from kinoedu.curves import dubins as dubins_file
from kinoedu.curves import reeds_shepp as reeds_shepp_file
from kinoedu.curves.space import pieces_between
from kinoedu.errors import InvalidParameter, InvalidPoint
from kinoedu.spaces.angles import wrap_angle

CASES = json.loads((Path(__file__).parent / "data" / "kino" / "cases_expected.json").read_text())[
    "cases"
]
PATHS = {"dubins": dubins_path, "rs": reeds_shepp_path}
CURVES = [case for case in CASES if case["kind"] in PATHS]
# The file's length is a full turn too long: an angle of -1e-17 was wrapped to 2 pi.
A_TURN_TOO_LONG = {"dubins_quarter"}


def poses(rng: np.random.Generator, n: int) -> Any:
    """Random poses; every third is on a lattice, where lengths are equal and pieces vanish."""
    drawn = np.column_stack([rng.uniform(-6, 6, (n, 2)), rng.uniform(-np.pi, np.pi, n)])
    drawn[::3] = np.column_stack(
        [
            rng.integers(-3, 4, (len(drawn[::3]), 2)),
            0.5 * np.pi * rng.integers(-2, 2, len(drawn[::3])),
        ]
    )
    return drawn


def miss(curve: Curve, goal: Any) -> float:
    """The error of the curve's end, in position or heading."""
    end = curve.at(curve.length)
    return max(math.dist(end[:2], goal[:2]), abs(wrap_angle(end[2] - wrap_angle(goal[2]))))


@pytest.mark.parametrize("case", CURVES, ids=lambda case: case["id"])
def test_lengths_of_the_reference_cases(case: dict[str, Any]) -> None:
    """Equal to 1e-9, except for one case where the reference contains a superfluous full turn."""
    curve = PATHS[case["kind"]](case["q0"], case["q1"], case["R"])
    too_long = 2 * np.pi * case["R"] if case["id"] in A_TURN_TOO_LONG else 0.0
    assert curve.length == pytest.approx(case["expected"]["length"] - too_long, abs=1e-9)
    assert miss(curve, case["q1"]) < 1e-9


@pytest.mark.parametrize("path", PATHS.values())
def test_the_end_is_the_goal_and_pieces_are_driven_in_order(path: Any) -> None:
    """Random poses, and poses where pieces vanish; positions change at most by the length.

    Before the start and after the end are no poses.
    """
    rng = np.random.default_rng(1)
    for q0, q1 in zip(poses(rng, 600), poses(rng, 600)):
        curve = path(q0, q1, 1.5)
        assert miss(curve, q1) < 1e-8
        assert miss(Curve(q0, 1.5, curve.turns[:0], curve.lengths[:0]), q0) == 0.0
        along = curve.at(np.linspace(0, curve.length, 50))
        apart = np.linalg.norm(np.diff(along[:, :2], axis=0), axis=1)
        assert apart.max() <= curve.length / 49 + 1e-9
        assert (curve.at([-1.0, curve.length + 1.0]) == along[[0, -1]]).all()
        assert (along[0] == curve.start).all()


def drawn_word(rng: np.random.Generator, pieces: int, forward: bool) -> tuple[Any, Any]:
    """Random turns and lengths; neighbouring pieces differ in turn or gear."""
    turns, lengths = rng.integers(-1, 2, pieces), rng.uniform(0.0, 2.5, pieces)
    if rng.random() < 0.3:
        lengths[rng.integers(pieces)] = 0.5 * np.pi
    return turns, lengths if forward else lengths * rng.choice([-1.0, 1.0], pieces)


@pytest.mark.parametrize(
    ("path", "forward", "pieces"), [(dubins_path, True, 3), (reeds_shepp_path, False, 5)]
)
def test_no_random_word_is_shorter(path: Any, forward: bool, pieces: int) -> None:
    """No random word reaches its end by a shorter way than the curve to that end."""
    rng = np.random.default_rng(2)
    for _ in range(4000):
        word = Curve(
            np.array([0.5, -1.0, 2.0]), 1.0, *drawn_word(rng, rng.integers(1, pieces + 1), forward)
        )
        assert path(word.start, word.at(word.length), 1.0).length <= word.length + 1e-7


@pytest.mark.parametrize(
    ("path", "q0", "q1", "length"),
    [
        (dubins_path, (0, 1, 0), (8.676153112044282e-07, 1.000000000000222, 3.1200100858117836e-07),
         8.676153112044603e-07),
        (dubins_path, (1.741242611171848, 1, np.pi / 2),
         (1.7412241008762737, 1.006084428120869, 1.576876664439557), 0.006084465662633356),
        (reeds_shepp_path, (1.2402142392314417, 1, 0.8463673946015828),
         (1.2419110284286752, 1.0019124886866957, 0.8438673417910646), 0.0025566990646380644),
        (reeds_shepp_path, (0, 1, 0),
         (-0.0015490097585393531, 0.9999988003420923, 0.0015382003911917047),
         0.0015490103779070032),
    ],
)  # fmt: skip
def test_curves_between_near_poses_take_no_turn_or_detour(
    path: Any, q0: Any, q1: Any, length: float
) -> None:
    """An arc, then straight: angles are rounded more where poses are near.

    The lengths were calculated with 50 digits.
    """
    curve = path(q0, q1, 1.0)
    assert curve.length == pytest.approx(length, abs=1e-9)
    assert miss(curve, q1) < 1e-11


@pytest.mark.parametrize("apart", [4.0, 4.0 - 1e-13, 4.0 - 9e-13])
def test_a_word_exists_within_rounding_of_the_pose_where_it_begins(apart: float) -> None:
    """Two half circles to (0, 4, 0), also for a goal 1e-12 radii nearer, which they nearly reach.

    Without them its shortest curve is longer by 3e-6 radii, and at other poses by a full turn.
    """
    curve = dubins_path((0, 0, 0), (0, apart, 0), 1.0)
    assert curve.length == pytest.approx(2.0 * np.pi, abs=1e-9)
    assert miss(curve, (0, apart, 0)) < 1e-11
    further = dubins_path((0, 0, 0), (0, 4.0 - 2e-12, 0), 1.0)
    assert 1e-6 < further.length - curve.length < 1e-5


@pytest.mark.parametrize(("path", "forward"), [(dubins_path, True), (reeds_shepp_path, False)])
def test_no_short_random_word_is_shorter(path: Any, forward: bool) -> None:
    """Straight, with an arc before or behind: of lengths from 1e-8 to 1."""
    rng = np.random.default_rng(4)
    for _ in range(4000):
        turns = np.array([rng.integers(-1, 2), 0, rng.integers(-1, 2)])
        lengths = 10.0 ** rng.uniform(-8, 0) * rng.random(3)
        lengths *= 1.0 if forward else rng.choice([-1.0, 1.0], 3)
        word = Curve(np.array([0.5, -1.0, 2.0]), 1.0, turns, lengths)
        assert path(word.start, word.at(word.length), 1.0).length <= word.length + 1e-9


Q = np.pi / 2
FAMILIES = [
    ((1, 0, 1), (1.0, 2.9, 0.4)),
    ((1, 0, -1), (0.4, 1.3, 0.9)),
    ((1, -1, 1), (0.3, -1.5, -1.4)),
    ((1, -1, 1), (1.0, -1.7, 0.3)),
    ((1, -1, 1), (1.1, 1.2, -0.5)),
    ((1, -1, 1, -1), (0.7, -1.0, -1.0, 0.3)),
    ((1, -1, 1, -1), (0.4, 0.8, -0.8, -0.4)),
    ((1, -1, 0, 1), (1.0, -Q, -0.9, -0.3)),
    ((1, -1, 0, -1), (0.7, -Q, -1.6, -0.3)),
    ((1, -1, 0, 1, -1), (0.3, -Q, -0.4, -Q, 0.3)),
]


@pytest.mark.parametrize(("turns", "lengths"), FAMILIES)
@pytest.mark.parametrize("mirror", [1, -1])
@pytest.mark.parametrize("gear", [1, -1])
@pytest.mark.parametrize("order", [1, -1])
def test_every_family_of_reeds_and_shepp_is_found(
    turns: Any, lengths: Any, mirror: int, gear: int, order: int
) -> None:
    """A shortest curve of each family is found, also mirrored, backwards and reversed."""
    word = Curve(
        np.zeros(3), 1.0, mirror * np.array(turns)[::order], gear * np.array(lengths)[::order]
    )
    found = reeds_shepp_path(word.start, word.at(word.length), 1.0)
    assert found.length == pytest.approx(word.length, abs=1e-9)


def test_lengths_are_symmetric_and_invariant() -> None:
    """Reeds-Shepp lengths are symmetric and at most Dubins' lengths.

    Both are invariant under reflections, displacements and scaling.
    """
    rng = np.random.default_rng(3)
    for q0, q1 in zip(poses(rng, 400), poses(rng, 400)):
        there = reeds_shepp_path(q0, q1, 1.0).length
        assert there == pytest.approx(reeds_shepp_path(q1, q0, 1.0).length, abs=1e-9)
        assert there <= dubins_path(q0, q1, 1.0).length + 1e-9
        for path in PATHS.values():
            length = path(q0, q1, 1.0).length
            assert path(q0 * [1, -1, -1], q1 * [1, -1, -1], 1.0).length == pytest.approx(
                length, abs=1e-9
            )
            assert path(q0 * [3, 3, 1], q1 * [3, 3, 1], 3.0).length == pytest.approx(
                3 * length, abs=1e-8
            )


@pytest.mark.parametrize("path", PATHS.values())
def test_a_displacement_changes_nothing(path: Any) -> None:
    """Start and goal are rotated and translated together."""
    rng = np.random.default_rng(4)
    for q0, q1 in zip(poses(rng, 300)[1::3], poses(rng, 300)[1::3]):
        turn, c, s = 0.7, math.cos(0.7), math.sin(0.7)
        r0, r1 = (
            np.array([c * x - s * y + 2, s * x + c * y - 5, theta + turn])
            for x, y, theta in (q0, q1)
        )
        assert path(r0, r1, 1.0).length == pytest.approx(path(q0, q1, 1.0).length, abs=1e-8)


@pytest.mark.parametrize("path", PATHS.values())
def test_a_curve_from_a_pose_to_itself_is_empty(path: Any) -> None:
    """The curve from a pose to itself has length 0, for every representation of its heading."""
    assert path((1, 2, 0.5), (1, 2, 0.5), 1.0).length == 0.0
    assert path((1, 2, 0.5), (1, 2, 0.5 + 2 * np.pi), 1.0).length == pytest.approx(0.0, abs=1e-12)


def test_compiled_and_interpreted_agree() -> None:
    """Turns and lengths are identical."""
    rng = np.random.default_rng(5)
    for x, y, phi in poses(rng, 60):
        for file, name in ((dubins_file, "shortest_forward"), (reeds_shepp_file, "shortest")):
            body = getattr(file, name)
            for compiled, interpreted in zip(body(x, y, phi), body.py_func(x, y, phi)):
                assert np.allclose(compiled, interpreted, rtol=0, atol=1e-12)


@pytest.mark.parametrize("path", PATHS.values())
def test_invalid_arguments_are_refused(path: Any) -> None:
    """A pose has three numbers, a radius is positive, distances are numbers."""
    for q in ((1, 2), (1, 2, np.nan), "abc", None, [(1, 2, 3)]):
        with pytest.raises(InvalidPoint):
            path(q, (0, 0, 0), 1.0)
        with pytest.raises(InvalidPoint):
            path((0, 0, 0), q, 1.0)
    for radius in (0, -1, (1, 2)):
        with pytest.raises(InvalidParameter):
            path((0, 0, 0), (1, 1, 1), radius)
    with pytest.raises(InvalidPoint):
        path((0, 0, 0), (1, 1, 1), 1.0).at("far")


def test_a_curve_is_the_same_from_either_end():
    """This also holds where several curves have equal length, as between almost equal positions.

    A planner may check an edge from one end and drive it from the other.
    """
    rng = np.random.default_rng(8)
    for spread in (0.0, 0.1, 1.0, 10.0):
        for a, b in rng.uniform(-1, 1, (200, 2, 3)) * (spread, spread, np.pi):
            turns, lengths = pieces_between(a, b, 1.5, True)
            back_turns, back_lengths = pieces_between(b, a, 1.5, True)
            there, back = lengths != 0.0, back_lengths != 0.0
            assert turns[there].tolist() == back_turns[back][::-1].tolist()
            assert lengths[there].tolist() == (-back_lengths[back][::-1]).tolist()


def test_a_table_of_distances_is_refused():
    with pytest.raises(InvalidPoint, match="a row of numbers"):
        dubins_path((0, 0, 0), (10, 0, 0), 1).at([[1.0, 2.0]])
