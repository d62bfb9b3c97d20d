"""Exercises on matrices that turn and move: rotations and displacements of the plane. Bullo & Smith, chapters 3 and 6."""

from collections.abc import Iterator
from math import cos, pi, radians, sin
from typing import Any

import numpy as np

from ...geometry.checks import Array
from ...geometry.displacements import displacement, rotation
from ..exercise import Case, Slip, ValueExercise, Verdict
from ..outcomes import Answer, Outcome
from ..shapes import Number, Numbers, Record
from .configuration_pictures import draw_moved


class MatrixExercise(ValueExercise):
    """An exercise whose answer is a matrix that turns, and perhaps moves."""

    lesson = "05_configuration_spaces"

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """A flag, where it should go, and where the student's matrix takes it."""
        draw_moved(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


class Rotation(MatrixExercise):
    """The matrix that turns by an angle."""

    name = "rotation"
    kinds = ("quarter", "left", "right", "turns")
    given = Record(theta=Number())
    answer = Numbers((2, 2))
    source = staticmethod(rotation)
    slips = (
        Slip("clockwise", lambda theta: rotation(-theta)),
        Slip("degrees", lambda theta: rotation(radians(theta))),
        Slip("degrees", lambda theta: rotation(np.degrees(theta))),
        Slip("mirror", lambda theta: np.array([[cos(theta), sin(theta)], [sin(theta), -cos(theta)]])),
        Slip("swapped", lambda theta: np.array([[sin(theta), -cos(theta)], [cos(theta), sin(theta)]])),
        Slip("swapped", lambda theta: np.array([[sin(theta), cos(theta)], [-cos(theta), sin(theta)]])),
        Slip("root", lambda theta: rotation(theta) if sin(theta) >= 0.0 else rotation(-theta)),
        Slip("sign", lambda theta: np.array([[cos(theta), sin(theta)], [sin(theta), cos(theta)]])),
    )
    reference = staticmethod(rotation)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Quarters first."""
        for kind, theta in (("quarter", pi / 2), ("quarter", 0), ("left", 1), ("right", -1), ("turns", 8), ("turns", -20)):
            yield Case(kind, {"theta": float(theta)})
        for _ in range(15):
            angle = float(np.round(rng.uniform(0.05, 3.1), 2))
            yield Case("quarter", {"theta": float(rng.integers(-4, 5) * pi / 2)})
            yield Case("left", {"theta": angle})
            yield Case("right", {"theta": -angle})
            yield Case("turns", {"theta": float(np.round(rng.choice([-1, 1]) * rng.uniform(3.2, 50.0), 2))})


class Displacement(MatrixExercise):
    """The matrix that turns, then moves."""

    name = "displacement"
    kinds = ("moves", "turns", "both")
    given = Record(x=Number(), y=Number(), theta=Number())
    answer = Numbers((3, 3))
    source = staticmethod(displacement)
    slips = (
        Slip("move_first", lambda x, y, theta: moved_first(x, y, theta)),
        Slip("clockwise", lambda x, y, theta: displacement(x, y, -theta)),
        Slip("transposed", lambda x, y, theta: displacement(x, y, theta).T),
        Slip("way_back", lambda x, y, theta: np.linalg.inv(displacement(x, y, theta))),
        Slip("no_one", lambda x, y, theta: displacement(x, y, theta) * [[1], [1], [0]]),
        Slip("degrees", lambda x, y, theta: displacement(x, y, radians(theta))),
        Slip("no_turn", lambda x, y, theta: displacement(x, y, 0.0)),
    )
    reference = staticmethod(displacement)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Whole numbers and quarters first."""
        for x, y, theta in ((3, 4, 0), (0, 0, pi / 2), (2, 0, pi / 2), (0, 0, 0), (-1, 5, pi), (3, 1, -1), (0, 0, 2)):
            yield displacement_case(x, y, theta)
        for size in (3.0, 10.0, 10.0, 100.0, 1000.0):
            for _ in range(5):
                x, y = np.round(rng.uniform(-size, size, 2), 2)
                theta = np.round(rng.uniform(0.1, 3.0) * rng.choice([-1, 1]), 2)
                yield displacement_case(x, y, 0.0)
                yield displacement_case(0.0, 0.0, theta)
                yield displacement_case(x, y, theta)

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """The last row has a rule of its own."""
        verdict = super().value_verdict(case, value)
        if not verdict.is_right and not self.same(value[2], (0.0, 0.0, 1.0)):
            return Verdict(0.0, "last_row", self.wanted(case))
        return verdict


def displacement_case(x: float, y: float, theta: float) -> Case:
    """A case of the kind that it is."""
    kind = "moves" if theta == 0.0 else "turns" if x == 0.0 == y else "both"
    return Case(kind, {"x": float(x), "y": float(y), "theta": float(theta)})


def moved_first(x: float, y: float, theta: float) -> Array:
    """The matrix that moves, then turns."""
    return displacement(0.0, 0.0, theta) @ displacement(x, y, 0.0)
