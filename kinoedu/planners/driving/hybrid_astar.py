"""Hybrid A*: a search over cells of poses, each of which keeps a pose that the car can drive to.

    hybrid-A*(start, goal)
     1  cost(start) := 0; insert start into an empty priority queue Q
     2  while Q is not empty:
     3      q := retrieve from Q the pose with the least cost(q) + curve(q, goal)
     4      if the curve from q to the goal is free: return the drive to q, and on along the curve
     5      for each move of the car from q, to q':
     6          if no pose in the cell of q' costs as little, and the move is free:
     7              insert q' into Q, at cost(q) + the move's length

The heuristic is the length of the shortest curve to the goal. When such a curve is free, the drive
that it completes is as short as any that the queue can still lead to.

Where a search runs out of cells, finer ones follow. A car that can reverse is also searched for
from the goal, and the drive turned round: out of a tight place there are many ways, into it few.

D. Dolgov, S. Thrun, M. Montemerlo, J. Diebel, "Path planning for autonomous vehicles in unknown
semi-structured environments" (2010).
"""

import math
from heapq import heappop, heappush
from typing import Any, NamedTuple

import numpy as np

from ...compiled import algorithm
from ...graphs import extract_path
from ...problems import Plan, ProblemRecord, Recorder
from ...problems.protocols import CarProblem
from ...problems.recorder import record_as, unwrap_recorder
from ...robots.car import CarRobot
from ...robots.trajectory import DrivenTree, TrajectoryRecord
from ..problem_input import count_checks
from ..tuning import integer
from .common import DrivenGrowth, add_drive, begin_tree, check_car, copy_tree
from .lattice import Lattice, cell_of, lattices_for
from .trajectories import controls_along


@algorithm
def drive_by_cells(problem: CarProblem, growth: DrivenGrowth, lattice: Lattice) -> tuple[int, int]:
    """Lines 1 to 7, until a curve to the goal is free, no pose is left, or the tree is full.

    Returns
    -------
    The node where that curve begins, or -1, and how many nodes were expanded.
    """
    tree, there, expanded = growth.tree, np.empty(3), 0
    cost = np.zeros(len(tree.nodes))
    reached = {cell_of(lattice, problem.start): 0.0}  # the least cost in each cell
    left = problem.distance(problem.start, problem.goal)
    frontier = [(left, left, 0)]
    while len(frontier) > 0 and tree.size[0] + len(lattice.moves) <= len(tree.nodes):
        _, _, node = heappop(frontier)
        q = tree.nodes[node]
        if cost[node] > reached[cell_of(lattice, q)]:  # the cell holds a cheaper pose
            continue
        expanded += 1
        if problem.is_free_path(q, problem.goal):
            return node, expanded
        for v, phi in lattice.moves:
            t = lattice.step_size / abs(v)
            problem.drive(q, v, phi, t, there)
            cell, c = cell_of(lattice, there), cost[node] + lattice.step_size
            if c < reached.get(cell, np.inf) and problem.is_free_drive(q, v, phi, t):
                reached[cell] = c
                new = add_drive(problem, growth, node, v, phi, t)
                cost[new] = c
                left = problem.distance(there, problem.goal)
                heappush(frontier, (c + left, left, new))
    return -1, expanded


class LatticeSearch(NamedTuple):
    """A search of one lattice, from the start or, where `backward`, from the goal.

    tree : the drives from that end. last : the node where the curve to the other end begins, or -1.
    expanded : how many nodes were expanded. full : whether it ended because the tree was full.
    """

    backward: bool
    lattice: Lattice
    tree: DrivenTree
    last: int
    expanded: int
    full: bool


def hybrid_astar(
    problem: ProblemRecord | Recorder,
    *,
    spacing: float | None = None,
    step_size: float | None = None,
    angles: int = 3,
    max_nodes: int = 100_000,
) -> Plan:
    """Plan by hybrid A*: the shortest drive over cells of poses that ends in a curve to the goal.

    No random numbers are used. Searches from the start and, for a car that can reverse, from the
    goal take turns; by default they become finer by themselves where it is tight. Complete for
    their lattices only. O(n log n) for n nodes.

    Parameters
    ----------
    problem : a Problem of a Car, or a Recorder of one.
    spacing : the side of a cell. By default it is refined, from a quarter of the wheelbase.
    step_size : the length of each move; by default 1.5 times the spacing, so that a move leaves
        its cell. There are as many headings as moves at full steering in a full turn. Where one of
        both is given, nothing is refined.
    angles : how many steering angles are tried, from full right to full left, forward and, if the
        car can reverse, backward.
    max_nodes : stop each search at this many nodes.

    Returns
    -------
    Plan with its `trajectory`, which ends at the goal up to rounding, and the `tree` of the last
    search, whose root is the goal if it began there. `stats` count all searches. Without a path
    `plan.reason` says why.

    Raises
    ------
    InvalidParameter
        Where the robot is not a car, or a parameter is out of its range.

    Examples
    --------
    >>> from kinoedu import Car, PolygonWorld, Problem
    >>> wall = [(9, 0), (11, 0), (11, 10), (9, 10)]
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], [wall])
    >>> plan = hybrid_astar(Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0)))
    >>> plan.path[-1].round(9), bool(20 < plan.cost < 30)
    (array([16.,  4.,  0.]), True)
    """
    inner = check_car(problem, "hybrid_astar")
    lattices = lattices_for(inner, spacing, step_size, integer(angles, "angles", least=2))
    limit, before = integer(max_nodes, "max_nodes", least=1), count_checks(inner)
    searches, drive = search_by_turns(problem, lattices, limit)
    last, expanded = searches[-1], sum(search.expanded for search in searches)
    built: dict[str, Any] = {"tree": last.tree, "problem": problem, "planner": "hybrid A*"}
    built["stats"] = {
        "nodes": sum(len(search.tree.nodes) for search in searches),
        "expanded": expanded,
        "checks": count_checks(inner) - before,
        "searches": len(searches),
    }
    if drive is None:
        finest = min(search.lattice.side for search in searches)
        reason = (
            f"none of {expanded:,} poses has a free curve to the other end; allow more nodes, or a "
            f"finer spacing than {finest:.3g}"
        )
        return Plan(None, math.inf, reason=reason, **built)
    return Plan(drive.poses, drive.length, trajectory=drive, **built)


def search_by_turns(
    problem: ProblemRecord | Recorder, lattices: list[Lattice], max_nodes: int
) -> tuple[list[LatticeSearch], TrajectoryRecord | None]:
    """Search from the start and from the goal, ever finer, until a free drive is found.

    It is the turn of the end whose last search had the fewest nodes: there it is tight, and a finer
    search costs little. Where a search was full, a finer one would come less far.

    Returns
    -------
    The searches in order, and the drive from the start to the goal, or None.
    """
    searches, drive = list[LatticeSearch](), None
    both_ways = unwrap_recorder(problem).robot.both_ways
    turns = [(0, 0, False), (0, 0, True)] if both_ways else [(0, 0, False)]
    while drive is None and turns:
        _, level, backward = heappop(turns)
        search = search_lattice(problem, lattices[level], backward, max_nodes)
        searches.append(search)
        drive = drive_along(unwrap_recorder(problem), search)
        if not search.full and level + 1 < len(lattices):
            heappush(turns, (len(search.tree.nodes), level + 1, backward))
    return searches, drive


def search_lattice(
    problem: ProblemRecord | Recorder, lattice: Lattice, backward: bool, max_nodes: int
) -> LatticeSearch:
    """Search one lattice; `backward` from the goal."""
    inner = unwrap_recorder(problem)
    if backward:
        inner = turn_round(inner)
    growth = begin_tree(inner, max_nodes + len(lattice.moves))
    last, expanded = drive_by_cells(record_as(problem, inner), growth, lattice)
    tree = copy_tree(growth)
    full = len(tree.nodes) > max_nodes
    return LatticeSearch(backward, lattice, tree, int(last), int(expanded), full)


def drive_along(problem: ProblemRecord, search: LatticeSearch) -> TrajectoryRecord | None:
    """The drive that a search found, from the start to the goal; None where there is none.

    It is checked as it is driven, since a drive turned round is rounded otherwise.
    """
    if search.last < 0:
        return None
    car, tree, here = problem.robot, search.tree, problem
    if search.backward:
        here = turn_round(problem)
    numbers = extract_path(tree.parent, search.last)[1:]
    controls, durations = controls_along(car, tree.nodes[search.last], here.goal)
    drive = TrajectoryRecord(
        here.start.copy(),
        np.concatenate([tree.controls[numbers], controls]),
        np.concatenate([tree.durations[numbers], durations]),
        car.wheelbase,
    )
    if search.backward:
        drive = shift_gears(car, drive.reversed._replace(start=problem.start.copy()))
    moves = zip(drive.poses, drive.controls, drive.durations)
    free = all(problem.is_free_drive(q, v, phi, t) for q, (v, phi), t in moves)
    return drive if free else None


def turn_round(problem: ProblemRecord) -> ProblemRecord:
    """The problem from the goal to the start."""
    return problem._replace(start=problem.goal, goal=problem.start)


def shift_gears(car: CarRobot, drive: TrajectoryRecord) -> TrajectoryRecord:
    """The same drive at the car's highest speeds forward and backward."""
    lengths = drive.controls[:, 0] * drive.durations
    speeds = np.where(lengths > 0.0, car.speeds.max(), car.speeds.min())
    controls = np.stack([speeds, drive.controls[:, 1]], axis=1)
    return drive._replace(controls=controls, durations=lengths / speeds)
