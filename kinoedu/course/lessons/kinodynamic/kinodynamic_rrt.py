"""The exercise `kinodynamic_rrt`.

S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning" (2001).
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....graphs import extract_path
from ....planners.driving.kinodynamic_rrt import grow_by_driving
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
def grow_tree(problem: DrivingProblem, iterations: int, rng: int) -> Value:
    """Grow the tree as the exercise demands, and return its arrays and path."""
    chance, nodes = np.random.default_rng(rng), [problem.start]
    parent, controls, durations = [-1], [(0.0, 0.0)], [0.0]
    for turn in range(1, iterations + 1):
        if len(find_near_goal(problem, np.array(nodes[-1:]))):
            break
        target = choose_target(problem, turn, chance)
        near = int(measure_distances(problem, np.array(nodes), target).argmin())
        drive = problem.best_drive(nodes[near], target, chance)
        if drive is None:
            continue
        v, phi, t = drive
        nodes.append(problem.move(nodes[near], v, phi, t))
        parent.append(near)
        controls.append((v, phi))
        durations.append(t)
    there = find_near_goal(problem, np.array(nodes))
    nearest = measure_distances(problem, np.array(nodes), problem.goal).argmin()
    last = there[0] if len(there) else nearest
    return parent, controls, durations, extract_path(np.array(parent), int(last))


class KinodynamicRrt(DrivingPlanner):
    """Grow a tree of drives."""

    name = "kinodynamic_rrt"
    kinds = KINDS
    given = Record(problem=DrivenProblemShape(), iterations=Integer(), rng=Integer())
    result = Together((Integers(("n",)), CONTROLS, DURATIONS, ROUTE))
    answer = with_logs(result)
    source = staticmethod(grow_tree)
    shown = staticmethod(grow_by_driving)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield every garage twice, then a goal whose heading is on the other side of pi."""
        for garages in (GARAGES, TURNED):
            for kind in KINDS:
                seed = int(rng.integers(1000))
                question = {"problem": garages[kind], "iterations": ITERATIONS[kind], "rng": seed}
                yield Case(kind, question)
        yield self.case_beyond_pi(rng)
        for kind, garage in (("same", JUST_THERE), ("room", NOT_THERE)):
            seed = int(rng.integers(1000))
            question = {"problem": garage, "iterations": FEW, "rng": seed}
            yield Case(kind, question)

    def tree_of(self, case: Case, answer: Value) -> DrivenTree:
        """Return the tree in an answer."""
        return DrivenTree(NOWHERE, *answer[:3])

    def turns_of(self, case: Case, tree: DrivenTree, log: Array) -> Turns:
        """One drive in each turn, up to the goal."""
        return Turns(case.given["problem"], tree, log, case.given["iterations"], 1, True)

    def fault(self, case: Case, answer: Value) -> Fault | None:
        """Judge the drives, the path and its end."""
        problem, iterations, _ = case.given.values()
        tree, path = self.tree_of(case, answer), answer[-1]
        if len(tree.parent) > iterations + 1:
            return Fault("iterations", NOWHERE)
        fault, nodes = find_drive_fault(problem, tree)
        if fault is not None:
            return fault
        return find_path_fault(tree.parent, path, nodes) or find_goal_fault(problem, nodes, path)


def find_goal_fault(problem: DrivingProblem, nodes: Array, path: NDArray[np.int64]) -> Fault | None:
    """Return a fault where growth went on after the goal was reached or the path ends elsewhere."""
    surely, perhaps = find_near_goal(problem, nodes, -SLACK), find_near_goal(problem, nodes, SLACK)
    if len(surely) and surely[0] < len(nodes) - 1:
        return Fault("returned", nodes[surely[:1]])
    if path[-1] in perhaps:
        return None
    return Fault("goal", nodes[path[-1:]]) if len(surely) else find_end_fault(problem, nodes, path)
