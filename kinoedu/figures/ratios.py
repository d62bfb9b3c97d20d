"""Ratios of times on a logarithmic axis, one line for each, with their targets."""

import os
from collections.abc import Mapping, Sequence
from itertools import groupby
from textwrap import wrap
from typing import Any, NamedTuple

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from . import palette
from .palette import Style
from .saving import save_figure

LINE, WIDTH = 0.34, 14.0  # inches: the height of a line, the width of the figure
TITLE = 38  # the most letters in a line of a title
GUTTER = 440.0  # points from the beginning of a title to the axis
HOLDS = {
    True: ("o", palette.CLEAR, "holds"),
    False: ("X", palette.HIT, "missed"),
    None: ("s", palette.OBSTACLE, "nothing to hold"),
}
TEXT: Style = {**palette.TEXT, "va": "center", "color": palette.INK}
OFFSET: Style = {"textcoords": "offset points"}


BAR: Style = {"linewidth": 6.0, "alpha": 0.35}  # for the middle half of the rounds


class Mark(NamedTuple):
    """A ratio.

    Attributes
    ----------
    what : the task measured.
    beside : the peer that it is compared with.
    low, middle, high : the median and the middle half of the rounds.
    goal : the target, or None.
    holds : whether the target is met, or None.
    """

    what: str
    beside: str
    low: float
    middle: float
    high: float
    goal: float | None
    holds: bool | None


def draw_ratios(marks: Sequence[Mark], ax: Axes | None = None, *, label: str = "") -> list[Artist]:
    """Draw one line per mark; consecutive marks with the same `what` form a group.

    label : the meaning of the ratio, written at the axis.

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> held = Mark("RRT", "OMPL", 11.0, 12.0, 14.0, 10.0, True)
    >>> artists = draw_ratios([held, Mark("RRT", "C", 0.8, 0.9, 1.0, None, None)])
    >>> plt.close()
    """
    ax = palette.axes_or_new(ax, (WIDTH, figure_height(marks)))
    ax.set_xscale("log")
    artists: list[Artist] = []
    top = 0
    for number, (what, group) in enumerate(groupby(marks, key=lambda mark: mark.what)):
        lines, title = list(group), wrap(what, TITLE)
        height = max(len(lines), len(title))
        if number % 2 == 0:
            stripe: Style = {"color": palette.CELL, "alpha": 0.6, "linewidth": 0, "zorder": 0}
            artists.append(ax.axhspan(top - 0.5, top + height - 0.5, **stripe))
        place: Style = {"xytext": (-GUTTER, 0), "xycoords": ax.get_yaxis_transform(), **OFFSET}
        at = (0.0, top + height / 2 - 0.5)
        artists.append(ax.annotate("\n".join(title), at, **place, **TEXT))
        for i, mark in enumerate(lines):
            artists += draw_mark(mark, top + i + (height - len(lines)) / 2, ax)
        top += height
    artists.append(ax.axvline(1.0, color=palette.OUTSIDE, linewidth=1.2, zorder=1))
    ax.set_ylim(top - 0.5, -0.5)
    least = min([1.0, *(mark.low for mark in marks)])
    most = max([1.0, *(max(mark.high, mark.goal or 0.0) for mark in marks)])
    ax.set_xlim(least / 1.25, most * (most / least) ** 0.12 * 1.1)
    return [*artists, *dress_axes(ax, label)]


def draw_mark(mark: Mark, y: float, ax: Axes) -> list[Artist]:
    """Draw one line: a bar for the middle half, the median, the target as a stroke, and numbers."""
    shape, colour, _ = HOLDS[mark.holds]
    artists: list[Artist] = [*ax.plot([mark.low, mark.high], [y, y], color=colour, zorder=2, **BAR)]
    artists += ax.plot(mark.middle, y, shape, color=colour, markersize=9.5, zorder=4, **palette.RIM)
    if mark.goal is not None:
        stroke: Style = {"color": palette.INK, "linewidth": 2.6, "zorder": 3}
        artists += ax.plot([mark.goal, mark.goal], [y - 0.4, y + 0.4], **stroke)
    number = f"{mark.middle:.3g}" if mark.middle < 1000 else f"{mark.middle:,.0f}"
    at, left = (max(mark.high, mark.goal or 0.0), y), ax.get_yaxis_transform()
    artists.append(ax.annotate(number, at, xytext=(8, 0), **OFFSET, **TEXT))
    artists.append(ax.text(-0.012, y, mark.beside, ha="right", transform=left, **TEXT))
    return artists


def figure_height(marks: Sequence[Mark]) -> float:
    """The height of these marks in inches."""
    by_task = groupby(marks, key=lambda mark: mark.what)
    groups = [(what, len(list(group))) for what, group in by_task]
    return LINE * sum(max(lines, len(wrap(what, TITLE))) for what, lines in groups) + 0.9


def dress_axes(ax: Axes, label: str) -> list[Artist]:
    """Set the label of x, plain numbers as ticks, and a light grid."""
    ax.set_yticks([])
    ax.tick_params(labelsize=palette.TEXT_SIZE)
    ax.xaxis.set_major_formatter(lambda ratio, _: f"{ratio:g}")
    ax.xaxis.set_minor_formatter(
        lambda ratio, _: f"{ratio:g}" if ax.get_xlim()[1] < 12 * ax.get_xlim()[0] else ""
    )
    ax.tick_params(which="minor", labelsize=palette.TEXT_SIZE)
    ax.grid(axis="x", **palette.GRID)
    ax.set_axisbelow(True)
    ax.spines[["top", "right", "left"]].set_visible(False)
    return [ax.set_xlabel(label, fontsize=palette.TEXT_SIZE)]


def save_ratios(
    panels: Mapping[str, Sequence[Mark]],
    path: str | os.PathLike[str],
    *,
    title: str,
    dpi: int = 100,
) -> None:
    """Draw marks under the label of their axis, one panel below the other, into a file.

    path : a file name that ends in .png, .svg or .pdf, as `save_figure` writes it.
    """
    heights = [figure_height(marks) for marks in panels.values()]
    figure = Figure(figsize=(WIDTH, sum(heights) + 1.0), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(len(panels), 1, squeeze=False, height_ratios=heights)[:, 0]
    for (label, marks), ax in zip(panels.items(), axes):
        draw_ratios(marks, ax, label=label)
    figure.suptitle(title, fontsize=palette.TEXT_SIZE + 2)
    looks: list[Any] = [
        {"marker": shape, "color": colour, "label": word, "linestyle": "", "markersize": 9.5}
        for shape, colour, word in HOLDS.values()
    ]
    stroke = {"marker": "|", "linestyle": "", "markersize": 16, "markeredgewidth": 2.6}
    looks.append({"color": palette.INK, "label": "to hold", **stroke})
    looks.append({"color": palette.OBSTACLE, "label": "the middle half of the rounds", **BAR})
    keys = [Line2D([], [], **look) for look in looks]
    below: Style = {"loc": "outside lower center", "ncols": len(keys), "frameon": False}
    figure.legend(handles=keys, **below, **palette.TEXT)
    save_figure(figure, path, dpi=dpi)
