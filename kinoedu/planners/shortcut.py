"""Shorten paths: replace parts of a path by straight motions where these are free.

R. Geraerts, M. H. Overmars, "Creating high-quality paths for motion planning" (2007).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..compiled import algorithm
from ..errors import InvalidParameter
from ..geometry.checks import Array, as_generator
from ..problems import Plan
from ..problems.protocols import PlanningProblem
from .answers import cost_along, cost_between, plan_of
from .problem_input import as_problem, count_checks
from .tuning import integer


@algorithm
def cut_corners(
    problem: PlanningProblem, path: Array, tries: int, rng: np.random.Generator
) -> Array:
    """Try to join two random places of a path (n, d) by a straight motion, `tries` times.

    Returns
    -------
    (m, d) array: the path that remains.
    """
    points, size = np.empty((len(path) + tries, path.shape[1])), len(path)
    points[:size] = path
    for _ in range(tries):
        i, j = int(rng.integers(0, size - 1)), int(rng.integers(0, size - 1))
        t, s = rng.random(), rng.random()
        if i >= j:
            continue
        p = problem.steer(points[i], points[i + 1], t * problem.distance(points[i], points[i + 1]))
        q = problem.steer(points[j], points[j + 1], s * problem.distance(points[j], points[j + 1]))
        before, after = points[i].copy(), points[j + 1].copy()
        along = cost_between(problem, points, i, j + 1)
        straight = (
            problem.motion_cost(before, p)
            + problem.motion_cost(p, q)
            + problem.motion_cost(q, after)
        )
        if straight >= along or not problem.is_free_path(p, q):
            continue
        if problem.is_free_path(before, p) and problem.is_free_path(q, after):
            points[i + 3 : size + i + 2 - j] = points[j + 1 : size].copy()
            points[i + 1], points[i + 2] = p, q
            size += i + 2 - j
    return points[:size].copy()


def shortcut(plan: Plan, *, tries: int = 200, rng: int | np.random.Generator) -> Plan:
    """The plan with a cheaper path, found by random shortcuts.

    Two random places on the path are joined by a straight motion where this is free and cheaper;
    this is tried `tries` times. The path remains free and never costs more; it need not become a
    shortest one. O(tries) motions.

    Parameters
    ----------
    plan : the plan of any planner, except one with a trajectory.
    tries : how many pairs of places are drawn.
    rng : a seed or a numpy Generator.

    Returns
    -------
    Plan with the new path. All else that the planner built stays, and the motions that were checked
    are added to its stats. A plan without a path is returned unchanged.

    Raises
    ------
    InvalidParameter
        Where `plan` is no Plan or has a trajectory, `tries` is negative or not an integer, or `rng`
        is neither a seed nor a Generator.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, rrt
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> plan = rrt(Problem(Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
    >>> bool(17.2 < shortcut(plan, rng=0).cost < plan.cost)
    True
    """
    if plan_of(plan).trajectory is not None:
        raise InvalidParameter(
            "the drives of a trajectory cannot be shortened; give shortcut a plan of curves, such "
            "as rrt's"
        )
    attempts, generator = integer(tries, "tries", least=0), as_generator(rng)
    if plan.path is None or len(plan.path) < 3 or attempts == 0:
        return plan
    problem = as_problem(plan.problem)
    before = count_checks(problem)
    path = cut_corners(problem, plan.path, attempts, generator)
    cost = float(cost_along(problem, path))
    stats = {
        **plan.stats,
        "checks": plan.stats.get("checks", 0) + count_checks(problem) - before,
    }
    if cost >= plan.cost:
        return replace(plan, stats=stats)
    return replace(plan, path=path, cost=cost, stats=stats)
