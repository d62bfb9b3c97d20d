"""The exercise `bug1`. Bullo & Smith, chapter 1."""

from collections.abc import Iterator
from itertools import product

import numpy as np

from ....geometry import point_polygon_distance
from ....geometry.checks import Array
from ....geometry.paths import path_length
from ....planners import bug1
from ....planners.bugs.bug1 import bug1_walk
from ....problems import Plan
from ...exercise import Case, Given
from .walking import (
    BOX,
    ME145,
    SMALL_STEPS,
    TURNS,
    BugExercise,
    Choice,
    is_clear,
    turned_world,
    walk_of,
    walk_with_choices,
    world,
)

WIDE = np.array([(2, -3), (3, -3), (3, 3.6), (2, 3.6)], float)  # it leads away from the goal first
SMALL = np.array([(2, -0.2), (2.6, -0.2), (2.6, 0.4), (2, 0.4)], float)  # round it in few steps
TIED = 0.3  # ways that differ by less count as equally long


class Bug1(BugExercise):
    """Bug 1: go all the way round, return to the point nearest to the goal, and leave."""

    name = "bug1"
    kinds = ("free", "one", "many")
    source = staticmethod(bug1)
    variants = TURNS

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """No obstacle, one, and several."""
        for goal in ((3, 4), (-2, 0.5), (0, 1.02)):
            yield Case("free", world((0, 0), goal, []))
        yield Case("one", world((0, 0), (6, 0), [BOX]))
        yield Case("free", {**SMALL_STEPS, "obstacles": []})
        yield Case("one", SMALL_STEPS)
        yield Case("one", world((0, 0), (60, 0), [BOX]))
        yield Case("one", world((0, 0), (6, 0), [WIDE]))
        yield Case("one", world((0, 0), (6, 0), [SMALL]))
        yield Case("many", world((0, 0), (5, 3), ME145))
        for n in (2, 3, 2):
            yield self.random_case(rng, "one", 1)
            yield self.random_case(rng, "many", n)
        yield Case("one", turned_world(world((0, 0), (6, 0), [WIDE]), rng.uniform(0.0, 6.0)))

    def plans(self, given: Given) -> list[Plan]:
        """Plans for both turns, and for both ways back: the shorter, or the same direction."""
        return [
            bug1(*given.values(), turn=turn, way_back=back)
            for turn, back in product(self.turns, ("shorter", "same"))
        ]

    def options(self) -> list[Choice]:
        """Each turn with each way back."""
        return [Choice(*both) for both in product(self.turns, ("shorter", "same"))]

    def mixed_walk(self, given: Given, choices: list[Choice]) -> tuple[Array, int]:
        """The walk of Bug 1 with these choices."""
        return walk_with_choices(lambda robot: bug1_walk(robot, True), given, choices)

    def leaves_no_doubt(self, given: Given, plan: Plan) -> bool:
        """Whether the walk is clear, and it is also clear which way back is shorter."""
        return is_clear(given, plan) and not is_tied(given, plan)


def is_tied(given: Given, plan: Plan) -> bool:
    """Whether the two ways back around an obstacle are nearly equally long.

    A walk of Bug 1 in steps could then take either.
    """
    walk = walk_of(plan)
    for hit, leave in zip(walk.hit, walk.leave):
        wall = min(
            given["obstacles"],
            key=lambda obstacle: float(point_polygon_distance(walk.points[hit], obstacle)),
        )
        around = path_length(np.vstack([wall, wall[:1]]))
        back = walk.travelled[leave] - walk.travelled[hit] - around
        if abs(around - 2.0 * back) < TIED:
            return True
    return False
