"""Long runs in a new process with an empty cache: each is begun interpreted, and begun again as
machine code when another process has compiled it.

The ruler compiles first, and then waits for as long as the budget. A run with an empty cache may
take as long. Every answer is the same.
"""

import hashlib
import itertools
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from timing import Contestant, Goal, measure, report, run

import kinoedu as ke
from kinoedu.collision import paint_configuration_space
from kinoedu.compiled import COMPILED_FIRST, WHEN_IT_PAYS
from kinoedu.compiled.tiers import BUDGET

SECONDS = 400
AT_ONCE, WITH_COMPILER = "kinoedu", "compiled at once, and the budget"


def astar_on_a_million_cells() -> np.ndarray:
    """A* on 1,000 x 1,000 cells of two prices, so that it skips none."""
    rng = np.random.default_rng(0)
    free = rng.random((1000, 1000)) > 0.25
    free[:3, :3] = free[-3:, -3:] = True
    terrain = ke.Terrain(free, cost=rng.choice([1.0, 2.0], free.shape))
    path = ke.plan_on_grid(ke.Problem(ke.Point(), terrain, (1.5, 1.5), (998.5, 998.5))).path
    return np.zeros((0, 2)) if path is None else path


def rrt_of_50_000_nodes() -> np.ndarray:
    """A tree whose goal is out of reach."""
    wall = [(8.0, 0.0), (8.5, 0.0), (8.5, 10.0), (8.0, 10.0)]
    world = ke.PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    problem = ke.Problem(ke.Point(), world, (1, 1), (9, 9))
    return ke.rrt(
        problem, step_size=0.5, max_nodes=50_000, max_iterations=200_000, rng=0
    ).tree.nodes


def arms_configuration_space() -> np.ndarray:
    """360 x 360 configurations of an arm of two links among discs and boxes."""
    world = ke.PolygonWorld(
        [(-3, -3), (3, -3), (3, 3), (-3, 3)],
        [((1.5, 1.0), 0.4), ((-1.5, 0.5), 0.3), [(0.5, -2), (1, -2), (1, -1), (0.5, -1)]],
    )
    return paint_configuration_space(ke.TwoLinkArm(1.0, 1.0, 0.1), world, 360)


RUNS = {
    function.__name__: function
    for function in (astar_on_a_million_cells, rrt_of_50_000_nodes, arms_configuration_space)
}


def process(name: str, mode: str, caches: Iterator[Path]) -> Contestant:
    """A new process that does one of the runs; it prints a digest of its answer."""

    def contestant(_case: Any) -> Callable[[], str]:
        def begin() -> str:
            variables = {"KINOEDU_CACHE": str(next(caches)), "KINOEDU_MACHINE_CODE": mode}
            done = subprocess.run(
                [sys.executable, __file__, "--alone", name],
                env=os.environ | variables,
                check=True,
                capture_output=True,
                text=True,
            )
            if mode == COMPILED_FIRST:
                time.sleep(BUDGET)
            return str(json.loads(done.stdout.splitlines()[-1]))

        return begin

    return contestant


def judge(_case: Any, answers: dict[str, str]) -> None:
    """Every process found the same."""
    assert len(set(answers.values())) == 1, answers


def main(repeats: int = 3) -> None:
    """Three rounds of each run, after one that does not count."""
    with tempfile.TemporaryDirectory() as place:
        anew = map(Path(place).joinpath, map(str, itertools.count()))
        for name in RUNS:
            contestants = {
                AT_ONCE: process(name, WHEN_IT_PAYS, anew),
                WITH_COMPILER: process(name, COMPILED_FIRST, anew),
            }
            seconds = measure(contestants, [None], judge, repeats=repeats)
            report(name.replace("_", " "), seconds, {WITH_COMPILER: Goal(at_most=1.0)})


if __name__ == "__main__":
    if sys.argv[1:2] == ["--alone"]:
        answer = np.ascontiguousarray(RUNS[sys.argv[2]]())
        print(json.dumps(hashlib.sha256(answer.tobytes()).hexdigest()))
    else:
        run(main)
