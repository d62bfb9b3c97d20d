"""Lesson 12: its exercises and figures, checked against independent computations."""

import math

import numpy as np
import pytest

from kinoedu import Car, Trajectory, dubins_path, reeds_shepp_path
from kinoedu.boards import curves_board
from kinoedu.course.lessons.cars import csc_length, exposing_drive
from kinoedu.course.lessons.shared.driving import pose_after
from kinoedu.curves.dubins import all_dubins_curves
from kinoedu.figures import cars


def poses(seed, n):
    """Random poses."""
    rng = np.random.default_rng(seed)
    return np.column_stack([rng.uniform(-6, 6, (n, 2)), rng.uniform(-np.pi, np.pi, n)])


@pytest.mark.parametrize("seed", range(3))
def test_every_word_leads_there_and_the_shortest_is_dubins(seed):
    """Each curve ends at the goal, each word occurs once, the shortest is that of dubins_path."""
    for a, b in zip(poses(seed, 60), poses(seed + 10, 60)):
        curves = all_dubins_curves(a, b, 1.3)
        for curve in curves:
            end = curve.at(curve.length)
            assert math.dist(end[:2], b[:2]) < 1e-8
            assert abs(math.remainder(end[2] - b[2], 2 * math.pi)) < 1e-8
            assert (curve.lengths >= 0).all()
        assert len({curve.word for curve in curves}) == len(curves) >= 2
        assert min(curve.length for curve in curves) == pytest.approx(
            dubins_path(a, b, 1.3).length, abs=1e-8
        )


@pytest.mark.parametrize("seed", range(3))
def test_the_lengths_by_circles_are_those_of_the_curves(seed):
    """The lengths by tangents and by circles in the plane agree for each word."""
    for a, b in zip(poses(seed, 80), poses(seed + 20, 80)):
        by_circles = {
            word: 1.3 * (t + v) + u for word, (t, u, v) in csc_length.words_to(a, b, 1.3).items()
        }
        curves = {
            curve.word: curve.length
            for curve in all_dubins_curves(a, b, 1.3)
            if curve.word[1] == "S"
        }
        assert by_circles == pytest.approx(curves, abs=1e-7)


def test_cases_of_the_curves_are_as_stated():
    """Straight cases have both headings 0; the others are clear of degenerate turns and circles."""
    for seed in range(4):
        for case in csc_length.CscLength().cases(np.random.default_rng(seed)):
            a, b, r = case.given.values()
            if case.kind == "straight":
                assert a[2] == b[2] == 0.0 == a[1] - b[1] and b[0] > a[0]
                assert csc_length.csc(a, b, r) == pytest.approx(b[0] - a[0])
            else:
                assert csc_length.kind_of(a, b, r) == case.kind


@pytest.mark.parametrize("angle", [0.9, 0.3, 0.05, -0.4])
def test_four_moves_lead_exactly_sideways(angle):
    """Two moves, undone in the same order, lead sideways by 4 r (1 - cos angle)."""
    r, side = 20.0, math.copysign(math.pi / 4, angle)
    controls = [(1, side), (1, -side), (-1, side), (-1, -side)]
    end = Trajectory(Car(30, 10, 20), (0, 0, 0), controls, [r * abs(angle)] * 4).poses[-1]
    assert end == pytest.approx(
        [0.0, math.copysign(4 * r * (1 - math.cos(angle)), angle), 0.0], abs=1e-12
    )


def test_the_program_to_break_is_right_for_no_steering_and_wrong_by_the_square_of_the_time():
    """Its error is 0 on a line, small for a short time, and larger later, up to half a circle."""
    assert exposing_drive.off_after(0.0, 1000.0) == 0.0
    assert exposing_drive.off_after(0.1, 10.0) < 1e-3
    assert exposing_drive.off_after(0.1, 20.0) == pytest.approx(
        4 * exposing_drive.off_after(0.1, 10.0), rel=0.02
    )
    assert exposing_drive.off_after(0.1, 1000.0) > 1.0


def test_moves_agree_with_fine_steps():
    """The exercise's truth agrees with Runge-Kutta steps."""
    from kinoedu.curves.integrators import runge_kutta

    for pose, phi in zip(poses(3, 20), np.linspace(-0.78, 0.78, 20)):
        stepped = runge_kutta(pose, -1.5, math.tan(phi) / 2.5, 4.0, 400)[-1]
        assert pose_after(pose, -1.5, phi, 4.0, 2.5) == pytest.approx(stepped, abs=1e-8)


def test_the_board_tells_both_ways_and_moves_what_a_pose_looks_at():
    """The board shows both lengths; the second handle of a pose keeps its distance."""
    canvas = curves_board((0, 0, 0), (1, 9, 1), 2.0)
    assert f"{dubins_path((0, 0, 0), (1, 9, 1), 2.0).length:.3g} long" in repr(canvas)
    assert f"{reeds_shepp_path((0, 0, 0), (1, 9, 1), 2.0).length:.3g} long" in repr(canvas)
    for _, number, at in canvas.drawing.places:
        assert math.dist(at, (0, 0) if number == 1 else (1, 9)) == pytest.approx(3.0)


def test_ways_that_are_backed_are_dashed():
    """One line for each control, solid forwards and dashed backwards, to the trajectory's end."""
    from matplotlib.figure import Figure

    car, ax = Car(30, 10, 20), Figure().add_subplot()
    drive = Trajectory(car, (0, 0, 0), [(1, 0.5), (-1, 0.2)], [30, 20])
    cars.draw_drive(car, drive, ax)
    assert [line.get_linestyle() for line in ax.lines] == ["-", "--"]
    assert ax.lines[-1].get_xydata()[-1] == pytest.approx(drive.poses[-1][:2])
