"""One iteration of a kinodynamic planner, drawn in three steps."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from ..geometry.checks import Array
from ..messages import get_message
from ..problems import ProblemRecord
from ..robots.trajectory import DrivenTree, TrajectoryRecord
from ..spaces import SE2, distance
from . import palette
from .cars import draw_pose
from .drawing import draw_tree, draw_world
from .plane import label

MOMENTS = 60  # the moments at which a drive is compared with its target


def draw_driving_steps(
    problem: ProblemRecord,
    tree: DrivenTree,
    q_rand: Array,
    controls: Array,
    duration: float,
    axes: Any = None,
) -> list[Artist]:
    """Draw the nearest node to a pose, the drives by some controls, and the best, cut.

    A radian counts as a quarter of the wheelbase.

    Parameters
    ----------
    problem : of a car.
    q_rand : (3,), the target.
    controls : (m, 2), each applied for `duration`.
    axes : three; by default those of a new figure.

    Examples
    --------
    >>> from kinoedu import Car, PolygonWorld, Problem, kinodynamic_rrt
    >>> from matplotlib import pyplot as plt
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)])
    >>> problem = Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0))
    >>> tree = kinodynamic_rrt(problem, max_iterations=9, rng=0).tree
    >>> q_rand, controls = np.array([9.0, 9.0, 1.0]), np.array([(1, 0.1), (1, -0.5)])
    >>> artists = draw_driving_steps(problem, tree, q_rand, controls, 2.0)
    >>> plt.close()
    """
    radian = 0.25 * problem.robot.wheelbase
    space = SE2(problem.world.lo, problem.world.hi, turn_weight=radian)
    q_near = tree.nodes[int(np.argmin([distance(space, q, q_rand) for q in tree.nodes]))]
    cuts = [cut_drive(problem, q_near, q_rand, u, duration, radian) for u in controls]
    drives = [drive_along(problem, q_near, u, duration) for u in controls]
    best = int(np.argmin([apart for *_, apart in cuts]))
    way, lasts, _ = cuts[best]
    v, phi = controls[best]
    free = problem.is_free_drive(q_near, v, phi, lasts)
    panels = axes
    if panels is None:
        _, panels = plt.subplots(1, 3, figsize=(13.5, 5.0), dpi=72, layout="constrained")
    around = np.vstack([q_near[None], q_rand[None], *drives])[:, :2]
    size = 0.16 * float(np.ptp(around, axis=0).max())
    artists: list[Artist] = []
    for number, (ax, name) in enumerate(zip(panels, ("nearest", "controls", "best"))):
        artists += draw_panel(problem, tree, around, get_message(f"driving_steps.{name}"), ax)
        artists += draw_pose(q_rand, size, "q_rand", ax, colour=palette.INK, below=True)
        near = "q_near" if number < 2 else ""
        artists += draw_pose(q_near, size, near, ax, colour=palette.TREE, below=True)
        if number == 1:
            for drive, (before, *_) in zip(drives, cuts):
                artists += draw_cut(drive, len(before) - 1, ax)
        if number == 2:
            colour = palette.CLEAR if free else palette.HIT
            artists += ax.plot(*way[:, :2].T, color=colour, linewidth=4.0, zorder=5)
            artists += draw_pose(way[-1], size, "", ax, colour=colour)
            beside: palette.Style = {"offset": (-10, 10), "ha": "right"}
            artists.append(label(way[-1][:2], "q_new", ax, colour=colour, **beside))
    return artists


def cut_drive(
    problem: ProblemRecord,
    q: Array,
    q_rand: Array,
    control: ArrayLike,
    duration: float,
    radian: float,
) -> tuple[Array, float, float]:
    """The drive by a control from a pose, cut where it is closest to another pose.

    Parameters
    ----------
    problem : of a car.
    q, q_rand : (3,), where the drive begins, and its target.
    control : (v, phi), held at most for the `duration`.
    radian : the units of length that a radian counts.

    Returns
    -------
    The poses of the drive up to the cut, (k, 3); how long it lasts; its distance from the target.

    Examples
    --------
    >>> from kinoedu import Car, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)])
    >>> problem = Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0))
    >>> q, q_rand = np.array([4.0, 4.0, 0.0]), np.array([9.0, 4.0, 0.0])
    >>> drive, lasts, apart = cut_drive(problem, q, q_rand, (1, 0), 6.0, 0.5)
    >>> drive[-1].round(2).tolist(), round(lasts, 2), round(apart, 2)
    ([9.0, 4.0, 0.0], 5.0, 0.0)
    """
    space = SE2(problem.world.lo, problem.world.hi, turn_weight=radian)
    drive = drive_along(problem, q, control, duration)
    off = [distance(space, pose, q_rand) for pose in drive[1:]]
    cut = 1 + int(np.argmin(off))
    return drive[: cut + 1], duration * cut / MOMENTS, float(off[cut - 1])


def drive_along(problem: ProblemRecord, q: Array, control: ArrayLike, duration: float) -> Array:
    """The poses of a drive by one control at even moments, (MOMENTS + 1, 3)."""
    held, lasts = np.array([control], float), np.array([duration])
    times = np.linspace(0.0, duration, MOMENTS + 1)
    return TrajectoryRecord(q, held, lasts, problem.robot.wheelbase).at(times)


def draw_panel(
    problem: ProblemRecord, tree: DrivenTree, around: Array, title: str, ax: Axes
) -> list[Artist]:
    """Draw the part of the world and of the tree near some places."""
    artists = [*draw_world(problem.world, ax), *draw_tree(tree, ax, robot=problem.robot)]
    artists += ax.plot(*tree.nodes[:, :2].T, "o", color=palette.TREE, markersize=5, zorder=4)
    lo, hi = around.min(axis=0), around.max(axis=0)
    middle, reach = (lo + hi) / 2.0, 0.75 * float((hi - lo).max())
    ax.set(xlim=(middle[0] - reach, middle[0] + reach), ylim=(middle[1] - reach, middle[1] + reach))
    ax.set(xlabel="", ylabel="", xticks=[], yticks=[])
    return [*artists, ax.set_title(title, fontsize=palette.TEXT_SIZE + 2)]


def draw_cut(drive: Array, cut: int, ax: Axes) -> list[Artist]:
    """Draw a drive up to its cut, and the rest thinner."""
    before = ax.plot(*drive[: cut + 1, :2].T, color=palette.PATH, linewidth=2.2, zorder=4.5)
    after = ax.plot(*drive[cut:, :2].T, ":", color=palette.OUTSIDE, linewidth=1.6, zorder=4.2)
    end = ax.plot(*drive[cut, :2], ".", color=palette.INK, markersize=7, zorder=5)
    return [*before, *after, *end]
