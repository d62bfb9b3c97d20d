"""The base class of the exercises on paths in graphs.

Bullo & Smith, chapter 2; LaValle, section 2.2.
"""

from collections.abc import Iterator
from typing import ClassVar

import numpy as np

from .... import graphs
from ...exercise import RIGHT, Axes, Case, Restated, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Maybe, Record, Value
from ...whole_shapes import Integer
from ..shared.random_graphs import (
    Neighbours,
    adjacency_lists,
    as_graph,
    random_graphs,
    reachable_pair,
    unreachable_pair,
)
from .bfs_tree import LINE, NEIGHBOURS, RING, ROUND_TRIP, TRIANGLE
from .on_graphs import NODES, GraphExercise
from .pictures import draw_path_answer

FORK = [(0, 1), (1, 2), (0, 3)]
MOST_NODES = 60
KINDS = ("small", "cycle", "directed", "unreachable", "start_is_goal")


class PathExercise(GraphExercise):
    """An exercise whose answer is a path between two nodes, or None."""

    kinds: ClassVar[tuple[str, ...]] = KINDS
    given: ClassVar[Record] = Record(neighbours=NEIGHBOURS, start=Integer(), goal=Integer())
    answer = Maybe(NODES)
    last_rule: ClassVar[str] = ""
    shared: ClassVar[tuple[str, ...]] = ("path_in_graph", "exercise")
    changes = (
        Restated("from_goal", answer=lambda path, *given: path[::-1]),
        Restated("incoming", given=lambda neighbours, *ends: (reverse_edges(neighbours), *ends)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield graphs that can be searched by hand, then random ones."""
        for kind, n, edges, start, goal in (
            ("small", 2, [(0, 1)], 0, 1),
            ("small", 3, LINE, 0, 2),
            ("small", 4, FORK, 0, 3),
            ("small", 4, FORK, 3, 2),
            ("start_is_goal", 2, [(0, 1)], 1, 1),
            ("cycle", 3, TRIANGLE, 0, 2),
            ("cycle", 4, RING, 0, 3),
            ("cycle", 4, [*RING, (1, 3)], 1, 3),
            ("cycle", 5, [*TRIANGLE, (2, 3), (3, 4)], 0, 4),
            ("directed", 3, ROUND_TRIP, 1, 0),
            ("directed", 4, [(0, 1), (1, 2), (2, 3), (3, 0)], 0, 3),
            ("unreachable", 3, [(0, 1)], 0, 2),
            ("start_is_goal", 1, [], 0, 0),
        ):
            yield from self.make_case(
                kind, adjacency_lists(n, edges, directed=kind == "directed")[0], start, goal
            )
        # the only edge leads the other way
        yield from self.make_case("unreachable", [[], [0]], 0, 1)
        yield from self.make_case("unreachable", [[1], []], 1, 0)
        for shape, neighbours, _ in random_graphs(rng):
            kind = {"tree": "small", "parts": "unreachable"}.get(shape, shape)
            yield from self.make_case(
                kind,
                neighbours,
                *(unreachable_pair if shape == "parts" else reachable_pair)(neighbours, rng),
            )
            if shape == "cycle":
                yield from self.make_case(
                    "start_is_goal", neighbours, *(int(rng.integers(len(neighbours))),) * 2
                )
        longest = adjacency_lists(MOST_NODES, [(u, u + 1) for u in range(MOST_NODES - 1)])[0]
        yield from self.make_case("small", longest, 0, MOST_NODES - 1)

    def make_case(self, kind: str, neighbours: Neighbours, start: int, goal: int) -> Iterator[Case]:
        """The case of a question."""
        yield Case(kind, {"neighbours": neighbours, "start": start, "goal": goal})

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that every step is an edge, and then what this exercise demands besides."""
        rule = find_path_fault(case, value, self.truth(case)) or (
            self.last_rule if value and not self.is_good(case, value) else ""
        )
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def is_good(self, case: Case, path: list[int]) -> bool:
        """Whether a path along edges from start to goal is what this exercise asks for."""
        raise NotImplementedError

    def describe_expected(self, case: Case) -> str:
        """Describe one right path."""
        truth = self.truth(case)
        value = format_value(self.as_asked(truth, case))
        return value if truth is None or len(truth) < 2 else self.message("wanted", value=value)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the graph, a right path and the student's."""
        draw_path_answer(
            self, case, outcome.value if isinstance(outcome, Answer) else None, self.truth(case), ax
        )


def find_path_fault(case: Case, path: list[int] | None, truth: list[int] | None) -> str:
    """Return the rule that a path from start to goal breaks, or ""."""
    neighbours, start, goal = (case.given[name] for name in ("neighbours", "start", "goal"))
    if path is None:
        return "" if truth is None else "alone" if start == goal else "missing"
    if truth is None:
        return "unreachable"
    if not path or path[0] != start or path[-1] != goal:
        return "ends"
    if start == goal and len(path) > 1:
        return "alone"
    n = len(neighbours)
    for u, v in zip(path[:-1], path[1:]):
        if not (0 <= u < n and v in neighbours[u]):
            return "one_way" if 0 <= v < n and u in neighbours[v] else "edge"
    return ""


def reverse_edges(neighbours: Neighbours) -> Neighbours:
    """Return for each node the nodes from which an edge leads to it."""
    nodes = range(len(neighbours))
    return [[u for u in nodes if v in neighbours[u]] for v in nodes]


def convert_path(path: Value) -> list[int] | None:
    """Convert a path of the library to a list of ints; None stays None."""
    return None if path is None else [int(u) for u in path]


def search_depth_first(neighbours: Neighbours, start: int, goal: int) -> list[int] | None:
    """Return the path of a depth-first search, or None."""
    return convert_path(graphs.dfs_path(as_graph(neighbours), start, goal))
