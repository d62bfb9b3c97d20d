"""Alternative routes: further paths in a roadmap, for use when the shortest one is blocked.

R. Bader, J. Dees, R. Geisberger, P. Sanders, "Alternative route graphs in road networks" (2011),
section 4.2: the penalty method.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...graphs import astar, flat_graph
from ...problems import Plan
from ...robots.trajectory import DrivenRoadmap, TrajectoryRecord
from ...support.text import shortened
from ..answers import plan_along
from ..problem_input import as_problem
from ..tuning import integer, positive
from .multi_query import motion_costs


def alternative_routes(plan: Plan, k: int = 3, *, penalty: float = 1.0) -> list[Plan]:
    """Up to k routes through the roadmap of a plan, in the order of their costs.

    Each edge that a route uses becomes longer for the routes after it, so they avoid it where they
    can. O(k m log n).

    Parameters
    ----------
    plan : a plan with a roadmap, of `prm`, `prm_star`, `kinodynamic_prm`, `plan_by_visibility` or a
        similar planner.
    k : how many routes.
    penalty : the fraction of its length by which an edge becomes longer each time a route uses it.
        The larger it is, the less the routes share.

    Returns
    -------
    Plans with different paths. They are fewer than k where the penalties lead to no other path, and
    none where the plan has no path.

    Raises
    ------
    InvalidParameter
        Where the plan has no roadmap with its start and goal, `k` is not a positive integer, or
        `penalty` is not positive.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, prm
    >>> wall = [(4, 2), (6, 2), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> plan = prm(Problem(Point(), world, start=(1, 5), goal=(9, 5)), n=200, rng=0)
    >>> below, above = alternative_routes(plan, 2, penalty=10)
    >>> bool(below.cost <= above.cost)
    True
    >>> bool((below.path[:, 1].mean() < 5) != (above.path[:, 1].mean() < 5))
    True
    """
    if not isinstance(plan, Plan) or plan.roadmap is None:
        raise InvalidParameter(
            f"expected a plan with a roadmap, such as prm's, got {shortened(plan)}"
        )
    count, factor = integer(k, "k", least=1), positive(penalty, "penalty")
    if plan.path is None:
        return []
    roadmap, driven = plan.roadmap, isinstance(plan.roadmap, DrivenRoadmap)
    lengths, start, goals = find_lengths_and_ends(plan)
    found: list[NDArray[np.int64]] = []
    weights = lengths.copy()
    for _ in range(3 * count):  # a route may repeat until its penalties suffice
        numbers = find_route(len(roadmap.nodes), roadmap.edges, weights, start, goals, driven)
        if not any(np.array_equal(numbers, other) for other in found):
            found.append(numbers)
        if len(found) == count:
            break
        used = edges_along(roadmap.edges, numbers, driven)
        weights[used] += factor * lengths[used]
    routes = [plan_along_route(plan, numbers) for numbers in found]
    return sorted(routes, key=lambda one: one.cost)


def find_route(
    n: int,
    edges: NDArray[np.int64],
    weights: Array,
    start: int,
    goals: NDArray[np.int64],
    directed: bool,
) -> NDArray[np.int64]:
    """The nodes of the lightest path from the start to any of the goals.

    One more node is added, to which every goal has an edge of weight zero.
    """
    last = np.stack([goals, np.full(len(goals), n)], axis=1)
    graph = flat_graph(
        n + 1,
        np.concatenate([edges, last]),
        np.append(weights, np.zeros(len(goals))),
        directed=directed,
    )
    numbers, _ = astar(graph, start, n)
    if numbers is None:
        raise InvalidParameter(
            "the plan has a path, but its roadmap does not lead from start to goal; plan again"
        )
    return numbers[:-1]


def edges_along(
    edges: NDArray[np.int64], numbers: NDArray[np.int64], directed: bool
) -> NDArray[np.int64]:
    """The numbers of the edges that a path through nodes uses."""
    steps = set(zip(numbers.tolist(), numbers[1:].tolist()))
    if not directed:
        steps |= {(v, u) for u, v in steps}
    return np.array([e for e, (u, v) in enumerate(edges.tolist()) if (u, v) in steps], np.int64)


def find_lengths_and_ends(plan: Plan) -> tuple[Array, int, NDArray[np.int64]]:
    """The length of each edge (m,), the start's node, and the nodes that count as the goal (k,)."""
    roadmap, path = plan.roadmap, plan.path
    assert path is not None  # without one there are no routes
    if isinstance(roadmap, DrivenRoadmap):
        return np.abs(roadmap.controls[:, 0] * roadmap.durations), 0, roadmap.goals
    starts, goals = (np.flatnonzero((roadmap.nodes == end).all(axis=1)) for end in path[[0, -1]])
    if len(starts) == 0 or len(goals) == 0:
        raise InvalidParameter(
            "the ends of the plan's path are no nodes of its roadmap, so no other route is known"
        )
    lengths = motion_costs(as_problem(plan.problem), roadmap.nodes, roadmap.edges)
    return lengths, int(starts[0]), goals[goals != starts[0]] if len(goals) > 1 else goals


def plan_along_route(plan: Plan, numbers: NDArray[np.int64]) -> Plan:
    """The plan with the path through these nodes."""
    if not isinstance(plan.roadmap, DrivenRoadmap):
        unchanged = {"planner": plan.planner, "roadmap": plan.roadmap, "stats": plan.stats}
        return plan_along(as_problem(plan.problem), plan.roadmap.nodes, numbers, "", **unchanged)
    used = edges_along(plan.roadmap.edges, numbers, directed=True)
    used = used[np.argsort(np.searchsorted(numbers, plan.roadmap.edges[used, 1]))]
    assert plan.trajectory is not None  # a driven roadmap comes with one
    drives = plan.roadmap.controls[used], plan.roadmap.durations[used]
    trajectory = TrajectoryRecord(plan.trajectory.start, *drives, plan.trajectory.wheelbase)
    return replace(plan, path=trajectory.poses, cost=trajectory.length, trajectory=trajectory)
