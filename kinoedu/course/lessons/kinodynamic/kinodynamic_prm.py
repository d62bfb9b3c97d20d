"""The exercise `kinodynamic_prm`.

S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning" (2001).
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....graphs import extract_path
from ....planners.driving.kinodynamic_prm import drive_from_nearest
from ....robots.trajectory import DrivenTree
from ...drivable import DrivenProblemShape, DrivingProblem
from ...exercise import Case
from ...shapes import Record, Together, Value
from ...whole_shapes import Integer, Integers
from ...withheld import withheld
from ..shared.planned import Fault
from .driven_trees import (
    NOWHERE,
    SLACK,
    find_drive_fault,
    find_end_fault,
    find_near_goal,
    find_path_fault,
    measure_distances,
)
from .driven_turns import Turns
from .drives import CONTROLS, DURATIONS, ITERATIONS, ROUTE, choose_target
from .driving_planner import DrivingPlanner, with_logs
from .garages import FEW, GARAGES, JUST_THERE, KINDS, NOT_THERE, TURNED


@withheld
def grow_roadmap(problem: DrivingProblem, k: int, iterations: int, rng: int) -> Value:
    """Grow the roadmap as the exercise demands, and return its arrays and path."""
    chance, nodes, arrival = np.random.default_rng(rng), [problem.start], [0.0]
    edges, controls, durations = [], [], []
    for turn in range(1, iterations + 1):
        target = choose_target(problem, turn, chance)
        order = measure_distances(problem, np.array(nodes), target).argsort(kind="stable")
        for near in order[:k].tolist():
            drive = problem.best_drive(nodes[near], target, chance)
            if drive is None:
                continue
            v, phi, t = drive
            edges.append((near, len(nodes)))
            nodes.append(problem.move(nodes[near], v, phi, t))
            controls.append((v, phi))
            durations.append(t)
            arrival.append(arrival[near] + t)
    there = find_near_goal(problem, np.array(nodes))
    nearest = measure_distances(problem, np.array(nodes), problem.goal).argmin()
    last = min(there, key=arrival.__getitem__) if len(there) else nearest
    parent = np.array([-1, *(u for u, _ in edges)])
    return edges, controls, durations, extract_path(parent, int(last))


class KinodynamicPrm(DrivingPlanner):
    """Build a roadmap of drives, and find the fastest path through it."""

    name = "kinodynamic_prm"
    kinds = KINDS
    given = Record(problem=DrivenProblemShape(), k=Integer(), iterations=Integer(), rng=Integer())
    result = Together((Integers(("n", 2)), CONTROLS, DURATIONS, ROUTE))
    answer = with_logs(result)
    source = staticmethod(grow_roadmap)
    shown = staticmethod(drive_from_nearest)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield every garage twice, with two and with three drives per iteration.

        In the last case the goal's heading is on the other side of pi.
        """
        for k, garages in ((2, GARAGES), (3, TURNED)):
            for kind in KINDS:
                iterations, seed = min(100, ITERATIONS[kind]), int(rng.integers(1000))
                question = {"problem": garages[kind], "k": k, "iterations": iterations, "rng": seed}
                yield Case(kind, question)
        yield self.case_beyond_pi(rng, k=2)
        for kind, garage in (("same", JUST_THERE), ("room", NOT_THERE)):
            seed = int(rng.integers(1000))
            question = {"problem": garage, "k": 2, "iterations": FEW, "rng": seed}
            yield Case(kind, question)

    def uses_chance(self, case: Case) -> bool:
        """Another seed always gives another answer: the roadmap does not stop at the goal."""
        return True

    def tree_of(self, case: Case, answer: Value) -> DrivenTree:
        """Return the roadmap as a tree: each edge leads to a new node."""
        edges, controls, durations, _ = answer
        return DrivenTree(
            NOWHERE,
            np.append(-1, edges[:, 0]),
            np.vstack([[0.0, 0.0], controls]),
            np.append(0.0, durations),
        )

    def turns_of(self, case: Case, tree: DrivenTree, log: Array) -> Turns:
        """Drives from the k nearest nodes in each turn; all turns are used."""
        problem, k, iterations, _ = case.given.values()
        return Turns(problem, tree, log, iterations, k, False)

    def fault(self, case: Case, answer: Value) -> Fault | None:
        """Judge the edges, the drives, the path and its end."""
        problem, k, iterations, _ = case.given.values()
        edges, tree, path = answer[0], self.tree_of(case, answer), answer[-1]
        if not np.array_equal(edges[:, 1], np.arange(1, len(edges) + 1)):
            turned = np.array_equal(edges[:, 0], np.arange(1, len(edges) + 1))
            return Fault("turned" if turned else "edges", NOWHERE)
        if len(edges) > k * iterations:
            return Fault("iterations", NOWHERE)
        fault, nodes = find_drive_fault(problem, tree)
        if fault is not None:
            return fault
        return find_path_fault(tree.parent, path, nodes) or find_slower_end(
            problem, tree, nodes, path
        )


def find_slower_end(
    problem: DrivingProblem, tree: DrivenTree, nodes: Array, path: NDArray[np.int64]
) -> Fault | None:
    """Return a fault where another node near the goal is reached sooner than the path's end."""
    surely, perhaps = find_near_goal(problem, nodes, -SLACK), find_near_goal(problem, nodes, SLACK)
    if not len(surely):
        return None if path[-1] in perhaps else find_end_fault(problem, nodes, path)
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
