"""RRT fills a tree of 5,000 nodes among 24 polygons; its goal cannot be reached."""

import random
import runpy
from collections.abc import Callable
from ctypes import byref, c_double, c_int64
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from ompl_peer import Setup, compiled_test
from ruler import compile_c, pointer, tree_of, world_of
from timing import Contestant, Goal, Missing, available, measure, report, run
from worlds import SIDE, WALLED_IN, Case, among_polygons

import kinoedu as ke
from kinoedu.planners.problem_input import new_tree

SECONDS = 60
NODES, STEP, BIAS = 5000, 5.0, 0.05
GOALS = {
    "C ruler": Goal(at_most=1.1),
    "OMPL": Goal(at_least=10),
    "PythonRobotics": Goal(at_least=1000),
}


def kinoedu() -> Contestant:
    """The public function, from the problem to the plan."""
    given = {"step_size": STEP, "goal_bias": BIAS, "max_nodes": NODES}
    return lambda case: lambda: ke.rrt(case.problem, **given, rng=case.seed).tree


def ruler() -> Contestant:
    """The same loop in C, from an empty tree to the full one, on the same random numbers."""
    library = compile_c("rrt_ruler")
    library.grow.restype = c_int64

    def contestant(case: Case) -> Callable[[], Any]:
        problem, world = case.problem, world_of(case.problem)

        def run() -> Any:
            tree, rng, made = (
                new_tree(problem, NODES + 1),
                np.random.default_rng(case.seed),
                c_int64(),
            )
            in_c, draws = tree_of(tree), rng.bit_generator.ctypes
            ends = [
                pointer(q)
                for q in (problem.space.lo, problem.space.hi, problem.start, problem.goal)
            ]
            limits = c_double(STEP), c_double(BIAS), c_int64(10 * NODES)
            at_goal = library.grow(
                byref(world),
                byref(in_c),
                *ends,
                *limits,
                draws.state,
                draws.next_double,
                byref(made),
            )
            return at_goal, in_c.size, tree

        return run

    return contestant


def ompl(make: Callable[[int], Case] = among_polygons) -> Contestant:
    """Its RRT with the same step, goal bias and number of nodes; its test is compiled once for each
    seed's case.
    """
    from ompl import geometric

    test = lru_cache(lambda seed: compiled_test(make(seed).problem))

    def contestant(case: Case) -> Callable[[], Any]:
        setup = Setup(case.problem, test(case.seed))
        planner = geometric.RRT(setup.information)
        planner.setRange(STEP)
        planner.setGoalBias(BIAS)
        planner.setProblemDefinition(setup.definition)
        planner.setup()
        stop = setup.motions.start(NODES - 1)

        def run() -> Any:
            planner.solve(stop)
            return setup, planner

        return run

    return contestant


def python_robotics(checkout: str) -> Contestant:
    """Its RRT, which knows discs alone: the circles round the polygons, judged every half unit as
    by its default. It counts iterations, not nodes: it gets as many as kinoedu needed.
    """
    if not checkout:
        raise Missing("give a checkout of it: --pythonrobotics PATH")
    path = Path(checkout, "PathPlanning", "RRT", "rrt.py")
    if not path.is_file():
        raise Missing(f"there is no {path}")
    theirs = runpy.run_path(str(path))["RRT"]

    def contestant(case: Case) -> Callable[[], Any]:
        plan = ke.rrt(case.problem, step_size=STEP, goal_bias=BIAS, max_nodes=NODES, rng=case.seed)
        random.seed(case.seed)
        area, discs = [0.0, SIDE], [tuple(disc) for disc in case.obstacles.tolist()]
        planner = theirs(
            list(case.problem.start),
            list(WALLED_IN),
            discs,
            area,
            STEP,
            max_iter=plan.stats["iterations"],
        )

        def run() -> Any:
            return planner.planning(animation=False), planner.node_list

        return run

    return contestant


def judge(case: Case, answers: dict[str, Any]) -> None:
    """kinoedu's and the ruler's trees are the same node by node; every motion of OMPL's is free;
    PythonRobotics' is as large.
    """
    ours = answers["kinoedu"]
    assert len(ours.nodes) == NODES
    if "C ruler" in answers:
        at_goal, size, tree = answers["C ruler"]
        assert (at_goal, size) == (-1, NODES), (
            "the ruler was in doubt about an orientation, or stopped early"
        )
        assert np.array_equal(tree.nodes[:NODES], ours.nodes) and np.array_equal(
            tree.parent[:NODES], ours.parent
        )
    if "OMPL" in answers:
        judge_ompl(case, *answers["OMPL"])
    if "PythonRobotics" in answers:
        path, nodes = answers["PythonRobotics"]
        assert path is None and abs(len(nodes) / NODES - 1.0) < 0.15, len(nodes)


def judge_ompl(case: Case, setup: Setup, planner: Any) -> None:
    """The tree has the nodes asked for, and every motion in it is free and at most a step long."""
    data = setup.data(planner)
    at = np.array(
        [(q[0], q[1]) for q in (data.getVertex(i).getState() for i in range(data.numVertices()))]
    )
    assert len(at) == NODES
    problem = case.problem
    for i in range(NODES):
        for j in data.getEdges(i):
            assert problem.is_free_path(at[i], at[j]) and problem.distance(at[i], at[j]) <= STEP * (
                1 + 1e-9
            )


def main(repeats: int = 5, pythonrobotics: str = "") -> None:
    """Three worlds, each planned in five times; `pythonrobotics` is a checkout of
    github.com/AtsushiSakai/PythonRobotics.
    """
    theirs = {"PythonRobotics": lambda: python_robotics(pythonrobotics)}
    contestants = available({"kinoedu": kinoedu, "C ruler": ruler, "OMPL": ompl, **theirs})
    seconds = measure(contestants, map(among_polygons, range(3)), judge, repeats=repeats)
    report(f"RRT, {NODES:,} nodes among 24 polygons", seconds, GOALS)


if __name__ == "__main__":
    run(main)
