"""What planners need of a problem, as types: the methods and fields that they use.

`ProblemRecord` and `Recorder` have all of them. An object of a reader's own needs those of
`ProblemLike`; `as_problem` adds the rest.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.checks import Array
from ..robots.car import CarRobot
from ..spaces.buckets import GrowingTree
from ..spaces.wrapping import WrappingSpace


class ProblemLike(Protocol):
    """A problem that a planner takes: the methods and fields that every planner needs."""

    @property
    def start(self) -> ArrayLike:
        """The first configuration."""

    @property
    def goal(self) -> ArrayLike:
        """The last configuration."""

    def sample(self, rng: np.random.Generator, /) -> ArrayLike:
        """A random configuration."""

    def distance(self, a: Array, b: Array, /) -> float:
        """The distance between two configurations."""

    def steer(self, a: Array, b: Array, step: float, /) -> ArrayLike:
        """The configuration at distance `step` from a on the way to b, or b if it is nearer."""

    def is_free_path(self, a: Array, b: Array, /) -> bool:
        """Whether the motion from a to b is free."""


class PlanningProblem(Protocol):
    """A problem that an algorithm uses: configurations are arrays, and motions are counted."""

    @property
    def start(self) -> Array:
        """The first configuration, shape (d,)."""

    @property
    def goal(self) -> Array:
        """The last configuration, shape (d,)."""

    @property
    def query_counts(self) -> NDArray[np.int64]:
        """The number of queries about motions and about configurations."""

    def sample(self, rng: np.random.Generator, /) -> Array:
        """A random configuration."""

    def distance(self, a: Array, b: Array, /) -> float:
        """The distance between two configurations."""

    def motion_cost(self, a: Array, b: Array, /) -> float:
        """The cost of the motion from a to b."""

    def steer(self, a: Array, b: Array, step: float, /) -> Array:
        """The configuration at distance `step` from a on the way to b, or b if it is nearer."""

    def nearest(self, tree: GrowingTree, q: Array, /) -> int:
        """The number of the tree node that is nearest to q."""

    def is_free(self, q: Array, /) -> bool:
        """Whether the robot at q touches nothing."""

    def is_free_path(self, a: Array, b: Array, /) -> bool:
        """Whether the motion from a to b is free."""


class CarProblem(PlanningProblem, Protocol):
    """The problem of a car, with the distance of SE(2)."""

    @property
    def robot(self) -> CarRobot:
        """The car."""

    @property
    def space(self) -> WrappingSpace:
        """Poses (x, y, theta)."""

    def control(self, rng: np.random.Generator, /) -> tuple[float, float]:
        """A random control (v, phi)."""

    def curvature(self, phi: float, /) -> float:
        """The curvature of the arc that the car drives at a steering angle."""

    def drive(self, q: Array, v: float, phi: float, t: float, there: Array, /) -> None:
        """Write into `there` the pose after driving from q by (v, phi) for time t."""

    def is_free_drive(self, q: Array, v: float, phi: float, t: float, /) -> bool:
        """Whether the car touches nothing while it drives from q by (v, phi) for time t."""


class RoadmapLike(Protocol):
    """A roadmap of any planner."""

    @property
    def nodes(self) -> Array:
        """The configurations, shape (n, d)."""

    @property
    def edges(self) -> NDArray[np.int64]:
        """Pairs of node numbers, shape (m, 2)."""
