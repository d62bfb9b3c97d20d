"""The exercise `kinodynamic_prm`. S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning"
(2001).
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....graphs import extract_path
from ....planners.driving.kinodynamic_prm import drive_from_nearest
from ....robots.trajectory import DrivenTree
from ...drivable import DrivenTask
from ...exercise import Case
from ...shapes import Record, Together
from ...whole_shapes import Whole, WholeNumbers
from ..shared.planned import Fault, three_times
from .driven_trees import (
    NOWHERE,
    SLACK,
    DrivingPlanner,
    by_turns,
    distances,
    near_ones,
    not_along,
    not_nearest_to_goal,
    why_not_driven,
)
from .drives import CONTROLS, DURATIONS, ROUTE, TURNS, place_to_go, stopped_early
from .garages import GARAGES, KINDS, OPEN


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
    last = (
        min(there, key=arrival.__getitem__)
        if len(there)
        else distances(problem, np.array(nodes), problem.goal).argmin()
    )
    return (
        edges,
        controls,
        durations,
        extract_path(np.array([-1, *(u for u, _ in edges)]), int(last)),
    )


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
                yield Case(
                    kind,
                    {
                        "problem": GARAGES[kind],
                        "k": k,
                        "iterations": turns,
                        "rng": int(rng.integers(1000)),
                    },
                )

    def uses_chance(self, case: Case) -> bool:
        """Always: it does not stop at the goal."""
        return True

    def tree_of(self, case: Case, answer: Any) -> DrivenTree:
        """A new node for each edge."""
        edges, controls, durations, _ = answer
        return DrivenTree(
            NOWHERE,
            np.append(-1, edges[:, 0]),
            np.vstack([[0.0, 0.0], controls]),
            np.append(0.0, durations),
        )

    def fault(self, case: Case, answer: Any) -> Fault | None:
        """The edges; the drives; the path and its end; and where no drive can fail, from which
        nodes each turn drove.
        """
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
        return fault or (
            fault_of_groups(problem, edges, nodes, k, iterations) if case.kind in OPEN else None
        )


def not_fastest(
    problem: Any, tree: DrivenTree, nodes: Array, path: NDArray[np.int64]
) -> Fault | None:
    """A path that ends at another node than the one near the goal that is reached first."""
    surely, perhaps = near_ones(problem, nodes, -SLACK), near_ones(problem, nodes, SLACK)
    if not len(surely):
        return None if path[-1] in perhaps else not_nearest_to_goal(problem, nodes, path)
    arrival = np.zeros(len(nodes))
    for i in range(1, len(nodes)):
        arrival[i] = arrival[tree.parent[i]] + tree.durations[i]
    if path[-1] not in perhaps:
        return Fault("goal", nodes[path[-1:]])
    return (
        Fault("fastest", nodes[path[-1:]])
        if arrival[path[-1]] > arrival[surely].min() * (1.0 + SLACK)
        else None
    )


def fault_of_groups(
    problem: Any, edges: NDArray[np.int64], nodes: Array, k: int, iterations: int
) -> Fault | None:
    """Turns that did not drive from k different nodes that were there before them, or from the
    wrong ones.
    """
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
