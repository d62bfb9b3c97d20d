"""The exercise `bug2`. Bullo & Smith, chapter 1."""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ....planners import bug2
from ....planners.bugs.bug2 import bug2_walk
from ....problems import Plan
from ...exercise import Case, Given
from .walking import (
    BOX,
    ME145,
    SMALL_STEPS,
    TURNS,
    BugExercise,
    Choice,
    turned_world,
    walk_with_choices,
    world,
)

SPIRAL = np.array(
    [(1, -3), (9, -3), (9, 3), (3, 3), (3, 2), (8, 2), (8, -2), (2, -2), (2, 3.5), (1, 3.5)], float
)
SMALL = np.array([(2, -0.15), (2.4, -0.15), (2.4, 0.25), (2, 0.25)], float)  # past it in few steps
THIN = np.array([(2, -1), (2.42, -1), (2.42, 2), (2, 2)], float)
# open at the top
HORSESHOE = np.array(
    [(-5, -2), (3, -2), (3, 2), (2, 2), (2, -1), (-4, -1), (-4, 2), (-5, 2)], float
)
# the wall comes near the goal on the far side of the line
SNAIL = np.array(
    [
        (-3, 4),
        (-3, -4),
        (3, -4),
        (3, 2),
        (1.5, 2),
        (1.5, -3),
        (-2, -3),
        (-2, 3),
        (4, 3),
        (4, 4),
    ],
    float,
)


class Bug2(BugExercise):
    """Bug 2: follow the wall until the line from start to goal is met again, nearer to the goal."""

    name = "bug2"
    kinds = ("free", "one", "many", "spiral")
    source = staticmethod(bug2)
    variants = TURNS

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """No obstacle, one, several, and walls that meet the line again farther from the goal."""
        for goal in ((3, 4), (-2, 0.5), (0, 1.02)):
            yield Case("free", world((0, 0), goal, []))
        yield Case("one", world((0, 0), (6, 0), [BOX]))
        yield Case("free", {**SMALL_STEPS, "obstacles": []})
        yield Case("one", SMALL_STEPS)
        yield Case("one", world((0, 0), (60, 0), [BOX]))
        yield Case("one", world((0, 0), (6, 0), [THIN]))
        yield Case("one", world((0, 0), (6, 0), [SMALL]))
        yield Case("many", world((0, 0), (5, 3), ME145))
        yield Case("spiral", world((7.5, 0.5), (0, 3.5), [SPIRAL]))
        yield Case("spiral", world((0, 0), (6, 0), [HORSESHOE]))
        yield Case("spiral", world((0, 0), (6, 0), [SNAIL]))
        upright = np.pi / 2.0
        for start, goal, wall in (
            ((7.5, -0.5), (0, -3.5), SPIRAL),
            ((0, 0), (6, 0), HORSESHOE),
            ((0, 0), (6, 0), SNAIL),
        ):
            yield Case("spiral", turned_world(world(start, goal, [mirrored(wall)]), upright))
        for n in (2, 3, 2):
            yield self.random_case(rng, "one", 1)
            yield self.random_case(rng, "many", n)

    def plans(self, given: Given) -> list[Plan]:
        """Plans for both turns."""
        return [bug2(*given.values(), turn=turn) for turn in self.turns]

    def options(self) -> list[Choice]:
        """Each turn."""
        return [Choice(turn) for turn in self.turns]

    def mixed_walk(self, given: Given, choices: list[Choice]) -> tuple[Array, int]:
        """The walk of Bug 2 with these turns."""
        return walk_with_choices(bug2_walk, given, choices)


def mirrored(polygon: Array) -> Array:
    """Reflect a polygon in the x-axis, and keep it counter-clockwise."""
    return (polygon * (1.0, -1.0))[::-1]
