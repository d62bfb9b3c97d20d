"""RRT: rapidly-exploring random trees.

    RRT(q_start, q_goal, delta)
     1  T := a tree with the root q_start
     2  repeat until T contains q_goal:
     3      q_rand := a random configuration, or q_goal with a small probability
     4      q_near := the node of T nearest to q_rand
     5      q_new := the configuration at most delta from q_near on the way to q_rand
     6      if the motion from q_near to q_new is free:
     7          add q_new to T, with the parent q_near
     8          if q_goal is at most delta from q_new and the motion to it is free:
     9              add q_goal to T, with the parent q_new

LaValle, "Rapidly-exploring random trees: a new tool for path planning" (1998); LaValle, Planning
Algorithms, section 5.5; Bullo & Smith, chapter 5.
"""

from __future__ import annotations

import numpy as np

from ...compiled import algorithm
from ...errors import InvalidParameter
from ...geometry.checks import as_generator
from ...messages import get_message
from ...problems import Plan
from ...problems.protocols import PlanningProblem, ProblemLike
from ...spaces.buckets import GrowingTree, add
from ..answers import plan_from_tree
from ..problem_input import as_problem, as_step_size, count_checks, new_tree
from ..tuning import fraction, integer, iteration_limit, nonnegative
from .goal import join_goal
from .spaced import grow_spaced


@algorithm
def grow(
    problem: PlanningProblem,
    tree: GrowingTree,
    step_size: float,
    goal_bias: float,
    max_iterations: int,
    rng: np.random.Generator,
) -> tuple[int, int]:
    """Grow the tree until it contains the goal, is full, or has had its iterations.

    One place in the tree is reserved for the goal.

    Returns
    -------
    The goal's node, or -1, and the number of iterations.
    """
    at_goal = join_goal(problem, tree, add(tree, problem.start, -1), step_size)
    iteration = 0
    while at_goal < 0 and iteration < max_iterations and tree.size[0] < len(tree.nodes) - 1:
        iteration += 1
        q_rand = problem.goal if rng.random() < goal_bias else problem.sample(rng)
        near = problem.nearest(tree, q_rand)
        q_new = problem.steer(tree.nodes[near], q_rand, step_size)
        if problem.is_free_path(tree.nodes[near], q_new):
            new = add(tree, q_new, near)
            at_goal = join_goal(problem, tree, new, step_size)
    return at_goal, iteration


def rrt(
    problem: ProblemLike,
    *,
    step_size: float | None = None,
    goal_bias: float = 0.05,
    spacing: float = 0.0,
    max_nodes: int = 10_000,
    max_iterations: int | None = None,
    max_failures: int | None = None,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan by RRT: grow a tree from the start towards random configurations, up to the goal.

    Probabilistically complete for goal_bias < 1: if a path with some clearance exists, the
    probability of missing it tends to zero as max_nodes and max_iterations grow.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours with the same methods.
    step_size : delta, the longest edge; by default a twentieth of the space's diameter.
    goal_bias : the probability that a sample is the goal.
    spacing : refuse a new node nearer than this to another node; less than `step_size`. Default:
        0, which refuses none.
    max_nodes : stop at this many nodes.
    max_iterations : stop after this many iterations; by default ten for each node.
    max_failures : stop after this many consecutive iterations without a new node. Default: no
        limit.
    rng : a seed or a numpy Generator.

    Returns
    -------
    Plan with its `tree`. Without a path `plan.reason` says what ran out.

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> plan = rrt(Problem(Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
    >>> plan.path[0], plan.path[-1]
    (array([1., 1.]), array([9., 1.]))
    """
    problem = as_problem(problem)
    delta = as_step_size(problem, step_size, "step_size")
    bias, apart = fraction(goal_bias, "goal_bias"), nonnegative(spacing, "spacing")
    if apart >= delta:
        raise InvalidParameter(
            f"spacing must be less than the step size {delta:g}, or no node can be added; got "
            f"{apart:g}"
        )
    most = integer(max_nodes, "max_nodes", least=1)
    limit = iteration_limit(max_iterations, most)
    failures = limit if max_failures is None else integer(max_failures, "max_failures", least=1)
    tree = new_tree(problem, most + 1)
    before, generator = count_checks(problem), as_generator(rng)
    if apart == 0.0 and failures >= limit:
        at_goal, iterations = grow(problem, tree, delta, bias, limit, generator)
    else:
        at_goal, iterations = grow_spaced(
            problem, tree, delta, bias, apart, limit, failures, generator
        )
    reason = get_message(
        "plan.tree_failed", iterations=f"{iterations:,}", nodes=f"{tree.size[0]:,}"
    )
    stats = {"iterations": int(iterations), "checks": count_checks(problem) - before}
    return plan_from_tree("RRT", problem, tree, at_goal, reason, **stats)
