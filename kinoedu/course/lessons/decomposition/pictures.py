"""Pictures of failing cases of lesson 3: truth solid, student's answer dashed brown."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ....decomposition.trapezoidation import corners_of
from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import Axes, Case, Exercise, Given
from ...shapes import Value

# figures are imported inside the functions: matplotlib is only needed for failing cases


def draw_crossed(
    case: Case, truth: NDArray[np.int64], value: NDArray[np.int64] | None, ax: Axes
) -> None:
    """Draw the numbered edges; each crossed one with its place in both orders."""
    from ....figures import palette, plane

    x, edges = case.given["x"], case.given["edges"]
    plane.frame(np.vstack([edges[:, :2], edges[:, 2:], [(x, edges[0, 1])]]), ax, margin=0.15)
    for number, (ax_, ay, bx, by) in enumerate(edges):
        plane.segment((ax_, ay), (bx, by), "", ax, colour=palette.OBSTACLE)
        if len(edges) <= 12:
            middle = ((ax_ + bx) / 2, (ay + by) / 2)
            plane.label(middle, f"edge {number}", ax, colour=palette.OBSTACLE, offset=(6, -16))
    draw_sweep_line(x, ax)
    answered = [] if value is None else value.tolist()
    for place, edge in enumerate(truth.tolist()):
        ax_, ay, bx, by = edges[edge]
        yours = ", ".join(str(k) for k, other in enumerate(answered) if other == edge) or "-"
        height = ay + (x - ax_) / (bx - ax_) * (by - ay)
        name = get_message("picture.place", true=place, yours=yours) if len(truth) <= 8 else ""
        plane.dot((x, height), name, ax, colour=palette.YOURS)
    if value is None:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)


def draw_intervals(case: Case, truth: Array, value: Array | None, ax: Axes) -> None:
    """Draw the world, the line with its free intervals, and the student's beside it."""
    from ....figures import palette, plane

    x = case.given["x"]
    draw_ground(case.given, ax)
    draw_sweep_line(x, ax)
    for low, high in truth:
        plane.segment((x, low), (x, high), "", ax, colour=palette.TRUE, width=6.0)
    aside = x + 0.03 * float(np.ptp(ax.get_xlim()))
    for low, high in [] if value is None else value[np.isfinite(value).all(axis=1)][:50]:
        plane.segment(
            (aside, low), (aside, high), "", ax, colour=palette.YOURS, style="--", width=4.0
        )
        ticks: palette.Style = {"color": palette.YOURS, "markersize": 12, "markeredgewidth": 3}
        ax.plot([aside, aside], [low, high], "_", zorder=5, **ticks)
    note = (
        get_message("picture.no_answer")
        if value is None
        else get_message("picture.stretches", true=len(truth), yours=len(value))
    )
    plane.corner_note(note, ax, colour=palette.YOURS)


def draw_cells(world: Given, truth: Array, value: Array | None, ax: Axes) -> None:
    """Draw the world, the true cells pale, the student's dashed, and wrong ones filled brown."""
    from ....figures import palette, plane

    draw_ground(world, ax)
    for outline in corners_of(truth):
        ax.fill(*outline.T, facecolor=palette.CELL, edgecolor=palette.TREE, linewidth=2.0, zorder=3)
    if value is None:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
        return
    shown = value[np.isfinite(value).all(axis=1)][:300]
    right = np.array(
        [
            np.abs(truth - row).max(axis=1).min(initial=np.inf) <= 1e-6 * (1 + np.abs(row).max())
            for row in shown
        ],
        bool,
    )
    for outline, good in zip(corners_of(shown), right):
        if good:
            closed = np.vstack([outline, outline[:1]])
            dashed: palette.Style = {"color": palette.YOURS, "linewidth": 2.0, "zorder": 4}
            ax.plot(*closed.T, "--", scalex=False, scaley=False, **dashed)
        else:
            face = (*bytes.fromhex(palette.YOURS[1:]), 40)
            ax.fill(
                *outline.T,
                facecolor=[c / 255 for c in face],
                edgecolor=palette.YOURS,
                linewidth=3,
                linestyle="--",
                zorder=5,
            )
    plane.frame(world["boundary"], ax, margin=0.2)
    plane.corner_note(
        get_message("picture.cells", true=len(truth), yours=len(value), good=int(right.sum())),
        ax,
        colour=palette.YOURS,
    )


def draw_pairs(
    cells: Array, truth: NDArray[np.int64], value: NDArray[np.int64] | None, ax: Axes
) -> None:
    """Draw the numbered cells, true pairs joined by solid lines, the student's by dashed ones."""
    from ....figures import palette, plane

    centres = number_cells(cells, ax)
    for i, j in truth:
        plane.segment(centres[i], centres[j], "", ax, colour=palette.TRUE, width=4.0)
    for i, j in [] if value is None else value[(np.isin(value, np.arange(len(cells)))).all(axis=1)]:
        plane.segment(centres[i], centres[j], "", ax, colour=palette.YOURS, style="--")
    note = (
        get_message("picture.no_answer")
        if value is None
        else get_message("picture.pairs", true=len(truth), yours=len(value))
    )
    plane.corner_note(note, ax, colour=palette.YOURS)


def draw_cell_path(
    given: Given,
    truth: Array | None,
    value: Array | None,
    ax: Axes,
    is_free: Callable[..., bool],
) -> None:
    """Draw the cells, a right path, the student's path, and its first motion that is not free."""
    from ....figures import palette, plane

    number_cells(given["trapezoids"], ax)
    if truth is not None:
        ax.plot(*truth.T, "-", color=palette.TRUE, linewidth=3, zorder=5)
    if value is None:
        plane.corner_note(get_message("picture.yours", value="None"), ax, colour=palette.YOURS)
    elif len(value) and np.isfinite(value).all():
        ax.plot(
            *value.T,
            "o--",
            color=palette.YOURS,
            linewidth=2.5,
            markersize=5,
            zorder=6,
            scalex=False,
            scaley=False,
        )
        cells, motions = given["trapezoids"], range(len(value) - 1)
        hit = next((i for i in motions if not is_free(value[i], value[i + 1], cells)), None)
        if hit is not None:
            plane.segment(
                value[hit],
                value[hit + 1],
                get_message("picture.contact"),
                ax,
                colour=palette.CONTACT,
            )
    plane.dot(given["start"], "start", ax, colour=palette.START, marker="s")
    plane.dot(given["goal"], "goal", ax, colour=palette.GOAL, marker="*")


def draw_middles(
    cells: Array,
    pairs: Value,
    shared: Callable[..., Value],
    found: Callable[..., Array],
    ax: Axes,
) -> None:
    """Draw the cells, their common walls, and crosses for middles that are not on them."""
    from ....figures import palette, plane

    number_cells(cells, ax)
    for i, j in pairs:
        x, low, high = shared(cells[i], cells[j])
        y = found(cells[i], cells[j])[1]
        plane.segment((x, low), (x, high), "", ax, colour=palette.TRUE, width=6.0)
        colour, marker = (palette.INK, "o") if low < y < high else (palette.YOURS, "X")
        plane.dot((x, y), "", ax, colour=colour, marker=marker)


def draw_outline(boundary: Array, ax: Axes) -> None:
    """Draw the vertices of an invalid world in their order, as far as there are any."""
    from ....figures import palette, plane

    shown = boundary[np.isfinite(boundary).all(axis=1)]
    plane.frame(np.vstack([shown, np.zeros((1 - min(len(shown), 1), 2))]), ax, margin=0.15)
    ax.plot(*np.vstack([shown, shown[:1]]).T, "o--", color=palette.YOURS, linewidth=2.5)
    if len(shown) == 0:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)


def set_title(exercise: Exercise, case: Case, ax: Axes) -> None:
    """Set the title for this kind of input."""
    from ....figures import plane

    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def draw_ground(world: Given, ax: Axes) -> None:
    """Draw the outside grey, the inside white and obstacles solid."""
    from ....figures import palette, plane

    plane.frame(world["boundary"], ax, margin=0.2)
    ax.set_facecolor(palette.GRID["color"])
    look: palette.Style = {"facecolor": palette.FREE, "edgecolor": palette.OBSTACLE, "linewidth": 2}
    ax.fill(*np.asarray(world["boundary"]).T, zorder=1, **look)
    for obstacle in world["obstacles"]:
        plane.polygon(obstacle, ax, numbers=False)


def number_cells(cells: Array, ax: Axes) -> Array:
    """Draw numbered cells on solid ground, and return their centres, (n, 2)."""
    from ....figures import palette, plane

    outlines = corners_of(cells)
    centres = np.column_stack([cells[:, :2].mean(axis=1), cells[:, 2:].mean(axis=1)])
    plane.frame(outlines.reshape(-1, 2), ax, margin=0.15)
    ax.set_facecolor(palette.GRID["color"])
    for number, outline in enumerate(outlines):
        ax.fill(*outline.T, facecolor=palette.CELL, edgecolor=palette.TREE, linewidth=1.5, zorder=1)
        if len(cells) <= 25:
            plane.label(centres[number], str(number), ax, colour=palette.OBSTACLE, offset=(5, 5))
    return centres


def draw_sweep_line(x: float, ax: Axes) -> None:
    """Draw the sweep line."""
    from ....figures import palette

    ax.axvline(x, color=palette.INK, linewidth=1.8, zorder=3)
