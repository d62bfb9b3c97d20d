"""Configuration space as figures: obstacles grown by the robot's shape, and the solid that they are
for a robot that turns.
"""

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
from ..words import say
from ..worlds.polygon_world import PolygonWorldRecord
from . import palette, plane
from .drawing import HALO, axes_for, compound, draw_world
from .solid import draw_mesh

if TYPE_CHECKING:
    from trimesh import Trimesh

GROWN = "#D5D9E0"  # an obstacle's colour, thinned: where the reference point may not be


def draw_c_obstacle(
    robot_vertices: ArrayLike, obstacle: ArrayLike, ax: Axes | None = None, *, ghosts: int = 9
) -> list[Artist]:
    """Draw an obstacle, its C-obstacle for a translating polygon, and the robot in contact at some
    places round it.

    robot_vertices : (n, 2), its reference point at the origin; obstacle : (m, 2); convex or not.
        ghosts : how many placements.
    """
    robot, ring = as_ring(robot_vertices, "robot"), as_ring(obstacle, "obstacle")
    outline = united(translating_obstacles(robot, [ring]))[0]
    places = along(outline, ghosts)
    if ax is None:
        _, ax = plt.subplots(figsize=(7.0, 5.0), dpi=72, layout="constrained")
    plane.frame(np.concatenate([outline, *(robot + q for q in places)]), ax, margin=0.08)
    artists: list[Artist] = [
        ax.add_patch(Polygon(outline, facecolor=GROWN, edgecolor="none", zorder=1))
    ]
    artists += [draw_body(robot + q, ax, alpha=0.22) for q in places]
    artists.append(
        ax.add_patch(
            Polygon(ring, facecolor=palette.OBSTACLE, edgecolor=palette.OBSTACLE, zorder=3)
        )
    )
    artists.append(
        ax.add_patch(
            Polygon(
                outline, fill=False, edgecolor=palette.INK, linestyle="--", linewidth=2.0, zorder=4
            )
        )
    )
    artists += ax.plot(
        *places.T, "o", color=palette.INK, markersize=6, markeredgecolor="white", zorder=5
    )
    artists.append(inside_label(ring, say("c_space.obstacle"), "white", ax))
    artists.append(inside_label(robot + places[0], say("c_space.robot"), palette.INK, ax))
    artists.append(corner_label(outline, say("c_space.c_obstacle"), palette.INK, ax))
    return [*artists, plane.title(say("c_space.sliding"), ax)]


def draw_grown(
    radius: float, world: PolygonWorldRecord, ax: Axes | None = None, *, ghosts: int = 5
) -> list[Artist]:
    """Draw a world, where a disk's centre may be in it, and the disk in contact at some places."""
    ax = axes_for(world, ax)
    regions = free_regions(radius, world, tolerance=1e-2 * radius)
    artists = draw_world(world, ax)
    for artist in artists:
        artist.set_zorder(2)
    ax.set_facecolor(GROWN)
    for rings in regions:
        style: Any = {"edgecolor": palette.INK, "linestyle": "--", "linewidth": 1.8}
        artists.append(
            ax.add_patch(PathPatch(compound(rings), facecolor=palette.FREE, zorder=1, **style))
        )
    outline = max((rings[0] for rings in regions), key=len, default=np.empty((0, 2)))
    for x, y in along(outline, ghosts) if len(outline) else []:
        artists.append(
            ax.add_patch(
                Circle(
                    (x, y),
                    radius,
                    facecolor=palette.ROBOT,
                    alpha=0.35,
                    edgecolor=palette.ROBOT,
                    zorder=3,
                )
            )
        )
        artists += ax.plot(
            x, y, "o", color=palette.INK, markersize=6, markeredgecolor="white", zorder=5
        )
    unit = say("c_space.region") if len(regions) == 1 else say("c_space.regions")
    count = f"{len(regions)} {unit}"
    return [*artists, plane.title(say("c_space.grown", radius=f"{radius:g}", count=count), ax)]


def draw_turning_obstacle(
    robot_vertices: ArrayLike,
    obstacle: ArrayLike,
    theta: float,
    *,
    mesh: "Trimesh | None" = None,
    at: ArrayLike | None = None,
) -> list[Artist]:
    """Draw the C-obstacle of a polygon that turns: on the left the solid, cut at theta; on the
    right that cut, and the robot there.

    mesh : what `turning_obstacle` gave for the two, made anew where left out. at : where the
        reference point is, (2,), on the cut's outline where left out. Only the pictures are linked:
        the plane on the left is the page on the right.
    """
    robot, ring = turned(robot_vertices, theta), as_ring(obstacle, "obstacle")
    figure = plt.figure(figsize=(11.0, 5.0), dpi=72, layout="constrained")
    artists = draw_mesh(
        turning_obstacle(robot_vertices, obstacle) if mesh is None else mesh,
        theta=theta,
        ax=left_panel(figure),
    )
    figure.axes[0].set_title(say("c_space.solid"), fontsize=palette.TEXT_SIZE + 1)
    return artists + draw_slice(robot, ring, theta, figure.add_subplot(1, 2, 2), at=at)


def left_panel(figure: Any) -> Any:
    """The axes of a solid, on the left of two."""
    return figure.add_subplot(1, 2, 1, projection="3d")


def draw_slice(
    robot: Array, ring: Array, theta: float, ax: Axes, *, at: ArrayLike | None = None
) -> list[Artist]:
    """Draw the workspace at one heading: the obstacle, the slice of the C-obstacle, and the turned
    robot.
    """
    outlines = united(translating_obstacles(robot, [ring]))
    q = along(outlines[0], 8)[5] if at is None else np.asarray(at, float)
    plane.frame(np.concatenate([*outlines, robot + q]), ax, margin=0.12)
    artists: list[Artist] = [
        ax.add_patch(Polygon(outline, facecolor=GROWN, edgecolor="none", zorder=1))
        for outline in outlines
    ]
    artists += [
        ax.add_patch(Polygon(outline, fill=False, edgecolor=palette.GOAL, linewidth=2.5, zorder=4))
        for outline in outlines
    ]
    artists.append(
        ax.add_patch(
            Polygon(ring, facecolor=palette.OBSTACLE, edgecolor=palette.OBSTACLE, zorder=2)
        )
    )
    artists.append(draw_body(robot + q, ax, alpha=0.5))
    artists += ax.plot(*q, "o", color=palette.INK, markersize=7, markeredgecolor="white", zorder=6)
    artists.append(inside_label(ring, say("c_space.obstacle"), "white", ax))
    artists.append(inside_label(robot + q, say("c_space.robot"), palette.INK, ax))
    artists.append(corner_label(outlines[0], say("c_space.c_obstacle"), palette.GOAL, ax))
    return [*artists, plane.title(say("c_space.turning", theta=f"{np.degrees(theta):.0f}"), ax)]


def draw_body(body: Array, ax: Axes, *, alpha: float) -> Artist:
    """A robot's body where it is, (n, 2)."""
    patch = Polygon(body, facecolor=palette.ROBOT, alpha=alpha, edgecolor="none", zorder=2.5)
    ax.add_patch(Polygon(body, fill=False, edgecolor=palette.ROBOT, linewidth=1.6, zorder=3.5))
    return ax.add_patch(patch)


def inside_label(ring: Array, words: str, colour: str, ax: Axes) -> Artist:
    """Words in the middle of a shape, where it has most room."""
    import shapely

    x, y = shapely.get_coordinates(shapely.maximum_inscribed_circle(shapely.Polygon(ring)))[0]
    halo = (
        [patheffects.withStroke(linewidth=3.5, foreground=palette.OBSTACLE)]
        if colour == "white"
        else HALO
    )
    style: Any = {
        "ha": "center",
        "va": "center",
        "fontsize": palette.TEXT_SIZE,
        "fontweight": "bold",
        "path_effects": halo,
    }
    return ax.text(x, y, words, color=colour, zorder=9, **style)


def united(parts: list[Array]) -> list[Array]:
    """The outlines of what polygons cover together, the longest first; holes are left out."""
    import shapely

    whole = shapely.get_parts(shapely.union_all([shapely.Polygon(part) for part in parts]))
    return sorted(
        (shapely.get_coordinates(part.exterior)[:-1] for part in whole), key=len, reverse=True
    )


def along(ring: Array, count: int) -> Array:
    """Places round a ring, evenly spread, (count, 2)."""
    import shapely

    line = shapely.LinearRing(ring)
    return shapely.get_coordinates(
        shapely.line_interpolate_point(line, (np.arange(count) + 0.5) / count, normalized=True)
    )


def corner_label(ring: Array, words: str, colour: str, ax: Axes) -> Artist:
    """Words in the axes' upper right corner, with a line to the ring's vertex that is nearest to
    it.
    """
    x, y = ring[int((ring[:, 0] + ring[:, 1]).argmax())]
    style: Any = {
        "ha": "right",
        "va": "top",
        "fontsize": palette.TEXT_SIZE,
        "fontweight": "bold",
        "path_effects": HALO,
    }
    line = {"arrowstyle": "-", "color": colour, "linewidth": 1.2, "shrinkB": 2.0}
    corner: Any = {"xytext": (0.985, 0.975), "textcoords": "axes fraction", "arrowprops": line}
    return ax.annotate(words, (x, y), color=colour, zorder=9, **corner, **style)
