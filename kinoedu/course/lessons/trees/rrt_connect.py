"""The exercise `rrt_connect`. LaValle, section 5.5; Bullo & Smith, chapter 5."""

from typing import Any

import numpy as np

from ....geometry.checks import Array
from ....graphs import extract_path
from ....planners.trees.rrt_connect import grow_both
from ....problems import Tree
from ....problems.protocols import PlanningProblem
from ...exercise import Case
from ...shapes import Maybe, Number, Record, Together, Value
from ...whole_shapes import Integer
from ..shared.planned import (
    NODES,
    PATH,
    Fault,
    ProblemShape,
    StudentProblem,
    find_motion_off_tree,
    find_node_off_nearest,
    find_tree_fault,
    three_times,
)
from ..shared.tree_exercise import ENOUGH, PARENTS, STEP, TreeExercise


def grow_two_trees(problem: PlanningProblem, step: float, iterations: int, rng: int) -> Value:
    """Grow both trees as the exercise demands, and return them with the path."""
    chance, trees = np.random.default_rng(rng), [([problem.start], [-1]), ([problem.goal], [-1])]

    def extend(tree: Any, q: Array) -> Value:
        nodes, parent = tree
        near = int(np.argmin([problem.distance(node, q) for node in nodes]))
        q_new = problem.steer(nodes[near], q, step)
        if not problem.is_free_path(nodes[near], q_new):
            return None
        nodes.append(q_new)
        parent.append(near)
        return q_new

    def way(tree: Any) -> list[Array]:
        return [tree[0][i] for i in extract_path(np.array(tree[1]), len(tree[0]) - 1)]

    for turn in range(iterations):
        here, there = trees[turn % 2], trees[1 - turn % 2]
        q_new = extend(here, problem.sample(chance))
        while q_new is not None:
            q = extend(there, q_new)
            if q is None:
                break
            if problem.distance(q, q_new) == 0.0:
                path = np.array([*way(trees[0]), *way(trees[1])[-2::-1]])
                return *trees[0], *trees[1], path
    return *trees[0], *trees[1], None


class RrtConnect(TreeExercise):
    """Grow two trees."""

    name = "rrt_connect"
    given = Record(problem=ProblemShape(), step=Number(), iterations=Integer(), rng=Integer())
    result = Together((NODES, PARENTS, NODES, PARENTS, Maybe(PATH)))
    answer = three_times(result)
    source = staticmethod(grow_two_trees)
    shown = staticmethod(grow_both)

    def make_case(self, kind: str, problem: StudentProblem, rng: np.random.Generator) -> Case:
        """Return a case with more iterations than the trap needs."""
        question = {"problem": problem, "step": STEP, "iterations": ENOUGH[kind]}
        return Case(kind, {**question, "rng": int(rng.integers(1000))})

    def fault(self, case: Case, answer: Value) -> Fault | None:
        """Judge the path, both trees and their rule, and that one tree connects greedily.

        The path must also belong to the trees.
        """
        *both, path = answer
        problem, step = case.given["problem"], case.given["step"]
        fault = None if path is None else self.fault_of_end(case, path)
        for nodes, parent, root in ((*both[:2], problem.start), (*both[2:], problem.goal)):
            fault = (
                fault
                or find_tree_fault(problem, nodes, parent, step, root)
                or find_node_off_nearest(problem, nodes, parent)
            )
        if fault is None and path is not None:
            fault = find_path_fault(path, *both)
        if fault is None and case.kind == "room" and not is_greedy(problem, both[0], both[2], step):
            fault = Fault("greedy", both[0][:0])
        return fault or self.fault_of_end(case, path)

    def drawn(self, answer: Value) -> tuple[list[Tree], Array | None]:
        """Return both trees and the path."""
        return [Tree(*answer[:2]), Tree(*answer[2:4])], answer[4]


def is_greedy(problem: PlanningProblem, nodes: Array, goal_nodes: Array, step: float) -> bool:
    """Whether one tree took a step and the other went to its end in the fewest steps."""
    for tree in (nodes, goal_nodes):
        if len(tree) > 1 + np.ceil(problem.distance(tree[0], tree[-1]) / step + 1e-6):
            return False
    return min(len(nodes), len(goal_nodes)) <= 2


def find_path_fault(
    path: Array, nodes: Array, parent: Value, goal_nodes: Array, goal_parent: Value
) -> Fault | None:
    """Return the fault of a path that leaves the trees, or None.

    It must go down the start's tree and then up the goal's tree.
    """
    for a, b in zip(path[:-1], path[1:]):
        down = find_motion_off_tree(np.array([a, b]), nodes, parent)
        if (
            down is not None
            and find_motion_off_tree(np.array([b, a]), goal_nodes, goal_parent) is not None
        ):
            return down
    return None
