"""Decompositions as figures: the cells, who is whose neighbour, and the sweep line at work."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection

from ..decomposition import Step, Trapezoidation, Triangulation
from ..decomposition.trapezoidation import corners_of
from ..geometry.checks import Array
from . import palette
from .drawing import HALO, axes_for, draw_edges, draw_world, line_width

FEW = 60  # cells whose numbers can be read
ROOM = 0.012  # of the world, round a number


def draw_decomposition(
    decomposition: Trapezoidation | Triangulation,
    ax: Axes | None = None,
    *,
    upto: int | None = None,
    numbers: bool = True,
    neighbours: bool = False,
) -> list[Artist]:
    """Draw a world cut into cells: their outlines, and their numbers where there are few cells, in
    those that have room.

    upto : show only the first so many cells. neighbours : join the centres of cells that share a
        wall, through the wall's middle.
    """
    total = len(decomposition.outlines)
    shown = total if upto is None else min(max(upto, 0), total)
    ax = axes_for(decomposition.world, ax)
    artists = [
        *draw_world(decomposition.world, ax),
        *draw_cells(decomposition.outlines[:shown], ax, total),
    ]
    if neighbours:
        artists += draw_neighbours(decomposition, shown, ax)
    if numbers and total <= FEW:
        roomy = (
            inner_sizes(decomposition.outlines[:shown])
            > ROOM * (decomposition.world.hi - decomposition.world.lo).max()
        )
        artists += [
            write_number(i, decomposition.centres[i], ax) for i in np.flatnonzero(roomy).tolist()
        ]
    kind = "triangles" if isinstance(decomposition, Triangulation) else "trapezoids"
    count = f"{shown:,} of {total:,} {kind}" if shown < total else f"{total:,} {kind}"
    title = (
        f"{count}, {len(decomposition.adjacency):,} pairs of neighbours"
        if shown == total
        else f"the first {count}"
    )
    ax.set_title(title, fontsize=palette.TEXT_SIZE)
    return artists


def draw_cells(outlines: Array, ax: Axes, total: int) -> list[Artist]:
    """Draw convex cells, shape (n, k, 2), with thinner lines for more of them."""
    width = 1.2 * line_width(total)
    pale = PolyCollection(
        list(outlines),
        facecolors=palette.CELL,
        edgecolors=palette.TREE,
        linewidths=width,
        zorder=1.5,
    )
    return [ax.add_collection(pale, autolim=False)]


def inner_sizes(outlines: Array) -> Array:
    """How roomy convex cells (n, k, 2) are, (n,): twice the area by the perimeter, the inscribed
    circle's radius in a triangle.
    """
    ahead = np.roll(outlines, -1, axis=1)
    doubled = (outlines[..., 0] * ahead[..., 1] - outlines[..., 1] * ahead[..., 0]).sum(axis=1)
    return doubled / np.sqrt(((ahead - outlines) ** 2).sum(axis=2)).sum(axis=1)


def draw_neighbours(
    decomposition: Trapezoidation | Triangulation, shown: int, ax: Axes
) -> list[Artist]:
    """Draw the roadmap of the first `shown` cells: from centre to centre through the middles of
    walls.
    """
    between = (decomposition.adjacency < shown).all(axis=1)
    middles = decomposition.walls[between].mean(axis=1)
    left, right = decomposition.centres[decomposition.adjacency[between].T]
    legs = np.concatenate([np.stack([left, middles], axis=1), np.stack([middles, right], axis=1)])
    size = 4.0 * line_width(shown)
    dots = [
        *ax.plot(
            *decomposition.centres[:shown].T, "o", color=palette.TREE, markersize=size, zorder=3.5
        ),
        *ax.plot(*middles.T, "s", color=palette.ROADMAP, markersize=0.7 * size, zorder=3.5),
    ]
    return [*draw_edges(legs, ax, palette.ROADMAP, width=1.6, zorder=3), *dots]


def write_number(i: int, centre: Array, ax: Axes) -> Artist:
    """A cell's number at its centre."""
    style: dict[str, Any] = {
        "ha": "center",
        "va": "center",
        "color": palette.INK,
        "path_effects": HALO,
        "zorder": 8,
    }
    return ax.annotate(str(i), (centre[0], centre[1]), fontsize=palette.TEXT_SIZE - 1, **style)


def draw_sweep(steps: Sequence[Step], world: Any, ax: Axes | None = None) -> list[Artist]:
    """Draw the sweep line where it is after the last of these steps: the cells it has closed, the
    floors and ceilings it crosses.

    steps : the first steps of `sweep(world)`, at least one; `list(sweep(world))[:k]`.
    """
    ax, now = axes_for(world, ax), steps[-1]
    closed, count = np.concatenate([step.closed for step in steps]), len(now.closed)
    artists = [*draw_world(world, ax), *draw_cells(corners_of(closed), ax, len(closed))]
    if count:
        new = PolyCollection(
            list(corners_of(now.closed)),
            facecolors="none",
            edgecolors=palette.TREE,
            linewidths=3.0,
            zorder=2,
        )
        artists.append(ax.add_collection(new, autolim=False))
    for name, edges, colour, style in (
        ("floors", now.status[::2], palette.START, "-"),
        ("ceilings", now.status[1::2], palette.GOAL, "--"),
    ):
        lines = ax.plot(
            *crossed(edges),
            color=colour,
            linewidth=3.5,
            linestyle=style,
            zorder=4,
            label=f"{name}: {len(edges)}",
        )
        artists += lines
    artists.append(ax.axvline(now.x, color=palette.INK, linewidth=1.8, zorder=4.5))
    artists += ax.plot(
        *now.vertices.T, "o", color=palette.INK, markersize=8, markeredgecolor="white", zorder=6
    )
    changes = f"cells closed {count}, opened {len(now.opened)}"
    ax.set_title(
        f"event {len(steps)}, x = {now.x:.4g}, {now.kind}: {changes}", fontsize=palette.TEXT_SIZE
    )
    below: dict[str, Any] = {
        "loc": "upper center",
        "bbox_to_anchor": (0.5, -0.12),
        "ncols": 2,
        "frameon": False,
    }
    artists.append(ax.legend(fontsize=palette.TEXT_SIZE - 1, **below))
    return artists


def crossed(edges: Array) -> tuple[Array, Array]:
    """Edges (s, 4) as the x and the y of one broken line, parted by nan."""
    gaps = np.full(len(edges), np.nan)
    return np.column_stack([edges[:, 0], edges[:, 2], gaps]).ravel(), np.column_stack(
        [edges[:, 1], edges[:, 3], gaps]
    ).ravel()
