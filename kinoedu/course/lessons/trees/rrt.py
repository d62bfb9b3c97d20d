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
from ...withheld import withheld
from ..roadmaps.halls import make_arm
from ..shared.planned import (
    NODES,
    PATH,
    TRAPS,
    Fault,
    ProblemShape,
    Run,
    StudentProblem,
    Watched,
    find_motion_off_tree,
    find_tree_fault,
    find_unreturned_path,
    same_configuration,
    watched_three_times,
)
from ..shared.replayed import Regrown, find_rrt_fault
from ..shared.small_problems import box, in_room
from ..shared.tree_exercise import BIAS, ENOUGH, PARENTS, STEP, TreeExercise

LONG = 2.5  # a step; a program that has the usual one in it fails
OFTEN = 0.5  # a goal bias at which a test of its share is sharp
BESIDE = in_room((4, 5), (4.6, 5.3))
# less than a step apart, with a wall between that fits between sampled points
BEHIND = in_room((7.6, 5), (8.2, 5), box(7.8723, 3, 7.8728, 7))
# a corner touches the last step of the straight way to the goal
TOUCHED = in_room((2, 3), (8, 3), [(7, 5), (7.5, 3), (8, 5)])
ARM = make_arm([], (2.4, 0.3), (-2.0, 1.5))  # the way is short, because an angle wraps


@withheld
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


class Rrt(Watched, TreeExercise):
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
    answer = watched_three_times(result)
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
        """Yield traps with a goal bias, a goal beside the start, then goal bias 1, and 0.

        The goal bias is larger the second time where no path exists.
        """
        yield self.make_case("room", BESIDE, rng)
        sealed = 0
        for case in super().cases(rng):
            sealed += case.kind == "sealed"
            often = case.kind == "sealed" and sealed == 2
            yield with_bias(case, OFTEN) if often else case
        yield self.make_case("thin", BEHIND, rng)
        yield self.make_case("room", ARM, rng)
        for kind in ("room", "sealed"):
            yield aim_at_goal(self.make_case(kind, TRAPS[kind], rng))
        yield with_bias(self.make_case("sealed", TRAPS["sealed"], rng), 0.0, iterations=60)
        # so few steps from the start are all free: every iteration adds a node
        yield with_bias(self.make_case("sealed", TRAPS["sealed"], rng), 0.0, iterations=5)
        # the goal is exactly one step away, or three; or less than two, and the last node joins it
        for kind, x, iterations in (("room", 3, 9), ("room", 5, 9), ("room", 3.5, 1)):
            case = self.make_case(kind, in_room((2, 3), (x, 3)), rng)
            yield aim_at_goal(case, iterations)
        yield aim_at_goal(self.make_case("sealed", TOUCHED, rng))
        yield with_step(self.make_case("room", TRAPS["room"], rng), LONG)
        # the goal is more than the usual step away, and less than this one
        yield with_step(aim_at_goal(self.make_case("room", in_room((2, 3), (4, 3)), rng)), LONG)

    def uses_chance(self, case: Case) -> bool:
        """Whether another seed gives another answer.

        It does not with goal bias 1, nor where the goal can be joined to the start.
        """
        problem, step = case.given["problem"], case.given["step"]
        ends = problem.start, problem.goal
        joined = problem.distance(*ends) <= step and problem.problem.is_free_path(*ends)
        return case.given["goal_bias"] < 1.0 and not joined

    def ask_for_answers(self, case: Case) -> None:
        """Ask also for the course's own tree where nothing is random."""
        super().ask_for_answers(case)
        if case.given["goal_bias"] == 1.0:
            grow_straight(case)

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer must be."""
        return (
            super().describe_expected(case)
            if case.given["goal_bias"] < 1.0
            else self.message("wanted.straight")
        )

    def fault_of_run(self, case: Case, answer: Value, run: Run | None) -> Fault | None:
        """Judge the path, the tree, and that every node comes from a sample.

        The path must also belong to the tree.
        """
        nodes, parent, path = answer
        problem, step, bias, iterations, _ = case.given.values()
        fault = None if path is None else self.fault_of_end(case, path)
        fault = fault or find_tree_fault(problem, nodes, parent, step)
        fault = fault or find_unreturned_path(problem, nodes, path)
        if fault is None and bias == 1.0 and not has_same_nodes(case, nodes):
            # nothing is random here, so a distance of exactly one step counts
            within = step * (1.0 + 1e-9)
            fault = find_missed_goal(problem, nodes, within, path is not None)
            ended_early = path is None and case.kind != "sealed" and begins_alike(case, nodes)
            fault = fault or Fault("missed" if ended_early else "bias", nodes[:0])
        if fault is None and len(nodes) > iterations + 1 + (path is not None):
            fault = Fault("iterations", nodes[:0])
        if fault is None and path is not None:
            fault = find_motion_off_tree(path, nodes, parent)
        fault = fault or find_missed_goal(problem, nodes, step * (1.0 - 1e-9), path is not None)
        if fault is None and bias < 1.0 and run is not None:
            joined = len(nodes) > 1 and path is not None
            grown = Tree(nodes[:-1], parent[:-1]) if joined else Tree(nodes, parent)
            fault = find_rrt_fault(
                Regrown(problem, grown, step), run, bias, iterations, path is not None
            )
        return fault or self.fault_of_end(case, path)

    def drawn(self, answer: Value) -> tuple[list[Tree], Array | None]:
        """Return the tree and the path."""
        nodes, parent, path = answer
        return [Tree(nodes, parent)], path


def with_bias(case: Case, goal_bias: float, **others: Value) -> Case:
    """Return the case with another goal bias, and other arguments."""
    return case._replace(given={**case.given, "goal_bias": goal_bias, **others})


def with_step(case: Case, step: float) -> Case:
    """Return the case with another step."""
    return case._replace(given={**case.given, "step": step})


def aim_at_goal(case: Case, iterations: int = 20) -> Case:
    """Return the case with goal bias 1."""
    return with_bias(case, 1.0, iterations=iterations)


def has_same_nodes(case: Case, nodes: Array) -> bool:
    """Whether the nodes are those of the course's own RRT, with goal bias 1."""
    return len(nodes) == len(grow_straight(case)) and begins_alike(case, nodes)


def begins_alike(case: Case, nodes: Array) -> bool:
    """Whether the nodes are the first ones of the course's own RRT, with goal bias 1."""
    own = grow_straight(case)
    return len(nodes) <= len(own) and all(
        same_configuration(case.given["problem"], a, b) for a, b in zip(nodes, own)
    )


def grow_straight(case: Case) -> list[Array]:
    """Return the nodes of the course's own RRT; with goal bias 1 they depend on no seed."""
    nodes: list[Array] = grow_tree(*{**case.given, "rng": 0}.values())[0]
    return nodes


def find_missed_goal(
    problem: StudentProblem, nodes: Array, less_than: float, ended: bool
) -> Fault | None:
    """Return the fault of a node that could have reached the goal by one free motion, or None.

    Where the search ended at the goal, the last two nodes are excepted.
    """
    for q in nodes[:-2] if ended else nodes:
        near = problem.distance(q, problem.goal) < less_than
        if near and problem.problem.is_free_path(q, problem.goal):
            return Fault("returned", np.array([q, problem.goal]))
    return None
