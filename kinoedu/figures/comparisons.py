"""Many runs of planners beside each other: medians with their spread, shares of runs, and costs
that fall as a tree grows.

Each takes numbers by the planners' names, in one order and so in one colour; a run that never found
a path is infinite.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from ..errors import InvalidPoint
from ..geometry.checks import Array, whole
from ..support.text import shortened
from ..words import say
from . import palette
from .ends import name_ends

COLOURS = (palette.TREE, palette.GOAL, palette.START, palette.ROBOT, palette.INK, palette.ROADMAP)
LINES = ("-", "--", "-.", ":")
WIDE = 20.0  # values whose largest is so many times the smallest are drawn on a logarithmic axis


def draw_medians(
    values: Mapping[str, ArrayLike],
    ax: Axes | None = None,
    *,
    label: str = "",
    colours: int = len(COLOURS),
) -> list[Artist]:
    """Draw a bar as long as the median of each planner's values (runs,), with a line over the
    middle half of them, and its number.

    Infinite values count neither there nor there: how many of the runs are finite is written beside
    the number. `label` is what the numbers are. After so many `colours`, at least 1, the first
    comes again: 2 where two planners take turns on several problems. Returns the artists. Raises
    InvalidPoint, InvalidParameter.

    >>> artists = draw_medians({"RRT": [12.0, 14.0, np.inf], "PRM": [11.0, 11.5, 12.0]}, label="length")
    >>> plt.close()
    """
    runs, colours = as_runs(values), whole(colours, "colours", least=1)
    ax = axes_of(ax, (7.0, 1.0 + 0.6 * len(runs)))
    finite = [given[np.isfinite(given)] for given in runs.values()]
    spreads = np.array(
        [
            np.quantile(some, (0.25, 0.5, 0.75)) if len(some) else np.full(3, np.nan)
            for some in finite
        ]
    )
    artists: list[Artist] = []
    paint = [COLOURS[i % colours % len(COLOURS)] for i in range(len(runs))]
    for i, ((low, median, high), some, given) in enumerate(zip(spreads, finite, runs.values())):
        artists += ax.barh(i, np.nan_to_num(median), height=0.62, color=paint[i], alpha=0.45)
        artists += ax.plot(
            [low, high], [i, i], color=palette.INK, linewidth=2.4, solid_capstyle="butt"
        )
        artists += ax.plot(
            [median, median],
            [i - 0.31, i + 0.31],
            color=paint[i],
            linewidth=3.0,
            solid_capstyle="butt",
        )
        place = np.nan_to_num(high)
        artists.append(
            ax.annotate(
                number(median, some, given),
                (place, i),
                xytext=(6, 0),
                textcoords="offset points",
                **TEXT,
            )
        )
    ax.set_yticks(range(len(runs)), list(runs))
    ax.set_ylim(len(runs) - 0.5, -0.5)
    tallest = np.nanmax(spreads[:, 2]) if np.isfinite(spreads).any() else 1.0
    ax.set_xlim(
        0.0,
        (tallest or 1.0)
        * (1.75 if any(len(s) < len(g) for s, g in zip(finite, runs.values())) else 1.3),
    )
    return [*artists, *dressed(ax, label, grid="x")]


TEXT: dict[str, Any] = {"fontsize": palette.TEXT_SIZE, "va": "center", "color": palette.INK}


def number(median: float, finite: Array, runs: Array) -> str:
    """The median, and how many runs it is of where that is not all."""
    if not len(finite):
        return say("comparisons.never")
    words = "comparisons.all" if len(finite) == len(runs) else "comparisons.count"
    return say(
        words,
        median=f"{median:.3g}" if median < 1000 else f"{median:,.0f}",
        found=len(finite),
        runs=len(runs),
    )


def draw_ecdf(
    values: Mapping[str, ArrayLike], ax: Axes | None = None, *, label: str = ""
) -> list[Artist]:
    """Draw for each planner what share of its runs (runs,) have a value of at most x; where some
    are infinite it ends below 1.

    The axis is logarithmic where values are far apart. Returns the artists. Raises InvalidPoint.

    >>> artists = draw_ecdf({"RRT": [12.0, 14.0, np.inf], "PRM": [11.0, 11.5, 12.0]}, label="length")
    >>> plt.close()
    """
    runs = as_runs(values)
    ax = axes_of(ax, (7.0, 4.6))
    finite = {name: np.sort(given[np.isfinite(given)]) for name, given in runs.items()}
    low, high, wide = limits(np.concatenate(list(finite.values())))
    artists: list[Artist] = []
    ends = []
    for i, (name, some) in enumerate(finite.items()):
        share = np.arange(len(some) + 1) / len(runs[name])
        x, y = np.concatenate([[low], some, [high]]), np.concatenate([share, share[-1:]])
        artists += ax.step(x, y, LINES[i % 4], where="post", color=COLOURS[i % 6], linewidth=2.4)
        ends.append(
            (
                name,
                float(share[-1]),
                COLOURS[i % 6],
                float(np.median(some)) if len(some) else np.inf,
            )
        )
    if wide:
        ax.set_xscale("log")
    ax.set_xlim(low, high)
    ax.set_ylim(0.0, 1.03)
    ax.set_ylabel(say("comparisons.share"), fontsize=palette.TEXT_SIZE)
    named = [
        (name, height, colour) for name, height, colour, _ in sorted(ends, key=lambda end: -end[3])
    ]
    return [*artists, *name_ends(high, named, ax), *dressed(ax, label)]


def limits(values: Array) -> tuple[float, float, bool]:
    """Where an axis of these values begins and ends, and whether it is logarithmic."""
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
    """Draw for each planner numbers of nodes n (m,) and costs (m, seeds): the median over the
    seeds, in a band of the middle half.

    A seed without a path has infinite cost, and a curve begins where half of the seeds have one.
    Raises InvalidPoint.

    >>> artists = draw_convergence({"RRT*": ([100, 200], [[14.0, 13.0, np.inf], [13.0, 12.5, 12.8]])}, label="length")
    >>> plt.close()
    """
    ax = axes_of(ax, (7.0, 4.6))
    artists: list[Artist] = []
    ends = []
    for i, (name, (n, costs)) in enumerate(curves.items()):
        sizes, spread = np.asarray(n, float), np.asarray(costs, float)
        if (
            sizes.ndim != 1
            or spread.ndim != 2
            or len(spread) != len(sizes)
            or not spread.size
            or np.isnan(spread).any()
        ):
            raise InvalidPoint(
                f"{name!r} needs nodes (m,) and costs (m, seeds), got shapes {sizes.shape} and "
                f"{spread.shape}"
            )
        low, median, high = np.quantile(spread, (0.25, 0.5, 0.75), axis=1, method="inverted_cdf")
        median[np.isinf(median)] = np.nan
        artists.append(
            ax.fill_between(
                sizes,
                low,
                high,
                where=np.isfinite(high),
                color=COLOURS[i % 6],
                alpha=0.2,
                linewidth=0,
            )
        )
        artists += ax.plot(
            sizes, median, LINES[i % 4], color=COLOURS[i % 6], linewidth=2.4, marker="o^sD"[i % 4]
        )
        if np.isfinite(median).any():
            ends.append((name, float(median[np.isfinite(median)][-1]), COLOURS[i % 6]))
    ax.set_xlabel(say("comparisons.nodes"), fontsize=palette.TEXT_SIZE)
    ax.set_ylabel(label, fontsize=palette.TEXT_SIZE)
    right = ax.get_xlim()[1]
    ax.set_xlim(right=right)
    return [*artists, *name_ends(right, ends, ax), *dressed(ax, say("comparisons.nodes"))]


def as_runs(values: Mapping[str, ArrayLike]) -> dict[str, Array]:
    """Numbers by names, at least one of each, no NaN. Raises InvalidPoint."""
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


def axes_of(ax: Axes | None, size: tuple[float, float]) -> Axes:
    """The axes given, or those of a new figure."""
    return plt.subplots(figsize=size, dpi=72, layout="constrained")[1] if ax is None else ax


def dressed(ax: Axes, label: str, *, grid: str = "both") -> list[Artist]:
    """What x is, large ticks, a quiet grid."""
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(color="#E5E7EB", linewidth=0.8, axis=grid)  # type: ignore[arg-type]
    ax.set_axisbelow(True)
    ax.spines[["top", "right"]].set_visible(False)
    return [ax.set_xlabel(label, fontsize=palette.TEXT_SIZE)]
