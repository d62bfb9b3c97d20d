"""The exercise "break it" of lesson 8: obstacles through which a program sees."""

from collections.abc import Iterator
from itertools import combinations

import numpy as np

from ....collision import is_semi_free_path
from ....errors import InvalidPoint, InvalidPolygon, InvalidWorld
from ....geometry.checks import Array
from ....geometry.exact import orientation_sign
from ....geometry.polygons import locate_point
from ....messages import get_message
from ....robots import Point
from ....worlds import PolygonWorld
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Record, Value
from ..decomposition.free_intervals import RING
from ..shared.random_worlds import edges_round
from .halls import measure_turns

FEWEST, MOST = 5, 40  # number of vertices
LARGEST = 100.0  # midpoints of whole numbers up to this are exact
REFUSALS = (InvalidPoint, InvalidPolygon, InvalidWorld)


class ExposeSight(Exercise):
    """Give obstacles for which `sees` is wrong about two corners."""

    name = "exposing_sight"
    lesson = "08_roadmaps"
    kinds = ("valid", "exposes", "smallest")
    given = Record()
    answer = Listed(RING)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the same question three times; each time the answer must fulfil more."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that the polygons are valid, that `sees` is wrong, and the vertex count."""
        rule = world_fault(value)
        if not rule and case.kind != "valid":
            rule = "" if wrong_views(value) else "exposes"
            rule = rule or (
                "smallest" if case.kind == "smallest" and sum(map(len, value)) > FEWEST else ""
            )
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer to a case must be."""
        return get_message(f"exposing_sight.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the obstacles and the pairs about which the program is wrong."""
        from ....figures import palette, plane

        rings = outcome.value if isinstance(outcome, Answer) else []
        shown = [ring for ring in rings if len(ring) > 1 and np.isfinite(ring).all()]
        plane.frame(np.vstack([*shown, [(0, 0), (1, 1)]]) if not shown else np.vstack(shown), ax)
        for ring in shown:
            plane.polygon(ring, ax, numbers=len(shown) == 1)
        for a, b in [] if world_fault(rings) else wrong_views(rings):
            plane.segment(a, b, "", ax, colour=palette.YOURS, style="--")
        if not shown:
            plane.corner_note(get_message("picture.no_answer"), ax, colour=palette.YOURS)
        plane.title(self.message("picture"), ax)


def world_fault(obstacles: Value) -> str:
    """Return the rule that the obstacles of a world break, or ""."""
    rings = list(obstacles)
    if not rings or sum(map(len, rings)) > MOST:
        return "valid"
    if any(
        not np.isfinite(ring).all()
        or (np.abs(ring) > LARGEST).any()
        or (ring != np.rint(ring)).any()
        for ring in rings
    ):
        return "range"
    import shapely

    try:
        PolygonWorld(make_room(rings), rings)
    except REFUSALS:
        return "valid"
    solids = [shapely.Polygon(ring) for ring in rings]
    apart = all(a.distance(b) > 0.0 for a, b in combinations(solids, 2))
    return "" if apart and all(shapely.LinearRing(ring).is_ccw for ring in rings) else "valid"


def make_room(rings: Value) -> Array:
    """Return a rectangle that contains all obstacles."""
    (x0, y0), (x1, y1) = np.vstack(rings).min(axis=0) - 1.0, np.vstack(rings).max(axis=0) + 1.0
    return np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


def wrong_views(obstacles: Value) -> list[tuple[Array, Array]]:
    """Return the pairs of convex corners about which `sees` is wrong.

    The truth is the course's own collision check.
    """
    world = PolygonWorld(make_room(obstacles), obstacles)
    corners = np.vstack([ring[measure_turns(ring) > 0.0] for ring in obstacles])
    return [
        (a, b)
        for a, b in combinations(corners, 2)
        if bool(sees(a, b, obstacles)) != bool(is_semi_free_path(Point(), world, a, b, 0.0))
    ]


def sees(a: Array, b: Array, obstacles: list[Array]) -> bool:
    """Whether two corners see each other: no edge is crossed, and the midpoint is not inside.

    The program is wrong somewhere. Where?
    """
    for cx, cy, dx, dy in edges_round(obstacles[0], obstacles[1:]):
        # the ends of the edge are on both sides of the line of sight, a and b on both of the edge
        across = orientation_sign(*a, *b, cx, cy) * orientation_sign(*a, *b, dx, dy) < 0
        if (
            across
            and orientation_sign(cx, cy, dx, dy, *a) * orientation_sign(cx, cy, dx, dy, *b) < 0
        ):
            return False
    x, y = (a + b) / 2
    return not any(
        locate_point(x, y, ring) > 0 for ring in obstacles
    )  # 1 is inside, 0 on the boundary
