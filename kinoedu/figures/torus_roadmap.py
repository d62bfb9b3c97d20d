"""A roadmap on the torus of two angles: what leaves the square on one side comes in on the other."""

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes

from ..geometry.checks import Array
from ..problems import Plan
from . import palette
from .drawing import draw_edges

FULL = 2.0 * np.pi


def draw_torus_roadmap(plan: Plan, ax: Axes | None = None) -> list[Artist]:
    """Draw the roadmap and the path of a two-link arm by its angles, 0 to 2 pi. Returns the artists."""
    if ax is None:
        _, ax = plt.subplots(figsize=(6.0, 6.0), dpi=72, layout="constrained")
    nodes, edges = np.mod(plan.roadmap.nodes, FULL), plan.roadmap.edges
    artists = draw_edges(unrolled(nodes[edges[:, 0]], nodes[edges[:, 1]]), ax, palette.ROADMAP, width=0.8, zorder=3)
    artists += ax.plot(*nodes.T, ".", color=palette.TREE, markersize=5, zorder=3.5)
    if plan.path is not None:
        path = np.mod(plan.path, FULL)
        artists += draw_edges(unrolled(path[:-1], path[1:]), ax, palette.INK, width=5.0, zorder=4)
        artists += draw_edges(unrolled(path[:-1], path[1:]), ax, palette.PATH, width=3.0, zorder=5)
    ends: Any = np.mod([plan.problem.start, plan.problem.goal], FULL)
    for q, colour, marker in zip(ends, (palette.START, palette.GOAL), "o*"):
        artists += ax.plot(*q, marker, color=colour, markersize=13, markeredgecolor="white", zorder=7)
    ax.set_xlim(0, FULL)
    ax.set_ylim(0, FULL)
    ax.set_aspect("equal")
    ticks, names = np.linspace(0, FULL, 5), ["0", "π/2", "π", "3π/2", "2π"]
    ax.set_xticks(ticks, names, fontsize=palette.TEXT_SIZE)
    ax.set_yticks(ticks, names, fontsize=palette.TEXT_SIZE)
    ax.set_xlabel("$q_1$", fontsize=palette.TEXT_SIZE)
    ax.set_ylabel("$q_2$", fontsize=palette.TEXT_SIZE)
    return artists


def unrolled(a: Array, b: Array) -> Array:
    """The shorter ways from a to b, (k, 2, 2); those that leave the square once more, as they come in on the other side."""
    way = np.mod(b - a + np.pi, FULL) - np.pi
    out, back = np.stack([a, a + way], axis=1), np.stack([b - way, b], axis=1)
    return np.concatenate([out, back[np.abs(out[:, 1] - b).max(axis=1) > 1e-9]])
