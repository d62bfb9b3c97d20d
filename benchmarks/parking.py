"""Which cars park within ten seconds: the twenty cases of TPCAP, and bench-mr's car parks and
warehouse. A table, not a race.

Each planner plans again and again from one generator, each time with twice the nodes or iterations,
until it has a path; seconds are those of the processor. The radii of SST shrink by a tenth each
time: SST*, algorithm 7 of its paper. Its tree is finer near the goal. Every path is replayed from
its controls and judged by shapely in fine steps before it counts.
"""

import json
import time
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import shapely
from timing import run

import kinoedu as ke
from kinoedu.files import read_tpcap
from kinoedu.problems import Plan, ProblemRecord

DATA = Path(__file__).resolve().parent.parent / "tests" / "data" / "parking"
MARGIN = 8.0  # metres round everything: the maps have no boundary
PARKED = {
    "parking1, rows": ((9.0, 7.0, 0.0), (4.0, 9.0, np.pi / 2), "parking1"),
    "parking1, wide": ((-4.0, 7.0, 0.0), (10.4, 1.5, np.pi / 2), "parking1"),
    "parking2, rows": ((1.0, 7.0, 0.0), (12.2, 9.8, np.pi / 2), "parking2"),
    "parking2, kerb": ((16.0, 7.5, np.pi), (15.2, 1.4, np.pi / 2), "parking2"),
    "warehouse": ((10.0, 70.0, -np.pi / 2), (76.0, 16.0, np.pi / 2), "warehouse"),
}


class Case(NamedTuple):
    """A problem, its obstacles for the judge, and its name."""

    name: str
    problem: ProblemRecord
    solid: Any


def case_of(name: str, problem: ProblemRecord, obstacles: list[np.ndarray]) -> Case:
    """A problem in a rectangle, and for the judge its obstacles with all that lies outside."""
    lo, hi = problem.world.lo, problem.world.hi
    frame = shapely.box(*lo - 100.0, *hi + 100.0) - shapely.box(*lo, *hi)
    return Case(name, problem, shapely.union_all([frame, *map(shapely.Polygon, obstacles)]))


def tpcap() -> Iterator[Case]:
    """The cases of the competition; the judge reads them by numpy alone."""
    for number in range(1, 21):
        file = DATA / "tpcap" / f"Case{number}.csv"
        numbers = np.loadtxt(file, delimiter=",")
        n = int(numbers[6])
        ends = np.cumsum(numbers[7 : 7 + n].astype(int))[:-1]
        rings = np.split(numbers[7 + n :].reshape(-1, 2), ends)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ke.errors.MendedPolygons)  # 19 repeats corners
            yield case_of(f"TPCAP {number}", read_tpcap(file), rings)


def bench_mr() -> Iterator[Case]:
    """Its car parks and warehouse, turned so that y points up, for a car as large as its own."""
    car = ke.Car(4.25, 1.9, 2.6, max_steering=0.6)
    for name, (start, goal, file) in PARKED.items():
        rings = json.loads((DATA / f"bench_mr_{file}.json").read_text(encoding="utf-8"))["polygons"]
        top = max(y for ring in rings for _, y in ring)
        hulls = [
            ke.geometry.convex_hull([(x, top - y) for x, y in ring]) for ring in rings
        ]  # rounding made some cross themselves
        places = np.vstack([*hulls, np.array([start, goal])[:, :2]])
        (x0, y0), (x1, y1) = places.min(axis=0) - MARGIN, places.max(axis=0) + MARGIN
        world = ke.PolygonWorld([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], hulls)
        yield case_of(f"bench-mr {name}", ke.Problem(car, world, start, goal), hulls)


def shrinking_sst(problem: ProblemRecord, turn: int, rng: np.random.Generator) -> Plan:
    """SST whose radii, at first the defaults, are a tenth smaller with each doubling of `turn`."""
    base = problem.robot.wheelbase
    radius = 0.4 * base * 0.9 ** np.log2(turn)
    return ke.sst(
        problem,
        sparsity=ke.Sparsity(radius),
        goal_bias=ke.GoalBias(goal_every=10, region_every=3, region=base, region_turn=0.5),
        refinement=ke.Refinement(),
        max_iterations=5000 * turn,
        rng=rng,
    )


PLANNERS: dict[str, Callable[[ProblemRecord, int, np.random.Generator], Plan]] = {
    "rrt (curves)": lambda problem, turn, rng: ke.rrt(problem, max_nodes=3000 * turn, rng=rng),
    "rrt_connect (curves)": lambda problem, turn, rng: ke.rrt_connect(
        problem, max_nodes=3000 * turn, rng=rng
    ),
    "kinodynamic_rrt": lambda problem, turn, rng: ke.kinodynamic_rrt(
        problem, max_iterations=5000 * turn, rng=rng
    ),
    "sst*": shrinking_sst,
    "hybrid_astar": lambda problem, turn, rng: ke.hybrid_astar(problem),
}


def first_path(
    planner: Callable[..., Plan], case: Case, seconds: float
) -> tuple[Plan | None, float]:
    """The first plan with a path, and how long it took; None when time is up."""
    rng, began, turn = np.random.default_rng(0), time.process_time(), 1
    while True:
        plan, took = planner(case.problem, turn, rng), time.process_time() - began
        if plan.path is not None and took <= seconds:
            return plan, took
        if took > seconds:
            return None, took
        turn *= 2


def judge(case: Case, plan: Plan) -> None:
    """Replayed from its controls, the trajectory begins at the start, ends where the plan says, and
    shapely sees no contact.
    """
    there, car = ke.trajectory_along(plan), case.problem.robot
    assert np.allclose(there.poses[0], case.problem.start, rtol=0, atol=1e-9)
    off = there.poses[-1] - plan.path[-1]
    assert np.hypot(off[0], off[1]) < 1e-5 and abs(np.sin(off[2] / 2)) < 1e-6, off
    poses = there.at(np.linspace(0.0, there.duration, 4000))
    cos, sin, (x, y) = np.cos(poses[:, 2:]), np.sin(poses[:, 2:]), car.outline.T
    corners = np.stack(
        [poses[:, :1] + cos * x - sin * y, poses[:, 1:2] + sin * x + cos * y], axis=-1
    )
    assert not shapely.intersects(shapely.polygons(corners), case.solid).any(), case.name


def reversals(plan: Plan) -> int:
    """How often the car changes between forward and backward."""
    speeds = ke.trajectory_along(plan).controls[:, 0]
    return int((np.diff(np.sign(speeds)) != 0).sum())


def main(seconds: float = 10.0) -> None:
    """A row for each case: how long each planner took, how far it drives, and how often it
    reverses.
    """
    cases = [*tpcap(), *bench_mr()]
    for planner in PLANNERS.values():
        planner(cases[0].problem, 1, np.random.default_rng(0))  # compiles
    print(f"\n| case | {' | '.join(PLANNERS)} |\n|---|{'---|' * len(PLANNERS)}")
    for case in cases:
        row = []
        for planner in PLANNERS.values():
            plan, took = first_path(planner, case, seconds)
            if plan is not None:
                judge(case, plan)
            row.append(
                f"not within {seconds:g} s"
                if plan is None
                else f"{took:.2g} s, {plan.cost:.3g} m, {reversals(plan)}"
            )
        print(f"| {case.name} | {' | '.join(row)} |", flush=True)


if __name__ == "__main__":
    run(main)
