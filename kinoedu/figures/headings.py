"""Free headings at a place, and the configurations in vertical cells."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Arc
from numpy.typing import ArrayLike

from ..collision import free_configurations, free_headings
from ..geometry.checks import Array, as_point
from ..messages import get_message
from ..robots.polygon import RigidPolygonRobot
from ..worlds.checks import World
from . import palette
from .drawing import axes_for, draw_problem, draw_world
from .palette import Style
from .plane import title
from .robots import draw_robot

MARK: Style = {"markersize": 9, "zorder": 8, **palette.RIM}


def draw_headings(
    robot: RigidPolygonRobot,
    world: World,
    point: ArrayLike,
    ax: Axes | None = None,
    *,
    tried: ArrayLike = (),
) -> list[Artist]:
    """Draw a robot that turns at a place, and a ring whose thick green arcs are free headings.

    tried : (k,) headings; each is a mark on the ring, a disk where the robot is free at it and a
        cross where it is in contact.
    """
    place, ax = as_point(point), axes_for(world, ax)
    reach = 1.15 * np.hypot(*robot.outline.T).max()
    rows = free_headings(robot, world, place)
    artists = draw_world(world, ax)
    thin: Style = {"color": palette.CONTACT, "linewidth": 1.5}
    thick: Style = {"color": palette.CLEAR, "linewidth": 7}
    size = 2 * reach
    for look, arcs in ((thin, [(-np.pi, np.pi)]), (thick, rows)):
        for low, high in np.degrees(np.array(arcs).reshape(-1, 2)):
            at = (place[0], place[1])
            ring = Arc(at, size, size, theta1=low, theta2=high, zorder=7, **look)
            artists.append(ax.add_patch(ring))
    for low, high in rows:
        artists += draw_robot(robot, np.array([*place, (low + high) / 2]), ax)
    artists += mark_tried(robot, world, place, reach, np.atleast_1d(np.asarray(tried, float)), ax)
    lines = [Line2D([], [], **look) for look in (thick, thin)]
    names = [get_message("headings.free"), get_message("headings.contact")]
    box: Style = {"fontsize": palette.TEXT_SIZE - 1, "loc": "lower left", "framealpha": 0.9}
    return [*artists, ax.legend(lines, names, **box)]


def mark_tried(
    robot: RigidPolygonRobot, world: World, place: Array, reach: float, tried: Array, ax: Axes
) -> list[Artist]:
    """Draw marks on the ring for the headings tried."""
    poses = np.column_stack([np.tile(place, (len(tried), 1)), tried])
    free = free_configurations(robot, world, poses)
    at = place + reach * np.column_stack([np.cos(tried), np.sin(tried)])
    disks = ax.plot(*at[free].T, "o", color=palette.CLEAR, **MARK)
    return [*disks, *ax.plot(*at[~free].T, "X", color=palette.HIT, **MARK)]


def draw_cells_with_headings(
    problem: Any, roadmap: Any, ax: Axes | None = None, *, edges: bool = True
) -> list[Artist]:
    """Draw the configurations of `cells_with_headings` and the free motions.

    An X marks a place where no heading is free.
    """
    ax = axes_for(problem.world, ax)
    artists = draw_problem(problem, ax)
    if edges:
        segments = list(roadmap.nodes[roadmap.edges][:, :, :2])
        faint: Style = {"colors": palette.ROADMAP, "linewidths": 0.5, "alpha": 0.5}
        lines = LineCollection(segments, zorder=2, **faint)
        artists.append(ax.add_collection(lines, autolim=False))
    bodies = [body for q in roadmap.nodes[2:] for body in draw_robot(problem.robot, q, ax)]
    for body in bodies:
        body.set(facecolor="none", linewidth=1.0)  # because many overlap
    artists += ax.plot(*roadmap.empty.T, "X", color=palette.HIT, **MARK)
    counts = {"nodes": len(roadmap.nodes) - 2, "edges": len(roadmap.edges)}
    text = get_message("headings.counts", **counts, empty=len(roadmap.empty))
    return [*artists, *bodies, title(text, ax)]
