"""How far from the shortest path planners are that sample, against how much they sample: a point
among polygons, over seeds.

The optimum is the visibility roadmap's, which may touch corners; a path that must not touch them
comes as close to it as you like.
"""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from random_problems import SQUARE, star
from timing import run, surroundings

import kinoedu as ke
from kinoedu.errors import InvalidGoal, InvalidStart
from kinoedu.problems import ProblemRecord

SAMPLES = (250, 1000, 4000)

PLANNERS: dict[str, Callable[[Any, int, int], ke.Plan]] = {
    "RRT*": lambda problem, n, seed: ke.rrt_star(problem, max_nodes=n, rng=seed),
    "informed RRT*": lambda problem, n, seed: ke.informed_rrt_star(problem, max_nodes=n, rng=seed),
    "PRM*": lambda problem, n, seed: ke.prm_star(problem, n=n, rng=seed),
    "RRT, then so many shortcuts": lambda problem, n, seed: ke.shortcut(
        ke.rrt(problem, rng=seed), tries=n, rng=seed
    ),
}


def crowded(seed: int) -> tuple[ProblemRecord, float]:
    """A point among 15 polygons, from corner to corner, and its shortest path's length; drawn until
    there is one that turns.
    """
    rng = np.random.default_rng([seed, 11])
    while True:
        world = ke.PolygonWorld(SQUARE, [star(rng) for _ in range(15)])
        try:
            problem = ke.Problem(ke.Point(), world, (0.3, 0.3), (9.7, 9.7))
        except (InvalidStart, InvalidGoal):
            continue
        shortest = ke.plan_by_visibility(problem)
        if shortest.path is not None and len(shortest.path) > 2:
            return problem, shortest.cost


def gaps(
    planner: str, n: int, cases: Iterable[tuple[ProblemRecord, float]], seeds: Iterable[int]
) -> np.ndarray:
    """By how much each path is longer than the shortest, as a share of it, (k,); infinite where
    none was found.
    """
    found = [
        PLANNERS[planner](problem, n, seed).cost / shortest - 1.0
        for seed in seeds
        for problem, shortest in cases
    ]
    assert min(found) > -1e-9, (planner, n, "a path shorter than the shortest")
    return np.array(found)


def row(planner: str, cases: list[tuple[ProblemRecord, float]], seeds: range) -> str:
    """A planner's line of the table: for each number of samples the median gap, the quartiles, and
    the share solved.
    """
    cells = []
    for n in SAMPLES:
        found = gaps(planner, n, cases, seeds)
        solved = found[np.isfinite(found)]
        low, middle, high = (
            100 * np.percentile(solved, [25, 50, 75]) if len(solved) else [np.nan] * 3
        )
        cells.append(
            f"{middle:.2f} ({low:.2f} to {high:.2f}), {100 * len(solved) / len(found):.0f}"
        )
    return f"| {planner} | {' | '.join(cells)} |"


def main(worlds: int = 10, seeds: int = 10) -> None:
    """The table: gap in per cent, median and quartiles over worlds and seeds, and how many in a
    hundred were solved.
    """
    cases = [crowded(seed) for seed in range(worlds)]
    print(
        "| gap in %: median (quartiles), solved in % | "
        f"{' | '.join(f'{n:,} samples' for n in SAMPLES)} |"
    )
    print("|---|" + "---|" * len(SAMPLES))
    for planner in PLANNERS:
        print(row(planner, cases, range(seeds)), flush=True)
    print(f"\n{worlds} worlds, {seeds} seeds each; {surroundings()}")


if __name__ == "__main__":
    run(main)
