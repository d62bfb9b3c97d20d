"""How times grow with n: a panel for each curve, both axes logarithmic, with the exponent of its
last stretch.
"""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from ..geometry.checks import Array
from ..support.whole_files import written_whole
from . import palette

PANEL, COLUMNS = (4.0, 3.5), 4  # inches


class Curve(NamedTuple):
    """What is done, what n counts, each n (m,), seconds (m, rounds), and the exponent that was
    fitted to the last `fitted` n.
    """

    name: str
    unit: str
    n: Array
    seconds: Array
    exponent: float
    fitted: int


def draw_growth(curve: Curve, ax: Axes | None = None) -> list[Artist]:
    """Draw the median over the rounds in a band from the quickest to the slowest, and the line that
    was fitted.

    >>> artists = draw_growth(Curve("RRT", "nodes", np.array([1.0, 2, 4]), np.array([[1.0, 2], [2, 3], [4, 5]]), 1.2, 2))
    >>> plt.close()
    """
    ax = plt.subplots(figsize=PANEL, dpi=72, layout="constrained")[1] if ax is None else ax
    ax.set_xscale("log")
    ax.set_yscale("log")
    median = np.median(curve.seconds, axis=1)
    band = ax.fill_between(
        curve.n,
        curve.seconds.min(axis=1),
        curve.seconds.max(axis=1),
        color=palette.TREE,
        alpha=0.25,
        linewidth=0,
    )
    last = curve.n[-curve.fitted :]
    height = np.exp(
        np.log(median[-curve.fitted :]).mean()
        + curve.exponent * (np.log(last) - np.log(last).mean())
    )
    artists: list[Artist] = [
        band,
        *ax.plot(last, height, color=palette.GOAL, linewidth=5.0, alpha=0.5, solid_capstyle="butt"),
    ]
    artists += ax.plot(curve.n, median, "o-", color=palette.TREE, linewidth=2.0, markersize=5.0)
    ax.tick_params(labelsize=palette.TEXT_SIZE)
    ax.grid(color="#E5E7EB", linewidth=0.8)
    ax.spines[["top", "right"]].set_visible(False)
    title = ax.set_title(
        f"{curve.name}: $n^{{{curve.exponent:.2f}}}$",
        fontsize=palette.TEXT_SIZE + 1,
        color=palette.INK,
    )
    return [*artists, title, ax.set_xlabel(f"n = {curve.unit}", fontsize=palette.TEXT_SIZE)]


def save_growth(curves: Sequence[Curve], path: str | os.PathLike[str], *, dpi: int = 100) -> None:
    """Draw curves side by side into a picture, as many decades across in each, so that slopes
    compare. Raises OSError.
    """
    file, rows = Path(path), -(-len(curves) // COLUMNS)
    columns = min(COLUMNS, len(curves))
    figure = Figure(figsize=(PANEL[0] * columns, PANEL[1] * rows), layout="constrained")
    FigureCanvasAgg(figure)
    panels = figure.subplots(rows, columns, squeeze=False, sharey=True)
    decades = max(float(np.log10(curve.n[-1] / curve.n[0])) for curve in curves)
    for curve, ax in zip(curves, panels.flat):
        draw_growth(curve, ax)
        ax.set_xlim(curve.n[-1] / 10 ** (decades + 0.15), curve.n[-1] * 10**0.15)
        ax.set_xticks(
            [
                10.0**power
                for power in range(13)
                if curve.n[0] / 10.0 < 10**power < 1.4 * curve.n[-1]
            ]
        )
        ax.xaxis.set_minor_locator(NullLocator())
    for ax in panels[:, 0]:
        ax.set_ylabel("seconds (processor)", fontsize=palette.TEXT_SIZE)
    for ax in panels.flat[len(curves) :]:
        ax.set_visible(False)
    with written_whole(file) as part:
        figure.savefig(part, format=file.suffix[1:].lower(), dpi=dpi)
