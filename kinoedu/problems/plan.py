"""A plan is a planner's answer: its path, and what was built on the way, in the order it was
built.
"""

from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..geometry.checks import Array
from ..robots.trajectory import DrivenTree, TrajectoryRecord


class Tree(NamedTuple):
    """A tree in the order it grew: nodes (n, d), the root first; parent (n,), -1 for the root."""

    nodes: Array
    parent: NDArray[np.int64]


class Roadmap(NamedTuple):
    """A roadmap in the order it grew: nodes (n, d), and edges (m, 2), pairs of node numbers."""

    nodes: Array
    edges: NDArray[np.int64]


class Walk(NamedTuple):
    """A bug's walk in its order: points (n, 2), at most a step apart; for each, shape (n,), whether
    it followed a wall to get there, how far it had come, and how far the goal was; and the numbers
    of the points where it hit and left walls."""

    points: Array
    following: NDArray[np.bool_]
    travelled: Array
    distance_to_goal: Array
    hit: NDArray[np.int64]
    leave: NDArray[np.int64]

    @property
    def hits(self) -> Array:
        """Where it came upon a wall, in order, shape (k, 2)."""
        return self.points[self.hit]

    @property
    def leaves(self) -> Array:
        """Where it left a wall, in order, shape (m, 2)."""
        return self.points[self.leave]


@dataclass(frozen=True, eq=False)
class Plan:
    """A planner's answer.

    path : (n, d) from start to goal, or None where none was found; then `reason` says why.
    cost : the path's length, or on a terrain with costs what it costs; infinite without a path.
    tree, roadmap, walk : what was built on the way, in the order it was built; the ones that the
        planner has.
    trajectory : of planners that drive, the controls that lead along the path; without a path, to
        the pose nearest to the goal.
    stats : counts such as nodes, iterations, and checks (motions judged).
    problem : what was asked; planner : who answered.
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
            f"path of {len(self.path)} points, length {self.cost:.6g}"
            if self.path is not None
            else f"no path: {self.reason}"
        )
        return f"<Plan: {found}; {counts}>"
