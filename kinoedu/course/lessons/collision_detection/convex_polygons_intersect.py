"""The exercise `convex_polygons_intersect`."""

from collections.abc import Iterator
from itertools import product

import numpy as np

from ....geometry import convex_polygons_intersect, point_in_convex_polygon, segments_intersect
from ....geometry.checks import Array
from ....geometry.convex import has_separating_edge
from ...exercise import Axes, Case, Change, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Record, Truth
from ...withheld import withheld
from ..shared.random_shapes import convex_polygon, sizes
from .convex import RING, TRIANGLE, edge_areas
from .pictures import draw_pair


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
        Slip("vertices", lambda P1, P2: has_vertex_in(P1, P2) or has_vertex_in(P2, P1)),
        Slip("one_way", lambda P1, P2: edges_meet(P1, P2) or has_vertex_in(P1, P2)),
        Slip("one_way", lambda P1, P2: edges_meet(P1, P2) or has_vertex_in(P2, P1)),
        Slip("boxes", lambda P1, P2: boxes_meet(P1, P2)),
        Slip("open", lambda P1, P2: not (edge_divides(P1, P2) or edge_divides(P2, P1))),
        Slip("half", lambda P1, P2: not has_separating_edge(P1, P2)),
        Slip("half", lambda P1, P2: not has_separating_edge(P2, P1)),
        Slip("opposite", lambda P1, P2: not convex_polygons_intersect(P1, P2)),
    )
    reference = staticmethod(convex_polygons_intersect)

    changes = (
        Change("apart", lambda intersect, P1, P2: not intersect(P1, P2)),
        Change("overlap", lambda intersect, P1, P2: intersect(P1, P2) and share_inside(P1, P2)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The book's three pairs first, then larger polygons on squared paper of every kind."""
        unit = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
        for kind, P1, P2 in (
            ("corner", 2 * unit, 2 * unit + 1),
            ("apart", unit, translate(unit, 2, 0)),
            ("touching", [(0, 0), (1, 0), (1, 3)], [(1, 0), (2, 0), (2, 2)]),
            ("inside", 4 * unit, unit + 1),
            ("inside", unit + 1, 4 * unit),
            ("crossing", unit * (5, 1) + (0, 2), unit * (1, 5) + (2, 0)),
            # long bars, whose crossing a few sampled points of each edge would miss
            ("crossing", unit * (3000, 1) + (-1234, 0), unit * (1, 3000) + (0, -778)),
            ("boxes", TRIANGLE, [(4, 4), (1, 4), (4, 1)]),
            ("touching", unit, translate(unit, 1, 1)),
            ("touching", unit, translate(unit, 1, 0)),
            ("touching", [(-4, 9), (-2, -8), (8, -6)], [(-5, -20), (6, -10), (3, -7), (-1, -9)]),
            ("apart", 0.01 * unit, 0.01 * translate(unit, 2, 0)),
            ("apart", 1e-5 * unit, 1e-5 * translate(unit, 2, 0)),
        ):
            yield Case(kind, {"P1": np.array(P1, float), "P2": np.array(P2, float)})
        for number, size in enumerate(sizes(3)):
            for kind in self.kinds:
                P1, P2 = pair_of(rng, 3 + number // 3, size, kind)
                yield Case(kind, {"P1": P1, "P2": P2})

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw both polygons, with a separating line where there is one."""
        draw_pair(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def translate(ring: Array, x: float, y: float) -> Array:
    """Translate a polygon."""
    return ring + np.array([x, y])


def pair_of(rng: np.random.Generator, n: int, size: float, kind: str) -> tuple[Array, Array]:
    """Random pair of polygons of a kind, on squared paper."""
    while True:
        P, Q = convex_polygon(rng, n, size), convex_polygon(rng, n + 1, size)
        if kind == "inside":
            P = 10 * P
        if kind == "crossing":
            P, Q = P * (9, 1), Q * (1, 9)
        reach = {"inside": 1.0, "crossing": 1.0, "apart": 5.0}.get(kind, 2.0) * size
        Q = (
            Q + np.round(rng.uniform(-reach, reach, 2))
            if kind != "touching"
            else moved_to_touch(rng, 2 * P, Q)
        )
        P = 2 * P if kind == "touching" else P
        P, Q = (P, Q) if rng.random() < 0.5 else (Q, P)
        if classify_pair(P, Q) == kind:
            return P + 0.0, Q + 0.0


def moved_to_touch(rng: np.random.Generator, P: Array, Q: Array) -> Array:
    """Q, moved to touch the middle or the end of an edge of P from outside."""
    i = int(rng.integers(len(P)))
    along = P[i] - P[i - 1]
    nearest = Q[int((Q @ np.array([along[1], -along[0]])).argmin())]
    return Q + (P[i - 1] + rng.choice([0.0, 0.5]) * along - nearest)


@withheld
def classify_pair(P: Array, Q: Array) -> str:
    """Kind of a pair of convex polygons."""
    if not convex_polygons_intersect(P, Q):
        return "boxes" if boxes_meet(P, Q) else "apart"
    if edge_divides(P, Q) or edge_divides(Q, P):
        return "touching"
    if not edges_meet(P, Q):
        return "inside"
    return "corner" if has_vertex_in(P, Q) or has_vertex_in(Q, P) else "crossing"


def edge_divides(P: Array, Q: Array) -> bool:
    """Whether an edge of P has all of Q on its line or to its right."""
    return bool(np.any(np.all([edge_areas(q, P) <= 0 for q in Q], axis=0)))


def share_inside(P: Array, Q: Array) -> bool:
    """Whether polygons that share a point share one that is on neither boundary."""
    return not (edge_divides(P, Q) or edge_divides(Q, P))


def boxes_meet(P: Array, Q: Array) -> bool:
    """Whether the bounding boxes of two polygons share a point."""
    return bool((P.min(axis=0) <= Q.max(axis=0)).all() and (Q.min(axis=0) <= P.max(axis=0)).all())


def has_vertex_in(P: Array, Q: Array) -> bool:
    """Whether a vertex of P lies in Q."""
    return bool(np.any(point_in_convex_polygon(P, Q)))


def edges_meet(P: Array, Q: Array) -> bool:
    """Whether an edge of P shares a point with an edge of Q."""
    pairs = np.array(
        [(P[i - 1], P[i], Q[j - 1], Q[j]) for i, j in product(range(len(P)), range(len(Q)))]
    )
    return bool(np.any(segments_intersect(*pairs.transpose(1, 0, 2))))
