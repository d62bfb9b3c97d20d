"""PRM samples 500 and 2,000 nodes among 24 boxes, joins each to its 10 closest and searches the
roadmap.
"""

from collections.abc import Callable
from ctypes import byref, c_double, c_int64
from functools import lru_cache, partial
from typing import Any, NamedTuple

import numpy as np
from ompl_peer import Setup, compiled_test
from ruler import compile_c, pointer, world_of
from timing import Contestant, Goal, available, measure, report, run
from worlds import SIDE, Case, among_boxes

import kinoedu as ke
from kinoedu.planners.roadmaps.neighbours import k_closest

SECONDS = 60
K = 10
GOALS = {
    "C ruler": Goal(at_most=1.1),
    "pathplanning": Goal(at_least=1.5),
    "OMPL": Goal(at_least=7),
}


class Roadmap(NamedTuple):
    """What the ruler answers."""

    nodes: np.ndarray
    edges: np.ndarray
    cost: float


def kinoedu(n: int) -> Contestant:
    """The public function, from the problem to the plan."""
    return lambda case: lambda: ke.prm(case.problem, n=n, k=K, rng=case.seed)


def ruler(n: int) -> Contestant:
    """Samples, edges and search in C; the neighbours by the same k-d tree, which is C++."""
    library = compile_c("prm_ruler")
    library.sample_free.restype = library.join.restype = c_int64
    library.search.restype = c_double

    def contestant(case: Case) -> Callable[[], Roadmap]:
        problem, world = case.problem, byref(in_c := world_of(case.problem))

        def run() -> Roadmap:
            nodes, rng, _alive = np.empty((n + 2, 2)), np.random.default_rng(case.seed), in_c
            nodes[0], nodes[1], draws = problem.start, problem.goal, rng.bit_generator.ctypes
            box = pointer(problem.space.lo), pointer(problem.space.hi)
            found = library.sample_free(
                world,
                pointer(nodes),
                c_int64(n),
                c_int64(100 * n),
                *box,
                draws.state,
                draws.next_double,
            )
            near = k_closest(problem, nodes[:found], K)
            edges, lengths, parent = (
                np.empty((near.size, 2), np.int64),
                np.empty(near.size),
                np.empty(found, np.int64),
            )
            at, size = (pointer(nodes), c_int64(found)), near.shape[1]
            joined = library.join(
                world, *at, pointer(near), c_int64(size), pointer(edges), pointer(lengths)
            )
            cost = library.search(
                *at, pointer(edges), pointer(lengths), c_int64(joined), pointer(parent)
            )
            return Roadmap(nodes[:found], edges[:joined], cost)

        return run

    return contestant


def pathplanning(n: int) -> Contestant:
    """Its native PRM*, on the same boxes, which it knows natively. It joins all within a radius:
    one that has about as many motions judged as kinoedu judges, near the rim of the world fewer.
    """
    from pathplanning.core.contracts import ContinuousProblem, GoalState
    from pathplanning.core.params import RoadmapParams
    from pathplanning.planners.sampling.prm_star import plan_prm_star
    from pathplanning.spaces import Grid2DSamplingSpace

    def contestant(case: Case) -> Callable[[], Any]:
        problem = case.problem
        checks = ke.prm(problem, n=n, k=K, rng=case.seed).stats["checks"]
        space = Grid2DSamplingSpace(
            (0, SIDE), (0, SIDE), obs_rectangle=case.obstacles.tolist(), delta=0.0
        )
        free = SIDE * SIDE - case.obstacles[:, 2:].prod(axis=1).sum()
        radius = np.sqrt(2.0 * checks * free / np.pi) / n
        params = RoadmapParams(sample_count=n, gamma=float(radius / np.sqrt(np.log(n) / n)))
        query = ContinuousProblem(space, problem.start, GoalState(problem.goal))
        return lambda: plan_prm_star(query, params=params, rng=np.random.default_rng(case.seed))

    return contestant


def ompl(n: int) -> Contestant:
    """Its PRM, grown to as many nodes with the same number of neighbours, then asked for a path."""
    from ompl import base, geometric

    test = lru_cache(lambda seed: compiled_test(among_boxes(seed).problem))

    def contestant(case: Case) -> Callable[[], Any]:
        setup = Setup(case.problem, test(case.seed))
        planner = geometric.PRM(setup.information)
        planner.setMaxNearestNeighbors(K)
        planner.setProblemDefinition(setup.definition)
        planner.setup()
        full, solved = (
            setup.places.start(n),
            base.exactSolnPlannerTerminationCondition(setup.definition),
        )

        def run() -> Any:
            planner.growRoadmapPtc(full)
            planner.solve(solved)
            return setup, planner

        return run

    return contestant


def judge(n: int, case: Case, answers: dict[str, Any]) -> None:
    """kinoedu's and the ruler's roadmaps are the same, edge by edge; everyone's path is free, and
    about as long.
    """
    ours, problem = answers["kinoedu"], case.problem
    if "C ruler" in answers:
        theirs = answers["C ruler"]
        assert np.array_equal(theirs.nodes, ours.roadmap.nodes) and np.array_equal(
            theirs.edges, ours.roadmap.edges
        )
        assert np.isclose(theirs.cost, ours.cost, rtol=1e-12)
    paths = {}
    if "pathplanning" in answers:
        paths["pathplanning"] = answers["pathplanning"].path
    if "OMPL" in answers:
        setup, planner = answers["OMPL"]
        states = setup.definition.getSolutionPath().getStates()
        paths["OMPL"] = np.array([(q[0], q[1]) for q in states])
        assert planner.milestoneCount() >= n
    for name, path in paths.items():
        assert all(problem.is_free_path(a, b) for a, b in zip(path[:-1], path[1:], strict=True)), (
            name
        )
        length = np.linalg.norm(np.diff(path, axis=0), axis=1).sum()
        assert 0.8 < length / ours.cost < 1.25, (name, length, ours.cost)


def main(repeats: int = 7) -> None:
    """Three worlds, each planned in seven times."""
    for n in (500, 2000):
        makers = {"kinoedu": kinoedu, "C ruler": ruler, "pathplanning": pathplanning, "OMPL": ompl}
        contestants = available({name: partial(make, n) for name, make in makers.items()})
        seconds = measure(
            contestants, map(among_boxes, range(3)), partial(judge, n), repeats=repeats
        )
        report(f"PRM, {n:,} nodes, k = {K}, among 24 boxes", seconds, GOALS)


if __name__ == "__main__":
    run(main)
