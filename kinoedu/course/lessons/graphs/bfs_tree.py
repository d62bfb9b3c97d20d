"""The exercise `bfs_tree`. Bullo & Smith, chapter 2."""

from collections.abc import Iterator

import numpy as np

from .... import graphs
from ....graphs.bfs import breadth_first
from ....messages import get_message
from ...exercise import CONTRACT, RIGHT, Axes, Case, Slip, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Record, Value
from ...whole_shapes import Integer
from ...withheld import withheld
from ..shared.graph_slips import (
    depths,
    search_breadth_first,
    search_by_stack,
    search_marking_late,
    undirected,
    visit_breadth_first,
)
from ..shared.random_graphs import Neighbours, adjacency_lists, as_graph, random_graphs
from .on_graphs import NODES, GraphExercise
from .pictures import draw_tree_answer

NEIGHBOURS = Listed(NODES)
LINE, RING = [(0, 1), (1, 2)], [(0, 1), (1, 2), (2, 3), (0, 3)]
ROUND_TRIP, TRIANGLE = [(0, 1), (1, 2), (2, 0)], [(0, 1), (0, 2), (1, 2)]


class BfsTree(GraphExercise):
    """Compute the parents of a breadth-first tree from adjacency lists and a start.

    Any breadth-first tree is right, unless a variant says which parent to choose.
    """

    name = "bfs_tree"
    kinds = ("small", "cycle", "directed", "unreachable")
    given = Record(neighbours=NEIGHBOURS, start=Integer())
    answer = NODES
    shown = staticmethod(breadth_first)
    variants = ("smallest", "largest")
    slips = (
        Slip("order", visit_breadth_first),
        Slip("stack", search_by_stack),
        Slip("late", search_marking_late),
        Slip(
            "own_parent",
            lambda neighbours, start: replace_parent(
                search_breadth_first(neighbours, start), start, start
            ),
        ),
        Slip("zeros", lambda neighbours, start: mark_unreached_zero(neighbours, start)),
        Slip(
            "from_one",
            lambda neighbours, start: [p + 1 for p in search_breadth_first(neighbours, start)],
        ),
        Slip("distances", depths),
        Slip(
            "undirected",
            lambda neighbours, start: search_breadth_first(undirected(neighbours), start),
        ),
    )

    @staticmethod
    @withheld
    def reference(neighbours: Neighbours, start: int) -> list[int]:
        """Return the parents that the library finds."""
        return [int(p) for p in graphs.bfs_tree(as_graph(neighbours), start)]

    source = reference

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield graphs that can be searched by hand, then random ones."""
        for kind, n, edges, start in (
            ("small", 2, [(0, 1)], 0),
            ("small", 3, LINE, 0),
            ("small", 3, LINE, 1),
            ("cycle", 3, TRIANGLE, 0),
            ("cycle", 4, RING, 2),
            ("directed", 3, ROUND_TRIP, 1),
            ("directed", 3, TRIANGLE, 0),
            ("unreachable", 3, [(0, 1)], 1),
            ("unreachable", 1, [], 0),
        ):
            yield Case(
                kind,
                {
                    "neighbours": adjacency_lists(n, edges, directed=kind == "directed")[0],
                    "start": start,
                },
            )
        for shape, neighbours, _ in random_graphs(rng):
            kind = {"tree": "small", "parts": "unreachable"}.get(shape, shape)
            yield Case(
                kind, {"neighbours": neighbours, "start": int(rng.integers(len(neighbours)))}
            )

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that each parent has an edge to its child and is one edge nearer to the start.

        With a variant, each parent must also be the one that the contract names.
        """
        rule = find_tree_fault(case.given["neighbours"], case.given["start"], value)
        if not rule and self.variant and list(value) != self.truth(case):
            rule = CONTRACT
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def truth(self, case: Case) -> Value:
        """Return one right tree: the library's, or the one that the contract names."""
        if not self.variant:
            return super().truth(case)
        return choose_parents(case.given["neighbours"], case.given["start"], self.variant)

    def describe_expected(self, case: Case) -> str:
        """Describe one right tree."""
        if self.variant:
            return format_value(self.truth(case))
        return get_message("bfs_tree.wanted", value=format_value(self.truth(case)))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the graph, each node's distance from the start, and the student's tree."""
        from ....figures import plane

        far = graphs.bfs(as_graph(case.given["neighbours"]), case.given["start"]).cost
        value = outcome.value if isinstance(outcome, Answer) else None
        wanted = self.truth(case) if self.variant else None
        draw_tree_answer(self, case, value, far, ax, wanted)
        if self.judge(case, outcome).rule == CONTRACT:
            plane.title(self.message("pictures.contract"), ax)


@withheld
def choose_parents(neighbours: Neighbours, start: int, variant: str) -> list[int]:
    """Build the breadth-first tree whose parents are the smallest or largest of all candidates."""
    choose = min if variant == "smallest" else max
    far = graphs.bfs(as_graph(neighbours), start).cost
    able: list[list[int]] = [[] for _ in neighbours]
    for v, row in enumerate(neighbours):
        for u in row:
            if np.isfinite(far[v]) and far[v] + 1 == far[u]:
                able[u].append(v)
    return [choose(nodes) if nodes else -1 for nodes in able]


def replace_parent(parent: list[int], start: int, value: int) -> list[int]:
    """Return the parents with another value at the start."""
    return [*parent[:start], value, *parent[start + 1 :]]


def mark_unreached_zero(neighbours: Neighbours, start: int) -> list[int]:
    """Return parents that are 0 instead of -1 for unreached nodes."""
    parent, order = search_breadth_first(neighbours, start), visit_breadth_first(neighbours, start)
    return [parent[u] if u in order else 0 for u in range(len(neighbours))]


def find_tree_fault(neighbours: Neighbours, start: int, parent: list[int]) -> str:
    """Return the rule that the parents break, or ""."""
    far = graphs.bfs(as_graph(neighbours), start).cost
    if len(parent) != len(neighbours):
        return "length"
    if parent[start] != -1:
        return "start"
    reached = [u for u in range(len(parent)) if np.isfinite(far[u]) and u != start]
    if any(parent[u] != -1 for u in range(len(parent)) if np.isinf(far[u])):
        return "unreached"
    if any(not 0 <= parent[u] < len(parent) or u not in neighbours[parent[u]] for u in reached):
        return "edge"
    return "nearer" if any(far[parent[u]] + 1 != far[u] for u in reached) else ""
