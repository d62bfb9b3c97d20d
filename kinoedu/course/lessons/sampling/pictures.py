"""Pictures of failing cases in the unit cube.

The right answer is green, the student's is brown.
"""

from textwrap import fill

import numpy as np
from numpy.typing import ArrayLike

from ....geometry.checks import Array
from ....messages import get_message
from ....sampling import largest_empty_ball, sukharev_grid, van_der_corput
from ...exercise import Axes, Case, Exercise

# functions import figures themselves: matplotlib is needed only where an answer is wrong

CORNERS = [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]
FAR = 3.0  # points farther out are described, not drawn
BESIDE = 1.07  # x of labels, to the right of the unit square


def draw_points(
    exercise: Exercise,
    case: Case,
    found: Array | None,
    truth: Array | None,
    ax: Axes,
    *,
    cells: int = 0,
) -> None:
    """Draw the right points as rings and the student's as crosses.

    Points in space are drawn by their first two coordinates.

    Parameters
    ----------
    cells : number of cells to draw along each side.
    """
    from ....figures import palette, plane

    shown = np.empty((0, 2)) if found is None else project_points(found)
    near = shown[(np.abs(shown) <= FAR).all(axis=1)]  # false for nan
    d = next((points.shape[1] for points in (truth, found) if points is not None), 2)
    draw_square(ax, near, [(0, 0.5), (1, 0.5)] if d == 1 else CORNERS)
    for share in np.arange(1, cells) / cells if cells else ():
        plane.segment((share, 0), (share, 1), "", ax, colour=palette.OUTSIDE, width=0.9)
        plane.segment((0, share), (1, share), "", ax, colour=palette.OUTSIDE, width=0.9)
    if truth is not None:
        ring: palette.Style = {
            "markerfacecolor": "none",
            "markeredgecolor": palette.TRUE,
            "markeredgewidth": 2.2,
            "markersize": 11,
        }
        ax.plot(*project_points(truth).T, "o", label=get_message("picture.true"), zorder=5, **ring)
    if len(near):
        size = 9 if len(near) <= 150 else 4
        look: palette.Style = {"color": palette.YOURS, "markeredgewidth": 2.2, "zorder": 6}
        ax.plot(*near.T, "x", markersize=size, label=get_message("picture.yours_short"), **look)
    else:
        text = get_message("picture.no_answer" if found is None else "samples.elsewhere")
        draw_label(text, 0.05, ax, colour=palette.YOURS)
    if truth is not None or len(near):
        ax.legend(fontsize=palette.TEXT_SIZE, loc="upper right", framealpha=1.0)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def project_points(points: Array) -> Array:
    """Return positions in the plane for points (n, d).

    Points of a line are put at half height; points in space lose their third coordinate.
    """
    if points.shape[1] == 1:
        return np.column_stack([points[:, 0], np.full(len(points), 0.5)])
    return points[:, :2].reshape(-1, 2)


def draw_square(ax: Axes, others: Array, outline: ArrayLike = CORNERS) -> None:
    """Draw the outline of the unit square, or a line, with room for outliers and labels."""
    from ....figures import palette, plane

    plane.frame(np.vstack([[(0, 0), (1.45, 1)], others]), ax, margin=0.06)
    ax.plot(*np.transpose(outline), color=palette.INK, linewidth=1.8, zorder=2)


def draw_label(text: str, y: float, ax: Axes, *, colour: str) -> None:
    """Write a label to the right of the square."""
    from ....figures import palette
    from ....figures.names import HALO

    look: palette.Style = {
        "fontsize": palette.TEXT_SIZE,
        "fontweight": "bold",
        "path_effects": HALO,
    }
    ax.text(BESIDE, y, fill(text, 16), color=colour, **look)


def draw_mirrored(exercise: Exercise, case: Case, found: float | None, ax: Axes) -> None:
    """Draw the interval from 0 to 1, the right and the student's number, and the digits."""
    from ....figures import palette, plane
    from ....figures.digits import digits_of, mirrored_digits

    i, base = case.given.values()
    truth = float(van_der_corput(1, base, start=i)[0])
    plane.frame([(0, -0.3), (1, 0.3)], ax, margin=0.06)
    plane.segment((0, 0), (1, 0), "", ax, colour=palette.OBSTACLE)
    if len(digits_of(i, base)) <= 24:
        both = {"digits": digits_of(i, base), "mirrored": mirrored_digits(i, base)}
        text = get_message("samples.mirrored", i=i, base=base, **both)
        ax.text(
            0.5, 0.27, fill(text, 60), ha="center", fontsize=palette.TEXT_SIZE, color=palette.INK
        )
    plane.dot((truth, 0), "", ax, colour=palette.TRUE)
    text = get_message("picture.should_be", value=f"{truth:.6g}")
    plane.label((truth, 0), text, ax, colour=palette.TRUE, offset=(9, 14))
    if found is not None and -0.1 <= found <= 1.1:
        plane.dot((found, 0), "", ax, colour=palette.YOURS, marker="X")
        text = get_message("picture.yours", value=f"{found:.6g}")
        plane.label((found, 0), text, ax, colour=palette.YOURS, offset=(9, -32))
    else:
        text = (
            get_message("picture.no_answer")
            if found is None
            else get_message("picture.yours", value=f"{found:.6g}")
        )
        plane.corner_note(text, ax, colour=palette.YOURS)
    for words in ax.texts:
        words.set_in_layout(False)  # they are inside the axes, and would push the title out
    ax.set_yticks([])
    ax.set_ylabel("")
    ax.set_xlabel("")
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_holes(exercise: Exercise, case: Case, found: Array | None, ax: Axes) -> None:
    """Draw the points, the largest empty ball, and the student's bounds as circles."""
    from ....figures import palette, plane

    points = case.given["points"]
    ball = largest_empty_ball(points)
    draw_square(ax, np.empty((0, 2)))
    (inside,) = ax.fill(*np.transpose(CORNERS), alpha=0.0)
    low, high = (np.nan, np.nan) if found is None else found
    for radius, colour, style in (
        (ball.radius, palette.TRUE, "-"),
        (low, palette.YOURS, ":"),
        (high, palette.YOURS, "--"),
    ):
        if 0 < radius < FAR:
            for circle in plane.ring(ball.centre, radius, "", ax, colour=colour, style=style):
                circle.set_clip_path(inside)
    ax.plot(*points.T, "o", color=palette.TREE, markersize=7, zorder=5)
    plane.dot(ball.centre, "", ax, colour=palette.TRUE, marker="X")
    text = (
        get_message("picture.no_answer")
        if found is None
        else get_message("samples.bounds", low=f"{low:.4f}", high=f"{high:.4f}")
    )
    draw_label(text, 0.05, ax, colour=palette.YOURS)
    draw_label(
        get_message("picture.should_be", value=f"{ball.radius:.4f}"), 0.85, ax, colour=palette.TRUE
    )
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_corridor(corridor: Array | None, ax: Axes) -> None:
    """Draw the points of all five grids, the corridor, and crosses on the points inside it."""
    from ....figures import palette

    draw_square(ax, np.empty((0, 2)))
    points = np.vstack([sukharev_grid(k * k) for k in (1, 2, 4, 8, 16)])
    ax.plot(*points.T, "o", color=palette.TREE, markersize=4, zorder=4)
    if corridor is None or not (np.abs(corridor) <= FAR).all():
        text = get_message("picture.no_answer" if corridor is None else "samples.elsewhere")
        draw_label(text, 0.05, ax, colour=palette.YOURS)
        return
    x0, y0, x1, y1 = corridor
    look: palette.Style = {
        "facecolor": palette.PATH,
        "alpha": 0.4,
        "edgecolor": palette.YOURS,
        "linewidth": 1.5,
    }
    ax.fill([x0, x1, x1, x0], [y0, y0, y1, y1], **look, zorder=3)
    inside = points[((points > (x0, y0)) & (points < (x1, y1))).all(axis=1)]
    ax.plot(*inside.T, "x", color=palette.YOURS, markersize=10, markeredgewidth=2.5, zorder=6)
