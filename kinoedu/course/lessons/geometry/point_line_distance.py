"""The exercise `point_line_distance`. Bullo & Smith, chapter 1."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike

from ....geometry import point_line_distance, point_segment_distance
from ....geometry.checks import Array
from ...exercise import Axes, Case, Change, Slip, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record, Value
from ..shared.pictures import draw_distance
from ..shared.random_shapes import points, sizes
from .lines import NEXT, POINT, UPRIGHT, DistanceExercise, LineExercise

NEARLY = 1e-4  # how near the true distance an answer is that lost digits


class PointLineDistance(LineExercise, DistanceExercise):
    """The distance from a point to the line through two other points."""

    name = "point_line_distance"
    lesson = "01_geometry"
    kinds = ("beside", "beyond", "on", "upright", "coincident")
    given = Record(q=POINT, p1=POINT, p2=POINT)
    answer = Number()
    source = staticmethod(point_line_distance)
    slips = (
        Slip("segment", point_segment_distance),
        Slip("signed", lambda q, p1, p2: signed_distance(q, p1, p2)),
        Slip("unscaled", lambda q, p1, p2: abs(cross(p2 - p1, q - p1))),
        Slip(
            "along",
            lambda q, p1, p2: abs(float(np.dot(q - p1, p2 - p1))) / float(np.linalg.norm(p2 - p1)),
        ),
        Slip("square", lambda q, p1, p2: point_line_distance(q, p1, p2) ** 2),
        Slip("half", lambda q, p1, p2: point_line_distance(q, p1, p2) / 2),
        Slip(
            "vertical",
            lambda q, p1, p2: abs(
                p1[1] + (p2[1] - p1[1]) * (q[0] - p1[0]) / (p2[0] - p1[0]) - q[1]
            ),
        ),
        Slip("rounded", lambda q, p1, p2: round(point_line_distance(q, p1, p2), 2)),
        Slip("nearer_point", lambda q, p1, p2: min(np.linalg.norm(q - p1), np.linalg.norm(q - p2))),
    )
    reference = staticmethod(point_line_distance)

    changes = (
        Change("left", lambda distance, *given: side_of(*given) * distance(*given)),
        Change("right", lambda distance, *given: -side_of(*given) * distance(*given)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Small integers first; both sides of the line, and both directions along it."""
        for kind, q, p1, p2 in (
            ("beside", (2, 3), (0, 0), (4, 0)),
            ("beside", (2, -3), (0, 0), (4, 0)),
            ("beside", (3, 5), (1, 1), (5, 1)),
            ("beside", (1, 7), (0, 0), (8, 6)),
            ("beyond", (7, 4), (0, 0), (4, 0)),
            ("upright", (3, 1), (0, 0), (0, 4)),
            ("on", (2, 2), (0, 0), (4, 4)),
            ("beyond", (-3, 1), (0, 0), (4, 0)),
            ("beyond", (9000, 5), (0, 0), (4, 0)),
            ("beyond", (9000, 0.0005), (0, 0), (4, 0)),
            ("beside", (2, 0.0005), (0, 0), (4, 0)),
            ("beside", (0, 3), (0, 0), (0.01, 0)),
            ("coincident", (1, 1), (2, 2), (2, 2)),
            ("coincident", (2, 2), (2, 2), (2, 2)),
            ("beside", (2, 0.00001), (0, 0), (4, 0)),
            ("beside", (-4, 3), (0, 0), (0.03, 0.04)),
            ("beside", (1, 50), (0, 0), (0.5, 100)),
            ("beside", (50, 1), (0, 0), (100, 0.5)),
            ("beside", (1, 1), (0, 0), (0.0005, 2)),
            ("beside", (-4, 3), (0, 0), (0.0003, 0.0004)),
            ("beside", (-4, 3), (0, 0), (3e-9, 4e-9)),
            ("beside", (-4, 3), (0, 0), (1e-30, 0)),
            ("beside", (1, 5), (1, 2), (1 + NEXT, 2)),
            ("beside", (1, 4000), (0, 0), (0.1, 9000)),
            ("beside", (9999.2, 9999.5), (9999.9, 9999.7), (9999.8, 9999.9)),
        ):
            yield Case(kind, arguments(q, p1, p2))
        for size in sizes(6):
            p1, p2, q = points(rng, 3, size)
            while p1[0] == p2[0]:
                p1, p2, q = points(rng, 3, size)
            along = float(np.dot(q - p1, p2 - p1) / np.dot(p2 - p1, p2 - p1))
            yield Case("beside" if 0 <= along <= 1 else "beyond", arguments(q, p1, p2))
            yield Case(
                "beside",
                arguments((p1 + p2) / 2 + rng.uniform(0.2, 2) * turn_left(p2 - p1), p1, p2),
            )
            yield Case(
                "beyond",
                arguments(p2 + rng.integers(1, 4) * (p2 - p1) + turn_left(p2 - p1), p1, p2),
            )
            yield Case("on", arguments(np.round(p1 + rng.integers(-3, 4) * (p2 - p1), 2), p1, p2))
            yield Case("upright", arguments(q, p1, p1 + UPRIGHT * (1 + rng.integers(9))))
            yield Case("coincident", arguments(q, p1, p1))
            step = rng.integers(1, 10, 2) * np.array((0.01, 1.0)) * rng.choice([-1.0, 1.0], 2)
            for way in (step, step[::-1]):
                yield Case("beside", arguments(p1 + way / 2 + turn_left(way), p1, p1 + way))

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Compare a distance with the true one; a nearly right one breaks a rule of its own."""
        verdict, truth = super().value_verdict(case, value), self.truth(case)
        is_near = value != 0.0 and abs(value - truth) <= NEARLY * (1.0 + truth)
        return verdict if verdict.is_right or not is_near else verdict._replace(rule="digits")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the line, the point, and a circle around it for each of the two distances."""
        draw_distance(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def arguments(q: ArrayLike, p1: ArrayLike, p2: ArrayLike) -> dict[str, Array]:
    """Arguments of a case."""
    return {"q": np.array(q, float), "p1": np.array(p1, float), "p2": np.array(p2, float)}


def turn_left(v: Array) -> Array:
    """Turn a vector by a quarter turn to the left."""
    return np.array([-v[1], v[0]])


def cross(u: Array, v: Array) -> float:
    """The z component of the cross product."""
    return float(u[0] * v[1] - u[1] * v[0])


def side_of(q: Array, p1: Array, p2: Array) -> float:
    """1 where q is to the left of the direction from p1 to p2, -1 to the right, 0 on the line."""
    return float(np.sign(cross(p2 - p1, q - p1)))


def signed_distance(q: Array, p1: Array, p2: Array) -> float:
    """Distance to the line, negative to the right of the direction from p1 to p2."""
    return cross(p2 - p1, q - p1) / float(np.linalg.norm(p2 - p1))
