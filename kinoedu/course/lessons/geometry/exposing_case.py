"""The "break it" exercise of lesson 1: find an input on which a plausible program is wrong."""

from collections.abc import Iterator

import numpy as np

from ....errors import InvalidPoint, InvalidPolygon
from ....geometry import point_polygon_distance, point_segment_distance
from ....geometry.checks import Array
from ....messages import get_message
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Together, Value
from ..shared.pictures import draw_crossings


class ExposeRayCounting(Exercise):
    """Find a point and a polygon on which `ray_counting_distance` is wrong."""

    name = "exposing_case"
    lesson = "01_geometry"
    kinds = ("valid", "exposes", "smallest")
    given = Record()
    answer = Together((Numbers((2,)), Numbers(("n", 2))))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The same question three times; each case demands more of the answer."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check that the polygon is simple, the program is wrong, and the number of vertices."""
        q, polygon = value
        if (
            not np.isfinite(q).all()
            or not np.isfinite(polygon).all()
            or max(np.abs(q).max(), np.abs(polygon).max(initial=0)) > 1e4
        ):
            return Verdict(0.0, "range", self.describe_expected(case))
        try:
            wrong = (
                abs(ray_counting_distance(q, polygon) - point_polygon_distance(q, polygon)) > 1e-6
            )
        except (InvalidPolygon, InvalidPoint):
            return Verdict(0.0, "valid", self.describe_expected(case))
        if case.kind != "valid" and not wrong:
            return Verdict(0.0, "exposes", self.describe_expected(case))
        if case.kind == "smallest" and len(polygon) > 3:
            return Verdict(0.0, "smallest", self.describe_expected(case))
        return RIGHT

    def describe_expected(self, case: Case) -> str:
        """Description of what the case asks for."""
        return get_message(f"exposing_case.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the polygon, the point and the crossings of its ray."""
        draw_crossings(outcome.value if isinstance(outcome, Answer) else None, ax)


def ray_counting_distance(q: Array, polygon: Array) -> float:
    """Distance from q to a polygon, 0 inside.

    A ray to the right from a point inside crosses the boundary an odd number of times.

    It is wrong somewhere. Where?
    """
    crossings, distance = 0, np.inf
    for a, b in zip(polygon, np.roll(polygon, -1, axis=0)):
        distance = min(distance, point_segment_distance(q, a, b))
        if a[1] != b[1] and min(a[1], b[1]) <= q[1] <= max(a[1], b[1]):
            x = a[0] + (q[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
            crossings += x > q[0]
    return 0.0 if crossings % 2 == 1 else distance
