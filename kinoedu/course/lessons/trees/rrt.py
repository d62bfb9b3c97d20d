"""The exercise `rrt`. LaValle, section 5.5; Bullo & Smith, chapter 5."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....graphs import extract_path
from ....planners.trees.rrt import grow
from ....problems import Tree
from ....problems.protocols import PlanningProblem
from ...exercise import Case
from ...shapes import Maybe, Number, Record, Together, Value
from ...whole_shapes import Integer
from ..shared.planned import (
    NODES,
    PATH,
    TRAPS,
    Fault,
    ProblemShape,
    StudentProblem,
    empty_boxes,
    find_motion_off_tree,
    find_node_off_nearest,
    find_tree_fault,
    same_configuration,
    three_times,
)
from ..shared.tree_exercise import BIAS, ENOUGH, PARENTS, STEP, TreeExercise

# of 16 boxes: one is behind the walls of the trap, and one more may stay empty by chance
LEFT_OUT = 2


def grow_tree(
    problem: PlanningProblem, step: float, goal_bias: float, iterations: int, rng: int
) -> Value:
    """Grow an RRT as the exercise demands, and return nodes, parents and path."""
    chance, nodes, parent = np.random.default_rng(rng), [problem.start], [-1]
    if problem.distance(problem.start, problem.goal) <= step and problem.is_free_path(
        problem.start, problem.goal
    ):
        return [problem.start, problem.goal], [-1, 0], [problem.start, problem.goal]
    for _ in range(iterations):
        q_rand = problem.goal if chance.random() < goal_bias else problem.sample(chance)
        near = int(np.argmin([problem.distance(q, q_rand) for q in nodes]))
        q_new = problem.steer(nodes[near], q_rand, step)
        if not problem.is_free_path(nodes[near], q_new):
            continue
        nodes.append(q_new)
        parent.append(near)
        if problem.distance(q_new, problem.goal) <= step and problem.is_free_path(
            q_new, problem.goal
        ):
            nodes.append(problem.goal)
            parent.append(len(nodes) - 2)
            return nodes, parent, np.array(nodes)[extract_path(np.array(parent), len(nodes) - 1)]
    return nodes, parent, None


class Rrt(TreeExercise):
    """Grow one tree."""

    name = "rrt"
    given = Record(
        problem=ProblemShape(),
        step=Number(),
        goal_bias=Number(),
        iterations=Integer(),
        rng=Integer(),
    )
    result = Together((NODES, PARENTS, Maybe(PATH)))
    answer = three_times(result)
    source = staticmethod(grow_tree)
    shown = staticmethod(grow)

    def make_case(self, kind: str, problem: StudentProblem, rng: np.random.Generator) -> Case:
        """Return a case with more iterations than the trap needs."""
        given = {
            "problem": problem,
            "step": STEP,
            "goal_bias": BIAS,
            "iterations": ENOUGH[kind],
            "rng": int(rng.integers(1000)),
        }
        return Case(kind, given)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield traps with a goal bias, then goal bias 1 with and without a free straight path."""
        yield from super().cases(rng)
        for kind in ("room", "sealed"):
            yield aim_at_goal(self.make_case(kind, TRAPS[kind], rng))

    def uses_chance(self, case: Case) -> bool:
        """Whether another seed gives another answer: not with goal bias 1."""
        return case.given["goal_bias"] < 1.0 and super().uses_chance(case)

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer must be."""
        return (
            super().describe_expected(case)
            if case.given["goal_bias"] < 1.0
            else self.message("wanted.straight")
        )

    def fault(self, case: Case, answer: Value) -> Fault | None:
        """Judge the path, the tree and its rule, and the spread of the samples.

        The path must also belong to the tree.
        """
        nodes, parent, path = answer
        if case.given["goal_bias"] == 1.0 and not has_same_nodes(case, nodes):
            return Fault("bias", nodes[:0])
        problem, step = case.given["problem"], case.given["step"]
        fault = None if path is None else self.fault_of_end(case, path)
        fault = (
            fault
            or find_tree_fault(problem, nodes, parent, step)
            or find_node_off_nearest(problem, nodes, parent)
        )
        if fault is None and len(nodes) > case.given["iterations"] + 2:
            fault = Fault("iterations", nodes[:0])
        if fault is None and path is not None:
            fault = find_motion_off_tree(path, nodes, parent) or find_missed_goal(
                problem, nodes, step
            )
        if (
            fault is None
            and must_cover_room(case)
            and empty_boxes(nodes, problem.world.lo, problem.world.hi, 4) > LEFT_OUT
        ):
            fault = Fault("corner", nodes[:0])
        return fault or self.fault_of_end(case, path)

    def drawn(self, answer: Value) -> tuple[list[Tree], Array | None]:
        """Return the tree and the path."""
        nodes, parent, path = answer
        return [Tree(nodes, parent)], path


def aim_at_goal(case: Case) -> Case:
    """Return the case with goal bias 1."""
    return case._replace(given={**case.given, "goal_bias": 1.0, "iterations": 20})


def has_same_nodes(case: Case, nodes: Array) -> bool:
    """Whether the nodes are those of the course's own RRT.

    With goal bias 1 nothing is random.
    """
    own = grow_tree(*case.given.values())[0]
    return nodes.shape == (len(own), len(own[0])) and all(
        same_configuration(case.given["problem"], a, b) for a, b in zip(nodes, own)
    )


def find_missed_goal(problem: StudentProblem, nodes: Array, step: float) -> Fault | None:
    """Return the fault of a node that could have reached the goal by one free motion, or None.

    The last two nodes are excepted.
    """
    for q in nodes[:-2]:
        if problem.distance(q, problem.goal) < step * (1.0 - 1e-9) and problem.problem.is_free_path(
            q, problem.goal
        ):
            return Fault("returned", np.array([q, problem.goal]))
    return None


def must_cover_room(case: Case) -> bool:
    """Whether the samples of this case must cover the whole room."""
    return case.kind == "sealed" and case.given.get("goal_bias", 0.0) < 1.0
