"""Headings at a place, and the configurations that stand in vertical cells."""

from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Arc
from numpy.typing import ArrayLike

from ..collision import free_configurations, free_headings
from ..geometry.checks import as_point
from ..words import say
from . import palette
from .drawing import axes_for, draw_problem, draw_world
from .plane import title
from .robots import draw_robot


def draw_headings(
    robot: Any, world: Any, point: ArrayLike, ax: Axes | None = None, *, tried: ArrayLike = ()
) -> list[Artist]:
    """Draw a robot that turns at a place: a ring whose thick green arcs are the free headings, and
    headings that are tried.

    tried : (k,) headings; each is a mark on the ring, full where the robot is free at it and a
        cross where it is in contact.
    """
    place, ax = as_point(point), axes_for(world, ax)
    reach = 1.15 * np.hypot(*robot.outline.T).max()
    rows = free_headings(robot, world, place)
    artists = draw_world(world, ax)
    for colour, width, arcs in (
        (palette.CONTACT, 1.5, [(-np.pi, np.pi)]),
        (palette.START, 7.0, rows),
    ):
        for low, high in np.degrees(np.array(arcs).reshape(-1, 2)):
            ring = Arc(
                (place[0], place[1]),
                2 * reach,
                2 * reach,
                theta1=low,
                theta2=high,
                color=colour,
                linewidth=width,
                zorder=7,
            )
            artists.append(ax.add_patch(ring))
    for low, high in rows:
        artists += draw_robot(robot, np.array([*place, (low + high) / 2]), ax)
    artists += mark_tried(robot, world, place, reach, np.atleast_1d(np.asarray(tried, float)), ax)
    lines = [
        Line2D([], [], color=palette.START, linewidth=7),
        Line2D([], [], color=palette.CONTACT, linewidth=1.5),
    ]
    names = [say("headings.free"), say("headings.contact")]
    artists.append(
        ax.legend(lines, names, fontsize=palette.TEXT_SIZE - 1, loc="lower left", framealpha=0.9)
    )
    return artists


def mark_tried(
    robot: Any, world: Any, place: Any, reach: float, tried: Any, ax: Axes
) -> list[Artist]:
    """Marks on the ring for headings that are tried."""
    free = free_configurations(
        robot, world, np.column_stack([np.tile(place, (len(tried), 1)), tried])
    )
    at = place + reach * np.column_stack([np.cos(tried), np.sin(tried)])
    full = ax.plot(
        *at[free].T, "o", color=palette.START, markersize=9, markeredgecolor="white", zorder=8
    )
    crosses = ax.plot(
        *at[~free].T, "X", color=palette.GOAL, markersize=9, markeredgecolor="white", zorder=8
    )
    return [*full, *crosses]


def draw_cells_with_headings(
    problem: Any, roadmap: Any, ax: Axes | None = None, *, edges: bool = True
) -> list[Artist]:
    """Draw the configurations of `cells_with_headings`, an X where no heading is free, and the free
    motions between them.
    """
    ax = axes_for(problem.world, ax)
    artists = draw_problem(problem, ax)
    if edges:
        lines = list(roadmap.nodes[roadmap.edges][:, :, :2])
        artists.append(
            ax.add_collection(
                LineCollection(lines, colors=palette.ROADMAP, linewidths=0.5, alpha=0.5, zorder=2),
                autolim=False,
            )
        )
    bodies = [body for q in roadmap.nodes[2:] for body in draw_robot(problem.robot, q, ax)]
    for body in bodies:
        body.set(facecolor="none", linewidth=1.0)  # many lie on top of each other
    artists += ax.plot(
        *roadmap.empty.T, "X", color=palette.GOAL, markersize=9, markeredgecolor="white", zorder=8
    )
    words = say(
        "headings.counts",
        nodes=len(roadmap.nodes) - 2,
        empty=len(roadmap.empty),
        edges=len(roadmap.edges),
    )
    return [*artists, *bodies, title(words, ax)]
