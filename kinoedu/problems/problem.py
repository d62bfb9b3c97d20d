"""A problem answers a planner's questions.

Planners never see robots or worlds. They ask: `problem.sample(rng)`, `.distance(a, b)`, `.steer(a,
b, step)`, `.is_free(q)`, `.is_free_path(a, b)`, `.nearest(tree, q)`, what a path is worth by
`.motion_cost(a, b)`, those that walk along obstacles `.is_semi_free_path(a, b)`, those that drive
`.control(rng)`, `.drive(...)` and `.is_free_drive(...)`, and read `problem.start` and
`problem.goal`. So one planner serves every robot in every world, and a reader's own object with
these names as well.
"""

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
from ..geometry.checks import Array, none_or_more
from ..robots.controls import control, curvature, drive
from ..spaces import distance, interpolate, nearest, sample
from ..worlds.checks import check_world
from .configurations import as_configuration, space_of, why_not_free

MOTIONS, PLACES = (
    0,
    1,
)  # what ProblemRecord.asked counts: is_free_path or is_semi_free_path, and is_free


@record
class ProblemRecord(NamedTuple):
    """What `Problem` makes. Configurations have shape (d,), float64."""

    robot: Any
    world: Any
    space: Any
    start: Array
    goal: Array
    clearance: float
    asked: NDArray[np.int64]

    def sample(self, rng: np.random.Generator) -> Array:
        """A configuration drawn uniformly, free or not."""
        return sample(self.space, rng)

    def distance(self, a: Array, b: Array) -> float:
        """The distance between two configurations."""
        return distance(self.space, a, b)

    def motion_cost(self, a: Array, b: Array) -> float:
        """What the motion from a to b costs: its length, and on a terrain with costs their integral
        along it.
        """
        return motion_cost(self.robot, self.world, self.space, a, b)

    def steer(self, a: Array, b: Array, step: float) -> Array:
        """The configuration at most `step` from a on the way to b."""
        whole = distance(self.space, a, b)
        return b.copy() if whole <= step else interpolate(self.space, a, b, step / whole)

    def nearest(self, tree: Any, q: Array) -> int:
        """The number of the tree's node nearest to q."""
        return nearest(self.space, tree, q)

    def is_free(self, q: Array) -> bool:
        """Whether the robot at q touches nothing."""
        self.asked[PLACES] += 1
        return is_free(self.robot, self.world, q, self.clearance)

    def is_free_path(self, a: Array, b: Array) -> bool:
        """Whether the whole motion from a to b touches nothing."""
        self.asked[MOTIONS] += 1
        return is_free_path(self.robot, self.world, a, b, self.clearance)

    def is_semi_free_path(self, a: Array, b: Array) -> bool:
        """Whether the motion from a to b enters nothing; contact is allowed."""
        self.asked[MOTIONS] += 1
        return is_semi_free_path(self.robot, self.world, a, b, self.clearance)

    def control(self, rng: np.random.Generator) -> tuple[float, float]:
        """A control (v, phi) at random, for a robot that is driven."""
        return control(self.robot, rng)

    def curvature(self, phi: float) -> float:
        """The curvature that a steering angle drives."""
        return curvature(self.robot, phi)

    def drive(self, q: Array, v: float, phi: float, t: float, there: Array) -> None:
        """Write into `there` where the control (v, phi), held for a time t, leads from q."""
        drive(self.robot, q, v, phi, t, there)

    def is_free_drive(self, q: Array, v: float, phi: float, t: float) -> bool:
        """Whether the robot, driven from q by the control (v, phi) for a time t, touches nothing
        all the way.
        """
        self.asked[MOTIONS] += 1
        return is_free_drive(
            self.robot, self.world, q, v * t, curvature(self.robot, phi), self.clearance
        )


def Problem(
    robot: Any, world: Any, start: ArrayLike, goal: ArrayLike, *, clearance: float = 0.0
) -> ProblemRecord:
    """The task: a robot, a world, and where it is to go from where.

    Parameters
    ----------
    robot : Point(), Disk(radius), TranslatingPolygon(vertices), RigidPolygon(vertices),
    TwoLinkArm(l1, l2, width), ...
    world : PolygonWorld(...), Terrain(...) or what read_world(path) returns. start, goal :
    configurations, shape (d,): (x, y); (x, y, theta) for what turns; an arm's angles. Both must be
    free.
    clearance : the whole robot keeps more than this away from every obstacle, in the world's unit
    of length.

    Raises InvalidStart, InvalidGoal, InvalidPoint, InvalidParameter.

    >>> from kinoedu.robots import Point
    >>> from kinoedu.worlds import PolygonWorld
    >>> world = PolygonWorld([(0, 0), (10, 0), (10, 10), (0, 10)], [[(4, 0), (6, 0), (6, 8), (4, 8)]])
    >>> problem = Problem(Point(), world, start=(1, 1), goal=(9, 1))
    >>> problem.is_free_path(problem.start, problem.goal), problem.distance(problem.start, problem.goal)
    (False, 8.0)
    """
    margin = none_or_more(clearance, "clearance")
    check_world(world)
    space = space_of(robot, world)
    check_cost(robot, world)
    q_start, q_goal = as_configuration(start, space, "start"), as_configuration(goal, space, "goal")
    problem = ProblemRecord(robot, world, space, q_start, q_goal, margin, np.zeros(2, np.int64))
    for q, name, error in ((q_start, "start", InvalidStart), (q_goal, "goal", InvalidGoal)):
        if not problem.is_free(q):
            raise error(
                f"the {name} {tuple(q.tolist())} is not free: "
                f"{why_not_free(robot, world, q, margin)}"
            )
    problem.asked[:] = 0
    return problem
