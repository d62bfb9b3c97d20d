"""The exercise on shortest paths along a roadmap. Bullo & Smith, chapters 2 and 5."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .... import graphs
from ....geometry.checks import Array
from ....messages import get_message
from ....planners import dijkstra_path
from ...exercise import RIGHT, Axes, Case, Restated, Slip, ValueExercise, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Maybe, Number, Numbers, Record, Together, Value
from ...whole_shapes import Integer, Integers
from ...withheld import withheld
from ..shared.graph_slips import fewest_edges
from ..shared.random_graphs import random_rows
from .rules import set_title

Pairs = NDArray[np.int64]
PathAndLength = tuple[list[int] | None, float]
LITTLE_GAIN = [(0, 0), (4, 0), (1, 1.00001), (3, 1)]
LATE_GAIN = [(0, 0), (4, 0), (1, 1), (3, 1.00001)]
NEAR_BUT_LATE = [(0, 0), (0, 1), (2, 0), (4, 0)]
DETOUR = [(0, 0), (2, 3), (4, 0), (1, -1), (3, -1)]


@withheld
def find_shortest(nodes: Array, edges: Pairs, start: int, goal: int) -> PathAndLength:
    """Return a shortest path and its length."""
    return find_lightest(nodes, edges, measure_edges(nodes, edges), start, goal)


def find_lightest(
    nodes: Array, edges: Pairs, weights: Array, start: int, goal: int, *, directed: bool = False
) -> PathAndLength:
    """Return a path of least weight and its length, or (None, inf)."""
    return measure_path(
        nodes,
        dijkstra_path(graphs.Graph(len(nodes), edges, weights, directed=directed), start, goal),
    )


def find_fewest_edges(nodes: Array, edges: Pairs, start: int, goal: int) -> PathAndLength:
    """Return a path with the fewest edges and its length."""
    return measure_path(nodes, fewest_edges(graphs.Graph(len(nodes), edges), start, goal))


def measure_path(nodes: Array, path: Pairs | None) -> PathAndLength:
    """Return a path as node indices and its length, or (None, inf)."""
    if path is None:
        return None, np.inf
    return path.tolist(), float(measure_edges(nodes, np.column_stack([path[:-1], path[1:]])).sum())


def measure_edges(nodes: Array, pairs: Pairs) -> Array:
    """Return the Euclidean lengths of edges, (m,)."""
    found: Array = np.sqrt(((nodes[pairs[:, 0]] - nodes[pairs[:, 1]]) ** 2).sum(axis=1))
    return found


def search_and_sum_by(weigh: Any) -> Value:
    """Return a program that finds the path by other weights, and adds up those."""

    def answer(nodes: Array, edges: Pairs, start: int, goal: int) -> PathAndLength:
        weights = weigh(nodes, edges)
        path, _ = find_lightest(nodes, edges, weights, start, goal)
        if path is None:
            return None, np.inf
        steps = np.sort(np.column_stack([path[:-1], path[1:]]), axis=1)
        of = dict(zip(map(tuple, np.sort(edges, axis=1).tolist()), weights.tolist()))
        return path, float(sum(of[pair] for pair in map(tuple, steps.tolist())))

    return answer


def reverse_path(found: PathAndLength, *given: Value) -> PathAndLength:
    """Return the path from its end to its beginning, and the length."""
    path, length = found
    return (None if path is None else path[::-1]), length


def subtract_beeline(
    found: PathAndLength, nodes: Array, edges: Pairs, start: int, goal: int
) -> PathAndLength:
    """Return the path, and its length beyond that of the straight line."""
    return found[0], found[1] - float(np.linalg.norm(nodes[goal] - nodes[start]))


def add_beeline(
    found: PathAndLength, nodes: Array, edges: Pairs, start: int, goal: int
) -> PathAndLength:
    """Return the path and its length, which is given beyond that of the straight line."""
    return found[0], found[1] + float(np.linalg.norm(nodes[goal] - nodes[start]))


class ShortestPath(ValueExercise):
    """Find a shortest path between two nodes of a roadmap, and its length."""

    name = "shortest_path"
    lesson = "08_roadmaps"
    kinds = ("small", "detour", "many", "space", "apart", "same")
    given = Record(
        nodes=Numbers(("n", "d")), edges=Integers(("m", 2)), start=Integer(), goal=Integer()
    )
    answer = Together((Maybe(Integers(("k",))), Number()))
    reference = staticmethod(find_shortest)
    source = staticmethod(find_shortest)
    slips = (
        Slip("fewest", find_fewest_edges),
        Slip("counted", search_and_sum_by(lambda nodes, edges: np.ones(len(edges)))),
        Slip("squared", search_and_sum_by(lambda nodes, edges: measure_edges(nodes, edges) ** 2)),
        Slip(
            "one_way",
            lambda nodes, edges, s, g: find_lightest(
                nodes, edges, measure_edges(nodes, edges), s, g, directed=True
            ),
        ),
        Slip("plane", lambda nodes, edges, s, g: find_shortest(nodes[:, :2], edges, s, g)),
        Slip(
            "straight",
            lambda nodes, edges, s, g: (
                find_shortest(nodes, edges, s, g)[0],
                float(np.linalg.norm(nodes[s] - nodes[g])),
            ),
        ),
    )

    changes = (
        Restated("from_goal", answer=reverse_path),
        Restated("detour", answer=subtract_beeline, usual_answer=add_beeline),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield an edge, a chain and a shorter detour of more edges, then random roadmaps.

        Some of the random roadmaps have nodes in space.
        """
        for kind, nodes, edges, s, g in (
            ("small", [(0, 0), (3, 4)], [(0, 1)], 0, 1),
            ("small", [(0, 0), (3, 4)], [(0, 1)], 1, 0),
            ("small", [(0, 0), (3, 4), (6, 0)], [(0, 1), (1, 2)], 2, 0),
            ("detour", DETOUR, [(0, 1), (1, 2), (0, 3), (3, 4), (2, 4)], 0, 2),
            # node 1 is nearer to the start than node 2, and the goal is first found from there
            ("many", NEAR_BUT_LATE, [(0, 1), (1, 3), (0, 2), (2, 3)], 0, 3),
            ("small", [(0, 0), (3e6, 4e6), (6e6, 0)], [(0, 1), (1, 2)], 0, 2),
            ("space", [(0, 0, 0), (3, 4, 0), (3, 4, 5)], [(0, 1), (1, 2)], 0, 2),
            ("apart", [(0, 0), (3, 4), (6, 0)], [(0, 1)], 0, 2),
            ("same", [(0, 0), (3, 4)], [(0, 1)], 1, 1),
            ("same", [(0, 0), (3, 4), (6, 0)], [(0, 1)], 2, 2),
            ("same", [(0, 0), (3, 4)], [], 0, 0),
            ("apart", [(0, 0), (3, 4)], [], 0, 1),
            ("small", [(0, 0), (0, 0), (3, 4)], [(0, 1), (1, 2)], 0, 2),
            # the second way is shorter by 0.00001
            ("detour", LITTLE_GAIN, [(0, 2), (2, 1), (0, 3), (3, 1)], 0, 1),
            # the first is, and an estimate that is too large takes the second node first
            ("detour", LATE_GAIN, [(0, 2), (2, 1), (0, 3), (3, 1)], 0, 1),
        ):
            yield make_case(kind, np.array(nodes, float), np.array(edges, np.int64), s, g)
        for n in (3, 4, 5, 6, 7, 8, 10, 12, 16, 24, 40, 60):
            for kind, shape in zip(
                self.kinds, ("tree", "cycle", "cycle", "cycle", "parts", "cycle")
            ):
                size = max(n, 4)
                rows = random_rows(shape, size, rng)
                pairs = np.unique(np.sort([row[:2] for row in rows], axis=1), axis=0)
                flipped = rng.random(len(pairs)) < 0.5
                pairs[flipped] = pairs[flipped, ::-1]
                places = np.round(rng.uniform(-10, 10, (size, 3 if kind == "space" else 2)), 2)
                yield make_case(kind, places, pairs, *draw_ends(rng, kind, size, pairs))

    def same(self, value: Value, truth: Value) -> bool:
        """Whether the lengths are equal, and the paths too where both are given."""
        (path, far), (right, least) = value, truth
        both = (path is None) == (right is None)
        return both and self.near(far, least) and (path is None or list(path) == list(right))

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that the path follows edges from start to goal, and its length.

        No other path may be shorter. Without a path, None and inf are right.
        """
        (path, far), (right, least) = value, self.truth(case)
        if path is None or right is None:
            if path is None and right is None and far == np.inf:
                return RIGHT
            return Verdict(
                0.0, "apart" if right is None else "missed", self.describe_expected(case)
            )
        rule = self.fault_of(case, path)
        if not rule:
            steps = np.column_stack([path[:-1], path[1:]])
            long = float(measure_edges(case.given["nodes"], steps).sum())
            if not self.near(long, least):
                rule = "shortest"
            elif not self.near(far, least):
                rule = "length"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def fault_of(self, case: Case, path: Pairs) -> str:
        """Return the rule that a path from start to goal breaks, or ""."""
        _, edges, start, goal = case.given.values()
        if len(path) == 0 or path[0] != start or path[-1] != goal:
            return "ends"
        known = {*map(tuple, edges.tolist()), *map(tuple, edges[:, ::-1].tolist())}
        return (
            "edges"
            if any(step not in known for step in zip(path[:-1].tolist(), path[1:].tolist()))
            else ""
        )

    def describe_expected(self, case: Case) -> str:
        """Describe one right path and its length."""
        path, far = self.as_asked(self.truth(case), case)
        return (
            get_message("shortest_path.wanted", path=format_value(path), length=format_value(far))
            if path is not None
            else "(None, inf)"
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the roadmap, a shortest path and the student's."""
        from .pictures import draw_shortest_path

        value = outcome.value[0] if isinstance(outcome, Answer) else None
        draw_shortest_path(case.given["nodes"], case.given["edges"], self.truth(case)[0], value, ax)
        set_title(self, case, ax)


def make_case(kind: str, nodes: Array, edges: Pairs, start: int, goal: int) -> Case:
    """Return a case of two nodes of a roadmap."""
    return Case(kind, {"nodes": nodes, "edges": edges.reshape(-1, 2), "start": start, "goal": goal})


def draw_ends(rng: np.random.Generator, kind: str, n: int, edges: Pairs) -> tuple[int, int]:
    """Draw a start and a goal: far apart, in different components, or the same."""
    start = int(rng.integers(n))
    far = graphs.bfs(graphs.Graph(n, edges), start).cost
    if kind == "same":
        return start, start
    reached = np.isfinite(far)
    return start, int(np.argmin(reached)) if kind == "apart" else int(
        np.argmax(np.where(reached, far, -1))
    )
