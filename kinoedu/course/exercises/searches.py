"""Exercises on graphs with weights: Dijkstra's algorithm and A*. Bullo & Smith, chapter 2; LaValle, section 2.2."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ... import graphs
from ...graphs.search import expand
from ...words import say
from ..exercise import Case, Slip, ValueExercise, spoken
from ..outcomes import Answer, Outcome
from ..shapes import Listed, Number, Numbers, Record
from ..whole_shapes import Whole
from .graph_paths import PathExercise, as_list
from .graph_pictures import draw_costs
from .graph_slips import best_first, best_path, depths, in_turn, lightest_first, tree_path, undirected, undirected_weights
from .graphs import NEIGHBOURS
from .random_graphs import Neighbours, Weights, as_graph, far_pair, lists, lost_pair, random_graphs

WEIGHTS = Listed(Listed(Number()))
DETOUR = [(0, 1, 1), (1, 2, 1), (0, 2, 5)]
LATE_GAIN = [(0, 1, 1), (0, 2, 4), (1, 2, 2), (2, 3, 1)]
LIGHT_EDGES = [(0, 1, 3), (0, 3, 4), (1, 2, 3), (2, 3, 1), (2, 4, 1)]
REOPENED = [(0, 1, 1), (0, 2, 3), (1, 2, 1), (2, 3, 4)]


class Dijkstra(ValueExercise):
    """Adjacency lists with weights and a start to the least cost of every node."""

    name = "dijkstra"
    lesson = "04_graph_search"
    kinds = ("small", "detour", "directed", "unreachable", "negative")
    given = Record(neighbours=NEIGHBOURS, weights=WEIGHTS, start=Whole())
    answer = Numbers(("n",))
    shown = staticmethod(expand)
    slips = (
        Slip("edges", lambda neighbours, weights, start: [float(d) if d >= 0 else np.inf for d in depths(neighbours, start)]),
        Slip("first_found", lambda neighbours, weights, start: best_first(neighbours, weights, start, improves=False)[0]),
        Slip(
            "last_edge",
            lambda neighbours, weights, start: best_first(neighbours, weights, start, from_node=False, reopens=False)[0],
        ),
        Slip("overwritten", lambda neighbours, weights, start: best_first(neighbours, weights, start, overwrites=True)[0]),
        Slip("in_turn", in_turn),
        Slip("lightest_first", lightest_first),
        Slip("undirected", lambda neighbours, weights, start: best_first(*both_ways(neighbours, weights), start)[0]),
        Slip("minus_one", lambda neighbours, weights, start: finite_or(best_first(neighbours, weights, start)[0], -1.0)),
        Slip("zero", lambda neighbours, weights, start: finite_or(best_first(neighbours, weights, start)[0], 0.0)),
    )

    @staticmethod
    def reference(neighbours: Neighbours, weights: Weights, start: int) -> list[float]:
        """The library's costs; a ValueError where a weight is negative."""
        return graphs.dijkstra(as_graph(neighbours, weights), start).cost.tolist()

    source = reference

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Graphs that fit on a finger first."""
        for kind, n, rows, start in (
            ("small", 2, [(0, 1, 3)], 0),
            ("small", 3, [(0, 1, 2), (1, 2, 3)], 0),
            ("detour", 3, DETOUR, 0),
            ("detour", 4, LATE_GAIN, 0),
            ("detour", 5, LIGHT_EDGES, 0),
            ("directed", 3, [(0, 1, 2), (1, 2, 2), (2, 0, 1)], 0),
            ("unreachable", 3, [(0, 1, 2)], 1),
            ("detour", 3, [(0, 1, 0), (1, 2, 0.5), (0, 2, 1)], 2),
            ("negative", 3, [(0, 1, 2), (1, 2, -1)], 0),
            ("negative", 4, [(0, 1, 2), (2, 3, -1)], 0),
            ("unreachable", 1, [], 0),
        ):
            directed = kind in ("directed", "negative")
            yield Case(kind, dict(zip(self.given.fields, (*lists(n, rows, directed=directed), start))))
        for shape, neighbours, weights in random_graphs(rng):
            kind = {"tree": "small", "cycle": "detour", "parts": "unreachable"}.get(shape, shape)
            start = int(rng.integers(len(neighbours)))
            yield Case(kind, {"neighbours": neighbours, "weights": weights, "start": start})
            if kind == "directed":
                spoilt = [row.copy() for row in weights]
                spoilt[int(rng.integers(len(spoilt)))][0] = -float(rng.integers(1, 4))
                yield Case("negative", {"neighbours": neighbours, "weights": spoilt, "start": start})

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The graph with its weights, and both costs of every node."""
        draw_costs(self, case, outcome.value if isinstance(outcome, Answer) else None, self.truth(case), ax)


def both_ways(neighbours: Neighbours, weights: Weights) -> tuple[Neighbours, Weights]:
    """The graph with its edges led both ways."""
    return undirected(neighbours), undirected_weights(neighbours, weights)


def finite_or(costs: list[float], other: float) -> list[float]:
    """The costs, with another number for infinite ones."""
    return [cost if np.isfinite(cost) else other for cost in costs]


class Astar(PathExercise):
    """A path of least cost, any of them."""

    name = "astar"
    kinds = ("small", "estimate", "inconsistent", "directed", "unreachable", "start_is_goal")
    given = Record(neighbours=NEIGHBOURS, weights=WEIGHTS, estimate=Listed(Number()), start=Whole(), goal=Whole())
    last_rule = "shortest"
    shown = staticmethod(expand)
    slips = (
        Slip("greedy", lambda n, w, estimate, s, g: best_path(n, w, estimate, s, g, cost_counts=0.0, improves=False)),
        Slip("at_sight", lambda n, w, estimate, s, g: best_path(n, w, estimate, s, g, at_sight=True)),
        Slip("closed", lambda n, w, estimate, s, g: best_path(n, w, estimate, s, g, reopens=False)),
        Slip("first_found", lambda n, w, estimate, s, g: best_path(n, w, estimate, s, g, improves=False)),
        Slip("summed", lambda n, w, estimate, s, g: best_path(n, summed(n, w, estimate), [0.0] * len(n), s, g)),
        Slip("edges", lambda n, w, estimate, s, g: tree_path(n, s, g)),
        Slip("undirected", lambda n, w, estimate, s, g: best_path(*both_ways(n, w), estimate, s, g)),
        Slip("reversed", lambda n, w, estimate, s, g: (best_path(n, w, estimate, s, g) or [])[::-1] or None),
    )

    @staticmethod
    def reference(neighbours: Neighbours, weights: Weights, estimate: list[float], start: int, goal: int) -> list[int] | None:
        """The library's path."""
        return as_list(graphs.astar(as_graph(neighbours, weights), start, goal, estimate)[0])

    source = reference

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Graphs that fit on a finger first; estimates of zero, good ones, and lower bounds that jump."""
        for kind, n, rows, estimate, start, goal in (
            ("small", 2, [(0, 1, 3)], [0, 0], 0, 1),
            ("small", 3, DETOUR, [0, 0, 0], 0, 2),
            ("estimate", 3, DETOUR, [2, 1, 0], 0, 2),
            ("estimate", 4, LATE_GAIN, [3, 2, 1, 0], 0, 3),
            ("inconsistent", 4, REOPENED, [0, 5, 0, 0], 0, 3),
            ("start_is_goal", 2, [(0, 1, 3)], [3, 0], 1, 1),
            ("directed", 3, [(0, 1, 1), (1, 2, 1), (2, 0, 1)], [2, 1, 0], 0, 2),
            ("directed", 3, [(0, 1, 2), (1, 2, 2), (2, 0, 1)], [0, 0, 0], 1, 0),
            ("unreachable", 3, [(0, 1, 2)], [1, 1, 0], 0, 2),
        ):
            both = lists(n, rows, directed=kind == "directed")
            yield Case(kind, dict(zip(self.given.fields, (*both, [float(h) for h in estimate], start, goal))))
        for shape, neighbours, weights in random_graphs(rng):
            start, goal = (lost_pair if shape == "parts" else far_pair)(neighbours, rng)
            truth = left(neighbours, weights, goal)
            jumping = np.floor(truth * rng.choice([0.0, 1.0], len(truth))).tolist()
            kinds = {"tree": ["small"], "cycle": ["estimate", "inconsistent", "start_is_goal"], "parts": ["unreachable"]}
            for kind in kinds.get(shape, ["directed"]):
                estimate = jumping if kind == "inconsistent" else np.floor(truth * (kind != "small") * 0.8).tolist()
                last = start if kind == "start_is_goal" else goal
                bounds = np.zeros(len(truth)).tolist() if kind == "start_is_goal" else estimate
                yield Case(kind, dict(zip(self.given.fields, (neighbours, weights, bounds, start, last))))

    def is_good(self, case: Case, path: list[int]) -> bool:
        """Of the least cost."""
        return self.near(cost_of(case, path), cost_of(case, self.truth(case)))

    def wanted(self, case: Case) -> str:
        """One such path, and its cost."""
        truth = self.truth(case)
        if truth is None or len(truth) < 2:
            return spoken(truth)
        return say("astar.wanted", value=spoken(truth), cost=spoken(cost_of(case, truth)))


def summed(neighbours: Neighbours, weights: Weights, estimate: list[float]) -> Weights:
    """The weights, each with the estimate of the node that the edge leads to: what counts where estimates are added up."""
    return [[w + estimate[v] for v, w in zip(row, beside)] for row, beside in zip(neighbours, weights)]


def left(neighbours: Neighbours, weights: Weights, goal: int) -> Any:
    """What remains from each node to the goal, shape (n,); 5 where no path leads there."""
    costs = as_graph(neighbours, weights).cost_to_go(goal)
    return np.where(np.isfinite(costs), costs, 5.0)


def cost_of(case: Case, path: list[int]) -> float:
    """The sum of the weights along a path that goes along edges."""
    neighbours, weights = case.given["neighbours"], case.given["weights"]
    return sum((weights[u][neighbours[u].index(v)] for u, v in zip(path[:-1], path[1:])), 0.0)
