"""Lesson 5: the claims of its exercises and figures, against independent computations."""

import numpy as np
import pytest

from kinoedu import TwoLinkArm, torus_distance
from kinoedu.boards import reach_board, torus_board
from kinoedu.course.lessons.configurations.degrees_of_freedom import freedoms, random_joints
from kinoedu.course.lessons.configurations.exposing_reach import inverse_by_sines
from kinoedu.errors import InvalidRobot
from kinoedu.figures import configurations
from kinoedu.robots.arm import ArmChain


@pytest.mark.parametrize("seed", range(30))
def test_counted_freedoms_are_those_of_the_constraints(seed):
    """Where pins close no ring, the count is the nullity of the constraints' Jacobian."""
    rng = np.random.default_rng(seed)
    bodies = int(rng.integers(1, 8))
    joints = random_joints(rng, "arm" if seed % 2 else "loose", bodies)
    rows = []
    for held in joints:
        x, y = rng.normal(size=2)
        first, *others = held
        for other in others:
            row = np.zeros((2, bodies + 1, 3))
            row[:, other] = [(1, 0, -y), (0, 1, x)]
            row[:, first] = -row[:, other]
            rows.append(row[:, 1:].reshape(2, -1))
    rank = np.linalg.matrix_rank(np.vstack(rows)) if rows else 0
    assert freedoms(bodies, joints) == 3 * bodies - rank


def test_the_law_of_sines_misses_where_the_angle_at_the_base_is_obtuse():
    """The program to break is right where l2^2 <= l1^2 + r^2 and wrong elsewhere."""
    rng, met = np.random.default_rng(0), {True: 0, False: 0}
    for _ in range(500):
        l1, l2 = rng.uniform(0.5, 2.0, 2)
        far = rng.uniform(abs(l1 - l2), l1 + l2)
        p = far * np.array([np.cos(l1), np.sin(l1)])
        if min(far - abs(l1 - l2), l1 + l2 - far, abs(l1 * l1 + far * far - l2 * l2)) < 1e-3:
            continue
        off = max(
            np.hypot(*(TwoLinkArm(l1, l2, 0).joints(q)[1] - p)) for q in inverse_by_sines(l1, l2, p)
        )
        right = l2 * l2 < l1 * l1 + far * far
        assert (off < 1e-9) == right
        met[right] += 1
    assert min(met.values()) > 30


def test_a_way_on_the_torus_is_short_and_even():
    """Its steps are equal and sum up to the distance; in the square it is split at the edges."""
    from matplotlib.figure import Figure

    rng = np.random.default_rng(1)
    for a, b in rng.uniform(-np.pi, np.pi, (50, 2, 2)):
        path = configurations.sample_torus_path(a, b)
        steps = torus_distance(path[1:], path[:-1])
        assert np.allclose(
            steps, torus_distance(a, b) / configurations.PIECES, rtol=1e-9, atol=1e-12
        )
        assert torus_distance(path[-1], b) < 1e-12
        (line,) = configurations.draw_torus_path(a, b, Figure().add_subplot())
        crossed = int((np.abs(b - a) > np.pi).sum())
        assert np.isnan(line.get_xdata()).sum() == crossed


def test_the_reach_board_tells_both_configurations_or_why_there_is_none():
    """In the ring, on its rim, beyond it and in its hole; a warning for infinitely many."""
    arm, equal = TwoLinkArm(2, 1, 0.2, base=(1, 0)), TwoLinkArm(1, 1, 0)
    assert "; or " in repr(reach_board(arm, (3, 1)))
    assert repr(reach_board(arm, (1, 3))) == "Canvas(3 from the base: θ₁ = 1.571, θ₂ = 0)"
    assert "reach only 3" in repr(reach_board(arm, (5, 0)))
    assert "still reaches 1 away" in repr(reach_board(arm, (1, 0.5)))
    assert "infinitely many" in repr(reach_board(equal, (0, 0)))
    with pytest.raises(InvalidRobot):
        reach_board(ArmChain([1, 1, 1], 0), (1, 0))


def test_points_on_the_torus_lie_on_its_tube():
    """Every point is one tube radius away from the central circle, at its two angles."""
    q = np.random.default_rng(3).uniform(-np.pi, np.pi, (50, 2))
    x, y, z = configurations.on_torus(q).T
    beside = np.hypot(x, y) - configurations.TORUS[0]
    assert np.allclose(np.hypot(beside, z), 1.02 * configurations.TORUS[1], rtol=1e-12)
    assert np.allclose(np.column_stack([np.arctan2(y, x), np.arctan2(z, beside)]), q, atol=1e-9)
    assert np.allclose(configurations.on_torus(q[0]), configurations.on_torus(q)[0])


def test_the_torus_board_draws_no_line_across_the_square():
    """The path is drawn in short pieces, whichever edges it crosses."""
    rng = np.random.default_rng(2)
    for a, b in rng.uniform(-np.pi, np.pi, (20, 2, 2)):
        canvas = torus_board(a, b)
        path = canvas.drawing.layers[1].rows.reshape(-1, 2, 2)
        assert np.hypot(*(path[:, 1] - path[:, 0]).T).sum() <= torus_distance(a, b) * (1 + 1e-9)
        assert len(path) >= configurations.PIECES - 2
