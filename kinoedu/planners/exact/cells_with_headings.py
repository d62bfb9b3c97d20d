"""Vertical cells for a robot that turns: the cells say where to stand, a free heading is found
there, and motions are tried.

Bullo & Smith, chapter 2, for the cells. They are cells of the workspace, made for a point. So
nothing is promised to a body: a motion inside one cell may hit what bounds it, and is judged as any
other.
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...collision import free_headings
from ...decomposition import decomposition_roadmap, trapezoidation
from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...problems import MOTIONS, Plan, ProblemRecord, Recorder
from ...robots.polygon import RigidPolygonRobot
from ...spaces.angles import wrapped
from ...worlds.polygon_world import PolygonWorldRecord
from ..roadmaps.connecting import KClosest, joined
from ..roadmaps.search import Search, dijkstra_path, plan_on_roadmap
from ..tuning import whole


class CellsWithHeadings(NamedTuple):
    """A roadmap over cells, in the order it grew.

    nodes : (n, 3), start, goal, and configurations at the middles of cells and of the walls between
        them. edges : (m, 2), pairs of nodes whose motion is free. empty : (k, 2), the middles at
        which no heading is free.
    """

    nodes: Array
    edges: NDArray[np.int64]
    empty: Array


def cells_with_headings(
    problem: Any, *, headings: int = 1, neighbours: Any = None
) -> CellsWithHeadings:
    """A roadmap of configurations at the middles of vertical cells and of the walls between them,
    joined where motions are free.

    Parameters
    ----------
    problem : a Problem(RigidPolygon(...), PolygonWorld(...), start, goal) without clearance, or a
    Recorder of one.
    headings : how many of each free interval of headings are nodes, evenly spread: of one the
    middle. Within an interval the robot
        can turn on the spot from one to another, between two intervals it cannot.
    neighbours : which are tried with which, a rule such as KClosest(10) or Radius(5); by default
    all with all.

    Not complete: where the free motions lead through other places or headings, none is found.
    Raises InvalidParameter.

    >>> from kinoedu import PolygonWorld, Problem, RigidPolygon
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    >>> bar = RigidPolygon([(-1, -0.2), (1, -0.2), (1, 0.2), (-1, 0.2)])
    >>> roadmap = cells_with_headings(Problem(bar, world, start=(1.5, 1.5, 0), goal=(7.5, 1.5, 0)))
    >>> len(roadmap.nodes), len(roadmap.empty)
    (10, 0)
    """
    robot, world = turning_polygon(problem)
    share = (np.arange(whole(headings, "headings", least=1)) + 0.5) / headings
    places = decomposition_roadmap(trapezoidation(world)).nodes
    found = [free_headings(robot, world, place) for place in places]
    poses = [
        (*place, wrapped(float(theta)))
        for place, rows in zip(places, found)
        for low, high in rows
        for theta in low + share * (high - low)
    ]
    nodes = np.vstack([problem.start, problem.goal, *poses])
    edges, _ = joined(
        KClosest(max(len(nodes) - 1, 1)) if neighbours is None else neighbours, problem, nodes
    )
    return CellsWithHeadings(nodes, edges, places[[len(rows) == 0 for rows in found]])


def plan_by_cells_with_headings(
    problem: Any, *, headings: int = 1, neighbours: Any = None, search: Search = dijkstra_path
) -> Plan:
    """A path along the roadmap of `cells_with_headings`, whose arguments these are, found by any
    graph search.

    search : as in `plan_on_roadmap`; `dfs_path` finds a path, `bfs_path` one of the fewest motions,
        `dijkstra_path` the shortest that the roadmap has. No path means that the roadmap has none,
        not that there is none. Raises InvalidParameter.

    >>> from kinoedu import PolygonWorld, Problem, RigidPolygon, dfs_path
    >>> world = PolygonWorld([(0, 0), (9, 0), (9, 6), (0, 6)], [[(3, 0), (6, 0), (6, 4), (3, 4)]])
    >>> bar = RigidPolygon([(-1, -0.2), (1, -0.2), (1, 0.2), (-1, 0.2)])
    >>> problem = Problem(bar, world, start=(1.5, 1.5, 0), goal=(7.5, 1.5, 0))
    >>> plan_by_cells_with_headings(problem).path is None  # horizontal at every middle, the bar cannot turn the corners
    True
    >>> plans = [plan_by_cells_with_headings(problem, headings=4, search=search) for search in (dijkstra_path, dfs_path)]
    >>> bool(plans[0].cost < plans[1].cost)
    True
    """
    turning_polygon(problem)
    before = problem.asked[MOTIONS]
    roadmap = cells_with_headings(problem, headings=headings, neighbours=neighbours)
    checks = int(problem.asked[MOTIONS] - before)
    plan = plan_on_roadmap(problem, roadmap, search)
    plan.stats.update(checks=checks, empty=len(roadmap.empty))
    return plan


def turning_polygon(problem: Any) -> tuple[RigidPolygonRobot, PolygonWorldRecord]:
    """The robot and the world of a problem in which a polygon turns among polygons. Raises
    InvalidParameter.
    """
    inner = problem.problem if isinstance(problem, Recorder) else problem
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
