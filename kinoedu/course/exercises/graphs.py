"""Exercises on trees in graphs: the breadth-first tree, and the paths that parents hold. Bullo & Smith, chapter 2."""

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from ... import graphs
from ...errors import InvalidGraph
from ...graphs.bfs import breadth_first
from ...words import say
from ..exercise import CONTRACT, RIGHT, Case, Slip, ValueExercise, Verdict, spoken
from ..outcomes import Answer, Outcome
from ..shapes import Listed, Maybe, Record
from ..whole_shapes import Whole
from .graph_pictures import draw_pointers, draw_tree_answer
from .graph_slips import depths, first_in, followed, undirected
from .random_graphs import Neighbours, as_graph, lists, random_graphs

NODES = Listed(Whole())
NEIGHBOURS = Listed(NODES)
LINE, RING = [(0, 1), (1, 2)], [(0, 1), (1, 2), (2, 3), (0, 3)]
ROUND_TRIP, TRIANGLE = [(0, 1), (1, 2), (2, 0)], [(0, 1), (0, 2), (1, 2)]


class OnGraph(ValueExercise):
    """An exercise of lesson 4, whose answers are lists of nodes, or None."""

    lesson = "04_graph_search"

    def same(self, value: Any, truth: Any) -> bool:
        """The same nodes in the same order."""
        return (None if value is None else list(value)) == (None if truth is None else list(truth))


class BfsTree(OnGraph):
    """Adjacency lists and a start to the parents in any breadth-first tree."""

    name = "bfs_tree"
    kinds = ("small", "cycle", "directed", "unreachable")
    given = Record(neighbours=NEIGHBOURS, start=Whole())
    answer = NODES
    shown = staticmethod(breadth_first)
    variants = ("smallest", "largest")
    slips = (
        Slip("order", lambda neighbours, start: first_in(neighbours, start)[1]),
        Slip("stack", lambda neighbours, start: first_in(neighbours, start, at=-1)[0]),
        Slip("late", lambda neighbours, start: first_in(neighbours, start, late=True)[0]),
        Slip("own_parent", lambda neighbours, start: with_start(first_in(neighbours, start)[0], start, start)),
        Slip("zeros", lambda neighbours, start: unmarked(neighbours, start)),
        Slip("from_one", lambda neighbours, start: [p + 1 for p in first_in(neighbours, start)[0]]),
        Slip("distances", depths),
        Slip("undirected", lambda neighbours, start: first_in(undirected(neighbours), start)[0]),
    )

    @staticmethod
    def reference(neighbours: Neighbours, start: int) -> list[int]:
        """The library's tree."""
        return [int(p) for p in graphs.bfs_tree(as_graph(neighbours), start)]

    source = reference

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Graphs that fit on a finger first."""
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
            yield Case(kind, {"neighbours": lists(n, edges, directed=kind == "directed")[0], "start": start})
        for shape, neighbours, _ in random_graphs(rng):
            kind = {"tree": "small", "parts": "unreachable"}.get(shape, shape)
            yield Case(kind, {"neighbours": neighbours, "start": int(rng.integers(len(neighbours)))})

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """Each reached node's parent has an edge to it, and is one edge nearer to the start; ties go as the contract says."""
        rule = tree_fault(case.given["neighbours"], case.given["start"], value)
        if not rule and self.variant and list(value) != self.truth(case):
            rule = CONTRACT
        return Verdict(0.0, rule, self.wanted(case)) if rule else RIGHT

    def truth(self, case: Case) -> Any:
        """One such tree: the library's, or the contract's."""
        if not self.variant:
            return super().truth(case)
        return tree_of_extremes(case.given["neighbours"], case.given["start"], min if self.variant == "smallest" else max)

    def wanted(self, case: Case) -> str:
        """One such tree."""
        if self.variant:
            return spoken(self.truth(case))
        return say("bfs_tree.wanted", value=spoken(self.truth(case)))

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The graph, how far each node is, and the student's arrows from parents to children."""
        from ...figures import plane

        far = graphs.bfs(as_graph(case.given["neighbours"]), case.given["start"]).cost
        value, wanted = outcome.value if isinstance(outcome, Answer) else None, self.truth(case) if self.variant else None
        draw_tree_answer(self, case, value, far, ax, wanted)
        if self.judge(case, outcome).rule == CONTRACT:
            plane.title(self.words("pictures.contract"), ax)


def tree_of_extremes(neighbours: Neighbours, start: int, choose: Callable[[list[int]], int]) -> list[int]:
    """The breadth-first tree in which each node chooses among all that could be its parent."""
    far = graphs.bfs(as_graph(neighbours), start).cost
    able: list[list[int]] = [[] for _ in neighbours]
    for v, row in enumerate(neighbours):
        for u in row:
            if np.isfinite(far[v]) and far[v] + 1 == far[u]:
                able[u].append(v)
    return [choose(nodes) if nodes else -1 for nodes in able]


def with_start(parent: list[int], start: int, value: int) -> list[int]:
    """The parents with another one for the start."""
    return [*parent[:start], value, *parent[start + 1 :]]


def unmarked(neighbours: Neighbours, start: int) -> list[int]:
    """Parents that were 0 before the search began, where -1 was meant; that of the start is right."""
    parent, order = first_in(neighbours, start)
    return [parent[u] if u in order else 0 for u in range(len(neighbours))]


def tree_fault(neighbours: Neighbours, start: int, parent: list[int]) -> str:
    """The rule that parents break, or ""."""
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


class ExtractPath(OnGraph):
    """Parents and a goal to the nodes from the root to it."""

    name = "extract_path"
    kinds = ("root", "tree", "forest", "circle")
    given = Record(parent=NODES, goal=Whole())
    answer = Maybe(NODES)
    shown = staticmethod(graphs.extract_path)
    slips = (
        Slip("reversed", lambda parent, goal: (followed(parent, goal) or [])[::-1] or None),
        Slip("no_goal", lambda parent, goal: (followed(parent, goal) or [])[:-1]),
        Slip("no_root", lambda parent, goal: (followed(parent, goal) or [])[1:]),
        Slip("root_none", lambda parent, goal: None if parent[goal] == -1 else followed(parent, goal)),
        Slip("one_step", lambda parent, goal: [p for p in (parent[goal], goal) if p != -1]),
        Slip("parents", lambda parent, goal: [parent[u] for u in followed(parent, goal) or []]),
    )

    @staticmethod
    def reference(parent: list[int], goal: int) -> list[int] | None:
        """The library's path; None where it says that parents lead to no root."""
        try:
            return [int(u) for u in graphs.extract_path(np.array(parent, np.int64), goal)]
        except InvalidGraph:
            return None

    source = reference

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """A few parents by hand; then trees, forests and circles with tails."""
        for kind, parent, goal in (
            ("root", [-1, 0], 0),
            ("tree", [-1, 0, 1], 2),
            ("tree", [-1, 0, 0, 2], 3),
            ("tree", [2, 0, -1], 1),
            ("forest", [-1, 0, -1, 2], 3),
            ("root", [1, -1, 1], 1),
            ("circle", [1, 0], 0),
            ("circle", [0], 0),
            ("circle", [1, 2, 1, 0], 3),
        ):
            yield Case(kind, {"parent": parent, "goal": goal})
        for n in (4, 5, 6, 7, 8, 10, 12, 16, 24, 40, 60):
            for kind in self.kinds:
                yield Case(kind, {"parent": (found := random_parents(kind, n, rng))[0], "goal": found[1]})

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """Each node and the arrow from its parent to it; the path, and the student's."""
        draw_pointers(self, case, outcome.value if isinstance(outcome, Answer) else None, self.truth(case), ax)


def random_parents(kind: str, n: int, rng: np.random.Generator) -> tuple[list[int], int]:
    """Parents of n nodes, numbered at random, and a goal.

    "root": one tree, whose root it is; "tree": low in it; "forest": low in the second of two; "circle": in a circle, or on a tail.
    """
    name, low = rng.permutation(n), n // 2 if kind == "forest" else 0
    parent = [-1] * n
    for i in range(1, n):
        above = int(rng.integers(max(i - 3, low if i > low else 0), i))
        if i != low:
            parent[name[i]] = int(name[i - 1 if kind == "circle" and i < n - 1 else above])
    if kind == "circle":
        parent[name[0]] = int(name[n - 2])
    return parent, int(name[0 if kind == "root" else n - 1 - int(rng.integers(2))])
