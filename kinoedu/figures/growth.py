"""Running time against n: a panel for each curve, both axes logarithmic, with fitted exponents."""

import os
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import NullLocator

from ..geometry.checks import Array
from . import palette
from .palette import Style
from .saving import save_figure

PANEL, COLUMNS = (4.0, 3.5), 4  # the size of a panel in inches; panels in a row


class Curve(NamedTuple):
    """A measured curve.

    Attributes
    ----------
    name : the task measured.
    unit : the things that n counts.
    n : (m,).
    seconds : (m, rounds).
    exponent : the exponent fitted to the last `fitted` n.
    """

    name: str
    unit: str
    n: Array
    seconds: Array
    exponent: float
    fitted: int


def draw_growth(curve: Curve, ax: Axes | None = None) -> list[Artist]:
    """Draw the median over the rounds in a band from fastest to slowest, and the fitted line.

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> n, seconds = np.array([1.0, 2, 4]), np.array([[1.0, 2], [2, 3], [4, 5]])
    >>> artists = draw_growth(Curve("RRT", "nodes", n, seconds, 1.2, 2))
    >>> plt.close()
    """
    ax = palette.axes_or_new(ax, PANEL)
    ax.set_xscale("log")
    ax.set_yscale("log")
    median, least, most = (f(curve.seconds, axis=1) for f in (np.median, np.min, np.max))
    tint: Style = {"color": palette.TREE, "alpha": 0.25, "linewidth": 0}
    artists: list[Artist] = [ax.fill_between(curve.n, least, most, **tint)]
    last = curve.n[-curve.fitted :]
    middle = np.log(median[-curve.fitted :]).mean()
    height = np.exp(middle + curve.exponent * (np.log(last) - np.log(last).mean()))
    line: Style = {"linewidth": 5.0, "alpha": 0.5, "solid_capstyle": "butt"}
    artists += ax.plot(last, height, color=palette.METHODS[1], **line)
    artists += ax.plot(curve.n, median, "o-", color=palette.TREE, linewidth=2.0, markersize=5.0)
    ax.tick_params(labelsize=palette.TEXT_SIZE)
    ax.grid(**palette.GRID)
    ax.spines[["top", "right"]].set_visible(False)
    style: Style = {"fontsize": palette.TEXT_SIZE + 1, "color": palette.INK}
    title = ax.set_title(f"{curve.name}: $n^{{{curve.exponent:.2f}}}$", **style)
    return [*artists, title, ax.set_xlabel(f"n = {curve.unit}", **palette.TEXT)]


def save_growth(curves: Sequence[Curve], path: str | os.PathLike[str], *, dpi: int = 100) -> None:
    """Draw curves side by side into a picture, as `save_figure` writes it.

    All panels span the same number of decades, so that slopes can be compared.
    """
    rows, columns = -(-len(curves) // COLUMNS), min(COLUMNS, len(curves))
    figure = Figure(figsize=(PANEL[0] * columns, PANEL[1] * rows), layout="constrained")
    FigureCanvasAgg(figure)
    panels = figure.subplots(rows, columns, squeeze=False, sharey=True)
    decades = max(float(np.log10(curve.n[-1] / curve.n[0])) for curve in curves)
    for curve, ax in zip(curves, panels.flat):
        draw_growth(curve, ax)
        ax.set_xlim(curve.n[-1] / 10 ** (decades + 0.15), curve.n[-1] * 10**0.15)
        powers = (10.0**power for power in range(13))
        ax.set_xticks([n for n in powers if curve.n[0] / 10.0 < n < 1.4 * curve.n[-1]])
        ax.xaxis.set_minor_locator(NullLocator())
    for ax in panels[:, 0]:
        ax.set_ylabel("seconds (processor)", fontsize=palette.TEXT_SIZE)
    for ax in panels.flat[len(curves) :]:
        ax.set_visible(False)
    save_figure(figure, path, dpi=dpi)
