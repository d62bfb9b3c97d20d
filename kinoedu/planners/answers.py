"""Build the Plan that a planner returns."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..compiled import algorithm, callable_from_compiled
from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import Array, as_array
from ..graphs import extract_path
from ..problems import Plan, Tree
from ..problems.protocols import PlanningProblem, ProblemLike
from ..spaces.buckets import GrowingTree
from ..support.text import shortened
from .problem_input import as_problem


@algorithm
def cost_along(problem: PlanningProblem, path: Array) -> float:
    """The cost of a path: the sum of the costs of its motions."""
    return cost_between(problem, path, 0, len(path) - 1)


@callable_from_compiled
def cost_between(problem: PlanningProblem, path: Array, first: int, last: int) -> float:
    """The cost of a path from point `first` to point `last`."""
    cost = 0.0
    for k in range(first, last):
        cost += problem.motion_cost(path[k], path[k + 1])
    return cost


def path_cost(problem: ProblemLike, path: ArrayLike) -> float:
    """The cost of a path in a problem, whether the path is free or not.

    The cost is the length of the path; on a terrain with costs it is their integral along the path.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours with the same methods.
    path : (n, d).

    Raises
    ------
    InvalidPoint
        Where the path is not an array of configurations of the problem.

    Examples
    --------
    >>> from kinoedu import Point, Problem, Terrain
    >>> mud = Terrain([[1, 1, 1]], cost=[[1, 5, 1]])
    >>> path_cost(Problem(Point(), mud, (0.5, 0.5), (2.5, 0.5)), [(0.5, 0.5), (2.5, 0.5)])
    6.0
    """
    problem, places = as_problem(problem), as_array(path, "path")
    if places.ndim != 2 or places.shape[1:] != problem.start.shape:
        raise InvalidPoint(f"a path must have shape (n, {len(problem.start)}), got {places.shape}")
    return float(cost_along(problem, places))


def plan_of(answer: object) -> Plan:
    """What a planner has returned, which must be a Plan. Raises InvalidParameter."""
    if not isinstance(answer, Plan):
        raise InvalidParameter(f"expected the Plan of a planner, got {shortened(answer)}")
    return answer


def plan_along(
    problem: PlanningProblem,
    nodes: Array,
    numbers: NDArray[np.int64] | None,
    reason: str,
    **built: Any,
) -> Plan:
    """A plan along numbered nodes, shape (k,), or a plan without a path where `numbers` is None."""
    if numbers is None:
        return Plan(None, np.inf, reason=reason, problem=problem, **built)
    path = nodes[numbers]
    return Plan(path, float(cost_along(problem, path)), problem=problem, **built)


def plan_from_tree(
    planner: str,
    problem: PlanningProblem,
    tree: GrowingTree,
    at_goal: int,
    reason: str,
    **stats: int,
) -> Plan:
    """A plan from the root of a tree to its node at the goal; without a path where that is -1."""
    n = int(tree.size[0])
    grown = Tree(tree.nodes[:n].copy(), tree.parent[:n].copy())
    numbers = extract_path(grown.parent, at_goal) if at_goal >= 0 else None
    return plan_along(
        problem,
        grown.nodes,
        numbers,
        reason,
        planner=planner,
        tree=grown,
        stats={"nodes": n, **stats},
    )
