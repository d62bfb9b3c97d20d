"""Pictures of failing cases of lesson 12: truth solid green, student's answer dashed brown."""

import math

import numpy as np

from ....curves import dubins
from ....curves.arcs import drive_arc
from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import Axes, Case, ValueExercise

# figures are imported inside the functions: matplotlib is only needed for failing cases


def arc(pose: Array, distance: float, curvature: float) -> Array:
    """Poses along an arc, shape (k, 3)."""
    k = 2 + int(min(40.0 * abs(distance * curvature), 2000.0))
    fractions = np.linspace(0.0, 1.0, k)
    return np.array([drive_arc(*pose, part * distance, curvature) for part in fractions])


def set_axes(truth: Array, value: Array | None, words: str, ax: Axes) -> tuple[float, Array | None]:
    """Set the axes around the true poses, and around the student's where they are near enough.

    Returns
    -------
    The length of an arrow, and the student's poses to draw or None.
    """
    from ....figures import palette, plane

    size = max(float(np.ptp(truth[:, :2], axis=0).max()), 1.0)
    shown = None if value is None or not len(value) or not np.isfinite(value).all() else value
    if shown is not None and np.abs(shown[:, :2] - truth[0, :2]).max() > 4.0 * size:
        plane.corner_note(
            get_message("picture.outside", what=get_message("picture.yours_short")),
            ax,
            colour=palette.YOURS,
        )
        shown = None
    elif shown is None:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    plane.frame((truth if shown is None else np.vstack([truth, shown]))[:, :2], ax, margin=0.2)
    plane.title(words, ax)
    return 0.18 * size, shown


def draw_moves(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw the driven arc, the poses at its ends, and the student's pose."""
    from ....figures import cars, palette

    pose, v, phi, t, wheelbase = case.given.values()
    way = arc(pose, v * t, math.tan(phi) / wheelbase)
    size, shown = set_axes(
        way, None if value is None else value[None], exercise.message(f"pictures.{case.kind}"), ax
    )
    ax.plot(*way[:, :2].T, "-", color=palette.TRUE, linewidth=2.6, zorder=3)
    cars.draw_pose(pose, size, get_message("car_picture.start"), ax, colour=palette.INK, below=True)
    cars.draw_pose(way[-1], size, get_message("picture.true"), ax, colour=palette.TRUE)
    if shown is not None:
        cars.draw_pose(
            shown[0], size, get_message("picture.yours_short"), ax, colour=palette.YOURS, below=True
        )


def draw_drives(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw the trajectory of all controls, the poses between them, and the student's poses."""
    from ....figures import cars, palette

    start, controls, durations, wheelbase = case.given.values()
    truth, ways = exercise.truth(case), [start[None]]
    for pose, (v, phi), t in zip(truth, controls, durations):
        ways.append(arc(pose, v * t, math.tan(phi) / wheelbase))
    size, shown = set_axes(np.vstack(ways), value, exercise.message(f"pictures.{case.kind}"), ax)
    ax.plot(*np.vstack(ways)[:, :2].T, "-", color=palette.TRUE, linewidth=2.6, zorder=3)
    for number, pose in enumerate(truth):
        cars.draw_pose(pose, 0.7 * size, str(number), ax, colour=palette.TRUE)
    for pose in [] if shown is None else shown:
        cars.draw_pose(pose, 0.7 * size, "", ax, colour=palette.YOURS)


def draw_steps(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw the arc, Euler's steps, and the student's steps."""
    from ....figures import cars, palette

    pose, v, phi, t, wheelbase, _ = case.given.values()
    truth = exercise.truth(case)
    size, shown = set_axes(truth, value, exercise.message(f"pictures.{case.kind}"), ax)
    exact = arc(pose, v * t, math.tan(phi) / wheelbase)
    ax.plot(*exact[:, :2].T, ":", color=palette.INK, linewidth=2.0, zorder=2)
    solid: palette.Style = {"color": palette.TRUE, "linewidth": 2.6, "markersize": 6, "zorder": 4}
    ax.plot(*truth[:, :2].T, "-o", label=get_message("picture.true"), **solid)
    if shown is not None:
        dashed: palette.Style = {
            "color": palette.YOURS,
            "linewidth": 2.2,
            "markersize": 6,
            "zorder": 5,
        }
        ax.plot(*shown[:, :2].T, "--s", label=get_message("picture.yours_short"), **dashed)
    cars.draw_pose(pose, size, "", ax, colour=palette.INK)
    ax.legend(fontsize=palette.TEXT_SIZE, loc="best")


def draw_orders(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw the errors against the step on logarithmic scales, with both orders at each slope."""
    from ....figures import palette, plane

    h, errors = case.given.values()
    ax.loglog(h, errors, "-o", color=palette.TREE, linewidth=2.6, markersize=8)
    truth, value = (exercise.as_asked(one, case) for one in (exercise.truth(case), value))
    for k, order in enumerate(truth):
        yours = (
            f"{value[k]:.3g}"
            if value is not None and k < len(value)
            else get_message("car_picture.none")
        )
        at = math.sqrt(h[k] * h[k + 1]), math.sqrt(errors[k] * errors[k + 1])
        name = get_message("car_picture.order", true=f"{order:.3g}", yours=yours)
        plane.label(at, name, ax, colour=palette.YOURS, offset=(9, -16))
    ax.margins(x=0.35, y=0.2)
    ax.set_xlabel(get_message("car_picture.step"), fontsize=palette.TEXT_SIZE)
    ax.set_ylabel(get_message("car_picture.error"), fontsize=palette.TEXT_SIZE)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1, which="both")
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_tangents(exercise: ValueExercise, case: Case, value: float | None, ax: Axes) -> None:
    """Draw the shortest of the four curves, its circles, and both lengths."""
    from ....figures import cars, palette, plane

    a, b, r = case.given.values()
    curve = min(
        (one for one in dubins.all_dubins_curves(a, b, r) if one.word[1] == "S"),
        key=lambda one: one.length,
    )
    centres = [
        p[:2] + side * r * np.array([-math.sin(p[2]), math.cos(p[2])])
        for p in (a, b)
        for side in (1, -1)
    ]
    plane.frame(
        np.vstack([curve.at(np.linspace(0.0, curve.length, 60))[:, :2], np.array(centres)]),
        ax,
        margin=0.3,
    )
    for centre in centres:
        plane.ring(centre, r, "", ax, colour=palette.OUTSIDE, style=":")
    cars.draw_curve(curve, ax, colour=palette.TRUE)
    cars.draw_pose(a, r, "a", ax, colour=palette.INK, below=True)
    cars.draw_pose(b, r, "b", ax, colour=palette.INK, below=True)
    true, yours = (
        get_message("car_picture.none") if one is None else f"{exercise.as_asked(one, case):.8g}"
        for one in (curve.length, value)
    )
    words = get_message("car_picture.lengths", word=curve.word, true=true, yours=yours)
    plane.corner_note(words, ax, colour=palette.YOURS)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_lost(value: tuple[float, float] | None, wheelbase: float, ax: Axes) -> None:
    """Draw the car's path, and the path of a program that uses phi for tan(phi)."""
    from ....figures import cars, palette, plane

    if value is None:
        plane.frame([(0, 0), (1, 1)], ax)
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
        return
    (phi, t), start = value, np.zeros(3)
    true, believed = arc(start, t, math.tan(phi) / wheelbase), arc(start, t, phi / wheelbase)
    plane.frame(np.vstack([true, believed])[:, :2], ax, margin=0.2)
    size = 0.15 * max(float(np.ptp(true[:, :2], axis=0).max()), 1.0)
    for way, colour, style, words in (
        (true, palette.TRUE, "-", "car"),
        (believed, palette.YOURS, "--", "program"),
    ):
        ax.plot(*way[:, :2].T, style, color=colour, linewidth=2.4, zorder=3)
        name, below = get_message(f"car_picture.{words}"), colour == palette.YOURS
        cars.draw_pose(way[-1], size, name, ax, colour=colour, below=below)
    plane.title(get_message("exposing_drive.picture"), ax)
