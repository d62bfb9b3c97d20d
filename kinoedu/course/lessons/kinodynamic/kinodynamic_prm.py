"""The exercise `kinodynamic_prm`.

S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning" (2001).
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
    """Grow the roadmap as the exercise demands, and return its arrays and path."""
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
    """Build a roadmap of drives, and find the fastest path through it."""

    name = "kinodynamic_prm"
    kinds = KINDS
    given = Record(problem=DrivenTask(), k=Whole(), iterations=Whole(), rng=Whole())
    result = Together((WholeNumbers(("n", 2)), CONTROLS, DURATIONS, ROUTE))
    answer = three_times(result)
    source = staticmethod(own_kinodynamic_prm)
    shown = staticmethod(drive_from_nearest)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield every garage twice, with two and with three drives per iteration."""
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
        """Another seed always gives another answer: the roadmap does not stop at the goal."""
        return True

    def tree_of(self, case: Case, answer: Any) -> DrivenTree:
        """Return the roadmap as a tree: each edge leads to a new node."""
        edges, controls, durations, _ = answer
        return DrivenTree(
            NOWHERE,
            np.append(-1, edges[:, 0]),
            np.vstack([[0.0, 0.0], controls]),
            np.append(0.0, durations),
        )

    def fault(self, case: Case, answer: Any) -> Fault | None:
        """Judge the edges, the drives, the path and its end.

        Where every drive is free, also judge from which nodes each iteration drove.
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
    """Return a fault where another node near the goal is reached sooner than the path's end."""
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
    """Judge that each iteration drove from the right k nodes.

    They must be different, be older than the iteration, and be nearest to its target.
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
