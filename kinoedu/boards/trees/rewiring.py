"""The rewiring board: RRT* node by node, with the changes that each new node makes."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...messages import get_message
from ...planners.problem_input import world_size
from ...planners.trees.rewiring import Rewirings, rrt_star_rewirings
from ...planners.tuning import integer
from ...problems import Plan, ProblemRecord
from ..core.drawing import Drawing
from ..core.framed import Framed, make_code_box, make_counter, make_length_slider
from ..core.scene import Scene
from ..planning.lit import draw_lines_of, trace_planner
from ..planning.plans import check_in_plane, make_problem_canvas, problem_in
from .rewired import (
    PathToGoal,
    costs_at,
    describe_steps,
    draw_moments,
    draw_paths,
    draw_tree_history,
    find_last_path,
    find_near_pairs,
    find_paths_to_goal,
)


def rewiring_board(
    problem: ProblemRecord, *, nodes: int = 300, step_size: float | None = None, rng: int = 0
) -> RewiringBoard:
    """Scrub through RRT*: each new node, its ball and neighbours, its parent, the rewired edges.

    The edge to the new node is black; edges that are attached to it are red, their former places
    dashed. Drag start, goal and obstacles. With the box "code" the lines of RRT* are shown as they
    run.

    Parameters
    ----------
    problem : a Problem in the plane.
    nodes, step_size, rng : the first values of the controls; see `rrt_star`.

    Returns
    -------
    RewiringBoard
        `plan` and `rewirings` are the plan shown and its log.

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> room = [(0, 0), (10, 0), (10, 10), (0, 10)]
    >>> world = PolygonWorld(room, [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> rewiring_board(Problem(Point(), world, start=(1, 1), goal=(9, 1)), step_size=1)
    RewiringBoard(node 300: 4 neighbours, parent 29, 0 rewired; path of length 20.87)
    """
    return RewiringBoard(problem, nodes, step_size, rng)


class RewiringBoard(Framed):
    """The widget that `rewiring_board` returns: controls, and the tree in `canvas`."""

    def __init__(
        self, problem: ProblemRecord, nodes: int, step_size: float | None, rng: int
    ) -> None:
        self._given = check_in_plane(problem)
        self.nodes = make_counter("rewiring_board.n", integer(nodes, "nodes", least=1), 50, 1000)
        self.step_size = make_length_slider("board.step_size", world_size(problem), step_size)
        self.seed = make_counter("board.seed", integer(rng, "rng", least=0), 0, 99)
        self.code = make_code_box()
        self.plan: Plan | None = None
        controls = [self.nodes, self.step_size, self.seed, self.code]
        super().__init__(controls, [make_problem_canvas(problem, self.answer)])

    def answer(self, scene: Scene) -> Drawing:
        """Plan in a scene, and draw all steps."""
        problem = problem_in(scene, self._given)
        given: dict[str, Any] = {"max_nodes": self.nodes.value, "step_size": self.step_size.value}
        call: Any = partial(rrt_star_rewirings, **given, rng=self.seed.value)
        plan, self.rewirings = call(problem)
        self.plan = plan
        drawing = draw_rewirings(self.rewirings)
        if not self.code.value:
            return drawing
        return drawing.completed_by(
            lambda: draw_lines_of(plan, trace_planner("rrt_star", problem, call))
        )


def draw_rewirings(log: Rewirings) -> Drawing:
    """The tree of RRT* at each step; while something is dragged at the last one."""
    n = len(log.nodes)
    last = draw_steps(log, np.array([n - 1]), find_last_path(log), [n])
    return last.completed_by(
        lambda: draw_steps(log, np.arange(n), find_paths_to_goal(log), range(n + 1))
    )


def draw_steps(
    log: Rewirings, numbers: NDArray[np.int64], paths: list[PathToGoal], steps: Iterable[int]
) -> Drawing:
    """Draw the tree, these paths, and the moments of these new nodes; with the texts of steps."""
    n, near = len(log.nodes), find_near_pairs(log, numbers)
    layers = [draw_tree_history(log), *draw_paths(paths), *draw_moments(log, near, numbers)]
    *texts, text = describe_steps(log, near, costs_at(paths, n), steps)
    unit = get_message("rewiring_board.unit")
    return Drawing(layers, text=text, total=n, unit=unit, step_texts=texts)
