"""The "break it" exercise of lesson 2: find a world in which a mended Bug 0 fails.

The goal must be reachable in that world.
"""

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import ArrayLike

from ....errors import KinoeduError
from ....messages import get_message
from ....planners import bug2
from ....planners.bugs import BugRobot
from ....planners.bugs.walk import plan_walk
from ....problems import Plan
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Record, Together, Value
from .walks import POINT, POLYGON

FEWEST, MOST = 4, 100  # vertices; convex obstacles never lead the bug back, so 3 are too few
FAR = 1e4


class ExposeMendedBug(Exercise):
    """Find a start, a goal and obstacles with which `mended_bug0` does not arrive."""

    name = "exposing_problem"
    lesson = "02_bug_algorithms"
    kinds = ("valid", "exposes", "smallest")
    given = Record()
    answer = Together((POINT, POINT, Listed(POLYGON)))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The same question three times; each case demands more of the answer."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check that the goal is reachable, that the program fails, and the number of vertices."""
        start, goal, obstacles = value
        rule = world_fault(start, goal, obstacles)
        if not rule and case.kind != "valid":
            arrives = mended_bug0(start, goal, obstacles, FAR).path is not None
            if arrives:
                rule = "exposes"
            elif case.kind == "smallest" and count_vertices(obstacles) > FEWEST:
                rule = "smallest"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Description of what the case asks for."""
        return get_message(f"exposing_problem.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the world, and the walk of the program in it."""
        from ....figures import palette, plane

        fault = world_fault(*outcome.value) if isinstance(outcome, Answer) else "range"
        if not isinstance(outcome, Answer) or fault == "range":
            plane.frame([(0, 0), (1, 1)], ax)
            plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
            return
        start, goal, obstacles = outcome.value
        plane.frame(np.vstack([start, goal, *obstacles]), ax, margin=0.15)
        for obstacle in filter(len, obstacles):
            plane.polygon(obstacle, ax, numbers=False)
        walk = None if fault == "valid" else mended_bug0(start, goal, obstacles, FAR).walk
        if walk is not None:
            ax.plot(*walk.points.T, "--", color=palette.YOURS, linewidth=2.5, zorder=4)
        plane.dot(start, "start", ax, colour=palette.START)
        plane.dot(goal, "goal", ax, colour=palette.GOAL, marker="*")
        plane.title(self.message("picture"), ax)


def count_vertices(obstacles: list[Value]) -> int:
    """Number of vertices of all obstacles."""
    return sum(map(len, obstacles))


def world_fault(start: Value, goal: Value, obstacles: list[Value]) -> str:
    """Key of the rule that makes the world invalid, or ""."""
    if count_vertices(obstacles) > MOST:
        return "range"
    numbers = np.vstack([start, goal, *obstacles])
    if not (np.abs(numbers) <= FAR).all():
        return "range"
    try:
        mended_bug0(start, goal, obstacles, FAR)
        return "way" if bug2(start, goal, obstacles, FAR).path is None else ""
    except KinoeduError:
        return "valid"


REASONS = (
    "",
    "it walks in a circle forever: it hit the same wall at the same point again",
    "it went round the obstacle and could not leave it anywhere",
)
REACHED, IN_A_CIRCLE, SHUT_IN = range(3)


def mended_bug0_walk(robot: BugRobot) -> int:
    """Bug 0, mended: it leaves a wall only where the goal is nearer than it was at the start.

    It is wrong somewhere. Where?
    """
    start = robot.place
    while not robot.move_to_goal():
        if robot.was_hit_before():
            return IN_A_CIRCLE
        hit = robot.place
        while not (robot.can_move_to_goal() and robot.place.is_nearer_than(start)):
            robot.follow_wall()
            if robot.place == hit:
                return SHUT_IN
    return REACHED


def mended_bug0(
    start: ArrayLike, goal: ArrayLike, obstacles: Iterable[ArrayLike], step: float
) -> Plan:
    """Plan of `mended_bug0_walk`, turning left.

    Arguments, result and errors are those of `kinoedu.bug0`.

    >>> mended_bug0((0, 0), (4, 0), [[(1, -1), (2, -1), (2, 2), (1, 2)]], step=9).path.tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 2.0], [2.0, 2.0], [4.0, 0.0]]
    """
    return plan_walk(
        "Bug 0, mended", mended_bug0_walk, REASONS, start, goal, obstacles, step, "left", 0.0
    )
