"""Pictures of failing cases of lesson 5: truth solid green, student's answer dashed brown."""

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ....robots import TwoLinkArm
from ....spaces.angles import angle_difference, wrap_angle
from ...exercise import Axes, Case, ValueExercise
from ...shapes import Value

# figures are imported inside the functions: matplotlib is only needed for failing cases

FLAG = np.array([(0, 0), (2, 0), (2, 0.6), (0.6, 0.6), (0.6, 1.2), (0, 1.2)])
APART = 3.4  # distance between the centres of two circles


def write_both(truth: Value, value: object, ax: Axes) -> None:
    """Write both numbers into the lower left corner."""
    from ....figures import palette, plane

    yours = get_message("configuration_picture.none") if value is None else f"{value:.4g}"
    plane.corner_note(
        get_message("configuration_picture.both", true=f"{float(truth):.4g}", yours=yours),
        ax,
        colour=palette.YOURS,
    )


def draw_shorter_arcs(exercise: ValueExercise, case: Case, value: float | None, ax: Axes) -> None:
    """Draw a circle for each angle, the shorter arc from a to b, and the student's distance."""
    from ....figures import configurations, palette, plane

    a, b = np.atleast_1d(case.given["a"]), np.atleast_1d(case.given["b"])
    middles = APART * np.arange(len(a))
    plane.frame([(-1.5, -1.9), (middles[-1] + 1.5, 1.5)], ax, margin=0.05)
    ax.set_axis_off()
    for x, p, q in zip(middles, a, b):
        turn = angle_difference(wrap_angle(p), wrap_angle(q))
        plane.ring((x, 0.0), 1.0, "", ax, colour=palette.OUTSIDE)
        configurations.draw_turn((x, 0), p, turn, 1.0, "", ax, colour=palette.TRUE)
        plane.label(
            (x, 0.0), f"{abs(turn):.4g}", ax, colour=palette.TRUE, offset=(0, -5), ha="center"
        )
        if value is not None and len(a) == 1 and 0.0 < abs(value) < 20.0:
            sense = float(np.sign(turn) or 1.0)
            configurations.draw_turn(
                (x, 0), p, sense * value, 0.8, "", ax, colour=palette.YOURS, style="--"
            )
        for angle, name, gap in ((p, "a", 16), (q, "b", 30)):  # the labels must not overlap
            u, v = np.cos(angle), np.sin(angle)
            plane.dot((x + u, v), "", ax)
            plane.label((x + u, v), name, ax, offset=(gap * u, gap * v - 5), ha="center")
    write_both(exercise.truth(case), value, ax)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_moved(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw a flag before, after, and as the student's matrix moves it."""
    from ....figures import palette, plane

    truth = exercise.truth(case)
    size = max(1.0, 0.3 * float(np.abs(truth).max())) if len(truth) == 3 else 1.0
    flag = size * FLAG
    right = transform_points(truth, flag)
    yours = None if value is None or not np.isfinite(value).all() else transform_points(value, flag)
    reach = 3.0 * size + float(np.abs(right).max())
    seen = yours if yours is not None and np.abs(yours).max() <= 2.0 * reach else None
    plane.frame(np.vstack([flag, right, right if seen is None else seen]), ax, margin=0.15)
    draw_outline(
        flag, get_message("configuration_picture.before"), ax, colour=palette.OUTSIDE, style="-"
    )
    draw_outline(right, get_message("picture.true"), ax, colour=palette.TRUE, style="-")
    if seen is not None:
        draw_outline(seen, get_message("picture.yours_short"), ax, colour=palette.YOURS, style="--")
    else:
        words = (
            get_message("picture.no_answer")
            if yours is None
            else get_message("picture.outside", what=get_message("picture.yours_short"))
        )
        plane.corner_note(words, ax, colour=palette.YOURS)
    plane.dot((0, 0), "", ax)
    ax.legend(fontsize=palette.TEXT_SIZE, loc="best")
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_outline(ring: Value, words: str, ax: Axes, *, colour: str, style: str) -> None:
    """Draw a closed outline with an entry in the legend."""
    points = np.vstack([ring, ring[:1]])
    ax.plot(*points.T, style, color=colour, linewidth=2.6, label=words, zorder=4)


def transform_points(matrix: Array, points: Array) -> Array:
    """Images of points (n, 2) under a matrix (2, 2) or (3, 3)."""
    moved = points @ matrix[:2, :2].T
    return moved + matrix[:2, 2] if len(matrix) == 3 else moved


def draw_joints(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw base, elbow and tip of the arm and of the student's arm."""
    from ....figures import configurations, palette, plane

    l1, l2 = case.given["l1"], case.given["l2"]
    frame_arm(l1 + l2, ax)
    truth = np.vstack([(0.0, 0.0), exercise.truth(case)])
    configurations.draw_links(truth, "", ax, colour=palette.TRUE)
    if value is not None and np.isfinite(value).all() and np.abs(value).max() < 2.0 * (l1 + l2):
        configurations.draw_links(
            np.vstack([(0.0, 0.0), value]), "", ax, colour=palette.YOURS, style="--"
        )
        name = get_message("configuration_picture.your_tip")
        plane.label(value[1], name, ax, colour=palette.YOURS, offset=(9, -18))
    else:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    plane.label(truth[2], get_message("configuration_picture.tip"), ax, colour=palette.TRUE)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_solutions(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw the arm's reach, the target, the right arms and the student's arms."""
    from ....figures import configurations, palette, plane

    l1, l2, p = case.given.values()
    truth = exercise.truth(case)
    draw_reach(l1, l2, p, ax)
    for q in [] if isinstance(truth, ValueError) else truth:
        configurations.draw_links(arm_points(l1, l2, q), "", ax, colour=palette.TRUE)
    draw_students(
        l1, l2, [] if value is None else [q for q in value[:6] if np.isfinite(q).all()], ax
    )
    if value is None or len(value) == 0:
        words = (
            get_message("picture.no_answer")
            if value is None
            else get_message("configuration_picture.no_solution")
        )
        plane.corner_note(words, ax, colour=palette.YOURS)
    plane.dot(p, "p", ax, marker="*")
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_missed(value: tuple[float, float, Array] | None, answers: Value, ax: Axes) -> None:
    """Draw the arm's reach, the target, and the arms at the program's angles."""
    from ....figures import palette, plane

    if value is None:
        plane.frame([(0, 0), (1, 1)], ax)
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
        return
    l1, l2, p = value
    draw_reach(l1, l2, p, ax)
    draw_students(l1, l2, answers, ax)
    plane.dot(p, "p", ax, marker="*")
    plane.title(get_message("exposing_reach.picture"), ax)


def draw_students(l1: float, l2: float, answers: Value, ax: Axes) -> None:
    """Draw arms at the configurations of an answer."""
    from ....figures import configurations, palette

    for q in answers:
        configurations.draw_links(arm_points(l1, l2, q), "", ax, colour=palette.YOURS, style="--")


def draw_reach(l1: float, l2: float, p: Array, ax: Axes) -> None:
    """Draw the ring that an arm's tip reaches, in axes that also show the target."""
    from ....figures import configurations

    frame_arm(max(l1 + l2, 1.05 * float(np.hypot(*p))), ax)
    configurations.draw_reach(TwoLinkArm(l1, l2, 0.0), ax)


def frame_arm(reach: float, ax: Axes) -> None:
    """Set the axes to show the whole reach of an arm at the origin."""
    from ....figures import plane

    plane.frame([(-reach, -reach), (reach, reach)], ax, margin=0.12)


def arm_points(l1: float, l2: float, q: Array) -> Array:
    """Base, elbow and tip, shape (3, 2)."""
    return np.vstack([(0.0, 0.0), *TwoLinkArm(l1, l2, 0.0).joints(q)])


def draw_mechanism(exercise: ValueExercise, case: Case, value: float | None, ax: Axes) -> None:
    """Draw bodies in a ring, pins joined to their bodies, the ground as a square; both numbers."""
    from ....figures import palette, plane

    bodies, joints = case.given["bodies"], case.given["joints"]
    angles = np.pi * (-0.5 - 2.0 * np.arange(bodies + 1) / (bodies + 1))
    at = np.column_stack([np.cos(angles), np.sin(angles)])
    plane.frame([(-1.3, -1.5), (1.3, 1.3)], ax, margin=0.02)
    ax.set_axis_off()
    for number, held in enumerate(joints):
        pin = 0.82 * at[held].mean(axis=0) + 0.02 * number
        for body in held:
            plane.segment(pin, at[body], "", ax, colour=palette.OBSTACLE, width=3.0)
        white: palette.Style = {
            "color": "white",
            "markeredgecolor": palette.INK,
            "markeredgewidth": 2.0,
        }
        ax.plot(*pin, "o", markersize=13, zorder=7, **white)
    for body, place in enumerate(at):
        marker, colour = ("s", palette.INK) if body == 0 else ("o", palette.TREE)
        ax.plot(*place, marker, color=colour, markersize=26, zorder=7)
        centred: palette.Style = {"ha": "center", "va": "center", "fontsize": palette.TEXT_SIZE}
        ax.text(place[0], place[1], str(body), color="white", zorder=8, **centred)
    write_both(exercise.truth(case), value, ax)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)
