"""Safe-interval path planning (SIPP): the earliest arrival on a roadmap among moving obstacles.

M. Phillips, M. Likhachev, "SIPP: Safe interval path planning for dynamic environments" (2011);
LaValle, section 7.1.
"""

from __future__ import annotations

from heapq import heappop, heappush
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...collision.collision_intervals import (
    collision_intervals,
    find_safe_intervals,
    first_free_time,
    relative_obstacles,
)
from ...compiled import algorithm, inlined
from ...errors import InvalidParameter
from ...geometry.checks import Array, as_point
from ...geometry.exact import length
from ...geometry.parts import Parts
from ...graphs import GraphRecord, flat_graph
from ...problems import Plan, Problem, Roadmap
from ...problems.in_time import TimedProblemRecord
from ...support.text import shortened
from ..roadmaps.connecting import KClosest, connect_nodes
from ..roadmaps.prm import free_configurations
from ..tuning import integer


@algorithm
def search_intervals(
    problem: TimedProblemRecord,
    graph: GraphRecord,
    nodes: Array,
    safe: Array,
    first: NDArray[np.int64],
    hulls: Parts,
    knots: NDArray[np.int64],
) -> tuple[Array, Array, NDArray[np.int64], int]:
    """Dijkstra's algorithm over the safe intervals of all nodes, from the first interval of node 0.

    Returns
    -------
    arrival : for each interval the earliest time at which the robot can be there.
    departure : when it left the interval before.
    parent : the number of that interval.
    at_goal : the interval of the goal, node 1, that was reached first, or -1.
    """
    arrival, departure = np.full(len(safe), np.inf), np.zeros(len(safe))
    parent, owner = np.full(len(safe), -1), np.empty(len(safe), np.int64)
    times, places = problem.world.times, problem.world.places
    for u in range(len(nodes)):
        owner[first[u] : first[u + 1]] = u
    arrival[0] = 0.0
    frontier = [(0.0, 0)]
    while len(frontier) > 0:
        when, here = heappop(frontier)
        u = owner[here]
        if when > arrival[here]:  # it was reached earlier and has been expanded
            continue
        if u == 1:
            return arrival, departure, parent, here
        for k in range(graph.first[u], graph.first[u + 1]):
            v, duration = graph.to[k], graph.weight[k] / problem.speed
            if not may_gain(arrival, safe, here, first[v], first[v + 1], duration):
                continue
            vx, vy = (nodes[v, 0] - nodes[u, 0]) / duration, (nodes[v, 1] - nodes[u, 1]) / duration
            collisions = collision_intervals(
                hulls, knots, times, places, problem.horizon, nodes[u], vx, vy, duration
            )
            for there in range(first[v], first[v + 1]):
                t = first_free_time(collisions, max(arrival[here], safe[there, 0] - duration))
                arrives = max(t + duration, safe[there, 0])  # the sum may be rounded to just before
                on_time = t <= safe[here, 1] and arrives <= safe[there, 1]
                if (
                    on_time
                    and arrives < arrival[there]
                    and is_free_ride(problem, nodes[u], nodes[v], arrival[here], t, arrives)
                ):
                    arrival[there], departure[there], parent[there] = arrives, t, here
                    heappush(frontier, (arrives, there))
    return arrival, departure, parent, -1


@inlined
def may_gain(arrival: Array, safe: Array, here: int, begin: int, end: int, duration: float) -> bool:
    """Whether an earlier arrival at one of the intervals from `begin` to `end` is possible at all.

    Nothing that moves on the way is considered here.
    """
    for there in range(begin, end):
        t = max(arrival[here], safe[there, 0] - duration)
        if t <= safe[here, 1] and t + duration <= safe[there, 1] and t + duration < arrival[there]:
            return True
    return False


@inlined
def is_free_ride(
    problem: TimedProblemRecord, a: Array, b: Array, arrived: float, left: float, arrives: float
) -> bool:
    """Whether the robot can wait at a, and then go to b, without contact."""
    begin, end = np.array([a[0], a[1], arrived]), np.array([a[0], a[1], left])
    return problem.is_free_path(begin, end) and problem.is_free_path(
        end, np.array([b[0], b[1], arrives])
    )


def safe_intervals(problem: TimedProblemRecord, q: ArrayLike) -> Array:
    """The intervals of [0, horizon] in which the robot may stand at a place without contact.

    Round shapes count as half a percent larger than they are. Where a static obstacle is in the
    way, there is no interval.

    Returns
    -------
    (k, 2) array of intervals (begin, end), in order.

    Raises
    ------
    InvalidPoint
        Where q is not a point.
    InvalidParameter
        Where `problem` is not a TimedProblem.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld
    >>> from kinoedu.problems.in_time import TimedProblem
    >>> from kinoedu.worlds import Moving, MovingWorld
    >>> hall = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    >>> box = Moving([(-1, -1), (1, -1), (1, 1), (-1, 1)], [0, 10], [(9, 3), (-1, 3)])
    >>> world = MovingWorld(hall, [box])
    >>> problem = TimedProblem(Point(), world, start=(1, 1), goal=(9, 3), horizon=20)
    >>> safe_intervals(problem, (5, 3)).round(3)
    array([[ 0.,  3.],
           [ 5., 20.]])
    """
    task, place = as_timed(problem), as_point(q, "q")
    still = Problem(task.robot, task.world.still, task.goal, task.goal, clearance=task.clearance)
    if not still.is_free(place):
        return np.empty((0, 2))
    hulls, knots = relative_obstacles(task.robot, task.world, task.clearance)
    return find_safe_intervals(
        hulls, knots, task.world.times, task.world.places, task.horizon, place[None]
    )[0]


def plan_in_time(
    problem: TimedProblemRecord, *, n: int = 300, k: int = 10, rng: int | np.random.Generator
) -> Plan:
    """The earliest arrival at the goal on a roadmap of the static world, with waits at its nodes.

    The robot goes along edges at its greatest speed. The earliest arrival in a safe interval of a
    node is as good as any other, because the robot may wait there. So each interval is reached
    once, and the result is the earliest arrival on this roadmap; without a path, another roadmap
    may have one. Every motion and every wait is checked along its whole length. The goal must be
    free at the moment of arrival only.

    Parameters
    ----------
    problem : a TimedProblem.
    n, k : how many nodes are sampled, and with how many closest ones each is joined, as in `prm`.
    rng : a seed or a numpy Generator.

    Returns
    -------
    Plan whose path (m, 3) has rows (x, y, t), and whose cost is the time of arrival. Without a path
    `plan.reason` says why.

    Raises
    ------
    InvalidParameter
        Where `problem` is not a TimedProblem, or a parameter is out of its range.

    Examples
    --------
    >>> from kinoedu import Disk, PolygonWorld
    >>> from kinoedu.problems.in_time import TimedProblem
    >>> from kinoedu.worlds import Moving, MovingWorld
    >>> hall = PolygonWorld([(0, 0), (10, 0), (10, 6), (0, 6)])
    >>> world = MovingWorld(hall, [Moving(1.0, [0, 10], [(9, 3), (-1, 3)])])
    >>> plan = plan_in_time(TimedProblem(Disk(0.5), world, start=(1, 3), goal=(9, 3)), rng=0)
    >>> bool(8 < plan.cost < 10), plan.path[-1, 2] == plan.cost
    (True, np.True_)
    """
    task = as_timed(problem)
    still = Problem(task.robot, task.world.still, task.start, task.goal, clearance=task.clearance)
    sampled = free_configurations(still, integer(n, "n", least=0), None, rng)
    nodes = np.concatenate([[still.start, still.goal], sampled])
    edges, costs = connect_nodes(KClosest(k), still, nodes)
    apart = costs > 0.0
    graph = flat_graph(len(nodes), edges[apart], costs[apart])
    hulls, knots = relative_obstacles(task.robot, task.world, task.clearance)
    safe, first = find_safe_intervals(
        hulls, knots, task.world.times, task.world.places, task.horizon, nodes
    )
    stats = {"nodes": len(nodes), "edges": len(graph.edges), "intervals": len(safe)}
    built: dict[str, Any] = {
        "roadmap": Roadmap(nodes, graph.edges),
        "stats": stats,
        "problem": task,
        "planner": "safe intervals",
    }
    if length(*(still.goal - still.start)) == 0.0:
        return Plan(np.append(task.start, 0.0)[None], 0.0, **built)
    if first[1] == 0 or safe[0, 0] > 0.0:
        reason = "the start is not in a safe interval at time 0; let the robot start elsewhere"
        return Plan(None, np.inf, reason=reason, **built)
    arrival, departure, parent, at_goal = search_intervals(
        task, graph, nodes, safe, first, hulls, knots
    )
    if at_goal < 0:
        reason = (
            f"on a roadmap of {len(nodes):,} nodes no way reaches the goal by the time "
            f"{task.horizon:g}; sample more nodes"
        )
        return Plan(None, np.inf, reason=reason, **built)
    owner = np.repeat(np.arange(len(nodes)), np.diff(first))
    path = timed_path(nodes[owner], arrival, departure, parent, at_goal)
    return Plan(path, float(arrival[at_goal]), **built)


def timed_path(
    places: Array, arrival: Array, departure: Array, parent: NDArray[np.int64], last: int
) -> Array:
    """The rows (x, y, t) of the path to an interval: arrivals, and departures after waits."""
    rows = [(*places[last], arrival[last])]
    while parent[last] >= 0:
        before = parent[last]
        rows.append((*places[before], departure[last]))
        if departure[last] > arrival[before]:
            rows.append((*places[before], arrival[before]))
        last = before
    return np.array(rows[::-1])


def as_timed(problem: TimedProblemRecord) -> TimedProblemRecord:
    """A timed problem; raises InvalidParameter for any other."""
    if not isinstance(problem, TimedProblemRecord):
        raise InvalidParameter(
            "expected a TimedProblem(robot, MovingWorld(...), start, goal), got "
            f"{shortened(problem)}"
        )
    return problem
