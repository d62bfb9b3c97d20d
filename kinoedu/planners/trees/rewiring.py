"""How an RRT* was rewired while it grew: who hung below whom, and when."""

from copy import deepcopy
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array, as_generator
from ...problems import Plan
from ..tuning import share, whole
from .informed import Everywhere
from .rrt_star import grown, plan_of

USUAL = 4  # times that a node is hung somewhere, on the way to a large tree


class Rewirings(NamedTuple):
    """Every edge that a tree ever had, in the order in which they came: m of them, for n nodes.

    nodes : (n, d), in the order they came. node, parent : (m,), the ends of each edge.
    came, gone : (m,), the number of the new node with which it came, and of that with which it was
        replaced, n where it never was. An edge whose node is not the new one, but older, was
        rewired to it.
    radius : (n,), how far each node looked for neighbours when it was new, 0 for the root and the
        goal, which did not look.
    at_goal : the goal's node, or -1.
    """

    nodes: Array
    node: NDArray[np.int64]
    parent: NDArray[np.int64]
    came: NDArray[np.int64]
    gone: NDArray[np.int64]
    radius: Array
    at_goal: int


def rrt_star_rewirings(
    problem: Any,
    *,
    step: float | None = None,
    goal_bias: float = 0.05,
    gamma: float | None = None,
    max_nodes: int = 5_000,
    max_iterations: int | None = None,
    rng: int | np.random.Generator,
) -> tuple[Plan, Rewirings]:
    """The plan of `rrt_star`, whose arguments these are, and every edge that its tree had on the
    way.

    >>> from kinoedu import Point, PolygonWorld, Problem, rrt_star
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(9, 1))
    >>> plan, edges = rrt_star_rewirings(problem, max_nodes=500, rng=0)
    >>> plan.cost == rrt_star(problem, max_nodes=500, rng=0).cost
    True
    >>> last = edges.gone == len(plan.tree.nodes)
    >>> bool((plan.tree.parent[edges.node[last]] == edges.parent[last]).all())
    True
    """
    generator, rows = as_generator(rng), USUAL * whole(max_nodes, "max_nodes", least=1)
    sampler, unused = Everywhere(share(goal_bias, "goal_bias")), deepcopy(generator)
    growth = grown(
        "RRT*", problem, sampler, step, gamma, max_nodes, max_iterations, generator, rows
    )
    hung = int(growth.costs.hung[0])
    if hung > rows:  # once more, now that it is known how much room the log needs
        growth = grown(
            "RRT*", problem, sampler, step, gamma, max_nodes, max_iterations, unused, hung
        )
    n = int(growth.costs.tree.size[0])
    node, parent = growth.costs.log[:hung].T.copy()
    radius = growth.radii[:n].copy()
    radius[[0, growth.at_goal] if growth.at_goal >= 0 else [0]] = 0.0
    came, plan = np.maximum.accumulate(node), plan_of("RRT*", growth)
    nodes = growth.costs.tree.nodes[:n].copy()
    return plan, Rewirings(
        nodes, node, parent, came, replaced(node, came, n), radius, growth.at_goal
    )


def replaced(node: NDArray[np.int64], came: NDArray[np.int64], n: int) -> NDArray[np.int64]:
    """For each edge of a log when the next one of the same node came, n where there is none,
    (m,).
    """
    order = np.argsort(node, kind="stable")
    gone = np.full(len(node), n)
    again = node[order][1:] == node[order][:-1]
    gone[order[:-1][again]] = came[order[1:][again]]
    return gone
