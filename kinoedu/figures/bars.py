"""Bars with rounded ends, such as the links of an arm."""

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Polygon

from ..geometry.bars import bar_outline
from ..geometry.checks import Array
from .palette import Style


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
