"""RRT*: trees whose paths converge to shortest paths.

    RRT*(Q_free, q_start, q_goal, eta)
     1  T := a tree with the root q_start
     2  repeat:
     3      q_rand := a random configuration
     4      q_nearest := the node of T nearest to q_rand
     5      q_new := the configuration at most eta from q_nearest on the way to q_rand
     6      if the motion from q_nearest to q_new is free:
     7          Q_near := the nodes of T within r(T) of q_new
     8          q_min := the node of Q_near or q_nearest through which q_new costs least
     9          add q_new to T, with the parent q_min
    10          for each q_near in Q_near:
    11              if q_near costs less through q_new and the motion to it is free:
    12                  make q_new the parent of q_near

S. Karaman, E. Frazzoli, "Sampling-based algorithms for optimal motion planning" (2011), algorithm
6.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm, callable_from_compiled
from ...geometry.checks import Array, as_generator
from ...messages import get_message
from ...problems import Plan
from ...problems.protocols import PlanningProblem, ProblemLike
from ...support.constructors import with_type_names
from ..answers import plan_from_tree
from ..problem_input import as_step_size, as_two_way_problem, count_checks, new_tree
from ..tuning import fraction, integer, iteration_limit, positive
from .cost_tree import CostTree, append_node, empty_costs, rewire
from .informed import Everywhere, Informed, draw_sample
from .near import near_nodes


@with_type_names
class Growth(NamedTuple):
    """A tree that has grown, with its problem and the work that it took.

    radii : (n,), radii[i] is how far a tree of i nodes looks for neighbours.
    at_goal : the goal's node, or -1.
    checks : how many motions were checked.
    """

    problem: PlanningProblem
    costs: CostTree
    radii: Array
    at_goal: int
    iterations: int
    checks: int


@algorithm
def grow_shortest(
    problem: PlanningProblem,
    costs: CostTree,
    sampler: Everywhere | Informed,
    step_size: float,
    radii: Array,
    max_iterations: int,
    rng: np.random.Generator,
) -> tuple[int, int]:
    """Grow the tree by lines 2 to 12 until it is full, out of iterations, or cannot be improved.

    radii[n] is how far a tree of n nodes looks for neighbours.

    Returns
    -------
    The goal's node, or -1, and the number of iterations.
    """
    tree = costs.tree
    append_node(costs, problem.start, -1, 0.0)
    at_goal = reach_goal(problem, costs, 0, step_size)
    least, iteration = problem.distance(problem.start, problem.goal), 0
    room = len(tree.nodes) - 1  # the last place is reserved for the goal
    while iteration < max_iterations and tree.size[0] < room + int(at_goal >= 0):
        shortest = np.inf if at_goal < 0 else costs.cost[at_goal]
        if shortest <= least:
            break
        iteration += 1
        q_rand = draw_sample(sampler, problem, shortest, rng)
        nearest = problem.nearest(tree, q_rand)
        q_new = problem.steer(tree.nodes[nearest], q_rand, step_size)
        if not problem.is_free_path(tree.nodes[nearest], q_new):
            continue
        near = near_nodes(problem, tree, q_new, radii[tree.size[0]])
        parent, length = cheapest_parent(problem, costs, near, nearest, q_new)
        new = append_node(costs, q_new, parent, length)
        for node in near:
            q_near = tree.nodes[node]
            length = problem.motion_cost(q_new, q_near)
            cheaper = costs.cost[new] + length < costs.cost[node]
            if cheaper and problem.is_free_path(q_new, q_near):
                rewire(costs, node, new, length)
        if at_goal < 0:
            at_goal = reach_goal(problem, costs, new, step_size)
    return at_goal, iteration


@callable_from_compiled
def cheapest_parent(
    problem: PlanningProblem, costs: CostTree, near: NDArray[np.int64], nearest: int, q: Array
) -> tuple[int, float]:
    """Line 8: the node through which q costs least, and the cost of the motion from it.

    The motion from `nearest` to q is known to be free.
    """
    parent, length = nearest, problem.motion_cost(costs.tree.nodes[nearest], q)
    for node in near:
        apart = problem.motion_cost(costs.tree.nodes[node], q)
        cheaper = costs.cost[node] + apart < costs.cost[parent] + length
        if cheaper and problem.is_free_path(costs.tree.nodes[node], q):
            parent, length = node, apart
    return parent, length


@callable_from_compiled
def reach_goal(problem: PlanningProblem, costs: CostTree, node: int, step_size: float) -> int:
    """Append the goal below a node within one free step of it; returns the goal's node, or -1."""
    q = costs.tree.nodes[node]
    if problem.distance(q, problem.goal) > step_size or not problem.is_free_path(q, problem.goal):
        return -1
    return append_node(costs, problem.goal, node, problem.motion_cost(q, problem.goal))


def rrt_star(
    problem: ProblemLike,
    *,
    step_size: float | None = None,
    goal_bias: float = 0.05,
    gamma: float | None = None,
    max_nodes: int = 5_000,
    max_iterations: int | None = None,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan by RRT*: grow a tree as RRT does, and rewire it wherever that makes a path cheaper.

    Asymptotically optimal where a robot can move in every direction: the cost tends to the least
    possible one as max_nodes grows. For that, a path must cost at least its length and at most a
    fixed multiple of it, as on a terrain with costs. O(n log n) motions for n nodes.

    Parameters
    ----------
    problem : a Problem, a Recorder, or an object of yours with the same methods.
    step_size : eta, the longest motion towards a sample; by default a twentieth of the space's
        diameter.
    goal_bias : the probability that a sample is the goal, until the goal is reached.
    gamma : a tree of n nodes looks for neighbours within gamma (log n / n)^(1/d), at most
        `step_size`. By default large enough that paths converge to the shortest in the problem's
        space; for an object of yours the radius is always `step_size`.
    max_nodes : stop at this many nodes; the planner does not stop at the first path.
    max_iterations : stop after this many iterations; by default ten for each node.
    rng : a seed or a numpy Generator.

    Returns
    -------
    Plan with its `tree`: the nodes in the order of creation, with their final parents. Without a
    path `plan.reason` says what ran out.

    Raises
    ------
    InvalidParameter
        Where a parameter is out of its range, or the robot only drives forward.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> plan = rrt_star(Problem(Point(), world, start=(1, 1), goal=(9, 1)), max_nodes=2000, rng=0)
    >>> bool(17.2 < plan.cost < 17.7)
    True
    """
    sampler = Everywhere(fraction(goal_bias, "goal_bias"))
    growth = grow_rrt_star(
        "RRT*", problem, sampler, step_size, gamma, max_nodes, max_iterations, rng
    )
    return plan_from_growth("RRT*", growth)


def informed_rrt_star(
    problem: ProblemLike,
    *,
    step_size: float | None = None,
    goal_bias: float = 0.05,
    gamma: float | None = None,
    max_nodes: int = 5_000,
    max_iterations: int | None = None,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan by RRT* that, once it has a path, samples only where a shorter one may pass.

    Parameters, result and errors are those of `rrt_star`.
    """
    sampler = Informed(fraction(goal_bias, "goal_bias"))
    return plan_from_growth(
        "informed RRT*",
        grow_rrt_star(
            "informed RRT*", problem, sampler, step_size, gamma, max_nodes, max_iterations, rng
        ),
    )


def grow_rrt_star(
    planner: str,
    problem: ProblemLike,
    sampler: Everywhere | Informed,
    step_size: float | None,
    gamma: float | None,
    max_nodes: int,
    max_iterations: int | None,
    rng: int | np.random.Generator,
    rows: int = 0,
) -> Growth:
    """Check the parameters and grow the tree, with a log of `rows` edges."""
    problem = as_two_way_problem(problem, planner)
    eta = as_step_size(problem, step_size, "step_size")
    most = integer(max_nodes, "max_nodes", least=1)
    limit = iteration_limit(max_iterations, most)
    widest = sufficient_gamma(problem) if gamma is None else positive(gamma, "gamma")
    radii = neighbour_radii(widest, len(problem.start), most + 2, eta)
    costs = empty_costs(new_tree(problem, most + 1), rows)
    before = count_checks(problem)
    at_goal, iterations = grow_shortest(
        problem, costs, sampler, eta, radii, limit, as_generator(rng)
    )
    checks = count_checks(problem) - before
    return Growth(problem, costs, radii, int(at_goal), int(iterations), checks)


@callable_from_compiled
def neighbour_radii(gamma: float, d: int, size: int, most: float) -> Array:
    """How far a tree of n nodes looks for neighbours, for each n below `size`, shape (size,).

    gamma (log n / n)^(1/d), but at most `most`.
    """
    radii = np.full(size, most)
    for n in range(2, size):
        radii[n] = min(gamma * (math.log(n) / n) ** (1.0 / d), most)
    return radii


def plan_from_growth(planner: str, growth: Growth) -> Plan:
    """The plan along a tree that has grown."""
    tree, iterations = growth.costs.tree, growth.iterations
    reason = get_message(
        "plan.tree_failed", iterations=f"{iterations:,}", nodes=f"{tree.size[0]:,}"
    )
    return plan_from_tree(
        planner,
        growth.problem,
        tree,
        growth.at_goal,
        reason,
        iterations=iterations,
        checks=growth.checks,
    )


def sufficient_gamma(problem: PlanningProblem) -> float:
    """2 (1 + 1/d)^(1/d) (volume / ball)^(1/d): a gamma that is large enough for convergence.

    The volume is that of the whole space, which is at least that of the free space; the ball has
    radius 1.
    """
    space, d = getattr(problem, "space", None), len(problem.start)
    if space is None:
        return np.inf
    volume = float(np.prod((space.hi - space.lo) * getattr(space, "weight", 1.0)))
    ball = math.pi ** (d / 2.0) / math.gamma(d / 2.0 + 1.0)
    return float(2.0 * (1.0 + 1.0 / d) ** (1.0 / d) * (volume / ball) ** (1.0 / d))
