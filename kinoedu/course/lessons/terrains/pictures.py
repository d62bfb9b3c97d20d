"""Pictures of failing cases of lesson 10.

The right answer is green, the student's is brown.
"""

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import Axes, Case, Exercise, format_value
from ...shapes import Value
from .motions import find_cuts, find_motion_fault, sample_motion

# functions import figures themselves: matplotlib is needed only where an answer is wrong


def draw_costs(exercise: Exercise, case: Case, found: float | None, truth: str, ax: Axes) -> None:
    """Draw the cells with their costs, and the motion cut where it enters another cell."""
    from ....figures import palette, plane

    cost, a, b = case.given.values()
    rows, columns = cost.shape
    ax.imshow(
        cost,
        origin="lower",
        extent=(0, columns, 0, rows),
        cmap="Greys",
        vmin=0.0,
        vmax=2.2 * cost.max(),
        zorder=0,
    )
    for j, i in np.ndindex(rows, columns):
        look: palette.Style = {"fontsize": palette.TEXT_SIZE, "color": palette.INK, "zorder": 3}
        ax.text(i + 0.08, j + 0.08, f"{cost[j, i]:g}", **look)
    places = a + find_cuts(a, b)[:, None] * (b - a)
    ax.plot(*np.array([a, b]).T, color=palette.PATH, linewidth=3.0, zorder=4)
    ax.plot(*places.T, "o", color=palette.INK, markersize=6, zorder=5)
    set_cell_axes(ax, columns, rows)
    plane.dot(a, "a", ax, colour=palette.TREE)
    plane.dot(b, "b", ax, colour=palette.INK)
    yours = (
        get_message("picture.no_answer")
        if found is None
        else get_message("picture.yours", value=format_value(found))
    )
    plane.title(f"{exercise.message(f'pictures.{case.kind}')}\n{truth}; {yours}", ax)


def set_cell_axes(ax: Axes, columns: int, rows: int) -> None:
    """Set equal axes with a line at every side of a cell."""
    from ....figures import palette

    ax.set_aspect("equal")
    ax.set_xlim(-0.05, columns + 0.05)
    ax.set_ylim(-0.05, rows + 0.05)
    ax.set_xticks(range(columns + 1))
    ax.set_yticks(range(rows + 1))
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(color=palette.OUTSIDE, linewidth=0.8, zorder=1)


def draw_table(exercise: Exercise, case: Case, found: Array | None, truth: Value, ax: Axes) -> None:
    """Draw the table with the repeats in green and the student's wrong entries in brown."""
    from ....figures import palette, plane

    table = case.given["table"]
    n, m = table.shape
    ax.set_xlim(-0.6, m - 0.3)
    ax.set_ylim(n - 0.4, -1.0)
    ax.axis("off")
    right = {(row, c) for i, j, c in truth for row in (i, j)}
    triples = np.reshape([] if found is None else found, (-1, 3)).tolist()
    named = {(row, c) for i, j, c in triples for row in (i, j)}
    size = palette.TEXT_SIZE if n <= 12 else 10
    for (row, c), value in np.ndenumerate(table):
        colour = palette.YOURS if (row, c) in named else palette.INK
        colour = palette.TRUE if (row, c) in right else colour
        weight = "bold" if (row, c) in right | named else "normal"
        ax.text(c, row, f"{value:.7g}", fontsize=size, color=colour, fontweight=weight, va="center")
    for row in range(n):
        ax.text(-0.5, row, f"{row}", fontsize=size, color=palette.OBSTACLE, va="center")
    for c in range(m):
        look: palette.Style = {"fontsize": size, "color": palette.OBSTACLE, "va": "center"}
        ax.text(c, -0.8, get_message("repeated_rows.column", number=c), **look)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_runs(exercise: Exercise, case: Case, found: Array | None, truth: Array, ax: Axes) -> None:
    """Draw every run with a path as a dot, with quartiles and medians.

    The right ones are green, the student's are brown and below.
    """
    from ....figures import palette, plane

    lengths, planners, _ = case.given.values()
    for i, (runs, row) in enumerate(zip(lengths, truth)):
        ends = np.isfinite(runs)
        look: palette.Style = {"color": palette.TREE, "markersize": 6, "alpha": 0.6, "zorder": 3}
        ax.plot(runs[ends], np.full(ends.sum(), i), "o", **look)
        rows = [(row, 0.15, palette.TRUE)]
        if found is not None and len(found) == len(truth):
            rows.append((found[i], 0.3, palette.YOURS))
        for (_, low, median, high), below, colour in rows:
            ax.plot([low, high], [i + below] * 2, color=colour, linewidth=4.0, zorder=4)
            look = {"color": colour, "markeredgecolor": "white", "zorder": 5}
            ax.plot(median, i + below, "D", markersize=9, **look)
    ax.set_yticks(range(len(planners)), planners, fontsize=palette.TEXT_SIZE)
    ax.set_ylim(len(planners) - 0.4, -0.5)
    ax.set_xlabel(get_message("comparisons.cost"), fontsize=palette.TEXT_SIZE)
    ax.tick_params(labelsize=palette.TEXT_SIZE)
    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_samples_on(value: Value, text: str, ax: Axes) -> None:
    """Draw a small terrain, a motion and its samples."""
    from ....figures import palette, plane
    from ....figures.drawing import draw_cells

    if value is None or find_motion_fault(*value):
        plane.frame([(0, 0), (3, 2)], ax)
        note = get_message("picture.no_answer" if value is None else "exposing_motion.outside")
        plane.corner_note(note, ax, colour=palette.YOURS)
    else:
        free, a, b = value
        rows, columns = free.shape
        draw_cells(free, (0, columns, 0, rows), ax)
        ax.plot(*np.array([a, b]).T, color=palette.PATH, linewidth=3.0, zorder=4)
        look: palette.Style = {"color": palette.TREE, "markeredgecolor": "white", "zorder": 5}
        ax.plot(*sample_motion(a, b).T, "o", markersize=8, **look)
        set_cell_axes(ax, columns, rows)
    plane.title(text, ax)
