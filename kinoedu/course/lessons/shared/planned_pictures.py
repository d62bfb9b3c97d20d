"""Pictures of what a student's planner built, with a cross on what is at fault."""

from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....messages import get_message
from ....problems import ProblemRecord, Tree
from ...exercise import Axes
from ...shapes import Value

# figures are imported inside the functions: matplotlib is only needed for failing cases


def draw_answer(
    problem: ProblemRecord,
    trees: list[Tree],
    path: Array | None,
    fault: Value,
    words: str,
    ax: Axes,
) -> None:
    """Draw the problem, the trees, the path, and a cross on what is at fault."""
    from ....figures import palette, plane
    from ....figures.drawing import draw_path, draw_problem, draw_tree
    from ....figures.robots import place_of, track_of

    draw_problem(problem, ax)
    for tree in map(drawable, trees):
        draw_tree(tree, ax, robot=problem.robot)
        dots = np.array([place_of(problem.robot, q) for q in tree.nodes])
        ax.plot(*dots.T, ".", color=palette.TREE, markersize=6, zorder=3.5)
    if path is not None and path.ndim == 2 and path.shape[1] == len(problem.start) and len(path):
        draw_path(track_of(problem.robot, path[np.isfinite(path).all(axis=1)]), ax)
    if fault is not None and len(fault.marked):
        marks = np.array([place_of(problem.robot, q) for q in fault.marked])
        line: palette.Style = {"color": palette.YOURS, "linewidth": 3.5, "zorder": 8}
        ax.plot(*marks.T, "--", scalex=False, scaley=False, **line)
        cross: palette.Style = {
            "color": palette.YOURS,
            "markersize": 13,
            "markeredgecolor": "white",
            "zorder": 9,
        }
        ax.plot(*marks[-1], "X", **cross)
    if not trees and path is None and fault is None:
        plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
    plane.title(words, ax)


def drawable(tree: Tree) -> Tree:
    """The part of a tree that can be drawn: finite nodes, and edges to existing parents."""
    nodes = tree.nodes if tree.nodes.shape[1] > 1 else np.zeros((0, 2))  # else they are no places
    parent = np.full(len(nodes), -1)
    known = min(len(nodes), len(tree.parent))
    parent[:known] = tree.parent[:known]
    finite: Any = np.isfinite(nodes).all(axis=1)
    parent[(parent >= len(nodes)) | ~finite] = -1
    parent[~finite[parent]] = -1
    return Tree(np.where(finite[:, None], nodes, 0.0), parent)
