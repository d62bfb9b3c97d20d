"""One iteration of an RRT in four steps, and its flowchart."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes

from ..geometry.checks import Array
from ..messages import get_message
from ..problems import ProblemRecord, Tree
from . import palette
from .drawing import draw_problem, draw_tree
from .flowcharts import Step, draw_flowchart
from .panels import panels
from .plane import dot, label, segment


def draw_rrt_steps(
    problem: ProblemRecord,
    tree: Tree,
    sample: Array,
    step_size: float,
    axes: Any = None,
    steps: Sequence[int] = (1, 2, 3, 4),
) -> list[Artist]:
    """Draw one iteration: the sample, its nearest node, the step, and whether it is free.

    Parameters
    ----------
    problem : of a point in the plane.
    sample : (2,), q_rand.
    axes : one for each step; by default those of a new figure, two in a row.
    steps : the steps to draw, from 1.

    Examples
    --------
    >>> from matplotlib import pyplot as plt
    >>> from kinoedu import Point, PolygonWorld, Problem, rrt
    >>> problem = Problem(Point(), PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)]), (1, 1), (8, 5))
    >>> tree = rrt(problem, max_nodes=9, rng=0).tree
    >>> artists = draw_rrt_steps(problem, tree, np.array([6.0, 2.0]), 1.0)
    >>> plt.close()
    """
    if axes is None:
        axes = panels(len(steps), columns=2, width=5.2, height=3.4)
    q_rand = np.asarray(sample, float)
    near = int(np.argmin([problem.distance(q, q_rand) for q in tree.nodes]))
    q_near, q_new = tree.nodes[near], problem.steer(tree.nodes[near], q_rand, step_size)
    free = problem.is_free_path(q_near, q_new)
    artists: list[Artist] = []
    titles = [get_message(f"rrt_steps.{name}") for name in ("sample", "nearest", "steer", "check")]
    for ax, number in zip(axes, (step - 1 for step in steps)):
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
        artists.append(ax.set_title(titles[number], fontsize=palette.TEXT_SIZE + 1))
        ax.set(xlabel="", ylabel="", xticks=[], yticks=[])
    return artists


def draw_new(q_near: Array, q_new: Array, good: bool, ax: Axes) -> list[Artist]:
    """Draw the step from the nearest node, green if it is free."""
    colour = palette.CLEAR if good else palette.HIT
    artists = segment(q_near, q_new, "", ax, colour=colour, width=4.0)
    marker = dot(q_new, "", ax, colour=colour, marker="o" if good else "X")
    return [*artists, *marker, label(q_new, "q_new", ax, colour=colour, offset=(6, -18))]


def draw_rrt_flowchart(ax: Axes | None = None) -> list[Artist]:
    """Draw the flowchart of an RRT that stops at the goal."""
    steps = {
        name: Step(kind, get_message(f"rrt_flowchart.{name}"), column, row)
        for name, kind, column, row in (
            ("start", "end", 0, 0),
            ("near", "ask", 0, 1),
            ("done", "end", 1, 1),
            ("left", "ask", 0, 2),
            ("failed", "end", 1, 2),
            ("sample", "do", 0, 3),
            ("steer", "do", 0, 4),
            ("free", "ask", 0, 5),
            ("add", "do", 0, 6),
        )
    }
    yes, no = get_message("rrt_flowchart.yes"), get_message("rrt_flowchart.no")
    arrows = [("start", "near", ""), ("near", "done", yes), ("near", "left", no)]
    arrows += [("left", "failed", no), ("left", "sample", yes), ("sample", "steer", "")]
    arrows += [("steer", "free", ""), ("free", "left", no), ("free", "add", yes)]
    arrows += [("add", "near", "")]
    return draw_flowchart(steps, arrows, palette.axes_or_new(ax, (7.4, 7.6)))
