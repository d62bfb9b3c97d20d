"""Compile the functions of the course ahead, in separate processes."""

import os
from collections.abc import Iterator
from functools import partial
from itertools import chain
from typing import Any

from .collision import free_configurations, free_motions
from .compiled import HAS_COMPILER, requests
from .compiled.store import AWAITED, WANTED, Request, folder
from .compiled.tiers import TIERED
from .curves import dubins_path, reeds_shepp_path
from .graphs import Graph, astar, bfs, dfs, dijkstra
from .planners import (
    Radius,
    bug2,
    cells_with_headings,
    kinodynamic_rrt,
    plan_by_decomposition,
    plan_in_time,
    plan_on_grid,
    prm,
    roadmap_properties,
    rrt,
    rrt_connect,
    rrt_star,
    shortcut,
)
from .planners.grids.grid import grid_for, octile
from .planners.registry import ARM, CAR, DISK, PLANNERS, POINT, TRANSLATING, TURNING
from .problems import Problem, ProblemRecord
from .problems.in_time import TimedProblem
from .robots import Car, Disk, Point, RigidPolygon, TranslatingPolygon, TwoLinkArm
from .robots.kinds import Robot
from .support.progress import show_progress
from .worlds import Moving, MovingWorld, PolygonWorld, Terrain
from .worlds.checks import World
from .worlds.terrain import TerrainRecord

Job = tuple[Any, ...]  # a name, a function, and its arguments

ROOM = [(0, 0), (9, 0), (9, 9), (0, 9)]
BEAM = [(-0.5, -0.2), (0.5, -0.2), (0.5, 0.2), (-0.5, 0.2)]


def warm_up() -> list[str]:
    """Compile what the tour and the first lessons use: planners, bugs, and searches on a graph.

    Functions that are compiled already are skipped. Without a cache nothing is done.

    Returns
    -------
    list
        The functions that could not be compiled; they stay interpreted.
    """
    return compile_all(AWAITED, first_jobs(), workers=os.cpu_count() or 1)


def warm_all() -> list[str]:
    """Compile what all lessons use; returns the functions that could not be compiled."""
    return compile_all(AWAITED, chain(first_jobs(), later_jobs()), workers=os.cpu_count() or 1)


def warm_behind() -> list[str]:
    """Compile what all lessons use, the first lessons first, at low priority.

    Returns the functions that could not be compiled.
    """
    workers = max(1, (os.cpu_count() or 1) - 1)
    first = compile_all(WANTED, first_jobs(), workers=workers)
    return first + compile_all(WANTED, later_jobs(), workers=workers)


def compile_all(queue: str, jobs: Iterator[Job], *, workers: int) -> list[str]:
    """Run all jobs interpreted to record the algorithms and types they call; compile those.

    Returns the functions that could not be compiled.
    """
    place = folder()
    if place is None or not HAS_COMPILER:
        return []
    for _, job, *given in jobs:
        job(*given)
    with show_progress("compiling once") as report_progress:
        left = requests.compile_all(
            place,
            queue,
            requests_of_called_algorithms(),
            workers=workers,
            report_progress=report_progress,
        )
    return sorted({f"{request.module}.{request.function}" for request in left})


def requests_of_called_algorithms() -> list[Request]:
    """Requests for all algorithms that this process has called and that can be compiled."""
    kinds_of_calls = [s for f in TIERED if f.is_algorithm for s in f.specializations.values()]
    return [s.to_compile for s in kinds_of_calls if not s.is_never_stored]


def first_jobs() -> Iterator[Job]:
    """Point robots, bugs and graphs."""
    round_and_not = PolygonWorld(
        [*ROOM[:3], (5, 8), ROOM[3]], [[(4, 0), (5, 0), (5, 5)], ((7, 5), 1.0)]
    )
    worlds: dict[str, World] = {"polygons": round_and_not, "a terrain": Terrain([[1] * 9] * 9)}
    for kind, world in worlds.items():
        task = Problem(Point(), world, (1, 1), (8, 8))
        for planner in PLANNERS.values():
            if planner.board is not None:
                yield f"{planner.name} on {kind}", planner.quick_plan, task
    yield (
        "A* of a disk on a terrain",
        plan_on_grid,
        Problem(Disk(0.4), Terrain([[1] * 9] * 9), (1, 1), (8, 8)),
    )
    yield "cells", plan_by_decomposition, room(Point(), (1, 1), (8, 8))
    yield "bugs", bug2, (1, 1), (8, 8), [[(4, 2), (5, 2), (5, 6)], [(1, 8), (2, 8), (2, 9)]], 1.0
    yield "searches on graphs", search_a_graph


def search_a_graph() -> None:
    """Run every search, and the queries of a graph."""
    graph = Graph(nodes=[(0, 0), (1, 0)], edges=[(0, 1)])
    for search in (bfs, dfs, dijkstra):
        search(graph, 0)
    graph.components()
    graph.closest((1, 1))


def later_jobs() -> Iterator[Job]:
    """Other planners for a point, all sampling planners for other robots, the car's own."""
    problem = room(Point(), (1, 1), (8, 8))
    tasks: dict[str, ProblemRecord] = {
        POINT: problem,
        DISK: room(Disk(0.3), (1, 1), (8, 8)),
        TRANSLATING: room(TranslatingPolygon(BEAM), (1, 1), (8, 8)),
        TURNING: room(RigidPolygon(BEAM), (1, 1, 0), (8, 8, 1)),
        ARM: room(TwoLinkArm(1.0, 0.8, 0.1, base=(2, 6)), (1.5, 0), (2.5, 0.5)),
        CAR: room(Car(1.0, 0.5, 0.6), (1, 1, 0), (8, 8, 1)),
    }
    for planner in PLANNERS.values():
        for robot in planner.robots:
            yield f"{planner.name} of a {robot}", planner.quick_plan, tasks[robot]
    for robot, task in tasks.items():
        yield f"shortcuts of a {robot}", shorten, task
    for robot in (POINT, TRANSLATING, TURNING):
        yield f"many configurations and motions of a {robot}", judge_many, tasks[robot]
    yield (
        "a terrain with costs",
        plan_on_priced_terrain,
        Terrain([[1] * 9] * 9, cost=[[2.0] * 9] * 9),
    )
    bare = Problem(Point(), Terrain([[1] * 9] * 9), (1, 1), (8, 8))
    yield "cells of a terrain, one by one", search_cells, bare
    yield "a tree with spacing on a terrain", partial(rrt, spacing=0.5, max_nodes=50, rng=0), bare
    yield "how well a roadmap serves", survey, problem
    yield (
        "cells with headings",
        partial(cells_with_headings, neighbours=Radius(7.0)),
        tasks[TURNING],
    )
    yield "obstacles that move", plan_among_movers
    yield "a car's ride", ride, tasks[CAR]
    for curve in (dubins_path, reeds_shepp_path):
        yield curve.__name__, curve, (0, 0, 0), (3, 2, 1), 1.0


def judge_many(problem: ProblemRecord) -> None:
    """Judge two configurations and a motion."""
    free_configurations(problem.robot, problem.world, [problem.start, problem.goal])
    free_motions(problem.robot, problem.world, [problem.start], [problem.goal])


def plan_on_priced_terrain(terrain: TerrainRecord) -> None:
    """Run the planners that use the costs of a terrain."""
    problem = Problem(Point(), terrain, (1, 1), (8, 8))
    plan_on_grid(problem)
    prm(problem, n=20, rng=0)
    rrt_star(problem, max_nodes=200, rng=0)


def survey(problem: ProblemRecord) -> None:
    """Measure a roadmap's four properties."""
    roadmap_properties(problem, prm(problem, n=20, rng=0).roadmap, rng=0)


def search_cells(problem: ProblemRecord) -> None:
    """Search the cells of a terrain without jump points, with an estimate and without."""
    grid = grid_for(problem, None)
    first, last = grid.columns + 1, grid.size - grid.columns - 2
    astar(grid, first, last)
    astar(grid, first, last, octile(grid, last))


def plan_among_movers() -> None:
    """Plan for a disk with another disk that crosses its path."""
    world = MovingWorld(PolygonWorld(ROOM), [Moving(0.5, times=[0, 10], places=[(5, 1), (5, 8)])])
    problem = TimedProblem(Disk(0.4), world, (1, 1), (8, 8), speed=1.0)
    plan_in_time(problem, n=20, rng=0)


def shorten(problem: ProblemRecord) -> None:
    """Make a path shorter."""
    shortcut(rrt_connect(problem, rng=0, max_nodes=500), tries=5, rng=0)


def ride(problem: ProblemRecord) -> None:
    """Find where a car is at some times of a drive, as the pictures of drives do."""
    plan = kinodynamic_rrt(problem, max_iterations=5, rng=0)
    assert plan.trajectory is not None
    plan.trajectory.at([0.0, 1.0])


def room(robot: Robot, start: tuple[float, ...], goal: tuple[float, ...]) -> ProblemRecord:
    """A problem in a room with a wedge."""
    return Problem(robot, PolygonWorld(ROOM, [[(4, 0), (5, 0), (5, 5)]]), start, goal)
