"""The exercise `polygon_tangent`. Bullo & Smith, chapter 1."""

from collections.abc import Iterator

import numpy as np

from ....geometry import polygon_tangent
from ....geometry.checks import Array
from ....geometry.polygons import nearest_on_ring
from ...exercise import Axes, Case, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ..shared.pictures import draw_tangent
from ..shared.random_shapes import sizes
from .lines import POINT
from .point_line_distance import turn_left
from .polygons import CORNER, POLYGON, SQUARE, kind_of, nearest_on_edges, star_and_queries


class PolygonTangent(ValueExercise):
    """The unit vector along which a robot circles a polygon counter-clockwise."""

    name = "polygon_tangent"
    lesson = "01_geometry"
    kinds = ("edge", "closing", "vertex")
    given = Record(q=POINT, polygon=POLYGON)
    answer = Numbers((2,))
    source = staticmethod(polygon_tangent)
    slips = (
        Slip("clockwise", lambda q, polygon: -polygon_tangent(q, polygon)),
        Slip("towards", lambda q, polygon: turn_left(polygon_tangent(q, polygon))),
        Slip("away", lambda q, polygon: -turn_left(polygon_tangent(q, polygon))),
        Slip("unscaled", lambda q, polygon: unscaled_tangent(q, polygon)),
        Slip("edge_at_vertex", lambda q, polygon: edge_direction(q, polygon, 0)),
        Slip("edge_at_vertex", lambda q, polygon: edge_direction(q, polygon, -1)),
        Slip("open", lambda q, polygon: open_tangent(q, polygon)),
    )
    reference = staticmethod(polygon_tangent)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """A square, an L, then larger star-shaped polygons, with a point of every kind."""
        for polygon, queries in (
            (SQUARE, ((2, -1), (5, 1), (-3, 2), (7, 8), (-1, -1), (9000, 3))),
            (CORNER, ((3, -2), (3, 4), (-1, 5), (8, 4))),
        ):
            for q in queries:
                yield self.case(np.array(q, float), polygon)
        for number, size in enumerate(sizes(8)):
            star, points = star_and_queries(rng, 3 + number // 4, size, self.kinds)
            for point in points:
                yield self.case(point, star)

    def case(self, q: Array, polygon: Array) -> Case:
        """Case of a point and a polygon, with its kind."""
        return Case(kind_of(q, polygon), {"q": q, "polygon": polygon})

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check the length, then the direction."""
        verdict = super().value_verdict(case, value)
        if not verdict.is_right and not abs(float(np.dot(value, value)) - 1.0) <= self.tolerance:
            return Verdict(0.0, "unit", self.describe_expected(case))
        return verdict

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the polygon, the nearest point, and both vectors."""
        draw_tangent(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def edge_direction(q: Array, polygon: Array, step: int) -> Array:
    """Direction of an edge at the nearest vertex: the outgoing one (0) or the incoming one (-1)."""
    edge, _, _, region = nearest_on_ring(q[0], q[1], polygon)
    start = edge if region == 0 else ((edge + (region == 2)) % len(polygon) + step) % len(polygon)
    side = polygon[(start + 1) % len(polygon)] - polygon[start]
    return side / np.linalg.norm(side)


def unscaled_tangent(q: Array, polygon: Array) -> Array:
    """The right direction, with the length of the edge or of the vector to the vertex."""
    edge, x, y, region = nearest_on_ring(q[0], q[1], polygon)
    if region != 0:
        return np.array([y - q[1], q[0] - x])
    return polygon[(edge + 1) % len(polygon)] - polygon[edge]


def open_tangent(q: Array, polygon: Array) -> Array:
    """Tangent of the polygon without its closing edge."""
    feet = nearest_on_edges(q, polygon)[:-1]
    near = int(np.linalg.norm(feet - q, axis=1).argmin())
    side = polygon[near + 1] - polygon[near]
    at_end = bool(
        np.abs(feet[near] - polygon[near]).max() < 1e-12
        or np.abs(feet[near] - polygon[near + 1]).max() < 1e-12
    )
    vector = turn_left(q - feet[near]) if at_end else side
    return vector / np.linalg.norm(vector)
