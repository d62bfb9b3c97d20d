"""Ten thousand random problems: how many are solved, and whether any path touches anything, judged
anew by `certify.py`.
"""

import argparse
import time
from collections import defaultdict
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from certify import is_valid
from random_problems import ROBOTS, WORLDS, Drawn, drawn

import kinoedu as ke
from kinoedu.bench import surroundings
from kinoedu.chances import wilson_interval

PLANNERS: dict[str, Callable[[Any, int], ke.Plan]] = {
    "RRT": lambda problem, seed: ke.rrt(problem, max_nodes=1500, rng=seed),
    "RRT-Connect": lambda problem, seed: ke.rrt_connect(problem, max_nodes=1500, rng=seed),
    "RRT*": lambda problem, seed: ke.rrt_star(problem, max_nodes=400, rng=seed),
    "informed RRT*": lambda problem, seed: ke.informed_rrt_star(problem, max_nodes=400, rng=seed),
    "PRM": lambda problem, seed: ke.prm(problem, n=200, k=8, rng=seed),
    "PRM*": lambda problem, seed: ke.prm_star(problem, n=150, rng=seed),
    "RRT, shortcuts": lambda problem, seed: ke.shortcut(
        ke.rrt(problem, max_nodes=1500, rng=seed), tries=60, rng=seed
    ),
}
ON_A_GRID = {"A* on a grid": lambda problem, seed: ke.plan_on_grid(problem)}
EXACT = {
    "decomposition": lambda problem, seed: ke.plan_by_decomposition(problem),
    "visibility": lambda problem, seed: ke.plan_by_visibility(problem),
}
DRIVING = {
    "kinodynamic RRT": lambda problem, seed: ke.kinodynamic_rrt(
        problem, max_iterations=2000, rng=seed
    ),
    "kinodynamic PRM": lambda problem, seed: ke.kinodynamic_prm(problem, n=700, rng=seed),
    "SST": lambda problem, seed: ke.sst(problem, max_iterations=10_000, rng=seed),
    "hybrid A*": lambda problem, seed: ke.hybrid_astar(problem, max_nodes=5_000),
}
ONE_WAY = {"RRT", *DRIVING}  # those that plan for a car which only goes forward
SEMI_FREE = ("visibility",)
KINDS = len(ROBOTS) * len(WORLDS)


class Outcome(NamedTuple):
    """What came of one problem: who planned in what, whether there was a path, and whether it was
    valid.
    """

    planner: str
    setting: str
    seed: int
    solved: bool
    valid: bool


def planners_for(
    case: Drawn, only: list[str] | None = None
) -> dict[str, Callable[[Any, int], ke.Plan]]:
    """Those that take such a problem, among those named."""
    fitting = dict(PLANNERS)
    if case.robot in ("point", "disk"):
        fitting |= ON_A_GRID
    if (case.robot, case.world) == ("point", "polygons"):
        fitting |= EXACT
    if case.robot == "car":
        fitting |= DRIVING
        if not case.problem.robot.both_ways:
            fitting = {name: plan for name, plan in fitting.items() if name in ONE_WAY}
    return {name: plan for name, plan in fitting.items() if only is None or name in only}


def outcome(seed: int, only: list[str] | None = None) -> Outcome | None:
    """Draw a problem, plan with one of the planners that take it, in turn, and judge the path. None
    where none takes it.
    """
    case = drawn(seed)
    fitting = planners_for(case, only)
    if not fitting:
        return None
    name = list(fitting)[seed // KINDS % len(fitting)]
    plan = fitting[name](case.problem, seed)
    solved = plan.path is not None
    return Outcome(
        name,
        f"{case.robot}, {case.world}",
        seed,
        solved,
        not solved or is_valid(plan, semi_free=name in SEMI_FREE),
    )


def table(title: str, outcomes: Iterable[Outcome], key: Callable[[Outcome], str]) -> None:
    """Print, for each key: how many problems, the share solved with its interval, and how many
    paths are invalid.
    """
    groups: dict[str, list[Outcome]] = defaultdict(list)
    for one in outcomes:
        groups[key(one)].append(one)
        groups["all"].append(one)
    print(
        f"\n| {title} | problems | solved, % | 95 % interval | paths | invalid "
        "|\n|---|---:|---:|---|---:|---:|"
    )
    for name in sorted(groups, key=lambda name: (name == "all", name)):
        group = groups[name]
        solved = sum(one.solved for one in group)
        low, high = wilson_interval(solved, len(group))
        invalid = sum(not one.valid for one in group)
        share = f"{100 * solved / len(group):.1f} | {100 * low:.1f} to {100 * high:.1f}"
        print(f"| {name} | {len(group):,} | {share} | {solved:,} | {invalid} |")


def main() -> None:
    """All problems, the tables, and the seeds of invalid paths; the exit status is 1 where there
    are any.
    """
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--problems", type=int, default=10_000)
    options.add_argument("--first", type=int, default=0, help="the first seed")
    options.add_argument(
        "--planners",
        nargs="+",
        choices=[*PLANNERS, *ON_A_GRID, *EXACT, *DRIVING],
        help="these alone (all)",
    )
    given = options.parse_args()
    began = time.perf_counter()
    tried = (
        outcome(seed, given.planners) for seed in range(given.first, given.first + given.problems)
    )
    outcomes = [one for one in tried if one is not None]
    table("planner", outcomes, lambda one: one.planner)
    table("robot, world", outcomes, lambda one: one.setting)
    invalid = [one for one in outcomes if not one.valid]
    print(f"\n{time.perf_counter() - began:.0f} s; {surroundings()}")
    for one in invalid:
        print(f"INVALID: seed {one.seed}, {one.planner}, {one.setting}")
    raise SystemExit(bool(invalid))


if __name__ == "__main__":
    main()
