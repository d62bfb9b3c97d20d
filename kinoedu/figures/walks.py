"""Figures of a bug's walk: in the world, and as distance to the goal against distance walked."""

from collections.abc import Iterable
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib import patheffects
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from ..geometry.checks import Array
from ..problems import Plan, Walk
from . import palette
from .names import move_names_off
from .palette import Style

CASING = [patheffects.withStroke(linewidth=4.5, foreground=palette.INK)]
HALO = [patheffects.withStroke(linewidth=3.0, foreground="white")]
ARROWS = 12  # about the number of arrows that show the direction of a walk
STRAIGHT = 0.3  # of the way between two arrows: the walk must be straight so long before a tip


def draw_walk(walk: Walk, ax: Axes, *, upto: int | None = None) -> list[Artist]:
    """Draw a walk, or its first `upto` points: dotted blue to the goal, solid orange along walls.

    H1, H2, ... mark hits of walls and L1, L2, ... leaves. The board has the same two colours.
    """
    shown = len(walk.points) if upto is None else min(max(upto, 1), len(walk.points))
    artists = draw_stretches(walk.points[:shown], walk.following[:shown], ax)
    artists += draw_arrows(walk, shown, ax)
    artists += mark_hits_and_leaves(walk.points, walk, shown, ax)
    move_names_off(walk.points[:shown], ax)
    return artists


def draw_distance_to_goal(plan: Plan, ax: Axes | None = None) -> list[Artist]:
    """Plot the distance to the goal against the distance walked.

    Lines and marks are those of `draw_walk`.

    Raises
    ------
    TypeError
        Where the plan has no walk.
    """
    ax = palette.axes_or_new(ax, (7.0, 3.2))
    walk = plan.walk
    if walk is None:
        raise TypeError(
            f"a plan of {plan.planner or 'this planner'} has no walk; those of the Bug family have"
        )
    curve = np.column_stack([walk.travelled, walk.distance_to_goal])
    artists = draw_stretches(curve, walk.following, ax)
    artists += mark_hits_and_leaves(curve, walk, len(curve), ax, above=True)
    ax.set_xlim(0.0, max(1.1 * walk.travelled[-1], 1e-9))
    ax.set_ylim(0.0, 1.15 * walk.distance_to_goal.max() or 1.0)
    ax.set_xlabel("way travelled", fontsize=palette.TEXT_SIZE)
    ax.set_ylabel("distance to goal", fontsize=palette.TEXT_SIZE)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    ax.grid(alpha=0.3)
    return artists


def draw_stretches(points: Array, following: Iterable[bool], ax: Axes) -> list[Artist]:
    """Draw the line through points (n, 2): solid orange along walls, dotted blue elsewhere."""
    along = np.asarray(following, dtype=bool)[1:]
    changes = np.flatnonzero(along[1:] != along[:-1]) + 1
    artists: list[Artist] = []
    for run in np.split(np.arange(len(points) - 1), changes):
        if len(run):
            line = points[run[0] : run[-1] + 2]
            style: Any = "-" if along[run[0]] else (0, (0.1, 1.8))
            colour = palette.PATH if along[run[0]] else palette.TREE
            look: Style = {"colors": colour, "linewidths": 2.6, "capstyle": "round"}
            lines = LineCollection([line], linestyles=[style], zorder=5, **look)
            lines.set_path_effects([*CASING, patheffects.Normal()])
            artists.append(ax.add_collection(lines, autolim=False))
    return artists


def draw_arrows(walk: Walk, shown: int, ax: Axes) -> list[Artist]:
    """Draw arrow heads along a walk that show its direction, at equal distances."""
    every = walk.travelled[-1] / ARROWS
    if every == 0.0:
        return []
    head = {"arrowstyle": "-|>,head_width=0.26,head_length=0.75", "color": palette.INK}
    style = {**head, "shrinkA": 0, "shrinkB": 0}
    artists: list[Artist] = []
    for place in np.arange(0.5 * every, walk.travelled[shown - 1], every):
        back, tip = (place_at(walk, way) for way in (place - STRAIGHT * every, place))
        if np.hypot(*(tip - back)) > 0.98 * STRAIGHT * every:  # no corner is beneath the head
            tail = tip - 1e-3 * (tip - back)
            artists.append(
                ax.annotate("", (tip[0], tip[1]), (tail[0], tail[1]), arrowprops=style, zorder=5.5)
            )
    return artists


def place_at(walk: Walk, way: float) -> Array:
    """The place of a walk after a way, (2,)."""
    return np.array([np.interp(way, walk.travelled, values) for values in walk.points.T])


def mark_hits_and_leaves(
    points: Array, walk: Walk, shown: int, ax: Axes, *, above: bool = False
) -> list[Artist]:
    """Mark hits with squares and leaves with triangles among points (n, 2).

    Names of the same point are joined into one.
    """
    artists: list[Artist] = []
    for numbers, letter, marker in ((walk.hit, "H", "s"), (walk.leave, "L", "^")):
        names: dict[tuple[float, float], list[str]] = {}
        for count, i in enumerate(numbers, start=1):
            if i < shown:
                names.setdefault((points[i, 0], points[i, 1]), []).append(f"{letter}{count}")
        look: Style = {"color": palette.CONTACT, "markersize": 8, **palette.RIM}
        for at, labels in names.items():
            artists += ax.plot(*at, marker, zorder=7, **look)
            right, up = (True, True) if above else roomiest_side(at, points, ax)
            artists.append(name_mark(", ".join(labels), at, ax, right=right, up=up))
    return artists


def roomiest_side(at: tuple[float, float], points: Array, ax: Axes) -> tuple[bool, bool]:
    """Whether a name beside a mark should be to the right and above: farthest from the walk."""
    low, high = zip(ax.get_xlim(), ax.get_ylim())
    size = 0.05 * abs(high[0] - low[0])
    legs = [a + np.linspace(0, 1, 20)[:, None] * (b - a) for a, b in pairwise(points)]
    even = np.concatenate([points, *legs])

    def room(side: tuple[bool, bool]) -> float:
        x, y = at[0] + (1.4 if side[0] else -1.4) * size, at[1] + (size if side[1] else -size)
        inside = low[0] < x < high[0] and low[1] < y < high[1]
        return float(((even - (x, y)) ** 2).sum(axis=1).min()) if inside else 0.0

    return max(((True, True), (True, False), (False, True), (False, False)), key=room)


def name_mark(text: str, at: tuple[float, float], ax: Axes, *, right: bool, up: bool) -> Artist:
    """Write a name beside a mark."""
    beside: Style = {
        "xytext": (7 if right else -7, 7 if up else -7),
        "textcoords": "offset points",
        "ha": "left" if right else "right",
        "va": "bottom" if up else "top",
    }
    style: Style = {"fontsize": palette.TEXT_SIZE - 1, "fontweight": "bold", "path_effects": HALO}
    return ax.annotate(text, at, color=palette.CONTACT, zorder=8, **beside, **style)
