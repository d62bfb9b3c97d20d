"""RRT-Connect's first solution among 24 boxes and through narrow doors, and RRT* grown for 5,000 iterations."""

import argparse
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from timing import Contestant, Goal, available, measure, report
from worlds import SIDE, Case, among_boxes, through_doors

import kinoedu as ke

STEP, ITERATIONS = 5.0, 5000
GOALS = {"pathplanning": Goal(at_least=8)}


def kinoedu(planner: str) -> Contestant:
    """The public functions, from the problem to the plan."""
    if planner == "rrt_connect":
        return lambda case: lambda: ke.rrt_connect(case.problem, step=STEP, max_nodes=50_000, rng=case.seed)
    return lambda case: (
        lambda: ke.rrt_star(case.problem, step=STEP, max_nodes=ITERATIONS + 1, max_iterations=ITERATIONS, rng=case.seed)
    )


def pathplanning(planner: str) -> Contestant:
    """Its native planners, which judge motions among boxes exactly; gamma is the one that kinoedu's defaults come to."""
    from pathplanning.core.contracts import ContinuousProblem, GoalState
    from pathplanning.core.params import RrtParams
    from pathplanning.planners.sampling.rrt_connect import plan_rrt_connect
    from pathplanning.planners.sampling.rrt_star import plan_rrt_star
    from pathplanning.spaces import Grid2DSamplingSpace

    plan = plan_rrt_connect if planner == "rrt_connect" else plan_rrt_star
    gamma = 2.0 * 1.5**0.5 * SIDE / np.pi**0.5

    def contestant(case: Case) -> Callable[[], Any]:
        space = Grid2DSamplingSpace((0, SIDE), (0, SIDE), obs_rectangle=case.obstacles.tolist(), delta=0.0)
        radius = {"rrt_star_radius_gamma": gamma, "rrt_star_radius_bias": 0.0, "rrt_star_radius_max_factor": 1.0}
        params = RrtParams(max_iters=100 * ITERATIONS if planner == "rrt_connect" else ITERATIONS, step_size=STEP, **radius)
        asked = ContinuousProblem(space, case.problem.start, GoalState(case.problem.goal))
        return lambda: plan(asked, params=params, rng=np.random.default_rng(case.seed))

    return contestant


def judge(case: Case, answers: dict[str, Any]) -> None:
    """Every path leads from start to goal, and all its motions are free."""
    for name, answer in answers.items():
        path = np.asarray(answer.path)
        assert np.allclose(path[0], case.problem.start) and np.allclose(path[-1], case.problem.goal), name
        assert all(case.problem.is_free_path(a, b) for a, b in zip(path[:-1], path[1:], strict=True)), name


def main() -> None:
    """Ten worlds, each planned in seven times."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--repeats", type=int, default=7)
    repeats = options.parse_args().repeats
    for planner, title, world in (
        ("rrt_connect", "RRT-Connect, first solution among 24 boxes", among_boxes),
        ("rrt_connect", "RRT-Connect, first solution through three doors", through_doors),
        ("rrt_star", f"RRT*, {ITERATIONS:,} iterations among 24 boxes", among_boxes),
    ):
        makers = {"kinoedu": kinoedu, "pathplanning": pathplanning}
        contestants = available({name: partial(make, planner) for name, make in makers.items()})
        seconds = measure(contestants, map(world, range(10)), judge, repeats=repeats)
        report(title, seconds, GOALS if planner == "rrt_connect" else {})


if __name__ == "__main__":
    main()
