"""Pictures of failing cases of lesson 7: truth solid green, student's answer dashed brown."""

from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import Axes, Case, ValueExercise

# figures are imported inside the functions: matplotlib is only needed for failing cases


def draw_membership(exercise: ValueExercise, case: Case, value: object, ax: Axes) -> None:
    """Draw the polygon, q, and dashed lines through the edges that have q on their right."""
    from ....figures import palette, plane

    q, P = case.given["q"], case.given["P"]
    plane.frame(np.vstack([P, q]), ax, margin=0.25)
    plane.polygon(P, ax)
    for a, b in zip(P, np.roll(P, -1, axis=0)):
        (x, y), (u, v) = b - a, q - a
        if x * v - y * u < 0:
            plane.line((-y, x, y * a[0] - x * a[1]), "", ax, colour=palette.TRUE, style=":")
            plane.segment(a, b, "", ax, colour=palette.TRUE, width=4.0)
    plane.dot(q, "q", ax)
    write_answer_and_title(exercise, case, value, ax)


def draw_segments(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw both segments, their common points, and the student's points."""
    from ....figures import palette, plane

    p1, p2, p3, p4 = case.given.values()
    plane.frame([p1, p2, p3, p4], ax, margin=0.25)
    plane.segment(p1, p2, "", ax, colour=palette.OBSTACLE, width=5.0)
    plane.segment(p3, p4, "", ax, colour=palette.TREE, width=2.5)
    for name, end, lift in (("p1", p1, 9), ("p2", p2, 9), ("p3", p3, -19), ("p4", p4, -19)):
        plane.label(
            end, name, ax, colour=palette.OBSTACLE if lift > 0 else palette.TREE, offset=(5, lift)
        )
    for point in exercise.truth(case):
        plane.dot(point, "", ax, colour=palette.TRUE)
    shown: Any = [] if value is None else value[np.isfinite(value).all(axis=1)][:20]
    for point in shown:
        plane.dot(point, "", ax, colour=palette.YOURS, marker="X")
    words = (
        get_message("picture.no_answer")
        if value is None
        else get_message(
            "collision_picture.points", yours=len(value), true=len(exercise.truth(case))
        )
    )
    plane.corner_note(words, ax, colour=palette.YOURS)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_pair(exercise: ValueExercise, case: Case, value: object, ax: Axes) -> None:
    """Draw both polygons, and a separating edge with its line where there is one."""
    draw_polygons(case.given["P1"], case.given["P2"], ax)
    write_answer_and_title(exercise, case, value, ax)


def draw_polygons(P: Array, Q: Array, ax: Axes) -> None:
    """Draw two polygons, and a separating line where there is one."""
    from ....figures import palette, plane

    plane.frame(np.vstack([P, Q]), ax, margin=0.2)
    for ring, name, colour in ((P, "P1", palette.OBSTACLE), (Q, "P2", palette.TREE)):
        ax.fill(*ring.T, facecolor=colour, edgecolor=colour, alpha=0.4, linewidth=2.0, zorder=2)
        plane.label(ring[0], name, ax, colour=colour, offset=(5, 5))
    for ring, other in ((P, Q), (Q, P)):
        for a, b in zip(ring, np.roll(ring, -1, axis=0)):
            (x, y), way = b - a, other - a
            if (x * way[:, 1] - y * way[:, 0] < 0).all():
                plane.line((-y, x, y * a[0] - x * a[1]), "", ax, colour=palette.TRUE, style=":")
                plane.segment(a, b, "", ax, colour=palette.TRUE, width=4.0)
                return


def draw_grown_obstacle(exercise: ValueExercise, case: Case, value: Array | None, ax: Axes) -> None:
    """Draw the obstacle, the robot at its reference point, and both C-obstacles."""
    from ....figures import palette, plane

    robot, obstacle, truth = case.given["robot"], case.given["obstacle"], exercise.truth(case)
    shown = np.empty((0, 2)) if value is None else value[np.isfinite(value).all(axis=1)][:60]
    ground = np.vstack([robot, obstacle, truth, [(0.0, 0.0)]])
    near = shown[
        np.abs(shown - truth.mean(axis=0)).max(axis=1) <= 2.0 * np.ptp(ground, axis=0).max()
    ]
    plane.frame(np.vstack([ground, near]), ax, margin=0.15)
    ax.fill(*obstacle.T, facecolor=palette.OBSTACLE, zorder=3)
    ax.fill(*robot.T, facecolor=palette.ROBOT, alpha=0.6, zorder=3)
    ax.fill(*truth.T, facecolor="none", edgecolor=palette.TRUE, linewidth=2.5, zorder=4)
    plane.dot((0, 0), get_message("collision_picture.reference"), ax)
    if len(shown):
        closed = np.vstack([shown, shown[:1]])
        dashed: palette.Style = {"color": palette.YOURS, "linewidth": 2.2}
        ax.plot(*closed.T, "--o", zorder=5, scalex=False, scaley=False, **dashed)
    if value is None:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_gap(exercise: Any, value: tuple[Array, Array] | None, ax: Axes) -> None:
    """Draw the two polygons that a student returned."""
    from ....figures import palette, plane

    if value is None:
        plane.frame([(0, 0), (1, 1)], ax)
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    else:
        draw_polygons(value[0], value[1], ax)
    plane.title(exercise.message("picture"), ax)


def write_answer_and_title(exercise: ValueExercise, case: Case, value: object, ax: Axes) -> None:
    """Write the student's answer into the corner, and the title."""
    from ....figures import palette, plane

    plane.corner_note(
        get_message("picture.no_answer")
        if value is None
        else get_message("picture.yours", value=value),
        ax,
        colour=palette.YOURS,
    )
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)
