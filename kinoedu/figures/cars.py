"""Cars that drive: a trajectory with the car at its ends, and a curve of arcs. Forward is a solid
line, back a dashed one.
"""

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.patches import Polygon
from numpy.typing import ArrayLike

from ..curves.curve import Curve
from ..geometry.checks import Array
from ..robots.car import CarRobot
from ..robots.trajectory import TrajectoryRecord
from . import palette
from .robots import draw_robot, outline_at

PIECES = 60  # of an arc, to draw it


def draw_drive(
    car: CarRobot, trajectory: TrajectoryRecord, ax: Axes, *, ghosts: int = 0
) -> list[Artist]:
    """Draw the car at the start and at the end of a trajectory, the way of its rear axle, and so
    many bodies on the way.

    >>> from kinoedu import Car, Trajectory
    >>> from matplotlib import pyplot as plt
    >>> car = Car(30, 10, 20)
    >>> artists = draw_drive(car, Trajectory(car, (0, 0, 0), [(1, 0.5), (-1, 0)], [30, 20]), plt.gca(), ghosts=3)
    >>> plt.close()
    """
    poses = trajectory.poses
    begins = np.concatenate([[0.0], np.cumsum(trajectory.durations)])
    drawn: list[Artist] = []
    for (v, _), begin, end in zip(trajectory.controls, begins, begins[1:]):
        drawn += draw_way(trajectory.at(np.linspace(begin, end, PIECES)), v < 0.0, ax, palette.PATH)
    for q in trajectory.at(np.linspace(0.0, trajectory.duration, ghosts + 2)[1:-1]):
        drawn.append(
            ax.add_patch(
                Polygon(
                    outline_at(car, q),
                    facecolor="none",
                    edgecolor=palette.ROBOT,
                    linewidth=1.2,
                    zorder=3,
                )
            )
        )
    drawn += draw_robot(car, poses[0], ax, palette.START) + draw_robot(
        car, poses[-1], ax, palette.GOAL
    )
    ax.set_aspect("equal")
    ax.autoscale_view()
    ax.tick_params(labelsize=palette.TEXT_SIZE - 1)
    return drawn


def draw_curve(curve: Curve, ax: Axes, *, colour: str = palette.PATH) -> list[Artist]:
    """Draw a curve's pieces, and a dot where one ends and the next begins."""
    ends = np.concatenate([[0.0], np.cumsum(np.abs(curve.lengths))])
    drawn: list[Artist] = []
    for length, begin, end in zip(curve.lengths, ends, ends[1:]):
        drawn += draw_way(curve.at(np.linspace(begin, end, PIECES)), length < 0.0, ax, colour)
    return drawn + ax.plot(
        *curve.at(ends[1:-1])[:, :2].T,
        "o",
        color=colour,
        markersize=6,
        markeredgecolor="white",
        zorder=5,
    )


def draw_way(poses: Array, back: bool, ax: Axes, colour: str) -> list[Artist]:
    """Draw the way through poses (k, 3)."""
    return [
        *ax.plot(
            poses[:, 0], poses[:, 1], "--" if back else "-", color=colour, linewidth=2.6, zorder=4
        )
    ]


def draw_pose(
    pose: ArrayLike, size: float, words: str, ax: Axes, *, colour: str, below: bool = False
) -> list[Artist]:
    """A pose as an arrow so long, from the place in the direction of the heading, with its words
    above or below.
    """
    from .plane import arrow, label

    x, y, theta = np.asarray(pose, float)
    drawn = arrow((x, y), (size * np.cos(theta), size * np.sin(theta)), "", ax, colour=colour)
    drawn += ax.plot(x, y, "o", color=colour, markersize=8, markeredgecolor="white", zorder=8)
    return (
        [*drawn, label((x, y), words, ax, colour=colour, offset=(10, -22 if below else 10))]
        if words
        else drawn
    )
