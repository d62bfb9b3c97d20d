"""The bodies of the planners' board: a scene, settings and a generator make a plan as it is shown.

Each does what the board of a lesson does with the same planner.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..compiled import algorithm, compiled, inlined
from ..geometry.checks import Array
from ..geometry.parts import box_of
from ..graphs.flat import GraphRecord, compress_rows
from ..graphs.search import begin_search, search
from ..planners.answers import cost_along
from ..planners.roadmaps.connecting import join_in_order
from ..planners.roadmaps.prm import distances_to, sample_free
from ..planners.trees.cost_tree import empty_costs
from ..planners.trees.informed import Everywhere
from ..planners.trees.rrt import grow
from ..planners.trees.rrt_connect import TRAPPED, grow_both, merge_trees, roomy_size
from ..planners.trees.rrt_star import grow_shortest, neighbour_radii
from ..problems import ProblemRecord
from ..robots.round import RoundRobot
from ..spaces import RealSpace
from ..spaces.buckets import GrowingTree, empty_tree, sparse_tree
from ..spaces.closest import add_nodes, k_closest_in_buckets
from .scenes import (
    FOUND,
    GOAL_NOT_FREE,
    RING_FAULT,
    START_NOT_FREE,
    SceneArrays,
    find_fault,
    without_obstacles,
    world_of_scene,
)

Numbers = NDArray[np.int64]

NOT_FOUND = 1  # the first status without a path; a body with more reasons counts on


class TreeSettings(NamedTuple):
    """The settings of RRT."""

    clearance: float
    step_size: float
    goal_bias: float
    max_nodes: float
    max_iterations: float


class StarSettings(NamedTuple):
    """The settings of RRT*."""

    clearance: float
    step_size: float
    goal_bias: float
    max_nodes: float
    max_iterations: float
    gamma: float


class PairSettings(NamedTuple):
    """The settings of RRT-Connect."""

    clearance: float
    step_size: float
    max_nodes: float
    max_iterations: float


class RoadmapSettings(NamedTuple):
    """The settings of PRM."""

    clearance: float
    n: float
    k: float


class ShownPlan(NamedTuple):
    """What is shown of a plan.

    facts : (5,), the status, cost, steps, iterations, nodes.
    edges, others : (m, 7), rows x, y, next x, next y, two numbers that the edge says when one
        points at it, the step at which it appears.
    dots : (n, 4), rows x, y and two numbers that the dot says.
    path : (k, 2), with no rows where there is none.
    """

    facts: Array
    edges: Array
    others: Array
    dots: Array
    path: Array


@algorithm
def show_rrt(scene: SceneArrays, settings: TreeSettings, rng: np.random.Generator) -> ShownPlan:
    """RRT among polygons and discs."""
    refused, problem = pose_problem(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_rrt(problem, settings, rng)


@algorithm
def show_rrt_star(
    scene: SceneArrays, settings: StarSettings, rng: np.random.Generator
) -> ShownPlan:
    """RRT* among polygons and discs."""
    refused, problem = pose_problem(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_rrt_star(problem, settings, rng)


@algorithm
def show_rrt_connect(
    scene: SceneArrays, settings: PairSettings, rng: np.random.Generator
) -> ShownPlan:
    """RRT-Connect among polygons and discs."""
    refused, problem = pose_problem(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_rrt_connect(problem, settings, rng)


@algorithm
def show_prm(scene: SceneArrays, settings: RoadmapSettings, rng: np.random.Generator) -> ShownPlan:
    """PRM among polygons and discs."""
    refused, problem = pose_problem(scene, settings.clearance)
    if refused.facts[0] != FOUND:
        return refused
    return plan_by_prm(problem, settings, rng)


# ---- the planners, in any world


@compiled
def plan_by_rrt(
    problem: ProblemRecord, settings: TreeSettings, rng: np.random.Generator
) -> ShownPlan:
    """A tree of RRT."""
    room, most = int(settings.max_nodes) + 1, int(settings.max_iterations)
    tree = empty_tree(room, problem.space.lo, problem.space.hi)
    at_goal, iterations = grow(problem, tree, settings.step_size, settings.goal_bias, most, rng)
    return show_tree(problem, tree, at_goal, iterations)


@compiled
def plan_by_rrt_star(
    problem: ProblemRecord, settings: StarSettings, rng: np.random.Generator
) -> ShownPlan:
    """A tree of RRT*."""
    eta, room, most = settings.step_size, int(settings.max_nodes), int(settings.max_iterations)
    space, radii = problem.space, neighbour_radii(settings.gamma, 2, room + 2, eta)
    costs = empty_costs(empty_tree(room + 1, space.lo, space.hi), 0)
    sampler = Everywhere(settings.goal_bias)
    at_goal, iterations = grow_shortest(problem, costs, sampler, eta, radii, most, rng)
    return show_tree(problem, costs.tree, at_goal, iterations)


@compiled
def plan_by_rrt_connect(
    problem: ProblemRecord, settings: PairSettings, rng: np.random.Generator
) -> ShownPlan:
    """The two trees of RRT-Connect."""
    room, space = int(settings.max_nodes), problem.space
    owner = np.empty(room, np.int64)
    one = sparse_tree(room, roomy_size(room), space.lo, space.hi)
    other = sparse_tree(room, roomy_size(room), space.lo, space.hi)
    at_start, at_goal, iterations = grow_both(
        problem, one, other, owner, settings.step_size, int(settings.max_iterations), rng
    )
    grown = one.size[0] + other.size[0]
    nodes, parent, number = merge_trees(
        (one.nodes, other.nodes), (one.parent, other.parent), owner[:grown]
    )
    path = np.empty((0, 2))
    if at_start != TRAPPED:
        first = branch_to(nodes, parent, number[0, at_start])
        path = np.concatenate((first, branch_to(nodes, parent, number[1, at_goal])[-2::-1]))
    edges = tree_edges(nodes, parent, len(nodes))
    from_start = np.empty(len(edges), np.bool_)
    for k in range(len(edges)):
        from_start[k] = owner[int(edges[k, 4])] == 0
    none = np.empty((0, 4))
    shown = show_plan(problem, path, edges[from_start], none, grown, grown, iterations)
    return ShownPlan(shown.facts, shown.edges, edges[~from_start], shown.dots, shown.path)


@compiled
def plan_by_prm(
    problem: ProblemRecord, settings: RoadmapSettings, rng: np.random.Generator
) -> ShownPlan:
    """A roadmap of PRM, and the shortest path in it."""
    n = int(settings.n)
    sampled = sample_free(problem, n, 100 * n, rng)
    nodes = np.concatenate((np.stack((problem.start, problem.goal)), sampled))
    pairs, costs = join_closest(problem, nodes, min(int(settings.k), len(nodes) - 1))
    first, to, weight = compress_rows(len(nodes), pairs, costs, 2)
    graph = GraphRecord(len(nodes), pairs, costs, first, to, weight)
    heuristic = distances_to(problem, nodes, problem.goal)
    labels, queue = begin_search(len(nodes), 0, heuristic)
    search(graph, 1, heuristic, labels, queue)
    path = branch_to(nodes, labels.parent, 1) if labels.cost[1] < np.inf else nodes[:0]
    edges, dots = np.empty((len(pairs), 7)), np.empty((len(nodes), 4))
    for k in range(len(pairs)):
        write_edge(edges, k, nodes, pairs[k, 0], pairs[k, 1])
        edges[k, 4], edges[k, 5], edges[k, 6] = pairs[k, 0], pairs[k, 1], k + 1
    for node in range(len(nodes)):
        dots[node, 0], dots[node, 1] = nodes[node, 0], nodes[node, 1]
        dots[node, 2], dots[node, 3] = node, first[node + 1] - first[node]
    shown = show_plan(problem, path, edges, dots, len(edges), len(nodes), 0)
    if len(path) == 0:
        reason = 0 if first[1] == 0 else 1 if first[2] == first[1] else 2
        shown.facts[0] = NOT_FOUND + reason
    return shown


@compiled
def join_closest(problem: ProblemRecord, nodes: Array, k: int) -> tuple[Numbers, Array]:
    """The edges of a roadmap that joins each node to its k closest nodes, and their costs."""
    lo, hi = box_of(nodes)
    tree = empty_tree(len(nodes), lo, hi)
    add_nodes(tree, nodes)
    to = k_closest_in_buckets(problem.space, tree, k)
    n = len(nodes)
    return join_in_order(problem, nodes, k * np.arange(n + 1), to.ravel(), np.arange(n))


# ---- the problem of a scene


@compiled
def pose_problem(scene: SceneArrays, clearance: float) -> tuple[ShownPlan, ProblemRecord]:
    """What is shown where a scene cannot be planned, else with the status FOUND; and its problem.

    A scene with a fault of a ring has the problem of its empty box, which nobody plans.
    """
    ring, fault = find_fault(scene)
    if ring >= 0:
        refused = show_no_plan(RING_FAULT - fault.kind, ring, fault.i, fault.j)
        return refused, problem_of(without_obstacles(scene), clearance)
    problem = problem_of(scene, clearance)
    return show_no_plan(find_end_in_contact(problem), 0, 0, 0), problem


@compiled
def show_no_plan(status: float, ring: int, first: int, second: int) -> ShownPlan:
    """The answer to a scene in which nothing can be planned."""
    facts = np.array([status, ring, first, second, 0.0])
    return ShownPlan(facts, np.empty((0, 7)), np.empty((0, 7)), np.empty((0, 4)), np.empty((0, 2)))


@compiled
def problem_of(scene: SceneArrays, clearance: float) -> ProblemRecord:
    """The problem of a scene whose first two handles are start and goal; they are not checked."""
    world, robot = world_of_scene(scene), RoundRobot(scene.handles[0, 2])
    start, goal = scene.handles[0, :2].copy(), scene.handles[1, :2].copy()
    space = RealSpace(world.lo, world.hi)
    return ProblemRecord(robot, world, space, start, goal, clearance, np.zeros(2, np.int64))


@compiled
def find_end_in_contact(problem: ProblemRecord) -> int:
    """START_NOT_FREE or GOAL_NOT_FREE, or FOUND where both are free."""
    if not problem.is_free(problem.start):
        return START_NOT_FREE
    return FOUND if problem.is_free(problem.goal) else GOAL_NOT_FREE


# ---- a plan as it is shown


@compiled
def show_tree(
    problem: ProblemRecord, tree: GrowingTree, at_goal: int, iterations: int
) -> ShownPlan:
    """A tree and the path to its node at the goal."""
    edges = tree_edges(tree.nodes, tree.parent, tree.size[0])
    path = branch_to(tree.nodes, tree.parent, at_goal) if at_goal >= 0 else tree.nodes[:0].copy()
    size = tree.size[0]
    return show_plan(problem, path, edges, np.empty((0, 4)), size, size, iterations)


@compiled
def show_plan(
    problem: ProblemRecord,
    path: Array,
    edges: Array,
    dots: Array,
    steps: int,
    nodes: int,
    iterations: float,
) -> ShownPlan:
    """A plan as it is shown."""
    found = len(path) > 0
    cost = cost_along(problem, path) if found else np.inf
    status = FOUND if found else NOT_FOUND
    facts = np.array([status, cost, steps, iterations, nodes])
    return ShownPlan(facts, edges.copy(), np.empty((0, 7)), dots.copy(), path.copy())


@compiled
def tree_edges(nodes: Array, parent: Numbers, size: int) -> Array:
    """The edges of a tree, which say their node and its parent; node k appears at step k + 1."""
    edges, m = np.empty((size, 7)), 0
    for node in range(size):
        if parent[node] >= 0:
            write_edge(edges, m, nodes, parent[node], node)
            edges[m, 4], edges[m, 5], edges[m, 6] = node, parent[node], node + 1
            m += 1
    return edges[:m].copy()


@inlined
def write_edge(edges: Array, row: int, nodes: Array, u: int, v: int) -> None:
    """Write where the edge from node u to node v lies."""
    edges[row, 0], edges[row, 1] = nodes[u, 0], nodes[u, 1]
    edges[row, 2], edges[row, 3] = nodes[v, 0], nodes[v, 1]


@compiled
def branch_to(nodes: Array, parent: Numbers, node: int) -> Array:
    """The places of the nodes from the root to a node, (k, 2)."""
    return nodes[numbers_to(parent, node)]


@compiled
def numbers_to(parent: Numbers, node: int) -> Numbers:
    """The nodes from the root to a node, (k,)."""
    size, above = 1, parent[node]
    while above >= 0:
        size, above = size + 1, parent[above]
    branch = np.empty(size, np.int64)
    for k in range(size - 1, -1, -1):
        branch[k], node = node, parent[node]
    return branch
