"""The exercise `point_segment_distance`. Bullo & Smith, chapter 1."""

from collections.abc import Iterator

import numpy as np

from ....geometry import point_line_distance, point_segment_distance
from ....geometry.checks import Array
from ....geometry.segments import closest_on_segment
from ...exercise import Axes, Case, Slip
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record
from ..shared.pictures import draw_distance
from ..shared.random_shapes import points, sizes
from .lines import POINT, DistanceExercise, is_short
from .point_line_distance import arguments, turn_left


class PointSegmentDistance(DistanceExercise):
    """The distance from a point to a segment, which may be a single point."""

    name = "point_segment_distance"
    lesson = "01_geometry"
    kinds = ("beside", "beyond_p1", "beyond_p2", "on", "point")
    given = Record(q=POINT, p1=POINT, p2=POINT)
    answer = Number()
    source = staticmethod(point_segment_distance)
    shown = staticmethod(closest_on_segment)
    slips = (
        Slip("line", point_line_distance),
        Slip("ends", lambda q, p1, p2: min(np.linalg.norm(q - p1), np.linalg.norm(q - p2))),
        Slip("one_end", lambda q, p1, p2: clamped_distance(q, p1, p2, 0.0, np.inf)),
        Slip("other_end", lambda q, p1, p2: clamped_distance(q, p1, p2, -np.inf, 1.0)),
        Slip("unscaled", lambda q, p1, p2: clamped_distance(q, p1, p2, 0.0, 1.0, power=1)),
        Slip("square", lambda q, p1, p2: point_segment_distance(q, p1, p2) ** 2),
        Slip("rounded", lambda q, p1, p2: round(float(point_segment_distance(q, p1, p2)), 2)),
        Slip(
            "near",
            lambda q, p1, p2: (
                float(np.linalg.norm(q - p1))
                if is_short(p1, p2)
                else point_segment_distance(q, p1, p2)
            ),
        ),
        Slip(
            "nan",
            lambda q, p1, p2: clamped_distance(q, p1, p2, 0.0, 1.0) if (p1 != p2).any() else np.nan,
        ),
    )
    reference = staticmethod(point_segment_distance)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Small integers first: q beside the segment, beyond each end, on it, and p1 = p2."""
        for kind, q, p1, p2 in (
            ("beside", (1, 2), (0, 0), (4, 0)),
            ("beside", (2, 4), (1, 2), (5, 2)),
            ("beyond_p2", (7, 4), (0, 0), (4, 0)),
            ("beyond_p1", (-3, 4), (0, 0), (4, 0)),
            ("on", (3, 0), (0, 0), (4, 0)),
            ("on", (4, 0), (0, 0), (4, 0)),
            ("on", (1.23457, 0), (0, 0), (4, 0)),  # between the places that a program may try
            ("point", (3, 4), (0, 0), (0, 0)),
            ("beside", (2, 3), (0, 0), (0, 4)),
            ("beyond_p2", (0, 7), (0, 0), (0, 4)),
            ("beyond_p1", (-9000, 5), (0, 0), (4, 0)),
            ("beside", (2, 0.0005), (0, 0), (4, 0)),
            ("beyond_p2", (3, 0), (0, 0), (0.01, 0)),
            ("beside", (2, 0.00001), (0, 0), (4, 0)),
            ("beyond_p2", (3, 4), (0, 0), (0.0003, 0.0004)),
            ("beyond_p2", (0.3, 0.4), (0, 0), (0.00003, 0.00004)),
            ("beyond_p2", (9003, 9004), (9000, 9000), (9000.03, 9000.04)),
        ):
            yield Case(kind, arguments(q, p1, p2))
        for size in sizes(6):
            p1, p2 = points(rng, 2, size)
            side = rng.choice([-1.0, 1.0]) * rng.uniform(0.1, 2.0)
            for kind, along in (
                ("beside", rng.uniform(0.05, 0.95)),
                ("beyond_p1", -rng.uniform(0.1, 3)),
                ("beyond_p2", rng.uniform(1.1, 4)),
            ):
                q = np.round(p1 + along * (p2 - p1) + side * turn_left(p2 - p1), 3)
                yield Case(kind, arguments(q, p1, p2))
            yield Case("beyond_p2", arguments(p2 + (p2 - p1), p1, p2))
            yield Case("beyond_p1", arguments(p1 - 2 * (p2 - p1), p1, p2))
            yield Case("on", arguments(p1 + rng.choice([0.25, 0.5, 0.75]) * (p2 - p1), p1, p2))
            yield Case("point", arguments(p2, p1, p1))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the segment, the point, and a circle around it for each of the two distances."""
        draw_distance(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def clamped_distance(
    q: Array, p1: Array, p2: Array, least: float, most: float, power: int = 2
) -> float:
    """Distance to the point p1 + t (p2 - p1), with t limited to an interval."""
    way = p2 - p1
    share = np.clip(np.dot(q - p1, way) / np.linalg.norm(way) ** power, least, most)
    return float(np.linalg.norm(q - p1 - share * way))
