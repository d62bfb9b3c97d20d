"""A roadmap whose motions a car can drive: each place to go is driven to from its K nearest nodes,
and A* searches what grew.

After S. M. LaValle, J. J. Kuffner, "Randomized kinodynamic planning" (2001) and L. E. Kavraki et
al. (1996). What was driven one way cannot be driven the other way by the same control: the edges
are directed. Each ends in a new node, since random controls never meet an old one; so routes to one
pose are unique, and alternatives end at other poses near the goal.
"""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from ...compiled import algorithm
from ...geometry.checks import as_generator
from ...graphs import astar, flat_graph
from ...problems import MOTIONS, Plan
from ...robots.trajectory import DrivenRoadmap, DrivenTree
from ..roadmaps.prm import distances_to
from ..tuning import whole
from .common import (
    Bias,
    DrivenGrowth,
    Drives,
    Near,
    add_drive,
    bias_of,
    driven,
    drives_of,
    free_drive,
    grown_tree,
    is_near,
    near_of,
    new_growth,
    next_place,
    plan_driven,
    trajectory_to,
)


@algorithm
def drive_from_nearest(
    problem: Any,
    growth: DrivenGrowth,
    k: int,
    bias: Bias,
    drives: Drives,
    iterations: int,
    rng: np.random.Generator,
) -> None:
    """Grow the roadmap: each iteration drives from the k nodes nearest to a place, as they were
    when it was drawn.
    """
    tree = growth.tree
    for turn in range(1, iterations + 1):
        q_rand = next_place(problem, bias, turn, rng)
        apart = np.empty(tree.size[0])
        for node in range(len(apart)):
            apart[node] = problem.distance(tree.nodes[node], q_rand)
        for q_near in np.argsort(apart, kind="mergesort")[:k]:
            v, phi, t = free_drive(problem, tree.nodes[q_near], q_rand, drives, rng)
            if t > 0.0:
                add_drive(problem, growth, q_near, v, phi, t)


def kinodynamic_prm(
    problem: Any,
    *,
    k: int = 2,
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
    iterations: int = 350,
    rng: int | np.random.Generator,
) -> Plan:
    """Drive towards many places, each from its K nearest nodes; then take the shortest drive to a
    node near the goal.

    Parameters
    ----------
    k : K, from how many nodes each place is driven to.
    iterations : how many places are drawn; there is no stopping at the first that reaches the goal.

    The others are those of `kinodynamic_rrt`. Returns a Plan with its `roadmap`, whose edges are
    directed, and its `trajectory`; see `alternative_routes` for others. Without a path the
    trajectory leads to the node nearest to the goal. O(n^2) distances for n nodes. Raises
    InvalidParameter.

    >>> from kinoedu import Car, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], [[(9, 0), (11, 0), (11, 10), (9, 10)]])
    >>> plan = kinodynamic_prm(Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0)), iterations=3000, rng=0)
    >>> bool(plan.cost > 20), plan.roadmap.edges.shape == (len(plan.roadmap.nodes) - 1, 2)
    (True, True)
    """
    asked, nearest = driven(problem, "kinodynamic_prm", turn_weight), whole(k, "k", least=1)
    bias = bias_of(asked, goal_every, region_every, region, region_turn)
    drives, near = (
        drives_of(asked, trials, duration, step, batches),
        near_of(asked, tolerance, turn_tolerance),
    )
    turns = whole(iterations, "iterations", least=0)
    growth, before = new_growth(asked, turns * nearest + 1), int(asked.asked[MOTIONS])
    drive_from_nearest(asked, growth, nearest, bias, drives, turns, as_generator(rng))
    tree = grown_tree(growth)
    stats = {
        "nodes": len(tree.nodes),
        "iterations": turns,
        "checks": int(asked.asked[MOTIONS]) - before,
    }
    return replace(searched(asked, tree, near, stats), problem=problem)


def searched(problem: Any, tree: DrivenTree, near: Near, stats: dict[str, int]) -> Plan:
    """The plan along the shortest drive to a node near the goal; where there is none, to the node
    nearest to it.
    """
    edges = np.stack([tree.parent, np.arange(len(tree.nodes))], axis=1)[1:]
    goals = np.flatnonzero([is_near(q, problem.goal, near) for q in tree.nodes])
    roadmap = DrivenRoadmap(tree.nodes, edges, tree.controls[1:], tree.durations[1:], goals)
    apart = distances_to(problem, tree.nodes, problem.goal)
    ends = goals if len(goals) else np.array([apart.argmin()])
    lengths = np.abs(roadmap.controls[:, 0] * roadmap.durations)
    at_goal = len(tree.nodes)  # one more node, to which every end leads at no cost
    graph = flat_graph(
        at_goal + 1,
        np.concatenate([edges, np.stack([ends, np.full(len(ends), at_goal)], axis=1)]),
        np.concatenate([lengths, np.zeros(len(ends))]),
        directed=True,
    )
    left = np.hypot(*(tree.nodes[:, :2] - problem.goal[:2]).T)
    estimate = np.append(np.maximum(left - left[ends].max(), 0.0), 0.0)
    numbers, _ = astar(graph, 0, at_goal, estimate)
    assert numbers is not None  # every node hangs on the start
    trajectory = trajectory_to(problem, tree, numbers[:-1])
    return plan_driven(
        problem,
        trajectory,
        bool(len(goals)),
        planner="kinodynamic PRM",
        roadmap=roadmap,
        stats=stats,
    )
