"""A problem joins a robot, a world, a start and a goal, and answers the queries of a planner.

Planners do not use robots or worlds directly. They call `problem.sample(rng)`, `.distance(a, b)`,
`.steer(a, b, step)`, `.is_free(q)`, `.is_free_path(a, b)`, `.nearest(tree, q)` and `.motion_cost(a,
b)`. Planners that walk along obstacles also call `.is_semi_free_path(a, b)`; planners that drive
call `.control(rng)`, `.drive(...)` and `.is_free_drive(...)`. They read `problem.start` and
`problem.goal`. So one planner works for every robot in every world, and for any other object that
has these methods and fields.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..collision import (
    check_cost,
    is_free,
    is_free_drive,
    is_free_path,
    is_semi_free_path,
    motion_cost,
)
from ..compiled import record
from ..errors import InvalidGoal, InvalidStart
from ..geometry.checks import Array, nonnegative
from ..messages import get_message
from ..robots.controls import control, curvature, drive
from ..robots.kinds import Robot
from ..spaces import distance, interpolate, nearest, sample
from ..spaces.buckets import GrowingTree
from ..support.constructors import Constructor, with_type_names
from ..worlds.checks import World, check_size, check_world
from .configurations import as_configuration, explain_not_free, space_of

# indices of ProblemRecord.query_counts: the queries about motions and about configurations
MOTIONS, PLACES = 0, 1


@with_type_names
@record
class ProblemRecord(NamedTuple):
    """The record that `Problem` returns. Configurations have shape (d,), float64.

    `query_counts` counts the collision queries: query_counts[MOTIONS] for motions,
    query_counts[PLACES] for configurations.
    """

    robot: Any  # of any kind; a planner that needs a special kind checks for it
    world: Any
    space: Any
    start: Array
    goal: Array
    clearance: float
    query_counts: NDArray[np.int64]

    def sample(self, rng: np.random.Generator) -> Array:
        """A configuration drawn uniformly from the space, free or not."""
        return sample(self.space, rng)

    def distance(self, a: Array, b: Array) -> float:
        """The distance between two configurations."""
        return distance(self.space, a, b)

    def motion_cost(self, a: Array, b: Array) -> float:
        """The cost of the motion from a to b: its length, or the integral of a terrain's cost."""
        return motion_cost(self.robot, self.world, self.space, a, b)

    def steer(self, a: Array, b: Array, step: float) -> Array:
        """The configuration at distance `step` from a on the way to b, or b if it is nearer."""
        length = distance(self.space, a, b)
        return b.copy() if length <= step else interpolate(self.space, a, b, step / length)

    def nearest(self, tree: GrowingTree, q: Array) -> int:
        """The number of the tree node that is nearest to q."""
        return nearest(self.space, tree, q)

    def is_free(self, q: Array) -> bool:
        """Whether the robot at q touches nothing."""
        self.query_counts[PLACES] += 1
        return is_free(self.robot, self.world, q, self.clearance)

    def is_free_path(self, a: Array, b: Array) -> bool:
        """Whether the robot touches nothing during the whole motion from a to b."""
        self.query_counts[MOTIONS] += 1
        return is_free_path(self.robot, self.world, a, b, self.clearance)

    def is_semi_free_path(self, a: Array, b: Array) -> bool:
        """Whether the robot enters no obstacle on the motion from a to b; contact is allowed."""
        self.query_counts[MOTIONS] += 1
        return is_semi_free_path(self.robot, self.world, a, b, self.clearance)

    def control(self, rng: np.random.Generator) -> tuple[float, float]:
        """A random control (v, phi), for a robot that is driven."""
        return control(self.robot, rng)

    def curvature(self, phi: float) -> float:
        """The curvature of the arc that the robot drives at a steering angle."""
        return curvature(self.robot, phi)

    def drive(self, q: Array, v: float, phi: float, t: float, there: Array) -> None:
        """Write into `there` the configuration after driving from q by (v, phi) for time t."""
        drive(self.robot, q, v, phi, t, there)

    def is_free_drive(self, q: Array, v: float, phi: float, t: float) -> bool:
        """Whether the robot touches nothing while it drives from q by (v, phi) for time t."""
        self.query_counts[MOTIONS] += 1
        return is_free_drive(
            self.robot, self.world, q, v * t, curvature(self.robot, phi), self.clearance
        )


class Problem(ProblemRecord, metaclass=Constructor):
    """Define a planning problem: a robot, a world, a start and a goal.

    Parameters
    ----------
    robot : Point(), Disk(radius), TranslatingPolygon(vertices), RigidPolygon(vertices),
        TwoLinkArm(l1, l2, width), ...
    world : PolygonWorld(...), Terrain(...) or the result of read_world(path).
    start, goal : free configurations, shape (d,): (x, y); (x, y, theta) for a robot that turns; the
        angles of an arm.
    clearance : the whole robot keeps more than this distance from every obstacle, in the world's
        unit of length.

    Returns
    -------
    ProblemRecord

    Raises
    ------
    InvalidStart, InvalidGoal
        Where the start or the goal is not free.
    InvalidPoint, InvalidParameter, InvalidWorld
        Where another argument is not valid.

    Examples
    --------
    >>> from kinoedu.robots import Point
    >>> from kinoedu.worlds import PolygonWorld
    >>> wall = [(4, 0), (6, 0), (6, 8), (4, 8)]
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [wall])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(9, 1))
    >>> problem.is_free_path(problem.start, problem.goal)
    False
    >>> problem.distance(problem.start, problem.goal)
    8.0
    """

    def __new__(  # type: ignore[misc]  # returns the record
        cls,
        robot: Robot,
        world: World,
        start: ArrayLike,
        goal: ArrayLike,
        *,
        clearance: float = 0.0,
    ) -> ProblemRecord:
        margin = nonnegative(clearance, "clearance")
        check_world(world)
        check_size(world)
        space = space_of(robot, world)
        check_cost(robot, world)
        q_start, q_goal = (
            as_configuration(start, space, "start"),
            as_configuration(goal, space, "goal"),
        )
        problem = ProblemRecord(robot, world, space, q_start, q_goal, margin, np.zeros(2, np.int64))
        for q, name, error in ((q_start, "start", InvalidStart), (q_goal, "goal", InvalidGoal)):
            if not problem.is_free(q):
                why = explain_not_free(robot, world, q, margin)
                raise error(get_message(f"not_free.{name}", q=tuple(q.tolist()), why=why))
        problem.query_counts[:] = 0
        return problem
