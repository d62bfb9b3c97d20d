"""The exercise `forward_kinematics`. Bullo & Smith, chapter 3."""

from collections.abc import Iterator
from functools import partial
from math import pi

import numpy as np
from numpy.typing import ArrayLike

from ....geometry.checks import Array
from ....robots import TwoLinkArm
from ....robots.arm import joints_at
from ...exercise import Axes, Case, Restated, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Number, Numbers, Record
from ...withheld import withheld
from .arm_cases import PAIR, arm_case
from .pictures import draw_joints


@withheld
def arm_joints(l1: float, l2: float, q: ArrayLike) -> Array:
    """Elbow and tip of an arm at the origin, shape (2, 2)."""
    return np.array(TwoLinkArm(l1, l2, 0.0).joints(q))


def from_x_axis(l1: float, l2: float, q: Array) -> tuple[float, float, Array]:
    """Measure both angles from the x-axis."""
    return l1, l2, np.array([q[0], q[0] + q[1]])


def from_first_link(l1: float, l2: float, q: Array) -> tuple[float, float, Array]:
    """Measure the second angle from link 1 again."""
    return l1, l2, np.array([q[0], q[1] - q[0]])


def with_rounded_sines(digits: int, l1: float, l2: float, q: Array) -> Array:
    """Elbow and tip, with sines and cosines of few digits."""
    elbow, tip = arm_joints(1.0, 1.0, q)
    first, second = np.round([elbow, tip - elbow], digits)
    return np.array([l1 * first, l1 * first + l2 * second])


def rounded_joints(digits: int, l1: float, l2: float, q: Array) -> Array:
    """Elbow and tip with few digits."""
    return np.round(arm_joints(l1, l2, q), digits)


class ForwardKinematics(ValueExercise):
    """Elbow and tip, from two angles."""

    name = "forward_kinematics"
    lesson = "05_configuration_spaces"
    kinds = ("stretched", "bent", "folded", "turns")
    given = Record(l1=Number(), l2=Number(), q=PAIR)
    answer = Numbers((2, 2))
    source = staticmethod(arm_joints)
    shown = staticmethod(joints_at)
    slips = (
        Slip("absolute", lambda l1, l2, q: arm_joints(l1, l2, (q[0], q[1] - q[0]))),
        Slip("swapped", lambda l1, l2, q: arm_joints(l1, l2, q)[::-1]),
        Slip(
            "from_elbow",
            lambda l1, l2, q: np.array(
                [arm_joints(l1, l2, q)[0], np.diff(arm_joints(l1, l2, q), axis=0)[0]]
            ),
        ),
        Slip("same_array", lambda l1, l2, q: arm_joints(l1, l2, q)[[1, 1]]),
        Slip("difference", lambda l1, l2, q: arm_joints(l1, l2, (q[0], -q[1]))),
        Slip("axes", lambda l1, l2, q: arm_joints(l1, l2, q)[:, ::-1]),
        Slip("one_length", lambda l1, l2, q: arm_joints(l1, l1, q)),
        Slip("columns", lambda l1, l2, q: arm_joints(l1, l2, q).T),
        *(Slip("rounded", partial(with_rounded_sines, digits)) for digits in (1, 2, 3, 4)),
        *(Slip("rounded", partial(rounded_joints, digits)) for digits in (1, 2, 3, 4)),
        Slip("degrees", lambda l1, l2, q: arm_joints(l1, l2, np.radians(q))),
    )
    reference = staticmethod(arm_joints)

    changes = (
        Restated("absolute", given=from_x_axis, usual_given=from_first_link),
        Restated("clockwise", given=lambda l1, l2, q: (l1, l2, -q + 0.0)),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Quarter turns first."""
        for kind, l1, l2, q in (
            ("stretched", 2, 1, (0, 0)),
            ("stretched", 2, 1, (pi / 2, 0)),
            ("bent", 2, 1, (0, pi / 2)),
            ("bent", 2, 1, (pi / 2, pi / 2)),
            ("folded", 2, 1, (0, pi)),
            ("bent", 1, 2, (1, -0.5)),
            ("turns", 2, 1, (7, -8)),
        ):
            yield arm_case(kind, l1, l2, q=q)
        for size in (1.0, 3.0, 3.0, 10.0, 100.0):
            for _ in range(3):
                l1, l2 = np.round(rng.uniform(0.2, 1.0, 2) * size, 2)
                first, second = np.round(rng.uniform(-3.1, 3.1, 2), 2)
                yield arm_case("stretched", l1, l2, q=(first, 0.0))
                yield arm_case("bent", l1, l2, q=(first, second))
                yield arm_case("folded", l1, l2, q=(first, rng.choice([-pi, pi])))
                turned = np.round(rng.uniform(4.0, 30.0, 2) * rng.choice([-1, 1], 2), 2)
                yield arm_case("turns", l1, l2, q=turned)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the arm and the student's arm."""
        draw_joints(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)
