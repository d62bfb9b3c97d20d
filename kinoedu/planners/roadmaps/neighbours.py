"""The nodes closest to each node of a roadmap."""

import numpy as np
from numpy.typing import NDArray

from ...geometry.checks import Array
from ...problems import ProblemRecord
from ...problems.protocols import PlanningProblem
from ...spaces import RealSpace, WrappingSpace
from ...spaces.buckets import empty_tree
from ...spaces.closest import add_nodes, k_closest_in_buckets, list_by_bucket

FEW = 4096


def k_closest(problem: PlanningProblem, nodes: Array, k: int) -> NDArray[np.int64]:
    """The k nodes closest to each of the nodes (n, d), nearest first, without the node itself.

    On the line, in the plane and where angles wrap, the nodes are kept in buckets: O(n) in the
    plane for nodes spread evenly. In R^n of more dimensions a k-d tree is used, O(n log n). In a
    space with nothing but a distance all distances are computed, O(n^2).

    Returns
    -------
    (n, min(k, n - 1)) array of node numbers.
    """
    k = min(k, len(nodes) - 1)
    space = getattr(problem, "space", None)
    if not isinstance(space, RealSpace | WrappingSpace):
        apart = np.array([[problem.distance(a, b) for b in nodes] for a in nodes])
        np.fill_diagonal(apart, np.inf)
        return np.argsort(apart, axis=1, kind="stable")[:, :k]
    if nodes.shape[1] <= 2 or isinstance(space, WrappingSpace):
        tree = empty_tree(len(nodes), nodes.min(axis=0), nodes.max(axis=0))
        add_nodes(tree, nodes)
        return k_closest_in_buckets(space, tree, k)
    from scipy.spatial import cKDTree

    _, found = cKDTree(nodes).query(nodes, k=k + 1)
    found = np.asarray(found, np.int64).reshape(len(nodes), k + 1)
    others = found != np.arange(len(nodes))[:, None]
    # among many nodes at one place a node may not be among its own neighbours
    others[others.all(axis=1), -1] = False
    return found[others].reshape(len(nodes), k)


def visiting_order(problem: PlanningProblem, nodes: Array) -> NDArray[np.int64]:
    """An order of the nodes (n, d) in which many that are close follow one another, (n,).

    What is read for one of them is then in the processor's caches for the next. Few nodes fit into
    the caches anyway, and keep their order. So do the nodes of a recorder or of a reader's own
    problem, because there the order of the queries can be seen.
    """
    if not isinstance(problem, ProblemRecord) or len(nodes) <= FEW:
        return np.arange(len(nodes))
    tree = empty_tree(len(nodes), nodes.min(axis=0), nodes.max(axis=0))
    add_nodes(tree, nodes)
    return list_by_bucket(tree)
