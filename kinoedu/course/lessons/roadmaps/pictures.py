"""Pictures of failing cases on roadmaps.

The right answer is solid and green, the student's is dashed and brown.
"""

from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ....problems.protocols import ProblemLike
from ...exercise import Axes
from ...shapes import Value
from .halls import FULL, is_arm

MOST_NUMBERS = 25  # nodes that get numbers
# functions import figures themselves: matplotlib is needed only where an answer is wrong


def draw_joined(problem: ProblemLike, nodes: Array, truth: Value, value: Value, ax: Axes) -> None:
    """Draw the world, the numbered nodes, the right edges and the student's."""
    from ....figures import palette, plane

    draw_problem_ground(problem, ax)
    wraps = is_arm(problem)
    for pairs, colour, style, width in (
        (truth, palette.TRUE, "-", 5.0),
        (value, palette.YOURS, "--", 2.2),
    ):
        for i, j in [] if pairs is None else pairs:
            if 0 <= i < len(nodes) and 0 <= j < len(nodes) and i != j:
                draw_edge(
                    nodes[i], nodes[j], ax, wraps, color=colour, linestyle=style, linewidth=width
                )
    number_nodes(nodes, ax)
    note = (
        get_message("picture.no_answer")
        if value is None
        else get_message("roadmap_picture.edges", true=len(truth), yours=len(value))
    )
    plane.corner_note(note, ax, colour=palette.YOURS)


def draw_problem_ground(problem: Any, ax: Axes) -> None:
    """Draw the world of a problem; for the arm, the square of its angles."""
    from ....figures import palette, plane
    from ....figures.drawing import draw_world

    if is_arm(problem):
        plane.frame([(0, 0), (FULL, FULL)], ax, margin=0.05)
        square = [0, FULL, FULL, 0, 0], [0, 0, FULL, FULL, 0]
        ax.plot(*square, ":", color=palette.OBSTACLE, linewidth=1.5)
        ax.set_xlabel("$q_1$", fontsize=13)
        ax.set_ylabel("$q_2$", fontsize=13)
    else:
        plane.frame([problem.world.lo, problem.world.hi], ax, margin=0.02)
        draw_world(problem.world, ax)


def draw_edge(a: Array, b: Array, ax: Axes, wraps: bool, **look: Any) -> None:
    """Draw a straight motion.

    Where angles wrap, it is the shorter way, in two pieces if it leaves the square.
    """
    way = b - a
    if wraps:
        way = (way + np.pi) % FULL - np.pi
    ax.plot(*np.array([a, a + way]).T, zorder=4, scalex=False, scaley=False, **look)
    if wraps and np.abs(way - (b - a)).max() > 1e-9:
        ax.plot(*np.array([b, b - way]).T, zorder=4, scalex=False, scaley=False, **look)


def number_nodes(nodes: Array, ax: Axes, *, first: int = 0) -> None:
    """Draw the nodes, with their numbers from `first` on unless there are too many."""
    from ....figures import palette, plane

    shown = nodes[np.isfinite(nodes).all(axis=1)]
    ax.plot(*shown.T, "o", color=palette.INK, markersize=6, zorder=6, scalex=False, scaley=False)
    for number, node in enumerate(shown if len(shown) <= MOST_NUMBERS else []):
        if number >= first:
            plane.label(node, str(number), ax, offset=(5, 5))


def draw_roadmap_answer(problem: ProblemLike, truth: Value, value: Value, ax: Axes) -> None:
    """Draw the world, the right roadmap if it is unique, and the student's.

    Parameters
    ----------
    truth, value : (nodes, edges), or None.
    """
    from ....figures import palette, plane

    draw_problem_ground(problem, ax)
    for roadmap, colour, style, width in (
        (truth, palette.TRUE, "-", 5.0),
        (value, palette.YOURS, "--", 1.8),
    ):
        if roadmap is None:
            continue
        nodes, pairs = roadmap
        for i, j in pairs:
            if 0 <= i < len(nodes) and 0 <= j < len(nodes) and np.isfinite(nodes[[i, j]]).all():
                draw_edge(
                    nodes[i], nodes[j], ax, False, color=colour, linestyle=style, linewidth=width
                )
    if value is None:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    else:
        number_nodes(value[0], ax, first=2)  # start and goal are labelled already
    plane.dot(problem.start, "start", ax, colour=palette.START, marker="s")
    plane.dot(problem.goal, "goal", ax, colour=palette.GOAL, marker="*")


def draw_shortest_path(nodes: Array, edges: Value, truth: Value, value: Value, ax: Axes) -> None:
    """Draw a roadmap, a shortest path along it and the student's path."""
    from ....figures import palette, plane

    plane.frame(nodes[:, :2], ax, margin=0.2)
    for i, j in edges:
        draw_edge(nodes[i, :2], nodes[j, :2], ax, False, color=palette.ROADMAP, linewidth=1.2)
    for path, colour, style, width in (
        (truth, palette.TRUE, "-", 6.0),
        (value, palette.YOURS, "--", 2.8),
    ):
        steps = [int(u) for u in ([] if path is None else path) if 0 <= u < len(nodes)]
        for i, j in zip(steps, steps[1:]):
            look = {"color": colour, "linestyle": style, "linewidth": width}
            draw_edge(nodes[i, :2], nodes[j, :2], ax, False, **look)
    number_nodes(nodes[:, :2], ax)
    if value is None:
        plane.corner_note(get_message("picture.yours", value="None"), ax, colour=palette.YOURS)
