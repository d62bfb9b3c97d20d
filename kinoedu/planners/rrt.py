"""Rapidly-exploring random trees. LaValle, "Rapidly-exploring random trees: a new tool for path planning" (1998); LaValle,
Planning Algorithms, section 5.5; Bullo & Smith, section 4.5.
"""

from typing import Any

import numpy as np

from ..compiled import body, callable_from_compiled
from ..geometry.checks import as_generator
from ..problems import MOTIONS, Plan
from ..spaces.buckets import GrowingTree, add
from .answers import plan_from_tree
from .asking import askable, body_for, new_tree, world_size
from .tuning import positive, share, whole


@body
def grow(
    problem: Any, tree: GrowingTree, step: float, goal_bias: float, max_iterations: int, rng: np.random.Generator
) -> tuple[int, int]:
    """Grow the tree until it reaches the goal, is full, or has had its iterations; returns the goal's node, or -1, and how many."""
    at_goal = join_goal(problem, tree, add(tree, problem.start, -1), step)
    iteration = 0
    room = len(tree.nodes) - 1  # one more is kept for the goal
    while at_goal < 0 and iteration < max_iterations and tree.size[0] < room:
        iteration += 1
        q_rand = problem.goal if rng.random() < goal_bias else problem.sample(rng)
        near = problem.nearest(tree, q_rand)
        q_new = problem.steer(tree.nodes[near], q_rand, step)
        if problem.is_free_path(tree.nodes[near], q_new):
            at_goal = join_goal(problem, tree, add(tree, q_new, near), step)
    return at_goal, iteration


@callable_from_compiled
def join_goal(problem: Any, tree: GrowingTree, node: int, step: float) -> int:
    """Append the goal to a node within one free step of it; returns the goal's node, or -1."""
    if problem.distance(tree.nodes[node], problem.goal) > step:
        return -1
    if not problem.is_free_path(tree.nodes[node], problem.goal):
        return -1
    return add(tree, problem.goal, node)


def rrt(
    problem: Any,
    *,
    step: float | None = None,
    goal_bias: float = 0.05,
    max_nodes: int = 10_000,
    max_iterations: int | None = None,
    rng: int | np.random.Generator,
) -> Plan:
    """Grow a tree from the start, each time from its nearest node towards a random configuration, until it reaches the goal.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours that answers the same questions.
    step : delta, the longest edge; by default a twentieth of the world's diagonal.
    goal_bias : the share of samples that are the goal itself, from 0 to 1.
    max_nodes, max_iterations : where to give up; by default ten iterations for each node.
    rng : a seed or a numpy Generator.

    Returns a Plan with its `tree`; without a path `plan.reason` says what ran out. Probabilistically complete for goal_bias < 1: if
    a path with some clearance exists, the chance of missing it goes to zero as max_nodes and max_iterations grow.
    Raises InvalidParameter.

    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> plan = rrt(Problem(Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
    >>> plan.path[0], plan.path[-1]
    (array([1., 1.]), array([9., 1.]))
    """
    asked = askable(problem)
    delta = positive(world_size(asked) / 20.0 if step is None else step, "step")
    bias = share(goal_bias, "goal_bias")
    most = whole(max_nodes, "max_nodes", least=1)
    limit = 10 * most if max_iterations is None else whole(max_iterations, "max_iterations", least=0)
    tree = new_tree(asked, most + 1)
    before = asked.asked[MOTIONS]
    at_goal, iterations = body_for(asked, grow)(asked, tree, delta, bias, limit, as_generator(rng))
    reason = f"after {iterations:,} iterations none of {tree.size[0]:,} nodes reaches the goal; allow more nodes, or another step"
    checks = int(asked.asked[MOTIONS] - before)
    return plan_from_tree("RRT", asked, tree, at_goal, reason, iterations=int(iterations), checks=checks)
