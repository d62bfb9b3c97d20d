"""Adapters that let a planner use any problem: ours, a recorder, or a reader's own object."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ..errors import InvalidParameter, InvalidPoint
from ..geometry.checks import Array, as_array
from ..problems import MOTIONS, ProblemRecord
from ..problems.configurations import as_configuration
from ..problems.protocols import PlanningProblem, ProblemLike
from ..problems.recorder import unwrap_recorder
from ..robots.round import RoundRobot
from ..spaces import diameter
from ..spaces.buckets import GrowingTree, sparse_tree
from ..worlds.polygon_world import PolygonWorldRecord
from .tuning import positive


class OwnProblem:
    """A reader's own problem, with checked answers.

    Methods that the reader's object may leave out are added: `motion_cost`, `is_free`, `nearest`,
    and the count of motions checked.
    """

    NEEDED = ("start", "goal", "sample", "distance", "steer", "is_free_path")

    def __init__(self, problem: ProblemLike) -> None:
        missing = [name for name in self.NEEDED if not hasattr(problem, name)]
        if missing:
            given = type(problem).__name__
            raise InvalidParameter(
                f"a problem needs {', '.join(self.NEEDED)}; this {given} lacks {', '.join(missing)}"
            )
        self.problem = problem
        self.start = np.atleast_1d(as_array(problem.start, "start"))
        if self.start.ndim != 1:
            raise InvalidPoint(f"start must be a row of numbers, got shape {self.start.shape}")
        self.goal = self._configuration(problem.goal, "goal")
        self.query_counts = np.zeros(2, np.int64)

    def _configuration(self, value: ArrayLike, name: str) -> Array:
        """A configuration with the shape of the start; raises InvalidPoint otherwise."""
        q = np.atleast_1d(as_array(value, name))
        if q.shape != self.start.shape:
            raise InvalidPoint(
                f"{name} must have the start's shape {self.start.shape}, got {q.shape}"
            )
        return q

    def sample(self, rng: np.random.Generator) -> Array:
        """The reader's sample, checked."""
        return self._configuration(self.problem.sample(rng), "sample")

    def steer(self, a: Array, b: Array, step: float) -> Array:
        """The reader's configuration on the way from a to b, checked."""
        return self._configuration(self.problem.steer(a, b, step), "steer")

    def distance(self, a: Array, b: Array) -> float:
        """The reader's distance, checked."""
        d = as_array(self.problem.distance(a, b), "distance")
        if d.ndim or d < 0.0:
            raise InvalidParameter(f"distance must be one number, zero or more, got {d}")
        return float(d)

    def motion_cost(self, a: Array, b: Array) -> float:
        """The reader's cost, checked; by default the distance."""
        own = getattr(self.problem, "motion_cost", None)
        if own is None:
            return self.distance(a, b)
        c = np.asarray(own(a, b), np.float64)
        if c.ndim or not c >= 0.0:
            raise InvalidParameter(f"motion_cost must be one number, zero or more, got {c}")
        return float(c)

    def is_free(self, q: Array) -> bool:
        """The reader's answer; by default whether the motion from q to q is free."""
        own = getattr(self.problem, "is_free", None)
        return bool(np.all(self.problem.is_free_path(q, q) if own is None else own(q)))

    def is_free_path(self, a: Array, b: Array) -> bool:
        """The reader's answer; the call is counted."""
        self.query_counts[MOTIONS] += 1
        return bool(np.all(self.problem.is_free_path(a, b)))

    def nearest(self, tree: GrowingTree, q: Array) -> int:
        """The node nearest to q by the reader's distance; ties go to the first node."""
        return int(np.argmin([self.distance(node, q) for node in tree.nodes[: tree.size[0]]]))


def as_problem(problem: Any) -> PlanningProblem:
    """The problem itself where it is ours or a recorder of ours; else a reader's object, checked.

    Raises
    ------
    InvalidParameter
        Where a reader's object lacks a method.
    InvalidPoint
        Where its start or goal is not a configuration.
    """
    inner = unwrap_recorder(problem)
    return problem if isinstance(inner, ProblemRecord) else OwnProblem(problem)


def count_checks(problem: PlanningProblem) -> int:
    """How many motions the problem has checked so far."""
    return int(problem.query_counts[MOTIONS])


def world_size(problem: PlanningProblem) -> float:
    """The diameter of the space; for a reader's object the distance from start to goal."""
    space = getattr(problem, "space", None)
    if space is None:
        return float(problem.distance(problem.start, problem.goal)) or 1.0
    return float(diameter(space))


def as_step_size(problem: PlanningProblem, value: object, name: str) -> float:
    """A length, checked; by default a twentieth of `world_size`.

    Raises
    ------
    InvalidParameter
        Where it is neither None nor a positive number.
    """
    return positive(world_size(problem) / 20.0 if value is None else value, name)


def in_space(problem: PlanningProblem, q: Array) -> Array:
    """A configuration (d,) with its angles in [-pi, pi); of a reader's own problem, as it is."""
    inner = unwrap_recorder(problem)
    return as_configuration(q, inner.space, "q") if isinstance(inner, ProblemRecord) else q


def new_tree(problem: PlanningProblem, capacity: int, expected: int | None = None) -> GrowingTree:
    """An empty tree for configurations of the problem; `expected` as in `sparse_tree`."""
    space, nodes = getattr(problem, "space", None), capacity if expected is None else expected
    if space is None:
        return sparse_tree(capacity, nodes, problem.start, problem.start)
    return sparse_tree(capacity, nodes, space.lo, space.hi)


def check_exact(problem: PlanningProblem, planner: str) -> None:
    """Check that a point is to move among polygons without clearance, as exact planners need it.

    Raises
    ------
    InvalidParameter
        Where the problem is of another kind.
    """
    inner = unwrap_recorder(problem)
    if not isinstance(inner, ProblemRecord) or not isinstance(inner.world, PolygonWorldRecord):
        raise InvalidParameter(
            f"{planner} needs a Problem(Point(), PolygonWorld(...), start, goal)"
        )
    if not isinstance(inner.robot, RoundRobot) or inner.robot.radius + inner.clearance > 0.0:
        raise InvalidParameter(
            f"{planner} moves a point without clearance; for a disk or a margin grow the "
            "obstacles first, and then plan for Point()"
        )


def as_two_way_problem(problem: ProblemLike, planner: str) -> PlanningProblem:
    """Convert as `as_problem` does, for a planner that uses its edges in both directions.

    Raises
    ------
    InvalidParameter
        Where the robot only drives forward, or a reader's object lacks a method.
    InvalidPoint
        Where the start or goal of a reader's object is not a configuration.
    """
    problem = as_problem(problem)
    if not getattr(getattr(problem, "space", None), "both_ways", True):
        raise InvalidParameter(
            f"{planner} uses its edges both ways, and this robot only goes forward; plan with rrt"
        )
    return problem
