"""The judge of the drives of a tree, of its path and of its end.

It replays every drive from its control with the course's own code, and checks that it is free.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....robots.trajectory import DrivenTree
from ....spaces.angles import angle_difference, wrap_angle
from ...drivable import DrivingProblem
from ..shared.planned import Fault

GOAL_EVERY, REGION_EVERY = 4, 7
SLACK = 1e-9  # relative tolerance of durations and distances
NOWHERE = np.empty((0, 3))
Path = NDArray[np.int64]


def find_drive_fault(problem: DrivingProblem, tree: DrivenTree) -> tuple[Fault | None, Array]:
    """Replay a tree, and return its first fault with the nodes up to there.

    Returns
    -------
    (fault, nodes) : None where every drive is valid and free; the poses of the nodes, shape (n, 3).
    """
    _, parent, controls, durations = tree
    if not len(parent) or not len(parent) == len(controls) == len(durations):
        return Fault("lengths", NOWHERE), problem.start[None]
    if parent[0] != -1 or controls[0].any() or durations[0] != 0.0:
        return Fault("root", problem.start[None]), problem.start[None]
    nodes, car = [problem.start], problem.problem.robot
    for p, (v, phi), t in zip(parent[1:], controls[1:], durations[1:]):
        if not 0 <= p < len(nodes):
            return Fault("parents", nodes[-1][None]), np.array(nodes)
        if v not in car.speeds or not abs(phi) <= car.max_steering:
            return Fault("control", nodes[p][None]), np.array(nodes)
        if not 0.0 < t <= problem.longest * (1.0 + SLACK):
            return Fault("duration", nodes[p][None]), np.array(nodes)
        nodes.append(problem.move(nodes[p], v, phi, t))
        if not problem.is_free_drive(nodes[p], v, phi, t):
            return Fault("free", np.array([nodes[p], nodes[-1]])), np.array(nodes)
    return None, np.array(nodes)


def replay(problem: DrivingProblem, tree: DrivenTree) -> Array:
    """Return the nodes, shape (n, 3), of a tree without a fault."""
    nodes = [problem.start]
    for p, (v, phi), t in zip(tree.parent[1:], tree.controls[1:], tree.durations[1:]):
        nodes.append(problem.move(nodes[p], v, phi, t))
    return np.array(nodes)


def find_near_goal(problem: DrivingProblem, nodes: Array, slack: float = 0.0) -> NDArray[np.int64]:
    """Return the indices of the nodes that are near enough to the goal."""
    x, y, theta = problem.goal
    off = [math.dist(q[:2], (x, y)) <= problem.tolerance * (1.0 + slack) for q in nodes]
    askew = [
        abs(angle_difference(wrap_angle(q[2]), theta)) <= problem.turn_tolerance * (1.0 + slack)
        for q in nodes
    ]
    return np.flatnonzero(np.array(off) & np.array(askew))


def measure_distances(problem: DrivingProblem, nodes: Array, q: Array) -> Array:
    """Return the distance from each node to q."""
    return np.array([problem.distance(node, q) for node in nodes])


def find_path_fault(parent: NDArray[np.int64], path: Path, nodes: Array) -> Fault | None:
    """Return the fault of a path that does not begin at node 0 or leaves the tree, or None."""
    if not len(path):
        return Fault("nothing", NOWHERE)
    if path[0] != 0:
        return Fault("start", nodes[:1])
    for a, b in zip(path[:-1], path[1:]):
        if not 0 < b < len(parent) or parent[b] != a:
            return Fault("along", nodes[[a]])
    return None


def find_end_fault(problem: DrivingProblem, nodes: Array, path: Path) -> Fault | None:
    """Return the fault of a path that does not end at the node nearest to the goal.

    For trees without a node near enough to the goal.
    """
    off = measure_distances(problem, nodes, problem.goal)
    return (
        None if off[path[-1]] <= off.min() * (1.0 + SLACK) else Fault("closest", nodes[[path[-1]]])
    )


class TurnFault(NamedTuple):
    """A rule that a turn breaks, the poses involved, and the turn's number; 0 where it is all."""

    rule: str
    marked: Array
    turn: int
