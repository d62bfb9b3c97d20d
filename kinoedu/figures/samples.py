"""Figures of samples in the unit square: their order, their largest hole, and its decrease."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.colors import to_rgb
from matplotlib.patches import Circle, Rectangle
from numpy.typing import ArrayLike

from ..errors import InvalidPoint
from ..geometry.checks import as_array
from ..messages import get_message
from ..sampling import largest_empty_ball
from ..sampling.dispersion import EmptyBall
from . import palette
from .ends import name_ends
from .names import HALO
from .palette import Style

MOST_NUMBERS = 40  # the numbers of more points than this would cover the square
LINES = ("-", "--", "-.", ":")
COLOURS = palette.METHODS[:4]


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
    upto : draw only the first so many, in their order.
    cells : draw k x k cells, such as those of a grid of k^2 points.
    norm : 2 or math.inf: draw the largest empty ball in that norm, with its centre and radius.
    numbers : write each point's number beside it, from 1; by default up to 40 points.

    Returns
    -------
    list of artists

    Raises
    ------
    InvalidPoint, InvalidParameter

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> artists = draw_samples([(0.25, 0.25), (0.75, 0.25)], cells=2, norm=2)
    >>> plt.close()
    """
    shown = as_array(points, "points")[:upto]
    if shown.ndim != 2 or shown.shape[1] != 2:
        raise InvalidPoint(f"points must have shape (n, 2), got {np.shape(points)}")
    ax = square_axes(ax)
    frame = Rectangle((0, 0), 1, 1, fill=False, edgecolor=palette.INK, linewidth=1.8, zorder=2)
    artists: list[Artist] = [ax.add_patch(frame)]
    if cells is not None:
        places = np.arange(1, cells) / cells
        pairs = [([(c, 0), (c, 1)], [(0, c), (1, c)]) for c in places]
        lines = [line for pair in pairs for line in pair]
        grid = LineCollection(lines, colors=palette.OUTSIDE, linewidths=0.9, zorder=1.5)
        artists.append(ax.add_collection(grid))
    if norm is not None and len(shown):
        artists += draw_ball(largest_empty_ball(shown, norm), norm, ax)
    size = float(np.clip(11.0 - 2.0 * np.log10(len(shown) + 1), 3.0, 9.0))
    look: Style = {"color": palette.TREE, "markersize": size, "markeredgewidth": 0.6, **palette.RIM}
    artists += ax.plot(*shown.T, "o", zorder=4, **look)
    if len(shown) <= MOST_NUMBERS if numbers is None else numbers:
        artists += [write_beside(str(i), (x, y), ax) for i, (x, y) in enumerate(shown, start=1)]
    return artists


def square_axes(ax: Axes | None) -> Axes:
    """The axes given, or new ones, showing the unit square with a margin."""
    ax = palette.axes_or_new(ax, (6.0, 6.0))
    ax.set_aspect("equal")
    ax.set_xlim(-0.06, 1.06)
    ax.set_ylim(-0.06, 1.06)
    ax.set_xticks([0, 0.5, 1], ["0", "0.5", "1"])
    ax.set_yticks([0, 0.5, 1], ["0", "0.5", "1"])
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return ax


def draw_ball(ball: EmptyBall, norm: float, ax: Axes) -> list[Artist]:
    """Draw the empty ball or square and its centre, and write its radius as the title."""
    look: Style = {"edgecolor": palette.PATH, "linewidth": 2.0, "zorder": 1}
    look["facecolor"] = (*to_rgb(palette.PATH), 0.25)
    (x, y), r = ball.centre, ball.radius
    square = norm == math.inf
    shape = Rectangle((x - r, y - r), 2 * r, 2 * r, **look) if square else Circle((x, y), r, **look)
    text = get_message("samples.sup" if norm == math.inf else "samples.euclidean", radius=r)
    centre = ax.plot(x, y, "x", color=palette.INK, markersize=9, markeredgewidth=2.2, zorder=5)
    return [ax.add_patch(shape), *centre, ax.set_title(text, fontsize=palette.TEXT_SIZE + 1)]


def write_beside(
    text: str, at: tuple[float, float], ax: Axes, *, colour: str = palette.INK
) -> Artist:
    """Write words above a place, to the left where there is no room on the right."""
    right = at[0] < 0.93
    place: Style = {"xytext": (4 if right else -4, 3), "textcoords": "offset points"}
    style: Style = {"fontsize": palette.TEXT_SIZE - 1, "color": colour, "path_effects": HALO}
    return ax.annotate(text, at, ha="left" if right else "right", zorder=6, **place, **style)


def draw_dispersion(
    n: ArrayLike, curves: Mapping[str, ArrayLike], ax: Axes | None = None
) -> list[Artist]:
    """Draw dispersions against the number of points n (m,), both axes logarithmic.

    A grey line falls like n^(-1/2), the best rate in the plane.

    Parameters
    ----------
    curves : (m,) for each name; the names are written at the ends.

    Returns
    -------
    list of artists

    Raises
    ------
    InvalidPoint
        Where the shapes do not match.

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> curves = {"Sukharev": [0.35, 0.18, 0.09], "corners": [0.7, 0.35, 0.18]}
    >>> artists = draw_dispersion([4, 16, 64], curves)
    >>> plt.close()
    """
    ax = palette.axes_or_new(ax, (7.0, 5.0))
    sizes = as_array(n, "n")
    values = {name: as_array(curve, name) for name, curve in curves.items()}
    other = any(curve.shape != sizes.shape for curve in values.values())
    if sizes.ndim != 1 or not values or other:
        raise InvalidPoint(
            f"n and every curve must have the same shape (m,), got {sizes.shape} and "
            f"{[c.shape for c in values.values()]}"
        )
    guide = 0.6 * min(float(curve[0]) for curve in values.values()) * np.sqrt(sizes[0] / sizes)
    artists: list[Artist] = [*ax.loglog(sizes, guide, color=palette.OUTSIDE, linewidth=1.5)]
    for i, curve in enumerate(values.values()):
        artists += ax.loglog(sizes, curve, LINES[i % 4], color=COLOURS[i % 4], linewidth=2.4)
    label_axes(get_message("samples.n"), get_message("samples.dispersion"), ax)
    ax.set_xlim(sizes.min() * 0.9, sizes.max() * (sizes.max() / sizes.min()) ** 0.32)
    names = enumerate(values.items())
    ends = [(name, float(curve[-1]), COLOURS[i % 4]) for i, (name, curve) in names]
    ends.append((get_message("samples.rate"), float(guide[-1]), palette.OBSTACLE))
    return artists + name_ends(float(sizes[-1]), ends, ax)


def label_axes(along: str, up: str, ax: Axes) -> None:
    """Label the axes, and draw a light grid."""
    ax.set_xlabel(along, **palette.TEXT)
    ax.set_ylabel(up, **palette.TEXT)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(zorder=0, **palette.GRID)


def draw_shares(
    widths: ArrayLike, chance: ArrayLike, curves: Mapping[str, ArrayLike], ax: Axes | None = None
) -> list[Artist]:
    """Draw the share of passages that are hit against their widths (m,).

    Parameters
    ----------
    chance : (seeds, m), of random points; drawn as their median and full range.
    curves : (m,) for each name.

    Returns
    -------
    list of artists

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> artists = draw_shares([0.1, 0.2], [[0.4, 0.8], [0.5, 0.9]], {"a grid": [0.3, 1.0]})
    >>> plt.close()
    """
    ax = palette.axes_or_new(ax, (7.0, 5.0))
    across, random = as_array(widths, "widths"), as_array(chance, "chance")
    least, most = random.min(axis=0), random.max(axis=0)
    artists: list[Artist] = [ax.fill_between(across, least, most, color=palette.TREE, alpha=0.2)]
    names = {get_message("samples.chance", seeds=len(random)): np.median(random, axis=0), **curves}
    for i, (name, curve) in enumerate(names.items()):
        look: Style = {"color": COLOURS[i % 4], "linewidth": 2.4, "marker": "o^sD"[i % 4]}
        artists += ax.plot(across, curve, LINES[i % 4], label=name, **look)
    label_axes(get_message("samples.width"), get_message("samples.share"), ax)
    ax.set_xlim(0.0, float(across.max()) * 1.03)
    ax.set_ylim(0.0, 1.04)
    return [*artists, ax.legend(fontsize=palette.TEXT_SIZE, loc="lower right")]
