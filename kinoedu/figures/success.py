"""What comes of many seeds: how often something succeeds, with the interval in which the truth lies
95 times of 100; how large something is, with its spread.
"""

from collections.abc import Mapping

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from ..chances import wilson
from ..geometry.checks import as_array
from ..words import say
from . import palette
from .samples import COLOURS, LINES


def draw_success(
    x: ArrayLike, curves: Mapping[str, ArrayLike], trials: int, along: str, ax: Axes | None = None
) -> list[Artist]:
    """Draw the share of trials that succeed against x (m,): for each name a curve of counts (m,),
    and Wilson's interval as a band.

    along : what x is, in words. Returns the artists. Raises InvalidParameter.

    >>> artists = draw_success([1, 2, 4], {"random": [3, 10, 20]}, 20, "width")
    >>> plt.close()
    """
    if ax is None:
        _, ax = plt.subplots(figsize=(7.0, 4.6), dpi=72, layout="constrained")
    places, artists = as_array(x, "x"), list[Artist]()
    for i, (name, counts) in enumerate(curves.items()):
        low, high = wilson(counts, trials)
        colour = COLOURS[i % len(COLOURS)]
        artists.append(ax.fill_between(places, low, high, color=colour, alpha=0.2, linewidth=0))
        artists += ax.plot(
            places,
            as_array(counts, name) / trials,
            LINES[i % len(LINES)],
            marker="o^sD"[i % 4],
            color=colour,
            linewidth=2.2,
            label=name,
        )
    dress(along, say("success.share", trials=trials), ax)
    ax.set_ylim(-0.03, 1.03)
    return [*artists, ax.legend(fontsize=palette.TEXT_SIZE, loc="best")]


def draw_spread(
    x: ArrayLike, curves: Mapping[str, ArrayLike], along: str, up: str, ax: Axes | None = None
) -> list[Artist]:
    """Draw numbers that came of many seeds against x (m,): for each name an array (seeds, m), its
    median and 80 percent of it.

    along, up : what x and the numbers are, in words. x is drawn on a logarithmic axis. Returns the
        artists.

    >>> artists = draw_spread([10, 100], {"PRM": [[1.4, 1.1], [1.3, 1.2]]}, "samples", "length")
    >>> plt.close()
    """
    if ax is None:
        _, ax = plt.subplots(figsize=(7.0, 4.6), dpi=72, layout="constrained")
    places, artists = as_array(x, "x"), list[Artist]()
    for i, (name, values) in enumerate(curves.items()):
        low, middle, high = np.quantile(
            np.asarray(values, float), (0.1, 0.5, 0.9), axis=0, method="nearest"
        )
        colour = COLOURS[i % len(COLOURS)]
        artists.append(ax.fill_between(places, low, high, color=colour, alpha=0.2, linewidth=0))
        artists += ax.semilogx(
            places,
            middle,
            LINES[i % len(LINES)],
            marker="o^sD"[i % 4],
            color=colour,
            linewidth=2.2,
            label=name,
        )
    dress(along, up, ax)
    ax.set_xticks(places, [f"{place:g}" for place in places])
    ax.minorticks_off()
    return [*artists, ax.legend(fontsize=palette.TEXT_SIZE, loc="best")]


def dress(along: str, up: str, ax: Axes) -> None:
    """Name the axes."""
    ax.set_xlabel(along, fontsize=palette.TEXT_SIZE)
    ax.set_ylabel(up, fontsize=palette.TEXT_SIZE)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(color="#E5E7EB", linewidth=0.8, zorder=0)
