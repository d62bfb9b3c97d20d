"""The exercise on a PRM on a bitmap that joins every free pair.

It is the second planner of the document that lesson 10 examines; `repeated_rows.py` names it.
"""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....graphs import Graph, astar
from ....planners.roadmaps.prm import prm
from ....problems import Tree
from ....problems.protocols import PlanningProblem, ProblemLike
from ...exercise import Case
from ...shapes import Maybe, Record, Together, Value
from ...whole_shapes import Integer, Integers
from ...withheld import withheld
from ..shared.planned import (
    NODES,
    PATH,
    Fault,
    ProblemShape,
    Run,
    StudentProblem,
    Watched,
    watched_three_times,
)
from .rrt_on_terrain import GRAZED, SMALL, TerrainPlanner, make_terrain_problem

# a corridor of two cells among rocks: one sample in twenty is free
CORRIDOR = make_terrain_problem(
    [(0, 0, SMALL, 19), (0, 21, SMALL, SMALL)], (1.5, 20.5), (38.5, 20.5)
)
# a small rock between start and goal
ROCK = make_terrain_problem([(19, 19, 21, 22)], (6.5, 20.5), (33.5, 20.5))
LITTLE = 0.01


@withheld
def build_roadmap(problem: PlanningProblem, n: int, rng: int) -> Value:
    """Build the PRM as the exercise demands, and return nodes, edges and path."""
    chance, nodes = np.random.default_rng(rng), [problem.start, problem.goal]
    while len(nodes) < n + 2:
        q = problem.sample(chance)
        if problem.is_free(q):
            nodes.append(q)
    edges = [
        (i, j)
        for i in range(n + 2)
        for j in range(i + 1, n + 2)
        if problem.is_free_path(nodes[i], nodes[j])
    ]
    numbers = find_shortest(problem, np.array(nodes), np.array(edges))
    return nodes, edges, None if numbers is None else np.array(nodes)[numbers]


def find_shortest(problem: ProblemLike, nodes: Array, edges: Array) -> Value:
    """Return the indices of the nodes on a shortest path from node 0 to node 1, or None."""
    lengths = [problem.distance(nodes[i], nodes[j]) for i, j in edges]
    return astar(
        Graph(len(nodes), np.reshape(edges, (-1, 2)), np.array(lengths)), 0, 1, np.zeros(len(nodes))
    )[0]


class PrmOnTerrain(Watched, TerrainPlanner):
    """Build a roadmap of n free samples and all free pairs, and find a shortest path."""

    name = "prm_on_terrain"
    given = Record(problem=ProblemShape(), n=Integer(), rng=Integer())
    result = Together((NODES, Integers(("m", 2)), Maybe(PATH)))
    answer = watched_three_times(result)
    source = staticmethod(build_roadmap)
    shown = staticmethod(prm)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the cases of both planners, a grazed rock, a corridor, and two equal detours.

        Of these, the one that is found last is a little shorter.
        """
        yield from super().cases(rng)
        yield self.make_case("open", GRAZED, int(rng.integers(1000)))
        yield self.make_case("open", CORRIDOR, int(rng.integers(1000)))
        seed = int(rng.integers(10**6))
        while not 1e-4 < measure_gain(ROCK, seed) < LITTLE:
            seed = int(rng.integers(10**6))
        yield Case("open", {"problem": ROCK, "n": 2, "rng": seed})

    def make_case(self, kind: str, problem: StudentProblem, rng: int) -> Case:
        """Return a case with enough samples for every trap."""
        return Case(kind, {"problem": problem, "n": 8 if kind == "same" else 40, "rng": rng})

    def uses_chance(self, case: Case) -> bool:
        """Another seed always gives another answer."""
        return True

    def fault_of_run(self, case: Case, answer: Value, run: Run | None) -> Fault | None:
        """Judge the nodes, the edges and the path.

        The nodes must be the first free samples, each free pair must be there once, and the path
        must follow edges and be shortest.
        """
        nodes, edges, path = answer
        problem, n = case.given["problem"], case.given["n"]
        fault = find_node_fault(problem, nodes, n)
        fault = fault or (None if run is None else find_sample_fault(problem, nodes[2:], run))
        fault = fault or find_edge_fault(problem, nodes, edges)
        if fault is not None or path is None:
            known = fault is not None or find_shortest(problem, nodes, edges) is None
            return fault if known else Fault("missed", nodes[:0])
        return self.fault_of_end(case, path) or find_path_fault(problem, nodes, edges, path)

    def size_limit(self, case: Case) -> int:
        """The most rows: all pairs of nodes, so that pairs both ways break a rule of their own."""
        return (int(case.given["n"]) + 2) ** 2

    def drawn(self, answer: Value) -> tuple[list[Tree], Array | None]:
        """Return the nodes, as trees of one node each, and the path."""
        nodes, _, path = answer
        return [Tree(nodes, np.full(len(nodes), -1))], path


def measure_gain(problem: StudentProblem, rng: int) -> float:
    """Return by how much the path through the second of two samples is shorter; or 0.

    The first is the one nearer to the start, which Dijkstra's algorithm takes out first. It is 0
    where a sample does not see both start and goal.
    """
    record, chance = problem.problem, np.random.default_rng(rng)
    places, ends = [record.sample(chance) for _ in range(2)], (record.start, record.goal)
    away = np.array([[record.distance(q, end) for end in ends] for q in places])
    if not all(record.is_free_path(q, end) for q in places for end in ends):
        return 0.0
    first = int(away[:, 0].argmin())
    return float(away[first].sum() - away[1 - first].sum())


def find_node_fault(problem: StudentProblem, nodes: Array, n: int) -> Fault | None:
    """Judge that the nodes are start, goal and n free places."""
    if len(nodes) != n + 2:
        return Fault("count", nodes[:0])
    if not (np.array_equal(nodes[0], problem.start) and np.array_equal(nodes[1], problem.goal)):
        return Fault("ends_first", nodes[:2])
    for q in nodes:
        if not problem.problem.is_free(q):
            return Fault("free_node", q[None])
    return None


def find_sample_fault(problem: StudentProblem, nodes: Array, run: Run) -> Fault | None:
    """Judge that nodes are the first free samples, in the order in which they were drawn."""
    if run.generators > 1:
        return Fault("generator", nodes[:0])
    free = [q for q in run.samples if problem.problem.is_free(q)]
    for i, q in enumerate(nodes):
        if i == len(free) or not np.array_equal(q, free[i]):
            return Fault("samples", q[None])
    return None


def find_edge_fault(problem: StudentProblem, nodes: Array, edges: Array) -> Fault | None:
    """Judge that every free pair is an edge, once, and no other pair is."""
    if len(edges) and (edges.min() < 0 or edges.max() >= len(nodes)):
        return Fault("numbers_of_nodes", nodes[:0])
    pairs = {(min(i, j), max(i, j)) for i, j in edges.tolist()}
    if len(pairs) < len(edges) or any(i == j for i, j in pairs):
        return Fault("once", nodes[:0])
    for i in range(len(nodes)):
        for j in range(i + 1, len(nodes)):
            if ((i, j) in pairs) != bool(problem.problem.is_free_path(nodes[i], nodes[j])):
                return Fault("free" if (i, j) in pairs else "all_pairs", nodes[[i, j]])
    return None


def find_path_fault(
    problem: StudentProblem, nodes: Array, edges: Array, path: Array
) -> Fault | None:
    """Judge that the path follows edges and is shortest."""
    at = [int(np.argmin(((nodes - q) ** 2).sum(axis=1))) for q in path]
    pairs = {(i, j) for i, j in edges.tolist()} | {(j, i) for i, j in edges.tolist()}
    for a, b, i, j in zip(path[:-1], path[1:], at[:-1], at[1:]):
        on_nodes = np.allclose(nodes[[i, j]], [a, b], rtol=0.0, atol=1e-9)
        if not on_nodes or ((i, j) not in pairs and i != j):
            return Fault("along_edges", np.array([a, b]))
    best = nodes[find_shortest(problem, nodes, edges)]
    found, least = (
        sum(problem.distance(a, b) for a, b in zip(way[:-1], way[1:])) for way in (path, best)
    )
    return Fault("shortest", nodes[:0]) if found > least + 1e-6 * (1.0 + least) else None
