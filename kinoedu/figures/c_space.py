"""Figures of configuration space: C-obstacles of translating and of turning robots."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib import patheffects
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Circle, PathPatch, Polygon
from numpy.typing import ArrayLike

from ..c_space import free_regions, translating_obstacles, turned, turning_obstacle
from ..geometry.checks import Array
from ..geometry.rings import as_ring
from ..messages import get_message
from ..worlds.polygon_world import PolygonWorldRecord
from . import palette, plane
from .drawing import axes_for, compound, draw_world
from .names import HALO
from .palette import Style
from .solid import draw_mesh

if TYPE_CHECKING:
    from trimesh import Trimesh

SPOT: Style = {"color": palette.INK, "markeredgecolor": "white"}  # a reference point


def draw_c_obstacle(
    robot_vertices: ArrayLike, obstacle: ArrayLike, ax: Axes | None = None, *, ghosts: int = 9
) -> list[Artist]:
    """Draw an obstacle, its C-obstacle for a translating polygon, and the robot in contact.

    Parameters
    ----------
    robot_vertices : (n, 2), with the reference point at the origin; convex or not.
    obstacle : (m, 2), convex or not.
    ghosts : the number of placements of the robot round the obstacle.
    """
    robot, ring = as_ring(robot_vertices, "robot"), as_ring(obstacle, "obstacle")
    outline = unite(translating_obstacles(robot, [ring]))[0]
    places = spread_round(outline, ghosts)
    ax = palette.axes_or_new(ax, (7.0, 5.0))
    plane.frame(np.concatenate([outline, *(robot + q for q in places)]), ax, margin=0.08)
    grown = Polygon(outline, facecolor=palette.GROWN, edgecolor="none", zorder=1)
    artists: list[Artist] = [ax.add_patch(grown)]
    artists += [draw_body(robot + q, ax, alpha=0.22) for q in places]
    artists.append(ax.add_patch(Polygon(ring, zorder=3, **palette.SOLID)))
    dashed: Style = {"edgecolor": palette.INK, "linestyle": "--", "linewidth": 2.0}
    artists.append(ax.add_patch(Polygon(outline, fill=False, zorder=4, **dashed)))
    artists += ax.plot(*places.T, "o", markersize=6, zorder=5, **SPOT)
    artists.append(label_inside(ring, get_message("c_space.obstacle"), "white", ax))
    artists.append(label_inside(robot + places[0], get_message("c_space.robot"), palette.INK, ax))
    artists.append(label_corner(outline, get_message("c_space.c_obstacle"), palette.INK, ax))
    return [*artists, plane.title(get_message("c_space.sliding"), ax)]


def draw_grown(
    radius: float, world: PolygonWorldRecord, ax: Axes | None = None, *, ghosts: int = 5
) -> list[Artist]:
    """Draw a world, the free places of a disk's centre, and the disk in contact at some places."""
    ax = axes_for(world, ax)
    regions = free_regions(radius, world, tolerance=1e-2 * radius)
    artists = draw_world(world, ax)
    for artist in artists:
        artist.set_zorder(2)
    ax.set_facecolor(palette.GROWN)
    dashed: Style = {"edgecolor": palette.INK, "linestyle": "--", "linewidth": 1.8}
    for rings in regions:
        region = PathPatch(compound(rings), facecolor=palette.FREE, zorder=1, **dashed)
        artists.append(ax.add_patch(region))
    outline = max((rings[0] for rings in regions), key=len, default=np.empty((0, 2)))
    for x, y in spread_round(outline, ghosts) if len(outline) else []:
        look: Style = {"facecolor": palette.ROBOT, "edgecolor": palette.ROBOT, "alpha": 0.35}
        artists.append(ax.add_patch(Circle((x, y), radius, zorder=3, **look)))
        artists += ax.plot(x, y, "o", markersize=6, zorder=5, **SPOT)
    unit = get_message("c_space.region") if len(regions) == 1 else get_message("c_space.regions")
    count = f"{len(regions)} {unit}"
    return [
        *artists,
        plane.title(get_message("c_space.grown", radius=f"{radius:g}", count=count), ax),
    ]


def draw_turning_obstacle(
    robot_vertices: ArrayLike,
    obstacle: ArrayLike,
    theta: float,
    *,
    mesh: Trimesh | None = None,
    at: ArrayLike | None = None,
) -> list[Artist]:
    """Draw the C-obstacle of a polygon that turns, cut at theta, and the slice at theta.

    The solid is on the left; its plane at theta is the page on the right.

    Parameters
    ----------
    mesh : the result of `turning_obstacle` for the two; computed if left out.
    at : (2,), the reference point in the slice; by default on the outline of the slice.
    """
    robot, ring = turned(robot_vertices, theta), as_ring(obstacle, "obstacle")
    figure = plt.figure(figsize=(11.0, 5.0), dpi=72, layout="constrained")
    solid = turning_obstacle(robot_vertices, obstacle) if mesh is None else mesh
    artists = draw_mesh(solid, theta=theta, ax=left_panel(figure))
    figure.axes[0].set_title(get_message("c_space.solid"), fontsize=palette.TEXT_SIZE + 1)
    return artists + draw_slice(robot, ring, theta, figure.add_subplot(1, 2, 2), at=at)


def left_panel(figure: Any) -> Any:
    """3-D axes on the left of two."""
    return figure.add_subplot(1, 2, 1, projection="3d")


def draw_slice(
    robot: Array, ring: Array, theta: float, ax: Axes, *, at: ArrayLike | None = None
) -> list[Artist]:
    """Draw the workspace at one heading: obstacle, slice of the C-obstacle, turned robot."""
    outlines = unite(translating_obstacles(robot, [ring]))
    q = spread_round(outlines[0], 8)[5] if at is None else np.asarray(at, float)
    plane.frame(np.concatenate([*outlines, robot + q]), ax, margin=0.12)
    line: Style = {"fill": False, "edgecolor": palette.CUT, "linewidth": 2.5, "zorder": 4}
    look: Style = {"facecolor": palette.GROWN, "edgecolor": "none", "zorder": 1}
    faces = [Polygon(outline, **look) for outline in outlines]
    lines = [Polygon(outline, **line) for outline in outlines]
    solid = Polygon(ring, zorder=2, **palette.SOLID)
    artists: list[Artist] = [ax.add_patch(patch) for patch in (*faces, *lines, solid)]
    artists.append(draw_body(robot + q, ax, alpha=0.5))
    artists += ax.plot(*q, "o", markersize=7, zorder=6, **SPOT)
    artists.append(label_inside(ring, get_message("c_space.obstacle"), "white", ax))
    artists.append(label_inside(robot + q, get_message("c_space.robot"), palette.INK, ax))
    artists.append(label_corner(outlines[0], get_message("c_space.c_obstacle"), palette.CUT, ax))
    return [
        *artists,
        plane.title(get_message("c_space.turning", theta=f"{np.degrees(theta):.0f}"), ax),
    ]


def draw_body(body: Array, ax: Axes, *, alpha: float) -> Artist:
    """Draw a robot's body at its place, (n, 2)."""
    patch = Polygon(body, facecolor=palette.ROBOT, alpha=alpha, edgecolor="none", zorder=2.5)
    ax.add_patch(Polygon(body, fill=False, edgecolor=palette.ROBOT, linewidth=1.6, zorder=3.5))
    return ax.add_patch(patch)


def label_inside(ring: Array, text: str, colour: str, ax: Axes) -> Artist:
    """Write words in a shape, in the middle of its largest inscribed circle."""
    import shapely

    x, y = shapely.get_coordinates(shapely.maximum_inscribed_circle(shapely.Polygon(ring)))[0]
    dark = [patheffects.withStroke(linewidth=3.5, foreground=palette.OBSTACLE)]
    style: Style = {"path_effects": dark if colour == "white" else HALO, **palette.CENTRED}
    return ax.text(x, y, text, color=colour, zorder=9, **style, **palette.BOLD)


def unite(parts: list[Array]) -> list[Array]:
    """The outlines of the union of polygons, the longest first, without holes."""
    import shapely

    union = shapely.union_all([shapely.Polygon(part) for part in parts])
    rings = (shapely.get_coordinates(part.exterior)[:-1] for part in shapely.get_parts(union))
    return sorted(rings, key=len, reverse=True)


def spread_round(ring: Array, count: int) -> Array:
    """Places round a ring, equally spaced, (count, 2)."""
    import shapely

    line, fractions = shapely.LinearRing(ring), (np.arange(count) + 0.5) / count
    points = shapely.line_interpolate_point(line, fractions, normalized=True)
    return shapely.get_coordinates(points)


def label_corner(ring: Array, text: str, colour: str, ax: Axes) -> Artist:
    """Write words in the upper right corner, with a line to the ring's nearest vertex."""
    x, y = ring[int((ring[:, 0] + ring[:, 1]).argmax())]
    style: Style = {"ha": "right", "va": "top", "path_effects": HALO, **palette.BOLD}
    line = {"arrowstyle": "-", "color": colour, "linewidth": 1.2, "shrinkB": 2.0}
    corner: Style = {"xytext": (0.985, 0.975), "textcoords": "axes fraction", "arrowprops": line}
    return ax.annotate(text, (x, y), color=colour, zorder=9, **corner, **style)
