"""The nodes of a growing tree near a configuration, for any problem with a distance."""

import numpy as np
from numpy.typing import NDArray

from ...compiled import generic
from ...geometry.checks import Array
from ...problems import ProblemRecord, Recorder
from ...problems.protocols import PlanningProblem
from ...spaces import near
from ...spaces.buckets import GrowingTree


@generic(1)
def near_nodes(
    problem: PlanningProblem, tree: GrowingTree, q: Array, radius: float
) -> NDArray[np.int64]:
    """The nodes within a radius of q, shape (k,); by a reader's own distance, in O(n)."""
    return np.flatnonzero(
        np.array([problem.distance(node, q) for node in tree.nodes[: tree.size[0]]]) <= radius
    )


@near_nodes.register(ProblemRecord)
def near_in_space(
    problem: ProblemRecord, tree: GrowingTree, q: Array, radius: float
) -> NDArray[np.int64]:
    """By the space, which may use buckets."""
    return near(problem.space, tree, q, radius)


@near_nodes.register(Recorder)
def near_as_recorded(
    problem: Recorder, tree: GrowingTree, q: Array, radius: float
) -> NDArray[np.int64]:
    """By the recorded problem, in the same order; nothing is recorded."""
    return near_nodes(problem.problem, tree, q, radius)
