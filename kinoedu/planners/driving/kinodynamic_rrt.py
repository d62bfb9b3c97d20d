"""Kinodynamic RRT: rapidly-exploring random trees whose motions a car can drive.

    KINODYNAMIC-RRT(q_start, q_goal)
     1  T := a tree with the root q_start
     2  repeat until a node of T is near q_goal:
     3      q_rand := a random target
     4      q_near := the node of T nearest to q_rand
     5      u := of M random controls the one that brings the car from q_near closest to q_rand
     6      if the drive is free: add to T the node that u leads to

S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning" (2001); LaValle, Planning
Algorithms, section 14.4.3.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...compiled import algorithm
from ...geometry.checks import as_generator
from ...problems import Plan, ProblemRecord, Recorder
from ...problems.protocols import CarProblem
from ..problem_input import count_checks
from ..tuning import integer
from .common import (
    DrivenGrowth,
    add_drive,
    as_car_problem,
    begin_tree,
    free_drive,
    is_near,
    next_target,
    plan_from_driven_tree,
)
from .parameters import (
    Drives,
    DrivesRecord,
    GoalBias,
    GoalBiasRecord,
    GoalRegion,
    GoalRegionRecord,
    as_drives,
    as_goal_bias,
    as_goal_region,
)


@algorithm
def grow_by_driving(
    problem: CarProblem,
    growth: DrivenGrowth,
    bias: GoalBiasRecord,
    drives: DrivesRecord,
    near: GoalRegionRecord,
    max_iterations: int,
    rng: np.random.Generator,
) -> tuple[int, int]:
    """Grow the tree until it is near the goal or has had its iterations.

    Returns
    -------
    The node near the goal, or -1, and the number of iterations.
    """
    tree, iteration = growth.tree, 0
    at_goal = 0 if is_near(problem.start, problem.goal, near) else -1
    while at_goal < 0 and iteration < max_iterations:
        iteration += 1
        q_rand = next_target(problem, bias, iteration, rng)
        q_near = problem.nearest(tree, q_rand)
        v, phi, t = free_drive(problem, tree.nodes[q_near], q_rand, drives, rng)
        if t > 0.0:
            q_new = add_drive(problem, growth, q_near, v, phi, t)
            if is_near(tree.nodes[q_new], problem.goal, near):
                at_goal = q_new
    return at_goal, iteration


def kinodynamic_rrt(
    problem: ProblemRecord | Recorder,
    *,
    drives: Drives = Drives(),
    goal_bias: GoalBias = GoalBias(),
    goal_region: GoalRegion = GoalRegion(),
    turn_weight: float | None = None,
    max_iterations: int = 1000,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan by a tree of drives: the nearest node tries random controls, and keeps the best one.

    Every drive is free along its whole length. O(n) iterations of M drives each, for n nodes.

    Parameters
    ----------
    problem : a Problem of a Car, or a Recorder of one.
    drives : how drives are tried, such as `Drives(trials=8, duration=0.5)`; by default M = 20
        controls, each for as long as a drive of 0.75 wheelbases takes at top speed.
    goal_bias : how often the target is the goal, or is drawn from a region round it; by default
        `GoalBias(goal_every=4, region_every=7)`.
    goal_region : which poses count as the goal; by default those at most a quarter of a wheelbase
        and 15 degrees away.
    turn_weight : how many units of length a radian counts for in distances; by default a quarter of
        the wheelbase.
    max_iterations : stop after this many iterations.
    rng : a seed or a numpy Generator.

    Returns
    -------
    Plan with its `tree` and its `trajectory`. Its controls lead along the path, which ends near the
    goal, not at it. Without a path the trajectory leads to the node nearest to the goal.

    Raises
    ------
    InvalidParameter
        Where the robot is not a car, or a parameter is out of its range.

    Examples
    --------
    >>> from kinoedu import Car, PolygonWorld, Problem
    >>> wall = [(9, 0), (11, 0), (11, 10), (9, 10)]
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], [wall])
    >>> problem = Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0))
    >>> plan = kinodynamic_rrt(problem, max_iterations=5000, rng=0)
    >>> bool(np.array_equal(plan.path, plan.trajectory.poses)), bool(plan.cost > 20)
    (True, True)
    """
    car_problem = as_car_problem(problem, "kinodynamic_rrt", turn_weight)
    bias, tried = as_goal_bias(car_problem, goal_bias), as_drives(car_problem, drives)
    near = as_goal_region(car_problem, goal_region)
    limit = integer(max_iterations, "max_iterations", least=0)
    growth, before = begin_tree(car_problem, limit + 1), count_checks(car_problem)
    at_goal, iterations = grow_by_driving(
        car_problem, growth, bias, tried, near, limit, as_generator(rng)
    )
    stats = {"iterations": int(iterations), "checks": count_checks(car_problem) - before}
    plan = plan_from_driven_tree(car_problem, growth, at_goal, "kinodynamic RRT", stats)
    return replace(plan, problem=problem)
