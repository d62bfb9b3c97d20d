"""The exercise `bug_base`. Bullo & Smith, chapter 1."""

from collections.abc import Iterator

import numpy as np

from ....geometry import point_polygon_distance
from ....geometry.checks import Array
from ....planners import bug_base
from ....problems import Plan
from ...exercise import Case, Given
from .walking import BOX, ME145, SMALL_STEPS, BugExercise, random_world, world
from .walks import Violation

UP = np.array([0.0, 1.0])
# the one to be hit is neither among the first two, nor the nearest to the start
FOUR = [BOX - (5.0, 0.0), BOX + 5.0 * UP, BOX, BOX - 6.0 * UP]


class BugBase(BugExercise):
    """Move towards the goal until it is reached or an obstacle is in the way."""

    name = "bug_base"
    kinds = ("free", "hit", "passes")
    source = staticmethod(bug_base)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """No obstacle, an obstacle in the way, and obstacles beside the way."""
        yield Case("free", world((0, 0), (6, 0), []))
        yield Case("hit", world((0, 0), (6, 0), [BOX]))
        yield Case("passes", world((0, 0), (6, 0), [BOX + 4.0 * UP, BOX - 5.0 * UP]))
        yield Case("hit", world((0, 0), (6, 0), [BOX + 4.0 * UP, BOX]))
        yield Case("hit", world((0, 0), (5, 3), ME145, 0.1))
        yield Case("hit", world((0, 0), (6, 0), FOUR))
        yield Case("free", {**SMALL_STEPS, "obstacles": []})
        yield Case("hit", SMALL_STEPS)
        yield Case("free", world((0, 0), (60, 45), []))
        for n in (1, 2, 3) * 4:
            case = self.random_case(rng, "hit", 1)
            given = random_world(rng, n)
            yield case
            yield Case("free", {**given, "obstacles": []})
            yield Case("passes", {**given, "obstacles": moved_aside(given)})

    def plans(self, given: Given) -> list[Plan]:
        """The plan of the straight walk."""
        return [bug_base(*given.values())]

    def end(self, given: Given, path: Array) -> Violation | None:
        """Violation where a path ends neither at the goal nor within a step of an obstacle."""
        near = 1.001 * given["step"]
        at_goal = np.linalg.norm(path[-1] - given["goal"]) <= near
        at_wall = any(
            point_polygon_distance(path[-1], obstacle) <= near for obstacle in given["obstacles"]
        )
        return None if at_goal or at_wall else Violation("end", len(path) - 1)


def moved_aside(given: Given) -> list[Array]:
    """Obstacles moved off the straight way, alternately to the left and to the right."""
    x, y = (given["goal"] - given["start"]) / np.linalg.norm(given["goal"] - given["start"])
    return [
        np.round(obstacle + (-1) ** i * 4.0 * np.array([-y, x]), 2)
        for i, obstacle in enumerate(given["obstacles"])
    ]
