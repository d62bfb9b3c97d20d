"""Exercises on planners that drive: a tree, a roadmap. S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning" (2001)."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...graphs import extract_path
from ...planners.kinodynamic_prm import drive_from_nearest
from ...planners.kinodynamic_rrt import grow_by_driving
from ...robots.trajectory import DrivenTree
from ..drivable import DrivenTask
from ..exercise import Case
from ..shapes import Numbers, Record, Together
from ..whole_shapes import Whole, WholeNumbers
from .driven_trees import (
    GOAL_EVERY,
    NOWHERE,
    REGION_EVERY,
    SLACK,
    DrivingPlanner,
    by_turns,
    distances,
    near_ones,
    not_along,
    not_nearest_to_goal,
    why_not_driven,
)
from .garages import GARAGES, KINDS, OPEN
from .planned import Fault, three_times

TURNS = {"same": 20, "room": 300, "turn": 95, "seam": 300, "thin": 300, "far": 60, "sealed": 100}
CONTROLS, DURATIONS, ROUTE = Numbers(("n", 2)), Numbers(("n",)), WholeNumbers(("k",))


def place_to_go(problem: Any, turn: int, rng: np.random.Generator) -> Array:
    """Every seventh turn a pose near the goal, every fourth the goal, else any."""
    if turn % REGION_EVERY == 0:
        return problem.near_goal(rng)
    return problem.goal if turn % GOAL_EVERY == 0 else problem.sample(rng)


def own_kinodynamic_rrt(problem: Any, iterations: int, rng: int) -> Any:
    """The tree as the exercise asks for it."""
    chance, nodes = np.random.default_rng(rng), [problem.start]
    parent, controls, durations = [-1], [(0.0, 0.0)], [0.0]
    for turn in range(1, iterations + 1):
        if len(near_ones(problem, np.array(nodes[-1:]))):
            break
        target = place_to_go(problem, turn, chance)
        near = int(distances(problem, np.array(nodes), target).argmin())
        drive = problem.best_drive(nodes[near], target, chance)
        if drive is None:
            continue
        v, phi, t = drive
        nodes.append(problem.move(nodes[near], v, phi, t))
        parent.append(near)
        controls.append((v, phi))
        durations.append(t)
    there = near_ones(problem, np.array(nodes))
    last = int(there[0]) if len(there) else int(distances(problem, np.array(nodes), problem.goal).argmin())
    return parent, controls, durations, extract_path(np.array(parent), last)


class KinodynamicRrt(DrivingPlanner):
    """A tree of drives."""

    name = "kinodynamic_rrt"
    kinds = KINDS
    given = Record(problem=DrivenTask(), iterations=Whole(), rng=Whole())
    result = Together((WholeNumbers(("n",)), CONTROLS, DURATIONS, ROUTE))
    answer = three_times(result)
    source = staticmethod(own_kinodynamic_rrt)
    shown = staticmethod(grow_by_driving)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Every garage twice."""
        for _ in range(2):
            for kind in KINDS:
                yield Case(kind, {"problem": GARAGES[kind], "iterations": TURNS[kind], "rng": int(rng.integers(1000))})

    def tree_of(self, case: Case, answer: Any) -> DrivenTree:
        """As it stands."""
        return DrivenTree(NOWHERE, *answer[:3])

    def fault(self, case: Case, answer: Any) -> Fault | None:
        """The drives; the path and its end; and where no drive can fail, from which nodes each turn drove."""
        problem, iterations, _ = case.given.values()
        tree, path = self.tree_of(case, answer), answer[-1]
        fault, nodes = why_not_driven(problem, tree)
        if fault is not None:
            return fault
        if len(nodes) > iterations + 1:
            return Fault("iterations", NOWHERE)
        fault = not_along(tree.parent, path, nodes) or not_ended(problem, nodes, path)
        if fault is None and not len(near_ones(problem, nodes, SLACK)):
            fault = stopped_early(nodes, iterations)
        if fault is None and case.kind in OPEN:
            turns = [(i, tree.parent[i : i + 1]) for i in range(1, len(nodes))]
            whole = len(nodes) == iterations + 1 or len(near_ones(problem, nodes, SLACK))
            fault = by_turns(problem, nodes, turns) if whole else Fault("dropped", NOWHERE)
        return fault


def not_ended(problem: Any, nodes: Array, path: NDArray[np.int64]) -> Fault | None:
    """Growth that went on from the goal, or a path that ends elsewhere."""
    surely, perhaps = near_ones(problem, nodes, -SLACK), near_ones(problem, nodes, SLACK)
    if len(surely) and surely[0] < len(nodes) - 1:
        return Fault("returned", nodes[surely[:1]])
    if path[-1] in perhaps:
        return None
    return Fault("goal", nodes[path[-1:]]) if len(surely) else not_nearest_to_goal(problem, nodes, path)


def stopped_early(nodes: Array, iterations: int) -> Fault | None:
    """Far fewer nodes than there were turns: no garage is as narrow as that."""
    return Fault("stopped", nodes[-1:]) if 5 * len(nodes) < iterations else None


def own_kinodynamic_prm(problem: Any, k: int, iterations: int, rng: int) -> Any:
    """The roadmap as the exercise asks for it."""
    chance, nodes, arrival = np.random.default_rng(rng), [problem.start], [0.0]
    edges, controls, durations = [], [], []
    for turn in range(1, iterations + 1):
        target = place_to_go(problem, turn, chance)
        for near in distances(problem, np.array(nodes), target).argsort(kind="stable")[:k].tolist():
            drive = problem.best_drive(nodes[near], target, chance)
            if drive is None:
                continue
            v, phi, t = drive
            edges.append((near, len(nodes)))
            nodes.append(problem.move(nodes[near], v, phi, t))
            controls.append((v, phi))
            durations.append(t)
            arrival.append(arrival[near] + t)
    there = near_ones(problem, np.array(nodes))
    last = min(there, key=arrival.__getitem__) if len(there) else distances(problem, np.array(nodes), problem.goal).argmin()
    return edges, controls, durations, extract_path(np.array([-1, *(u for u, _ in edges)]), int(last))


class KinodynamicPrm(DrivingPlanner):
    """A roadmap of drives, and the fastest drive through it."""

    name = "kinodynamic_prm"
    kinds = KINDS
    given = Record(problem=DrivenTask(), k=Whole(), iterations=Whole(), rng=Whole())
    result = Together((WholeNumbers(("n", 2)), CONTROLS, DURATIONS, ROUTE))
    answer = three_times(result)
    source = staticmethod(own_kinodynamic_prm)
    shown = staticmethod(drive_from_nearest)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Every garage twice, with two nodes a turn and with three."""
        for k in (2, 3):
            for kind in KINDS:
                turns = min(100, TURNS[kind])
                yield Case(kind, {"problem": GARAGES[kind], "k": k, "iterations": turns, "rng": int(rng.integers(1000))})

    def uses_chance(self, case: Case) -> bool:
        """Always: it does not stop at the goal."""
        return True

    def tree_of(self, case: Case, answer: Any) -> DrivenTree:
        """A new node for each edge."""
        edges, controls, durations, _ = answer
        return DrivenTree(NOWHERE, np.append(-1, edges[:, 0]), np.vstack([[0.0, 0.0], controls]), np.append(0.0, durations))

    def fault(self, case: Case, answer: Any) -> Fault | None:
        """The edges; the drives; the path and its end; and where no drive can fail, from which nodes each turn drove."""
        problem, k, iterations, _ = case.given.values()
        edges, tree, path = answer[0], self.tree_of(case, answer), answer[-1]
        if not np.array_equal(edges[:, 1], np.arange(1, len(edges) + 1)):
            turned = np.array_equal(edges[:, 0], np.arange(1, len(edges) + 1))
            return Fault("turned" if turned else "edges", NOWHERE)
        fault, nodes = why_not_driven(problem, tree)
        if fault is not None:
            return fault
        if len(nodes) > k * iterations + 1:
            return Fault("iterations", NOWHERE)
        if stopped_early(nodes, iterations):
            return Fault("onward", nodes[-1:])
        fault = not_along(tree.parent, path, nodes) or not_fastest(problem, tree, nodes, path)
        return fault or (fault_of_groups(problem, edges, nodes, k, iterations) if case.kind in OPEN else None)


def not_fastest(problem: Any, tree: DrivenTree, nodes: Array, path: NDArray[np.int64]) -> Fault | None:
    """A path that ends at another node than the one near the goal that is reached first."""
    surely, perhaps = near_ones(problem, nodes, -SLACK), near_ones(problem, nodes, SLACK)
    if not len(surely):
        return None if path[-1] in perhaps else not_nearest_to_goal(problem, nodes, path)
    arrival = np.zeros(len(nodes))
    for i in range(1, len(nodes)):
        arrival[i] = arrival[tree.parent[i]] + tree.durations[i]
    if path[-1] not in perhaps:
        return Fault("goal", nodes[path[-1:]])
    return Fault("fastest", nodes[path[-1:]]) if arrival[path[-1]] > arrival[surely].min() * (1.0 + SLACK) else None


def fault_of_groups(problem: Any, edges: NDArray[np.int64], nodes: Array, k: int, iterations: int) -> Fault | None:
    """Turns that did not drive from k different nodes that were there before them, or from the wrong ones."""
    before, turns = 1, []
    for _ in range(iterations):
        chosen = edges[before - 1 : before - 1 + min(k, before), 0]
        if len(chosen) < min(k, before):
            return Fault("dropped", NOWHERE)
        if len(np.unique(chosen)) < len(chosen) or chosen.max() >= before:
            return Fault("group", nodes[chosen])
        turns.append((before, chosen))
        before += len(chosen)
    return by_turns(problem, nodes, turns)
