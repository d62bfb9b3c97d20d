"""Shared parts of the exercises on rapidly-exploring random trees.

LaValle, section 5.5; Bullo & Smith, chapter 5.
"""

from collections.abc import Iterator

import numpy as np

from ....geometry.checks import Array
from ...exercise import Case
from ...whole_shapes import Integers
from .planned import TRAPS, Fault, PlannerExercise, StudentProblem, find_path_fault
from .small_problems import box, in_room

PARENTS = Integers(("n",))
STEP, BIAS = 1.0, 0.1

# iterations; each of 2,000 seeds needed fewer; where there is no path, an odd number, so that trees
# that take turns end swapped
ENOUGH = {"same": 10, "room": 200, "sealed": 301, "wall": 1200, "passage": 1200, "thin": 1500}
KINDS = tuple(ENOUGH)

# a corner closed by walls that fit between sampled points of a step
SHEETS = in_room((2, 2), (8, 8), box(6, 6, 10, 6.0005), box(6, 6, 6.0005, 10))


def room_by_chance(rng: np.random.Generator) -> StudentProblem:
    """Problem with start and goal on two sides of a wall that has one gap, at a random place."""
    low = round(float(rng.uniform(1.0, 7.0)), 1)
    x = round(float(rng.uniform(3.5, 6.0)), 1)
    ends = np.round(rng.uniform((0.5, 0.5), (2.5, 9.5), (2, 2)), 1)
    return in_room(
        ends[0], ends[1] + (7.0, 0.0), box(x, 0, x + 0.5, low), box(x, low + 1.6, x + 0.5, 10)
    )


class TreeExercise(PlannerExercise):
    """A tree planner, judged on the traps."""

    lesson = "09_trees"
    kinds = KINDS

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Every trap twice, walls with a random gap, and a corner closed by very thin walls."""
        for _ in range(2):
            for kind in KINDS:
                yield self.make_case(kind, TRAPS[kind], rng)
        for _ in range(2):
            yield self.make_case("wall", room_by_chance(rng), rng)
        yield self.make_case("sealed", SHEETS, rng)

    def make_case(self, kind: str, problem: StudentProblem, rng: np.random.Generator) -> Case:
        """Case of a problem, with a random seed."""
        raise NotImplementedError

    def fault_of_end(self, case: Case, path: Array | None) -> Fault | None:
        """What is wrong with a path, or with its absence."""
        nowhere = np.empty((0, len(case.given["problem"].start)))
        if path is None:
            return Fault("missed", nowhere) if case.kind != "sealed" else None
        return find_path_fault(case.given["problem"], path)
