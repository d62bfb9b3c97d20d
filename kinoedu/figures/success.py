"""Results of many seeds: success rates with 95 % confidence intervals, and values with spread."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from ..chances import wilson_interval
from ..geometry.checks import Array, as_array
from ..messages import get_message
from . import palette
from .samples import COLOURS, LINES, label_axes


def draw_success(
    x: ArrayLike, curves: Mapping[str, ArrayLike], trials: int, along: str, ax: Axes | None = None
) -> list[Artist]:
    """Draw the share of trials that succeed against x (m,), with Wilson's interval as a band.

    Parameters
    ----------
    curves : counts (m,) for each name.
    along : the meaning of x, in words.

    Returns
    -------
    list of artists

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> artists = draw_success([1, 2, 4], {"random": [3, 10, 20]}, 20, "width")
    >>> plt.close()
    """
    ax = palette.axes_or_new(ax, (7.0, 4.6))
    places, artists = as_array(x, "x"), list[Artist]()
    for i, (name, counts) in enumerate(curves.items()):
        low, high = wilson_interval(counts, trials)
        artists.append(draw_band(places, low, high, i, ax))
        artists += ax.plot(places, as_array(counts, name) / trials, label=name, **curve_style(i))
    label_axes(along, get_message("success.share", trials=trials), ax)
    ax.set_ylim(-0.03, 1.03)
    return [*artists, ax.legend(fontsize=palette.TEXT_SIZE, loc="best")]


def draw_spread(
    x: ArrayLike, curves: Mapping[str, ArrayLike], along: str, up: str, ax: Axes | None = None
) -> list[Artist]:
    """Draw values of many seeds against x (m,), logarithmic: medians and the middle 80 percent.

    Parameters
    ----------
    curves : (seeds, m) for each name.
    along, up : the meanings of x and of the values, in words.

    Returns
    -------
    list of artists

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> artists = draw_spread([10, 100], {"PRM": [[1.4, 1.1], [1.3, 1.2]]}, "samples", "length")
    >>> plt.close()
    """
    ax = palette.axes_or_new(ax, (7.0, 4.6))
    places, artists = as_array(x, "x"), list[Artist]()
    for i, (name, values) in enumerate(curves.items()):
        runs = np.asarray(values, float)
        low, middle, high = np.quantile(runs, (0.1, 0.5, 0.9), axis=0, method="nearest")
        artists.append(draw_band(places, low, high, i, ax))
        artists += ax.semilogx(places, middle, label=name, **curve_style(i))
    label_axes(along, up, ax)
    ax.set_xticks(places, [f"{place:g}" for place in places])
    ax.minorticks_off()
    return [*artists, ax.legend(fontsize=palette.TEXT_SIZE, loc="best")]


def draw_dots(
    x: ArrayLike, values: ArrayLike, along: str, up: str, ax: Axes | None = None
) -> list[Artist]:
    """Draw values of many seeds against x (m,): a dot for each seed, and a line through medians.

    Parameters
    ----------
    values : (seeds, m).
    along, up : the meanings of x and of the values, in words.

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> artists = draw_dots([1, 2], [[0.1, 0.4], [0.2, 0.6]], "joints", "share")
    >>> plt.close()
    """
    ax = palette.axes_or_new(ax, (7.0, 4.6))
    places, runs = as_array(x, "x"), np.asarray(values, float)
    artists: list[Artist] = [*ax.plot(places, runs.T, ".", color=COLOURS[0], markersize=7)]
    median: palette.Style = {"color": COLOURS[1], "linewidth": 2.6}
    artists += ax.plot(places, np.median(runs, axis=0), "-", **median)
    label_axes(along, up, ax)
    return artists


def draw_band(x: Array, low: Array, high: Array, i: int, ax: Axes) -> Artist:
    """Draw the band of curve i."""
    return ax.fill_between(x, low, high, color=COLOURS[i % 4], alpha=0.2, linewidth=0)


def curve_style(i: int) -> palette.Style:
    """The style of curve i."""
    look = {"linestyle": LINES[i % 4], "marker": "o^sD"[i % 4], "color": COLOURS[i % 4]}
    return {**look, "linewidth": 2.2}
