"""RRT fills a tree of 5,000 nodes on a bitmap of 512 x 512 cells; its goal cannot be reached."""

import random
from collections.abc import Callable
from typing import Any

import numpy as np
from rrt import BIAS, NODES, STEP, judge_ompl, kinoedu, ompl
from timing import Contestant, Goal, available, measure, report, run
from worlds import Case

import kinoedu as ke

SECONDS = 120
SIZE, BLOCKS, START, GOAL = 512, 120, 2, 508
PYTHON_MOTION_PLANNING = "python-motion-planning"
GOALS = {"OMPL": Goal(at_least=8), PYTHON_MOTION_PLANNING: Goal(at_least=70)}


def in_town(seed: int) -> Case:
    """Blocks of 8 to 40 cells on a side, and a wall three cells thick round the goal. The
    obstacles: true where a cell is free.
    """
    rng = np.random.default_rng(seed)
    free = np.ones((SIZE, SIZE), bool)
    for row, column, height, width in rng.integers((0, 0, 8, 8), (SIZE, SIZE, 40, 40), (BLOCKS, 4)):
        free[row : row + height, column : column + width] = False
    free[:8, :8], free[GOAL - 3 :, GOAL - 3 :] = True, False
    free[GOAL, GOAL] = True
    problem = ke.Problem(
        ke.Point(), ke.Terrain(free), (START + 0.5, START + 0.5), (GOAL + 0.5, GOAL + 0.5)
    )
    return Case(problem, seed, free)


def python_motion_planning() -> Contestant:
    """Its RRT with neighbours by Faiss, and its test of the cells on a line by numba, its defaults.
    It counts iterations and gets as many as kinoedu made. Its cells have whole numbers at their
    centres.
    """
    from python_motion_planning.common import Grid
    from python_motion_planning.path_planner import RRT

    def contestant(case: Case) -> Callable[[], Any]:
        plan = ke.rrt(case.problem, step_size=STEP, goal_bias=BIAS, max_nodes=NODES, rng=case.seed)
        taken = np.ascontiguousarray(~case.obstacles.T, dtype=np.int8)
        grid = Grid(bounds=[[0, SIZE], [0, SIZE]], type_map=taken)
        limits = {
            "max_dist": STEP,
            "goal_sample_rate": BIAS,
            "max_sample_step": plan.stats["iterations"],
        }
        planner = RRT(map_=grid, start=(START, START), goal=(GOAL, GOAL), **limits)
        random.seed(case.seed)
        return planner.plan

    return contestant


def judge(case: Case, answers: dict[str, Any]) -> None:
    """Ours is full; every motion of OMPL's is free; the other's nodes are in free cells, and about
    as many.
    """
    assert len(answers["kinoedu"].nodes) == NODES
    if "OMPL" in answers:
        judge_ompl(case, *answers["OMPL"])
    if PYTHON_MOTION_PLANNING in answers:
        path, log = answers[PYTHON_MOTION_PLANNING]
        x, y = np.round(np.array(list(log["expand"]))).astype(int).T
        assert not path and case.obstacles[y, x].all() and abs(len(x) / NODES - 1.0) < 0.25, len(x)


def main(repeats: int = 5) -> None:
    """Three bitmaps, each planned on five times."""
    theirs = {"OMPL": lambda: ompl(in_town), PYTHON_MOTION_PLANNING: python_motion_planning}
    seconds = measure(
        available({"kinoedu": kinoedu, **theirs}), map(in_town, range(3)), judge, repeats=repeats
    )
    report(f"RRT, {NODES:,} nodes on {SIZE} x {SIZE} cells", seconds, GOALS)


if __name__ == "__main__":
    run(main)
