"""Stable sparse trees: drives that become ever cheaper, without a curve that joins two poses. Y.
Li, Z. Littlefield, K. E. Bekris, "Asymptotically optimal sampling-based kinodynamic planning"
(2016), algorithm 6.
"""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...compiled import algorithm, callable_from_compiled
from ...geometry.checks import Array, as_generator
from ...graphs import extract_path
from ...problems import MOTIONS, Plan
from ..tuning import positive, whole
from .common import (
    Bias,
    DrivenGrowth,
    Near,
    add_drive,
    bias_of,
    driven,
    grown_tree,
    is_near,
    near_of,
    new_growth,
    next_place,
    plan_driven,
    trajectory_to,
)


class Sparse(NamedTuple):
    """What makes a tree sparse: within `radius` of each of its `spots` (m, 3) only the cheapest
    node, `cheapest` (m,), is driven on from. `size[0]` spots are there. `cost` (n,) is how far each
    node is driven from the root; `reach`, how far round a place the cheapest node is looked for."""

    spots: Array
    cheapest: NDArray[np.int64]
    size: NDArray[np.int64]
    cost: Array
    radius: float
    reach: float


@algorithm
def grow_sparsely(
    problem: Any,
    growth: DrivenGrowth,
    sparse: Sparse,
    bias: Bias,
    duration: float,
    near: Near,
    max_iterations: int,
    rng: np.random.Generator,
) -> int:
    """Grow the tree for so many iterations; returns the cheapest node near the goal, or -1."""
    tree, there, cost = growth.tree, np.empty(3), sparse.cost
    add_spot(sparse, problem.start, 0)
    at_goal = 0 if is_near(problem.start, problem.goal, near) else -1
    for turn in range(1, max_iterations + 1):
        q_rand = next_place(problem, bias, turn, rng)
        q_near = cheapest_near(problem, growth, sparse, q_rand)
        (v, phi), t = problem.control(rng), duration * rng.random()
        problem.drive(tree.nodes[q_near], v, phi, t, there)
        c_new = cost[q_near] + abs(v) * t
        spot = spot_round(problem, sparse, there)
        beaten = spot >= 0 and c_new >= cost[sparse.cheapest[spot]]
        if (
            beaten
            or (at_goal >= 0 and c_new >= cost[at_goal])
            or not problem.is_free_drive(tree.nodes[q_near], v, phi, t)
        ):
            continue
        q_new = add_drive(problem, growth, q_near, v, phi, t)
        cost[q_new] = c_new
        if spot < 0:
            add_spot(sparse, there, q_new)
        else:
            sparse.cheapest[spot] = q_new
        if is_near(there, problem.goal, near):
            at_goal = q_new
    return at_goal


@callable_from_compiled
def add_spot(sparse: Sparse, q: Array, node: int) -> None:
    """A spot at q, and the node that is there."""
    spot = sparse.size[0]
    sparse.spots[spot] = q
    sparse.cheapest[spot] = node
    sparse.size[0] = spot + 1


@callable_from_compiled
def cheapest_near(problem: Any, growth: DrivenGrowth, sparse: Sparse, q: Array) -> int:
    """Of the nodes that stand for a spot the cheapest within reach of q; where there is none, the
    nearest.
    """
    nearest, cheapest, least_apart, least_cost = 0, -1, np.inf, np.inf
    for spot in range(sparse.size[0]):
        node = sparse.cheapest[spot]
        apart = problem.distance(growth.tree.nodes[node], q)
        if apart < least_apart:
            nearest, least_apart = node, apart
        if apart <= sparse.reach and sparse.cost[node] < least_cost:
            cheapest, least_cost = node, sparse.cost[node]
    return cheapest if cheapest >= 0 else nearest


@callable_from_compiled
def spot_round(problem: Any, sparse: Sparse, q: Array) -> int:
    """The nearest spot within whose radius q lies, or -1."""
    best, least = -1, sparse.radius
    for spot in range(sparse.size[0]):
        apart = problem.distance(sparse.spots[spot], q)
        if apart <= least:
            best, least = spot, apart
    return best


def sst(
    problem: Any,
    *,
    goal_every: int = 10,
    region_every: int = 7,
    region: float | None = None,
    region_turn: float = math.radians(90.0),
    duration: float | None = None,
    radius: float | None = None,
    reach: float | None = None,
    turn_weight: float | None = None,
    tolerance: float | None = None,
    turn_tolerance: float = math.radians(15.0),
    max_iterations: int = 20_000,
    rng: int | np.random.Generator,
) -> Plan:
    """Grow a tree of random drives in which only the cheapest node of each spot is driven on from:
    its drives become near-shortest.

    Parameters
    ----------
    duration : the longest drive; each lasts for a random part of it. By default the fastest drives
    3 wheelbases.
    radius : delta_s, within which a spot keeps one node; by default 0.4 wheelbases. The smaller,
    the shorter the drives in the end.
    reach : delta_BN, how far round a place the cheapest node is looked for; by default 0.8
    wheelbases.
    turn_weight : by default half a wheelbase, so that a spot holds headings at most some 45 degrees
    from its own.
    max_iterations : how many drives are tried; it does not stop at the first that reaches the goal.

    The others are those of `kinodynamic_rrt`. Returns a Plan with its `tree` (nodes that lost their
    spot are kept in it) and its `trajectory`; without a path that leads to the node nearest to the
    goal. O(n m) distances for n iterations and m spots. Raises InvalidParameter.

    >>> from kinoedu import Car, PolygonWorld, Problem
    >>> world = PolygonWorld([(0, 0), (20, 0), (20, 20), (0, 20)], [[(9, 0), (11, 0), (11, 10), (9, 10)]])
    >>> plan = sst(Problem(Car(3, 1, 2), world, (4, 4, 0), (16, 4, 0)), rng=1)
    >>> bool(20 < plan.cost < 40)
    True
    """
    asked = driven(problem, "sst", turn_weight, 0.5)
    bias, near = (
        bias_of(asked, goal_every, region_every, region, region_turn),
        near_of(asked, tolerance, turn_tolerance),
    )
    base, fastest = asked.robot.wheelbase, float(np.abs(asked.robot.speeds).max())
    longest = 3.0 * base / fastest if duration is None else positive(duration, "duration")
    limit = whole(max_iterations, "max_iterations", least=0)
    sparse = Sparse(
        *(
            np.empty((limit + 1, 3)),
            np.empty(limit + 1, np.int64),
            np.zeros(1, np.int64),
            np.zeros(limit + 1),
        ),
        0.4 * base if radius is None else positive(radius, "radius"),
        0.8 * base if reach is None else positive(reach, "reach"),
    )
    growth, before = new_growth(asked, limit + 1), int(asked.asked[MOTIONS])
    at_goal = grow_sparsely(asked, growth, sparse, bias, longest, near, limit, as_generator(rng))
    tree = grown_tree(growth)
    last = at_goal if at_goal >= 0 else int(asked.nearest(growth.tree, asked.goal))
    stats = {"nodes": len(tree.nodes), "spots": int(sparse.size[0]), "iterations": limit}
    stats["checks"] = int(asked.asked[MOTIONS]) - before
    trajectory = trajectory_to(asked, tree, extract_path(tree.parent, last))
    return plan_driven(problem, trajectory, at_goal >= 0, planner="SST", tree=tree, stats=stats)
