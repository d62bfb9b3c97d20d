"""Points, segments, polygons and arrows in the plane, labelled where they stand: the pictures of
geometry.
"""

from textwrap import fill

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon
from numpy.typing import ArrayLike

from ..words import say
from . import palette
from .drawing import HALO

SHAPE = 1.5  # the width of the axes to their height


def plane_figure() -> tuple[Figure, Axes]:
    """A figure for one picture of the plane, without a window and unknown to pyplot."""
    figure = Figure(figsize=(7.0, 5.0), layout="constrained")
    FigureCanvasAgg(figure)
    return figure, figure.add_subplot()


def axes(points: ArrayLike, words: str) -> Axes:
    """New axes in the notebook that show all of the points, shape (n, 2), under a title that says
    what to see.
    """
    _, ax = plt.subplots(figsize=(7.0, 5.0), dpi=72, layout="constrained")
    frame(points, ax, margin=0.3)
    title(words, ax)
    return ax


def frame(points: ArrayLike, ax: Axes, *, margin: float = 0.2) -> None:
    """Equal axes that show all finite points, shape (n, 2), and some room round them."""
    shown = np.asarray(points, float)
    shown = shown[np.isfinite(shown).all(axis=1)]
    lo, hi = shown.min(axis=0), shown.max(axis=0)
    middle, reach = (lo + hi) / 2, (hi - lo) / 2 * (1.0 + 2.0 * margin)
    height = max(reach[1], reach[0] / SHAPE) or 1.0
    reach = np.array([SHAPE * height, height])
    ax.set_aspect("equal")
    ax.set_xlim(middle[0] - reach[0], middle[0] + reach[0])
    ax.set_ylim(middle[1] - reach[1], middle[1] + reach[1])
    ax.set_xlabel("x", fontsize=palette.TEXT_SIZE)
    ax.set_ylabel("y", fontsize=palette.TEXT_SIZE, rotation=0, labelpad=12)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(color="#E5E7EB", linewidth=0.8, zorder=0)


def title(words: str, ax: Axes) -> Artist:
    """Say what to see."""
    return ax.set_title(fill(words, 60), fontsize=palette.TEXT_SIZE + 1)


def dot(
    at: ArrayLike, name: str, ax: Axes, *, colour: str = palette.INK, marker: str = "o"
) -> list[Artist]:
    """A point with its name beside it."""
    x, y = np.asarray(at, float)
    artists: list[Artist] = [
        *ax.plot(
            x,
            y,
            marker,
            color=colour,
            markersize=15 if marker == "*" else 9,
            markeredgecolor="white",
            zorder=6,
        )
    ]
    return [*artists, label((x, y), name, ax, colour=colour)] if name else artists


def label(
    at: ArrayLike,
    words: str,
    ax: Axes,
    *,
    colour: str = palette.INK,
    offset: tuple[float, float] = (9, 9),
    ha: str = "left",
) -> Artist:
    """Words beside a place, readable on anything."""
    x, y = np.asarray(at, float)
    if (
        offset[0] > 0
        and ha == "left"
        and x > ax.get_xlim()[0] + 0.8 * (ax.get_xlim()[1] - ax.get_xlim()[0])
    ):
        offset, ha = (-offset[0], offset[1]), "right"  # there is more room on the other side
    return ax.annotate(
        words, (x, y), xytext=offset, textcoords="offset points", fontsize=palette.TEXT_SIZE, fontweight="bold", color=colour,
        path_effects=HALO, zorder=9, ha=ha,
    )  # fmt: skip


def stretch(
    a: ArrayLike,
    b: ArrayLike,
    words: str,
    ax: Axes,
    *,
    colour: str = palette.INK,
    style: str = "-",
    width: float = 2.5,
) -> list[Artist]:
    """A segment with words at its middle."""
    (ax_, ay), (bx, by) = np.asarray(a, float), np.asarray(b, float)
    artists: list[Artist] = [
        *ax.plot([ax_, bx], [ay, by], style, color=colour, linewidth=width, zorder=4)
    ]
    return (
        [*artists, label(((ax_ + bx) / 2, (ay + by) / 2), words, ax, colour=colour)]
        if words
        else artists
    )


def endless(
    line: ArrayLike, words: str, ax: Axes, *, colour: str, style: str = "-"
) -> list[Artist]:
    """The line a x + b y + c = 0, given as (a, b, c), across what the axes show; nothing where it
    is none.
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
    artists: list[Artist] = [
        *ax.plot(
            *ends.T,
            style,
            color=colour,
            linewidth=2.5,
            zorder=3,
            scalex=False,
            scaley=False,
            label=words,
        )
    ]
    ax.set_xlim(limits[0])
    ax.set_ylim(limits[1])
    return artists


def ring(
    centre: ArrayLike, radius: float, words: str, ax: Axes, *, colour: str, style: str = "-"
) -> list[Artist]:
    """A circle: all that is so far from the centre. Its words stand where the circle is in view."""
    x, y = np.asarray(centre, float)
    lo, hi = np.column_stack([ax.get_xlim(), ax.get_ylim()])
    if radius > 3.0 * float((hi - lo).max()):
        return [corner_note(say("picture.outside", what=words), ax, colour=colour)] if words else []
    artists: list[Artist] = [
        ax.add_patch(
            Circle(
                (x, y),
                radius,
                fill=False,
                edgecolor=colour,
                linestyle=style,
                linewidth=2.2,
                zorder=3,
            )
        )
    ]
    for angle in np.radians((135, 45, 180, 225, 90, 270, 315, 160, 110)):
        at = np.array([x + radius * np.cos(angle), y + radius * np.sin(angle)])
        if (
            words
            and (lo + (0.22, 0.08) * (hi - lo) < at).all()
            and (at < hi - (0.12, 0.1) * (hi - lo)).all()
        ):
            left = np.cos(angle) < 0.1
            return [
                *artists,
                label(
                    at,
                    words,
                    ax,
                    colour=colour,
                    offset=(-6 if left else 6, 4),
                    ha="right" if left else "left",
                ),
            ]
    return [*artists, corner_note(words, ax, colour=colour)] if words else artists


def corner_note(words: str, ax: Axes, *, colour: str) -> Artist:
    """Words in the lower left corner, for what has no place in the picture."""
    return ax.annotate(
        words,
        (0.02, 0.03),
        xycoords="axes fraction",
        fontsize=palette.TEXT_SIZE,
        fontweight="bold",
        color=colour,
        path_effects=HALO,
    )


def arrow(
    at: ArrayLike, vector: ArrayLike, words: str, ax: Axes, *, colour: str, style: str = "-"
) -> list[Artist]:
    """A vector drawn from a place, to scale."""
    (x, y), (u, v) = np.asarray(at, float), np.asarray(vector, float)
    properties = {
        "arrowstyle": "-|>",
        "color": colour,
        "lw": 2.6,
        "linestyle": style,
        "mutation_scale": 18,
        "shrinkA": 0,
        "shrinkB": 0,
    }
    artists: list[Artist] = [
        ax.annotate("", (x + u, y + v), xytext=(x, y), arrowprops=properties, zorder=7)
    ]
    far = 12.0 / (float(np.sqrt(u * u + v * v)) or 1.0)
    ha = "center" if abs(u) < abs(v) else "left" if u > 0 else "right"
    return (
        [
            *artists,
            label((x + u, y + v), words, ax, colour=colour, offset=(far * u, far * v - 5), ha=ha),
        ]
        if words
        else artists
    )


def polygon(vertices: ArrayLike, ax: Axes, *, numbers: bool = True) -> list[Artist]:
    """A solid polygon, its vertices numbered as in the array."""
    points = np.asarray(vertices, float)
    artists: list[Artist] = [
        ax.add_patch(
            Polygon(
                points, facecolor="#C7CCD4", edgecolor=palette.OBSTACLE, linewidth=2.0, zorder=2
            )
        )
    ]
    middle = points.mean(axis=0)
    for number, point in enumerate(points if numbers and len(points) <= 40 else []):
        inward = middle - point
        size = float(np.sqrt((inward * inward).sum())) or 1.0
        dx, dy = 13.0 * inward / size
        artists.append(
            label(point, str(number), ax, colour=palette.OBSTACLE, offset=(dx - 4, dy - 5))
        )
    return artists
