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

import math
from typing import Any

import numpy as np

from ...compiled import algorithm
from ...geometry.checks import as_generator
from ...graphs import extract_path
from ...problems import Plan
from ..problem_input import count_checks
from ..tuning import integer
from .common import (
    Bias,
    DrivenGrowth,
    Drives,
    GoalRegion,
    add_drive,
    as_bias,
    as_car_problem,
    as_drives,
    as_goal_region,
    begin_tree,
    copy_tree,
    free_drive,
    is_near,
    next_target,
    plan_from_trajectory,
    trajectory_to,
)


@algorithm
def grow_by_driving(
    problem: Any,
    growth: DrivenGrowth,
    bias: Bias,
    drives: Drives,
    near: GoalRegion,
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
    problem: Any,
    *,
    goal_every: int = 4,
    region_every: int = 7,
    region: float | None = None,
    region_turn: float = math.radians(90.0),
    trials: int = 20,
    duration: float | None = None,
    step: float | None = None,
    batches: int = 4,
    turn_weight: float | None = None,
    tolerance: float | None = None,
    turn_tolerance: float = math.radians(15.0),
    max_iterations: int = 1000,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan by a tree of drives: the nearest node tries random controls, and keeps the best one.

    Every drive is free along its whole length. O(n) iterations of M drives each, for n nodes.

    Parameters
    ----------
    problem : a Problem of a Car, or a Recorder of one.
    goal_every, region_every : every so many iterations the target is the goal, or is drawn from a
        region round it; 0 for never.
    region, region_turn : the radius of that region, by default 2.5 wheelbases, and how far its
        headings may be from the goal's, in radians.
    trials : M, how many controls are tried, each a speed of the car and a steering angle.
    duration, step : delta t, for how long each control is simulated, and the time step. The best
        drive ends at the step that is closest to the target. By default a drive at top speed covers
        0.75 wheelbases, in 150 steps.
    batches : how many times M controls are drawn while the best drive is not free.
    turn_weight : how many units of length a radian counts for in distances; by default a quarter of
        the wheelbase.
    tolerance, turn_tolerance : what counts as the goal; by default a quarter of a wheelbase, and 15
        degrees in radians.
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
    bias = as_bias(car_problem, goal_every, region_every, region, region_turn)
    drives = as_drives(car_problem, trials, duration, step, batches)
    near = as_goal_region(car_problem, tolerance, turn_tolerance)
    limit = integer(max_iterations, "max_iterations", least=0)
    growth, before = begin_tree(car_problem, limit + 1), count_checks(car_problem)
    at_goal, iterations = grow_by_driving(
        car_problem, growth, bias, drives, near, limit, as_generator(rng)
    )
    tree = copy_tree(growth)
    last = at_goal if at_goal >= 0 else int(car_problem.nearest(growth.tree, car_problem.goal))
    trajectory = trajectory_to(car_problem, tree, extract_path(tree.parent, last))
    stats = {
        "nodes": len(tree.nodes),
        "iterations": int(iterations),
        "checks": count_checks(car_problem) - before,
    }
    return plan_from_trajectory(
        problem, trajectory, at_goal >= 0, planner="kinodynamic RRT", tree=tree, stats=stats
    )
