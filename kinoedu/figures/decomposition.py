"""Figures of decompositions: cells, their neighbours, and the sweep line at work."""

from collections.abc import Sequence

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection

from ..decomposition import Step, Trapezoidation, Triangulation
from ..decomposition.trapezoidation import corners_of
from ..geometry.checks import Array
from ..worlds.checks import World
from . import palette
from .drawing import axes_for, draw_edges, draw_world, line_width
from .names import HALO
from .palette import Style

FEW = 60  # the most cells whose numbers can be read
ROOM = 0.012  # the least radius of a cell with a number, as a fraction of the world


def draw_decomposition(
    decomposition: Trapezoidation | Triangulation,
    ax: Axes | None = None,
    *,
    upto: int | None = None,
    numbers: bool = True,
    neighbours: bool = False,
) -> list[Artist]:
    """Draw a world cut into cells, with numbers where there are few cells.

    Parameters
    ----------
    upto : draw only the first so many cells.
    numbers : write a cell's number in it, if it has room.
    neighbours : join the centres of cells that share a wall, through the wall's midpoint.
    """
    total = len(decomposition.outlines)
    shown = total if upto is None else min(max(upto, 0), total)
    ax = axes_for(decomposition.world, ax)
    world, outlines = decomposition.world, decomposition.outlines[:shown]
    artists = [*draw_world(world, ax), *draw_cells(outlines, ax, total)]
    if neighbours:
        artists += draw_neighbours(decomposition, shown, ax)
    if numbers and total <= FEW:
        roomy = inner_sizes(outlines) > ROOM * (world.hi - world.lo).max()
        for i in np.flatnonzero(roomy).tolist():
            artists.append(write_number(i, decomposition.centres[i], ax))
    kind = "triangles" if isinstance(decomposition, Triangulation) else "trapezoids"
    title = f"{total:,} {kind}, {len(decomposition.adjacency):,} pairs of neighbours"
    if shown < total:
        title = f"the first {shown:,} of {total:,} {kind}"
    ax.set_title(title, fontsize=palette.TEXT_SIZE)
    return artists


def draw_cells(outlines: Array, ax: Axes, total: int) -> list[Artist]:
    """Draw convex cells, shape (n, k, 2), with thinner lines for more of them."""
    look: Style = {"edgecolors": palette.TREE, "linewidths": 1.2 * line_width(total)}
    pale = PolyCollection(list(outlines), facecolors=palette.CELL, zorder=1.5, **look)
    return [ax.add_collection(pale, autolim=False)]


def inner_sizes(outlines: Array) -> Array:
    """Twice the area over the perimeter of convex cells (n, k, 2), shape (n,).

    For a triangle it is the radius of the inscribed circle.
    """
    ahead = np.roll(outlines, -1, axis=1)
    doubled = (outlines[..., 0] * ahead[..., 1] - outlines[..., 1] * ahead[..., 0]).sum(axis=1)
    return doubled / np.sqrt(((ahead - outlines) ** 2).sum(axis=2)).sum(axis=1)


def draw_neighbours(
    decomposition: Trapezoidation | Triangulation, shown: int, ax: Axes
) -> list[Artist]:
    """Draw the roadmap of the first `shown` cells, from centre to centre through walls."""
    between = (decomposition.adjacency < shown).all(axis=1)
    middles = decomposition.walls[between].mean(axis=1)
    left, right = decomposition.centres[decomposition.adjacency[between].T]
    legs = np.concatenate([np.stack([left, middles], axis=1), np.stack([middles, right], axis=1)])
    size, centres = 4.0 * line_width(shown), decomposition.centres[:shown]
    dots = [
        *ax.plot(*centres.T, "o", color=palette.TREE, markersize=size, zorder=3.5),
        *ax.plot(*middles.T, "s", color=palette.ROADMAP, markersize=0.7 * size, zorder=3.5),
    ]
    return [*draw_edges(legs, ax, palette.ROADMAP, width=1.6, zorder=3), *dots]


def write_number(i: int, centre: Array, ax: Axes) -> Artist:
    """Write a cell's number at its centre."""
    style: Style = {"color": palette.INK, "path_effects": HALO, "zorder": 8, **palette.CENTRED}
    return ax.annotate(str(i), (centre[0], centre[1]), fontsize=palette.TEXT_SIZE - 1, **style)


def draw_sweep(steps: Sequence[Step], world: World, ax: Axes | None = None) -> list[Artist]:
    """Draw the sweep line after the last of some steps, the closed cells, floors and ceilings.

    steps : the first steps of `sweep(world)`, at least one; `list(sweep(world))[:k]`.
    """
    ax, now = axes_for(world, ax), steps[-1]
    closed, count = np.concatenate([step.closed for step in steps]), len(now.closed)
    artists = [*draw_world(world, ax), *draw_cells(corners_of(closed), ax, len(closed))]
    if count:
        frame: Style = {"facecolors": "none", "edgecolors": palette.TREE, "linewidths": 3.0}
        new = PolyCollection(list(corners_of(now.closed)), zorder=2, **frame)
        artists.append(ax.add_collection(new, autolim=False))
    for name, edges, colour, style in (
        ("floors", now.status[::2], palette.FLOOR, "-"),
        ("ceilings", now.status[1::2], palette.CEILING, "--"),
    ):
        look: Style = {"color": colour, "linewidth": 3.5, "linestyle": style}
        artists += ax.plot(*join_edges(edges), zorder=4, label=f"{name}: {len(edges)}", **look)
    artists.append(ax.axvline(now.x, color=palette.INK, linewidth=1.8, zorder=4.5))
    dots: Style = {"color": palette.INK, "markersize": 8, **palette.RIM}
    artists += ax.plot(*now.vertices.T, "o", zorder=6, **dots)
    changes = f"cells closed {count}, opened {len(now.opened)}"
    title = f"event {len(steps)}, x = {now.x:.4g}, {now.kind}: {changes}"
    ax.set_title(title, **palette.TEXT)
    below: Style = {"loc": "upper center", "bbox_to_anchor": (0.5, -0.12), "ncols": 2}
    below["frameon"] = False
    artists.append(ax.legend(fontsize=palette.TEXT_SIZE - 1, **below))
    return artists


def join_edges(edges: Array) -> tuple[Array, Array]:
    """Edges (s, 4) as the x and the y of one broken line, separated by nan."""
    x0, y0, x1, y1 = edges.T
    gaps = np.full(len(edges), np.nan)
    return np.column_stack([x0, x1, gaps]).ravel(), np.column_stack([y0, y1, gaps]).ravel()
