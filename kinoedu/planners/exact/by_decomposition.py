"""Planning by decomposition and search: cut the free space into cells, and go from cell to cell.

The planner is exact and complete: it finds a path whenever there is one, and reports after finite
time that there is none. Bullo & Smith, chapter 2.
"""

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm
from ...decomposition import decomposition_roadmap, trapezoidation
from ...geometry.checks import Array
from ...graphs import Graph, astar, dijkstra
from ...problems import Plan, ProblemRecord, Recorder, Roadmap
from ..answers import plan_along
from ..problem_input import check_exact, count_checks


def plan_by_decomposition(problem: ProblemRecord | Recorder) -> Plan:
    """Plan through the cells of a decomposition and the midpoints of the walls between them.

    The nodes of the roadmap are the centres of the cells, the midpoints of the walls between cells,
    and last the start and the goal. These two are joined to the centres of their cells, and to each
    other where they share a cell. A* finds the shortest path in the roadmap, which is not the
    shortest of all. The problem checks every motion too, because rounding may close a passage
    narrower than floats can represent; `plan.reason` distinguishes this from a world without a
    path. The path is free: it does not pass between obstacles that touch in a single point, as the
    semi-free path of `plan_by_visibility` does. O(n log n) for n vertices.

    Parameters
    ----------
    problem : a Problem(Point(), PolygonWorld(...), start, goal) without clearance, or a Recorder of
        one.

    Returns
    -------
    Plan with its `roadmap`.

    Raises
    ------
    InvalidParameter
        Where the robot is not a point, or the world is not of polygons.
    InvalidWorld
        Where the world has round obstacles.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    >>> plan = plan_by_decomposition(Problem(Point(), world, start=(1, 1), goal=(8, 1)))
    >>> plan.path.tolist()
    [[1.0, 1.0], [1.5, 3.0], [3.0, 5.0], [4.5, 5.0], [6.0, 5.0], [7.5, 3.0], [8.0, 1.0]]
    """
    check_exact(problem, "planning by decomposition")
    cut = trapezoidation(problem.world)
    at_start, at_goal = cut.cells_at(problem.start), cut.cells_at(problem.goal)
    roadmap = add_ends(decomposition_roadmap(cut), problem, at_start, at_goal)
    n, start, goal = len(cut.trapezoids), len(roadmap.nodes) - 2, len(roadmap.nodes) - 1
    before = count_checks(problem)
    free, lengths = check_edges(problem, *roadmap)
    graph = Graph(len(roadmap.nodes), roadmap.edges[free], lengths[free])
    heuristic = np.sqrt(((roadmap.nodes - problem.goal) ** 2).sum(axis=1))
    numbers, _ = astar(graph, start, goal, heuristic)
    reason = explain_no_path(roadmap, free, n) if numbers is None else ""
    stats = {
        "cells": n,
        "nodes": len(roadmap.nodes),
        "edges": len(roadmap.edges),
        "checks": count_checks(problem) - before,
    }
    shown = Roadmap(roadmap.nodes, roadmap.edges[free])
    return plan_along(
        problem, roadmap.nodes, numbers, reason, planner="decomposition", roadmap=shown, stats=stats
    )


def add_ends(
    roadmap: Roadmap,
    problem: ProblemRecord | Recorder,
    at_start: NDArray[np.int64],
    at_goal: NDArray[np.int64],
) -> Roadmap:
    """The roadmap with start and goal as its last nodes.

    They are joined to the cells that hold them, and to each other where they share a cell.
    """
    start, goal = len(roadmap.nodes), len(roadmap.nodes) + 1
    joined = [(start, cell) for cell in at_start] + [(cell, goal) for cell in at_goal]
    if np.intersect1d(at_start, at_goal).size:
        joined.append((start, goal))
    edges = np.concatenate([roadmap.edges, np.array(joined, np.int64).reshape(-1, 2)])
    return Roadmap(np.concatenate([roadmap.nodes, [problem.start, problem.goal]]), edges)


@algorithm
def check_edges(
    problem: ProblemRecord | Recorder, nodes: Array, edges: NDArray[np.int64]
) -> tuple[NDArray[np.bool_], Array]:
    """Whether each edge (m, 2) is free, and its length, both (m,)."""
    free, lengths = np.empty(len(edges), np.bool_), np.empty(len(edges))
    for k in range(len(edges)):
        a, b = nodes[edges[k, 0]], nodes[edges[k, 1]]
        free[k] = problem.is_free_path(a, b)
        lengths[k] = problem.distance(a, b)
    return free, lengths


def explain_no_path(roadmap: Roadmap, free: NDArray[np.bool_], n: int) -> str:
    """Why start and goal, the last two nodes, are not connected; the first n nodes are cells."""
    start, goal = len(roadmap.nodes) - 2, len(roadmap.nodes) - 1
    graph = Graph(len(roadmap.nodes), roadmap.edges)
    from_start, from_goal = (np.isfinite(dijkstra(graph, q).cost) for q in (start, goal))
    for alone, name in ((from_start, "start"), (from_goal, "goal")):
        if alone[:n].sum() == 0:
            return f"the {name} is within rounding of an obstacle; move it away from it"
    if from_start[goal]:
        walls = np.unique(roadmap.edges[~free].max(axis=1))  # cells have smaller numbers
        return (
            f"the passages at {len(walls):,} of the walls between cells are shut, or narrower than "
            "floats can represent, and no path avoids them; widen them"
        )
    return (
        f"there is no path: the start lies in a part of {from_start[:n].sum():,} cells that does "
        f"not touch the goal's part of {from_goal[:n].sum():,}"
    )
