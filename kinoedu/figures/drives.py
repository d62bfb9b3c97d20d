"""Figures of drives: move by move, among alternatives, and run by run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import groupby
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from ..geometry.checks import Array
from ..messages import get_message
from ..problems import Plan
from ..robots.car import CarRobot
from ..robots.trajectory import TrajectoryRecord
from . import palette
from .cars import draw_drive, draw_poses_line
from .drawing import draw_problem, draw_roadmap, draw_world
from .panels import panels
from .robots import draw_robot, make_ghost
from .samples import label_axes

WIDTHS = (11.0, 6.0, 2.0)  # of nested routes, so that those that coincide are all seen
ROUTES = (palette.ROUTE, palette.PATH, palette.INK)


def draw_moves(
    car: CarRobot,
    trajectory: TrajectoryRecord,
    *,
    goal: ArrayLike | None = None,
    most: int = 8,
    columns: int = 4,
) -> list[Artist]:
    """Draw a drive as a strip: one picture for each move, that is until the gear changes.

    Each shows the car before the move as an outline, after it as a body, and the rear axle's line,
    dashed where the car backs.

    Parameters
    ----------
    goal : (3,), a pose whose outline is drawn in each picture.
    most : the most pictures; of more moves, the last and others at equal distances are drawn. None
        of a car that stands still.

    Examples
    --------
    >>> from kinoedu import Car, Trajectory
    >>> from matplotlib import pyplot as plt
    >>> car = Car(30, 10, 20)
    >>> drive = Trajectory(car, (0, 0, 0), [(1, 0.5), (1, 0), (-1, 0)], [30, 5, 20])
    >>> artists = draw_moves(car, drive)
    >>> plt.close()
    """
    begins = np.concatenate([[0.0], np.cumsum(trajectory.durations)])
    pieces = groupby(
        range(len(trajectory.durations)), lambda i: bool(trajectory.controls[i, 0] < 0)
    )
    moves = [(back, list(rows)) for back, rows in pieces]
    if not moves:
        return []
    shown = np.arange(len(moves))
    if len(moves) > most:
        shown = np.unique(np.linspace(0, len(moves) - 1, most + 1).round().astype(int)[1:])
    way = trajectory.at(np.linspace(0.0, trajectory.duration, 200))[:, :2]
    reach = float(np.abs(car.outline).max())
    lo, hi = way.min(axis=0) - reach, way.max(axis=0) + reach
    artists: list[Artist] = []
    across = min(columns, len(shown))
    strip = panels(len(shown), columns=across, width=2.7, height=2.9)
    for ax, k in zip(strip, shown.tolist()):
        back, rows = moves[k]
        line = trajectory.at(np.linspace(begins[rows[0]], begins[rows[-1] + 1], 60))
        artists.append(ax.add_patch(make_ghost(car, line[0], zorder=3)))
        artists += draw_robot(car, line[-1], ax, palette.ROBOT)
        artists += draw_poses_line(line, back, ax, palette.PATH)
        if goal is not None:
            wanted = make_ghost(car, np.asarray(goal, float), zorder=7)
            wanted.set(edgecolor=palette.GOAL, linewidth=2.4, linestyle="--")
            artists.append(ax.add_patch(wanted))
        words = get_message("moves.back" if back else "moves.forward", k=k + 1, n=len(moves))
        artists.append(ax.set_title(words, fontsize=palette.TEXT_SIZE + 1))
        ax.set(xlim=(lo[0], hi[0]), ylim=(lo[1], hi[1]), aspect="equal", xticks=[], yticks=[])
    return artists


def draw_routes(graphs: Mapping[str, Plan], routes: Sequence[Sequence[Any]]) -> list[Artist]:
    """Draw roadmaps side by side, each with the drives of its best three routes.

    The best is the widest line, the third the thinnest, on top: all are seen where they coincide.

    Parameters
    ----------
    graphs : plans with a roadmap, by their names.
    routes : for each the trajectories and costs of its routes, [(trajectory, cost), ...].
    """
    artists: list[Artist] = []
    for ax, (name, plan), rows in zip(
        panels(len(graphs), width=3.2, height=3.8), graphs.items(), routes
    ):
        artists += draw_problem(plan.problem, ax)
        if plan.roadmap is not None:
            faint = draw_roadmap(plan.roadmap, ax, robot=plan.problem.robot)
            for artist in faint:
                artist.set_alpha(0.25)
            artists += faint
        for (drive, cost), width, colour in zip(rows, WIDTHS, ROUTES):
            places = drive.at(np.linspace(0.0, drive.duration, 300))[:, :2]
            look: palette.Style = {"linewidth": width, "color": colour, "zorder": 5}
            artists += ax.plot(*places.T, label=f"{cost:.0f}", **look)
        below: palette.Style = {"loc": "upper center", "bbox_to_anchor": (0.5, 0.0), "ncols": 3}
        look = {"fontsize": palette.TEXT_SIZE, "handlelength": 1.0, "columnspacing": 0.8}
        legend = ax.legend(title=get_message("routes.length"), **below, **look)
        artists += [legend, ax.set_title(name, fontsize=palette.TEXT_SIZE + 2)]
        ax.set(xlabel="", ylabel="", xticks=[], yticks=[])
    return artists


def draw_drives(drives: Mapping[str, tuple[Any, TrajectoryRecord]]) -> list[Artist]:
    """Draw drives in their worlds, side by side: (problem, trajectory) by names."""
    artists: list[Artist] = []
    for ax, (name, (problem, drive)) in zip(panels(len(drives)), drives.items()):
        artists += draw_world(problem.world, ax)
        artists += draw_drive(problem.robot, drive, ax, ghosts=6)
        artists.append(ax.set_title(name, fontsize=palette.TEXT_SIZE + 1))
    return artists


def draw_runs(
    x: ArrayLike, runs: Array, along: str, up: str, ax: Axes | None = None
) -> list[Artist]:
    """Draw a line for each seed, runs (seeds, m), at the places x (m,), evenly spaced.

    A run that has found nothing yet is infinite, and its line begins later.
    """
    ax = palette.axes_or_new(ax, (8.0, 4.8))
    places = range(len(np.asarray(x)))
    values = np.where(np.isfinite(runs), runs, np.nan)
    look: palette.Style = {
        "color": palette.METHODS[0],
        "alpha": 0.55,
        "linewidth": 2.5,
        "markersize": 8,
    }
    artists: list[Artist] = [line for row in values for line in ax.plot(places, row, "-o", **look)]
    label_axes(along, up, ax)
    ax.set_xticks(places, [f"{n:,}" for n in np.asarray(x).tolist()])
    return artists
