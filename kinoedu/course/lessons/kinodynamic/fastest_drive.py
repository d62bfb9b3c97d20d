"""The exercise on the fastest path through a roadmap of directed drives. LaValle, section 2.2.2."""

from collections.abc import Callable, Iterator, Sequence
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from .... import graphs
from ....geometry.checks import Array
from ....planners import dijkstra_path
from ....planners.driving.kinodynamic_prm import find_shortest_drive
from ....planners.roadmaps.search import GraphSearch
from ...exercise import RIGHT, Axes, Case, Slip, ValueExercise, Verdict, format_value
from ...outcomes import Answer, Outcome
from ...shapes import Maybe, Numbers, Record, Value
from ...whole_shapes import Integer, Integers
from ...withheld import withheld
from ..shared.graph_slips import fewest_edges
from ..shared.random_graphs import SIZES, random_rows

Pairs = NDArray[np.int64]
NodePath = list[int] | None


@withheld
def find_fastest(n: int, edges: Pairs, controls: Array, durations: Array, ends: Pairs) -> NodePath:
    """Return the nodes of a fastest path from node 0 to one of the ends, or None."""
    pairs, times = np.reshape(edges, (-1, 2)), np.asarray(durations, float)
    graph = graphs.Graph(n, pairs, times, directed=True)
    found = [dijkstra_path(graph, 0, int(end)) for end in ends]
    paths = [path.tolist() for path in found if path is not None]
    return min(paths, key=lambda path: measure_duration(path, pairs, times), default=None)


def make_search(
    weights: Callable[[Array, Array], Array],
    *,
    directed: bool = True,
    search: GraphSearch = dijkstra_path,
) -> Callable[..., NodePath]:
    """Return a program like `find_fastest` that differs from it in one part.

    Parameters
    ----------
    weights : computes weights (m,) from controls (m, 2) and durations (m,).
    """

    def find(n: int, edges: Pairs, controls: Array, durations: Array, ends: Pairs) -> NodePath:
        pairs, heavy = (
            np.reshape(edges, (-1, 2)),
            weights(np.reshape(controls, (-1, 2)), np.asarray(durations, float)),
        )
        graph = graphs.Graph(n, pairs, heavy, directed=directed)
        paths = [
            path.tolist()
            for path in (search(graph, 0, int(end)) for end in ends)
            if path is not None
        ]
        return min(
            paths, key=lambda path: measure_duration(path, pairs, heavy, directed), default=None
        )

    return find


def weigh_by_time(_: Array, durations: Array) -> Array:
    """Return the durations as weights, as the exercise demands."""
    return durations


def measure_duration(
    path: list[int], edges: Pairs, durations: Array, directed: bool = True
) -> float:
    """Return the total duration of a path; infinite where it uses an edge that does not exist.

    Of parallel edges the quickest counts.
    """
    times: dict[tuple[int, int], float] = {}
    for (u, v), t in zip(edges.tolist(), durations.tolist()):
        for pair in ((u, v),) if directed else ((u, v), (v, u)):
            times[pair] = min(t, times.get(pair, np.inf))
    return float(sum(times.get(pair, np.inf) for pair in zip(path, path[1:])))


def keep_last_edges(
    n: int, edges: Pairs, controls: Array, durations: Array, ends: Pairs
) -> NodePath:
    """Find a fastest path where only the last of parallel edges is kept."""
    pairs = np.reshape(edges, (-1, 2))
    kept = list({(u, v): i for i, (u, v) in enumerate(pairs.tolist())}.values())
    return find_fastest(n, pairs[kept], controls[kept], durations[kept], ends)


def relax_three_times(
    n: int, edges: Pairs, controls: Array, durations: Array, ends: Pairs
) -> NodePath:
    """Relax all edges only three times, as in a Bellman-Ford that stops too early.

    This is right where the rows stand in the order in which they are driven.
    """
    paths: dict[int, tuple[float, NodePath]] = {0: (0.0, [0])}
    for u, v, t in 3 * [
        (int(u), int(v), float(t)) for (u, v), t in zip(np.reshape(edges, (-1, 2)), durations)
    ]:
        time, path = paths.get(u, (np.inf, None))
        if time + t < paths.get(v, (np.inf, None))[0]:
            paths[v] = time + t, [*(path or []), v]
    return min((paths[int(end)] for end in ends if int(end) in paths), default=(np.inf, None))[1]


def change_fastest(change: Callable[[list[int]], list[int]]) -> Callable[..., NodePath]:
    """Return a program that changes the fastest path by `change`."""

    def answer(*given: Value) -> NodePath:
        path = find_fastest(*given)
        return None if path is None else change(path)

    return answer


class FastestDrive(ValueExercise):
    """Find the fastest path through a roadmap of drives to a node near the goal."""

    name = "fastest_drive"
    lesson = "13_kinodynamic_planning"
    kinds = ("chain", "detour", "length", "oneway", "ends", "none", "there")
    given = Record(
        n=Integer(),
        edges=Integers(("m", 2)),
        controls=Numbers(("m", 2)),
        durations=Numbers(("m",)),
        ends=Integers(("k",)),
    )
    answer = Maybe(Integers(("j",)))
    source = staticmethod(find_fastest)
    shown = staticmethod(find_shortest_drive)
    reference: ClassVar[Callable[..., object]] = staticmethod(find_fastest)
    slips = (
        Slip("undirected", make_search(weigh_by_time, directed=False)),
        Slip("length", make_search(lambda controls, durations: np.abs(controls[:, 0]) * durations)),
        Slip(
            "fewest",
            make_search(lambda controls, durations: np.ones(len(durations)), search=fewest_edges),
        ),
        Slip(
            "first_end",
            lambda n, edges, controls, durations, ends: find_fastest(
                n, edges, controls, durations, ends[:1]
            ),
        ),
        Slip(
            "against",
            lambda n, edges, *others: find_fastest(n, np.reshape(edges, (-1, 2))[:, ::-1], *others),
        ),
        Slip("doubles", keep_last_edges),
        Slip("passes", relax_three_times),
        Slip("backwards", change_fastest(lambda path: path[::-1])),
        Slip("no_start", change_fastest(lambda path: path[1:])),
        Slip("no_end", change_fastest(lambda path: path[:-1])),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield chains, a faster detour and a one-way edge, then random roadmaps."""
        for kind, n, rows, ends in (
            ("chain", 2, [(0, 1, 3)], [1]),
            ("chain", 3, [(0, 1, 3), (1, 2, 4)], [2]),
            ("detour", 3, [(0, 2, 9), (0, 1, 3), (1, 2, 4)], [2]),
            ("length", 3, [(0, 2, 6, 0.5), (0, 1, 2, 2), (1, 2, 3, 2)], [2]),
            ("oneway", 4, [(2, 0, 1), (0, 1, 5), (1, 3, 4), (3, 2, 2)], [2]),
            ("length", 3, [(0, 2, 4, 2), (0, 2, 9, 0.5), (0, 1, 3), (1, 2, 3)], [2]),
            ("detour", 4, [(0, 3, 99_000), (0, 1, 9000), (1, 2, 8000), (2, 3, 7000)], [3]),
            ("detour", 3, [(0, 2, 7.00002), (0, 1, 3), (1, 2, 4)], [2]),
            ("ends", 4, [(0, 1, 2), (1, 2, 5), (1, 3, 4)], [2, 3]),
            ("none", 3, [(1, 0, 3), (1, 2, 4)], [2]),
            ("none", 2, [(0, 1, 3)], []),
            ("there", 2, [(0, 1, 3)], [1, 0]),
            ("there", 1, [], [0]),
        ):
            yield make_case(kind, n, rows, ends)
        for n in SIZES:
            size = max(n, 5)
            for kind in self.kinds:
                yield self.random_case(kind, size, rng)

    def random_case(self, kind: str, n: int, rng: np.random.Generator) -> Case:
        """Draw a random roadmap whose ends lie far from the start.

        Its rows are in random order, and some drives occur twice with different durations.
        """
        pairs = [(int(rng.integers(max(v - 3, 0), v)), v) for v in range(1, n)]
        if kind != "chain":
            pairs += [row[:2] for row in random_rows("directed", n, rng) if row[0] != row[1]]
        speeds = [-1.0, 0.5, 2.0] if kind == "length" else [-1.0, 1.0]
        rows = [
            (u, v, float(np.round(rng.uniform(1, 15), 3)), rng.choice(speeds))
            for u, v in dict.fromkeys(pairs)
        ]
        several = kind in ("ends", "none", "there")
        ends = rng.choice(np.arange(1 + n // 2, n), 1 + several, replace=False).tolist()
        if kind != "chain":
            rows += [(u, v, 2.0 * t, speed) for u, v, t, speed in rows[::2]]
        rows = [rows[i] for i in rng.permutation(len(rows))]
        if kind == "oneway":
            rows.append((ends[0], 0, 0.5, 1.0))
        if kind == "none":
            rows = [row for row in rows if row[1] not in ends]
        if kind == "there":
            ends.append(0)
        return make_case(kind, n, rows, ends)

    def same(self, value: Value, truth: Value) -> bool:
        """Whether both hold the same nodes, or both are None."""
        return value is None if truth is None else value is not None and list(value) == list(truth)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that the path starts at node 0, follows edges to an end, and is fastest.

        Where no end can be reached, None is right.
        """
        truth = self.truth(case)
        if value is None or truth is None:
            return (
                RIGHT
                if value is truth is None
                else Verdict(
                    0.0, "missed" if value is None else "none", self.describe_expected(case)
                )
            )
        _, edges, _, durations, ends = case.given.values()
        path = value.tolist()
        if not path or path[0] != 0 or path[-1] not in ends:
            return Verdict(0.0, "ends_of_way", self.describe_expected(case))
        least, found = (
            measure_duration(truth, edges, durations),
            measure_duration(path, edges, durations),
        )
        rule = "edges" if found == np.inf else "" if self.near(found, least) else "slower"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe one right path and its duration."""
        truth = self.truth(case)
        if truth is None:
            return "None"
        return self.message(
            "wanted",
            way=format_value(truth),
            time=measure_duration(truth, case.given["edges"], case.given["durations"]),
        )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the roadmap, a fastest path and the student's."""
        from .pictures import draw_fastest

        draw_fastest(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def make_case(kind: str, n: int, rows: Sequence[tuple[float, ...]], ends: list[int]) -> Case:
    """Return a case of a roadmap from rows (from, to, duration, speed); the default speed is 1."""
    whole = np.array([(*row, 1.0)[:4] for row in rows], float).reshape(-1, 4)
    numbers = {
        "controls": np.column_stack([whole[:, 3], np.zeros(len(rows))]),
        "durations": whole[:, 2],
    }
    edges = {"n": n, "edges": whole[:, :2].astype(np.int64)}
    return Case(kind, {**edges, **numbers, "ends": np.array(ends, np.int64)})
