"""The exercise `dijkstra`. Bullo & Smith, chapter 5; LaValle, section 2.2."""

from collections.abc import Iterator

import numpy as np

from .... import graphs
from ....graphs.search import expand
from ...exercise import Axes, Case, Change, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ...whole_shapes import Integer
from ...withheld import withheld
from ..shared.graph_slips import (
    count_last_edge,
    depths,
    dijkstra_costs,
    keep_first,
    lightest_first,
    overwrite,
    queue_costs,
)
from ..shared.random_graphs import Neighbours, Weights, adjacency_lists, as_graph
from .bfs_tree import NEIGHBOURS
from .pictures import draw_costs
from .weighted import DETOUR, LATE_GAIN, WEIGHTS, graphs_in_units, make_undirected, reverse_weighted

NEGATIVE = (3.0, 1.0, 0.25, 1e-5)
LITTLE_GAIN = [(0, 2, 2.00001), (0, 1, 1), (1, 2, 1)]
LIGHT_EDGES = [(0, 1, 3), (0, 3, 4), (1, 2, 3), (2, 3, 1), (2, 4, 1)]


class Dijkstra(ValueExercise):
    """Compute the least cost of every node from adjacency lists, weights and a start."""

    name = "dijkstra"
    lesson = "04_graph_search"
    kinds = ("small", "detour", "directed", "unreachable", "negative")
    given = Record(neighbours=NEIGHBOURS, weights=WEIGHTS, start=Integer())
    answer = Numbers(("n",))
    shown = staticmethod(expand)
    slips = (
        Slip(
            "edges",
            lambda neighbours, weights, start: [
                float(d) if d >= 0 else np.inf for d in depths(neighbours, start)
            ],
        ),
        Slip(
            "first_found",
            lambda neighbours, weights, start: dijkstra_costs(
                neighbours, weights, start, keep_first
            ),
        ),
        Slip(
            "last_edge",
            lambda neighbours, weights, start: dijkstra_costs(
                neighbours, weights, start, count_last_edge
            ),
        ),
        Slip(
            "overwritten",
            lambda neighbours, weights, start: dijkstra_costs(
                neighbours, weights, start, overwrite
            ),
        ),
        Slip("in_turn", queue_costs),
        Slip("lightest_first", lightest_first),
        Slip(
            "undirected",
            lambda neighbours, weights, start: dijkstra_costs(
                *make_undirected(neighbours, weights), start
            ),
        ),
        Slip(
            "minus_one",
            lambda neighbours, weights, start: replace_infinity(
                dijkstra_costs(neighbours, weights, start), -1.0
            ),
        ),
        Slip(
            "zero",
            lambda neighbours, weights, start: replace_infinity(
                dijkstra_costs(neighbours, weights, start), 0.0
            ),
        ),
    )

    changes = (
        Restated(
            "to_start", given=lambda n, weights, start: (*reverse_weighted(n, weights), start)
        ),
        Change("squared", lambda costs, n, weights, start: costs(n, square_each(weights), start)),
    )

    @staticmethod
    @withheld
    def reference(neighbours: Neighbours, weights: Weights, start: int) -> list[float]:
        """Return the library's costs.

        Raises
        ------
        ValueError
            Where a weight is negative.
        """
        return graphs.dijkstra(as_graph(neighbours, weights), start).cost.tolist()

    source = reference

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield graphs that can be searched by hand, then random ones, also negative weights."""
        for kind, n, rows, start in (
            ("small", 2, [(0, 1, 3)], 0),
            ("small", 3, [(0, 1, 2), (1, 2, 3)], 0),
            ("detour", 3, DETOUR, 0),
            ("detour", 4, LATE_GAIN, 0),
            ("detour", 5, LIGHT_EDGES, 0),
            ("detour", 3, LITTLE_GAIN, 0),
            ("small", 3, [(0, 1, 1 / 3), (1, 2, 0.0004)], 0),
            ("directed", 3, [(0, 1, 2), (1, 2, 2), (2, 0, 1)], 0),
            ("unreachable", 3, [(0, 1, 2)], 1),
            ("detour", 3, [(0, 1, 0), (1, 2, 0.5), (0, 2, 1)], 2),
            ("negative", 3, [(0, 1, 2), (1, 2, -1)], 0),
            ("negative", 4, [(0, 1, 2), (2, 3, -1)], 0),
            ("negative", 2, [(0, 1, -0.5)], 0),
            ("negative", 3, [(0, 1, 1), (0, 2, -1)], 0),
            ("negative", 3, [(0, 1, 2), (1, 2, 1), (2, 0, -0.001)], 0),
            ("negative", 2, [(0, 1, -1e-9)], 0),
            ("unreachable", 1, [], 0),
        ):
            directed = kind in ("directed", "negative")
            yield Case(
                kind,
                dict(zip(self.given.fields, (*adjacency_lists(n, rows, directed=directed), start))),
            )
        for shape, neighbours, weights in graphs_in_units(rng):
            kind = {"tree": "small", "cycle": "detour", "parts": "unreachable"}.get(shape, shape)
            start = int(rng.integers(len(neighbours)))
            yield Case(kind, {"neighbours": neighbours, "weights": weights, "start": start})
            if kind == "directed":
                spoilt = [row.copy() for row in weights]
                row = spoilt[int(rng.integers(len(spoilt)))]
                row[int(rng.integers(len(row)))] = -float(rng.choice(NEGATIVE))
                yield Case(
                    "negative", {"neighbours": neighbours, "weights": spoilt, "start": start}
                )

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Compare the costs; infinity for a node that can be reached breaks a rule of its own."""
        verdict, truth = super().value_verdict(case, value), self.truth(case)
        if verdict.is_right or len(value) != len(truth):
            return verdict
        is_lost = bool((np.isinf(value) & np.isfinite(truth)).any())
        return verdict._replace(rule="reached") if is_lost else verdict

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the graph with its weights, and the true and the student's cost of every node."""
        draw_costs(
            self, case, outcome.value if isinstance(outcome, Answer) else None, self.truth(case), ax
        )


def square_each(weights: Weights) -> Weights:
    """Return the squares of the weights; negative ones stay negative."""
    return [[w * abs(w) for w in row] for row in weights]


def replace_infinity(costs: list[float], other: float) -> list[float]:
    """Return the costs with infinite ones replaced by `other`."""
    return [cost if np.isfinite(cost) else other for cost in costs]
