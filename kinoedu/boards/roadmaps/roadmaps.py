"""The roadmaps' board: a growing PRM, with its rule, sampler and number of samples to choose."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

from ...figures.drawing import dot_size
from ...messages import get_message
from ...planners import ComponentKClosest, KClosest, Radius, prm
from ...planners.problem_input import world_size
from ...planners.roadmaps.connecting import count_components
from ...planners.roadmaps.prm import Sampler
from ...planners.tuning import integer, one_of
from ...problems import Plan, ProblemRecord, Roadmap
from ...sampling import halton, sukharev_grid
from ...support.json_fields import JsonObject
from ..core.drawing import Drawing, Layer, dots, edges, path
from ..core.framed import Framed, make_code_box, make_counter, make_length_slider, make_menu
from ..core.scene import Scene
from ..planning.lit import draw_lines_of, trace_planner
from ..planning.plans import check_in_plane, make_problem_canvas, note_roadmap, problem_in

RULES = ("closest", "radius", "component")
SAMPLERS: dict[str, Sampler | None] = {
    "random": None,
    "halton": lambda n, d: halton(n),
    "grid": lambda n, d: sukharev_grid(math.isqrt(n) ** 2, d),
}


class RoadmapControls:
    """The controls of a roadmap; `given` are their values as arguments of `prm`."""

    def __init__(self, problem: ProblemRecord, n: int, rule: str, sampler: str, rng: int) -> None:
        rules = [(get_message(f"roadmap_board.{name}"), name) for name in RULES]
        samplers = [(get_message(f"roadmap_board.{name}"), name) for name in SAMPLERS]
        self.rule = make_menu("roadmap_board.rule", rules, one_of(rule, "rule", RULES))
        self.k = make_counter("roadmap_board.k", 10, 1, 30)
        self.r = make_length_slider(
            "roadmap_board.r", world_size(problem), world_size(problem) / 10.0
        )
        chosen = one_of(sampler, "sampler", tuple(SAMPLERS))
        self.sampler = make_menu("roadmap_board.sampler", samplers, chosen)
        self.n = make_counter("roadmap_board.n", integer(n, "n", least=1), 1, 1000)
        self.seed = make_counter("roadmap_board.seed", integer(rng, "rng", least=0), 0, 99)
        self.all = (self.rule, self.k, self.r, self.sampler, self.n, self.seed)

    def dress(self) -> None:
        """Show the number that the rule takes, and the seed for random samples."""
        shown = {
            self.k: self.rule.value != "radius",
            self.r: self.rule.value == "radius",
            self.seed: self.sampler.value == "random",
        }
        for control, there in shown.items():
            control.layout.display = None if there else "none"

    @property
    def given(self) -> JsonObject:
        """The arguments of `prm` and `build_roadmap`."""
        k, r = self.k.value, self.r.value
        rules = {"closest": KClosest(k), "radius": Radius(r), "component": ComponentKClosest(k)}
        samples = {"n": self.n.value, "sampler": SAMPLERS[self.sampler.value]}
        return {**samples, "neighbours": rules[self.rule.value], "rng": self.seed.value}


def roadmap_board(
    problem: ProblemRecord,
    n: int = 300,
    *,
    rule: str = "closest",
    sampler: str = "random",
    rng: int = 0,
) -> RoadmapBoard:
    """Choose neighbours and samples, drag start, goal and obstacles; scrub through the growth.

    A step is a node; when all nodes are there, a step is the edges that one node gets when it is
    tried with its neighbours. With the box "code" a step is a line of the planner that joins nodes.

    Parameters
    ----------
    problem : a Problem in the plane.
    n : the number of samples; for a grid, the points of the largest grid with at most n. Free
        samples become nodes.
    rule : "closest", "radius" or "component": KClosest, Radius or ComponentKClosest.
    sampler : "random", "halton" or "grid".
    rng : the first seed.

    Returns
    -------
    RoadmapBoard
        `plan` is the plan shown.

    Raises
    ------
    InvalidParameter

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> room = [(0, 0), (10, 0), (10, 10), (0, 10)]
    >>> world = PolygonWorld(room, [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> roadmap_board(Problem(Point(), world, start=(1, 1), goal=(9, 1)), n=100, sampler="halton")
    RoadmapBoard(path of length 19.12; nodes 86, edges 490, components 1)
    """
    return RoadmapBoard(problem, n, rule, sampler, rng)


class RoadmapBoard(Framed):
    """The widget that `roadmap_board` returns: the controls, and the roadmap in `canvas`."""

    def __init__(self, problem: ProblemRecord, n: int, rule: str, sampler: str, rng: int) -> None:
        self._given = check_in_plane(problem)
        self.controls = RoadmapControls(problem, n, rule, sampler, rng)
        self.code = make_code_box()
        self.plan: Plan | None = None
        controls = [*self.controls.all, self.code]
        super().__init__(controls, [make_problem_canvas(problem, self.answer)])

    def answer(self, scene: Scene) -> Drawing:
        """Plan in a scene with the settings of the controls, and draw the roadmap."""
        problem = problem_in(scene, self._given)
        call: Any = partial(prm, **self.controls.given)
        plan = self.plan = call(problem)
        drawing = draw_growing_roadmap(plan)
        if not self.code.value:
            return drawing
        name = "prm_components" if self.controls.rule.value == "component" else "prm"
        return drawing.completed_by(lambda: draw_lines_of(plan, trace_planner(name, problem, call)))

    def _dress(self) -> None:
        self.controls.dress()


def draw_growing_roadmap(plan: Plan) -> Drawing:
    """Draw a roadmap that grows, its nodes first, then the edges of each node; and the path."""
    roadmap = plan.roadmap
    n = len(roadmap.nodes)
    layers, unit = draw_nodes_and_edges(roadmap), get_message("roadmap_board.unit")
    counts = describe_counts(roadmap)
    if plan.path is None:
        text = get_message("roadmap_board.failed", reason=plan.reason, counts=counts)
    else:
        layers.append(path(plan.path, "path"))
        text = get_message("roadmap_board.found", length=f"{plan.cost:.4g}", counts=counts)
    last = Drawing(layers, text=text, total=2 * n, unit=unit)
    return last.with_texts(lambda: describe_steps(roadmap))


def draw_nodes_and_edges(roadmap: Roadmap) -> list[Layer]:
    """Nodes one per step, then each edge at the step at which its first node is tried."""
    n = len(roadmap.nodes)
    tried = n + 1 + roadmap.edges[:, 0]
    links = edges(roadmap.nodes[roadmap.edges], "roadmap", width=0.8, when=tried)
    radius = max(dot_size(n) / 2.0, 1.5)
    return note_roadmap(
        roadmap, links, dots(roadmap.nodes, "tree", radius=radius, when=np.arange(1, n + 1))
    )


def describe_steps(roadmap: Roadmap) -> list[str]:
    """The nodes, edges and components at each step before the last, in words."""
    n = len(roadmap.nodes)
    # Each message is looked up once; its numbers are filled in afterwards.
    blanks = {name: f"{{{name}}}" for name in ("joined", "edges", "components")}
    sampled = get_message("roadmap_board.sampled", nodes="{nodes}", n=f"{n:,}")
    joined = get_message("roadmap_board.joined", n=f"{n:,}", **blanks)
    so_far = np.searchsorted(roadmap.edges[:, 0], np.arange(n), side="right")
    components = count_components(n, roadmap.edges)[so_far]
    texts = [sampled.format(nodes=f"{k:,}") for k in range(n + 1)]
    texts += [
        joined.format(joined=f"{k:,}", edges=f"{m:,}", components=f"{c:,}")
        for k, (m, c) in enumerate(zip(so_far.tolist(), components.tolist(), strict=True), start=1)
    ]
    return texts[:-1]


def describe_counts(roadmap: Roadmap) -> str:
    """The nodes, edges and components of a roadmap, in words."""
    n, edges = len(roadmap.nodes), len(roadmap.edges)
    components = count_components(n, roadmap.edges)[-1]
    counts = {"edges": f"{edges:,}", "components": f"{components:,}"}
    return get_message("roadmap_board.counts", n=f"{n:,}", **counts)
