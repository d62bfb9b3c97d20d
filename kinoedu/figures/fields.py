"""Functions of the plane: distance to a polygon, tangent vectors, and sides of a line."""

from collections.abc import Callable

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from numpy.typing import ArrayLike

from ..geometry import point_polygon_distance, polygon_tangent
from . import palette, plane


def draw_distance_levels(polygon: ArrayLike, levels: ArrayLike, ax: Axes) -> list[Artist]:
    """Draw the curves of equal distance to a polygon, each with its distance.

    The curves fill the present limits of the axes.
    """
    (x0, x1), (y0, y1) = ax.get_xlim(), ax.get_ylim()
    x, y = np.meshgrid(np.linspace(x0, x1, 241), np.linspace(y0, y1, 161))
    distance = point_polygon_distance(np.column_stack([x.ravel(), y.ravel()]), polygon)
    look: palette.Style = {"colors": palette.TREE, "linewidths": 1.8, "zorder": 1.5}
    curves = ax.contour(x, y, np.reshape(distance, x.shape), levels=levels, **look)
    numbers = ax.clabel(curves, fmt="%g", **palette.TEXT)
    return [curves, *numbers, *plane.polygon(polygon, ax, numbers=False)]


def draw_tangents(polygon: ArrayLike, spacing: float, ax: Axes) -> list[Artist]:
    """Draw the tangent vector at the points of a grid outside a polygon."""
    (x0, x1), (y0, y1) = ax.get_xlim(), ax.get_ylim()
    x, y = np.meshgrid(
        np.arange(x0 + spacing / 2, x1, spacing), np.arange(y0 + spacing / 2, y1, spacing)
    )
    places = np.column_stack([x.ravel(), y.ravel()])
    outside = places[np.asarray(point_polygon_distance(places, polygon)) > 0.2 * spacing]
    vectors = np.array([polygon_tangent(q, polygon) for q in outside])
    look: palette.Style = {"color": palette.TREE, "angles": "xy", "pivot": "mid", "width": 0.004}
    arrows = ax.quiver(*outside.T, *vectors.T, zorder=3, **look)
    return [arrows, *plane.polygon(polygon, ax)]


def draw_sides(
    side: Callable[[tuple[float, float]], float],
    corner: tuple[float, float],
    spacing: float,
    n: int,
    ax: Axes,
) -> list[Artist]:
    """Draw the sign of `side` at n x n places, `spacing` apart from a corner.

    1 is left, 0 on the line, -1 right.
    """
    places = [
        [(corner[0] + i * spacing, corner[1] + j * spacing) for i in range(n)] for j in range(n)
    ]
    signs = np.array([[np.sign(side(q)) for q in row] for row in places])
    colours = ListedColormap([palette.RIGHT, palette.FREE, palette.LEFT])
    image = ax.imshow(signs, origin="lower", cmap=colours, vmin=-1, vmax=1, interpolation="nearest")
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return [image]
