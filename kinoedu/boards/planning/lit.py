"""The lines of a planner that its boards show as they run, and what they draw of its variables."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...graphs.flat import estimate
from ...graphs.search import expand, search
from ...planners.roadmaps.connecting import join_components, join_in_order
from ...planners.trees.rrt import grow
from ...planners.trees.rrt_connect import extend
from ...planners.trees.rrt_star import grow_shortest
from ...problems import Plan, ProblemRecord
from ..core.drawing import Drawing
from ..tracing.code_run import CodeRun, Look, trace_lines
from .plans import draw_plan

TREE = "nodes in tree"
PAIRS = Look(
    {"q_i": "nodes[i]", "q_j": "nodes[j]"},
    lines=(("q_i", "q_j"),),
    colours={"nodes": "tree", "q_i": "path", "q_j": "hit"},
    hidden=("first", "to", "order", "cost_of_pair", "root", "costs", "edges", "closest", "tries"),
)
CODE: dict[str, tuple[Callable[..., object], Look]] = {
    "rrt": (
        grow,
        Look({"q_near": "tree.nodes[near]", TREE: "tree.size[0]"}, lines=(("q_near", "q_rand"),)),
    ),
    "rrt_star": (
        grow_shortest,
        Look(
            {"q_nearest": "costs.tree.nodes[nearest]", TREE: "costs.tree.size[0]"},
            lines=(("q_nearest", "q_rand"),),
            circles={"q_new": "radii[tree.size[0]]"},
            hidden=("radii",),
        ),
    ),
    "rrt_connect": (
        extend,
        Look({"q_near": "tree.nodes[near]", TREE: "tree.size[0]"}, lines=(("q_near", "q"),)),
    ),
    "prm": (join_in_order, PAIRS),
    "prm_components": (join_components, PAIRS),
    "astar": (
        expand,
        Look(
            {
                "queue": "middle(graph, list_in_order(queue))",
                "q_u": "middle(graph, u)",
                "q_v": "middle(graph, v)",
                "g": "cost[u]",
                "h": "estimate(heuristic, u)",
                "g + h": "cost[u] + estimate(heuristic, u)",
            },
            lines=(("q_u", "q_v"),),
            colours={"queue": "frontier", "q_u": "path", "q_v": "hit"},
            progress="n",
            hidden=("heuristic", "expanded", "cost", "parent", "settled"),
        ),
    ),
}
WITHOUT_RECORDER = ("astar",)  # planners that only take a Problem itself


def trace_planner(name: str, problem: ProblemRecord, call: Callable[[Any], object]) -> CodeRun:
    """The first lines of a planner, in a call with a problem.

    Parameters
    ----------
    name : a key of CODE.
    call : takes the problem, or a Recorder of it.
    """
    function, look = CODE[name]
    if name in WITHOUT_RECORDER:
        names = {"middle": partial(find_middle, problem.space.lo), "estimate": estimate}
        look = replace(look, names=names)
        return trace_lines(function, look, lambda _: call(problem), search)
    return trace_lines(function, look, lambda run: call(run.record(problem)))


def draw_lines_of(plan: Plan, run: CodeRun) -> Drawing:
    """The lines of a planner, and at the end the path that it found."""
    drawing = draw_plan(plan)
    if not run.look.progress:  # the questions that were asked show the tree or the roadmap
        drawing = replace(drawing, layers=[one for one in drawing.layers if one.last])
    return run.draw_over(drawing)


def find_middle(lo: Array, graph: Any, nodes: int | NDArray[np.int64]) -> Array | None:
    """The middle of the cell of a grid's node, or of cells (n,); None where there is no node."""
    cells = np.asarray(nodes, np.int64)
    if cells.ndim == 0 and cells < 0:
        return None
    steps = np.stack([cells % graph.columns, cells // graph.columns], axis=-1)
    return np.asarray(lo + graph.side * (steps - 0.5))
