"""The exercise `polygon_tangent`. Bullo & Smith, chapter 1."""

import math
from collections.abc import Iterator

import numpy as np

from ....geometry import polygon_tangent
from ....geometry.checks import Array
from ....geometry.polygons import nearest_on_ring
from ...exercise import Axes, Case, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ..shared.pictures import draw_tangent
from ..shared.random_shapes import sizes
from .lines import POINT
from .point_line_distance import turn_left
from .polygons import (
    CORNER,
    POLYGON,
    SQUARE,
    WEDGE,
    kind_of,
    nearest_on_edges,
    points_around,
    round_polygon,
    star_and_queries,
)

NEARLY = 0.1  # of an edge: how near its end a point may have been taken for the end


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
        Slip("vertex_at_edge", lambda q, polygon: vertex_tangent(q, polygon)),
    )
    reference = staticmethod(polygon_tangent)
    changes = (
        Restated("clockwise", answer=lambda tangent, *given: np.negative(tangent)),
        Restated(
            "outward",
            answer=lambda tangent, *given: turn_right(tangent),
            usual_answer=lambda outward, *given: turn_left(outward),
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Polygons to draw by hand, then stars of every kind, then many vertices."""
        for polygon, queries in (
            (SQUARE, ((2, -1), (5, 1), (-3, 2), (7, 8), (-1, -1), (9000, 3), (3.9, -9000))),
            (CORNER, ((3, -2), (3, 4), (-1, 5), (8, 4))),
            # the nearest point of an edge's line is exactly the edge's end
            (SQUARE, ((0, -2), (4, -2), (4, 7), (7, 0))),
            (SQUARE, ((0.03, -1), (3.9, -0.5), (-0.5, 3.97), (3.99997, -0.01))),
            (CORNER, ((2.5, 2.5004), (2.5004, 2.5), (6.003, 2.004))),
            (WEDGE, ((4.001, 0.001), (2, -0.003))),
            (SQUARE + 9000.12, ((9002, 9000.117), (9004.123, 9004.125), (-9999, -9998))),
        ):
            for q in queries:
                yield self.case(np.array(q, float), polygon)
        for number, size in enumerate(sizes(8)):
            star, points = star_and_queries(rng, 3 + number // 4, size, self.kinds)
            for point in points:
                yield self.case(point, star)
        for n in (30, 150):
            for point in points_around(rng, round_polygon(n)):
                yield self.case(point, round_polygon(n))

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


def vertex_tangent(q: Array, polygon: Array) -> Array:
    """Tangent of the circle round a vertex, where the nearest point is near that vertex."""
    edge, x, y, _ = nearest_on_ring(q[0], q[1], polygon)
    a, b = polygon[edge], polygon[(edge + 1) % len(polygon)]
    t = math.dist((x, y), a) / math.dist(a, b)
    if NEARLY < t < 1.0 - NEARLY:
        return polygon_tangent(q, polygon)
    vector = turn_left(q - (a if t < 0.5 else b))
    return vector / np.linalg.norm(vector)


def turn_right(v: Array) -> Array:
    """Turn a vector by a quarter turn to the right."""
    return -turn_left(v)


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
