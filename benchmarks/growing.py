"""Problems of any size whose times are to grow: each is made for an n, worked, and its answer
judged.
"""

import atexit
import time
from collections.abc import Callable
from ctypes import c_double, c_int64
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import shapely
from grading import HOUSE, NAME, SECRET, processor
from grid import graph_of
from ruler import compile_c, pointer
from scipy.sparse.csgraph import dijkstra
from timing import Missing
from trapezoids import stars
from worlds import SIDE, SQUARE, among_boxes, among_polygons, bitmap

import kinoedu as ke
from kinoedu.collision import free_motions
from kinoedu.grading.assignments.questions import read_assignment
from kinoedu.grading.judge.submission import grade
from kinoedu.grading.sandbox.sandbox import Sandbox, explain_no_sandbox
from kinoedu.planners.roadmaps.neighbours import k_closest

K, STEP, PAIRS, PROVED = 10, 5.0, 3000, 2**18


class Task(NamedTuple):
    """A problem: its true size, the work that is timed, and the judge of its answer, which is
    not.
    """

    n: int
    work: Callable[[], Any]
    judge: Callable[[Any], None]


class Growth(NamedTuple):
    """What n counts and begins with, the exponent that is expected, the problem for an n, and what
    measures the processor's time.
    """

    unit: str
    first: int
    expected: str
    make_task: Callable[[int], Task]
    clock: Callable[[], float] = time.process_time


def neighbours(n: int) -> Task:
    """The closest of each point; for some points, all distances are looked through."""
    problem, rng = among_boxes(0).problem, np.random.default_rng(0)
    points = rng.uniform(0, SIDE, (n, 2))

    def judge(near: np.ndarray) -> None:
        for i in rng.integers(0, n, 20):
            apart = np.linalg.norm(points - points[i], axis=1)
            apart[i] = np.inf
            assert near.shape == (n, K) and np.array_equal(apart[near[i]], np.sort(apart)[:K])

    return Task(n, lambda: k_closest(problem, points, K), judge)


def rrt(n: int) -> Task:
    """A tree whose goal cannot be reached; every motion in it is free and no longer than a step."""
    problem = among_polygons(0).problem

    def judge(plan: Any) -> None:
        nodes, parent = plan.tree.nodes, plan.tree.parent
        a, b = nodes[parent[1:]], nodes[1:]
        assert len(nodes) == n and np.linalg.norm(b - a, axis=1).max() <= STEP * (1 + 1e-9)
        assert free_motions(problem.robot, problem.world, a, b).all()

    return Task(n, lambda: ke.rrt(problem, step_size=STEP, max_nodes=n, rng=0), judge)


def random_reads(n: int) -> Task:
    """For each node four queries of two reads each in C: a bucket of 64 bytes, and its node."""
    library = compile_c("random_reads")
    library.read_at_random.restype = c_double
    rng, nodes = np.random.default_rng(0), np.random.default_rng(1).random((n, 2))
    buckets = np.repeat(rng.permutation(n), 8)  # each as long as a line of a cache
    arrays, sizes = (pointer(buckets), pointer(nodes)), (c_int64(n), c_int64(4 * n))

    def judge(total: float) -> None:
        assert abs(total / (4 * n) - nodes[:, 0].mean()) < 0.05

    return Task(n, lambda: library.read_at_random(*arrays, *sizes), judge)


def prm(n: int) -> Task:
    """A roadmap; every edge is free."""
    problem = among_boxes(0).problem

    def judge(plan: Any) -> None:
        nodes, edges = plan.roadmap.nodes, plan.roadmap.edges
        assert len(nodes) == n + 2 and plan.path is not None
        assert free_motions(
            problem.robot, problem.world, nodes[edges[:, 0]], nodes[edges[:, 1]]
        ).all()

    return Task(n, lambda: ke.prm(problem, n=n, k=K, rng=0), judge)


def visibility(n: int) -> Task:
    """All pairs of corners in sight; shapely says of some pairs whether an obstacle's inside is
    between them.
    """
    polygons, _ = stars(n // 6, 0)
    world, solid = (
        ke.PolygonWorld(SQUARE, polygons),
        shapely.MultiPolygon([shapely.Polygon(polygon) for polygon in polygons]),
    )
    shapely.prepare(solid)

    def judge(roadmap: Any) -> None:
        nodes, rng = roadmap.nodes, np.random.default_rng(0)
        joined = set(map(tuple, np.sort(roadmap.edges, axis=1).tolist()))
        pairs = np.sort(
            np.vstack(
                [rng.integers(0, len(nodes), (PAIRS, 2)), rng.permutation(roadmap.edges)[:PAIRS]]
            ),
            axis=1,
        )
        pairs = pairs[pairs[:, 0] != pairs[:, 1]]
        hidden = shapely.relate_pattern(shapely.linestrings(nodes[pairs]), solid, "T********")
        assert np.array_equal([tuple(pair) in joined for pair in pairs.tolist()], ~hidden)

    return Task(len(world.edges) - 4, lambda: ke.visibility_roadmap(world), judge)


def trapezoids(n: int) -> Task:
    """Cells, which together are as large as the square without its polygons."""
    polygons, _ = stars(n // 6, 0)
    world = ke.PolygonWorld(SQUARE, polygons)
    free = SIDE * SIDE - sum(shapely.Polygon(polygon).area for polygon in polygons)

    def judge(cells: Any) -> None:
        assert abs(cells.areas.sum() - free) <= 1e-9 * free

    return Task(len(world.edges), lambda: ke.trapezoidation(world), judge)


def astar(n: int) -> Task:
    """A path over a bitmap, of free cells one move apart; scipy's shortest is as long, where it
    need not be waited for too long.
    """
    side = round(n**0.5)
    free = bitmap(0, 0.25, side)
    problem = ke.Problem(ke.Point(), ke.Terrain(free), (0.5, 0.5), (side - 0.5, side - 0.5))

    def judge(plan: Any) -> None:
        cells = np.floor(plan.path).astype(int)
        moves = np.abs(np.diff(plan.path, axis=0))
        assert free[cells[:, 1], cells[:, 0]].all() and np.isclose(
            np.linalg.norm(moves, axis=1).sum(), plan.cost, rtol=1e-12
        )
        assert free_motions(problem.robot, problem.world, plan.path[:-1], plan.path[1:]).all()
        if n <= PROVED:
            assert np.isclose(dijkstra(graph_of(free), indices=0)[-1], plan.cost, rtol=1e-12)

    return Task(side * side, lambda: ke.plan_on_grid(problem), judge)


def grading(n: int) -> Task:
    """Submissions, right and empty by turns, one after another in one sandbox: full marks and
    none.
    """
    if reason := explain_no_sandbox():
        raise Missing(reason)
    task, box = read_assignment(NAME), sandbox()
    books = [(HOUSE / room / f"{NAME}.ipynb").read_bytes() for room in ("solutions", "exercises")]

    def judge(grades: Any) -> None:
        for i, one in enumerate(grades):
            questions = one["questions"]
            assert sum(q["score"] for q in questions) == (
                0 if i % 2 else sum(q["max_score"] for q in questions)
            )

    return Task(n, lambda: [grade(books[i % 2], task, SECRET, box) for i in range(n)], judge)


@cache
def sandbox() -> Sandbox:
    """One for all, closed in the end."""
    box = Sandbox()
    atexit.register(box.close)
    return box


GROWTHS = {
    "nearest neighbours": Growth("points", 2**10, "1", neighbours),
    "RRT": Growth("nodes", 2**10, "1 to 1.5", rrt),
    "RRT, a million nodes": Growth("nodes", 2**17, "1 to 1.5", rrt),  # four sizes, up to 2**20
    "random reads": Growth("nodes", 2**17, "1", random_reads),
    "PRM": Growth("nodes", 2**8, "1", prm),
    "visibility roadmap": Growth("corners", 6 * 2**3, "2, by log n", visibility),
    "trapezoidation": Growth("edges", 6 * 2**4, "1, by log n", trapezoids),
    "A*": Growth("cells", 2**12, "1, by log n", astar),
    "grading": Growth("submissions", 2, "1", grading, processor),
}
