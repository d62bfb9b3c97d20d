"""What holds at every place of the plane: how far a polygon is, which way round it, on which side
of a line.
"""

from collections.abc import Callable

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from numpy.typing import ArrayLike

from ..geometry import point_polygon_distance, polygon_tangent
from . import palette, plane


def draw_distance_levels(polygon: ArrayLike, levels: ArrayLike, ax: Axes) -> list[Artist]:
    """The curves of all places that are so far from a polygon, each with its distance; what the
    axes show is filled.
    """
    (x0, x1), (y0, y1) = ax.get_xlim(), ax.get_ylim()
    x, y = np.meshgrid(np.linspace(x0, x1, 241), np.linspace(y0, y1, 161))
    distance = point_polygon_distance(np.column_stack([x.ravel(), y.ravel()]), polygon)
    curves = ax.contour(
        x,
        y,
        np.reshape(distance, x.shape),
        levels=levels,
        colors=palette.TREE,
        linewidths=1.8,
        zorder=1.5,
    )
    return [
        curves,
        *ax.clabel(curves, fontsize=palette.TEXT_SIZE, fmt="%g"),
        *plane.polygon(polygon, ax),
    ]


def draw_tangents(polygon: ArrayLike, spacing: float, ax: Axes) -> list[Artist]:
    """The tangent vector at places in a grid, outside a polygon."""
    (x0, x1), (y0, y1) = ax.get_xlim(), ax.get_ylim()
    x, y = np.meshgrid(
        np.arange(x0 + spacing / 2, x1, spacing), np.arange(y0 + spacing / 2, y1, spacing)
    )
    places = np.column_stack([x.ravel(), y.ravel()])
    outside = places[np.asarray(point_polygon_distance(places, polygon)) > 0.2 * spacing]
    vectors = np.array([polygon_tangent(q, polygon) for q in outside])
    arrows = ax.quiver(
        *outside.T, *vectors.T, color=palette.TREE, angles="xy", pivot="mid", width=0.004, zorder=3
    )
    return [arrows, *plane.polygon(polygon, ax)]


def draw_sides(
    side: Callable[[tuple[float, float]], float],
    corner: tuple[float, float],
    step: float,
    n: int,
    ax: Axes,
) -> list[Artist]:
    """Which sign `side` gives to n x n places, `step` apart from a corner: 1 left, 0 on the line,
    -1 right.
    """
    signs = np.array(
        [
            [np.sign(side((corner[0] + i * step, corner[1] + j * step))) for i in range(n)]
            for j in range(n)
        ]
    )
    colours = ListedColormap([palette.GOAL, "#FFFFFF", palette.TREE])
    image = ax.imshow(signs, origin="lower", cmap=colours, vmin=-1, vmax=1, interpolation="nearest")
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return [image]
