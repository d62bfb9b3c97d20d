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

D. Dolgov, S. Thrun, M. Montemerlo, J. Diebel, "Path planning for autonomous vehicles in unknown
semi-structured environments" (2010).
"""

import math
from heapq import heappop, heappush
from typing import Any, NamedTuple

import numpy as np

from ...compiled import algorithm, compiled
from ...errors import InvalidParameter
from ...geometry.checks import Array
from ...graphs import extract_path
from ...problems import Plan, ProblemRecord, Recorder
from ...problems.protocols import CarProblem
from ...robots.trajectory import TrajectoryRecord
from ..problem_input import count_checks
from ..tuning import integer, positive
from .common import DrivenGrowth, add_drive, begin_tree, check_car, copy_tree
from .trajectories import controls_along


class Lattice(NamedTuple):
    """The cells of poses and the moves between them.

    Cells are squares of side `side` from (x, y), `columns` of them in a row, each divided into
    `headings` headings. moves (m, 2) are controls (v, phi); each is held for a drive of length
    `step_size`.
    """

    x: float
    y: float
    side: float
    columns: int
    headings: int
    moves: Array
    step_size: float


@compiled
def cell_of(lattice: Lattice, q: Array) -> int:
    """The number of the cell that a free pose lies in."""
    i = math.floor((q[0] - lattice.x) / lattice.side)
    j = math.floor((q[1] - lattice.y) / lattice.side)
    heading = math.floor((q[2] + math.pi) / (2.0 * math.pi) * lattice.headings) % lattice.headings
    return int((j * lattice.columns + i) * lattice.headings + heading)


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


def hybrid_astar(
    problem: ProblemRecord | Recorder,
    *,
    spacing: float | None = None,
    step_size: float | None = None,
    angles: int = 3,
    max_nodes: int = 200_000,
) -> Plan:
    """Plan by hybrid A*: the shortest drive over cells of poses that ends in a curve to the goal.

    No random numbers are used. Complete for its lattice only: where nothing is found, a finer
    spacing may help, or more nodes where they ran out. To park in a tight place, plan out of it,
    with a spacing much finer than the step size, and reverse the trajectory by its `reversed`.
    O(n log n) for n nodes.

    Parameters
    ----------
    problem : a Problem of a Car, or a Recorder of one.
    spacing : the side of a cell; by default a quarter of the wheelbase.
    step_size : the length of each move; by default 1.5 times the spacing, so that a move leaves
        its cell. There are as many headings as moves at full steering in a full turn.
    angles : how many steering angles are tried, from full right to full left, forward and, if the
        car can reverse, backward.
    max_nodes : stop at this many nodes.

    Returns
    -------
    Plan with its `tree` and its `trajectory`, which ends at the goal up to rounding. Without a path
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
    side = 0.25 * inner.robot.wheelbase if spacing is None else positive(spacing, "spacing")
    length = 1.5 * side if step_size is None else positive(step_size, "step_size")
    lattice = lattice_for(inner, side, length, integer(angles, "angles", least=2))
    growth = begin_tree(inner, integer(max_nodes, "max_nodes", least=1) + len(lattice.moves))
    before = count_checks(inner)
    last, expanded = drive_by_cells(problem, growth, lattice)
    tree = copy_tree(growth)
    built: dict[str, Any] = {"tree": tree, "problem": problem, "planner": "hybrid A*"}
    stats = {
        "nodes": len(tree.nodes),
        "expanded": int(expanded),
        "checks": count_checks(inner) - before,
    }
    if last < 0:
        reason = (
            f"none of {expanded:,} poses has a free curve to the goal; allow more nodes, or a "
            f"finer spacing than {side:.3g}"
        )
        return Plan(None, math.inf, reason=reason, stats=stats, **built)
    numbers = extract_path(tree.parent, last)[1:]
    controls, durations = controls_along(inner.robot, tree.nodes[last], inner.goal)
    trajectory = TrajectoryRecord(
        inner.start.copy(),
        np.concatenate([tree.controls[numbers], controls]),
        np.concatenate([tree.durations[numbers], durations]),
        inner.robot.wheelbase,
    )
    return Plan(trajectory.poses, trajectory.length, trajectory=trajectory, stats=stats, **built)


def lattice_for(problem: ProblemRecord, side: float, step_size: float, angles: int) -> Lattice:
    """The cells that cover a world, and the car's moves.

    Raises
    ------
    InvalidParameter
        Where there are too many cells to number them.
    """
    car, (lo, hi) = problem.robot, (problem.space.lo, problem.space.hi)
    gears = {float(car.speeds.max()), float(car.speeds.min())}
    steering = np.linspace(-car.max_steering, car.max_steering, angles)
    moves = [(v, phi) for v in sorted(gears, reverse=True) for phi in steering]
    headings = max(1.0, 2.0 * math.pi * car.radius / step_size)
    columns, rows = (hi - lo)[:2] / side + 1.0
    if columns * rows * headings > 1e18:
        raise InvalidParameter(
            f"a spacing of {side:g} and a step size of {step_size:g} make too many cells to be "
            "counted; choose larger ones"
        )
    x, y = float(lo[0]), float(lo[1])
    return Lattice(x, y, side, math.ceil(columns), math.ceil(headings), np.array(moves), step_size)
