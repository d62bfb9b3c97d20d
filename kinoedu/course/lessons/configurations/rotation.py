"""The exercise `rotation`. Bullo & Smith, chapters 3 and 6."""

from collections.abc import Iterator
from functools import partial
from math import cos, pi, radians, sin

import numpy as np

from ....geometry.checks import Array
from ....geometry.displacements import rotation
from ...exercise import Case, Slip
from ...shapes import Number, Numbers, Record
from .matrices import MatrixExercise


def rounded_matrix(digits: int, theta: float) -> Array:
    """The matrix with a sine and a cosine of few digits."""
    return np.round(rotation(theta), digits)


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
        Slip(
            "mirror", lambda theta: np.array([[cos(theta), sin(theta)], [sin(theta), -cos(theta)]])
        ),
        Slip(
            "swapped", lambda theta: np.array([[sin(theta), -cos(theta)], [cos(theta), sin(theta)]])
        ),
        Slip(
            "swapped", lambda theta: np.array([[sin(theta), cos(theta)], [-cos(theta), sin(theta)]])
        ),
        Slip("absolute", lambda theta: rotation(abs(theta))),
        Slip("root", lambda theta: rotation(theta) if sin(theta) >= 0.0 else rotation(-theta)),
        Slip("half_turns", lambda theta: rotation(theta % pi)),
        *(Slip("rounded", partial(rounded_matrix, digits)) for digits in (1, 2, 3, 4)),
        Slip("sign", lambda theta: np.array([[cos(theta), sin(theta)], [sin(theta), cos(theta)]])),
    )
    reference = staticmethod(rotation)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Quarter turns first."""
        for kind, theta in (
            ("quarter", pi / 2),
            ("quarter", 0),
            ("left", 1),
            ("right", -1),
            ("turns", 8),
            ("turns", -20),
        ):
            yield Case(kind, {"theta": float(theta)})
        for _ in range(15):
            angle = float(np.round(rng.uniform(0.05, 3.1), 2))
            yield Case("quarter", {"theta": float(rng.integers(-4, 5) * pi / 2)})
            yield Case("left", {"theta": angle})
            yield Case("right", {"theta": -angle})
            yield Case(
                "turns", {"theta": float(np.round(rng.choice([-1, 1]) * rng.uniform(3.2, 50.0), 2))}
            )
