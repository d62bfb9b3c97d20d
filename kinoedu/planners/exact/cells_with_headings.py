"""Vertical cells for a robot that turns: free headings at places given by cells of the workspace.

The cells are those of a point (Bullo & Smith, chapter 2), so nothing is guaranteed for a polygon: a
motion inside one cell may hit what bounds it. Every motion is therefore checked.
"""

from __future__ import annotations

import numpy as np

from ...collision import free_headings
from ...decomposition import decomposition_roadmap, trapezoidation
from ...errors import InvalidParameter
from ...problems import CellsWithHeadings, Plan, ProblemRecord, Recorder
from ...problems.recorder import unwrap_recorder
from ...robots.polygon import RigidPolygonRobot
from ...spaces.angles import wrap_angle
from ...worlds.polygon_world import PolygonWorldRecord
from ..problem_input import count_checks
from ..roadmaps.connecting import KClosest, Rule, connect_nodes
from ..roadmaps.search import GraphSearch, dijkstra_path, plan_on_roadmap
from ..tuning import integer


def cells_with_headings(
    problem: ProblemRecord | Recorder, *, headings: int = 1, neighbours: Rule | None = None
) -> CellsWithHeadings:
    """A roadmap of configurations at the centres of vertical cells and midpoints of their walls.

    Not complete: where the free motions need other places or headings, no path is found.

    Parameters
    ----------
    problem : a Problem(RigidPolygon(...), PolygonWorld(...), start, goal) without clearance, or a
        Recorder of one.
    headings : how many headings of each free interval become nodes, evenly spaced; one is its
        middle. The robot can turn on the spot within an interval, but not from one interval to
        another.
    neighbours : a rule for the pairs that are tried, such as KClosest(10) or Radius(5); by default
        all pairs.

    Returns
    -------
    CellsWithHeadings

    Raises
    ------
    InvalidParameter
        Where the robot is not a rigid polygon among polygons, or a parameter is out of its range.
    InvalidWorld
        Where an obstacle is round.

    Examples
    --------
    >>> from kinoedu import PolygonWorld, Problem, RigidPolygon
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    >>> bar = RigidPolygon([(-1, -0.2), (1, -0.2), (1, 0.2), (-1, 0.2)])
    >>> roadmap = cells_with_headings(Problem(bar, world, start=(1.5, 1.5, 0), goal=(7.5, 1.5, 0)))
    >>> len(roadmap.nodes), len(roadmap.empty)
    (10, 0)
    """
    robot, world = turning_polygon(problem)
    fractions = (np.arange(integer(headings, "headings", least=1)) + 0.5) / headings
    places = decomposition_roadmap(trapezoidation(world)).nodes
    found = [free_headings(robot, world, place) for place in places]
    poses = [
        (*place, wrap_angle(float(theta)))
        for place, rows in zip(places, found)
        for low, high in rows
        for theta in low + fractions * (high - low)
    ]
    nodes = np.vstack([problem.start, problem.goal, *poses])
    rule = KClosest(max(len(nodes) - 1, 1)) if neighbours is None else neighbours
    edges, _ = connect_nodes(rule, problem, nodes)
    return CellsWithHeadings(nodes, edges, places[[len(rows) == 0 for rows in found]])


def plan_by_cells_with_headings(
    problem: ProblemRecord | Recorder,
    *,
    headings: int = 1,
    neighbours: Rule | None = None,
    search: GraphSearch = dijkstra_path,
) -> Plan:
    """The path that a graph search finds in the roadmap of `cells_with_headings`.

    Where the roadmap has no path, the problem may still have one. The other parameters and the
    errors are those of `cells_with_headings`.

    Parameters
    ----------
    search : as in `plan_on_roadmap`: `dfs_path` finds some path, `bfs_path` one with the fewest
        motions, `dijkstra_path` the shortest.

    Returns
    -------
    Plan with its `roadmap`.

    Examples
    --------
    >>> from kinoedu import PolygonWorld, Problem, RigidPolygon, dfs_path
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    >>> bar = RigidPolygon([(-1, -0.2), (1, -0.2), (1, 0.2), (-1, 0.2)])
    >>> problem = Problem(bar, world, start=(1.5, 1.5, 0), goal=(7.5, 1.5, 0))

    With one heading, horizontal everywhere, the bar cannot turn the corners.

    >>> plan_by_cells_with_headings(problem).path is None
    True
    >>> shortest = plan_by_cells_with_headings(problem, headings=4)
    >>> bool(shortest.cost < plan_by_cells_with_headings(problem, headings=4, search=dfs_path).cost)
    True
    """
    turning_polygon(problem)
    before = count_checks(problem)
    roadmap = cells_with_headings(problem, headings=headings, neighbours=neighbours)
    checks = count_checks(problem) - before
    plan = plan_on_roadmap(problem, roadmap, search)
    plan.stats.update(checks=checks, empty=len(roadmap.empty))
    return plan


def turning_polygon(
    problem: ProblemRecord | Recorder,
) -> tuple[RigidPolygonRobot, PolygonWorldRecord]:
    """The robot and the world of a problem in which a polygon turns among polygons.

    Raises
    ------
    InvalidParameter
        Where the robot or the world is another.
    """
    inner = unwrap_recorder(problem)
    if (
        not isinstance(inner, ProblemRecord)
        or not isinstance(inner.robot, RigidPolygonRobot)
        or inner.clearance > 0.0
    ):
        raise InvalidParameter(
            "cells with headings need a Problem(RigidPolygon(...), PolygonWorld(...), start, "
            "goal) without clearance"
        )
    if not isinstance(inner.world, PolygonWorldRecord):
        raise InvalidParameter(
            "vertical cells are those of a PolygonWorld; plan with rrt or prm on a bitmap"
        )
    return inner.robot, inner.world
