"""A plan is a planner's answer: a path, and the data structures in the order they were built."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..geometry.checks import Array
from ..robots.trajectory import DrivenTree, TrajectoryRecord
from ..support.constructors import with_type_names


@with_type_names
class Tree(NamedTuple):
    """A tree in the order it grew: nodes (n, d), the root first; parent (n,), -1 for the root."""

    nodes: Array
    parent: NDArray[np.int64]


def roots_of(parent: NDArray[np.int64]) -> NDArray[np.int64]:
    """The root of each node's tree, (n,).

    Examples
    --------
    >>> roots_of(np.array([-1, -1, 0, 1, 3]))
    array([0, 1, 0, 1, 1])
    """
    roots = np.where(parent < 0, np.arange(len(parent)), parent)
    while (roots[roots] != roots).any():
        roots = roots[roots]
    return roots


@with_type_names
class Roadmap(NamedTuple):
    """A roadmap in the order it grew: nodes (n, d), and edges (m, 2), pairs of node numbers."""

    nodes: Array
    edges: NDArray[np.int64]


@with_type_names
class CellsWithHeadings(NamedTuple):
    """The roadmap of `cells_with_headings`, in the order in which it grew.

    nodes : (n, 3), start, goal, and configurations at the centres of cells and at the midpoints of
        the walls between them.
    edges : (m, 2), pairs of nodes whose motion is free.
    empty : (k, 2), the places at which no heading is free.
    """

    nodes: Array
    edges: NDArray[np.int64]
    empty: Array


@with_type_names
class Walk(NamedTuple):
    """The walk of a bug, in order.

    points : (n, 2), at most one step apart.
    following : (n,), whether the bug followed a wall to reach each point.
    travelled : (n,), the length of the walk up to each point.
    distance_to_goal : (n,), the distance from each point to the goal.
    hit, leave : the numbers of the points where the bug hit a wall and where it left one.
    """

    points: Array
    following: NDArray[np.bool_]
    travelled: Array
    distance_to_goal: Array
    hit: NDArray[np.int64]
    leave: NDArray[np.int64]

    @property
    def hits(self) -> Array:
        """The points where the bug hit a wall, in order, shape (k, 2)."""
        return self.points[self.hit]

    @property
    def leaves(self) -> Array:
        """The points where the bug left a wall, in order, shape (m, 2)."""
        return self.points[self.leave]


@dataclass(frozen=True, eq=False)
class Plan:
    """The answer of a planner.

    path : (n, d) from start to goal, or None where none was found; `reason` then says why.
    cost : the length of the path, or the integral of the costs on a terrain with costs; infinite
        without a path.
    tree, roadmap, walk : the data structures that the planner built, in the order it built them.
    trajectory : for planners that drive, the controls that follow the path; without a path, the
        controls that lead to the pose nearest to the goal.
    stats : counts such as nodes, iterations, and checks (motions that were tested for collision).
    problem : the problem that was solved.
    planner : the name of the planner.
    """

    path: Array | None
    cost: float
    tree: Tree | DrivenTree | None = None
    roadmap: Any = None
    walk: Walk | None = None
    trajectory: TrajectoryRecord | None = None
    stats: dict[str, int] = field(default_factory=dict)
    reason: str = ""
    problem: Any = None
    planner: str = ""

    def __repr__(self) -> str:
        counts = ", ".join(f"{value:,} {name}" for name, value in self.stats.items())
        found = (
            f"path of {len(self.path)} points, {self.measure} {self.cost:.6g}"
            if self.path is not None
            else f"no path: {self.reason}"
        )
        return f"<Plan: {found}; {counts}>" if counts else f"<Plan: {found}>"

    @property
    def measure(self) -> str:
        """What the cost of a path is: its "length", or on a terrain with costs its "cost"."""
        world = getattr(self.problem, "world", None)
        return "cost" if np.size(getattr(world, "cost", ())) else "length"
