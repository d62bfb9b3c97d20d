"""A roadmap on the torus of two angles, drawn on its square."""

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes

from ..geometry.checks import Array
from ..problems import Plan
from ..spaces.angles import wrap_angles_exactly
from . import palette
from .arms import torus_axes
from .drawing import draw_edges


def draw_torus_roadmap(plan: Plan, ax: Axes | None = None) -> list[Artist]:
    """Draw the roadmap and the path of a two-link arm by its angles, -pi to pi."""
    ax = torus_axes(ax)
    nodes, edges = wrap_angles_exactly(plan.roadmap.nodes), plan.roadmap.edges
    motions = unroll(nodes[edges[:, 0]], nodes[edges[:, 1]])
    artists = draw_edges(motions, ax, palette.ROADMAP, width=0.8, zorder=3)
    artists += ax.plot(*nodes.T, ".", color=palette.TREE, markersize=5, zorder=3.5)
    if plan.path is not None:
        path = wrap_angles_exactly(plan.path)
        legs = unroll(path[:-1], path[1:])
        artists += draw_edges(legs, ax, palette.INK, width=5.0, zorder=4)
        artists += draw_edges(legs, ax, palette.PATH, width=3.0, zorder=5)
    ends: Any = wrap_angles_exactly(np.array([plan.problem.start, plan.problem.goal]))
    for q, colour, marker in zip(ends, (palette.START, palette.GOAL), "o*"):
        artists += ax.plot(*q, marker, color=colour, markersize=13, zorder=7, **palette.RIM)
    return artists


def unroll(a: Array, b: Array) -> Array:
    """The shortest motions from a to b as segments in the square, (k, 2, 2).

    A motion that leaves the square is drawn twice: where it leaves and where it enters.
    """
    change = wrap_angles_exactly(b - a)
    out, back = np.stack([a, a + change], axis=1), np.stack([b - change, b], axis=1)
    return np.concatenate([out, back[np.abs(out[:, 1] - b).max(axis=1) > 1e-9]])
