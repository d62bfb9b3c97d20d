"""One roadmap for many queries: it is built once, and each start and goal is joined to it.

Bullo & Smith, chapter 5: the preprocessing phase and the query phase.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...compiled import algorithm
from ...errors import InvalidGoal, InvalidParameter, InvalidStart
from ...geometry.checks import Array, as_array
from ...problems import Plan, Problem, ProblemRecord, Roadmap
from ...problems.protocols import PlanningProblem, ProblemLike
from ...problems.recorder import record_as, unwrap_recorder
from ...support.text import shortened
from ..problem_input import as_two_way_problem, count_checks, in_space
from ..tuning import integer
from .connecting import KClosest, Rule, connect_nodes
from .prm import Sampler, free_configurations, plan_by_astar


@algorithm
def join_ends(problem: PlanningProblem, nodes: Array, k: int) -> tuple[NDArray[np.int64], Array]:
    """Join nodes 0 and 1 to the k closest other nodes that a free motion leads to.

    Returns the edges (m, 2) and their costs (m,).
    """
    edges, costs, size = np.empty((2 * k, 2), np.int64), np.empty(2 * k), 0
    for end in range(2):
        apart, joined_to = np.empty(len(nodes)), 0
        for node in range(len(nodes)):
            apart[node] = problem.distance(nodes[end], nodes[node])
        for j in np.argsort(apart, kind="mergesort"):
            tried_before = end == 1 and j == 0
            if joined_to == k or j == end or tried_before:
                continue
            if problem.is_free_path(nodes[end], nodes[j]):
                edges[size, 0], edges[size, 1] = end, j
                costs[size] = problem.motion_cost(nodes[end], nodes[j])
                size, joined_to = size + 1, joined_to + 1
    return edges[:size].copy(), costs[:size].copy()


@algorithm
def motion_costs(problem: PlanningProblem, nodes: Array, edges: NDArray[np.int64]) -> Array:
    """The cost of each edge (m, 2), shape (m,)."""
    costs = np.empty(len(edges))
    for i in range(len(edges)):
        costs[i] = problem.motion_cost(nodes[edges[i, 0]], nodes[edges[i, 1]])
    return costs


def build_roadmap(
    problem: ProblemLike,
    *,
    n: int = 1000,
    k: int = 10,
    neighbours: Rule | None = None,
    sampler: Sampler | None = None,
    rng: int | np.random.Generator | None = None,
) -> Roadmap:
    """A probabilistic roadmap without start and goal, for `query`; the preprocessing phase.

    The parameters are those of `prm`.

    Returns
    -------
    Roadmap

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range, or the robot only drives forward.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(9, 1))
    >>> roadmap = build_roadmap(problem, n=200, rng=0)
    >>> goals = (9, 1), (5, 9), (1, 9)
    >>> [query(problem, roadmap, (1, 1), goal).path is not None for goal in goals]
    [True, True, True]
    """
    problem = as_two_way_problem(problem, "a roadmap")
    rule = KClosest(k) if neighbours is None else neighbours
    nodes = free_configurations(problem, n, sampler, rng)
    edges, _ = connect_nodes(rule, problem, nodes)
    return Roadmap(nodes, edges)


def query(
    problem: ProblemLike,
    roadmap: Roadmap,
    start: ArrayLike | None = None,
    goal: ArrayLike | None = None,
    *,
    k: int = 10,
) -> Plan:
    """The cheapest path along a roadmap between a start and a goal; the query phase.

    Start and goal are joined to the k closest nodes that a free motion leads to, and A* finds the
    path.

    Parameters
    ----------
    problem : the problem for which the roadmap was built.
    roadmap : of `build_roadmap` or `grid_roadmap`.
    start, goal : (d,), by default those of the problem; both must be free.
    k : how many nodes each of them is joined to.

    Returns
    -------
    Plan whose roadmap has start and goal as nodes 0 and 1, before all others. Without a path
    `plan.reason` says why there is none.

    Raises
    ------
    InvalidStart, InvalidGoal
        Where the start or the goal is not a free configuration.
    InvalidPoint
        Where it is not an array of finite numbers.
    InvalidParameter
        Where `roadmap` is not a roadmap, or `k` is not a positive integer.
    """
    if not isinstance(roadmap, Roadmap):
        raise InvalidParameter(
            "expected the roadmap that build_roadmap or grid_roadmap made, got "
            f"{shortened(roadmap)}"
        )
    closest = integer(k, "k", least=1)
    problem = with_ends(as_two_way_problem(problem, "a roadmap"), start, goal)
    q_start, q_goal = as_free(problem, start, "start"), as_free(problem, goal, "goal")
    before = count_checks(problem)
    nodes = np.concatenate([[q_start, q_goal], roadmap.nodes.reshape(-1, len(q_start))])
    to_ends, end_costs = join_ends(problem, nodes, min(closest, len(nodes)))
    costs = motion_costs(problem, roadmap.nodes, roadmap.edges)
    edges = np.concatenate([to_ends, roadmap.edges + 2])
    return plan_by_astar(
        "roadmap query", problem, nodes, edges, np.concatenate([end_costs, costs]), before
    )


def with_ends(
    problem: PlanningProblem, start: ArrayLike | None, goal: ArrayLike | None
) -> PlanningProblem:
    """The problem with another start or goal; a reader's own object stays as it is."""
    inner = unwrap_recorder(problem)
    if not isinstance(inner, ProblemRecord) or (start is None and goal is None):
        return problem
    ends = (inner.start if start is None else start, inner.goal if goal is None else goal)
    moved: PlanningProblem = record_as(
        problem, Problem(inner.robot, inner.world, *ends, clearance=inner.clearance)
    )
    return moved


def as_free(problem: PlanningProblem, value: ArrayLike | None, name: str) -> Array:
    """A free configuration, shape (d,), by default that of the problem.

    Raises
    ------
    InvalidStart, InvalidGoal
        Where it is not a free configuration.
    """
    q = getattr(problem, name) if value is None else np.atleast_1d(as_array(value, name))
    error = InvalidStart if name == "start" else InvalidGoal
    if q.shape != problem.start.shape:
        raise error(f"the {name} must have shape {problem.start.shape}, got {q.shape}")
    q, inner = in_space(problem, q), unwrap_recorder(problem)
    if not inner.is_free(q):
        raise error(f"the {name} {tuple(q.tolist())} is not free; move it into the open")
    return q
