"""The exercise `astar`. Hart, Nilsson, Raphael (1968); LaValle, section 2.2."""

from collections.abc import Callable, Iterator

import numpy as np

from .... import graphs
from ....graphs.search import expand
from ...exercise import Case, Restated, Slip, format_value
from ...shapes import Listed, Number, Record, Value
from ...whole_shapes import Integer
from ...withheld import withheld
from ..shared.graph_slips import (
    astar_path,
    greedy_path,
    keep_closed,
    keep_first,
    path_at_sight,
    path_pushed_once,
    tree_path,
)
from ..shared.random_graphs import (
    Neighbours,
    Weights,
    adjacency_lists,
    as_graph,
    reachable_pair,
    unreachable_pair,
)
from .bfs_tree import NEIGHBOURS
from .paths import PathExercise, convert_path
from .weighted import DETOUR, LATE_GAIN, WEIGHTS, graphs_in_units, make_undirected, reverse_weighted

GAINS = [(0, i, i) for i in range(1, 6)] + [(i, 6, 20 - 3 * i) for i in range(1, 6)]  # five times
ONE_MORE_TURN = [(0, 1, 13), (0, 2, 8), (1, 2, 2), (1, 3, 5), (2, 3, 8)]
# node 1 becomes cheaper three times after it was expanded, and only then beats the edge to 5
OFTEN_REOPENED = [
    (0, 1, 10),
    (0, 2, 1),
    (1, 2, 7),
    (0, 3, 1),
    (1, 3, 5),
    (0, 4, 1),
    (1, 4, 3),
    (1, 5, 20),
    (0, 5, 26),
]
REOPENED = [(0, 1, 1), (0, 2, 3), (1, 2, 1), (2, 3, 4)]


def enlarge_estimates(factor: float) -> Callable[..., Value]:
    """Return a program that multiplies all estimates by a factor."""
    return lambda n, w, estimate, s, g: astar_path(n, w, [factor * h for h in estimate], s, g)


class Astar(PathExercise):
    """Find a path of least cost with A*; any such path is right."""

    name = "astar"
    kinds = ("small", "estimate", "inconsistent", "directed", "unreachable", "start_is_goal")
    given = Record(
        neighbours=NEIGHBOURS,
        weights=WEIGHTS,
        estimate=Listed(Number()),
        start=Integer(),
        goal=Integer(),
    )
    last_rule = "shortest"
    shown = staticmethod(expand)
    slips = (
        Slip("greedy", greedy_path),
        Slip("at_sight", path_at_sight),
        Slip("closed", lambda n, w, estimate, s, g: astar_path(n, w, estimate, s, g, keep_closed)),
        Slip(
            "first_found", lambda n, w, estimate, s, g: astar_path(n, w, estimate, s, g, keep_first)
        ),
        Slip("pushed_once", path_pushed_once),
        Slip(
            "summed",
            lambda n, w, estimate, s, g: astar_path(
                n, add_estimates(n, w, estimate), [0.0] * len(n), s, g
            ),
        ),
        Slip("larger", enlarge_estimates(1.5)),
        Slip("larger", enlarge_estimates(1.1)),
        Slip("edges", lambda n, w, estimate, s, g: tree_path(n, s, g)),
        Slip(
            "undirected",
            lambda n, w, estimate, s, g: astar_path(*make_undirected(n, w), estimate, s, g),
        ),
        Slip(
            "reversed",
            lambda *given: (astar_path(*given) or [])[::-1] or None,
        ),
    )

    changes = (
        Restated("from_goal", answer=lambda path, *given: path[::-1]),
        Restated(
            "incoming", given=lambda n, weights, *others: (*reverse_weighted(n, weights), *others)
        ),
    )

    @staticmethod
    @withheld
    def reference(
        neighbours: Neighbours, weights: Weights, estimate: list[float], start: int, goal: int
    ) -> list[int] | None:
        """Return the path that the library finds."""
        return convert_path(graphs.astar(as_graph(neighbours, weights), start, goal, estimate)[0])

    source = reference

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield small graphs with zero, close and inconsistent estimates, then random ones."""
        for kind, n, rows, estimate, start, goal in (
            ("small", 2, [(0, 1, 3)], [0, 0], 0, 1),
            ("small", 3, DETOUR, [0, 0, 0], 0, 2),
            ("small", 3, [(0, 1, 2.4), (0, 2, 1.6), (1, 2, 0.6)], [0, 0, 0], 0, 1),
            ("estimate", 3, DETOUR, [2, 1, 0], 0, 2),
            ("estimate", 4, LATE_GAIN, [3, 2, 1, 0], 0, 3),
            ("estimate", 3, [(0, 1, 0.26), (1, 2, 0.26), (0, 2, 0.54)], [0.5, 0.25, 0], 0, 2),
            ("estimate", 3, [(0, 2, 2.00001), (0, 1, 1), (1, 2, 1)], [0, 0, 0], 0, 2),
            ("estimate", 3, [(0, 1, 10), (1, 2, 10), (0, 2, 20.1)], [20, 10, 0], 0, 2),
            ("inconsistent", 4, REOPENED, [0, 5, 0, 0], 0, 3),
            ("inconsistent", 4, ONE_MORE_TURN, [0, 5, 7, 0], 0, 3),
            ("inconsistent", 6, OFTEN_REOPENED, [0, 0, 10, 11, 12, 0], 0, 5),
            ("estimate", 7, GAINS, [10, 1, 1, 1, 1, 1, 0], 0, 6),
            ("start_is_goal", 2, [(0, 1, 3)], [3, 0], 1, 1),
            ("start_is_goal", 1, [], [0], 0, 0),
            ("directed", 3, [(0, 1, 1), (1, 2, 1), (2, 0, 1)], [2, 1, 0], 0, 2),
            ("directed", 3, [(0, 1, 2), (1, 2, 2), (2, 0, 1)], [0, 0, 0], 1, 0),
            ("unreachable", 3, [(0, 1, 2)], [1, 1, 0], 0, 2),
        ):
            both = adjacency_lists(n, rows, directed=kind == "directed")
            yield Case(
                kind,
                dict(zip(self.given.fields, (*both, [float(h) for h in estimate], start, goal))),
            )
        for shape, neighbours, weights in graphs_in_units(rng):
            start, goal = (unreachable_pair if shape == "parts" else reachable_pair)(
                neighbours, rng
            )
            truth = find_costs_to_goal(neighbours, weights, goal)
            jumping = np.floor(truth * rng.choice([0.0, 1.0], len(truth))).tolist()
            kinds = {
                "tree": ["small"],
                "cycle": ["estimate", "inconsistent", "start_is_goal"],
                "parts": ["unreachable"],
            }
            for kind in kinds.get(shape, ["directed"]):
                estimate = (
                    jumping
                    if kind == "inconsistent"
                    else np.floor(truth * (kind != "small") * 0.8).tolist()
                )
                last = start if kind == "start_is_goal" else goal
                bounds = np.zeros(len(truth)).tolist() if kind == "start_is_goal" else estimate
                yield Case(
                    kind, dict(zip(self.given.fields, (neighbours, weights, bounds, start, last)))
                )

    def is_good(self, case: Case, path: list[int]) -> bool:
        """Whether the path has the least cost."""
        return self.near(measure_cost(case, path), measure_cost(case, self.truth(case)))

    def describe_expected(self, case: Case) -> str:
        """Describe one shortest path and its cost."""
        truth = self.truth(case)
        value = format_value(self.as_asked(truth, case))
        if truth is None or len(truth) < 2:
            return value
        cost = format_value(measure_cost(case, truth))
        return self.message("wanted", value=value, cost=cost)


def add_estimates(neighbours: Neighbours, weights: Weights, estimate: list[float]) -> Weights:
    """Add to each weight the estimate of the node that its edge leads to.

    A search on these weights makes the mistake of adding up the estimates along the way.
    """
    return [
        [w + estimate[v] for v, w in zip(row, beside)] for row, beside in zip(neighbours, weights)
    ]


def find_costs_to_goal(neighbours: Neighbours, weights: Weights, goal: int) -> Value:
    """Return the cost from each node to the goal, shape (n,); 5 where no path exists."""
    costs = as_graph(neighbours, weights).cost_to_go(goal)
    return np.where(np.isfinite(costs), costs, 5.0)


def measure_cost(case: Case, path: list[int]) -> float:
    """Return the sum of the weights along a path whose steps are all edges."""
    neighbours, weights = case.given["neighbours"], case.given["weights"]
    return sum((weights[u][neighbours[u].index(v)] for u, v in zip(path[:-1], path[1:])), 0.0)
