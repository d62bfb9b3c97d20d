"""Planners with one mistake each, and the promise that each breaks: a bank for check_planner."""

import random
import sys
import time

import numpy as np

import kinoedu as ke

GOOD = {"max_nodes": 400, "max_iterations": 800}


def good(problem, rng):
    """The planner without a mistake."""
    return ke.rrt(problem, **GOOD, rng=rng)


def good_path(problem, rng):
    """Its path, or None."""
    return good(problem, rng).path


def straight(problem):
    """It never asks."""
    return [problem.start, problem.goal]


def samples_of(a, b, step):
    """Configurations along a motion."""
    n = int(np.ceil(np.linalg.norm(b - a) / step)) + 1
    return a + np.linspace(0.0, 1.0, n)[:, None] * (b - a)


class Asked:
    """A problem whose motions are checked in another way."""

    def __init__(self, problem, is_free_path):
        self.start, self.goal = problem.start, problem.goal
        self.sample, self.distance = problem.sample, problem.distance
        self.steer, self.is_free_path = problem.steer, is_free_path


def at_points_only(problem, rng):
    """It checks the ends of a motion alone."""
    asked = Asked(problem, lambda a, b: problem.is_free(a) and problem.is_free(b))
    return ke.rrt(asked, **GOOD, step_size=2.5, rng=rng)


def at_a_resolution(problem, rng):
    """It checks every tenth of a unit, and a thin wall is thinner."""

    def is_free(a, b):
        return all(problem.is_free(q) for q in samples_of(a, b, 0.1))

    return ke.rrt(Asked(problem, is_free), **GOOD, step_size=1.0, rng=rng)


def as_a_point(problem, rng):
    """It forgets the size of the robot."""
    asked = problem._replace(robot=ke.Point())
    return ke.rrt(asked, **GOOD, rng=rng)


def without_clearance(problem, rng):
    """It forgets the clearance."""
    return ke.rrt(problem._replace(clearance=0.0), **GOOD, rng=rng)


def without_the_start(problem, rng):
    """Its path begins after the first motion."""
    path = good_path(problem, rng)
    return None if path is None else path[1:] if len(path) > 1 else path


def without_the_goal(problem, rng):
    """Its path ends before the last motion."""
    path = good_path(problem, rng)
    return None if path is None else path[:-1]


def near_the_goal(problem, rng):
    """Its path ends a little before the goal."""
    path = good_path(problem, rng)
    return None if path is None else [*path[:-1], path[-1] - 1e-3]


def backwards(problem, rng):
    """From the goal to the start, as parents are followed."""
    path = good_path(problem, rng)
    return None if path is None else path[::-1]


def last_motion_unchecked(problem, rng):
    """It joins the goal to the nearest node without a question."""
    plan = ke.rrt(problem, max_nodes=60, goal_bias=0.0, rng=rng)
    if plan.path is not None:
        return plan.path
    path = [int(np.argmin([problem.distance(q, problem.goal) for q in plan.tree.nodes]))]
    while plan.tree.parent[path[-1]] >= 0:
        path.append(int(plan.tree.parent[path[-1]]))
    return [*plan.tree.nodes[path[::-1]], problem.goal]


def shortcut_unchecked(problem, rng):
    """It leaves out every second point."""
    path = good_path(problem, rng)
    return None if path is None else [*path[:-1:4], path[-1]]


def from_the_clock(problem):
    """Its seed is another one each time."""
    return ke.rrt(problem, **GOOD, rng=time.perf_counter_ns())


def from_global_numbers(problem):
    """It draws from numpy's global generator."""
    return ke.rrt(problem, **GOOD, rng=np.random.randint(1 << 30))


def from_pythons_numbers(problem):
    """It draws from Python's global generator."""
    return ke.rrt(problem, **GOOD, rng=random.randrange(1 << 30))


def seeds_global_numbers(problem):
    """It sets numpy's global seed, for everybody."""
    np.random.seed(0)
    return ke.rrt(problem, **GOOD, rng=0)


MEMORY = {}


def remembers(problem, rng):
    """It keeps paths by their start and goal, whatever lies between."""
    key = problem.start.tobytes() + problem.goal.tobytes()
    if key not in MEMORY:
        MEMORY[key] = good_path(problem, rng)
    return MEMORY[key]


CALLS = []


def learns(problem):
    """Its result depends on how often it was called."""
    CALLS.append(1)
    return ke.rrt(problem, **GOOD, rng=len(CALLS))


def moves_the_goal(problem, rng):
    """It changes the problem."""
    plan = good(problem, rng)
    problem.goal[:] = problem.start
    return plan


def moves_obstacles(problem):
    """It takes the obstacles away."""
    if hasattr(problem.world, "obstacles"):
        problem.world.obstacles.points[:] = -100.0
    return [problem.start, problem.goal]


def endless(problem, rng):
    """It stops only at a path."""
    while True:
        plan = ke.rrt(problem, max_nodes=100, rng=rng)
        if plan.path is not None:
            return plan


def raises_without_a_path(problem, rng):
    """No path is an exception."""
    plan = good(problem, rng)
    if plan.path is None:
        raise RuntimeError("no path found")
    return plan


def divides_by_the_distance(problem, rng):
    """A start at the goal is a division by zero."""
    1.0 / float(problem.distance(problem.start, problem.goal))
    return good(problem, rng)


def exits(problem, rng):
    """It ends Python without a path."""
    plan = good(problem, rng)
    return sys.exit(1) if plan.path is None else plan


def recurses(problem):
    """It calls itself for ever."""
    return recurses(problem)


def empty_list(problem, rng):
    """No path is an empty list."""
    path = good_path(problem, rng)
    return [] if path is None else path


def false(problem, rng):
    """No path is False."""
    path = good_path(problem, rng)
    return False if path is None else path


def with_headings(problem, rng):
    """A third number for each point."""
    path = good_path(problem, rng)
    return None if path is None else [(*q, 0.0) for q in path]


def transposed(problem, rng):
    """Rows for columns."""
    path = good_path(problem, rng)
    return None if path is None else np.vstack([path, path[-1:]]).T


def with_nan(problem, rng):
    """A point that is no number."""
    path = good_path(problem, rng)
    return None if path is None else [path[0], (np.nan, np.nan), *path[1:]]


def flatters_itself(problem, rng):
    """Its cost is that of the straight line."""
    plan = good(problem, rng)
    far = problem.distance(problem.start, problem.goal)
    return ke.Plan(plan.path, far if plan.path is not None else np.inf)


def never(problem):
    """It finds nothing."""
    return


def needs_a_detour(problem, rng):
    """A tree without the motion from its root: nothing for a start at the goal."""
    if problem.distance(problem.start, problem.goal) == 0.0:
        return None
    return good(problem, rng)


def inside_its_own_box(problem, rng):
    """It knows the obstacles, and takes the box of the world for its boundary."""
    world = problem.world
    if not hasattr(world, "edges"):
        return good(problem, rng)
    (x0, y0), (x1, y1) = world.lo, world.hi
    solids = ke.worlds.polygon_world.rings_of(world)[1:]
    obstacles = [(ring, rooms) if rooms else ring for ring, *rooms in solids]
    box = ke.PolygonWorld([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], obstacles)
    return ke.rrt(problem._replace(world=box), **GOOD, rng=rng)


BANK = {
    straight: "free",
    at_points_only: "free",
    at_a_resolution: "free",
    as_a_point: "free",
    without_clearance: "free",
    without_the_start: "ends",
    without_the_goal: "ends",
    near_the_goal: "ends",
    backwards: "ends",
    last_motion_unchecked: "free",
    shortcut_unchecked: "free",
    from_the_clock: "same",
    from_global_numbers: "random",
    from_pythons_numbers: "random",
    seeds_global_numbers: "random",
    remembers: "free",
    learns: "same",
    moves_the_goal: "problem",
    moves_obstacles: "problem",
    endless: "time",
    raises_without_a_path: "errors",
    divides_by_the_distance: "errors",
    exits: "errors",
    recurses: "errors",
    empty_list: "answer",
    false: "answer",
    with_headings: "answer",
    transposed: "answer",
    with_nan: "answer",
    flatters_itself: "cost",
    never: "finds",
    needs_a_detour: "finds",
    inside_its_own_box: "free",
}
