"""Moving obstacles: the world at a moment with the robot, and a straight path against time."""

from __future__ import annotations

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.patches import Polygon
from numpy.typing import ArrayLike

from ..collision.collision_intervals import find_safe_intervals, relative_obstacles
from ..geometry.checks import Array
from ..problems.in_time import TimedProblemRecord
from ..worlds.moving import MovingWorldRecord, movers_at
from . import palette
from .drawing import ENDS, axes_for, draw_end, draw_path, draw_robot, draw_world
from .names import NOWHERE, move_names_off_points, spread
from .palette import Style
from .plane import arrow

ROUND = np.linspace(0.0, 2.0 * np.pi, 25)[:-1]
SOON = 1e-3  # the time step that gives an obstacle's velocity
COLUMNS = 400  # places along a segment


def outline_of(points: Array, radius: float) -> Array:
    """The outline of a moving obstacle, shape (k, 2): a disc's as a polygon of 24 corners."""
    if radius == 0.0:
        return points
    return points[0] + radius * np.column_stack([np.cos(ROUND), np.sin(ROUND)])


def place_on(path: Array, t: float) -> Array:
    """The position (2,) of a robot at a time on a path (m, 3) of rows (x, y, t).

    Before and after the path it is at its ends.
    """
    return np.array([np.interp(t, path[:, 2], path[:, axis]) for axis in (0, 1)])


def outlines_at(world: MovingWorldRecord, t: float) -> list[Array]:
    """The outlines of all moving obstacles at a time."""
    return [outline_of(points, radius) for points, radius in movers_at(world, t)]


def draw_movers(world: MovingWorldRecord, t: float, ax: Axes) -> list[Artist]:
    """Draw the moving obstacles at a time, with an arrow for the motion in a unit of time."""
    drawn: list[Artist] = []
    for (points, radius), (later, _) in zip(movers_at(world, t), movers_at(world, t + SOON)):
        shape = outline_of(points, radius)
        look: Style = {"facecolor": palette.OBSTACLE, "edgecolor": palette.INK, "hatch": "//"}
        drawn.append(ax.add_patch(Polygon(shape, zorder=2, **look)))
        (x, y), (u, v) = shape.mean(axis=0), (later[0] - points[0]) / SOON
        if u or v:
            drawn += arrow((x, y), (u, v), "", ax, colour=palette.HIT)
    return drawn


def draw_moment(
    problem: TimedProblemRecord, t: float, ax: Axes | None = None, *, path: Array | None = None
) -> list[Artist]:
    """Draw the world at a time: static and moving obstacles, start and goal, and the robot.

    path : (m, 3), rows (x, y, t); the robot is drawn on it, with the part behind it.

    Examples
    --------
    >>> from kinoedu import Disk, PolygonWorld
    >>> from kinoedu.problems.in_time import TimedProblem
    >>> from kinoedu.worlds import Moving, MovingWorld
    >>> from matplotlib import pyplot as plt
    >>> hall = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    >>> world = MovingWorld(hall, [Moving(1.0, [0, 10], [(9, 3), (-1, 3)])])
    >>> problem = TimedProblem(Disk(0.5), world, start=(1, 3), goal=(9, 3))
    >>> artists = draw_moment(problem, 2.0, plt.gca())
    >>> plt.close()
    """
    ax = axes_for(problem.world, ax)
    drawn = draw_world(problem.world.still, ax) + draw_movers(problem.world, t, ax)
    for q, look in zip((problem.start, problem.goal), ENDS, strict=True):
        drawn += draw_end(q, *look, problem.world, ax)
    lines = [np.vstack([rim, rim[0]]) for rim in outlines_at(problem.world, t)]  # under no name
    if path is not None:
        here = place_on(path, t)
        lines.append(np.vstack([path[path[:, 2] < t, :2], here]))
        drawn += draw_path(lines[-1], ax)
        drawn += draw_robot(problem.robot, here, ax)
        dot: Style = {"color": palette.ROBOT, "markeredgecolor": palette.INK, "markersize": 7}
        drawn += ax.plot(*here, "o", zorder=8, **dot)
    move_names_off_points(np.vstack([NOWHERE, *map(spread, lines)]), ax)
    return drawn


def draw_against_time(
    problem: TimedProblemRecord, a: ArrayLike, b: ArrayLike, ax: Axes, *, until: float
) -> list[Artist]:
    """Draw the safe intervals of the places from a to b, with time upwards.

    Each column is a place; its white part are the safe intervals, its grey part is hit by a moving
    obstacle. Motions go upwards, no flatter than the dotted line, which is the robot's speed.
    """
    begin, end = np.asarray(a, float), np.asarray(b, float)
    far = float(np.hypot(*(end - begin)))
    along = np.linspace(0.0, far, COLUMNS)
    world, places = problem.world, begin + np.outer(along / far, end - begin)
    hulls, knots = relative_obstacles(problem.robot, world, problem.clearance)
    safe, first = find_safe_intervals(hulls, knots, world.times, world.places, float(until), places)
    column, half = np.repeat(along, np.diff(first)), 0.51 * far / (COLUMNS - 1)
    x0, x1 = column - half, column + half
    from_, to = safe.T
    corners = ((x0, from_), (x1, from_), (x1, to), (x0, to))
    boxes = np.stack([np.column_stack(corner) for corner in corners], axis=1)
    ax.set(xlim=(0.0, far), ylim=(0.0, until), facecolor=palette.OBSTACLE)
    free = PolyCollection(list(boxes), facecolors=palette.FREE, edgecolors="none", zorder=1)
    fastest = [[(0.0, 0.0), (far, far / problem.speed)]]
    dotted: Style = {"colors": palette.PATH, "linestyles": ":", "linewidths": 2.0}
    slope = LineCollection(fastest, zorder=3, **dotted)
    artists: list[Artist] = [ax.add_collection(free), ax.add_collection(slope)]
    ax.set_xlabel("way from start to goal", **palette.TEXT)
    ax.set_ylabel("time", **palette.TEXT)
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return artists
