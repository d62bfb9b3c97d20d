"""Obstacles that move: the world at a moment with the robot on its way, and a straight way against
time.
"""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import Polygon
from numpy.typing import ArrayLike

from ..collision.departures import all_safe_intervals, seen_from_movers
from ..geometry.checks import Array
from ..problems.in_time import TimedProblemRecord
from ..worlds.moving import MovingWorldRecord, movers_at
from . import palette
from .drawing import axes_for, draw_path, draw_robot, draw_world, label_beside
from .plane import arrow

ROUND = np.linspace(0.0, 2.0 * np.pi, 25)[:-1]
SOON = 1e-3  # how far ahead one looks to see where something is going
COLUMNS = 400  # places along a way


def outline_of(points: Array, radius: float) -> Array:
    """The outline of a mover, shape (k, 2): a disc's as a polygon of 24 corners."""
    return (
        points
        if radius == 0.0
        else points[0] + radius * np.column_stack([np.cos(ROUND), np.sin(ROUND)])
    )


def place_on(path: Array, t: float) -> Array:
    """Where a robot is at a time that goes along a path (m, 3) of rows (x, y, t); at its ends
    before and after it. Shape (2,).
    """
    return np.array([np.interp(t, path[:, 2], path[:, axis]) for axis in (0, 1)])


def draw_movers(world: MovingWorldRecord, t: float, ax: Axes) -> list[Artist]:
    """What moves, where it is at a time, with an arrow as far as it goes in a unit of time; none
    where it rests.
    """
    drawn: list[Artist] = []
    for (points, radius), (later, _) in zip(movers_at(world, t), movers_at(world, t + SOON)):
        shape = outline_of(points, radius)
        drawn.append(
            ax.add_patch(
                Polygon(
                    shape, facecolor=palette.OBSTACLE, edgecolor=palette.INK, hatch="//", zorder=2
                )
            )
        )
        (x, y), (u, v) = shape.mean(axis=0), (later[0] - points[0]) / SOON
        if u or v:
            drawn += arrow((x, y), (u, v), "", ax, colour=palette.HIT)
    return drawn


def draw_moment(
    problem: TimedProblemRecord, t: float, ax: Axes | None = None, *, path: Array | None = None
) -> list[Artist]:
    """The world at a time: what stands, what moves, start and goal; and on a path (m, 3) the robot,
    with the way behind it.

    >>> from kinoedu import Disk, PolygonWorld
    >>> from kinoedu.problems.in_time import TimedProblem
    >>> from kinoedu.worlds import Moving, MovingWorld
    >>> from matplotlib import pyplot as plt
    >>> hall = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    >>> world = MovingWorld(hall, [Moving(1.0, [0, 10], [(9, 3), (-1, 3)])])
    >>> artists = draw_moment(TimedProblem(Disk(0.5), world, start=(1, 3), goal=(9, 3)), 2.0, plt.gca())
    >>> plt.close()
    """
    ax = axes_for(problem.world, ax)
    drawn = draw_world(problem.world.still, ax) + draw_movers(problem.world, t, ax)
    for q, name, colour, marker in (
        (problem.start, "start", palette.START, "o"),
        (problem.goal, "goal", palette.GOAL, "*"),
    ):
        size = 9 if marker == "o" else 15
        drawn += ax.plot(
            *q,
            marker,
            color=colour,
            markersize=size,
            markeredgecolor="white",
            markeredgewidth=1.2,
            zorder=7,
        )
        drawn.append(label_beside(q, name, colour, problem.world, ax))
    if path is not None:
        here = place_on(path, t)
        drawn += draw_path(np.vstack([path[path[:, 2] < t, :2], here]), ax) + draw_robot(
            problem.robot, here, ax
        )
        drawn += ax.plot(
            *here, "o", color=palette.ROBOT, markersize=7, markeredgecolor=palette.INK, zorder=8
        )
    return drawn


def draw_against_time(
    problem: TimedProblemRecord, a: ArrayLike, b: ArrayLike, ax: Axes, *, until: float
) -> list[Artist]:
    """The places of the segment from a to b, left to right, against the time, upwards: grey is met
    by something that moves.

    Each column is a place, and what is white of it its safe intervals. Motions go upwards, no
    flatter than the dotted line, which is the robot's speed.
    """
    begin, end = np.asarray(a, float), np.asarray(b, float)
    far = float(np.hypot(*(end - begin)))
    along = np.linspace(0.0, far, COLUMNS)
    world, places = problem.world, begin + np.outer(along / far, end - begin)
    hulls, knots = seen_from_movers(problem.robot, world, problem.clearance)
    safe, first = all_safe_intervals(hulls, knots, world.times, world.places, float(until), places)
    column, half = np.repeat(along, np.diff(first)), 0.51 * far / (COLUMNS - 1)
    x0, x1 = column - half, column + half
    boxes = np.stack(
        [
            np.column_stack(c)
            for c in ((x0, safe[:, 0]), (x1, safe[:, 0]), (x1, safe[:, 1]), (x0, safe[:, 1]))
        ],
        axis=1,
    )
    ax.set(xlim=(0.0, far), ylim=(0.0, until), facecolor=palette.OBSTACLE)
    free = ax.add_collection(
        PolyCollection(list(boxes), facecolors=palette.FREE, edgecolors="none", zorder=1)
    )
    fastest = [[(0.0, 0.0), (far, far / problem.speed)]]
    slope = ax.add_collection(
        LineCollection(fastest, colors=palette.START, linestyles=":", linewidths=2.0, zorder=3)
    )
    ax.set_xlabel("way from start to goal", fontsize=palette.TEXT_SIZE)
    ax.set_ylabel("time", fontsize=palette.TEXT_SIZE)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return [free, slope]
