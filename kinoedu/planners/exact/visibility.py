"""Visibility roadmaps, and the shortest paths of a point among polygons.

A shortest path is a string pulled tight: it turns only at corners where the free space is reflex,
and is straight between them. So the roadmap joins the corners that see each other, also along
obstacles. Its motions are semi-free: contact is allowed.

Bullo & Smith, chapter 5; LaValle, section 6.2.4.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm
from ...geometry.checks import Array
from ...graphs import astar, flat_graph
from ...problems import Plan, ProblemRecord, Recorder, Roadmap
from ...worlds.polygon_world import PolygonWorldRecord
from ..answers import plan_along
from ..problem_input import check_exact
from .corners import Corners, corners_of
from .rotating_sweep import visible_from


@algorithm
def pairs_in_sight(corners: Any) -> NDArray[np.int64]:
    """The pairs of nodes (m, 2) that see each other, by a sweep round each node."""
    status = np.zeros((len(corners.points) + 1, 6), np.int64)
    pairs, size = np.empty((16, 2), np.int64), 0
    for i in range(len(corners.nodes)):
        v = corners.nodes[i]
        visible = visible_from(corners, v, status)
        for w in corners.nodes[:i]:
            if visible[w]:
                if size == len(pairs):
                    pairs = np.concatenate((pairs, pairs))
                pairs[size, 0], pairs[size, 1] = w, v
                size += 1
    return pairs[:size].copy()


def visibility_roadmap(world: PolygonWorldRecord | ProblemRecord | Recorder) -> Roadmap:
    """The corners round which shortest paths turn, and the semi-free straight motions between them.

    Nodes are the corners where more than half a turn is free: convex ones of obstacles, reflex ones
    of the boundary and of rooms. Corners where obstacles touch are nodes too, because a semi-free
    motion passes between two obstacles that meet in a single point. Edges may run along obstacles
    and pass through corners, but not between two obstacles that touch along a stretch. Every
    decision is exact. O(n^2 log n) for n corners where no obstacles meet, and otherwise times the
    number of families into which they are divided (corners.py).

    Parameters
    ----------
    world : a PolygonWorld, or a Problem(Point(), PolygonWorld(...), start, goal), whose start and
        goal then are the last nodes.

    Returns
    -------
    Roadmap

    Raises
    ------
    InvalidParameter
        Where the robot is not a point, or the world is not of polygons.
    InvalidWorld
        Where the world has round obstacles.

    Examples
    --------
    >>> from kinoedu import PolygonWorld
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    >>> roadmap = visibility_roadmap(world)
    >>> roadmap.nodes.tolist(), roadmap.edges.tolist()
    ([[6.0, 4.0], [3.0, 4.0]], [[0, 1]])
    """
    if isinstance(world, PolygonWorldRecord):
        corners, _ = corners_of(world)
    else:
        check_exact(world, "a visibility roadmap")
        corners, _ = corners_of(world.world, world.start, world.goal)
    return roadmap_of(corners, pairs_in_sight(corners))


def plan_by_visibility(problem: ProblemRecord | Recorder) -> Plan:
    """The shortest semi-free path of a point among polygons, by A* on the visibility roadmap.

    The path touches the corners at which it turns. No path that keeps off them is as short, but
    some come as close as you like, except where it passes between obstacles that touch in a single
    point: there no free path passes, and `plan_by_decomposition` goes round or finds none.
    Complete: where no path is found there is none. The time is that of `visibility_roadmap`.

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
    >>> plan = plan_by_visibility(Problem(Point(), world, start=(0.5, 4), goal=(8.5, 4)))
    >>> plan.path.tolist(), plan.cost
    ([[0.5, 4.0], [8.5, 4.0]], 8.0)
    """
    check_exact(problem, "a visibility roadmap")
    for name, q in (("start", problem.start), ("goal", problem.goal)):
        if not problem.is_semi_free_path(q, q):
            reason = f"the {name} is inside an obstacle or outside the world"
            return plan_along(problem, np.empty((0, 2)), None, reason, planner="visibility")
    corners, (start, goal) = corners_of(problem.world, problem.start, problem.goal)
    roadmap = roadmap_of(corners, pairs_in_sight(corners))
    number = {node: i for i, node in enumerate(corners.nodes.tolist())}
    a, b = roadmap.nodes[roadmap.edges[:, 0]], roadmap.nodes[roadmap.edges[:, 1]]
    graph = flat_graph(len(roadmap.nodes), roadmap.edges, lengths_between(a, b))
    heuristic = lengths_between(roadmap.nodes, problem.goal)
    numbers, _ = astar(graph, number[start], number[goal], heuristic)
    if numbers is not None and start == goal:
        numbers = np.append(numbers, numbers)
    reason = ""
    if numbers is None:
        reason = "there is no path, not even one in contact: obstacles part the start from the goal"
    stats = {"nodes": len(roadmap.nodes), "edges": len(roadmap.edges)}
    return plan_along(
        problem, roadmap.nodes, numbers, reason, planner="visibility", roadmap=roadmap, stats=stats
    )


def roadmap_of(corners: Corners, pairs: NDArray[np.int64]) -> Roadmap:
    """The roadmap of the nodes alone, numbered in their order."""
    return Roadmap(corners.points[corners.nodes], np.searchsorted(corners.nodes, pairs))


def lengths_between(a: Array, b: Array) -> Array:
    """The distances between points, shape (n,)."""
    return np.sqrt(((a - b) ** 2).sum(axis=1))
