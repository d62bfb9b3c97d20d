"""The exercise `point_polygon_distance`. Bullo & Smith, chapter 1."""

from collections.abc import Callable, Iterator

import numpy as np

from ....geometry import point_polygon_distance
from ....geometry.checks import Array
from ....geometry.polygons import distances_to_ring, locate_point
from ...exercise import Axes, Case, Change, Slip
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record
from ..shared.pictures import draw_distance
from ..shared.random_shapes import sizes
from .lines import POINT, DistanceExercise
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

ROUND_SQUARE = ((2, -1), (7, 8), (-3, 2), (1, 1), (4, 2), (9000, 3), (-1, 4), (-2, 0))
ROUND_CORNER = ((4, 3), (8, -2), (-1, 5), (1, 5), (5, 1), (2, 2), (1, 2), (4, 2.0005), (2, 3))
ROUND_WEDGE = ((4.001, 0), (2, -0.00202), (5, 0))


class PointPolygonDistance(DistanceExercise):
    """The distance from a point to a polygon, 0 inside."""

    name = "point_polygon_distance"
    lesson = "01_geometry"
    kinds = ("edge", "vertex", "closing", "inside", "boundary")
    given = Record(q=POINT, polygon=POLYGON)
    answer = Number()
    source = staticmethod(point_polygon_distance)
    shown = staticmethod(distances_to_ring)
    slips = (
        Slip("vertices", lambda q, polygon: min(np.linalg.norm(polygon - q, axis=1))),
        Slip(
            "vertices",
            lambda q, polygon: (
                min(np.linalg.norm(polygon - q, axis=1)) if locate_point(*q, polygon) < 0 else 0.0
            ),
        ),
        Slip(
            "open",
            lambda q, polygon: (
                min(edge_distances(q, polygon)[:-1]) if locate_point(*q, polygon) < 0 else 0.0
            ),
        ),
        Slip("open", lambda q, polygon: min(edge_distances(q, polygon)[:-1])),
        Slip("rim", lambda q, polygon: min(edge_distances(q, polygon))),
        Slip(
            "lines",
            lambda q, polygon: (
                min(line_distances(q, polygon)) if locate_point(*q, polygon) < 0 else 0.0
            ),
        ),
        Slip("lines", lambda q, polygon: min(line_distances(q, polygon))),
        Slip(
            "first_edge",
            lambda q, polygon: (
                edge_distances(q, polygon)[-1] if locate_point(*q, polygon) < 0 else 0.0
            ),
        ),
        Slip(
            "first_edge",
            lambda q, polygon: (
                edge_distances(q, polygon)[0] if locate_point(*q, polygon) < 0 else 0.0
            ),
        ),
        Slip(
            "farthest",
            lambda q, polygon: (
                max(edge_distances(q, polygon)) if locate_point(*q, polygon) < 0 else 0.0
            ),
        ),
        Slip("centre", lambda q, polygon: float(np.linalg.norm(q - polygon.mean(axis=0)))),
        Slip(
            "signed",
            lambda q, polygon: (
                -min(edge_distances(q, polygon)) if locate_point(*q, polygon) < 0 else np.nan
            ),
        ),
        Slip(
            "rim",
            lambda q, polygon: (
                -min(edge_distances(q, polygon)) if locate_point(*q, polygon) > 0 else np.nan
            ),
        ),
        Slip("square", lambda q, polygon: point_polygon_distance(q, polygon) ** 2),
        Slip("rounded", lambda q, polygon: round(float(point_polygon_distance(q, polygon)), 2)),
    )
    reference = staticmethod(point_polygon_distance)

    changes = (
        Change("signed", lambda distance, *given: measure_depth(-1.0, distance, *given)),
        Change("boundary", lambda distance, *given: measure_depth(1.0, distance, *given)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Polygons to draw by hand, then stars of every kind, then many vertices."""
        for polygon, queries in (
            (SQUARE, ROUND_SQUARE),
            (CORNER, ROUND_CORNER),
            (WEDGE, ROUND_WEDGE),
            (SQUARE, ((2, -0.00001),)),
            (SQUARE + 9000.12, ((9002, 9000.117), (9005, 9002), (-9999, -9999))),
        ):
            for q in queries:
                yield self.case(np.array(q, float), polygon)
        for number, size in enumerate(sizes(6)):
            star, points = star_and_queries(rng, 3 + number // 3, size, self.kinds)
            for point in points:
                yield self.case(point, star)
        for n in (30, 150):
            for point in points_around(rng, round_polygon(n)):
                yield self.case(point, round_polygon(n))

    def case(self, q: Array, polygon: Array) -> Case:
        """Case of a point and a polygon, with its kind."""
        return Case(kind_of(q, polygon), {"q": q, "polygon": polygon})

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the polygon, the point, and a circle around it for each of the two distances."""
        draw_distance(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def measure_depth(sign: float, distance: Callable[..., float], q: Array, polygon: Array) -> float:
    """The distance outside, and inside the distance to the boundary with this sign."""
    if locate_point(*q, polygon) < 0:
        return distance(q, polygon)
    return sign * min(edge_distances(q, polygon))


def edge_distances(q: Array, polygon: Array) -> Array:
    """Distance of q to each edge, the closing edge last; shape (n,)."""
    return np.linalg.norm(nearest_on_edges(q, polygon) - q, axis=1)


def line_distances(q: Array, polygon: Array) -> Array:
    """Distance of q to the line through each edge; shape (n,)."""
    sides = np.roll(polygon, -1, axis=0) - polygon
    return np.abs(
        sides[:, 0] * (q - polygon)[:, 1] - sides[:, 1] * (q - polygon)[:, 0]
    ) / np.linalg.norm(sides, axis=1)
