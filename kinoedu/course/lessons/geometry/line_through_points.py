"""The exercise `line_through_points`. Bullo & Smith, chapter 1."""

from collections.abc import Iterator

import numpy as np

from ....geometry import line_through_points
from ....geometry.checks import Array
from ...exercise import RIGHT, Axes, Case, Slip, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ..shared.pictures import draw_line
from ..shared.random_shapes import points, sizes
from .lines import LEVEL, NEXT, POINT, UPRIGHT, LineExercise


class LineThroughPoints(LineExercise):
    """The line a x + b y + c = 0 through two points, with a^2 + b^2 = 1 and either sign."""

    name = "line_through_points"
    lesson = "01_geometry"
    kinds = ("slanted", "level", "upright", "coincident")
    given = Record(p1=POINT, p2=POINT)
    answer = Numbers((3,))
    source = staticmethod(line_through_points)
    slips = (
        Slip(
            "unscaled", lambda p1, p2: (p1[1] - p2[1], p2[0] - p1[0], p1[0] * p2[1] - p2[0] * p1[1])
        ),
        Slip("direction", lambda p1, p2: direction_as_normal(p1, p2)),
        Slip(
            "c_unscaled",
            lambda p1, p2: np.array(line_through_points(p1, p2)) * (1, 1, np.linalg.norm(p2 - p1)),
        ),
        Slip("sign_of_c", lambda p1, p2: np.array(line_through_points(p1, p2)) * (1, 1, -1)),
        Slip("steep", lambda p1, p2: (1.0, 0.0, -p1[0]) if p1[1] != p2[1] else (0.0, 1.0, -p1[1])),
        Slip("flat", lambda p1, p2: (0.0, 1.0, -p1[1]) if p1[0] != p2[0] else (1.0, 0.0, -p1[0])),
    )
    reference = staticmethod(line_through_points)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Small integers first."""
        for kind, p1, p2 in (
            ("slanted", (0, 0), (3, 4)),
            ("level", (0, 1), (5, 1)),
            ("upright", (2, 0), (2, 3)),
            ("slanted", (1, 0), (4, 4)),
            ("slanted", (0, 5), (5, 0)),
            ("level", (0, 0), (0.01, 0)),
            ("coincident", (1, 2), (1, 2)),
            ("slanted", (0, 0), (0.03, 0.04)),
            ("slanted", (0, 0), (0.5, 100)),
            ("slanted", (0, 0), (100, 0.5)),
            ("slanted", (1, 2), (1.001, 2.001)),
            ("slanted", (0, 0), (0.0003, 0.0004)),
            ("slanted", (0, 0), (3e-9, 4e-9)),
            ("level", (0, 0), (1e-30, 0)),
            ("level", (1, 2), (1 + NEXT, 2)),
            ("slanted", (0, 0), (0.1, 9000)),
            ("slanted", (0, 0), (9000, 0.1)),
            ("slanted", (9999.9, 9999.7), (9999.8, 9999.9)),
        ):
            yield Case(kind, {"p1": np.array(p1, float), "p2": np.array(p2, float)})
        for size in sizes(8):
            p1, p2 = points(rng, 2, size)
            yield Case(
                "slanted" if (p1 != p2).all() else "level" if p1[1] == p2[1] else "upright",
                {"p1": p1, "p2": p2},
            )
            yield Case(
                "level",
                {"p1": p1, "p2": p1 + LEVEL * rng.choice([-1.0, 1.0]) * (1 + rng.integers(9))},
            )
            yield Case(
                "upright",
                {"p1": p1, "p2": p1 + UPRIGHT * rng.choice([-1.0, 1.0]) * (1 + rng.integers(9))},
            )
            yield Case("coincident", {"p1": p2, "p2": p2})
            step = rng.integers(1, 10, 2) * (0.01, 1.0) * rng.choice([-1.0, 1.0], 2)
            yield Case("slanted", {"p1": p1, "p2": np.round(p1 + step, 2)})
            yield Case("slanted", {"p1": p1, "p2": np.round(p1 + step[::-1], 2)})
            yield Case("slanted", {"p1": p1, "p2": np.round(p1 + 0.01 * rng.integers(1, 10, 2), 2)})

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check a^2 + b^2 = 1, then that both points are on the line.

        A line without numbers is that of a slope, which an upright line does not have.
        """
        if self.same(value, self.truth(case)):
            return RIGHT
        if case.kind == "upright" and not np.isfinite(value).all():
            return Verdict(0.0, "slope", self.describe_expected(case))
        a, b, _ = value
        if not abs(a * a + b * b - 1.0) <= self.tolerance:
            return Verdict(0.0, "unit", self.describe_expected(case))
        return Verdict(0.0, "through", self.describe_expected(case))

    def same(self, value: Value, truth: Value) -> bool:
        """Compare lines up to the sign of (a, b, c)."""
        return super().same(value, truth) or super().same(np.negative(value), truth)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the points, the line through them and the student's line."""
        draw_line(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def direction_as_normal(p1: Array, p2: Array) -> tuple[float, float, float]:
    """A wrong line whose (a, b) is its direction and not its normal."""
    a, b = (p2 - p1) / np.sqrt(((p2 - p1) * (p2 - p1)).sum())
    return a, b, -(a * p1[0] + b * p1[1])
