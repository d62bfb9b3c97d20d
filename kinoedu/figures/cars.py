"""Figures of cars: a drive with the car at its ends, and a curve of arcs.

Forward motion is a solid line, backward motion a dashed one.
"""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from ..curves.curve import Curve
from ..geometry.checks import Array
from ..robots.car import CarRobot
from ..robots.trajectory import TrajectoryRecord
from . import palette
from .robots import draw_robot, make_ghost

PIECES = 60  # the points that draw an arc


def draw_drive(
    car: CarRobot, trajectory: TrajectoryRecord, ax: Axes, *, ghosts: int = 0
) -> list[Artist]:
    """Draw a car at both ends of a trajectory, its rear axle's path, and `ghosts` bodies between.

    Examples
    --------
    >>> from kinoedu import Car, Trajectory
    >>> from matplotlib import pyplot as plt
    >>> car = Car(30, 10, 20)
    >>> trajectory = Trajectory(car, (0, 0, 0), [(1, 0.5), (-1, 0)], [30, 20])
    >>> artists = draw_drive(car, trajectory, plt.gca(), ghosts=3)
    >>> plt.close()
    """
    poses = trajectory.poses
    begins = np.concatenate([[0.0], np.cumsum(trajectory.durations)])
    drawn: list[Artist] = []
    for (v, _), begin, end in zip(trajectory.controls, begins, begins[1:]):
        drawn += draw_poses_line(
            trajectory.at(np.linspace(begin, end, PIECES)), v < 0.0, ax, palette.PATH
        )
    for q in trajectory.at(np.linspace(0.0, trajectory.duration, ghosts + 2)[1:-1]):
        drawn.append(ax.add_patch(make_ghost(car, q, zorder=3)))
    drawn += draw_robot(car, poses[0], ax, palette.START)
    drawn += draw_robot(car, poses[-1], ax, palette.GOAL)
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return drawn


def draw_curve(curve: Curve, ax: Axes, *, colour: str = palette.PATH) -> list[Artist]:
    """Draw the pieces of a curve, with a dot where one ends and the next begins."""
    ends = np.concatenate([[0.0], np.cumsum(np.abs(curve.lengths))])
    drawn: list[Artist] = []
    for length, begin, end in zip(curve.lengths, ends, ends[1:]):
        drawn += draw_poses_line(
            curve.at(np.linspace(begin, end, PIECES)), length < 0.0, ax, colour
        )
    joints = curve.at(ends[1:-1])[:, :2]
    return drawn + ax.plot(*joints.T, "o", color=colour, markersize=6, zorder=5, **palette.RIM)


def draw_poses_line(poses: Array, back: bool, ax: Axes, colour: str) -> list[Artist]:
    """Draw the line through poses (k, 3)."""
    style = "--" if back else "-"
    return [*ax.plot(*poses[:, :2].T, style, color=colour, linewidth=2.6, zorder=4)]


def draw_pose(
    pose: ArrayLike, size: float, text: str, ax: Axes, *, colour: str, below: bool = False
) -> list[Artist]:
    """Draw a pose as an arrow of length `size` in its heading, with words above or below."""
    from .plane import arrow, label

    x, y, theta = np.asarray(pose, float)
    drawn = arrow((x, y), (size * np.cos(theta), size * np.sin(theta)), "", ax, colour=colour)
    drawn += ax.plot(x, y, "o", color=colour, markersize=8, zorder=8, **palette.RIM)
    if not text:
        return drawn
    offset = (10, -22 if below else 10)
    return [*drawn, label((x, y), text, ax, colour=colour, offset=offset)]
