"""Stable sparse trees (SST): trees of random drives that become ever shorter.

No curve that joins two poses is needed. Y. Li, Z. Littlefield, K. E. Bekris, "Asymptotically
optimal sampling-based kinodynamic planning" (2016), algorithm 6.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm, callable_from_compiled
from ...geometry.checks import Array, as_generator
from ...problems import Plan, ProblemRecord, Recorder
from ...problems.protocols import CarProblem
from ...spaces.buckets import GrowingTree, add
from ..problem_input import count_checks, new_tree
from ..trees.near import near_nodes
from ..tuning import integer, positive
from .common import (
    DrivenGrowth,
    add_drive,
    as_car_problem,
    begin_tree,
    is_near,
    next_target,
    plan_from_driven_tree,
)
from .parameters import (
    GoalBias,
    GoalBiasRecord,
    GoalRegion,
    GoalRegionRecord,
    Refinement,
    RefinementRecord,
    Sparsity,
    as_goal_bias,
    as_goal_region,
    as_refinement,
    as_sparsity,
)

ROUNDING = 1e-9  # of a distance, so that no witness is lost


class Sparse(NamedTuple):
    """The witnesses that keep a tree sparse.

    Within `radius` of each witness only the cheapest node is driven on from. Near the goal the
    radius and the reach may be smaller.

    witnesses : the poses of the witnesses, in buckets; they have no parents.
    cheapest : (m,), the cheapest node of each witness.
    cost : (n,), the length of the drive from the root to each node.
    radius : delta_s.
    reach : delta_BN, the radius round a target within which the cheapest node is chosen.
    refinement : how these shrink near the goal.
    """

    witnesses: GrowingTree
    cheapest: NDArray[np.int64]
    cost: Array
    radius: float
    reach: float
    refinement: RefinementRecord


@algorithm
def grow_sparsely(
    problem: CarProblem,
    growth: DrivenGrowth,
    sparse: Sparse,
    bias: GoalBiasRecord,
    duration: float,
    near: GoalRegionRecord,
    max_iterations: int,
    rng: np.random.Generator,
) -> int:
    """Grow the tree; returns the cheapest node near the goal, or -1."""
    tree, there, cost, finer = growth.tree, np.empty(3), sparse.cost, sparse.refinement
    add_witness(sparse, problem.start, 0)
    at_goal = 0 if is_near(problem.start, problem.goal, near) else -1
    for iteration in range(1, max_iterations + 1):
        q_rand = next_target(problem, bias, iteration, rng)
        q_near = cheapest_near(problem, growth, sparse, q_rand)
        longest = duration * share(problem, tree.nodes[q_near], finer, finer.duration)
        (v, phi), t = problem.control(rng), longest * rng.random()
        problem.drive(tree.nodes[q_near], v, phi, t, there)
        c_new = cost[q_near] + abs(v) * t
        witness = nearest_witness(problem, sparse, there)
        if witness >= 0 and c_new >= cost[sparse.cheapest[witness]]:
            continue
        if at_goal >= 0 and c_new >= cost[at_goal]:
            continue
        if not problem.is_free_drive(tree.nodes[q_near], v, phi, t):
            continue
        q_new = add_drive(problem, growth, q_near, v, phi, t)
        cost[q_new] = c_new
        if witness < 0:
            add_witness(sparse, there, q_new)
        else:
            sparse.cheapest[witness] = q_new
        if is_near(there, problem.goal, near):
            at_goal = q_new
    return at_goal


@callable_from_compiled
def add_witness(sparse: Sparse, q: Array, node: int) -> None:
    """Add a witness at q, with its cheapest node."""
    sparse.cheapest[add(sparse.witnesses, q, -1)] = node


@callable_from_compiled
def cheapest_near(problem: CarProblem, growth: DrivenGrowth, sparse: Sparse, q: Array) -> int:
    """The cheapest node within reach of q among those of the witnesses, or else the nearest.

    A node is at most a radius from its witness, so the witnesses around q are enough.
    """
    nodes, witnesses = growth.tree.nodes, sparse.witnesses.nodes
    reach = sparse.reach * share(problem, q, sparse.refinement, sparse.refinement.radius)
    apart = problem.distance(witnesses[problem.nearest(sparse.witnesses, q)], q)
    around = max(apart + sparse.radius, reach) + sparse.radius
    nearest, cheapest, least_apart, least_cost = 0, -1, np.inf, np.inf
    for witness in near_nodes(problem, sparse.witnesses, q, around * (1.0 + ROUNDING)):
        node = sparse.cheapest[witness]
        apart = problem.distance(nodes[node], q)
        if apart < least_apart:
            nearest, least_apart = node, apart
        if apart <= reach and sparse.cost[node] < least_cost:
            cheapest, least_cost = node, sparse.cost[node]
    return cheapest if cheapest >= 0 else nearest


@callable_from_compiled
def nearest_witness(problem: CarProblem, sparse: Sparse, q: Array) -> int:
    """The nearest witness, where it is within a radius of q; else -1."""
    radius = sparse.radius * share(problem, q, sparse.refinement, sparse.refinement.radius)
    witness = problem.nearest(sparse.witnesses, q)
    return witness if problem.distance(sparse.witnesses.nodes[witness], q) <= radius else -1


@callable_from_compiled
def share(problem: CarProblem, q: Array, finer: RefinementRecord, least: float) -> float:
    """How much of a radius or a duration is left at q: all of it far from the goal."""
    return min(max(problem.distance(q, problem.goal) / finer.region, least), 1.0)


def expected_witnesses(problem: CarProblem, radius: float, limit: int) -> int:
    """How many witnesses the buckets are made for: one in each square of a side `radius`.

    They are at most `limit`, and at least one.
    """
    width, height, _ = map(float, problem.space.hi - problem.space.lo)
    return max(int(min(width / radius * (height / radius), limit)), 1)


def sst(
    problem: ProblemRecord | Recorder,
    *,
    duration: float | None = None,
    sparsity: Sparsity = Sparsity(),
    goal_bias: GoalBias = GoalBias(goal_every=10),
    goal_region: GoalRegion = GoalRegion(),
    refinement: Refinement | None = None,
    turn_weight: float | None = None,
    max_iterations: int = 20_000,
    rng: int | np.random.Generator,
) -> Plan:
    """Plan by stable sparse trees: grow a tree in which each witness keeps its cheapest node.

    The drives become near-shortest. O(n k) distances for n iterations, each with
    k witnesses near its target.

    Parameters
    ----------
    duration : the longest drive; each drive lasts for a random fraction of it. By default a drive
        at top speed covers 3 wheelbases.
    sparsity : the radius of a witness, and the reach round a target.
    goal_bias : by default `GoalBias(goal_every=10)`.
    refinement : how much finer the tree is near the goal; by default it is not. With
        `Refinement()` it reaches tight goals sooner, but its drives become shorter more slowly.
    turn_weight : by default half a wheelbase, so that headings differ by at most about 45 degrees
        from that of their witness.
    max_iterations : how many drives are tried; the planner does not stop at the first path.

    The other parameters are those of `kinodynamic_rrt`.

    Returns
    -------
    Plan with its `tree` (nodes that lost their witness stay in it) and its `trajectory`. Without a
    path the trajectory leads to the node nearest to the goal.

    Raises
    ------
    InvalidParameter
        Where the robot is not a car, or a parameter is out of its range.

    Examples
    --------
    >>> from kinoedu import Car, PolygonWorld, Problem
    >>> wall = [(9, 0), (11, 0), (11, 10), (9, 10)]
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], [wall])
    >>> plan = sst(Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0)), rng=1)
    >>> bool(20 < plan.cost < 40)
    True
    """
    car_problem = as_car_problem(problem, "sst", turn_weight, 0.5)
    bias = as_goal_bias(car_problem, goal_bias)
    near = as_goal_region(car_problem, goal_region)
    base, fastest = car_problem.robot.wheelbase, float(np.abs(car_problem.robot.speeds).max())
    longest = 3.0 * base / fastest if duration is None else positive(duration, "duration")
    limit = integer(max_iterations, "max_iterations", least=0)
    delta_s, delta_bn = as_sparsity(car_problem, sparsity)
    sparse = Sparse(
        witnesses=new_tree(car_problem, limit + 1, expected_witnesses(car_problem, delta_s, limit)),
        cheapest=np.empty(limit + 1, np.int64),
        cost=np.zeros(limit + 1),
        radius=delta_s,
        reach=delta_bn,
        refinement=as_refinement(car_problem, refinement),
    )
    growth, before = begin_tree(car_problem, limit + 1), count_checks(car_problem)
    at_goal = grow_sparsely(
        car_problem, growth, sparse, bias, longest, near, limit, as_generator(rng)
    )
    stats = {"witnesses": int(sparse.witnesses.size[0]), "iterations": limit}
    stats["checks"] = count_checks(car_problem) - before
    plan = plan_from_driven_tree(car_problem, growth, at_goal, "SST", stats)
    return replace(plan, problem=problem)
