"""Several pictures side by side."""

from __future__ import annotations

from collections.abc import Mapping

from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes

from ..geometry.checks import integer
from ..problems import Plan
from . import palette
from .drawing import draw_plan, figure_size

WIDTH = 13.0  # inches of a row of panels, at most


def panels(
    n: int, *, columns: int | None = None, width: float | None = None, height: float = 4.0
) -> list[Axes]:
    """New axes for n pictures, row by row.

    Parameters
    ----------
    columns : pictures in a row; by default all n.
    width, height : inches of each; by default as wide as a page allows.

    Returns
    -------
    list of n axes

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> left, right = panels(2)
    >>> plt.close()
    """
    across = integer(n if columns is None else columns, "columns", least=1)
    rows = -(-integer(n, "n", least=1) // across)
    wide = min(WIDTH / across, 6.5) if width is None else width
    size = (wide * across, height * rows)
    _, axes = plt.subplots(*(rows, across), figsize=size, dpi=72, layout="constrained")
    row = [axes] if rows * across == 1 else list(axes.ravel())
    for ax in row[n:]:
        ax.set_visible(False)
    return row[:n]


def draw_plans(
    plans: Mapping[str, Plan], *, columns: int | None = None, width: float | None = None
) -> list[Artist]:
    """Draw plans side by side, each under its name; an empty name stands for the plan's summary.

    Parameters
    ----------
    columns : pictures in a row; by default all.
    width : inches of each picture; by default as wide as a page allows.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, rrt
    >>> problem = Problem(Point(), PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)]), (1, 1), (8, 5))
    >>> artists = draw_plans({f"seed {seed}": rrt(problem, rng=seed) for seed in (0, 1)})
    >>> plt.close()
    """
    across = len(plans) if columns is None else columns
    wide = min(WIDTH / across, 6.5) if width is None else width
    x, y = figure_size(next(iter(plans.values())).problem.world)
    shape = wide * (y - 0.4) / x
    axes = panels(len(plans), columns=across, width=wide, height=shape)
    for ax, name in zip(axes, plans):
        dress(ax, name or " ")
    lay_out(axes[0])  # so that names keep off the paths where they will be
    artists: list[Artist] = []
    for ax, (name, plan) in zip(axes, plans.items()):
        artists += [*draw_plan(plan, ax), ax.title]
        dress(ax, name)
    return artists


def dress(ax: Axes, name: str) -> None:
    """Leave a panel without ticks and labels, and under its name, if it has one."""
    ax.set(xlabel="", ylabel="", xticks=[], yticks=[])
    if name:
        ax.set_title(name, fontsize=palette.TEXT_SIZE + 1)


def lay_out(ax: Axes) -> None:
    """Place the panels of a figure now, not when it is drawn."""
    figure = ax.get_figure(root=True)
    if figure and (engine := figure.get_layout_engine()):
        engine.execute(figure)
