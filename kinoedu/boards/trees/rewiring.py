"""The rewiring board: RRT* node by node, with what each new node does to the tree."""

from ...planners.problem_input import world_size
from ...planners.trees.rewiring import rrt_star_rewirings
from ...planners.tuning import whole
from ...problems import Plan, ProblemRecord
from ...words import say
from ..core.controls import counter, length_slider
from ..core.drawing import Drawing
from ..core.framed import Framed
from ..core.scene import Scene
from ..planning.plans import canvas_for, in_plane, problem_in
from .rewired import (
    costs_at,
    moments_drawn,
    near_pairs,
    told_of,
    tree_as_it_was,
    ways_drawn,
    ways_to_goal,
)


def rewiring_board(
    problem: ProblemRecord, *, nodes: int = 300, step: float | None = None, rng: int = 0
) -> "RewiringBoard":
    """Scrub through RRT*: the new node and its ball, the nodes near, the parent that is chosen, and
    what is hung below it instead.

    Black is the edge to the new node, red are the edges that are re-hung, dashed where they were
    before. Drag start, goal and obstacles.

    Parameters
    ----------
    problem : a Problem in the plane. nodes, step, rng : where the controls begin; see `rrt_star`.

    `board.plan` and `board.rewirings` are on show. Raises InvalidParameter.

    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> rewiring_board(Problem(Point(), world, start=(1, 1), goal=(9, 1)), step=1)
    RewiringBoard(node 300: 4 within its ball; hangs below node 29; re-hung 0; path of length 20.87)
    """
    return RewiringBoard(problem, nodes, step, rng)


class RewiringBoard(Framed):
    """What `rewiring_board` makes: the controls, and the tree in `canvas`."""

    def __init__(self, problem: ProblemRecord, nodes: int, step: float | None, rng: int) -> None:
        self._given = in_plane(problem)
        self.nodes = counter("rewiring_board.n", whole(nodes, "nodes", least=1), 50, 1000)
        self.step = length_slider("board.step", world_size(problem), step)
        self.seed = counter("board.seed", whole(rng, "rng", least=0), 0, 99)
        self.plan: Plan | None = None
        super().__init__([self.nodes, self.step, self.seed], [canvas_for(problem, self.answer)])

    def answer(self, scene: Scene) -> Drawing:
        """Plan in a scene, and draw all that happened."""
        problem = problem_in(scene, self._given)
        self.plan, self.rewirings = rrt_star_rewirings(
            problem, max_nodes=self.nodes.value, step=self.step.value, rng=self.seed.value
        )
        log = self.rewirings
        n, ways, near = len(log.nodes), ways_to_goal(log), near_pairs(log)
        told = told_of(log, near, costs_at(ways, n))
        layers = [tree_as_it_was(log), *ways_drawn(ways), *moments_drawn(log, near)]
        return Drawing(layers, text=told.pop(), total=n, unit=say("rewiring_board.unit"), told=told)
