"""Exercises on convex polygons: is a point in one, do two of them meet? Bullo & Smith, chapter 4."""

from collections.abc import Iterator
from itertools import product
from typing import Any

import numpy as np

from ...geometry import convex_polygons_intersect, point_in_convex_polygon, segments_intersect
from ...geometry.checks import Array
from ...geometry.convex import has_separating_edge, in_convex
from ..exercise import Case, Slip, ValueExercise
from ..outcomes import Answer, Outcome
from ..shapes import Numbers, Record, Truth
from .chance import convex_polygon, sizes
from .collision_pictures import draw_membership, draw_pair
from .lines import POINT

RING = Numbers(("n", 2))
SQUARE = np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)])
TRIANGLE = np.array([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)])


class PointInConvexPolygon(ValueExercise):
    """Whether a point lies in a convex polygon or on its boundary."""

    name = "point_in_convex_polygon"
    lesson = "07_collision_detection"
    kinds = ("inside", "outside", "closing", "boundary", "aligned")
    given = Record(q=POINT, P=RING)
    answer = Truth()
    source = staticmethod(point_in_convex_polygon)
    shown = staticmethod(in_convex)
    slips = (
        Slip("strict", lambda q, P: bool((heights(q, P) > 0).all())),
        Slip("clockwise", lambda q, P: bool((heights(q, P) <= 0).all())),
        Slip("open", lambda q, P: bool((heights(q, P)[:-1] >= 0).all())),
        Slip("any", lambda q, P: bool((heights(q, P) >= 0).any())),
        Slip("first", lambda q, P: bool(heights(q, P)[0] >= 0)),
        Slip("on_line", lambda q, P: bool((heights(q, P) == 0).any() or (heights(q, P) > 0).all())),
        Slip("box", lambda q, P: bool((P.min(axis=0) <= q).all() and (q <= P.max(axis=0)).all())),
    )
    reference = staticmethod(point_in_convex_polygon)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The book's square first; then larger polygons on squared paper, with a point of every kind."""
        for kind, q, P in (
            ("inside", (2, 2), SQUARE),
            ("outside", (2, 4), SQUARE),
            ("boundary", (3, 1), SQUARE),
            ("boundary", (0, 0), SQUARE),
            ("closing", (-1, 1), SQUARE),
            ("aligned", (5, 0), SQUARE),
            ("outside", (3, 3), TRIANGLE),
            ("inside", (1, 1), TRIANGLE),
            ("boundary", (2, 2), TRIANGLE),
            ("aligned", (-4, 8), TRIANGLE),
        ):
            yield Case(kind, {"q": np.array(q, float), "P": P})
        for number, size in enumerate(sizes(4)):
            for kind in self.kinds:
                yield Case(kind, point_and_polygon(rng, 4 + number // 2, size, kind))

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """The polygon, and q; dashed the edges that q is on the wrong side of."""
        draw_membership(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def heights(q: Array, P: Array) -> Array:
    """For each edge, the last one closing the polygon, twice the area of the triangle with q: positive on the left; shape (n,)."""
    along, way = np.roll(P, -1, axis=0) - P, q - P
    return along[:, 0] * way[:, 1] - along[:, 1] * way[:, 0]


def point_and_polygon(rng: np.random.Generator, n: int, size: float, kind: str) -> dict[str, Array]:
    """A random point of a kind, and its polygon. On an edge or its line all numbers are whole or halves: nothing is rounded."""
    while True:
        P = convex_polygon(rng, n, size)
        a, b = P[-1], P[0]
        lo, hi = P.min(axis=0), P.max(axis=0)
        if kind in ("boundary", "aligned"):
            i = int(rng.integers(len(P)))
            share = rng.choice([0.0, 0.5] if kind == "boundary" else [-1.0, 2.0])
            return {"q": P[i - 1] + share * (P[i] - P[i - 1]), "P": P}
        beside = a + rng.uniform(0.3, 0.7) * (b - a) + rng.uniform(0.01, 0.2) * np.array([b[1] - a[1], a[0] - b[0]])
        anywhere = (lo + hi) / 2 + rng.uniform(-1.0, 1.0, 2) * (hi - lo)
        q = np.round(beside if kind == "closing" else anywhere, 3) + 0.0
        left = heights(q, P)
        wrong = np.flatnonzero(left < 0).tolist()
        place = "closing" if wrong == [len(P) - 1] else "outside" if wrong else "inside"
        if np.abs(left).min() > 1e-6 and place == kind:
            return {"q": q, "P": P}


class ConvexPolygonsIntersect(ValueExercise):
    """Whether two convex polygons share a point."""

    name = "convex_polygons_intersect"
    lesson = "07_collision_detection"
    kinds = ("apart", "boxes", "corner", "crossing", "inside", "touching")
    given = Record(P1=RING, P2=RING)
    answer = Truth()
    source = staticmethod(convex_polygons_intersect)
    shown = staticmethod(has_separating_edge)
    slips = (
        Slip("edges", lambda P1, P2: edges_meet(P1, P2)),
        Slip("vertices", lambda P1, P2: some_in(P1, P2) or some_in(P2, P1)),
        Slip("one_way", lambda P1, P2: edges_meet(P1, P2) or some_in(P1, P2)),
        Slip("one_way", lambda P1, P2: edges_meet(P1, P2) or some_in(P2, P1)),
        Slip("boxes", lambda P1, P2: boxes_meet(P1, P2)),
        Slip("open", lambda P1, P2: not (divides(P1, P2) or divides(P2, P1))),
        Slip("half", lambda P1, P2: not has_separating_edge(P1, P2)),
        Slip("half", lambda P1, P2: not has_separating_edge(P2, P1)),
        Slip("opposite", lambda P1, P2: not convex_polygons_intersect(P1, P2)),
    )
    reference = staticmethod(convex_polygons_intersect)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The book's three pairs first; then larger polygons on squared paper, that stand to each other in every way."""
        unit = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
        for kind, P1, P2 in (
            ("corner", 2 * unit, 2 * unit + 1),
            ("apart", unit, moved(unit, 2, 0)),
            ("touching", [(0, 0), (1, 0), (1, 3)], [(1, 0), (2, 0), (2, 2)]),
            ("inside", 4 * unit, unit + 1),
            ("inside", unit + 1, 4 * unit),
            ("crossing", unit * (5, 1) + (0, 2), unit * (1, 5) + (2, 0)),
            ("crossing", unit * (3000, 1) + (-1234, 0), unit * (1, 3000) + (0, -778)),  # a few points of each edge all miss
            ("boxes", TRIANGLE, [(4, 4), (1, 4), (4, 1)]),
            ("touching", unit, moved(unit, 1, 1)),
            ("touching", unit, moved(unit, 1, 0)),
        ):
            yield Case(kind, {"P1": np.array(P1, float), "P2": np.array(P2, float)})
        for number, size in enumerate(sizes(3)):
            for kind in self.kinds:
                P1, P2 = pair_of(rng, 3 + number // 3, size, kind)
                yield Case(kind, {"P1": P1, "P2": P2})

    def draw(self, case: Case, outcome: Outcome, ax: Any) -> None:
        """Both polygons, with a line between them where there is one."""
        draw_pair(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def moved(ring: Array, x: float, y: float) -> Array:
    """A polygon elsewhere."""
    return ring + np.array([x, y])


def pair_of(rng: np.random.Generator, n: int, size: float, kind: str) -> tuple[Array, Array]:
    """Two random polygons on squared paper that stand to each other in a given way."""
    while True:
        P, Q = convex_polygon(rng, n, size), convex_polygon(rng, n + 1, size)
        if kind == "inside":
            P = 10 * P
        if kind == "crossing":
            P, Q = P * (9, 1), Q * (1, 9)
        reach = {"inside": 1.0, "crossing": 1.0, "apart": 5.0}.get(kind, 2.0) * size
        Q = Q + np.round(rng.uniform(-reach, reach, 2)) if kind != "touching" else moved_to_touch(rng, 2 * P, Q)
        P = 2 * P if kind == "touching" else P
        P, Q = (P, Q) if rng.random() < 0.5 else (Q, P)
        if way_of(P, Q) == kind:
            return P + 0.0, Q + 0.0


def moved_to_touch(rng: np.random.Generator, P: Array, Q: Array) -> Array:
    """Q, moved so that it touches the middle or the end of an edge of P from outside."""
    i = int(rng.integers(len(P)))
    along = P[i] - P[i - 1]
    nearest = Q[int((Q @ np.array([along[1], -along[0]])).argmin())]
    return Q + (P[i - 1] + rng.choice([0.0, 0.5]) * along - nearest)


def way_of(P: Array, Q: Array) -> str:
    """How two convex polygons stand to each other: one of the exercise's kinds."""
    if not convex_polygons_intersect(P, Q):
        return "boxes" if boxes_meet(P, Q) else "apart"
    if divides(P, Q) or divides(Q, P):
        return "touching"
    if not edges_meet(P, Q):
        return "inside"
    return "corner" if some_in(P, Q) or some_in(Q, P) else "crossing"


def divides(P: Array, Q: Array) -> bool:
    """Whether all of Q lies on the line of one edge of P or to the right of it."""
    return bool(np.any(np.all([heights(q, P) <= 0 for q in Q], axis=0)))


def boxes_meet(P: Array, Q: Array) -> bool:
    """Whether the smallest boxes round two polygons share a point."""
    return bool((P.min(axis=0) <= Q.max(axis=0)).all() and (Q.min(axis=0) <= P.max(axis=0)).all())


def some_in(P: Array, Q: Array) -> bool:
    """Whether a vertex of P lies in Q."""
    return bool(np.any(point_in_convex_polygon(P, Q)))


def edges_meet(P: Array, Q: Array) -> bool:
    """Whether an edge of P shares a point with an edge of Q."""
    pairs = np.array([(P[i - 1], P[i], Q[j - 1], Q[j]) for i, j in product(range(len(P)), range(len(Q)))])
    return bool(np.any(segments_intersect(*pairs.transpose(1, 0, 2))))
