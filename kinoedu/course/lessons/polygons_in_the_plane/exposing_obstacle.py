"""The exercise "break it" of lesson 11: four chords and the centre line stand for a swept disk."""

from collections.abc import Iterator

import numpy as np

from ....collision import free_motions
from ....errors import InvalidPoint, InvalidPolygon
from ....geometry import segments_intersect
from ....geometry.checks import Array
from ....geometry.polygons import point_in_polygon
from ....geometry.rings import as_ring
from ....messages import get_message
from ....robots import Disk
from ....worlds import PolygonWorld
from ...exercise import RIGHT, Axes, Case, Exercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Numbers, Record, Together, Value
from ..geometry.lines import POINT
from .pictures import draw_swept

# least inradius of the obstacle; half the gap between two chords is 0.5
THICK = 0.45


class ExposeFourChords(Exercise):
    """Give a motion of a disk of radius 1 and a triangle that it hits and the chords miss."""

    name = "exposing_obstacle"
    lesson = "11_polygons_in_the_plane"
    kinds = ("valid", "exposes", "thickest")
    given = Record()
    answer = Together((POINT, POINT, Numbers((3, 2))))

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield the same question three times; each time the answer must fulfil more."""
        return (Case(kind, {}) for kind in self.kinds)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge that the answer is valid, that the program is wrong, and the thickness."""
        rule = find_triangle_fault(*value)
        if not rule and case.kind != "valid":
            rule = (
                "hits" if not swept_disk_hits(*value) else "exposes" if chords_hit(*value) else ""
            )
        if not rule and case.kind == "thickest" and measure_inradius(value[2]) < THICK:
            rule = "thickest"
        return Verdict(0.0, rule, self.describe_expected(case)) if rule else RIGHT

    def describe_expected(self, case: Case) -> str:
        """Describe what the answer to a case must be."""
        return get_message(f"exposing_obstacle.wanted.{case.kind}")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw what the disk sweeps, the chords and the triangle."""
        value = (
            outcome.value
            if isinstance(outcome, Answer) and not find_triangle_fault(*outcome.value)
            else None
        )
        draw_swept(value, find_chords(*value[:2]) if value else [], self.message("picture"), ax)


def chords_hit(a: Array, b: Array, obstacle: Array) -> bool:
    """Whether a disk of radius 1 that moves straight from a to b touches an obstacle.

    The program is wrong somewhere. Where?
    """
    for p, q in find_chords(a, b):  # of the centre, and of four points of the rim
        if point_in_polygon(p, obstacle):
            return True
        for c, d in zip(obstacle, np.roll(obstacle, -1, axis=0)):
            if segments_intersect(p, q, c, d):
                return True
    return False


def find_chords(a: Array, b: Array) -> list[tuple[Array, Array]]:
    """Return the paths of the disk's centre and of the right, top, left and bottom of its rim."""
    return [
        (a + off, b + off) for off in np.array([(0, 0), (1, 0), (0, 1), (-1, 0), (0, -1)], float)
    ]


def swept_disk_hits(a: Array, b: Array, obstacle: Array) -> bool:
    """Whether the disk really touches the obstacle, by the course's own collision check."""
    room = PolygonWorld(2e4 * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]), [obstacle])
    return not bool(free_motions(Disk(1.0), room, a[None], b[None])[0])


def find_triangle_fault(a: Array, b: Array, obstacle: Array) -> str:
    """Return the rule that the motion and the triangle break, or ""."""
    numbers = np.vstack([a, b, obstacle])
    if not np.isfinite(numbers).all() or np.abs(numbers).max() > 1e4:
        return "range"
    try:
        as_ring(obstacle)
    except (InvalidPolygon, InvalidPoint):
        return "valid"
    return ""


def measure_inradius(triangle: Array) -> float:
    """Return the inradius of a triangle: twice its area divided by its perimeter."""
    u, v = triangle[1] - triangle[0], triangle[2] - triangle[0]
    sides = triangle - np.roll(triangle, -1, axis=0)
    return float(abs(u[0] * v[1] - u[1] * v[0]) / np.hypot(*sides.T).sum())
