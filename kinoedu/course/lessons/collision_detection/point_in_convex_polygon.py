"""The exercise `point_in_convex_polygon`."""

from collections.abc import Iterator

import numpy as np

from ....geometry import point_in_convex_polygon
from ....geometry.checks import Array
from ....geometry.convex import in_convex
from ...exercise import Axes, Case, Change, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Record, Truth
from ..geometry.lines import POINT
from ..shared.random_shapes import convex_polygon, sizes
from .convex import RING, TRIANGLE, edge_areas
from .pictures import draw_membership

SQUARE = np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 3.0), (0.0, 3.0)])
SHARP = np.array([(0.0, 0.0), (8.0, 1.0), (0.0, 2.0)])
TURNS = 2.0 * np.pi * np.arange(40) / 40
ROUND = np.round(10.0 * np.column_stack([np.cos(TURNS), np.sin(TURNS)]), 2) + 0.0


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
        Slip("strict", lambda q, P: bool((edge_areas(q, P) > 0).all())),
        Slip("clockwise", lambda q, P: bool((edge_areas(q, P) <= 0).all())),
        Slip("open", lambda q, P: bool((edge_areas(q, P)[:-1] >= 0).all())),
        Slip("any", lambda q, P: bool((edge_areas(q, P) >= 0).any())),
        Slip("first", lambda q, P: bool(edge_areas(q, P)[0] >= 0)),
        Slip(
            "on_line",
            lambda q, P: bool((edge_areas(q, P) == 0).any() or (edge_areas(q, P) > 0).all()),
        ),
        Slip("box", lambda q, P: bool((P.min(axis=0) <= q).all() and (q <= P.max(axis=0)).all())),
    )
    reference = staticmethod(point_in_convex_polygon)

    changes = (
        Change("outside", lambda is_inside, q, P: not is_inside(q, P)),
        Change(
            "interior",
            lambda is_inside, q, P: is_inside(q, P) and bool((edge_areas(q, P) != 0).all()),
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The book's square first, then larger polygons on squared paper, with every kind of q."""
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
            ("boundary", (8, 1), SHARP),
            ("outside", (0.02, 0.04), 0.01 * SQUARE),
            ("aligned", (5e-5, 0), 1e-5 * SQUARE),
            *((kind, q, ROUND) for kind, q in (("inside", (9, -2)), ("outside", (9, -7)))),
            *((kind, q, ROUND) for kind, q in (("outside", (-9, -7)), ("outside", (-9, 7)))),
        ):
            yield Case(kind, {"q": np.array(q, float), "P": P})
        for number, size in enumerate(sizes(4)):
            for kind in self.kinds:
                yield Case(kind, point_and_polygon(rng, 4 + number // 2, size, kind))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the polygon, q, and dashed lines through the edges that have q on their right."""
        draw_membership(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def point_and_polygon(rng: np.random.Generator, n: int, size: float, kind: str) -> dict[str, Array]:
    """Random polygon, and a point of a kind.

    On an edge or its line all numbers are integers or halves, which floats represent exactly.
    """
    while True:
        P = convex_polygon(rng, n, size)
        a, b = P[-1], P[0]
        lo, hi = P.min(axis=0), P.max(axis=0)
        if kind in ("boundary", "aligned"):
            i = int(rng.integers(len(P)))
            share = rng.choice([0.0, 0.5] if kind == "boundary" else [-1.0, 2.0])
            return {"q": P[i - 1] + share * (P[i] - P[i - 1]), "P": P}
        beside = (
            a
            + rng.uniform(0.3, 0.7) * (b - a)
            + rng.uniform(0.01, 0.2) * np.array([b[1] - a[1], a[0] - b[0]])
        )
        anywhere = (lo + hi) / 2 + rng.uniform(-1.0, 1.0, 2) * (hi - lo)
        q = np.round(beside if kind == "closing" else anywhere, 3) + 0.0
        left = edge_areas(q, P)
        wrong = np.flatnonzero(left < 0).tolist()
        place = "closing" if wrong == [len(P) - 1] else "outside" if wrong else "inside"
        if np.abs(left).min() > 1e-6 and place == kind:
            return {"q": q, "P": P}
