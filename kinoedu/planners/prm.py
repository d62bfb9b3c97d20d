"""Probabilistic roadmaps. L. E. Kavraki, P. Svestka, J.-C. Latombe, M. H. Overmars, "Probabilistic roadmaps for path planning in
high-dimensional configuration spaces" (1996); Bullo & Smith, section 4.3; LaValle, section 5.6.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..compiled import body
from ..errors import InvalidParameter
from ..geometry.checks import Array, as_generator
from ..graphs import GraphRecord, astar, flat_graph
from ..problems import MOTIONS, Plan, Roadmap
from .answers import plan_along
from .asking import askable, body_for
from .neighbours import k_closest
from .tuning import whole


@body
def sample_free(problem: Any, n: int, tries: int, rng: np.random.Generator) -> Array:
    """The start, the goal, and up to n free configurations found in so many tries; shape (m, d)."""
    nodes = np.empty((n + 2, len(problem.start)))
    nodes[0], nodes[1], size = problem.start, problem.goal, 2
    for _ in range(tries):
        if size == len(nodes):
            break
        q = problem.sample(rng)
        if problem.is_free(q):
            nodes[size] = q
            size += 1
    return nodes[:size].copy()


@body
def join(problem: Any, nodes: Array, neighbours: NDArray[np.int64]) -> tuple[NDArray[np.int64], Array]:
    """The edges (m, 2) between neighbours whose motion is free, each pair asked once, and their lengths (m,)."""
    n, k = neighbours.shape
    edges, lengths, size = np.empty((n * k, 2), np.int64), np.empty(n * k), 0
    for i in range(n):
        for j in neighbours[i]:
            asked_before = j < i and np.any(neighbours[j] == i)
            if not asked_before and problem.is_free_path(nodes[i], nodes[j]):
                edges[size, 0], edges[size, 1] = i, j
                lengths[size] = problem.distance(nodes[i], nodes[j])
                size += 1
    return edges[:size].copy(), lengths[:size].copy()


@body
def distances_to(problem: Any, nodes: Array, q: Array) -> Array:
    """The distance from each node to q, shape (n,): what is left to go at the least."""
    left = np.empty(len(nodes))
    for i in range(len(nodes)):
        left[i] = problem.distance(nodes[i], q)
    return left


def prm(problem: Any, *, n: int = 1000, k: int = 10, rng: int | np.random.Generator) -> Plan:
    """Sample free configurations, join each to its k closest by free motions, and search the roadmap with A*.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours that answers the same questions and `is_free`.
    n : how many configurations are sampled.
    k : K, how many neighbours each is tried with.
    rng : a seed or a numpy Generator.

    Returns a Plan with its `roadmap`: start and goal are its nodes 0 and 1. Without a path `plan.reason` tells which of the two is
    cut off. Probabilistically complete where k grows with n like log n (S. Karaman, E. Frazzoli, 2011); a fixed small k may leave
    the roadmap in pieces however many nodes it has. Raises InvalidParameter.

    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> plan = prm(Problem(Point(), world, start=(1, 1), goal=(9, 1)), n=200, rng=0)
    >>> bool(15.2 < plan.cost < 20)
    True
    """
    asked, samples = askable(problem), whole(n, "n", least=0)
    closest = min(whole(k, "k", least=1), samples + 1)
    if samples * closest > 100_000_000:
        raise InvalidParameter(
            f"n * k must not exceed 100,000,000, got {samples:,} * {closest:,}; sample fewer nodes or join fewer"
        )
    before = asked.asked[MOTIONS]
    nodes = body_for(asked, sample_free)(asked, samples, 100 * samples, as_generator(rng))
    edges, lengths = body_for(asked, join)(asked, nodes, k_closest(asked, nodes, closest))
    graph = flat_graph(len(nodes), edges, lengths)
    numbers, _ = astar(graph, 0, 1, body_for(asked, distances_to)(asked, nodes, asked.goal))
    stats = {"nodes": len(nodes), "edges": len(edges), "checks": int(asked.asked[MOTIONS] - before)}
    return plan_along(asked, nodes, numbers, why_apart(graph), planner="PRM", roadmap=Roadmap(nodes, edges), stats=stats)


def why_apart(graph: GraphRecord) -> str:
    """Why a roadmap does not join nodes 0 and 1."""
    for node, name in ((0, "start"), (1, "goal")):
        if graph.degree(node) == 0:
            return f"no node of {graph.size:,} can be reached from the {name}; sample more nodes"
    return (
        f"start and goal lie in different parts of the roadmap of {graph.size:,} nodes; sample more nodes, or join more neighbours"
    )
