"""One iteration of an RRT in four steps, and its flowchart."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib import pyplot as plt
from matplotlib.artist import Artist
from matplotlib.axes import Axes

from ..geometry.checks import Array
from ..messages import get_message
from ..problems import ProblemRecord, Tree
from . import palette
from .drawing import draw_problem, draw_tree
from .flowcharts import Step, draw_flowchart
from .plane import dot, label, segment


def draw_rrt_steps(
    problem: ProblemRecord, tree: Tree, sample: Array, step_size: float, axes: Any = None
) -> list[Artist]:
    """Draw one iteration: the sample, its nearest node, the step, and whether it is free.

    Parameters
    ----------
    problem : of a point in the plane.
    sample : (2,), q_rand.
    axes : four; by default those of a new figure.

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> from kinoedu import Point, PolygonWorld, Problem, rrt
    >>> problem = Problem(Point(), PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)]), (1, 1), (8, 5))
    >>> tree = rrt(problem, max_nodes=9, rng=0).tree
    >>> artists = draw_rrt_steps(problem, tree, np.array([6.0, 2.0]), 1.0)
    >>> plt.close()
    """
    panels = axes
    if panels is None:
        _, new = plt.subplots(2, 2, figsize=(9.6, 6.4), dpi=72, layout="constrained")
        panels = new.ravel()
    q_rand = np.asarray(sample, float)
    near = int(np.argmin([problem.distance(q, q_rand) for q in tree.nodes]))
    q_near, q_new = tree.nodes[near], problem.steer(tree.nodes[near], q_rand, step_size)
    free = problem.is_free_path(q_near, q_new)
    artists: list[Artist] = []
    titles = [get_message(f"rrt_steps.{name}") for name in ("sample", "nearest", "steer", "check")]
    for number, (ax, title) in enumerate(zip(panels, titles)):
        artists += [*draw_problem(problem, ax), *draw_tree(tree, ax)]
        artists += ax.plot(*tree.nodes.T, "o", color=palette.TREE, markersize=5, zorder=4)
        if number < 3:
            artists += dot(q_rand, "" if number == 2 else "q_rand", ax)
        if number == 1:
            artists += segment(q_near, q_rand, "", ax, style=":", width=2.0)
        if number >= 1:
            artists += dot(q_near, "q_near" if number == 1 else "", ax, colour=palette.TREE)
        if number >= 2:
            artists += draw_new(q_near, q_new, number < 3 or free, ax)
        artists.append(ax.set_title(title, fontsize=palette.TEXT_SIZE + 1))
        ax.set(xlabel="", ylabel="", xticks=[], yticks=[])
    return artists


def draw_new(q_near: Array, q_new: Array, good: bool, ax: Axes) -> list[Artist]:
    """Draw the step from the nearest node, green if it is free."""
    colour = palette.START if good else palette.HIT
    artists = segment(q_near, q_new, "", ax, colour=colour, width=4.0)
    marker = dot(q_new, "", ax, colour=colour, marker="o" if good else "X")
    return [*artists, *marker, label(q_new, "q_new", ax, colour=colour, offset=(6, -18))]


def draw_rrt_flowchart(ax: Axes | None = None) -> list[Artist]:
    """Draw the flowchart of an RRT that stops at the goal."""
    steps = {
        "start": Step("end", get_message("rrt_flowchart.start"), 0, 0),
        "sample": Step("do", get_message("rrt_flowchart.sample"), 0, 1),
        "steer": Step("do", get_message("rrt_flowchart.steer"), 0, 2),
        "free": Step("ask", get_message("rrt_flowchart.free"), 0, 3),
        "add": Step("do", get_message("rrt_flowchart.add"), 0, 4),
        "near": Step("ask", get_message("rrt_flowchart.near"), 0, 5),
        "done": Step("end", get_message("rrt_flowchart.done"), 1, 5),
    }
    yes, no = get_message("rrt_flowchart.yes"), get_message("rrt_flowchart.no")
    arrows = [("start", "sample", ""), ("sample", "steer", ""), ("steer", "free", "")]
    arrows += [("free", "add", yes), ("free", "sample", no), ("add", "near", "")]
    arrows += [("near", "done", yes), ("near", "sample", no)]
    return draw_flowchart(steps, arrows, palette.axes_or_new(ax, (6.6, 7)))
