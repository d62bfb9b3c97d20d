"""Points in the unit square: in the order they came, with the largest hole among them; and how the
holes shrink.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb
from matplotlib.patches import Circle, Rectangle
from numpy.typing import ArrayLike

from ..errors import InvalidPoint
from ..geometry.checks import as_array
from ..sampling import largest_empty_ball
from ..sampling.dispersion import EmptyBall
from ..words import say
from . import palette
from .drawing import HALO
from .ends import name_ends

MOST_NUMBERS = 40  # numbers of more points than this would cover the square
LINES = ("-", "--", "-.", ":")
COLOURS = (palette.TREE, palette.GOAL, palette.START, palette.ROBOT)


def draw_samples(
    points: ArrayLike,
    ax: Axes | None = None,
    *,
    upto: int | None = None,
    cells: int | None = None,
    norm: float | None = None,
    numbers: bool | None = None,
) -> list[Artist]:
    """Draw points (n, 2) of the unit square.

    Parameters
    ----------
    upto : draw only the first so many, in the order they came.
    cells : draw k x k cells, such as those of a grid of k^2 points.
    norm : 2 or math.inf: draw the largest empty ball in that norm, its centre, and its radius in
    words.
    numbers : write each point's number beside it, from 1; by default up to 40 points.

    Returns the artists. Raises InvalidPoint, InvalidParameter.

    >>> artists = draw_samples([(0.25, 0.25), (0.75, 0.25)], cells=2, norm=2)
    >>> plt.close()
    """
    shown = as_array(points, "points")[:upto]
    if shown.ndim != 2 or shown.shape[1] != 2:
        raise InvalidPoint(f"points must have shape (n, 2), got {np.shape(points)}")
    ax = square_axes(ax)
    artists: list[Artist] = [
        ax.add_patch(
            Rectangle((0, 0), 1, 1, fill=False, edgecolor=palette.INK, linewidth=1.8, zorder=2)
        )
    ]
    if cells is not None:
        lines = [
            line
            for c in np.arange(1, cells) / cells
            for line in ([(c, 0), (c, 1)], [(0, c), (1, c)])
        ]
        artists.append(
            ax.add_collection(
                LineCollection(lines, colors=palette.OUTSIDE, linewidths=0.9, zorder=1.5)
            )
        )
    if norm is not None and len(shown):
        artists += draw_ball(largest_empty_ball(shown, norm), norm, ax)
    size = float(np.clip(11.0 - 2.0 * np.log10(len(shown) + 1), 3.0, 9.0))
    artists += ax.plot(
        *shown.T,
        "o",
        color=palette.TREE,
        markersize=size,
        markeredgecolor="white",
        markeredgewidth=0.6,
        zorder=4,
    )
    if len(shown) <= MOST_NUMBERS if numbers is None else numbers:
        artists += [beside(str(i), (x, y), ax) for i, (x, y) in enumerate(shown, start=1)]
    return artists


def square_axes(ax: Axes | None) -> Axes:
    """The axes given, or new ones, showing the unit square and what is just outside."""
    if ax is None:
        _, ax = plt.subplots(figsize=(6.0, 6.0), dpi=72, layout="constrained")
    ax.set_aspect("equal")
    ax.set_xlim(-0.06, 1.06)
    ax.set_ylim(-0.06, 1.06)
    ax.set_xticks([0, 0.5, 1], ["0", "0.5", "1"])
    ax.set_yticks([0, 0.5, 1], ["0", "0.5", "1"])
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return ax


def draw_ball(ball: EmptyBall, norm: float, ax: Axes) -> list[Artist]:
    """The ball or square without points, its centre, and a title with its radius."""
    look: dict[str, Any] = {"edgecolor": palette.PATH, "linewidth": 2.0, "zorder": 1}
    (x, y), r = ball.centre, ball.radius
    shape = (
        Rectangle((x - r, y - r), 2 * r, 2 * r, **look)
        if norm == math.inf
        else Circle((x, y), r, **look)
    )
    shape.set_facecolor((*to_rgb(palette.PATH), 0.25))
    words = say("samples.sup" if norm == math.inf else "samples.euclidean", radius=r)
    centre = ax.plot(x, y, "x", color=palette.INK, markersize=9, markeredgewidth=2.2, zorder=5)
    return [ax.add_patch(shape), *centre, ax.set_title(words, fontsize=palette.TEXT_SIZE + 1)]


def beside(words: str, at: tuple[float, float], ax: Axes, *, colour: str = palette.INK) -> Artist:
    """Words right above a place, or left above it where there is no room on the right."""
    right = at[0] < 0.93
    return ax.annotate(
        words, at, xytext=(4 if right else -4, 3), textcoords="offset points", ha="left" if right else "right", color=colour,
        fontsize=palette.TEXT_SIZE - 1, path_effects=HALO, zorder=6,
    )  # fmt: skip


def draw_dispersion(
    n: ArrayLike, curves: Mapping[str, ArrayLike], ax: Axes | None = None
) -> list[Artist]:
    """Draw dispersions against the number of points n (m,), both axes logarithmic: a curve (m,) for
    each name, written at its end.

    A grey line beside them falls like n^(-1/2), the best rate there is in the plane. Returns the
    artists.

    >>> artists = draw_dispersion([4, 16, 64], {"Sukharev": [0.35, 0.18, 0.09], "corners": [0.7, 0.35, 0.18]})
    >>> plt.close()
    """
    if ax is None:
        _, ax = plt.subplots(figsize=(7.0, 5.0), dpi=72, layout="constrained")
    sizes, values = (
        as_array(n, "n"),
        {name: as_array(curve, name) for name, curve in curves.items()},
    )
    if (
        sizes.ndim != 1
        or not values
        or any(curve.shape != sizes.shape for curve in values.values())
    ):
        raise InvalidPoint(
            f"n and every curve must have the same shape (m,), got {sizes.shape} and "
            f"{[c.shape for c in values.values()]}"
        )
    guide = 0.6 * min(float(curve[0]) for curve in values.values()) * np.sqrt(sizes[0] / sizes)
    artists: list[Artist] = [*ax.loglog(sizes, guide, color=palette.OUTSIDE, linewidth=1.5)]
    for i, curve in enumerate(values.values()):
        artists += ax.loglog(sizes, curve, LINES[i % 4], color=COLOURS[i % 4], linewidth=2.4)
    ax.set_xlabel(say("samples.n"), fontsize=palette.TEXT_SIZE)
    ax.set_ylabel(say("samples.dispersion"), fontsize=palette.TEXT_SIZE)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(color="#E5E7EB", linewidth=0.8, zorder=0)
    ax.set_xlim(sizes.min() * 0.9, sizes.max() * (sizes.max() / sizes.min()) ** 0.32)
    ends = [
        (name, float(curve[-1]), COLOURS[i % 4]) for i, (name, curve) in enumerate(values.items())
    ]
    return artists + name_ends(
        float(sizes[-1]), [*ends, (say("samples.rate"), float(guide[-1]), "#5B6470")], ax
    )


def draw_shares(
    widths: ArrayLike, chance: ArrayLike, curves: Mapping[str, ArrayLike], ax: Axes | None = None
) -> list[Artist]:
    """Draw the share of passages that are hit against their widths (m,): a curve (m,) for each
    name, and of random points, chance (seeds, m), the median and the whole spread. Returns the
    artists.

    >>> artists = draw_shares([0.1, 0.2], [[0.4, 0.8], [0.5, 0.9]], {"a grid": [0.3, 1.0]})
    >>> plt.close()
    """
    if ax is None:
        _, ax = plt.subplots(figsize=(7.0, 5.0), dpi=72, layout="constrained")
    across, lucky = as_array(widths, "widths"), as_array(chance, "chance")
    artists: list[Artist] = [
        ax.fill_between(across, lucky.min(axis=0), lucky.max(axis=0), color=palette.TREE, alpha=0.2)
    ]
    names = {say("samples.chance", seeds=len(lucky)): np.median(lucky, axis=0), **curves}
    for i, (name, curve) in enumerate(names.items()):
        artists += ax.plot(
            across,
            curve,
            LINES[i % 4],
            color=COLOURS[i % 4],
            linewidth=2.4,
            marker="o^sD"[i % 4],
            label=name,
        )
    ax.set_xlabel(say("samples.width"), fontsize=palette.TEXT_SIZE)
    ax.set_ylabel(say("samples.share"), fontsize=palette.TEXT_SIZE)
    ax.set_xlim(0.0, float(across.max()) * 1.03)
    ax.set_ylim(0.0, 1.04)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(color="#E5E7EB", linewidth=0.8, zorder=0)
    return [*artists, ax.legend(fontsize=palette.TEXT_SIZE, loc="lower right")]
