"""A roadmap that a car can drive: drives from the K nodes nearest to each target, and A*.

The edges are directed, because a control that leads one way does not lead back. Each edge ends in a
new node, because random controls never meet an old one. So the route to each pose is unique, and
alternative routes end at other poses near the goal.

After S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning" (2001) and L. E. Kavraki et
al. (1996).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...compiled import algorithm
from ...geometry.checks import as_generator
from ...graphs import astar, flat_graph
from ...problems import Plan, ProblemRecord, Recorder
from ...problems.protocols import CarProblem
from ...robots.trajectory import DrivenRoadmap, DrivenTree
from ..problem_input import count_checks
from ..roadmaps.prm import distances_to
from ..tuning import integer
from .common import (
    DrivenGrowth,
    add_drive,
    as_car_problem,
    begin_tree,
    copy_tree,
    free_drive,
    is_near,
    next_target,
    plan_from_trajectory,
    trajectory_to,
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
def drive_from_nearest(
    problem: CarProblem,
    growth: DrivenGrowth,
    k: int,
    bias: GoalBiasRecord,
    drives: DrivesRecord,
    n: int,
    rng: np.random.Generator,
) -> None:
    """Grow the roadmap by drives from the k nodes nearest to each of n targets.

    The k nodes are chosen when the target is drawn, so nodes made for it do not count.
    """
    tree = growth.tree
    for iteration in range(1, n + 1):
        q_rand = next_target(problem, bias, iteration, rng)
        apart = np.empty(tree.size[0])
        for node in range(len(apart)):
            apart[node] = problem.distance(tree.nodes[node], q_rand)
        for q_near in np.argsort(apart, kind="mergesort")[:k]:
            v, phi, t = free_drive(problem, tree.nodes[q_near], q_rand, drives, rng)
            if t > 0.0:
                add_drive(problem, growth, q_near, v, phi, t)


def kinodynamic_prm(
    problem: ProblemRecord | Recorder,
    *,
    n: int = 350,
    k: int = 2,
    drives: Drives = Drives(),
    goal_bias: GoalBias = GoalBias(),
    goal_region: GoalRegion = GoalRegion(),
    turn_weight: float | None = None,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan by drives towards random targets, each from its K nearest nodes, and A*.

    O(K n^2) distances.

    Parameters
    ----------
    n : how many targets are drawn; the planner does not stop at the first path.
    k : K, how many nodes try to drive towards each target.

    The other parameters are those of `kinodynamic_rrt`.

    Returns
    -------
    Plan with its `roadmap`, whose edges are directed, and its `trajectory`, the shortest drive to a
    node near the goal. Without a path the trajectory leads to the node nearest to the goal. See
    `alternative_routes` for other drives.

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
    >>> plan = kinodynamic_prm(problem, n=3000, rng=0)
    >>> bool(plan.cost > 20), plan.roadmap.edges.shape == (len(plan.roadmap.nodes) - 1, 2)
    (True, True)
    """
    car_problem = as_car_problem(problem, "kinodynamic_prm", turn_weight)
    bias, tried = as_goal_bias(car_problem, goal_bias), as_drives(car_problem, drives)
    near = as_goal_region(car_problem, goal_region)
    nearest, targets = integer(k, "k", least=1), integer(n, "n", least=0)
    growth, before = begin_tree(car_problem, targets * nearest + 1), count_checks(car_problem)
    drive_from_nearest(car_problem, growth, nearest, bias, tried, targets, as_generator(rng))
    tree = copy_tree(growth)
    stats = {
        "nodes": len(tree.nodes),
        "iterations": targets,
        "checks": count_checks(car_problem) - before,
    }
    return replace(find_shortest_drive(car_problem, tree, near, stats), problem=problem)


def find_shortest_drive(
    problem: CarProblem, tree: DrivenTree, near: GoalRegionRecord, stats: dict[str, int]
) -> Plan:
    """The plan along the shortest drive to a node near the goal, or else to the nearest node."""
    edges = np.stack([tree.parent, np.arange(len(tree.nodes))], axis=1)[1:]
    goals = np.flatnonzero([is_near(q, problem.goal, near) for q in tree.nodes])
    roadmap = DrivenRoadmap(tree.nodes, edges, tree.controls[1:], tree.durations[1:], goals)
    apart = distances_to(problem, tree.nodes, problem.goal)
    ends = goals if len(goals) else np.array([apart.argmin()])
    lengths = np.abs(roadmap.controls[:, 0] * roadmap.durations)
    at_goal = len(tree.nodes)  # one more node, to which each end has an edge of weight zero
    graph = flat_graph(
        at_goal + 1,
        np.concatenate([edges, np.stack([ends, np.full(len(ends), at_goal)], axis=1)]),
        np.concatenate([lengths, np.zeros(len(ends))]),
        directed=True,
    )
    left = np.hypot(*(tree.nodes[:, :2] - problem.goal[:2]).T)
    heuristic = np.append(np.maximum(left - left[ends].max(), 0.0), 0.0)
    numbers, _ = astar(graph, 0, at_goal, heuristic)
    assert numbers is not None  # every node can be reached from the start
    trajectory = trajectory_to(problem, tree, numbers[:-1])
    return plan_from_trajectory(
        problem,
        trajectory,
        bool(len(goals)),
        planner="kinodynamic PRM",
        roadmap=roadmap,
        stats=stats,
    )
