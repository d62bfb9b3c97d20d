"""The exercise on the distance between two poses. LaValle, section 5.1.2."""

import math
from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import ArrayLike

from ....geometry.checks import Array
from ....spaces.angles import angle_difference, wrap_angle
from ....spaces.wrapping import weighted_distance
from ...exercise import Axes, Case, Change, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record
from ...withheld import withheld
from ..shared.driving import a_pose

TURN = 2.0 * math.pi
POSE = Numbers((3,))


@withheld
def measure_distance(a: Array, b: Array, radian: float) -> float:
    """Return the distance between two poses, where a radian counts as `radian` units of length."""
    turn = radian * angle_difference(wrap_angle(a[2]), wrap_angle(b[2]))
    return math.sqrt((b[0] - a[0]) ** 2 + (b[1] - a[1]) ** 2 + turn * turn)


def measure_with(turn: Callable[[float, float, float], float]) -> Callable[..., float]:
    """Return a program whose share of the headings is turn(a, b, radian)."""
    return lambda a, b, radian: math.hypot(b[0] - a[0], b[1] - a[1], turn(a[2], b[2], radian))


def measure_apart(
    distance: Callable[..., float], a: Array, b: Array, radian: float
) -> tuple[float, float]:
    """Return the distance of the places with equal headings, then of the headings at one place."""
    turned = np.array([a[0], a[1], b[2]])
    return distance(turned, b, radian), distance(a, turned, radian)


def measure_short_way(a: float, b: float) -> float:
    """Return the size of the angle between two headings, the short way."""
    return abs(angle_difference(wrap_angle(a), wrap_angle(b)))


class HeadingDistance(ValueExercise):
    """Compute the distance between two poses whose headings wrap."""

    name = "heading_distance"
    lesson = "13_kinodynamic_planning"
    kinds = ("place", "heading", "both", "across", "turns")
    given = Record(a=POSE, b=POSE, radian=Number())
    answer = Number()
    source = staticmethod(measure_distance)
    shown = staticmethod(weighted_distance)
    reference = staticmethod(measure_distance)
    changes = (
        Change("sum", lambda distance, *given: sum(measure_apart(distance, *given))),
        Change("larger", lambda distance, *given: max(measure_apart(distance, *given))),
    )
    slips = (
        Slip("no_wrap", measure_with(lambda a, b, radian: radian * (b - a))),
        Slip("one_way", measure_with(lambda a, b, radian: radian * ((b - a) % TURN))),
        Slip(
            "once", measure_with(lambda a, b, radian: radian * min(abs(a - b), TURN - abs(a - b)))
        ),
        Slip("half_turns", measure_with(lambda a, b, radian: radian * (abs(b - a) % math.pi))),
        Slip("no_radian", measure_with(lambda a, b, radian: measure_short_way(a, b))),
        Slip("divided", measure_with(lambda a, b, radian: measure_short_way(a, b) / radian)),
        Slip(
            "degrees",
            measure_with(lambda a, b, radian: radian * math.degrees(measure_short_way(a, b))),
        ),
        Slip(
            "root", measure_with(lambda a, b, radian: math.sqrt(radian) * measure_short_way(a, b))
        ),
        Slip("place", measure_with(lambda a, b, radian: 0.0)),
        Slip(
            "chord",
            measure_with(
                lambda a, b, radian: 2.0 * radian * math.sin(0.5 * measure_short_way(a, b))
            ),
        ),
        Slip(
            "sum",
            lambda a, b, radian: (
                math.hypot(b[0] - a[0], b[1] - a[1]) + radian * measure_short_way(a[2], b[2])
            ),
        ),
        Slip("square", lambda a, b, radian: measure_distance(a, b, radian) ** 2),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield poses with whole numbers, then random ones."""
        for kind, a, b, radian in (
            ("place", (0, 0, 1), (3, 4, 1), 5),
            ("heading", (2, 1, 0), (2, 1, 0.5), 10),
            ("both", (0, 0, 0), (3, 0, 0.5), 8),
            ("across", (0, 0, 3), (0, 0, -3), 1),
            ("across", (0, 0, -3), (3, 4, 3), 5),
            ("turns", (0, 0, 0), (3, 4, TURN), 5),
            ("turns", (1, 2, 20), (1, 2, -20), 3),
            ("turns", (1, 2, 150), (4, 6, -150), 3),
        ):
            yield make_case(kind, a, b, radian)
        for _ in range(14):
            p, q, radian = a_pose(rng), a_pose(rng), np.round(rng.uniform(0.5, 12), 1)
            low, high, near = np.round(rng.uniform((-3.1, 1.7, -1.5), (-1.7, 3.1, 1.5)), 2)
            yield make_case("place", p, (*q[:2], p[2]), radian)
            yield make_case("heading", (*p[:2], near), (*p[:2], -0.7 * near), radian)
            yield make_case("both", (*p[:2], near), (*q[:2], -0.7 * near), radian)
            ends = (low, high) if rng.random() < 0.5 else (high, low)
            yield make_case("across", (*p[:2], ends[0]), (*q[:2], ends[1]), radian)
            more = TURN * rng.integers(1, 4) * rng.choice([-1, 1])
            yield make_case("turns", p, (*q[:2], np.round(q[2] + more, 2)), radian)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw both poses, the right distance and the student's."""
        from .pictures import draw_two_poses

        draw_two_poses(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def make_case(kind: str, a: ArrayLike, b: ArrayLike, radian: float) -> Case:
    """Return a case of two poses."""
    return Case(kind, {"a": np.array(a, float), "b": np.array(b, float), "radian": float(radian)})
