"""One iteration of a planner that drives: its three steps drawn."""

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes

from ..geometry.checks import Array
from ..problems import ProblemRecord
from ..robots.trajectory import DrivenTree, TrajectoryRecord
from ..spaces import SE2, distance
from ..words import say
from . import palette
from .cars import draw_pose
from .drawing import draw_tree, draw_world

MOMENTS = 60  # at which a drive is compared with its target


def draw_driving_steps(
    problem: ProblemRecord,
    tree: DrivenTree,
    q_rand: Array,
    controls: Array,
    duration: float,
    axes: Any = None,
) -> list[Artist]:
    """Draw what one iteration does to a tree: the node nearest to a pose, the drives by some
    controls, and the best one, cut.

    problem : of a car. q_rand : the target, (3,). controls : (m, 2), each held for `duration`. axes
        : three; by default new ones.
    A radian counts a quarter of the wheelbase.

    >>> from kinoedu import Car, PolygonWorld, Problem, kinodynamic_rrt
    >>> problem = Problem(Car(3, 1, 2), PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)]), (4, 4, 0), (16, 4, 0))
    >>> tree = kinodynamic_rrt(problem, max_iterations=9, rng=0).tree
    >>> artists = draw_driving_steps(problem, tree, np.array([9.0, 9.0, 1.0]), np.array([(1, 0.1), (1, -0.5)]), 2.0)
    >>> plt.close()
    """
    space = SE2(problem.world.lo, problem.world.hi, turn_weight=0.25 * problem.robot.wheelbase)
    q_near = tree.nodes[int(np.argmin([distance(space, q, q_rand) for q in tree.nodes]))]
    times = np.linspace(0.0, duration, MOMENTS + 1)
    drives = [
        TrajectoryRecord(q_near, u[None], np.array([duration]), problem.robot.wheelbase).at(times)
        for u in controls
    ]
    off = np.array([[distance(space, q, q_rand) for q in drive[1:]] for drive in drives])
    cuts, best = 1 + off.argmin(axis=1), int(off.min(axis=1).argmin())
    v, phi = controls[best]
    free = problem.is_free_drive(q_near, v, phi, times[cuts[best]])
    panels = (
        plt.subplots(1, 3, figsize=(13.5, 5.0), dpi=72, layout="constrained")[1]
        if axes is None
        else axes
    )
    around = np.vstack([q_near[None], q_rand[None], *drives])[:, :2]
    size = 0.16 * float(np.ptp(around, axis=0).max())
    artists: list[Artist] = []
    for number, ax in enumerate(panels):
        artists += dressed_panel(
            problem,
            tree,
            around,
            say(f"driving_steps.{('nearest', 'controls', 'best')[number]}"),
            ax,
        )
        artists += draw_pose(q_rand, size, "q_rand", ax, colour=palette.INK, below=True)
        artists += draw_pose(
            q_near, size, "q_near" if number < 2 else "", ax, colour=palette.TREE, below=True
        )
        if number == 1:
            artists += [
                line for drive, cut in zip(drives, cuts) for line in draw_cut(drive, int(cut), ax)
            ]
        if number == 2:
            way, colour = drives[best][: cuts[best] + 1], palette.START if free else palette.HIT
            artists += ax.plot(*way[:, :2].T, color=colour, linewidth=4.0, zorder=5)
            artists += draw_pose(way[-1], size, "q_new", ax, colour=colour)
    return artists


def dressed_panel(
    problem: ProblemRecord, tree: DrivenTree, around: Array, title: str, ax: Axes
) -> list[Artist]:
    """The world and the tree, as far as they are near these places."""
    artists = [*draw_world(problem.world, ax), *draw_tree(tree, ax, robot=problem.robot)]
    artists += ax.plot(*tree.nodes[:, :2].T, "o", color=palette.TREE, markersize=5, zorder=4)
    lo, hi = around.min(axis=0), around.max(axis=0)
    middle, reach = (lo + hi) / 2.0, 0.75 * float((hi - lo).max())
    ax.set(xlim=(middle[0] - reach, middle[0] + reach), ylim=(middle[1] - reach, middle[1] + reach))
    ax.set(xlabel="", ylabel="", xticks=[], yticks=[])
    return [*artists, ax.set_title(title, fontsize=palette.TEXT_SIZE + 2)]


def draw_cut(drive: Array, cut: int, ax: Axes) -> list[Artist]:
    """A drive up to its cut, and thinner what would come after."""
    before = ax.plot(*drive[: cut + 1, :2].T, color=palette.PATH, linewidth=2.2, zorder=4.5)
    after = ax.plot(*drive[cut:, :2].T, ":", color=palette.OUTSIDE, linewidth=1.6, zorder=4.2)
    return [
        *before,
        *after,
        *ax.plot(*drive[cut, :2], ".", color=palette.GOAL, markersize=7, zorder=5),
    ]
