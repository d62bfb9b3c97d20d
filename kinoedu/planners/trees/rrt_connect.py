"""RRT-Connect: two trees that grow towards each other.

    RRT-CONNECT(q_start, q_goal)
     1  T_a := a tree with the root q_start; T_b := a tree with the root q_goal
     2  repeat:
     3      q_rand := a random configuration
     4      q_new := EXTEND(T_a, q_rand)
     5      if that was not trapped and CONNECT(T_b, q_new) reaches q_new:
     6          return the path through q_new
     7      swap T_a and T_b

    EXTEND(T, q): one step from the node of T nearest to q towards q, where that is free
    CONNECT(T, q): EXTEND(T, q) again and again, until q is reached or a step is trapped

Here the loop starts at line 5 with q_new = q_start: the goal's tree first tries to reach the start.

J. J. Kuffner, S. M. LaValle, "RRT-Connect: an efficient approach to single-query path planning"
(2000); LaValle, section 5.5.3.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm, callable_from_compiled, compiled
from ...geometry.checks import Array, as_generator
from ...graphs import extract_path
from ...messages import get_message
from ...problems import Plan, Tree
from ...problems.protocols import PlanningProblem, ProblemLike
from ...spaces.buckets import GrowingTree, add
from ..answers import plan_along
from ..problem_input import as_step_size, as_two_way_problem, count_checks, new_tree
from ..tuning import integer, iteration_limit

Numbers = NDArray[np.int64]
TRAPPED = -1
TYPICAL_NODES = 500  # nodes of a tree when it meets the other


@algorithm
def grow_both(
    problem: PlanningProblem,
    from_start: GrowingTree,
    from_goal: GrowingTree,
    owner: Numbers,
    step_size: float,
    max_iterations: int,
    rng: np.random.Generator,
) -> tuple[int, int, int]:
    """Grow two trees until they meet, are full, or have had their iterations.

    owner[i] becomes 0 where the i-th new node is in the start's tree, and 1 in the goal's tree.

    Returns
    -------
    The nodes of both trees at which they meet, or TRAPPED twice, and the number of iterations.
    """
    add(from_goal, problem.goal, TRAPPED)
    new = add(from_start, problem.start, TRAPPED)
    here, there, side = from_start, from_goal, 0
    owner[0], owner[1], grown, iteration = 0, 1, 2, 0
    while True:
        if new != TRAPPED:
            meeting, added = connect(problem, there, here.nodes[new], step_size, len(owner) - grown)
            owner[grown : grown + added] = 1 - side
            grown += added
            if meeting != TRAPPED:
                return (new, meeting, iteration) if side == 0 else (meeting, new, iteration)
        if iteration == max_iterations or grown == len(owner):
            return TRAPPED, TRAPPED, iteration
        here, there, side = there, here, 1 - side
        iteration += 1
        new, _ = extend(problem, here, problem.sample(rng), step_size)
        if new != TRAPPED:
            owner[grown] = side
            grown += 1


@callable_from_compiled
def extend(
    problem: PlanningProblem, tree: GrowingTree, q: Array, step_size: float
) -> tuple[int, bool]:
    """Take one step from the nearest node towards q.

    Returns
    -------
    The new node, or TRAPPED, and whether it is at q.
    """
    near = problem.nearest(tree, q)
    reached = problem.distance(tree.nodes[near], q) <= step_size
    q_new = q if reached else problem.steer(tree.nodes[near], q, step_size)
    if not problem.is_free_path(tree.nodes[near], q_new):
        return TRAPPED, False
    return add(tree, q_new, near), reached


@callable_from_compiled
def connect(
    problem: PlanningProblem, tree: GrowingTree, q: Array, step_size: float, room: int
) -> tuple[int, int]:
    """Extend the tree towards q until it reaches q, is trapped, or has added `room` nodes.

    Returns
    -------
    The node at q, or TRAPPED, and how many nodes were added.
    """
    added, reached, node = 0, False, TRAPPED
    while not reached and added < room:
        node, reached = extend(problem, tree, q, step_size)
        if node == TRAPPED:
            break
        added += 1
    return (node if reached else TRAPPED), added


def rrt_connect(
    problem: ProblemLike,
    *,
    step_size: float | None = None,
    max_nodes: int = 10_000,
    max_iterations: int | None = None,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan with two trees, from the start and from the goal.

    In turns one tree takes a step towards a random configuration, and the other extends itself
    towards the new node. Probabilistically complete.

    Motions are checked in the direction towards the older node, so they must be free in both
    directions.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours with the same methods.
    step_size : epsilon, the longest edge; by default a twentieth of the space's diameter.
    max_nodes : stop at this many nodes, of both trees together.
    max_iterations : stop after this many iterations; by default ten for each node.
    rng : a seed or a numpy Generator.

    Returns
    -------
    Plan with its `tree`: both trees, in the order in which their nodes were made; start and goal,
    which have no parents, come first. Without a path `plan.reason` says what ran out.

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range, or the robot only drives forward.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> plan = rrt_connect(Problem(Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
    >>> plan.path[0], plan.path[-1]
    (array([1., 1.]), array([9., 1.]))
    """
    problem = as_two_way_problem(problem, "RRT-Connect")
    epsilon = as_step_size(problem, step_size, "step_size")
    most = integer(max_nodes, "max_nodes", least=2)
    limit = iteration_limit(max_iterations, most)
    trees, owner = (roomy_tree(problem, most), roomy_tree(problem, most)), np.empty(most, np.int64)
    before = count_checks(problem)
    at_start, at_goal, iterations = grow_both(
        problem, *trees, owner, epsilon, limit, as_generator(rng)
    )
    grown = int(trees[0].size[0] + trees[1].size[0])
    nodes, parent, number = merge_trees(
        (trees[0].nodes, trees[1].nodes), (trees[0].parent, trees[1].parent), owner[:grown]
    )
    tree, path = Tree(nodes, parent), None
    if at_start != TRAPPED:
        path = join_paths(parent, number[0, at_start], number[1, at_goal])
    reason = get_message(
        "plan.trees_failed", iterations=f"{iterations:,}", nodes=f"{len(tree.nodes):,}"
    )
    stats = {
        "nodes": len(tree.nodes),
        "iterations": int(iterations),
        "checks": count_checks(problem) - before,
    }
    return plan_along(
        problem, tree.nodes, path, reason, planner="RRT-Connect", tree=tree, stats=stats
    )


def roomy_tree(problem: PlanningProblem, capacity: int) -> GrowingTree:
    """An empty tree whose buckets are made for fewer nodes than it has room for."""
    return new_tree(problem, capacity, roomy_size(capacity))


@callable_from_compiled
def roomy_size(capacity: int) -> int:
    """The number of nodes for which the buckets of a tree are made.

    Trees that meet early would leave most buckets empty, and a search among empty buckets is slow.
    """
    return min(capacity, max(TYPICAL_NODES, capacity // 20))


@compiled
def merge_trees(
    nodes: tuple[Array, Array], parents: tuple[Numbers, Numbers], owner: Numbers
) -> tuple[Array, Numbers, Numbers]:
    """Merge two trees in the order in which their nodes were made.

    Returns
    -------
    The nodes, their parents, and the number of each node of either tree in the merged one.
    """
    together, parent = np.empty((len(owner), nodes[0].shape[1])), np.empty(len(owner), np.int64)
    number, size = np.empty((2, len(owner)), np.int64), np.zeros(2, np.int64)
    for i in range(len(owner)):
        side = owner[i]
        k = size[side]
        above = parents[side][k]
        together[i], parent[i] = nodes[side][k], number[side, above] if above >= 0 else TRAPPED
        number[side, k], size[side] = i, k + 1
    return together, parent, number


def join_paths(parent: Numbers, at_start: int, at_goal: int) -> Numbers:
    """The path from the start's root to where the trees meet, and on to the goal's root."""
    return np.concatenate([extract_path(parent, at_start), extract_path(parent, at_goal)[-2::-1]])
