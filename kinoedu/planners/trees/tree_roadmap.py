"""The incremental tree roadmap, with an expansion of the reader's choice. Bullo & Smith, chapter 5.

     1  T := the start, without edges
     2  while T has fewer than N nodes:
     3      select a node of T for expansion, and a configuration q_nearby near it
     4      if the motion from the node to q_nearby is free:
     5          add q_nearby and the motion to T
     6  return T

Here the tree also stops when it has reached the goal.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from ...errors import InvalidParameter
from ...geometry.checks import Array, as_array, as_generator, is_integer
from ...problems import Plan
from ...problems.protocols import PlanningProblem, ProblemLike
from ...spaces.buckets import GrowingTree, add
from ...support.text import shortened
from ..answers import plan_from_tree
from ..problem_input import as_problem, as_step_size, count_checks, in_space, new_tree, world_size
from ..tuning import fraction, integer, iteration_limit, positive
from .goal import join_goal

Expansion = Callable[[Any, GrowingTree, np.random.Generator], tuple[int, Array]]


def tree_roadmap(
    problem: ProblemLike,
    expand: Expansion | None = None,
    *,
    reach: float | None = None,
    max_nodes: int = 1_000,
    max_iterations: int | None = None,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan with a tree that grows from the start by an expansion of your own.

    The planner runs interpreted, as the expansion does.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours with the same methods.
    expand : a function `expand(problem, tree, rng)` that returns the number of a node and a
        configuration near it, shape (d,). `tree.nodes[: tree.size[0]]` are the nodes so far, and
        `problem.nearest(tree, q)` is the node nearest to q. By default `rrt_expansion()`, which
        makes this an RRT.
    reach : a new node within this distance of the goal is joined to it; by default a twentieth of
        the space's diameter.
    max_nodes : stop at this many nodes.
    max_iterations : stop after this many iterations; by default ten for each node.
    rng : a seed or a numpy Generator.

    Returns
    -------
    Plan with its `tree`. Without a path `plan.reason` says what ran out.

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range, or the expansion does not return a node and a
        configuration.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)])
    >>> def wander(problem, tree, rng):
    ...     node = int(rng.integers(tree.size[0]))
    ...     return node, tree.nodes[node] + rng.uniform(-1, 1, 2)
    >>> problem = Problem(Point(), world, start=(4, 4), goal=(6, 6))
    >>> tree_roadmap(problem, wander, rng=0).path is not None
    True
    """
    problem = as_problem(problem)
    near_goal = as_step_size(problem, reach, "reach")
    most = integer(max_nodes, "max_nodes", least=1)
    limit = iteration_limit(max_iterations, most)
    expansion = rrt_expansion() if expand is None else expand
    if not callable(expansion):
        raise InvalidParameter(
            "expand must be a function of a problem, a tree and a generator, got "
            f"{shortened(expand)}"
        )
    tree, generator = new_tree(problem, most + 1), as_generator(rng)
    before, iteration = count_checks(problem), 0
    at_goal = join_goal(problem, tree, add(tree, problem.start, -1), near_goal)
    while at_goal < 0 and iteration < limit and tree.size[0] < most:
        iteration += 1
        node, q_nearby = as_expansion(expansion(problem, tree, generator), problem, tree)
        if problem.is_free_path(tree.nodes[node], q_nearby):
            at_goal = join_goal(problem, tree, add(tree, q_nearby, node), near_goal)
    reason = (
        f"after {iteration:,} iterations none of {tree.size[0]:,} nodes reaches the goal; allow "
        "more nodes, or expand otherwise"
    )
    stats = {"iterations": iteration, "checks": count_checks(problem) - before}
    return plan_from_tree("tree roadmap", problem, tree, at_goal, reason, **stats)


def rrt_expansion(step_size: float | None = None, goal_bias: float = 0.05) -> Expansion:
    """The expansion of an RRT: the node nearest to a sample, and one step from it to the sample.

    Raises
    ------
    InvalidParameter
        Where `step_size` is not positive or `goal_bias` is not from 0 to 1.
    """
    bias = fraction(goal_bias, "goal_bias")
    delta = None if step_size is None else positive(step_size, "step_size")

    def expand(
        problem: PlanningProblem, tree: GrowingTree, rng: np.random.Generator
    ) -> tuple[int, Array]:
        q_rand = problem.goal if rng.random() < bias else problem.sample(rng)
        node = problem.nearest(tree, q_rand)
        longest = world_size(problem) / 20.0 if delta is None else delta
        return node, problem.steer(tree.nodes[node], q_rand, longest)

    return expand


def nodes_expansion(expand: Callable[[Any, Array, np.random.Generator], Any]) -> Expansion:
    """An expansion from a function `expand(problem, nodes, rng)` of the nodes so far, (n, d).

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> room = PolygonWorld([(0, 0), (9, 0), (9, 9), (0, 9)])
    >>> problem = Problem(Point(), room, start=(1, 1), goal=(8, 8))
    >>> newest = nodes_expansion(lambda problem, nodes, rng: (len(nodes) - 1, nodes[-1] + 3))
    >>> tree_roadmap(problem, expand=newest, reach=2, rng=0).path.tolist()
    [[1.0, 1.0], [4.0, 4.0], [7.0, 7.0], [8.0, 8.0]]
    """
    return lambda problem, tree, rng: expand(problem, tree.nodes[: tree.size[0]], rng)


def as_expansion(answer: object, problem: PlanningProblem, tree: GrowingTree) -> tuple[int, Array]:
    """The answer of an expansion as a node's number and a configuration of the problem's space.

    Raises
    ------
    InvalidParameter
        Where it is not a node of the tree and a configuration.
    """
    if not isinstance(answer, tuple | list) or len(answer) != 2:
        raise InvalidParameter(
            "an expansion must return a node's number and a configuration near it, got "
            f"{shortened(answer)}"
        )
    node, q = answer[0], as_array(answer[1], "the expansion's configuration")
    if not is_integer(node) or not 0 <= node < tree.size[0]:
        raise InvalidParameter(
            f"an expansion must choose a node from 0 to {tree.size[0] - 1}, got {shortened(node)}"
        )
    if q.shape != tree.nodes[0].shape:
        raise InvalidParameter(
            f"an expansion's configuration must have shape {tree.nodes[0].shape}, got {q.shape}"
        )
    return int(node), in_space(problem, q)
