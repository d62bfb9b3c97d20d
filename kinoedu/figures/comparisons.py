"""Figures that compare planners over many runs: medians, shares of runs, convergence.

Each takes numbers by the planners' names. The order of the names sets the colours. A run without a
path is infinite.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from ..errors import InvalidPoint
from ..geometry.checks import Array, integer
from ..messages import get_message
from ..support.text import shortened
from . import palette
from .ends import name_ends
from .palette import Style

TEXT: Style = {**palette.TEXT, "va": "center", "color": palette.INK}
BUTT: Style = {"solid_capstyle": "butt"}
COLOURS = palette.METHODS
LINES = ("-", "--", "-.", ":")
WIDE = 20.0  # the ratio of largest to smallest value from which on the axis is logarithmic


def draw_medians(
    values: Mapping[str, ArrayLike],
    ax: Axes | None = None,
    *,
    label: str = "",
    colours: int = len(COLOURS),
) -> list[Artist]:
    """Draw a bar as long as the median of each planner's values, with its number.

    A line shows the middle half of the values. Infinite values are left out of both; if there are
    some, the number of finite ones is written too.

    Parameters
    ----------
    values : (runs,) for each name.
    label : the quantity, written at the axis.
    colours : the number of colours, at least 1, before the first repeats: 2 where two planners take
        turns on several problems.

    Returns
    -------
    list of artists

    Raises
    ------
    InvalidPoint, InvalidParameter

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> lengths = {"RRT": [12.0, 14.0, np.inf], "PRM": [11.0, 11.5, 12.0]}
    >>> artists = draw_medians(lengths, label="length")
    >>> plt.close()
    """
    runs, colours = as_runs(values), integer(colours, "colours", least=1)
    ax = palette.axes_or_new(ax, (7.0, 1.0 + 0.6 * len(runs)))
    finite = [given[np.isfinite(given)] for given in runs.values()]
    spreads = np.array([quartiles(some) for some in finite])
    artists: list[Artist] = []
    for i, ((low, median, high), some, given) in enumerate(zip(spreads, finite, runs.values())):
        colour = COLOURS[i % colours % len(COLOURS)]
        artists += ax.barh(i, np.nan_to_num(median), height=0.62, color=colour, alpha=0.45)
        artists += ax.plot([low, high], [i, i], color=palette.INK, linewidth=2.4, **BUTT)
        ends = [i - 0.31, i + 0.31]
        artists += ax.plot([median, median], ends, color=colour, linewidth=3.0, **BUTT)
        beside: Style = {"xytext": (6, 0), "textcoords": "offset points"}
        place = (np.nan_to_num(high), i)
        artists.append(ax.annotate(format_median(median, some, given), place, **beside, **TEXT))
    ax.set_yticks(range(len(runs)), list(runs))
    ax.set_ylim(len(runs) - 0.5, -0.5)
    tallest = np.nanmax(spreads[:, 2]) if np.isfinite(spreads).any() else 1.0
    some_failed = any(len(some) < len(given) for some, given in zip(finite, runs.values()))
    ax.set_xlim(0.0, (tallest or 1.0) * (1.75 if some_failed else 1.3))
    return [*artists, *dress_axes(ax, label, grid="x")]


def quartiles(values: Array) -> Array:
    """The quartiles of some values, (3,); nan where there are none."""
    return np.quantile(values, (0.25, 0.5, 0.75)) if len(values) else np.full(3, np.nan)


def format_median(median: float, finite: Array, runs: Array) -> str:
    """The median in words, and how many runs it is of, unless it is of all."""
    if not len(finite):
        return get_message("comparisons.never")
    key = "comparisons.all" if len(finite) == len(runs) else "comparisons.count"
    middle = f"{median:.3g}" if median < 1000 else f"{median:,.0f}"
    return get_message(key, median=middle, found=len(finite), runs=len(runs))


def draw_ecdf(
    values: Mapping[str, ArrayLike], ax: Axes | None = None, *, label: str = ""
) -> list[Artist]:
    """Draw for each planner the share of its runs with a value of at most x.

    Where some runs are infinite the curve ends below 1. The axis is logarithmic where values are
    far apart.

    Parameters
    ----------
    values : (runs,) for each name.

    Returns
    -------
    list of artists

    Raises
    ------
    InvalidPoint

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> lengths = {"RRT": [12.0, 14.0, np.inf], "PRM": [11.0, 11.5, 12.0]}
    >>> artists = draw_ecdf(lengths, label="length")
    >>> plt.close()
    """
    runs = as_runs(values)
    ax = palette.axes_or_new(ax, (7.0, 4.6))
    finite = {name: np.sort(given[np.isfinite(given)]) for name, given in runs.items()}
    low, high, wide = choose_limits(np.concatenate(list(finite.values())))
    artists: list[Artist] = []
    ends = []
    for i, (name, some) in enumerate(finite.items()):
        fraction = np.arange(len(some) + 1) / len(runs[name])
        x, y = np.concatenate([[low], some, [high]]), np.concatenate([fraction, fraction[-1:]])
        artists += ax.step(x, y, LINES[i % 4], where="post", color=COLOURS[i % 6], linewidth=2.4)
        median = float(np.median(some)) if len(some) else np.inf
        ends.append((name, float(fraction[-1]), COLOURS[i % 6], median))
    if wide:
        ax.set_xscale("log")
    ax.set_xlim(low, high)
    ax.set_ylim(0.0, 1.03)
    ax.set_ylabel(get_message("comparisons.share"), fontsize=palette.TEXT_SIZE)
    named = [end[:3] for end in sorted(ends, key=lambda end: -end[3])]
    return [*artists, *name_ends(high, named, ax), *dress_axes(ax, label)]


def choose_limits(values: Array) -> tuple[float, float, bool]:
    """The limits of an axis for these values, and whether it is logarithmic."""
    if not len(values):
        return 0.0, 1.0, False
    least, most = float(values.min()), float(values.max())
    if least > 0.0 and most > WIDE * least:
        return least / 1.3, most * 1.3, True
    room = 0.05 * (most - least) or 0.05 * abs(most) or 1.0
    return least - room, most + room, False


def draw_convergence(
    curves: Mapping[str, tuple[ArrayLike, ArrayLike]], ax: Axes | None = None, *, label: str = ""
) -> list[Artist]:
    """Draw for each planner the median cost over seeds against the number of nodes.

    A band shows the middle half. A seed without a path has infinite cost; a curve begins where half
    of the seeds have a path.

    Parameters
    ----------
    curves : for each name n (m,) and costs (m, seeds).

    Raises
    ------
    InvalidPoint

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> costs = [[14.0, 13.0, np.inf], [13.0, 12.5, 12.8]]
    >>> artists = draw_convergence({"RRT*": ([100, 200], costs)}, label="length")
    >>> plt.close()
    """
    ax = palette.axes_or_new(ax, (7.0, 4.6))
    artists: list[Artist] = []
    ends = []
    for i, (name, (n, costs)) in enumerate(curves.items()):
        sizes, spread = np.asarray(n, float), np.asarray(costs, float)
        fits = sizes.ndim == 1 and spread.ndim == 2 and len(spread) == len(sizes)
        if not fits or not spread.size or np.isnan(spread).any():
            raise InvalidPoint(
                f"{name!r} needs nodes (m,) and costs (m, seeds), got shapes {sizes.shape} and "
                f"{spread.shape}"
            )
        low, median, high = np.quantile(spread, (0.25, 0.5, 0.75), axis=1, method="inverted_cdf")
        median[np.isinf(median)] = np.nan
        colour, line, marker = COLOURS[i % 6], LINES[i % 4], "o^sD"[i % 4]
        band: Style = {"where": np.isfinite(high), "alpha": 0.2, "linewidth": 0}
        artists.append(ax.fill_between(sizes, low, high, color=colour, **band))
        artists += ax.plot(sizes, median, line, color=colour, linewidth=2.4, marker=marker)
        if np.isfinite(median).any():
            ends.append((name, float(median[np.isfinite(median)][-1]), colour))
    ax.set_ylabel(label, fontsize=palette.TEXT_SIZE)
    right = ax.get_xlim()[1]
    ax.set_xlim(right=right)
    return [
        *artists,
        *name_ends(right, ends, ax),
        *dress_axes(ax, get_message("comparisons.nodes")),
    ]


def as_runs(values: Mapping[str, ArrayLike]) -> dict[str, Array]:
    """Values by names, at least one for each name and no NaN; or InvalidPoint."""
    if not isinstance(values, Mapping) or not values:
        raise InvalidPoint(
            f"values must be a dict of numbers by planners' names, got {shortened(values)}"
        )
    runs = {str(name): np.asarray(given, float) for name, given in values.items()}
    for name, given in runs.items():
        if given.ndim != 1 or not len(given) or np.isnan(given).any():
            raise InvalidPoint(
                f"{name!r} must have at least one number, (runs,), inf for never, got "
                f"{shortened(given)}"
            )
    return runs


def dress_axes(ax: Axes, label: str, *, grid: str = "both") -> list[Artist]:
    """Set the label of x, large ticks and a light grid."""
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(axis=grid, **palette.GRID)  # type: ignore[arg-type]
    ax.set_axisbelow(True)
    ax.spines[["top", "right"]].set_visible(False)
    return [ax.set_xlabel(label, fontsize=palette.TEXT_SIZE)]
