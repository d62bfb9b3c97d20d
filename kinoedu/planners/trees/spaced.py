"""RRT with two more rules: nodes keep a distance, and many failures in a row end the search.

Both serve large terrains, where a tree would otherwise fill every open place with nodes.
"""

import numpy as np

from ...compiled import algorithm, callable_from_compiled
from ...geometry.checks import Array
from ...problems.protocols import PlanningProblem
from ...spaces.buckets import GrowingTree, add
from .goal import join_goal


@algorithm
def grow_spaced(
    problem: PlanningProblem,
    tree: GrowingTree,
    step_size: float,
    goal_bias: float,
    spacing: float,
    max_iterations: int,
    max_failures: int,
    rng: np.random.Generator,
) -> tuple[int, int]:
    """Grow a tree as `rrt.grow` does, with no new node nearer than `spacing` to another.

    It also stops after `max_failures` consecutive iterations without a new node.

    Returns
    -------
    The goal's node, or -1, and the number of iterations.
    """
    at_goal = join_goal(problem, tree, add(tree, problem.start, -1), step_size)
    iteration, failures = 0, 0
    room = len(tree.nodes) - 1  # the last place is reserved for the goal
    while (
        at_goal < 0
        and iteration < max_iterations
        and failures < max_failures
        and tree.size[0] < room
    ):
        iteration, failures = iteration + 1, failures + 1
        q_rand = problem.goal if rng.random() < goal_bias else problem.sample(rng)
        near = problem.nearest(tree, q_rand)
        q_new = problem.steer(tree.nodes[near], q_rand, step_size)
        is_free = problem.is_free_path(tree.nodes[near], q_new)
        if is_free and is_apart(problem, tree, q_new, spacing):
            at_goal, failures = join_goal(problem, tree, add(tree, q_new, near), step_size), 0
    return at_goal, iteration


@callable_from_compiled
def is_apart(problem: PlanningProblem, tree: GrowingTree, q: Array, spacing: float) -> bool:
    """Whether a configuration is at least `spacing` away from every node."""
    return spacing <= 0.0 or problem.distance(tree.nodes[problem.nearest(tree, q)], q) >= spacing
