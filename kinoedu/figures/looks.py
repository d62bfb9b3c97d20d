"""Figures of a robot that sees its world on its way."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist

from ..messages import get_message
from ..problems import ProblemRecord
from . import palette
from .drawing import draw_edges, draw_path, draw_problem
from .panels import panels


def draw_looks(
    problem: ProblemRecord, looks: Sequence[Any], which: Sequence[int], axes: Any = None
) -> list[Artist]:
    """Draw some looks: what the robot sees, the walls of its map, its plan, and its way so far.

    Colours and lines are those of the board.

    Parameters
    ----------
    looks : of `receding_horizon_looks`.
    which : their numbers, from 0.
    axes : as many; by default those of a new figure, two in a row.
    """
    if axes is None:
        axes = panels(len(which), columns=2, width=5.3, height=3.5)
    artists: list[Artist] = []
    for ax, k in zip(axes, which):
        look = looks[k]
        artists += draw_problem(problem, ax)
        artists += ax.fill(*look.scan.points.T, color=palette.ROADMAP, alpha=0.35, zorder=0.5)
        artists += draw_edges(look.walls[:, :2], ax, palette.HIT, width=3.5, zorder=2)
        if look.plan.path is not None:
            plan: palette.Style = {"color": palette.TREE, "linewidth": 2.5, "zorder": 4.5}
            artists += ax.plot(*look.plan.path.T, "--", **plan)
        ways = [np.vstack([past.scan.origin, past.followed]) for past in looks[:k]]
        if ways:
            artists += draw_path(np.concatenate(ways), ax)
        artists += ax.plot(*look.scan.origin, "o", color=palette.ROBOT, markersize=11, zorder=9)
        words = get_message("looks.title", k=k + 1, n=len(looks))
        artists.append(ax.set_title(words, fontsize=palette.TEXT_SIZE + 1))
        ax.set(xlabel="", ylabel="", xticks=[], yticks=[])
    return artists
