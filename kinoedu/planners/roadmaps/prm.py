"""Probabilistic roadmaps.

    PRM(Q_free, n, rule)
     1  V := n free configurations
     2  E := the empty set
     3  for each pair (v, w) of V that the rule tries to join:
     4      if the motion from v to w is free: add (v, w) to E
     5  return the roadmap (V, E)

Start and goal are the first two nodes of V, and A* finds the path between them.

L. E. Kavraki, P. Svestka, J.-C. Latombe, M. H. Overmars, "Probabilistic roadmaps for path planning
in high-dimensional configuration spaces" (1996); Bullo & Smith, chapter 5; LaValle, section 5.6.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...compiled import algorithm
from ...errors import InvalidParameter
from ...geometry.checks import Array, as_array, as_generator
from ...graphs import GraphRecord, astar, flat_graph
from ...messages import get_message
from ...problems import Plan, Roadmap
from ...problems.protocols import PlanningProblem, ProblemLike
from ...support.text import shortened
from ..answers import plan_along
from ..problem_input import as_problem, as_two_way_problem, count_checks
from ..tuning import integer
from .connecting import KClosest, Rule, connect_nodes

Sampler = Callable[[int, int], ArrayLike]


@algorithm
def sample_free(problem: PlanningProblem, n: int, tries: int, rng: np.random.Generator) -> Array:
    """Up to n free configurations, (m, d), found in at most `tries` samples."""
    nodes, size = np.empty((n, len(problem.start))), 0
    for _ in range(tries):
        if size == n:
            break
        q = problem.sample(rng)
        if problem.is_free(q):
            nodes[size] = q
            size += 1
    return nodes[:size].copy()


@algorithm
def free_among(problem: PlanningProblem, places: Array) -> NDArray[np.bool_]:
    """Whether each configuration (n, d) is free, (n,)."""
    free = np.empty(len(places), np.bool_)
    for i in range(len(places)):
        free[i] = problem.is_free(places[i])
    return free


@algorithm
def distances_to(problem: PlanningProblem, nodes: Array, q: Array) -> Array:
    """The distance from each node to q, (n,): the heuristic of A*."""
    left = np.empty(len(nodes))
    for i in range(len(nodes)):
        left[i] = problem.distance(nodes[i], q)
    return left


def prm(
    problem: ProblemLike,
    *,
    n: int = 1000,
    k: int = 10,
    neighbours: Rule | None = None,
    sampler: Sampler | None = None,
    rng: int | np.random.Generator | None = None,
) -> Plan:
    """Plan by a probabilistic roadmap: sample free configurations, join neighbours, search with A*.

    Probabilistically complete where k grows with n like log n (`prm_star`). With a small constant k
    the roadmap may stay in several components, however many nodes it has.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours with the same methods and `is_free`.
    n : how many free configurations are sampled.
    k : K, how many closest neighbours each of them is tried with, where no other rule is given.
    neighbours : a rule instead of k: KClosest(k), Radius(r) or ComponentKClosest(k).
    sampler : a function of n and d that returns n points of the unit cube, shape (n, d), such as
        `lambda n, d: halton(n)`; the points that are free in the problem's space become nodes.
        Without a sampler, configurations are drawn at random until n of them are free, at most
        100 n of them.
    rng : a seed or a numpy Generator; not needed with a sampler.

    Returns
    -------
    Plan with its `roadmap`, whose nodes 0 and 1 are start and goal. Without a path `plan.reason`
    says why there is none.

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range, or the robot only drives forward.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> plan = prm(Problem(Point(), world, start=(1, 1), goal=(9, 1)), n=200, rng=0)
    >>> bool(15.2 < plan.cost < 20)
    True
    """
    problem = as_two_way_problem(problem, "PRM")
    rule = KClosest(k) if neighbours is None else neighbours
    before = count_checks(problem)
    sampled = free_configurations(problem, n, sampler, rng)
    nodes = np.concatenate([[problem.start, problem.goal], sampled])
    edges, costs = connect_nodes(rule, problem, nodes)
    return plan_by_astar("PRM", problem, nodes, edges, costs, before)


def prm_star(
    problem: ProblemLike,
    *,
    n: int = 1000,
    sampler: Sampler | None = None,
    rng: int | np.random.Generator | None = None,
) -> Plan:
    """Plan by PRM*: a PRM with K = e (1 + 1/d) log n, whose paths converge to the shortest.

    The other parameters, the result and the errors are those of `prm`.

    S. Karaman, E. Frazzoli, "Sampling-based algorithms for optimal motion planning" (2011), section
    3.3.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> plan = prm_star(Problem(Point(), world, start=(1, 1), goal=(9, 1)), n=1000, rng=0)
    >>> bool(17.2 < plan.cost < 18)
    True
    """
    samples, d = integer(n, "n", least=0), len(as_problem(problem).start)
    k = math.ceil(math.e * (1.0 + 1.0 / d) * math.log(samples + 2))
    return prm(problem, n=samples, neighbours=KClosest(k), sampler=sampler, rng=rng)


def free_configurations(
    problem: PlanningProblem, n: int, sampler: Sampler | None, rng: int | np.random.Generator | None
) -> Array:
    """Free configurations, (m, d): the free ones of n points of a sampler, or n at random.

    Raises
    ------
    InvalidParameter
        Where the sampler is not a function that returns n points of the unit cube, or the problem
        has no space to cover.
    """
    samples = integer(n, "n", least=0)
    if sampler is None:
        generator = as_generator(rng)  # type: ignore[arg-type]  # None is refused by name
        return sample_free(problem, samples, 100 * samples, generator)
    if not callable(sampler):
        raise InvalidParameter(
            f"the sampler must be a function such as halton, got {shortened(sampler)}"
        )
    space, d = getattr(problem, "space", None), len(problem.start)
    if space is None:
        raise InvalidParameter(
            "a sampler needs a Problem, whose space it covers; an object of yours has its own "
            "`sample`"
        )
    points = as_array(sampler(samples, d), "the sampler's points")
    if points.ndim != 2 or points.shape[1] != d or not ((points >= 0.0) & (points <= 1.0)).all():
        raise InvalidParameter(
            f"the sampler must give points of the unit cube, shape (n, {d}), got shape "
            f"{points.shape}"
        )
    places = space.lo + points * (space.hi - space.lo)
    return places[free_among(problem, places)]


def plan_by_astar(
    planner: str,
    problem: PlanningProblem,
    nodes: Array,
    edges: NDArray[np.int64],
    costs: Array,
    before: int,
) -> Plan:
    """The plan along the shortest path in a roadmap whose nodes 0 and 1 are start and goal.

    `before` is how many motions the problem had checked when the planner began.
    """
    graph = flat_graph(len(nodes), edges, costs)
    numbers, _ = astar(graph, 0, 1, distances_to(problem, nodes, nodes[1]))
    stats = {
        "nodes": len(nodes),
        "edges": len(edges),
        "checks": count_checks(problem) - before,
    }
    return plan_along(
        problem,
        nodes,
        numbers,
        explain_no_path(graph),
        planner=planner,
        roadmap=Roadmap(nodes, edges),
        stats=stats,
    )


def explain_no_path(graph: GraphRecord) -> str:
    """Why a roadmap has no path from node 0 to node 1."""
    alone = [node for node in (0, 1) if graph.degree(node) == 0]
    key = ("start_alone", "goal_alone")[alone[0]] if alone else "parts_apart"
    return get_message(f"plan.{key}", nodes=f"{graph.size:,}")
