"""The exercise on the first contact of a moving point and a moving disc.

It is solved by the motion of one seen from the other.
"""

import math
from collections.abc import Callable, Iterator

import numpy as np

from ....geometry import segments_intersect
from ....geometry.checks import Array
from ...exercise import RIGHT, Axes, Case, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record, Value
from ...withheld import withheld
from .pictures import draw_contact

PLACE = Numbers((2,))
# cases that graze the disc, or begin or end on its rim, by less than this are left out
CLEAR = 0.01
# a contact shorter than this is missed by programs that sample; no random case is so short
BRIEF = 0.002
TINY_SQUARE = 1e-9  # a tolerance where there must be none


def find_roots(x: Array, v: Array, r: float) -> tuple[float, float] | None:
    """Return the two times s at which |x + s v| = r.

    Returns
    -------
    Both times in order; None where no time or every time fulfils it.
    """
    a, b, c = float(v @ v), float(x @ v), float(x @ x) - r * r
    square = b * b - a * c
    if a == 0.0 or square < 0.0:
        return None
    return (-b - math.sqrt(square)) / a, (-b + math.sqrt(square)) / a


@withheld
def find_contact(p0: Array, p1: Array, c0: Array, c1: Array, r: float) -> float:
    """Return when the point is first within r of the centre.

    Returns
    -------
    A fraction of the motion's time, 0 to 1; infinity where there is no contact.
    """
    return find_relative_contact(p0 - c0, (p1 - p0) - (c1 - c0), r)


def find_relative_contact(x: Array, v: Array, r: float) -> float:
    """Return the time of contact of a motion x + s v with a disc at the origin."""
    if x @ x <= r * r:
        return 0.0
    found = find_roots(x, v, r)
    return found[0] if found is not None and 0.0 <= found[0] <= 1.0 else math.inf


def make_program(
    motion: Callable[..., tuple[Array, Array]], choose: Callable[..., float] = find_relative_contact
) -> Callable[..., float]:
    """Return a program that makes a mistake in the relative motion, or in what follows from it."""
    return lambda p0, p1, c0, c1, r: choose(*motion(p0, p1, c0, c1), r)


def find_relative_motion(p0: Array, p1: Array, c0: Array, c1: Array) -> tuple[Array, Array]:
    """Return the point's first position and its motion, both relative to the disc."""
    return p0 - c0, (p1 - p0) - (c1 - c0)


def check_ends_only(x: Array, v: Array, r: float) -> float:
    """Check only the first and the last moment."""
    return 0.0 if x @ x <= r * r else 1.0 if (x + v) @ (x + v) <= r * r else math.inf


def find_end_of_contact(x: Array, v: Array, r: float) -> float:
    """Return the time at which contact ends."""
    if x @ x <= r * r:
        return 0.0
    found = find_roots(x, v, r)
    return found[1] if found is not None and 0.0 <= found[1] <= 1.0 else math.inf


def find_at_any_time(x: Array, v: Array, r: float) -> float:
    """Accept times before the beginning or after the end."""
    found = find_roots(x, v, r)
    return math.inf if found is None else found[0]


def find_nearest_moment(x: Array, v: Array, r: float) -> float:
    """Return the time of the least distance, where that is contact."""
    s = 0.0 if v @ v == 0.0 else min(max(-float(x @ v) / float(v @ v), 0.0), 1.0)
    return s if (x + s * v) @ (x + s * v) <= r * r else math.inf


def miss_brief_contact(x: Array, v: Array, r: float) -> float:
    """Miss contacts that are shorter than a sampling program would see."""
    found = find_roots(x, v, r)
    if x @ x > r * r and found is not None and found[1] - found[0] < BRIEF:
        return math.inf
    return find_relative_contact(x, v, r)


def confuse_equal_velocities(x: Array, v: Array, r: float) -> float:
    """Treat nearly equal velocities as equal."""
    if np.abs(v).max() >= CLEAR:
        return find_relative_contact(x, v, r)
    return 0.0 if x @ x <= r * r else math.inf


def round_root(x: Array, v: Array, r: float) -> float:
    """Take a small number under the root for zero or less."""
    s, reach = find_relative_contact(x, v, r), float(x[0] * v[1] - x[1] * v[0])
    is_small = float(v @ v) * r * r - reach * reach < TINY_SQUARE
    return math.inf if s > 0.0 and is_small else s


def miss_first_moment(x: Array, v: Array, r: float) -> float:
    """Miss contact at the beginning."""
    found = find_roots(x, v, r)
    return found[0] if found is not None and 0.0 <= found[0] <= 1.0 else math.inf


def miss_last_moment(x: Array, v: Array, r: float) -> float:
    """Miss contact that begins exactly at the end."""
    s = find_relative_contact(x, v, r)
    return math.inf if s == 1.0 else s


def miss_rim(x: Array, v: Array, r: float) -> float:
    """Miss contact at the beginning where the distance is exactly r."""
    s = find_relative_contact(x, v, r)
    return math.inf if s == 0.0 and x @ x == r * r else s


def turn_time(s: float, *given: Value) -> float:
    """Return the moment if time runs backwards; infinity, which means never, stays the same."""
    return s if s == math.inf else 1.0 - s


class FirstContact(ValueExercise):
    """Compute when a point and a disc, both in straight motion, first touch."""

    name = "first_contact"
    lesson = "14_moving_and_uncertain"
    kinds = ("meets", "crosses", "outside", "touching", "together")
    given = Record(p0=PLACE, p1=PLACE, c0=PLACE, c1=PLACE, r=Number())
    answer = Number()
    source = staticmethod(find_contact)
    shown = staticmethod(find_contact)
    slips = (
        Slip("standing", make_program(lambda p0, p1, c0, c1: (p0 - c0, p1 - p0))),
        Slip("added", make_program(lambda p0, p1, c0, c1: (p0 - c0, (p1 - p0) + (c1 - c0)))),
        Slip("backwards", make_program(lambda p0, p1, c0, c1: (p0 - c0, (c1 - c0) - (p1 - p0)))),
        Slip("ends_only", make_program(find_relative_motion, check_ends_only)),
        Slip("leaving", make_program(find_relative_motion, find_end_of_contact)),
        Slip("last_moment", make_program(find_relative_motion, miss_last_moment)),
        Slip("any_time", make_program(find_relative_motion, find_at_any_time)),
        Slip("nearest", make_program(find_relative_motion, find_nearest_moment)),
        Slip("not_at_once", make_program(find_relative_motion, miss_first_moment)),
        Slip("rim", make_program(find_relative_motion, miss_rim)),
        Slip("alike", make_program(find_relative_motion, confuse_equal_velocities)),
        Slip("alike", make_program(find_relative_motion, round_root)),
        Slip("moments", make_program(find_relative_motion, miss_brief_contact)),
        Slip(
            "length", lambda p0, p1, c0, c1, r: find_contact(p0, p1, c0, c1, r) * math.dist(p0, p1)
        ),
        Slip("diameter", lambda p0, p1, c0, c1, r: find_contact(p0, p1, c0, c1, r / 2)),
    )
    reference = staticmethod(find_contact)

    changes = (
        Restated(
            "last_contact",
            answer=turn_time,
            given=lambda p0, p1, c0, c1, r: (p1, p0, c1, c0, r),
        ),
        Restated(
            "seconds",
            answer=lambda s, *given: 10.0 * s,
            usual_answer=lambda seconds, *given: seconds / 10.0,
        ),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Yield cases with small whole numbers, then random ones."""
        yield make_case("meets", (0, 0), (10, 0), (10, 0), (0, 0), 2)
        yield make_case("meets", (0, 0), (8, 0), (6, 0), (6, 0), 2)
        yield make_case("meets", (0, 0), (30, 0), (23, 0), (-30, 0), 0.001)
        yield make_case("meets", (0, 0), (5, 0), (2.001, 0), (6.999, 0), 2)
        yield make_case("meets", (0, 0), (5, 0), (2.00001, 0), (6.99999, 0), 2)
        yield make_case("meets", (0, 0), (5, 0), (0.001005, 0), (5.000995, 0), 0.001)
        yield make_case("crosses", (0, 0), (10, 0), (5, -1.5), (5, 18.5), 1)
        yield make_case("outside", (0, 0), (4, 0), (9, 0), (9, 0), 1)
        yield make_case("outside", (5, 0), (9, 0), (0, 0), (0, 0), 1)
        yield make_case("outside", (0, 0), (8, 0), (10.0008, 0), (10.0008, 0), 2)  # just too late
        yield make_case("touching", (0, 0), (5, 0), (1, 0), (9, 0), 2)
        yield make_case("touching", (2, 0), (6, 0), (0, 0), (0, 0), 2)
        yield make_case("meets", (0, 0), (8, 0), (10, 0), (10, 0), 2)  # at the last moment
        yield make_case("meets", (0, 0), (1, 0), (0.5, 0), (0.5, 0), 2e-5)
        yield make_case("together", (0, 0), (5, 5), (3, 0), (8, 5), 1)
        yield make_case("together", (0, 0), (0, 0), (1, 0), (1, 0), 2)
        wanted = dict.fromkeys(self.kinds, 12)
        while any(wanted.values()):
            p0, p1, c0, c1 = np.round(rng.uniform(-10, 10, (4, 2)), 1)
            r, which = float(np.round(rng.uniform(0.5, 4), 1)), rng.random()
            c1 = c0 + (p1 - p0) if which < 0.2 else c1
            c0 = np.round(p0 + rng.uniform(-0.6, 0.6, 2) * r, 1) if 0.2 < which < 0.4 else c0
            kind = classify(p0, p1, c0, c1, r)
            if kind and wanted[kind]:
                wanted[kind] -= 1
                yield make_case(kind, p0, p1, c0, c1, r)

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Judge the time; an answer outside of 0 to 1 breaks a rule of its own."""
        if self.same(value, self.truth(case)):
            return RIGHT
        never = math.isinf(self.truth(case)) and not 0.0 <= value <= 1.0
        return Verdict(0.0, "outside" if never else case.kind, self.describe_expected(case))

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw both motions, and point and disc at the right and at the student's time."""
        draw_contact(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


@withheld
def classify(p0: Array, p1: Array, c0: Array, c1: Array, r: float) -> str:
    """Return the kind of a case; "" where rounding might decide it, or where it is too easy.

    In a case "crosses" the way of the point crosses that of the disc's centre, at another time.
    """
    x, v = find_relative_motion(p0, p1, c0, c1)
    if abs(math.sqrt(x @ x) - r) < CLEAR or abs(math.sqrt((x + v) @ (x + v)) - r) < CLEAR:
        return ""
    if x @ x < r * r:
        return "touching" if v @ v > 1.0 else ""
    if np.abs(v).max() < 1e-9:
        return "together"
    found = find_roots(x, v, r)
    grazed = (find_roots(x, v, r - CLEAR) is None) != (find_roots(x, v, r + CLEAR) is None)
    if grazed or v @ v < 1.0:
        return ""
    if found is None:
        return "crosses" if segments_intersect(p0, p1, c0, c1) else ""
    return "meets" if 0.0 < found[0] < 1.0 else "outside"


def make_case(kind: str, p0: object, p1: object, c0: object, c1: object, r: float) -> Case:
    """Return a case of two motions."""
    places = {
        name: np.array(place, float)
        for name, place in (("p0", p0), ("p1", p1), ("c0", c0), ("c1", c1))
    }
    return Case(kind, {**places, "r": float(r)})
