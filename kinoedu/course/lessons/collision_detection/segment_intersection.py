"""The exercise on the common points of two segments. Bullo & Smith, chapter 4."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ....geometry import segment_intersection
from ....geometry.checks import Array
from ....geometry.segments import shared_points
from ...exercise import Axes, Case, Restated, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Value
from ...withheld import withheld
from ..geometry.lines import POINT
from ..geometry.point_line_distance import cross
from ..shared.random_shapes import points, sizes
from .pictures import draw_segments

NOTHING = np.empty((0, 2))


class SegmentIntersection(ValueExercise):
    """The points that two segments share: none, one, or the two ends of an overlap."""

    name = "segment_intersection"
    lesson = "07_collision_detection"
    kinds = ("crossing", "touching", "apart", "upright", "parallel", "overlap", "end_to_end")
    given = Record(p1=POINT, p2=POINT, p3=POINT, p4=POINT)
    answer = Numbers(("k", 2))
    source = staticmethod(segment_intersection)
    shown = staticmethod(shared_points)
    slips = (
        Slip("lines", lambda *ends: by_shares(ends, lambda t, s: True)),
        Slip("nearly", lambda *ends: with_tolerance(ends)),
        Slip("one_sided", lambda *ends: by_shares(ends, lambda t, s: 0 <= t <= 1)),
        Slip("one_sided", lambda *ends: by_shares(ends, lambda t, s: 0 <= s <= 1)),
        Slip("parallel", lambda *ends: by_shares(ends, lambda t, s: 0 <= t <= 1 and 0 <= s <= 1)),
        Slip("open", lambda *ends: by_shares(ends, lambda t, s: 0 < t < 1 and 0 < s < 1)),
        Slip(
            "upright",
            lambda *ends: NOTHING if ends[2][0] == ends[3][0] else segment_intersection(*ends),
        ),
        Slip("one_point", lambda *ends: segment_intersection(*ends)[:1]),
        Slip("one_point", lambda *ends: segment_intersection(*ends)[-1:]),
        Slip(
            "one_point",
            lambda *ends: (
                segment_intersection(*ends).mean(axis=0)[None]
                if len(segment_intersection(*ends))
                else NOTHING
            ),
        ),
        Slip("twice", lambda *ends: list_point_twice(segment_intersection(*ends), ends)),
    )
    reference = staticmethod(segment_intersection)

    changes = (
        Restated(
            "from_p1",
            answer=lambda points, p1, *others: np.reshape(points, (-1, 2)) - p1,
            usual_answer=lambda points, p1, *others: np.reshape(points, (-1, 2)) + p1,
        ),
        Restated(
            "vectors",
            given=lambda p1, p2, p3, p4: (p1, p2 - p1, p3, p4 - p3),
            usual_given=lambda p1, p2, p3, p4: (p1, p1 + p2, p3, p3 + p4),
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """The book's three pairs first, then small integers; collinear ones on squared paper."""
        for kind, *ends in (
            ("crossing", (1, 1), (3, 3), (1, 3), (3, 1)),
            ("touching", (0, 0), (2, 3), (4, 1), (0, 5)),
            ("apart", (0, 0), (3, 0), (3, 1), (5, 5)),
            ("upright", (0, 1), (4, 1), (2, 0), (2, 5)),
            ("upright", (2, 0), (2, 5), (0, 1), (4, 3)),
            ("parallel", (0, 0), (4, 0), (1, 1), (5, 1)),
            ("parallel", (0, 0), (2, 0), (3, 0), (5, 0)),
            ("overlap", (0, 0), (4, 0), (1, 0), (9, 0)),
            ("overlap", (0, 0), (6, 3), (4, 2), (2, 1)),
            ("end_to_end", (0, 0), (2, 0), (5, 0), (2, 0)),
            ("touching", (0, 0), (4, 0), (4, 0), (6, 3)),
            ("apart", (0, 0), (3, 0), (5, 5), (3, 1)),
            ("apart", (3, 1), (5, 5), (0, 0), (3, 0)),
            ("apart", (5, 5), (3, 1), (0, 0), (3, 0)),
            ("crossing", (0, 0), (0.125, 0.125), (0, 0.125), (0.125, 0)),
            ("parallel", (0, 0), (0.25, 0), (0, 0.125), (0.5, 0.125)),
            ("crossing", (0, 0), (0.01, 0.01), (0, 0.01), (0.01, 0)),
            ("crossing", (0, 0), (1e-5, 1e-5), (0, 1e-5), (1e-5, 0)),
            ("crossing", (0, 0), (20000, 0), (0, -100), (20000, 100)),
            ("apart", (0, 0), (20000, 0), (20005, -100), (20006, 100)),
            ("apart", (0, 0), (20000, 0), (10000, 1), (10001, 20000)),
            # nearly parallel, parallel and short, and a short overlap of long ones
            ("crossing", (0, 0), (20000, 0), (0, -0.05), (20000, 0.05)),
            ("crossing", (0, 0), (20000, 2), (1, 0), (19999, 2)),
            ("parallel", (0, 0), (0.01, 0), (0, 0.01), (0.02, 0.01)),
            ("overlap", (0, 0), (20000.125, 0), (20000, 0), (24000, 0)),
            ("overlap", (0, 0), (2, 1), (2, 1), (0, 0)),  # the same segment, the other way round
        ):
            yield case_of(kind, ends)
        for size in sizes(4):
            for kind in self.kinds:
                random_ends = on_one_line if kind in ("overlap", "end_to_end") else ends_of
                yield case_of(kind, random_ends(rng, size, kind))

    def same(self, value: object, truth: object) -> bool:
        """Compare points in either order."""
        return super().same(value, truth) or super().same(np.asarray(value)[::-1], truth)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw both segments, their common points and the student's points."""
        draw_segments(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def case_of(kind: str, ends: ArrayLike) -> Case:
    """Case of four ends."""
    return Case(kind, dict(zip(("p1", "p2", "p3", "p4"), np.array(ends, float) + 0.0)))


def ends_of(rng: np.random.Generator, size: float, kind: str) -> Array:
    """Random ends of two segments that are not collinear, of a kind; shape (4, 2)."""
    # short segments, and long ones at small angles; factors that cause no rounding
    scale = np.array([1.0, 2.0 ** -int(rng.choice([0, 0, 0, 7]) if kind != "touching" else 0)])
    scale = scale * 2.0 ** -int(rng.choice([0, 0, 3]))
    while True:
        ends = np.round(points(rng, 4, size)) if kind == "touching" else points(rng, 4, size)
        if kind == "upright":
            first = 2 * int(rng.integers(2))
            ends[first + 1, 0] = ends[first, 0]
        elif kind == "touching":
            along = ends[1] - ends[0]
            ends[1] = ends[0] + 2 * along
            ends[2] = ends[0] + rng.integers(3) * along
            ends = np.roll(ends, 2 * int(rng.integers(2)), axis=0)
        elif kind == "parallel":
            ends[:3] = np.round(ends[:3])
            ends[3] = ends[2] + rng.choice([-2, -1, 1, 2]) * (ends[1] - ends[0])
            if rng.random() < 0.3:
                return on_one_line(rng, size, kind)
        if kind_of(ends) == kind:
            return ends * scale


@withheld
def kind_of(ends: Array) -> str:
    """Kind of a pair of segments.

    It is "" where a small change of the ends would change the kind and they are not on squared
    paper.
    """
    u, v = ends[1] - ends[0], ends[3] - ends[2]
    if not (u.any() and v.any()):
        return ""
    if cross(u, v) == 0.0:
        return "parallel" if len(segment_intersection(*ends)) == 0 else ""
    if abs(cross(u, v)) < 0.05 * np.linalg.norm(u) * np.linalg.norm(v):
        return ""
    t, s = line_parameters(ends)
    if min(abs(t), abs(t - 1), abs(s), abs(s - 1)) < 1e-12:
        return "touching" if 0 <= t <= 1 and 0 <= s <= 1 else ""
    if min(abs(t), abs(t - 1), abs(s), abs(s - 1)) < 0.02:
        return ""
    if 0 < t < 1 and 0 < s < 1:
        return "upright" if u[0] == 0.0 or v[0] == 0.0 else "crossing"
    return "apart"


def on_one_line(rng: np.random.Generator, size: float, kind: str) -> Array:
    """Random collinear segments on squared paper, of a kind; shape (4, 2)."""
    start = np.round(points(rng, 1, size)[0])
    step = rng.integers(-4, 5, 2)
    while not step.any():
        step = rng.integers(-4, 5, 2)
    a, b, c, d = sorted(rng.choice(9, 4, replace=False))
    numbers = {
        "overlap": [(a, c, b, d), (a, d, b, c), (b, c, a, d), (a, b, a, c), (a, b, a, b)],
        "end_to_end": [(a, b, b, c)],
    }
    places = np.array(
        numbers.get(kind, [(a, b, c, d)])[int(rng.integers(len(numbers.get(kind, [0]))))]
    )
    pairs = places.reshape(2, 2)
    for pair in pairs:
        pair[:] = rng.permutation(pair)
    return start + rng.permutation(pairs).ravel()[:, None] * step


def line_parameters(ends: Value) -> tuple[float, float]:
    """Parameters t and s of the intersection of the two lines."""
    p1, p2, p3, p4 = ends
    denominator = cross(p2 - p1, p4 - p3)
    return cross(p3 - p1, p4 - p3) / denominator, cross(p3 - p1, p2 - p1) / denominator


def by_shares(ends: Value, accepts: Any) -> Array:
    """Intersection of the lines where `accepts(t, s)`; nothing where they are parallel."""
    if cross(ends[1] - ends[0], ends[3] - ends[2]) == 0.0:
        return NOTHING
    t, s = line_parameters(ends)
    return (ends[0] + t * (ends[1] - ends[0]))[None] if accepts(t, s) else NOTHING


def with_tolerance(ends: Value) -> Array:
    """The right answer, but segments are a little longer where they are not parallel."""
    if cross(ends[1] - ends[0], ends[3] - ends[2]) == 0.0:
        return np.asarray(segment_intersection(*ends))
    return by_shares(ends, lambda t, s: max(abs(t - 0.5), abs(s - 0.5)) <= 0.501)


def list_point_twice(found: Array, ends: Value) -> Array:
    """The right answer, but a single common point of parallel segments is listed twice."""
    is_parallel = cross(ends[1] - ends[0], ends[3] - ends[2]) == 0.0
    return np.vstack([found, found]) if is_parallel and len(found) == 1 else found
