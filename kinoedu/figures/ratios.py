"""Ratios of times on a logarithmic axis, a line for each, with what is to hold."""

import os
from collections.abc import Mapping, Sequence
from itertools import groupby
from pathlib import Path
from textwrap import wrap
from typing import Any, NamedTuple

from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from ..support.whole_files import written_whole
from . import palette

LINE, WIDTH, TITLE = 0.34, 14.0, 38  # inches from a line to the next, inches, letters
GUTTER = 440.0  # points from where a title begins to the axis
HOLDS = {
    True: ("o", palette.START, "holds"),
    False: ("X", palette.HIT, "missed"),
    None: ("s", palette.OBSTACLE, "nothing to hold"),
}
TEXT: dict[str, Any] = {"fontsize": palette.TEXT_SIZE, "va": "center", "color": palette.INK}


class Mark(NamedTuple):
    """A ratio: what was done, beside whom; its median and the middle half of the rounds; the goal,
    and whether it is held.
    """

    what: str
    beside: str
    low: float
    middle: float
    high: float
    goal: float | None
    holds: bool | None


def draw_ratios(marks: Sequence[Mark], ax: Axes | None = None, *, label: str = "") -> list[Artist]:
    """Draw a line for each mark, those that follow each other with the same `what` as a group.
    `label` says what the ratio is.

    >>> artists = draw_ratios([Mark("RRT", "OMPL", 11.0, 12.0, 14.0, 10.0, True), Mark("RRT", "C", 0.8, 0.9, 1.0, None, None)])
    >>> plt.close()
    """
    ax = (
        plt.subplots(figsize=(WIDTH, height_of(marks)), dpi=72, layout="constrained")[1]
        if ax is None
        else ax
    )
    ax.set_xscale("log")
    artists: list[Artist] = []
    top = 0
    for number, (what, group) in enumerate(groupby(marks, key=lambda mark: mark.what)):
        lines, title = list(group), wrap(what, TITLE)
        height = max(len(lines), len(title))
        if number % 2 == 0:
            artists.append(
                ax.axhspan(
                    top - 0.5,
                    top + height - 0.5,
                    color=palette.CELL,
                    alpha=0.6,
                    linewidth=0,
                    zorder=0,
                )
            )
        place: dict[str, Any] = {
            "xytext": (-GUTTER, 0),
            "textcoords": "offset points",
            "xycoords": ax.get_yaxis_transform(),
        }
        artists.append(
            ax.annotate("\n".join(title), (0.0, top + height / 2 - 0.5), **place, **TEXT)
        )
        for i, mark in enumerate(lines):
            artists += draw_mark(mark, top + i + (height - len(lines)) / 2, ax)
        top += height
    artists.append(ax.axvline(1.0, color=palette.OUTSIDE, linewidth=1.2, zorder=1))
    ax.set_ylim(top - 0.5, -0.5)
    least, most = (
        min([1.0, *(mark.low for mark in marks)]),
        max([1.0, *(max(mark.high, mark.goal or 0.0) for mark in marks)]),
    )
    ax.set_xlim(least / 1.25, most * (most / least) ** 0.12 * 1.1)
    return [*artists, *dressed(ax, label)]


def draw_mark(mark: Mark, y: float, ax: Axes) -> list[Artist]:
    """One line: the bar of the middle half, the median by its shape, the goal as a stroke, names
    and numbers beside them.
    """
    shape, colour, _ = HOLDS[mark.holds]
    artists: list[Artist] = [
        *ax.plot([mark.low, mark.high], [y, y], color=colour, linewidth=6.0, alpha=0.35, zorder=2)
    ]
    artists += ax.plot(
        mark.middle, y, shape, color=colour, markersize=9.5, markeredgecolor="white", zorder=4
    )
    if mark.goal is not None:
        artists += ax.plot(
            [mark.goal, mark.goal], [y - 0.4, y + 0.4], color=palette.INK, linewidth=2.6, zorder=3
        )
    place: dict[str, Any] = {"xytext": (8, 0), "textcoords": "offset points"}
    number = f"{mark.middle:.3g}" if mark.middle < 1000 else f"{mark.middle:,.0f}"
    artists.append(ax.annotate(number, (max(mark.high, mark.goal or 0.0), y), **place, **TEXT))
    return [
        *artists,
        ax.text(-0.012, y, mark.beside, ha="right", transform=ax.get_yaxis_transform(), **TEXT),
    ]


def height_of(marks: Sequence[Mark]) -> float:
    """The inches that these marks take."""
    groups = [
        (what, len(list(group))) for what, group in groupby(marks, key=lambda mark: mark.what)
    ]
    return LINE * sum(max(lines, len(wrap(what, TITLE))) for what, lines in groups) + 0.9


def dressed(ax: Axes, label: str) -> list[Artist]:
    """What x is, plain numbers as ticks, a quiet grid."""
    ax.set_yticks([])
    ax.tick_params(labelsize=palette.TEXT_SIZE)
    ax.xaxis.set_major_formatter(lambda ratio, _: f"{ratio:g}")
    ax.xaxis.set_minor_formatter(
        lambda ratio, _: f"{ratio:g}" if ax.get_xlim()[1] < 12 * ax.get_xlim()[0] else ""
    )
    ax.tick_params(which="minor", labelsize=palette.TEXT_SIZE)
    ax.grid(color="#D1D5DB", linewidth=0.8, axis="x")
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
    """Draw marks under the label of their axis, one panel below the other, into a .png, .svg or
    .pdf. Raises OSError.
    """
    file, heights = Path(path), [height_of(marks) for marks in panels.values()]
    figure = Figure(figsize=(WIDTH, sum(heights) + 1.0), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(len(panels), 1, squeeze=False, height_ratios=heights)[:, 0]
    for (label, marks), ax in zip(panels.items(), axes):
        draw_ratios(marks, ax, label=label)
    figure.suptitle(title, fontsize=palette.TEXT_SIZE + 2)
    look: dict[str, Any] = {"linestyle": "", "markersize": 9.5}
    keys = [
        Line2D([], [], marker=shape, color=colour, label=word, **look)
        for shape, colour, word in HOLDS.values()
    ]
    keys.append(
        Line2D(
            [],
            [],
            marker="|",
            color=palette.INK,
            label="to hold",
            markeredgewidth=2.6,
            linestyle="",
            markersize=16,
        )
    )
    keys.append(
        Line2D(
            [],
            [],
            color=palette.OBSTACLE,
            alpha=0.35,
            linewidth=6.0,
            label="the middle half of the rounds",
        )
    )
    figure.legend(
        handles=keys,
        loc="outside lower center",
        ncols=len(keys),
        frameon=False,
        fontsize=palette.TEXT_SIZE,
    )
    with written_whole(file) as part:
        figure.savefig(part, format=file.suffix[1:].lower(), dpi=dpi)
