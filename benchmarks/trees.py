"""RRT-Connect's first solution among 24 polygons, 24 boxes and through narrow doors, and RRT* grown
for 5,000 iterations.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from ompl_peer import FreeMotion, compiled_test
from timing import Contestant, Goal, available, measure, report, run
from worlds import SIDE, Case, among_boxes, between_polygons, through_doors

import kinoedu as ke

SECONDS = 120
STEP, ITERATIONS = 5.0, 5000


def kinoedu(planner: str) -> Contestant:
    """The public functions, from the problem to the plan."""
    if planner == "rrt_connect":
        return lambda case: (
            lambda: ke.rrt_connect(case.problem, step_size=STEP, max_nodes=50_000, rng=case.seed)
        )
    return lambda case: (
        lambda: ke.rrt_star(
            case.problem,
            step_size=STEP,
            max_nodes=ITERATIONS + 1,
            max_iterations=ITERATIONS,
            rng=case.seed,
        )
    )


class AmongPolygons:
    """A plane with polygons as pathplanning asks for it in Python: it knows none itself. Compiled
    code answers.
    """

    distance_metric = "euclidean"  # it may look for neighbours by its own index
    bounds, dimension = ((0.0, SIDE), (0.0, SIDE)), 2

    def __init__(self, free: FreeMotion) -> None:
        self.free = free

    def sample_free(self, rng: np.random.Generator) -> np.ndarray:
        """A free place."""
        while not self.is_state_valid(q := rng.uniform(0.0, SIDE, 2)):
            pass
        return q

    def is_state_valid(self, q: np.ndarray) -> bool:
        """Whether a place is free."""
        return self.free(q[0], q[1], q[0], q[1])

    def is_motion_valid(self, a: np.ndarray, b: np.ndarray) -> bool:
        """Whether a motion is free."""
        return self.free(a[0], a[1], b[0], b[1])

    def distance(self, a: np.ndarray, b: np.ndarray) -> float:
        """How far apart two places are."""
        return float(np.hypot(b[0] - a[0], b[1] - a[1]))

    def steer(self, a: np.ndarray, b: np.ndarray, step: float) -> np.ndarray:
        """A step from a towards b."""
        apart = self.distance(a, b)
        return b if apart <= step else a + step / apart * (b - a)


def among_polygons(case: Case) -> Any:
    """A plane that pathplanning asks in Python, by a test compiled for its world."""
    return AmongPolygons(compiled_test(case.problem))


def boxed(case: Case) -> Any:
    """pathplanning's own plane with boxes, which it judges exactly, without Python."""
    from pathplanning.spaces import Grid2DSamplingSpace

    return Grid2DSamplingSpace(
        (0, SIDE), (0, SIDE), obs_rectangle=case.obstacles.tolist(), delta=0.0
    )


def pathplanning(planner: str, space_of: Callable[[Case], Any]) -> Contestant:
    """Its native planners; gamma is the one that kinoedu's defaults come to."""
    from pathplanning.core.contracts import ContinuousProblem, GoalState
    from pathplanning.core.params import RrtParams
    from pathplanning.planners.sampling.rrt_connect import plan_rrt_connect
    from pathplanning.planners.sampling.rrt_star import plan_rrt_star

    plan = plan_rrt_connect if planner == "rrt_connect" else plan_rrt_star
    gamma = 2.0 * 1.5**0.5 * SIDE / np.pi**0.5

    def contestant(case: Case) -> Callable[[], Any]:
        radius = {
            "rrt_star_radius_gamma": gamma,
            "rrt_star_radius_bias": 0.0,
            "rrt_star_radius_max_factor": 1.0,
        }
        iterations = 100 * ITERATIONS if planner == "rrt_connect" else ITERATIONS
        params = RrtParams(
            max_iters=iterations, step_size=STEP, allow_python_callbacks=True, **radius
        )
        query = ContinuousProblem(space_of(case), case.problem.start, GoalState(case.problem.goal))
        return lambda: plan(query, params=params, rng=np.random.default_rng(case.seed))

    return contestant


def judge(case: Case, answers: dict[str, Any]) -> None:
    """Every path leads from start to goal, and all its motions are free."""
    for name, answer in answers.items():
        path = np.asarray(answer.path)
        assert np.allclose(path[0], case.problem.start) and np.allclose(
            path[-1], case.problem.goal
        ), name
        assert all(
            case.problem.is_free_path(a, b) for a, b in zip(path[:-1], path[1:], strict=True)
        ), name


def main(repeats: int = 7) -> None:
    """Ten worlds, each planned in seven times."""
    first = "RRT-Connect, first solution"
    for planner, title, world, space_of, times in (
        ("rrt_connect", f"{first} among 24 polygons", between_polygons, among_polygons, 20),
        ("rrt_connect", f"{first} among 24 boxes", among_boxes, boxed, None),
        ("rrt_connect", f"{first} through three doors", through_doors, boxed, 5),
        ("rrt_star", f"RRT*, {ITERATIONS:,} iterations among 24 boxes", among_boxes, boxed, None),
    ):
        makers: dict[str, Callable[[], Contestant]] = {
            "kinoedu": partial(kinoedu, planner),
            "pathplanning": partial(pathplanning, planner, space_of),
        }
        seconds = measure(available(makers), map(world, range(10)), judge, repeats=repeats)
        report(title, seconds, {"pathplanning": Goal(at_least=times)})


if __name__ == "__main__":
    run(main)
