"""Figures of configurations: angles, reach, linkages, and shortest paths on circle and torus.

Bullo & Smith, chapter 3.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Annulus, Circle
from numpy.typing import ArrayLike

from ..geometry.checks import Array
from ..robots.arm import ArmRobot
from ..spaces import Torus, interpolate
from . import palette
from .palette import Style
from .plane import TOUCHING, label
from .solid import TORUS, draw_mesh, torus_mesh

PIECES = 240  # the segments that draw a path on the torus


def draw_turn(
    centre: ArrayLike,
    start: float,
    turn: float,
    radius: float,
    text: str,
    ax: Axes,
    *,
    colour: str,
    style: str = "-",
) -> list[Artist]:
    """Draw an angle: an arc from a direction through `turn` radians, an arrow head, and words."""
    angles = start + turn * np.linspace(0.0, 1.0, 2 + int(20 * min(abs(turn), 40.0)))
    arc = np.asarray(centre, float) + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    artists: list[Artist] = [*ax.plot(*arc.T, style, color=colour, linewidth=2.6, zorder=5)]
    if turn != 0.0:
        head = {"arrowstyle": "-|>", "color": colour, "lw": 0.0, "mutation_scale": 18, **TOUCHING}
        artists.append(ax.annotate("", arc[-1], xytext=arc[-2], arrowprops=head, zorder=6))
    if not text:
        return artists
    x, y = np.cos(start + turn / 2), np.sin(start + turn / 2)
    ha = "left" if x > 0.35 else "right" if x < -0.35 else "center"
    offset = (8 * x, 12 * y - 5)
    return [*artists, label(arc[len(arc) // 2], text, ax, colour=colour, offset=offset, ha=ha)]


def draw_reach(arm: ArmRobot, ax: Axes) -> list[Artist]:
    """Draw the region that the tip of a two-link arm reaches, between two circles."""
    l1, l2 = arm.lengths
    inner, outer = abs(l1 - l2), l1 + l2
    base = (float(arm.base[0]), float(arm.base[1]))
    ring: Any = Annulus(base, outer, outer - inner) if inner > 0.0 else Circle(base, outer)
    ring.set(facecolor=palette.CELL, edgecolor=palette.TREE, linewidth=1.5, zorder=1)
    return [ax.add_patch(ring), *ax.plot(*arm.base, "s", color=palette.INK, markersize=9, zorder=7)]


def draw_links(
    places: ArrayLike, text: str, ax: Axes, *, colour: str, style: str = "-"
) -> list[Artist]:
    """Draw an arm without width through base, joints and tip, (n, 2); its words at the elbow."""
    joints = np.asarray(places, float)
    look: Style = {"marker": "o", "color": colour, "linewidth": 3.0, "markersize": 7}
    artists: list[Artist] = [*ax.plot(*joints.T, style, zorder=5, **look)]
    return [*artists, label(joints[1], text, ax, colour=colour)] if text else artists


def draw_linkage(
    pins: ArrayLike,
    bars: Iterable[tuple[int, int]],
    ground: Iterable[int],
    ax: Axes,
    *,
    colour: str = palette.TREE,
    style: str = "-",
) -> list[Artist]:
    """Draw bars between pins, shape (n, 2), by the pins' numbers; pins on the ground are square."""
    at, fixed = np.asarray(pins, float), list(ground)
    artists: list[Artist] = []
    for a, b in bars:
        artists += ax.plot(*at[[a, b]].T, style, color=colour, linewidth=5.0, zorder=4)
    loose: Style = {"color": "white", "markeredgecolor": palette.INK, "markersize": 10}
    artists += ax.plot(*np.delete(at, fixed, axis=0).T, "o", zorder=6, **loose)
    artists += ax.plot(*at[fixed].T, "s", color=palette.INK, markersize=13, zorder=5)
    return artists


def draw_torus_path(
    a: ArrayLike, b: ArrayLike, ax: Axes, *, colour: str = palette.PATH
) -> list[Artist]:
    """Draw the shortest path on the torus from a to b, shapes (2,), on its square.

    It may leave the square at one edge and enter at the opposite one.
    """
    path = sample_torus_path(a, b)
    jumps = np.flatnonzero((np.abs(np.diff(path, axis=0)) > np.pi).any(axis=1)) + 1
    broken = np.insert(path, jumps, np.nan, axis=0)
    return [*ax.plot(*broken.T, "-", color=colour, linewidth=3.5, zorder=4)]


def draw_torus(paths: Iterable[tuple[Array, str]], ax: Any = None) -> list[Artist]:
    """Draw the torus in space, and on it curves of pairs of angles, (n, 2), each in a colour.

    The first angle runs round the ring.
    """
    artists = draw_mesh(torus_mesh(np.zeros((40, 80), int)), ax, axes=False)
    drawn: Any = artists[0].axes
    for angles, colour in paths:
        artists += drawn.plot(*on_torus(angles).T, color=colour, lw=4, zorder=5)
    return artists


def on_torus(q: ArrayLike) -> Array:
    """Points in space of pairs of angles, (2,) or (n, 2), just above the torus of `draw_torus`.

    Returns
    -------
    (3,) or (n, 3) array
    """
    ring, tube = np.moveaxis(np.asarray(q, float), -1, 0)
    far = TORUS[0] + 1.02 * TORUS[1] * np.cos(tube)
    height = 1.02 * TORUS[1] * np.sin(tube)
    return np.stack([far * np.cos(ring), far * np.sin(ring), height], axis=-1)


def sample_torus_path(a: ArrayLike, b: ArrayLike) -> Array:
    """Configurations along the shortest path from a to b, angles wrapped, (PIECES + 1, d)."""
    p, q = np.asarray(a, float), np.asarray(b, float)
    space = Torus(len(p))
    return np.array([interpolate(space, p, q, t) for t in np.linspace(0.0, 1.0, PIECES + 1)])
