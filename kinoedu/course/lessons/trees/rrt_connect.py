"""The exercise `rrt_connect`. LaValle, section 5.5; Bullo & Smith, chapter 5."""

from collections.abc import Iterator
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
from ...withheld import withheld
from ..roadmaps.halls import make_arm
from ..shared.planned import (
    NODES,
    PATH,
    Fault,
    ProblemShape,
    Run,
    StudentProblem,
    Watched,
    find_motion_off_tree,
    find_tree_fault,
    watched_three_times,
)
from ..shared.replayed import Regrown, find_connect_fault
from ..shared.small_problems import in_room
from ..shared.tree_exercise import ENOUGH, PARENTS, STEP, TreeExercise
from .rrt import LONG, with_step

FAR = in_room((0.5, 0.5), (9.5, 9.5))
NEARLY = 0.01
# the short way leads across pi, which is farther than a step from both ends
ARM = make_arm([], (-2.0, 0.3), (1.8, 0.3))


@withheld
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


class RrtConnect(Watched, TreeExercise):
    """Grow two trees."""

    name = "rrt_connect"
    given = Record(problem=ProblemShape(), step=Number(), iterations=Integer(), rng=Integer())
    result = Together((NODES, PARENTS, NODES, PARENTS, Maybe(PATH)))
    answer = watched_three_times(result)
    source = staticmethod(grow_two_trees)
    shown = staticmethod(grow_both)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield every trap twice, walls with a random gap, and a long run.

        The last case without a path has an even number of iterations, the others have an odd one.
        The long run is followed by one that nearly arrives, and needs one more very short step. An
        arm's runs lead across pi. Last comes a run with longer steps.
        """
        *traps, sheets = super().cases(rng)
        yield from traps
        yield sheets._replace(given={**sheets.given, "iterations": ENOUGH["sealed"] + 1})
        yield self.make_case("room", FAR, rng)
        case = self.make_case("room", FAR, rng)
        while not 0.0 < measure_last_step(case) < NEARLY:
            case = self.make_case("room", FAR, rng)
        yield case
        for _ in range(2):
            yield self.make_case("room", ARM, rng)
        yield with_step(self.make_case("room", FAR, rng), LONG)

    def make_case(self, kind: str, problem: StudentProblem, rng: np.random.Generator) -> Case:
        """Return a case with more iterations than the trap needs."""
        question = {"problem": problem, "step": STEP, "iterations": ENOUGH[kind]}
        return Case(kind, {**question, "rng": int(rng.integers(1000))})

    def fault_of_run(self, case: Case, answer: Value, run: Run | None) -> Fault | None:
        """Judge the path, both trees, and that every node comes from a sample or a run.

        The path must also belong to the trees.
        """
        *both, path = answer
        problem, step, iterations, _ = case.given.values()
        trees = Tree(*both[:2]), Tree(*both[2:])
        is_judged_first = path is not None or case.kind == "same"
        fault = self.fault_of_end(case, path) if is_judged_first else None
        for tree, root in zip(trees, (problem.start, problem.goal)):
            fault = fault or find_tree_fault(problem, *tree, step, root)
        if fault is None and path is not None:
            fault = find_path_fault(path, *both)
        if fault is None and run is not None:
            a, b = (Regrown(problem, tree, step) for tree in trees)
            fault = find_connect_fault((a, b), run, iterations, path is not None)
        return fault or self.fault_of_end(case, path)

    def drawn(self, answer: Value) -> tuple[list[Tree], Array | None]:
        """Return both trees and the path."""
        return [Tree(*answer[:2]), Tree(*answer[2:4])], answer[4]


def measure_last_step(case: Case) -> float:
    """Return the length of the last step of the first run, where the start's tree begins."""
    problem, step = case.given["problem"].problem, case.given["step"]
    q = problem.sample(np.random.default_rng(case.given["rng"]))
    return float(problem.distance(problem.goal, problem.steer(problem.start, q, step)) % step)


def find_path_fault(
    path: Array, nodes: Array, parent: Value, goal_nodes: Array, goal_parent: Value
) -> Fault | None:
    """Return the fault of a path that leaves the trees, or None.

    It must go down the start's tree and then up the goal's tree, which have a node in common.
    """
    apart = np.abs(nodes[:, None] - goal_nodes[None]).max(axis=2)
    if apart.min() > 1e-9 * (1.0 + np.abs(nodes).max()):
        a, b = np.unravel_index(int(apart.argmin()), apart.shape)
        return Fault("meet", np.array([nodes[a], goal_nodes[b]]))
    for a, b in zip(path[:-1], path[1:]):
        down = find_motion_off_tree(np.array([a, b]), nodes, parent)
        if (
            down is not None
            and find_motion_off_tree(np.array([b, a]), goal_nodes, goal_parent) is not None
        ):
            return down
    return None
