"""The history of an RRT*: every edge that its tree ever had, and when."""

from copy import deepcopy
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array, as_generator
from ...problems import Plan
from ...problems.protocols import PlanningProblem
from ..tuning import fraction, integer
from .informed import Everywhere
from .rrt_star import grow_rrt_star, plan_from_growth

EDGES_PER_NODE = 4  # usual number of edges that a node has had when a large tree is done


class Rewirings(NamedTuple):
    """Every edge that a tree ever had, in the order of creation: m edges for n nodes.

    nodes : (n, d), in the order of creation.
    node, parent : (m,), the ends of each edge.
    created_at : (m,), the number of the new node with which the edge was made. Where it is not
        `node` itself, the older `node` was rewired to the new one.
    replaced_at : (m,), the number of the new node with which the edge was replaced; n where it
        never was.
    radius : (n,), the radius within which each new node looked for neighbours; 0 for the root and
        the goal, which did not look for any.
    at_goal : the goal's node, or -1.
    """

    nodes: Array
    node: NDArray[np.int64]
    parent: NDArray[np.int64]
    created_at: NDArray[np.int64]
    replaced_at: NDArray[np.int64]
    radius: Array
    at_goal: int


def rrt_star_rewirings(
    problem: PlanningProblem,
    *,
    step_size: float | None = None,
    goal_bias: float = 0.05,
    gamma: float | None = None,
    max_nodes: int = 5_000,
    max_iterations: int | None = None,
    rng: int | np.random.Generator,
) -> tuple[Plan, Rewirings]:
    """The plan of `rrt_star`, which has the same arguments, and every edge that its tree ever had.

    Examples
    --------
    >>> from kinoedu import Point, PolygonWorld, Problem, rrt_star
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(9, 1))
    >>> plan, edges = rrt_star_rewirings(problem, max_nodes=500, rng=0)
    >>> plan.cost == rrt_star(problem, max_nodes=500, rng=0).cost
    True
    >>> last = edges.replaced_at == len(plan.tree.nodes)
    >>> bool((plan.tree.parent[edges.node[last]] == edges.parent[last]).all())
    True
    """
    generator, rows = as_generator(rng), EDGES_PER_NODE * integer(max_nodes, "max_nodes", least=1)
    sampler, unused = Everywhere(fraction(goal_bias, "goal_bias")), deepcopy(generator)
    growth = grow_rrt_star(
        "RRT*", problem, sampler, step_size, gamma, max_nodes, max_iterations, generator, rows
    )
    attached = int(growth.costs.attached[0])
    if attached > rows:  # once more, now that it is known how much room the log needs
        growth = grow_rrt_star(
            "RRT*", problem, sampler, step_size, gamma, max_nodes, max_iterations, unused, attached
        )
    n = int(growth.costs.tree.size[0])
    node, parent = growth.costs.log[:attached].T.copy()
    radius = growth.radii[:n].copy()
    radius[[0, growth.at_goal] if growth.at_goal >= 0 else [0]] = 0.0
    created_at, plan = np.maximum.accumulate(node), plan_from_growth("RRT*", growth)
    nodes = growth.costs.tree.nodes[:n].copy()
    return plan, Rewirings(
        nodes,
        node,
        parent,
        created_at,
        find_replacements(node, created_at, n),
        radius,
        growth.at_goal,
    )


def find_replacements(
    node: NDArray[np.int64], created_at: NDArray[np.int64], n: int
) -> NDArray[np.int64]:
    """For each edge when the next edge of its node was made, (m,); n where there is none."""
    order = np.argsort(node, kind="stable")
    replaced_at = np.full(len(node), n)
    again = node[order][1:] == node[order][:-1]
    replaced_at[order[:-1][again]] = created_at[order[1:][again]]
    return replaced_at
