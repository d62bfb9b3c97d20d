"""Planning by decomposition and search: cut the free space into cells, and walk from cell to cell.

Bullo & Smith, chapter 2.

The planner is exact and complete: it finds a path whenever there is one, and says after finite time
that there is none.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm
from ...decomposition import decomposition_roadmap, trapezoidation
from ...geometry.checks import Array
from ...graphs import Graph, astar, dijkstra
from ...problems import MOTIONS, Plan, Roadmap
from ..answers import plan_along
from ..problem_input import check_exact


def plan_by_decomposition(problem: Any) -> Plan:
    """Find the cells of start and goal, and go from cell to cell through the middles of the walls
    between them.

    problem : a Problem(Point(), PolygonWorld(...), start, goal) without clearance, or a Recorder of
        one.

    The roadmap has the centres of the cells, the middles of the walls, and last the start and the
    goal, each joined to the centre of its cell, and to each other where they share one. A* finds
    the shortest path in it, which is not the shortest of all. Every motion is judged by the problem
    too, because a passage narrower than floats can tell may be lost to rounding; `plan.reason`
    tells such a case from one without a path. O(n log n) for n vertices. Raises InvalidParameter,
    InvalidWorld.

    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    >>> plan = plan_by_decomposition(Problem(Point(), world, start=(1, 1), goal=(8, 1)))
    >>> plan.path.tolist()
    [[1.0, 1.0], [1.5, 3.0], [3.0, 5.0], [4.5, 5.0], [6.0, 5.0], [7.5, 3.0], [8.0, 1.0]]
    """
    check_exact(problem, "planning by decomposition")
    cut = trapezoidation(problem.world)
    at_start, at_goal = cut.cells_at(problem.start), cut.cells_at(problem.goal)
    roadmap = with_ends(decomposition_roadmap(cut), problem, at_start, at_goal)
    n, start, goal = len(cut.trapezoids), len(roadmap.nodes) - 2, len(roadmap.nodes) - 1
    before = problem.asked[MOTIONS]
    free, lengths = judge(problem, *roadmap)
    graph = Graph(len(roadmap.nodes), roadmap.edges[free], lengths[free])
    numbers, _ = astar(
        graph, start, goal, np.sqrt(((roadmap.nodes - problem.goal) ** 2).sum(axis=1))
    )
    reason = why_apart(roadmap, free, n) if numbers is None else ""
    stats = {
        "cells": n,
        "nodes": len(roadmap.nodes),
        "edges": len(roadmap.edges),
        "checks": int(problem.asked[MOTIONS] - before),
    }
    shown = Roadmap(roadmap.nodes, roadmap.edges[free])
    return plan_along(
        problem, roadmap.nodes, numbers, reason, planner="decomposition", roadmap=shown, stats=stats
    )


def with_ends(
    roadmap: Roadmap, problem: Any, at_start: NDArray[np.int64], at_goal: NDArray[np.int64]
) -> Roadmap:
    """The roadmap with start and goal as its last nodes, joined to the cells that hold them, and to
    each other in a common one.
    """
    start, goal = len(roadmap.nodes), len(roadmap.nodes) + 1
    joined = [(start, cell) for cell in at_start] + [(cell, goal) for cell in at_goal]
    if np.intersect1d(at_start, at_goal).size:
        joined.append((start, goal))
    edges = np.concatenate([roadmap.edges, np.array(joined, np.int64).reshape(-1, 2)])
    return Roadmap(np.concatenate([roadmap.nodes, [problem.start, problem.goal]]), edges)


@algorithm
def judge(problem: Any, nodes: Array, edges: NDArray[np.int64]) -> tuple[NDArray[np.bool_], Array]:
    """Whether each edge (m, 2) is free, and its length, (m,)."""
    free, lengths = np.empty(len(edges), np.bool_), np.empty(len(edges))
    for k in range(len(edges)):
        a, b = nodes[edges[k, 0]], nodes[edges[k, 1]]
        free[k] = problem.is_free_path(a, b)
        lengths[k] = problem.distance(a, b)
    return free, lengths


def why_apart(roadmap: Roadmap, free: NDArray[np.bool_], n: int) -> str:
    """Why start and goal, the last two nodes, are not joined; the first n nodes are the cells."""
    start, goal = len(roadmap.nodes) - 2, len(roadmap.nodes) - 1
    whole = Graph(len(roadmap.nodes), roadmap.edges)
    from_start, from_goal = (np.isfinite(dijkstra(whole, q).cost) for q in (start, goal))
    for alone, name in ((from_start, "start"), (from_goal, "goal")):
        if alone[:n].sum() == 0:
            return (
                f"the {name} is closer to an obstacle than rounding can tell; move it into the open"
            )
    if from_start[goal]:
        return (
            f"{(~free).sum():,} passages are narrower than floats can tell, and no way round them "
            "was found; widen them"
        )
    return (
        f"there is no path: the start lies in a part of {from_start[:n].sum():,} cells that does "
        "not touch the goal's part of"
        f" {from_goal[:n].sum():,}"
    )
