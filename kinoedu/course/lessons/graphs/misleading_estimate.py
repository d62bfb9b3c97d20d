"""The exercise "break it" of lesson 4: an estimate with which A* misses the shortest path."""

from collections.abc import Iterator

import numpy as np

from .... import graphs
from ....messages import get_message
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Number, Record, Together, Value
from ...whole_shapes import Integer
from ..shared.random_graphs import as_graph
from .bfs_tree import NEIGHBOURS
from .paths import convert_path
from .pictures import draw_misled
from .weighted import WEIGHTS

MOST_NODES = 20


class MisleadingEstimate(Exercise):
    """Give a graph and an estimate for which A* returns a path that is not the shortest."""

    name = "misleading_estimate"
    lesson = "04_graph_search"
    kinds = ("valid", "misleads", "smallest")
    given = Record()
    answer = Together((NEIGHBOURS, WEIGHTS, Listed(Number()), Integer(), Integer()))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the same question three times; each time the answer must fulfil more."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that the graph is valid, that it misleads A*, and that it has three nodes."""
        rule = find_graph_fault(*value)
        if not rule and case.kind != "valid":
            found, best = find_both_costs(*value)
            if np.isinf(best):
                rule = "path"
            elif found <= best + 1e-6 * (1.0 + best):
                rule = "misleads"
            elif case.kind == "smallest" and len(value[0]) > 3:
                rule = "smallest"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer to a case must be."""
        return get_message(f"misleading_estimate.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the graph, the path that A* returns, and a shortest path."""
        value = (
            outcome.value
            if isinstance(outcome, Answer) and not find_graph_fault(*outcome.value)
            else None
        )
        draw_misled(self, value, (None, None) if value is None else find_both_paths(*value), ax)


def find_graph_fault(
    neighbours: Value, weights: Value, estimate: Value, start: int, goal: int
) -> str:
    """Return the rule that makes this an invalid input of A*, or ""."""
    n = len(neighbours)
    if (
        not 0 < n <= MOST_NODES
        or len(weights) != n
        or len(estimate) != n
        or not (0 <= start < n and 0 <= goal < n)
    ):
        return "valid"
    if any(len(row) != len(beside) for row, beside in zip(neighbours, weights)):
        return "valid"
    if any(not 0 <= v < n or v == u for u, row in enumerate(neighbours) for v in row):
        return "valid"
    if any(len(set(row)) < len(row) for row in neighbours):
        return "valid"
    numbers = [*estimate, *(w for row in weights for w in row)]
    if not all(0.0 <= number <= 1e6 for number in numbers):
        return "range"
    return "at_goal" if estimate[goal] != 0.0 else ""


def find_both_paths(
    neighbours: Value, weights: Value, estimate: Value, start: int, goal: int
) -> tuple[Value, Value]:
    """Return the path of A* with this estimate, and a shortest one; None where there is none."""
    graph = as_graph(neighbours, weights)
    return convert_path(graphs.astar(graph, start, goal, estimate)[0]), convert_path(
        graphs.astar(graph, start, goal)[0]
    )


def find_both_costs(
    neighbours: Value, weights: Value, estimate: Value, start: int, goal: int
) -> tuple[float, float]:
    """Return the cost of the path that A* finds with an estimate, and the least cost.

    Returns
    -------
    (found, best) : two floats; infinite where no path exists.
    """
    graph = as_graph(neighbours, weights)
    found, best = graphs.astar(graph, start, goal, estimate)[1], graphs.astar(graph, start, goal)[1]
    return float(found.cost[goal]), float(best.cost[goal])
