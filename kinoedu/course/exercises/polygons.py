"""Exercises on polygons. Bullo & Smith, chapter 1."""

from collections.abc import Iterator
from typing import Any

import numpy as np

from ...geometry import point_polygon_distance, polygon_tangent
from ...geometry.checks import Array
from ...geometry.polygons import distances_to_ring, nearest_on_ring, place
from ...geometry.segments import closest_on_segment
from ..exercise import Case, Slip, ValueExercise, Verdict
from ..outcomes import Answer, Outcome
from ..shapes import Number, Numbers, Record
from .chance import sizes, star_polygon
from .lines import POINT, turned
from .pictures import draw_distance, draw_tangent

POLYGON = Numbers(("n", 2))
SQUARE = np.array([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)])
ROUND_SQUARE = ((2, -1), (7, 8), (-3, 2), (1, 1), (4, 2), (9000, 3), (-1, 4), (-2, 0))
CORNER = np.array([(0.0, 0.0), (6.0, 0.0), (6.0, 2.0), (2.0, 2.0), (2.0, 6.0), (0.0, 6.0)])
TRIES = 1000
ROUND_CORNER = ((4, 3), (8, -2), (-1, 5), (1, 5), (5, 1), (2, 2), (1, 2), (4, 2.0005), (2, 3))


class PointPolygonDistance(ValueExercise):
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
        Slip("open", lambda q, polygon: min(edge_distances(q, polygon)[:-1]) if place(*q, polygon) < 0 else 0.0),
        Slip("open", lambda q, polygon: min(edge_distances(q, polygon)[:-1])),
        Slip("rim", lambda q, polygon: min(edge_distances(q, polygon))),
        Slip("lines", lambda q, polygon: min(line_distances(q, polygon)) if place(*q, polygon) < 0 else 0.0),
        Slip("lines", lambda q, polygon: min(line_distances(q, polygon))),
        Slip("first_edge", lambda q, polygon: edge_distances(q, polygon)[-1] if place(*q, polygon) < 0 else 0.0),
        Slip("first_edge", lambda q, polygon: edge_distances(q, polygon)[0] if place(*q, polygon) < 0 else 0.0),
        Slip("farthest", lambda q, polygon: max(edge_distances(q, polygon)) if place(*q, polygon) < 0 else 0.0),
        Slip("centre", lambda q, polygon: float(np.linalg.norm(q - polygon.mean(axis=0)))),
        Slip("signed", lambda q, polygon: -min(edge_distances(q, polygon)) if place(*q, polygon) < 0 else np.nan),
        Slip("rim", lambda q, polygon: -min(edge_distances(q, polygon)) if place(*q, polygon) > 0 else np.nan),
        Slip("rounded", lambda q, polygon: round(float(point_polygon_distance(q, polygon)), 2)),
    )
    reference = staticmethod(point_polygon_distance)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """A square, an L, then larger stars; q nearest to an edge, a vertex, the edge that closes; inside; on the boundary."""
        for polygon, queries in ((SQUARE, ROUND_SQUARE), (CORNER, ROUND_CORNER)):
            for q in queries:
                yield self.case(np.array(q, float), polygon)
        for number, size in enumerate(sizes(6)):
            star, points = star_and_queries(rng, 3 + number // 3, size, self.kinds)
            for point in points:
                yield self.case(point, star)

    def case(self, q: Array, polygon: Array) -> Case:
        """A case of the kind that it is."""
        return Case(kind_of(q, polygon), {"q": q, "polygon": polygon})

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The polygon, the point, and a circle round it as large as each of the two distances."""
        draw_distance(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


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
        Slip("towards", lambda q, polygon: turned(polygon_tangent(q, polygon))),
        Slip("away", lambda q, polygon: -turned(polygon_tangent(q, polygon))),
        Slip("unscaled", lambda q, polygon: unscaled_tangent(q, polygon)),
        Slip("edge_at_vertex", lambda q, polygon: edge_direction(q, polygon, 0)),
        Slip("edge_at_vertex", lambda q, polygon: edge_direction(q, polygon, -1)),
        Slip("open", lambda q, polygon: open_tangent(q, polygon)),
    )
    reference = staticmethod(polygon_tangent)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """A square, an L, then larger stars; q outside, nearest to an edge, to the edge that closes, or to a vertex."""
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
        """A case of the kind that it is."""
        return Case(kind_of(q, polygon), {"q": q, "polygon": polygon})

    def value_verdict(self, case: Case, value: Any) -> Verdict:
        """First the length, then the direction."""
        verdict = super().value_verdict(case, value)
        if not verdict.is_right and not abs(float(np.dot(value, value)) - 1.0) <= self.tolerance:
            return Verdict(0.0, "unit", self.wanted(case))
        return verdict

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The polygon, the nearest point, and both vectors."""
        draw_tangent(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def kind_of(q: Array, polygon: Array) -> str:
    """Where q is: inside, on the boundary, or outside and nearest to an edge, the last edge, or a vertex."""
    where = place(q[0], q[1], polygon)
    if where >= 0:
        return "inside" if where else "boundary"
    edge, _, _, region = nearest_on_ring(q[0], q[1], polygon)
    if region != 0:
        return "vertex"
    return "closing" if edge == len(polygon) - 1 else "edge"


def star_and_queries(rng: np.random.Generator, n: int, size: float, kinds: tuple[str, ...]) -> tuple[Array, list[Array]]:
    """A random star of n vertices and a point of every kind; where a star leaves no room for one of them, another star."""
    while True:
        polygon = star_polygon(rng, n, size)
        queries = [query(rng, polygon, kind) for kind in kinds]
        found = [q for q in queries if q is not None]
        if len(found) == len(queries):
            return polygon, found


def query(rng: np.random.Generator, polygon: Array, kind: str) -> Array | None:
    """A random point of a kind, with one nearest boundary point that is clearly the nearest; None where none was found."""
    lo, hi = polygon.min(axis=0), polygon.max(axis=0)
    for _ in range(TRIES):
        if kind == "boundary":
            i, share = rng.integers(len(polygon)), rng.choice([0.0, 0.25, 0.5])
            q = polygon[i - 1] + share * (polygon[i] - polygon[i - 1])
            if kind_of(q, polygon) == kind:  # else it was rounded off the edge
                return q
            continue
        side = polygon[-1] - polygon[0]
        beside = polygon[0] + rng.uniform(0.1, 0.9) * side + rng.uniform(0.05, 1.0) * turned(side)
        anywhere = (lo + hi) / 2 + rng.uniform(-1.0, 1.0, 2) * (hi - lo)
        q = np.round(beside if kind == "closing" else anywhere, 2) + 0.0
        if kind in ("inside", "vertex") and rng.random() < 0.5:
            q[1] = polygon[rng.integers(len(polygon)), 1]  # exactly as high as a vertex: where a ray to the right goes through it
        if kind_of(q, polygon) == kind and not is_tied(q, polygon):
            return q
    return None


def is_tied(q: Array, polygon: Array) -> bool:
    """Whether two places of the boundary are nearly equally near to q, or q lies nearly on it."""
    feet = nearest_on_edges(q, polygon)
    far = np.sqrt(((feet - q) * (feet - q)).sum(axis=1))
    near = far.argmin()
    apart = np.abs(feet - feet[near]).max(axis=1)
    return bool(far[near] < 0.01 or ((far < 1.01 * far[near]) & (apart > 1e-9)).any())


def nearest_on_edges(q: Array, polygon: Array) -> Array:
    """The point of each edge nearest to q, shape (n, 2)."""
    ends = zip(polygon, np.roll(polygon, -1, axis=0))
    return np.array([closest_on_segment(q[0], q[1], a[0], a[1], b[0], b[1])[:2] for a, b in ends])


def edge_distances(q: Array, polygon: Array) -> Array:
    """The distance of q to each edge, the closing one last; shape (n,)."""
    return np.linalg.norm(nearest_on_edges(q, polygon) - q, axis=1)


def line_distances(q: Array, polygon: Array) -> Array:
    """The distance of q to the line through each edge; shape (n,)."""
    sides = np.roll(polygon, -1, axis=0) - polygon
    return np.abs(sides[:, 0] * (q - polygon)[:, 1] - sides[:, 1] * (q - polygon)[:, 0]) / np.linalg.norm(sides, axis=1)


def edge_direction(q: Array, polygon: Array, step: int) -> Array:
    """The direction of an edge at the nearest vertex: the one that leaves it (0) or enters it (-1)."""
    edge, _, _, region = nearest_on_ring(q[0], q[1], polygon)
    start = edge if region == 0 else ((edge + (region == 2)) % len(polygon) + step) % len(polygon)
    side = polygon[(start + 1) % len(polygon)] - polygon[start]
    return side / np.linalg.norm(side)


def unscaled_tangent(q: Array, polygon: Array) -> Array:
    """The right direction, as long as the edge or as q is far from the vertex."""
    edge, x, y, region = nearest_on_ring(q[0], q[1], polygon)
    if region != 0:
        return np.array([y - q[1], q[0] - x])
    return polygon[(edge + 1) % len(polygon)] - polygon[edge]


def open_tangent(q: Array, polygon: Array) -> Array:
    """The tangent to the polygon without the edge that closes it."""
    feet = nearest_on_edges(q, polygon)[:-1]
    near = int(np.linalg.norm(feet - q, axis=1).argmin())
    side = polygon[near + 1] - polygon[near]
    at_end = bool(np.abs(feet[near] - polygon[near]).max() < 1e-12 or np.abs(feet[near] - polygon[near + 1]).max() < 1e-12)
    vector = turned(q - feet[near]) if at_end else side
    return vector / np.linalg.norm(vector)
