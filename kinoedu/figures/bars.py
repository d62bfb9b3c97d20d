"""Bars with rounded ends, such as the links of an arm."""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Polygon

from ..geometry.checks import Array
from .palette import Style

ROUND = np.linspace(-np.pi / 2.0, np.pi / 2.0, 25)


def draw_bar(
    a: Array, b: Array, radius: float, ax: Axes, colour: str, *, alpha: float, zorder: float
) -> list[Artist]:
    """Draw the points within a radius of the segment a-b; a line for radius 0."""
    if radius == 0.0:
        style: Style = {"color": colour, "alpha": max(2.0 * alpha, 0.3), "linewidth": 2.5}
        return list(ax.plot([a[0], b[0]], [a[1], b[1]], zorder=zorder, **style))
    face = (*tuple(int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)), alpha)
    edge = (*face[:3], min(1.0, 2.5 * alpha))
    look: Style = {"facecolor": face, "edgecolor": edge, "linewidth": 1.2}
    return [ax.add_patch(Polygon(bar_outline(a, b, radius), zorder=zorder, **look))]


def bar_outline(a: Array, b: Array, radius: float) -> Array:
    """The outline of a bar, shape (50, 2): half a circle about each end."""
    heading = np.arctan2(b[1] - a[1], b[0] - a[0])
    halves = ((b, heading + ROUND), (a, heading + (ROUND + np.pi)))
    ends = [p + radius * np.stack([np.cos(t), np.sin(t)], axis=1) for p, t in halves]
    return np.vstack(ends)
