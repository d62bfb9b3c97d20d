"""Two trees that grow towards each other. J. J. Kuffner, S. M. LaValle, "RRT-Connect: an efficient
approach to single-query path planning" (2000); LaValle, section 5.5.3.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm, callable_from_compiled, compiled
from ...geometry.checks import Array, as_generator
from ...graphs import extract_path
from ...problems import MOTIONS, Plan, Tree
from ...spaces.buckets import GrowingTree, add
from ..answers import plan_along
from ..problem_input import both_ways, new_tree, world_size
from ..tuning import positive, whole

Numbers = NDArray[np.int64]
TRAPPED = -1
USUAL = 500  # nodes of a tree when it meets the other


@algorithm
def grow_both(
    problem: Any,
    from_start: GrowingTree,
    from_goal: GrowingTree,
    owner: Numbers,
    step: float,
    max_iterations: int,
    rng: np.random.Generator,
) -> tuple[int, int, int]:
    """Grow two trees until they meet, are full, or have had their iterations.

    Returns the nodes of both at which they meet, or TRAPPED, and how many iterations; owner[i]
    tells whose the i-th new node was.
    """
    add(from_goal, problem.goal, TRAPPED)
    new = add(from_start, problem.start, TRAPPED)
    here, there, who = from_start, from_goal, 0
    owner[0], owner[1], grown, iteration = 0, 1, 2, 0
    while True:
        if new != TRAPPED:
            met, added = connect(problem, there, here.nodes[new], step, len(owner) - grown)
            owner[grown : grown + added] = 1 - who
            grown += added
            if met != TRAPPED:
                return (new, met, iteration) if who == 0 else (met, new, iteration)
        if iteration == max_iterations or grown == len(owner):
            return TRAPPED, TRAPPED, iteration
        here, there, who = there, here, 1 - who
        iteration += 1
        new, _ = extend(problem, here, problem.sample(rng), step)
        if new != TRAPPED:
            owner[grown] = who
            grown += 1


@callable_from_compiled
def extend(problem: Any, tree: GrowingTree, q: Array, step: float) -> tuple[int, bool]:
    """Take one step from the nearest node towards q: the new node, or TRAPPED, and whether it is at
    q.
    """
    near = problem.nearest(tree, q)
    reached = problem.distance(tree.nodes[near], q) <= step
    q_new = q if reached else problem.steer(tree.nodes[near], q, step)
    if not problem.is_free_path(tree.nodes[near], q_new):
        return TRAPPED, False
    return add(tree, q_new, near), reached


@callable_from_compiled
def connect(problem: Any, tree: GrowingTree, q: Array, step: float, room: int) -> tuple[int, int]:
    """Extend the tree towards q until it is there or trapped: the node at q, or TRAPPED, and how
    many nodes that took.
    """
    added, reached, node = 0, False, TRAPPED
    while not reached and added < room:
        node, reached = extend(problem, tree, q, step)
        if node == TRAPPED:
            break
        added += 1
    return (node if reached else TRAPPED), added


def rrt_connect(
    problem: Any,
    *,
    step: float | None = None,
    max_nodes: int = 10_000,
    max_iterations: int | None = None,
    rng: int | np.random.Generator,
) -> Plan:
    """Grow one tree from the start and one from the goal: in turns one takes a step at random, and
    the other runs to meet it.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours that answers the same questions.
    step : epsilon, the longest edge; by default a twentieth of the world's diagonal.
    max_nodes : of both trees together.
    max_iterations : where to give up; by default ten iterations for each node.
    rng : a seed or a numpy Generator.

    Returns a Plan; its `tree` holds both trees in the order their nodes came, start and goal, which
    have no parents, first. Without a path `plan.reason` says what ran out. Motions are judged
    towards the tree that they leave behind, so they must be free both ways. Probabilistically
    complete. Raises InvalidParameter.

    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> plan = rrt_connect(Problem(Point(), world, start=(1, 1), goal=(9, 1)), rng=0)
    >>> plan.path[0], plan.path[-1]
    (array([1., 1.]), array([9., 1.]))
    """
    asked = both_ways(problem, "RRT-Connect")
    epsilon = positive(world_size(asked) / 20.0 if step is None else step, "step")
    most = whole(max_nodes, "max_nodes", least=2)
    limit = (
        10 * most if max_iterations is None else whole(max_iterations, "max_iterations", least=0)
    )
    trees, owner = (roomy_tree(asked, most), roomy_tree(asked, most)), np.empty(most, np.int64)
    before = asked.asked[MOTIONS]
    at_start, at_goal, iterations = grow_both(
        asked, *trees, owner, epsilon, limit, as_generator(rng)
    )
    grown = int(trees[0].size[0] + trees[1].size[0])
    nodes, parent, number = as_one(
        (trees[0].nodes, trees[1].nodes), (trees[0].parent, trees[1].parent), owner[:grown]
    )
    tree = Tree(nodes, parent)
    path = (
        None
        if at_start == TRAPPED
        else meeting(tree.parent, number[0, at_start], number[1, at_goal])
    )
    reason = (
        f"after {iterations:,} iterations the trees, {len(tree.nodes):,} nodes, have not met; "
        "allow more, or another step"
    )
    stats = {
        "nodes": len(tree.nodes),
        "iterations": int(iterations),
        "checks": int(asked.asked[MOTIONS] - before),
    }
    return plan_along(
        asked, tree.nodes, path, reason, planner="RRT-Connect", tree=tree, stats=stats
    )


def roomy_tree(problem: Any, capacity: int) -> GrowingTree:
    """An empty tree with buckets for fewer nodes than it has room for: trees that meet early would
    leave most of them empty, and a search among empty buckets is slow.
    """
    tree, d = new_tree(problem, min(capacity, max(USUAL, capacity // 20))), len(problem.start)
    return tree._replace(
        nodes=np.empty((capacity, d)),
        parent=np.empty(capacity, np.int64),
        next=np.empty(capacity, np.int64),
    )


@compiled
def as_one(
    nodes: tuple[Array, Array], parents: tuple[Numbers, Numbers], owner: Numbers
) -> tuple[Array, Numbers, Numbers]:
    """Two trees in one, in the order in which they grew: its nodes, their parents, and the number
    in it of each node of either.
    """
    together, parent = np.empty((len(owner), nodes[0].shape[1])), np.empty(len(owner), np.int64)
    number, size = np.empty((2, len(owner)), np.int64), np.zeros(2, np.int64)
    for i in range(len(owner)):
        who = owner[i]
        k = size[who]
        above = parents[who][k]
        together[i], parent[i] = nodes[who][k], number[who, above] if above >= 0 else TRAPPED
        number[who, k], size[who] = i, k + 1
    return together, parent, number


def meeting(parent: Numbers, at_start: int, at_goal: int) -> Numbers:
    """From the start's root to where its tree meets the other, and on to the goal's root."""
    return np.concatenate([extract_path(parent, at_start), extract_path(parent, at_goal)[-2::-1]])
