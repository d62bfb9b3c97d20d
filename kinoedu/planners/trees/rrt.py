"""Rapidly-exploring random trees. LaValle, "Rapidly-exploring random trees: a new tool for path
planning" (1998); LaValle, Planning Algorithms, section 5.5; Bullo & Smith, chapter 5.
"""

from typing import Any

import numpy as np

from ...compiled import algorithm, callable_from_compiled
from ...errors import InvalidParameter
from ...geometry.checks import Array, as_generator
from ...problems import MOTIONS, Plan
from ...spaces.buckets import GrowingTree, add
from ..answers import plan_from_tree
from ..problem_input import askable, new_tree, world_size
from ..tuning import none_or_more, positive, share, whole


@algorithm
def grow(
    problem: Any,
    tree: GrowingTree,
    step: float,
    goal_bias: float,
    spacing: float,
    max_iterations: int,
    max_failures: int,
    rng: np.random.Generator,
) -> tuple[int, int]:
    """Grow the tree until it reaches the goal, is full, has had its iterations, or so many in a row
    have added nothing; returns the goal's node, or -1, and how many iterations.
    """
    at_goal = join_goal(problem, tree, add(tree, problem.start, -1), step)
    iteration, failures = 0, 0
    room = len(tree.nodes) - 1  # one more is kept for the goal
    while (
        at_goal < 0
        and iteration < max_iterations
        and failures < max_failures
        and tree.size[0] < room
    ):
        iteration, failures = iteration + 1, failures + 1
        q_rand = problem.goal if rng.random() < goal_bias else problem.sample(rng)
        near = problem.nearest(tree, q_rand)
        q_new = problem.steer(tree.nodes[near], q_rand, step)
        if problem.is_free_path(tree.nodes[near], q_new) and is_apart(
            problem, tree, q_new, spacing
        ):
            at_goal, failures = join_goal(problem, tree, add(tree, q_new, near), step), 0
    return at_goal, iteration


@callable_from_compiled
def join_goal(problem: Any, tree: GrowingTree, node: int, step: float) -> int:
    """Append the goal to a node within one free step of it; returns the goal's node, or -1."""
    if problem.distance(tree.nodes[node], problem.goal) > step:
        return -1
    if not problem.is_free_path(tree.nodes[node], problem.goal):
        return -1
    return add(tree, problem.goal, node)


@callable_from_compiled
def is_apart(problem: Any, tree: GrowingTree, q: Array, spacing: float) -> bool:
    """Whether a configuration is at least so far from every node."""
    return spacing <= 0.0 or problem.distance(tree.nodes[problem.nearest(tree, q)], q) >= spacing


def rrt(
    problem: Any,
    *,
    step: float | None = None,
    goal_bias: float = 0.05,
    spacing: float = 0.0,
    max_nodes: int = 10_000,
    max_iterations: int | None = None,
    max_failures: int | None = None,
    rng: int | np.random.Generator,
) -> Plan:
    """Grow a tree from the start, each time from its nearest node towards a random configuration,
    until it reaches the goal.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours that answers the same questions.
    step : delta, the longest edge; by default a twentieth of the world's diagonal.
    goal_bias : the share of samples that are the goal itself, from 0 to 1.
    spacing : a new node nearer than this to another is refused; 0 refuses none. Less than a step.
    max_nodes, max_iterations : where to give up; by default ten iterations for each node.
    max_failures : give up as well when so many iterations in a row have added no node; by default
    it does not.
    rng : a seed or a numpy Generator.

    Returns a Plan with its `tree`; without a path `plan.reason` says what ran out.
    Probabilistically complete for goal_bias < 1: if a path with some clearance exists, the chance
    of missing it goes to zero as max_nodes and max_iterations grow. Raises InvalidParameter.

    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> plan = rrt(Problem(Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
    >>> plan.path[0], plan.path[-1]
    (array([1., 1.]), array([9., 1.]))
    """
    asked = askable(problem)
    delta = positive(world_size(asked) / 20.0 if step is None else step, "step")
    bias, apart = share(goal_bias, "goal_bias"), none_or_more(spacing, "spacing")
    if apart >= delta:
        raise InvalidParameter(
            f"spacing must be less than the step {delta:g}, or no node can be added; got {apart:g}"
        )
    most = whole(max_nodes, "max_nodes", least=1)
    limit = (
        10 * most if max_iterations is None else whole(max_iterations, "max_iterations", least=0)
    )
    in_a_row = limit if max_failures is None else whole(max_failures, "max_failures", least=1)
    tree = new_tree(asked, most + 1)
    before = asked.asked[MOTIONS]
    at_goal, iterations = grow(asked, tree, delta, bias, apart, limit, in_a_row, as_generator(rng))
    reason = (
        f"after {iterations:,} iterations none of {tree.size[0]:,} nodes reaches the goal; allow "
        "more nodes, or another step"
    )
    checks = int(asked.asked[MOTIONS] - before)
    return plan_from_tree(
        "RRT", asked, tree, at_goal, reason, iterations=int(iterations), checks=checks
    )
