"""Where chance decides how long a planner takes: RRT-Connect through three doors, and RRT* until
its path is as short as kinoedu's. The median time over many seeds, with its interval.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from ompl_peer import Setup, compiled_test
from timing import Contestant, Goal, available, compare_medians, measure, report, run
from trees import ITERATIONS, STEP, boxed, judge, kinoedu, pathplanning
from worlds import Case, among_boxes, through_doors

SECONDS = 300
PATIENCE = 5.0  # seconds; whoever needs longer counts as having needed this long


class Found:
    """OMPL's path; the planner stays alive while its states are read."""

    def __init__(self, setup: Setup, planner: Any) -> None:
        self.setup, self.planner = setup, planner

    @property
    def path(self) -> np.ndarray:
        """The path found, shape (n, 2)."""
        states = self.setup.definition.getSolutionPath().getStates()
        return np.array([(q[0], q[1]) for q in states])


def ompl(world: Case) -> Contestant:
    """Its RRT* with the same step, until its path costs no more than kinoedu's of the same seed."""
    from ompl import base, geometric, util

    util.RNG.setSeed(1)
    free, ours = compiled_test(world.problem), kinoedu("rrt_star")

    def contestant(case: Case) -> Callable[[], Any]:
        setup = Setup(case.problem, free)
        shortest = base.PathLengthOptimizationObjective(setup.information)
        shortest.setCostThreshold(base.Cost(ours(case)().cost))
        setup.definition.setOptimizationObjective(shortest)
        planner = geometric.RRTstar(setup.information)
        planner.setRange(STEP)
        planner.setProblemDefinition(setup.definition)
        planner.setup()

        def solve() -> Found:
            planner.solve(base.timedPlannerTerminationCondition(PATIENCE))
            return Found(setup, planner)

        return solve

    return contestant


def main(seeds: int = 200, repeats: int = 1) -> None:
    """A set of doors for each seed; one world of boxes for all seeds."""
    doors = available(
        {
            "kinoedu": lambda: kinoedu("rrt_connect"),
            "pathplanning": lambda: pathplanning("rrt_connect", boxed),
        }
    )
    seconds = measure(doors, map(through_doors, range(seeds)), judge, repeats=repeats)
    over = "medians over {} seeds, with their 95 % interval"
    title = f"RRT-Connect through three doors, {over.format(seeds)}"
    report(title, seconds, {"pathplanning": Goal(at_least=5)}, compare=compare_medians)

    world = among_boxes(0)
    trees = available({"kinoedu": lambda: kinoedu("rrt_star"), "ompl": lambda: ompl(world)})
    cases = [world._replace(seed=seed) for seed in range(seeds // 10)]
    seconds = measure(trees, cases, judge, repeats=repeats)
    title = f"RRT* to the cost of {ITERATIONS:,} iterations, {over.format(len(cases))}"
    report(title, seconds, {}, compare=compare_medians)


if __name__ == "__main__":
    run(main)
