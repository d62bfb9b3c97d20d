"""The judge of trees of drives.

It replays every drive from its control with the course's own code, and checks that it is free.
"""

import math

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....problems import Tree
from ....robots.trajectory import DrivenTree
from ....spaces.angles import angle_difference, wrap_angle
from ...drivable import REGION, DrivingProblem
from ...exercise import Axes, Case
from ...outcomes import Answer, Outcome
from ...shapes import Value
from ..shared.planned import Fault, PlannerExercise

GOAL_EVERY, REGION_EVERY = 4, 7
MANY = 20  # iterations with random targets from which randomness can be judged
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


def find_bias_fault(
    problem: DrivingProblem,
    nodes: Array,
    before: int,
    chosen: NDArray[np.int64],
    turn: int,
) -> str:
    """Return the rule that an iteration broke when it chose its nodes, or "".

    Where the goal is the target, the chosen nodes are the nearest to it. Where a pose of the
    region is the target, each is nearly so: by the triangle inequality, no farther from the
    goal than the nearest node plus twice the region's radius.

    Parameters
    ----------
    before : number of nodes before this iteration.
    chosen : indices of the nodes from which it drove.
    turn : number of the iteration, from 1.
    """
    off = measure_distances(problem, nodes[:before], problem.goal)
    nearest = np.sort(off)[: len(chosen)]
    if turn % REGION_EVERY == 0:
        reach = REGION * problem.problem.robot.wheelbase
        most = nearest[-1] + 2.0 * math.hypot(reach, problem.radian * 0.5 * math.pi)
        return "region" if off[chosen].max() > most else ""
    if turn % GOAL_EVERY == 0 and not np.allclose(np.sort(off[chosen]), nearest):
        return "bias"
    return ""


def judge_turns(
    problem: DrivingProblem, nodes: Array, turns: list[tuple[int, NDArray[np.int64]]]
) -> Fault | None:
    """Judge each iteration of a tree for which every drive is free.

    Parameters
    ----------
    turns : for each iteration, the number of nodes before it and the indices of the chosen ones.
    """
    towards_goal = others = 0
    for turn, (before, chosen) in enumerate(turns, 1):
        rule = find_bias_fault(problem, nodes, before, chosen, turn)
        if rule:
            return Fault(rule, nodes[chosen])
        if turn % GOAL_EVERY and turn % REGION_EVERY and turn > 8:
            others += 1
            towards_goal += not find_bias_fault(problem, nodes, before, chosen, GOAL_EVERY)
    return Fault("chance", NOWHERE) if others >= MANY and towards_goal > 0.8 * others else None


class DrivingPlanner(PlannerExercise):
    """An exercise on a planner whose answer ends with the nodes along its path."""

    lesson = "13_kinodynamic_planning"
    shared = ("driving_planner", "planner", "exercise")

    def uses_chance(self, case: Case) -> bool:
        """Whether another seed gives another answer: always, unless start is goal."""
        return case.kind != "same"

    def tree_of(self, case: Case, answer: object) -> DrivenTree:
        """Return the tree in an answer, without its nodes."""
        raise NotImplementedError

    def nodes_of(self, case: Case, answer: Value) -> tuple[DrivenTree, Array]:
        """Return the valid part of the tree, and the known poses along the path."""
        tree = self.tree_of(case, answer)
        _, nodes = find_drive_fault(case.given["problem"], tree)
        path = answer[-1][(answer[-1] >= 0) & (answer[-1] < len(nodes))]
        n = len(nodes)
        return DrivenTree(nodes, tree.parent[:n], tree.controls[:n], tree.durations[:n]), nodes[
            path
        ]

    def drawn(self, answer: object) -> tuple[list[Tree], Array | None]:
        """Return nothing to draw: `describe_answer` describes the answer."""
        return [], None

    def describe_answer(self, case: Case, value: Value) -> str:
        """Describe the size of the answer, where its path ends, and where its fault is."""
        tree, poses = self.nodes_of(case, self.answer_at_fault(case, value))
        if not len(poses):
            return self.message("answers.nowhere", nodes=len(tree.nodes))
        x, y, theta = poses[-1]
        text = self.message(
            "answers.drive", nodes=len(tree.nodes), drives=len(poses) - 1, x=x, y=y, theta=theta
        )
        fault = self.fault_of_three(case, value)
        where = np.round(fault.marked, 2).tolist() if fault is not None else []
        return f"{text}; {self.message('answers.at', marked=where)}" if where else text

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the problem, the tree, the path, and a cross at the fault."""
        from .pictures import draw_driven_answer

        value = outcome.value if isinstance(outcome, Answer) else None
        fault = None if value is None else self.fault_of_three(case, value)
        built = None if value is None else self.nodes_of(case, self.answer_at_fault(case, value))
        rule = self.judge(case, outcome).rule
        draw_driven_answer(
            case.given["problem"].problem, built, fault, self.message(f"pictures.{rule}"), ax
        )
