"""Graphs for cases as adjacency lists: some fixed, others random, from small to large."""

from collections.abc import Iterable, Iterator

import numpy as np

from ....graphs import Graph
from ...shapes import Value

Neighbours = list[list[int]]
Weights = list[list[float]]
SIZES = (3, 4, 5, 6, 7, 8, 10, 12, 16, 24, 40, 60)  # nodes of the random cases


def adjacency_lists(
    n: int, rows: Iterable[Value], *, directed: bool = False
) -> tuple[Neighbours, Weights]:
    """Adjacency lists in increasing order, and the weights beside them.

    Rows are (u, v) or (u, v, weight). For repeated edges the last weight counts.

    >>> adjacency_lists(3, [(0, 2, 5), (0, 1)])
    ([[1, 2], [0], [0]], [[1.0, 5.0], [1.0], [5.0]])
    """
    leads: list[dict[int, float]] = [{} for _ in range(n)]
    for u, v, *weight in rows:
        leads[u][v] = float(weight[0]) if weight else 1.0
        if not directed:
            leads[v][u] = leads[u][v]
    return [sorted(row) for row in leads], [[row[v] for v in sorted(row)] for row in leads]


def as_graph(neighbours: Neighbours, weights: Weights | None = None) -> Graph:
    """The library's directed graph of adjacency lists.

    Raises
    ------
    InvalidGraph
        Where a weight is negative.
    """
    edges = [(u, v) for u, row in enumerate(neighbours) for v in row]
    return Graph(
        len(neighbours),
        edges,
        None if weights is None else [w for row in weights for w in row],
        directed=True,
    )


def symmetric(neighbours: Neighbours, weights: Weights | None = None) -> bool:
    """Whether each edge has an opposite edge of the same weight."""
    rows = [[1.0] * len(row) for row in neighbours] if weights is None else weights
    leads = {(u, v): w for u, row in enumerate(neighbours) for v, w in zip(row, rows[u])}
    return all(leads.get((v, u)) == w for (u, v), w in leads.items())


def random_rows(kind: str, n: int, rng: np.random.Generator) -> list[tuple[int, int, float]]:
    """Random edges with weights, between randomly numbered nodes.

    Parameters
    ----------
    kind : "tree", a spanning tree; "cycle", a tree with additional edges; "directed", a directed
        ring with additional edges; "parts", two separate graphs of kind "cycle".
    """
    name = rng.permutation(n)
    parts = [range(n)] if kind != "parts" else [range(n // 2), range(n // 2, n)]
    pairs = [
        (part[int(rng.integers(max(i - 3, 0), i))], part[i])
        for part in parts
        for i in range(1, len(part))
    ]
    if kind == "directed":
        pairs = [(i, (i + 1) % n) for i in range(n)] + [
            pair for pair in pairs if rng.random() < 0.3
        ]
    extra = 0 if kind == "tree" else 1 + n // 2
    for part in parts * extra:
        if len(part) > 2:
            u, v = rng.choice(part, 2, replace=False).tolist()
            pairs.append((u, v))
    return [
        (int(name[u]), int(name[v]), float(rng.integers(0 if i % 7 == 6 else 1, 10)))
        for i, (u, v) in enumerate(pairs)
    ]


def random_graphs(rng: np.random.Generator) -> Iterator[tuple[str, Neighbours, Weights]]:
    """Yield one graph of each size for each kind of `random_rows`."""
    for n in SIZES:
        for kind in ("tree", "cycle", "directed", "parts"):
            yield (
                kind,
                *adjacency_lists(n, random_rows(kind, n, rng), directed=kind == "directed"),
            )


def reachable_pair(neighbours: Neighbours, rng: np.random.Generator) -> tuple[int, int]:
    """A start and a goal that is reachable, at least two edges away where possible."""
    from ....graphs import bfs

    graph = as_graph(neighbours)
    pairs = [(int(s), bfs(graph, int(s)).cost) for s in rng.permutation(len(neighbours))]
    for least in (2, 1):
        for start, far in pairs:
            goals = np.flatnonzero(np.isfinite(far) & (far >= least))
            if len(goals):
                return start, int(rng.choice(goals))
    return 0, 0


def unreachable_pair(neighbours: Neighbours, rng: np.random.Generator) -> tuple[int, int]:
    """A start and a goal that is not reachable; the graph must have such a pair."""
    from ....graphs import bfs

    graph = as_graph(neighbours)
    while True:
        start = int(rng.integers(len(neighbours)))
        goals = np.flatnonzero(np.isinf(bfs(graph, start).cost))
        if len(goals):
            return start, int(rng.choice(goals))
