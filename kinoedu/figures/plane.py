"""Figures of geometry in the plane: points, segments, polygons and arrows with their labels."""

from textwrap import fill

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon
from numpy.typing import ArrayLike

from ..geometry.checks import Array
from ..messages import get_message
from . import palette
from .names import HALO
from .palette import Style

SHAPE = 1.5  # the width of the axes over their height
MOST_NUMBERS = 40  # of vertices
FLATTEST = 2.2  # the same, for axes as flat as what they show
TOUCHING: Style = {"shrinkA": 0, "shrinkB": 0}  # an arrow that reaches both its ends


def plane_figure() -> tuple[Figure, Axes]:
    """A figure for one picture of the plane, without a window and without pyplot."""
    figure = Figure(figsize=(7.0, 5.0), layout="constrained")
    FigureCanvasAgg(figure)
    return figure, figure.add_subplot()


def axes(points: ArrayLike, text: str) -> Axes:
    """New axes in the notebook that show all points, shape (n, 2), under a title.

    They are as flat as the points are, within bounds.
    """
    width, height = np.ptp(np.asarray(points, float), axis=0)
    shape = float(np.clip(width / height, SHAPE, FLATTEST)) if height > 0.0 else FLATTEST
    ax = palette.axes_or_new(None, (7.0, 6.2 / shape + 0.9))
    frame(points, ax, margin=0.3, shape=shape)
    title(text, ax)
    return ax


def frame(points: ArrayLike, ax: Axes, *, margin: float = 0.2, shape: float = SHAPE) -> None:
    """Set equal axes of a shape that show all finite points, shape (n, 2), with a margin."""
    shown = np.asarray(points, float)
    shown = shown[np.isfinite(shown).all(axis=1)]
    lo, hi = shown.min(axis=0), shown.max(axis=0)
    middle, reach = (lo + hi) / 2, (hi - lo) / 2 * (1.0 + 2.0 * margin)
    height = max(reach[1], reach[0] / shape) or 1.0
    reach = np.array([shape * height, height])
    ax.set_aspect("equal")
    ax.set_xlim(middle[0] - reach[0], middle[0] + reach[0])
    ax.set_ylim(middle[1] - reach[1], middle[1] + reach[1])
    ax.set_xlabel("x", **palette.TEXT)
    ax.set_ylabel("y", rotation=0, labelpad=12, **palette.TEXT)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(zorder=0, **palette.GRID)


def title(text: str, ax: Axes) -> Artist:
    """Write the title: what to see. Long lines are broken."""
    lines = "\n".join(fill(line, 60) for line in text.splitlines())
    return ax.set_title(lines, fontsize=palette.TEXT_SIZE + 1)


def dot(
    at: ArrayLike,
    name: str,
    ax: Axes,
    *,
    colour: str = palette.INK,
    marker: str = "o",
    offset: tuple[float, float] = (9, 9),
) -> list[Artist]:
    """Draw a point with its name beside it."""
    x, y = np.asarray(at, float)
    look: Style = {"color": colour, "markersize": 15 if marker == "*" else 9, **palette.RIM}
    artists: list[Artist] = [*ax.plot(x, y, marker, zorder=6, **look)]
    return [*artists, label((x, y), name, ax, colour=colour, offset=offset)] if name else artists


def label(
    at: ArrayLike,
    text: str,
    ax: Axes,
    *,
    colour: str = palette.INK,
    offset: tuple[float, float] = (9, 9),
    ha: str = "left",
) -> Artist:
    """Write words beside a place, readable on any background."""
    x, y = np.asarray(at, float)
    left, right = ax.get_xlim()
    if offset[0] > 0 and ha == "left" and x > left + 0.8 * (right - left):
        offset, ha = (-offset[0], offset[1]), "right"  # there is more room on the other side
    beside: Style = {"xytext": offset, "textcoords": "offset points", "ha": ha}
    style: Style = {"color": colour, "path_effects": HALO, **palette.BOLD}
    return ax.annotate(text, (x, y), zorder=9, **beside, **style)


def segment(
    a: ArrayLike,
    b: ArrayLike,
    text: str,
    ax: Axes,
    *,
    colour: str = palette.INK,
    style: str = "-",
    width: float = 2.5,
    offset: tuple[float, float] = (9, 9),
) -> list[Artist]:
    """Draw a segment with words beside its midpoint, `offset` points from it."""
    (ax_, ay), (bx, by) = np.asarray(a, float), np.asarray(b, float)
    line = ax.plot([ax_, bx], [ay, by], style, color=colour, linewidth=width, zorder=4)
    if not text:
        return [*line]
    middle = (ax_ + bx) / 2, (ay + by) / 2
    return [*line, label(middle, text, ax, colour=colour, offset=offset)]


def line(line: ArrayLike, text: str, ax: Axes, *, colour: str, style: str = "-") -> list[Artist]:
    """Draw the line a x + b y + c = 0, given as (a, b, c), across the axes.

    Nothing is drawn where the numbers are no line.
    """
    a, b, c = np.asarray(line, float)
    square = a * a + b * b
    if not np.isfinite([a, b, c]).all() or square == 0.0:
        return []
    foot = np.array([-a * c / square, -b * c / square])
    along = np.array([-b, a]) / np.sqrt(square)
    centre = np.array([np.mean(ax.get_xlim()), np.mean(ax.get_ylim())])
    middle = foot + along * float(np.dot(centre - foot, along))
    reach = 2.0 * max(np.ptp(ax.get_xlim()), np.ptp(ax.get_ylim()))
    ends = np.array([middle - reach * along, middle + reach * along])
    limits = ax.get_xlim(), ax.get_ylim()
    look: Style = {"color": colour, "linewidth": 2.5, "scalex": False, "scaley": False}
    artists: list[Artist] = [*ax.plot(*ends.T, style, zorder=3, label=text, **look)]
    ax.set_xlim(limits[0])
    ax.set_ylim(limits[1])
    return artists


def ring(
    centre: ArrayLike, radius: float, text: str, ax: Axes, *, colour: str, style: str = "-"
) -> list[Artist]:
    """Draw a circle, with words at a point of it that is in view."""
    x, y = np.asarray(centre, float)
    lo, hi = np.column_stack([ax.get_xlim(), ax.get_ylim()])
    if radius > 3.0 * float((hi - lo).max()):
        return (
            [corner_note(get_message("picture.outside", what=text), ax, colour=colour)]
            if text
            else []
        )
    look: Style = {"edgecolor": colour, "linestyle": style, "linewidth": 2.2}
    circle = ax.add_patch(Circle((x, y), radius, fill=False, zorder=3, **look))
    if not text:
        return [circle]
    least, most = lo + (0.22, 0.08) * (hi - lo), hi - (0.12, 0.1) * (hi - lo)
    for angle in np.radians((135, 45, 180, 225, 90, 270, 315, 160, 110)):
        at = np.array([x + radius * np.cos(angle), y + radius * np.sin(angle)])
        if (least < at).all() and (at < most).all():
            left = np.cos(angle) < 0.1
            beside: Style = {"offset": (-6 if left else 6, 4), "ha": "right" if left else "left"}
            return [circle, label(at, text, ax, colour=colour, **beside)]
    return [circle, corner_note(text, ax, colour=colour)]


def corner_note(text: str, ax: Axes, *, colour: str) -> Artist:
    """Write words in the lower left corner, for things outside the picture."""
    style: Style = {"color": colour, "path_effects": HALO, **palette.BOLD}
    return ax.annotate(text, (0.02, 0.03), xycoords="axes fraction", **style)


def arrow(
    at: ArrayLike, vector: ArrayLike, text: str, ax: Axes, *, colour: str, style: str = "-"
) -> list[Artist]:
    """Draw a vector from a place, to scale."""
    (x, y), (u, v) = np.asarray(at, float), np.asarray(vector, float)
    head = {"arrowstyle": "-|>", "mutation_scale": 18, **TOUCHING}
    properties = {"color": colour, "lw": 2.6, "linestyle": style, **head}
    tip = (x + u, y + v)
    drawn: list[Artist] = [ax.annotate("", tip, xytext=(x, y), arrowprops=properties, zorder=7)]
    if not text:
        return drawn
    far = 12.0 / (float(np.sqrt(u * u + v * v)) or 1.0)
    ha = "center" if abs(u) < abs(v) else "left" if u > 0 else "right"
    return [*drawn, label(tip, text, ax, colour=colour, offset=(far * u, far * v - 5), ha=ha)]


def polygon(vertices: ArrayLike, ax: Axes, *, numbers: bool = True) -> list[Artist]:
    """Draw a solid polygon, its vertices numbered as in the array."""
    points = np.asarray(vertices, float)
    look: Style = {"facecolor": palette.SHAPE, "edgecolor": palette.OBSTACLE, "linewidth": 2.0}
    artists: list[Artist] = [ax.add_patch(Polygon(points, zorder=2, **look))]
    if numbers and len(points) <= MOST_NUMBERS:
        for number, (point, (dx, dy)) in enumerate(zip(points, 13.0 * inward(points))):
            place: Style = {"colour": palette.OBSTACLE, "offset": (dx - 4, dy - 5)}
            artists.append(label(point, str(number), ax, **place))
    return artists


def inward(ring: Array) -> Array:
    """Unit vectors from the vertices of a ring (n, 2) into it; 0 where it turns back.

    Examples
    --------
    >>> inward(np.array([(0.0, 0.0), (0.0, 2.0), (2.0, 2.0), (2.0, 0.0)])).round(1)
    array([[ 0.7,  0.7],
           [ 0.7, -0.7],
           [-0.7, -0.7],
           [-0.7,  0.7]])
    """
    x, y = ring.T
    turns_left = (x * np.roll(y, -1) - np.roll(x, -1) * y).sum() > 0.0
    along = unit(np.roll(ring, -1, axis=0) - ring)
    along = unit(along + np.roll(along, 1, axis=0))
    left = np.column_stack([-along[:, 1], along[:, 0]])
    return left if turns_left else -left


def unit(vectors: Array) -> Array:
    """Vectors (n, 2) divided by their lengths; 0 stays 0."""
    lengths = np.hypot(*vectors.T)[:, None]
    return np.divide(vectors, lengths, out=np.zeros_like(vectors), where=lengths > 0.0)
