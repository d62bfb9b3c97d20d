"""The base class of the exercises on the rules that join the nodes of a roadmap.

Bullo & Smith, chapter 5; LaValle, section 5.6.
"""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....geometry.checks import Array
from ....problems.protocols import ProblemLike
from ...exercise import RIGHT, Axes, Case, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Value
from ...whole_shapes import Integers
from ...withheld import withheld
from .halls import ASTRIDE, GRAZING, SHEET, WALL, draw_obstacles, make_arm, make_hall
from .joining import are_pairs, find_closest, keep_free, remove_duplicates
from .pictures import draw_joined

Pairs = NDArray[np.int64]


NODES = Numbers(("n", 2))
PAIRS = Integers(("m", 2))
ROUND = 12  # number of random cases of each kind


@withheld
def join_k_closest(problem: Any, nodes: Array, k: int) -> Pairs:
    """Return the pairs that the K-closest rule joins.

    One node is among the other's k closest, and the motion between them is free.
    """
    return keep_free(problem, nodes, remove_duplicates(find_closest(problem, nodes, k)))


class RuleExercise(ValueExercise):
    """An exercise that asks which pairs of nodes a rule joins, in any order."""

    lesson = "08_roadmaps"
    seconds = 10.0
    answer = PAIRS

    def same(self, value: object, truth: object) -> bool:
        """Whether both hold the same pairs, equally often, in any order."""
        return bool(
            sorted(map(tuple, np.asarray(value).tolist()))
            == sorted(map(tuple, np.asarray(truth).tolist()))
        )

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that the rows are pairs, that their motions are free, and that they are right."""
        problem, nodes, _ = case.given.values()
        wanted = self.describe_expected(case)
        if not are_pairs(value, len(nodes)):
            return Verdict(0.0, "pairs", wanted)
        if len(keep_free(problem, nodes, value)) < len(value):
            return Verdict(0.0, "motion", wanted)
        return RIGHT if self.same(value, self.truth(case)) else Verdict(0.0, case.kind, wanted)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the numbered nodes, the right edges and the student's."""
        value = outcome.value if isinstance(outcome, Answer) else None
        draw_joined(case.given["problem"], case.given["nodes"], self.truth(case), value, ax)
        set_title(self, case, ax)


def set_title(exercise: Any, case: Case, ax: Axes) -> None:
    """Set the title of the picture of this kind of input."""
    from ....figures import plane

    plane.title(exercise.message(f"pictures.{case.kind}"), ax)


def make_case(kind: str, problem: ProblemLike, nodes: object, number: float) -> Case:
    """Return a case; `number` is a radius or K."""
    name = "r" if isinstance(number, float) else "k"
    return Case(kind, {"problem": problem, "nodes": np.array(nodes, float), name: number})


def make_pairs(number: float) -> Iterator[Case]:
    """Yield motions that need the problem's own collision check.

    One touches a corner, one crosses a thin wall, and one is an arm's short way round.
    """
    yield make_case("wall", make_hall(WALL), GRAZING, number)
    yield make_case("wall", make_hall(SHEET), ASTRIDE, number)
    yield make_case("torus", make_arm(), ((5.9, 0.3), (0.4, 0.3)), number)


def draw_worlds(rng: np.random.Generator, i: int) -> Iterator[tuple[str, Value]]:
    """Yield a problem with a wall, one with several obstacles, and the arm's."""
    yield "wall", make_hall(WALL)
    yield "many", make_hall(*draw_obstacles(rng, 1 + i // 4))
    yield "torus", make_arm()
