"""Who a planner asks: a problem of this package, a recorder of one, or a reader's own object, all through the same names."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ..compiled import Compiled
from ..errors import InvalidParameter
from ..geometry.checks import Array, as_array
from ..problems import MOTIONS, ProblemRecord, Recorder
from ..spaces.buckets import GrowingTree, empty_tree


class OwnProblem:
    """A reader's own problem object, with what it leaves out: arrays for start and goal, the nearest node, a count of checks."""

    NEEDED = ("start", "goal", "sample", "distance", "steer", "is_free_path")

    def __init__(self, problem: Any) -> None:
        missing = [name for name in self.NEEDED if not hasattr(problem, name)]
        if missing:
            raise InvalidParameter(
                f"a problem must answer {', '.join(self.NEEDED)}; this {type(problem).__name__} lacks {', '.join(missing)}"
            )
        self.problem = problem
        self.start, self.goal = as_array(problem.start, "start"), as_array(problem.goal, "goal")
        self.asked = np.zeros(2, np.int64)

    def __getattr__(self, name: str) -> Any:
        return getattr(self.problem, name)

    def is_free_path(self, a: Array, b: Array) -> bool:
        """The reader's answer, counted."""
        self.asked[MOTIONS] += 1
        return bool(self.problem.is_free_path(a, b))

    def nearest(self, tree: GrowingTree, q: Array) -> int:
        """The first of the nodes nearest by the reader's distance."""
        return int(np.argmin([self.problem.distance(node, q) for node in tree.nodes[: tree.size[0]]]))


def askable(problem: Any) -> Any:
    """The problem itself where it is this package's, otherwise a reader's object made whole."""
    return problem if isinstance(problem, ProblemRecord | Recorder) else OwnProblem(problem)


def body_for(problem: Any, body: Compiled) -> Callable[..., Any]:
    """The compiled body for a problem that is a record; the interpreted one, the same lines, for anything else."""
    return body if isinstance(problem, ProblemRecord) else body.py_func


def world_size(problem: Any) -> float:
    """The diagonal of the problem's space; for a reader's object the distance from start to goal."""
    space = getattr(problem, "space", None)
    if space is None:
        return float(problem.distance(problem.start, problem.goal)) or 1.0
    return float(np.sqrt(((space.hi - space.lo) ** 2).sum()))


def new_tree(problem: Any, capacity: int) -> GrowingTree:
    """An empty tree for the problem's configurations."""
    space = getattr(problem, "space", None)
    if space is None:
        return empty_tree(capacity, problem.start, problem.start)
    return empty_tree(capacity, space.lo, space.hi)
