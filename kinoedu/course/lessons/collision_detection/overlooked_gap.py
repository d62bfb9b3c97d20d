"""The "break it" exercise of lesson 7: find two polygons whose gap a program overlooks."""

from collections.abc import Iterator

import numpy as np

from ....errors import InvalidPoint, InvalidPolygon
from ....geometry import convex_polygons_intersect
from ....geometry.checks import Array
from ....geometry.rings import as_convex_ring
from ....messages import get_message
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Record, Together, Value
from .convex import RING
from .pictures import draw_gap


class OverlookedGap(Exercise):
    """Find two convex polygons for which `half_separating` is wrong."""

    name = "overlooked_gap"
    lesson = "07_collision_detection"
    kinds = ("valid", "exposes", "smallest")
    given = Record()
    answer = Together((RING, RING))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The same question three times; each case demands more of the answer."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check that both polygons are convex, the program is wrong, and both are triangles."""
        rule = polygon_fault(*value)
        if not rule and case.kind != "valid":
            P1, P2 = (as_convex_ring(ring) for ring in value)
            if half_separating(P1, P2) == convex_polygons_intersect(P1, P2):
                rule = "meets" if convex_polygons_intersect(P1, P2) else "exposes"
            elif case.kind == "smallest" and len(P1) + len(P2) > 6:
                rule = "smallest"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Description of what the case asks for."""
        return get_message(f"overlooked_gap.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw both polygons, with a separating line where there is one."""
        good = isinstance(outcome, Answer) and not polygon_fault(*outcome.value)
        rings = (
            (as_convex_ring(outcome.value[0]), as_convex_ring(outcome.value[1]))
            if isinstance(outcome, Answer) and good
            else None
        )
        draw_gap(self, rings, ax)


def polygon_fault(P1: Array, P2: Array) -> str:
    """Key of the rule that makes a polygon invalid, or ""."""
    for ring in (P1, P2):
        if not np.isfinite(ring).all() or np.abs(ring).max(initial=0.0) > 1e4:
            return "range"
        try:
            as_convex_ring(ring)
        except (InvalidPolygon, InvalidPoint):
            return "valid"
    return ""


def half_separating(P1: Array, P2: Array) -> bool:
    """Whether two convex polygons share a point.

    They do not if all of P2 lies to the right of an edge of P1.

    It is wrong somewhere. Where?
    """
    for a, b in zip(P1, np.roll(P1, -1, axis=0)):
        (x, y), way = b - a, P2 - a
        if (x * way[:, 1] - y * way[:, 0] < 0).all():
            return False
    return True
