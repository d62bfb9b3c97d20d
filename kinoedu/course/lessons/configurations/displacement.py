"""The exercise `displacement`. Bullo & Smith, chapters 3 and 6."""

from collections.abc import Iterator
from functools import partial
from math import pi, radians

import numpy as np

from ....geometry.checks import Array
from ....geometry.displacements import displacement
from ...exercise import Case, Change, Slip, Verdict
from ...shapes import Number, Numbers, Record, Value
from .matrices import MatrixExercise


def with_rounded_sine(digits: int, x: float, y: float, theta: float) -> Array:
    """The matrix with a sine and a cosine of few digits."""
    return displacement(x, y, 0.0) @ np.round(displacement(0.0, 0.0, theta), digits)


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
        Slip("half_turns", lambda x, y, theta: displacement(x, y, theta % pi)),
        *(Slip("rounded", partial(with_rounded_sine, digits)) for digits in (1, 2, 3, 4)),
        Slip("whole", lambda x, y, theta: np.trunc(displacement(x, y, theta))),
    )
    reference = staticmethod(displacement)

    changes = (
        Change("way_back", lambda matrix, *given: np.linalg.inv(matrix(*given))),
        Change(
            "move_first",
            lambda matrix, x, y, theta: np.matmul(matrix(0, 0, theta), matrix(x, y, 0)),
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Integers and quarter turns first."""
        for x, y, theta in (
            (3, 4, 0),
            (0, 0, pi / 2),
            (2, 0, pi / 2),
            (0, 0, 0),
            (-1, 5, pi),
            (3, 1, -1),
            (0, 0, 2),
        ):
            yield displacement_case(x, y, theta)
        for size in (3.0, 10.0, 10.0, 100.0, 1000.0):
            for _ in range(5):
                x, y = np.round(rng.uniform(-size, size, 2), 2)
                theta = np.round(rng.uniform(0.1, 3.0) * rng.choice([-1, 1]), 2)
                yield displacement_case(x, y, 0.0)
                yield displacement_case(0.0, 0.0, theta)
                yield displacement_case(x, y, theta)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check the last row first, which has its own rule."""
        verdict = super().value_verdict(case, value)
        if not verdict.is_right and not self.same(value[2], (0.0, 0.0, 1.0)):
            return Verdict(0.0, "last_row", self.describe_expected(case))
        return verdict


def displacement_case(x: float, y: float, theta: float) -> Case:
    """Case of a displacement, with its kind."""
    kind = "moves" if theta == 0.0 else "turns" if x == 0.0 == y else "both"
    return Case(kind, {"x": float(x), "y": float(y), "theta": float(theta)})


def moved_first(x: float, y: float, theta: float) -> Array:
    """The matrix that moves, then turns."""
    return displacement(0.0, 0.0, theta) @ displacement(x, y, 0.0)
