"""Exercises on rapidly-exploring random trees, of one tree and of two. LaValle, section 5.5; Bullo & Smith, chapter 5."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ...geometry.checks import Array
from ...graphs import extract_path
from ...planners.rrt import grow
from ...planners.rrt_connect import grow_both
from ...problems import Tree
from ..exercise import Case
from ..shapes import Maybe, Number, Record, Together
from ..whole_shapes import Whole, WholeNumbers
from .planned import (
    NODES,
    PATH,
    TRAPS,
    Asked,
    Fault,
    PlannerExercise,
    Task,
    empty_boxes,
    not_along_tree,
    not_to_nearest,
    same,
    three_times,
    why_not_a_path,
    why_not_a_tree,
)
from .tasks import box, in_room

PARENTS = WholeNumbers(("n",))
STEP, BIAS = 1.0, 0.1
ENOUGH = {"same": 10, "room": 200, "sealed": 300, "wall": 1200, "passage": 1200, "thin": 1500}  # of 2,000 seeds all needed less
KINDS = tuple(ENOUGH)


def room_by_chance(rng: np.random.Generator) -> Asked:
    """Start and goal on two sides of a wall with one gap, somewhere."""
    low = round(float(rng.uniform(1.0, 7.0)), 1)
    x = round(float(rng.uniform(3.5, 6.0)), 1)
    ends = np.round(rng.uniform((0.5, 0.5), (2.5, 9.5), (2, 2)), 1)
    return in_room(ends[0], ends[1] + (7.0, 0.0), box(x, 0, x + 0.5, low), box(x, low + 1.6, x + 0.5, 10))


class TreeExercise(PlannerExercise):
    """A planner among the traps."""

    lesson = "09_trees"
    kinds = KINDS

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Every trap twice, and walls with a gap somewhere."""
        for _ in range(2):
            for kind in KINDS:
                yield self.asked(kind, TRAPS[kind], rng)
        for _ in range(2):
            yield self.asked("wall", room_by_chance(rng), rng)

    def asked(self, kind: str, problem: Asked, rng: np.random.Generator) -> Case:
        """The case of a problem, with a seed by chance."""
        raise NotImplementedError

    def fault_of_end(self, case: Case, path: Array | None) -> Fault | None:
        """What is wrong with a path, or with there being none."""
        nowhere = np.empty((0, len(case.given["problem"].start)))
        if path is None:
            return Fault("missed", nowhere) if case.kind != "sealed" else None
        return why_not_a_path(case.given["problem"], path)


def own_rrt(problem: Any, step: float, goal_bias: float, iterations: int, rng: int) -> Any:
    """RRT as the exercise asks for it."""
    chance, nodes, parent = np.random.default_rng(rng), [problem.start], [-1]
    if problem.distance(problem.start, problem.goal) <= step and problem.is_free_path(problem.start, problem.goal):
        return [problem.start, problem.goal], [-1, 0], [problem.start, problem.goal]
    for _ in range(iterations):
        q_rand = problem.goal if chance.random() < goal_bias else problem.sample(chance)
        near = int(np.argmin([problem.distance(q, q_rand) for q in nodes]))
        q_new = problem.steer(nodes[near], q_rand, step)
        if not problem.is_free_path(nodes[near], q_new):
            continue
        nodes.append(q_new)
        parent.append(near)
        if problem.distance(q_new, problem.goal) <= step and problem.is_free_path(q_new, problem.goal):
            nodes.append(problem.goal)
            parent.append(len(nodes) - 2)
            return nodes, parent, np.array(nodes)[extract_path(np.array(parent), len(nodes) - 1)]
    return nodes, parent, None


class Rrt(TreeExercise):
    """One tree."""

    name = "rrt"
    given = Record(problem=Task(), step=Number(), goal_bias=Number(), iterations=Whole(), rng=Whole())
    result = Together((NODES, PARENTS, Maybe(PATH)))
    answer = three_times(result)
    source = staticmethod(own_rrt)
    shown = staticmethod(grow)

    def asked(self, kind: str, problem: Asked, rng: np.random.Generator) -> Case:
        """As many iterations as the trap needs, and more."""
        given = {"problem": problem, "step": STEP, "goal_bias": BIAS, "iterations": ENOUGH[kind], "rng": int(rng.integers(1000))}
        return Case(kind, given)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Some chance is left to the goal in most; then all of it, with a way to the goal and without."""
        yield from super().cases(rng)
        for kind in ("room", "sealed"):
            yield straight(self.asked(kind, TRAPS[kind], rng))

    def uses_chance(self, case: Case) -> bool:
        """Not where every sample is the goal."""
        return case.given["goal_bias"] < 1.0 and super().uses_chance(case)

    def wanted(self, case: Case) -> str:
        """What is asked for."""
        return super().wanted(case) if case.given["goal_bias"] < 1.0 else self.words("wanted.straight")

    def fault(self, case: Case, answer: Any) -> Fault | None:
        """The path; the tree and its rule; whether the one belongs to the other; what the samples leave out."""
        nodes, parent, path = answer
        if case.given["goal_bias"] == 1.0 and not has_same_nodes(case, nodes):
            return Fault("bias", nodes[:0])
        problem, step = case.given["problem"], case.given["step"]
        fault = None if path is None else self.fault_of_end(case, path)
        fault = fault or why_not_a_tree(problem, nodes, parent, step) or not_to_nearest(problem, nodes, parent)
        if fault is None and len(nodes) > case.given["iterations"] + 2:
            fault = Fault("iterations", nodes[:0])
        if fault is None and path is not None:
            fault = not_along_tree(path, nodes, parent) or not_returned(problem, nodes, step)
        if fault is None and leaves_out(case) and empty_boxes(nodes, problem.world.lo, problem.world.hi, 4) > LEFT_OUT:
            fault = Fault("corner", nodes[:0])
        return fault or self.fault_of_end(case, path)

    def drawn(self, answer: Any) -> tuple[list[Tree], Array | None]:
        """The tree and the path."""
        nodes, parent, path = answer
        return [Tree(nodes, parent)], path


def straight(case: Case) -> Case:
    """The case in which every sample is the goal."""
    return case._replace(given={**case.given, "goal_bias": 1.0, "iterations": 20})


def has_same_nodes(case: Case, nodes: Array) -> bool:
    """Whether they are the nodes of the course's own RRT: where every sample is the goal, nothing is left to chance."""
    own = own_rrt(*case.given.values())[0]
    return nodes.shape == (len(own), len(own[0])) and all(same(case.given["problem"], a, b) for a, b in zip(nodes, own))


def not_returned(problem: Any, nodes: Array, step: float) -> Fault | None:
    """A node, the last two excepted, from which the goal could have been reached by one free motion."""
    for q in nodes[:-2]:
        if problem.distance(q, problem.goal) < step * (1.0 - 1e-9) and problem.problem.is_free_path(q, problem.goal):
            return Fault("returned", np.array([q, problem.goal]))
    return None


def leaves_out(case: Case) -> bool:
    """Whether it is a case in which samples must have led everywhere."""
    return case.kind == "sealed" and case.given.get("goal_bias", 0.0) < 1.0


LEFT_OUT = 2  # of 16 boxes: one lies behind the walls of the trap, and one more may be missed


def own_rrt_connect(problem: Any, step: float, iterations: int, rng: int) -> Any:
    """RRT-Connect as the exercise asks for it."""
    chance, trees = np.random.default_rng(rng), [([problem.start], [-1]), ([problem.goal], [-1])]

    def extend(tree: Any, q: Array) -> Any:
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
    """Two trees."""

    name = "rrt_connect"
    given = Record(problem=Task(), step=Number(), iterations=Whole(), rng=Whole())
    result = Together((NODES, PARENTS, NODES, PARENTS, Maybe(PATH)))
    answer = three_times(result)
    source = staticmethod(own_rrt_connect)
    shown = staticmethod(grow_both)

    def asked(self, kind: str, problem: Asked, rng: np.random.Generator) -> Case:
        """As many iterations as the trap needs, and more."""
        return Case(kind, {"problem": problem, "step": STEP, "iterations": ENOUGH[kind], "rng": int(rng.integers(1000))})

    def fault(self, case: Case, answer: Any) -> Fault | None:
        """The path; both trees and their rule; whether it belongs to them; whether one tree runs all the way to the other."""
        *both, path = answer
        problem, step = case.given["problem"], case.given["step"]
        fault = None if path is None else self.fault_of_end(case, path)
        for nodes, parent, root in ((*both[:2], problem.start), (*both[2:], problem.goal)):
            fault = fault or why_not_a_tree(problem, nodes, parent, step, root) or not_to_nearest(problem, nodes, parent)
        if fault is None and path is not None:
            fault = not_along_trees(path, *both)
        if fault is None and case.kind == "room" and not ran_straight(problem, both[0], both[2], step):
            fault = Fault("greedy", both[0][:0])
        return fault or self.fault_of_end(case, path)

    def drawn(self, answer: Any) -> tuple[list[Tree], Array | None]:
        """Both trees and the path."""
        return [Tree(*answer[:2]), Tree(*answer[2:4])], answer[4]


def ran_straight(problem: Any, nodes: Array, goal_nodes: Array, step: float) -> bool:
    """Whether one tree took a step, and the other ran to its end in as few steps as there can be."""
    for tree in (nodes, goal_nodes):
        if len(tree) > 1 + np.ceil(problem.distance(tree[0], tree[-1]) / step + 1e-6):
            return False
    return min(len(nodes), len(goal_nodes)) <= 2


def not_along_trees(path: Array, nodes: Array, parent: Any, goal_nodes: Array, goal_parent: Any) -> Fault | None:
    """A stretch of a path that is an edge of neither tree: down the start's, then up the goal's."""
    for a, b in zip(path[:-1], path[1:]):
        down = not_along_tree(np.array([a, b]), nodes, parent)
        if down is not None and not_along_tree(np.array([b, a]), goal_nodes, goal_parent) is not None:
            return down
    return None
