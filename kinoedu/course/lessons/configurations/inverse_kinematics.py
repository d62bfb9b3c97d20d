"""The exercise `inverse_kinematics`. Bullo & Smith, chapter 3."""

from collections.abc import Iterator
from functools import partial
from math import acos, atan, atan2, cos, hypot, pi, sin

import numpy as np

from ....geometry.checks import Array
from ....robots import TwoLinkArm
from ....robots.arm import ArmRobot
from ...exercise import Axes, Case, Restated, Slip, ValueExercise, Verdict
from ...outcomes import Answer, Outcome, Raised
from ...shapes import Number, Numbers, Record, Value
from ...withheld import withheld
from .arm_cases import PAIR, arm_case
from .exposing_reach import inverse_by_sines
from .pictures import draw_solutions

# points whose distance from the origin is an integer
WHOLE_CORNERS = np.array([(3, 4), (5, 12), (8, 15), (7, 24), (20, 21), (5, 0)])
NEARLY = 0.05  # angles that are so near have probably been computed from rounded numbers


@withheld
def arm_solutions(l1: float, l2: float, p: Array) -> Array:
    """Every q with the tip at p, shape (k, 2).

    Raises
    ------
    InvalidPoint
        Where there are infinitely many.
    """
    return np.array(TwoLinkArm(l1, l2, 0.0).inverse(p)).reshape(-1, 2)


def half_mirrored(first: int, signs: tuple[int, int], l1: float, l2: float, p: Array) -> Array:
    """One solution and a wrong mirror image of it.

    The wrong image keeps link 1 unchanged, or mirrors it in the x-axis.
    """
    one = arm_solutions(l1, l2, p)[first:][:1]
    return np.vstack([one, one * signs])


class InverseKinematics(ValueExercise):
    """All pairs of angles with the tip at a given place."""

    name = "inverse_kinematics"
    lesson = "05_configuration_spaces"
    kinds = ("two", "too_far", "too_near", "outer_rim", "inner_rim", "endless")
    given = Record(l1=Number(), l2=Number(), p=PAIR)
    answer = Numbers(("k", 2))
    source = staticmethod(arm_solutions)
    shown = staticmethod(ArmRobot.inverse)
    slips = (
        Slip("one", lambda l1, l2, p: arm_solutions(l1, l2, p)[:1]),
        Slip("one", lambda l1, l2, p: arm_solutions(l1, l2, p)[-1:]),
        *(
            Slip("half_mirrored", partial(half_mirrored, first, signs))
            for first in (0, -1)
            for signs in ((1, -1), (-1, -1))
        ),
        Slip("mixed", lambda l1, l2, p: arm_solutions(l1, l2, p) * (1, -1)),
        Slip("absolute", lambda l1, l2, p: [(q[0], q[0] + q[1]) for q in arm_solutions(l1, l2, p)]),
        Slip("half_plane", lambda l1, l2, p: by_cosines(l1, l2, p, atan(p[1] / p[0]))),
        Slip("no_heading", lambda l1, l2, p: by_cosines(l1, l2, p, 0.0)),
        Slip("axes", lambda l1, l2, p: arm_solutions(l1, l2, p[::-1])),
        Slip(
            "exchanged", lambda l1, l2, p: by_cosines(l1, l2, p, atan2(p[1], p[0]), exchanged=True)
        ),
        Slip("sines", inverse_by_sines),
        Slip(
            "inner_angle",
            lambda l1, l2, p: [
                (q[0], np.sign(q[1]) * (pi - abs(q[1]))) for q in arm_solutions(l1, l2, p)
            ],
        ),
        Slip("inner_angle", lambda l1, l2, p: by_inner_angle(l1, l2, p)),
        Slip("degrees", lambda l1, l2, p: np.degrees(arm_solutions(l1, l2, p))),
        Slip("degrees", lambda l1, l2, p: np.degrees(by_cosines(l1, l2, p, atan2(p[1], p[0])))),
    )
    reference = staticmethod(arm_solutions)

    changes = (
        Restated(
            "absolute",
            answer=lambda rows, *given: np.reshape(rows, (-1, 2)) @ [[1.0, 1.0], [0.0, 1.0]],
            usual_answer=lambda rows, *given: np.reshape(rows, (-1, 2)) @ [[1.0, -1.0], [0.0, 1.0]],
        ),
        Restated("clockwise", answer=lambda rows, *given: np.negative(np.reshape(rows, (-1, 2)))),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Integers first, and always at the rims."""
        for kind, l1, l2, p in (
            ("two", 2, 1, (2, 1)),
            ("two", 1, 1, (1, 1)),
            ("two", 2, 1, (0, 2)),
            ("too_far", 2, 1, (4, 0)),
            ("outer_rim", 2, 1, (3, 0)),
            ("too_near", 3, 1, (1, 0)),
            ("inner_rim", 3, 1, (2, 0)),
            ("two", 2, 1, (-2, -1)),
            ("two", 1, 1, (0, -0.5)),
            ("two", 1, 1, (0.03, 0.04)),
            ("outer_rim", 2, 3, (-3, 4)),
            ("inner_rim", 1, 3, (2, 0)),
            ("too_near", 1, 3, (1, 0)),
            ("too_near", 2, 1, (0, 0)),
            ("endless", 1, 1, (0, 0)),
        ):
            yield arm_case(kind, l1, l2, p=p)
        for number in range(25):
            yield from random_targets(rng, (1.0, 3.0, 10.0, 100.0, 1000.0)[number // 5])

    def same(self, value: object, truth: object) -> bool:
        """Compare sets of configurations, up to order, repetition and whole turns."""
        found, wanted = (
            np.asarray(value, float).reshape(-1, 2),
            np.asarray(truth, float).reshape(-1, 2),
        )
        within = self.tolerance
        return are_among(found, wanted, within) and are_among(wanted, found, within)

    def judge(self, case: Case, outcome: Outcome) -> Verdict:
        """Judge an outcome; a ValueError breaks the rule for the kind of target.

        It may be the student's own ValueError, or one that acos raised.
        """
        verdict = super().judge(case, outcome)
        if (
            isinstance(outcome, Raised)
            and "ValueError" in outcome.kinds
            and verdict.rule == "raised"
        ):
            return verdict._replace(rule="refused" if case.kind == "two" else case.kind)
        return verdict

    def value_verdict(self, case: Case, value: Value) -> Verdict:
        """Check that every listed configuration is right, then that none is missing."""
        verdict, truth = super().value_verdict(case, value), self.truth(case)
        if verdict.is_right or len(truth) == 0 or are_among(value, truth, self.tolerance):
            return verdict
        return verdict._replace(rule="digits" if are_among(value, truth, NEARLY) else "reaches")

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the arm's reach, the target, and the arms with their tip there."""
        draw_solutions(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def are_among(some: Array, others: Array, within: float) -> bool:
    """Whether each of some configurations is one of others, up to an angle; nan is none."""
    with np.errstate(all="ignore"):
        apart = np.abs(np.remainder(some[:, None] - others[None] + pi, 2.0 * pi) - pi)
        return bool(np.all(np.any(np.all(apart <= within, axis=2), axis=1)))


def random_targets(rng: np.random.Generator, size: float) -> Iterator[Case]:
    """Random target of each kind: exactly on the rims with integers, else off them.

    Some are only a little more than a hundredth of l1 + l2 off a rim, or have equal links.
    """
    l1, l2 = np.round(rng.uniform(0.3, 1.0, 2) * size, 2)
    l2 = l1 if rng.random() < 0.3 else l2
    inner, outer = abs(l1 - l2), l1 + l2
    angle = rng.uniform(-pi, pi)
    direction = np.array([np.cos(angle), np.sin(angle)])
    margin = 0.013 * outer
    share = rng.choice([0.0, rng.random(), rng.random() ** 2, 1.0])  # 0 and 1 are near the rims
    reach = inner + margin + share * (outer - inner - 2.0 * margin)
    yield arm_case("two", l1, l2, p=np.round(reach * direction, 3))
    reach = rng.choice([1.013, rng.uniform(1.013, 2.0)]) * outer
    yield arm_case("too_far", l1, l2, p=np.round(reach * direction, 3))
    reach = rng.choice([0.73, rng.uniform(0.1, 0.73)]) * l1
    yield arm_case("too_near", *rng.permutation([l1, l1 / 4]), p=np.round(reach * direction, 3))
    corner = rng.choice(WHOLE_CORNERS) * rng.choice([-1, 1], 2)
    distance = int(hypot(*corner))
    first, swap = int(rng.integers(1, distance)), rng.permutation([0, 1])
    yield arm_case("outer_rim", first, distance - first, p=corner[swap])
    yield arm_case(
        "inner_rim", *np.array([first, distance + first])[rng.permutation([0, 1])], p=corner[swap]
    )
    yield arm_case("endless", l1, l1, p=(0.0, 0.0))


def by_inner_angle(l1: float, l2: float, p: Array) -> list[tuple[float, float]]:
    """Both solutions, with the inner angle of the triangle in place of the second angle."""
    distance, heading = hypot(*p), atan2(p[1], p[0])
    bend = acos((l1 * l1 + l2 * l2 - distance * distance) / (2.0 * l1 * l2))
    lead = atan2(l2 * sin(bend), l1 + l2 * cos(bend))
    return [(heading - lead, bend), (heading + lead, -bend)]


def by_cosines(
    l1: float, l2: float, p: Array, heading: float, *, exchanged: bool = False
) -> list[tuple[float, float]]:
    """Both solutions by the law of cosines, with the first angle counted from a heading.

    `exchanged` exchanges the sides of the triangle at the base.
    """
    distance = hypot(*p)
    bend = acos((distance * distance - l1 * l1 - l2 * l2) / (2.0 * l1 * l2))
    a, b = (l2, l1) if exchanged else (l1, l2)
    lead = acos((a * a + distance * distance - b * b) / (2.0 * a * distance))
    return [(heading - lead, bend), (heading + lead, -bend)]
