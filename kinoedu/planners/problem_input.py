"""Adapters that let a planner use any problem: one of this package, a recorder of one, or a
reader's own object.
"""

from typing import Any

import numpy as np

from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import Array, as_array
from ..problems import MOTIONS, ProblemRecord, Recorder
from ..robots.round import RoundRobot
from ..spaces import diameter
from ..spaces.buckets import GrowingTree, empty_tree
from ..worlds.polygon_world import PolygonWorldRecord


class OwnProblem:
    """A reader's own problem object, every answer checked, and with what it leaves out: the nearest
    node, a count of checks.
    """

    NEEDED = ("start", "goal", "sample", "distance", "steer", "is_free_path")

    def __init__(self, problem: Any) -> None:
        missing = [name for name in self.NEEDED if not hasattr(problem, name)]
        if missing:
            given = type(problem).__name__
            raise InvalidParameter(
                f"a problem must answer {', '.join(self.NEEDED)}; this {given} lacks "
                f"{', '.join(missing)}"
            )
        self.problem = problem
        self.start = np.atleast_1d(as_array(problem.start, "start"))
        self.goal = self._configuration(problem.goal, "goal")
        self.asked = np.zeros(2, np.int64)

    def _configuration(self, value: Any, name: str) -> Array:
        """A configuration of the start's shape."""
        q = np.atleast_1d(as_array(value, name))
        if q.shape != self.start.shape or q.ndim != 1:
            raise InvalidPoint(
                f"{name} must have the start's shape {self.start.shape}, got {q.shape}"
            )
        return q

    def sample(self, rng: np.random.Generator) -> Array:
        """The reader's sample."""
        return self._configuration(self.problem.sample(rng), "sample")

    def steer(self, a: Array, b: Array, step: float) -> Array:
        """The reader's step."""
        return self._configuration(self.problem.steer(a, b, step), "steer")

    def distance(self, a: Array, b: Array) -> float:
        """The reader's distance."""
        d = as_array(self.problem.distance(a, b), "distance")
        if d.ndim or d < 0.0:
            raise InvalidParameter(f"distance must be one number, zero or more, got {d}")
        return float(d)

    def motion_cost(self, a: Array, b: Array) -> float:
        """The reader's cost, or the distance."""
        own = getattr(self.problem, "motion_cost", None)
        if own is None:
            return self.distance(a, b)
        c = np.asarray(own(a, b), np.float64)
        if c.ndim or not c >= 0.0:
            raise InvalidParameter(f"motion_cost must be one number, zero or more, got {c}")
        return float(c)

    def is_free(self, q: Array) -> bool:
        """The reader's answer, or a motion that stays where it is."""
        own = getattr(self.problem, "is_free", None)
        return bool(np.all(self.problem.is_free_path(q, q) if own is None else own(q)))

    def is_free_path(self, a: Array, b: Array) -> bool:
        """The reader's answer, counted."""
        self.asked[MOTIONS] += 1
        return bool(np.all(self.problem.is_free_path(a, b)))

    def nearest(self, tree: GrowingTree, q: Array) -> int:
        """The first of the nodes nearest by the reader's distance."""
        return int(np.argmin([self.distance(node, q) for node in tree.nodes[: tree.size[0]]]))


def askable(problem: Any) -> Any:
    """The problem itself where it is this package's, or a recorder of one; otherwise a reader's
    object, checked and made whole.
    """
    inner = problem.problem if isinstance(problem, Recorder) else problem
    return problem if isinstance(inner, ProblemRecord) else OwnProblem(problem)


def world_size(problem: Any) -> float:
    """The diameter of the problem's space; for a reader's object the distance from start to
    goal.
    """
    space = getattr(problem, "space", None)
    if space is None:
        return float(problem.distance(problem.start, problem.goal)) or 1.0
    return float(diameter(space))


def new_tree(problem: Any, capacity: int) -> GrowingTree:
    """An empty tree for the problem's configurations."""
    space = getattr(problem, "space", None)
    if space is None:
        return empty_tree(capacity, problem.start, problem.start)
    return empty_tree(capacity, space.lo, space.hi)


def check_exact(problem: Any, planner: str) -> None:
    """Raise InvalidParameter unless a point is to move among polygons, without a margin: what exact
    planners are for.
    """
    inner = problem.problem if isinstance(problem, Recorder) else problem
    if not isinstance(inner, ProblemRecord) or not isinstance(inner.world, PolygonWorldRecord):
        raise InvalidParameter(
            f"{planner} needs a Problem(Point(), PolygonWorld(...), start, goal)"
        )
    if not isinstance(inner.robot, RoundRobot) or inner.robot.radius + inner.clearance > 0.0:
        raise InvalidParameter(
            f"{planner} moves a point without clearance; for a disk or a margin grow the "
            "obstacles first, and then plan for Point()"
        )


def both_ways(problem: Any, planner: str) -> Any:
    """`askable`, for a planner whose edges are used both ways. Raises InvalidParameter for a robot
    that only goes forward.
    """
    asked = askable(problem)
    if not getattr(getattr(asked, "space", None), "both_ways", True):
        raise InvalidParameter(
            f"{planner} uses its edges both ways, and this robot only goes forward; plan with rrt"
        )
    return asked
