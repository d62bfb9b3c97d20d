"""The exercise on degrees of freedom of planar bodies with pins. Bullo & Smith, chapter 3."""

from collections.abc import Iterator

import numpy as np

from ...exercise import Axes, Case, Change, Slip, ValueExercise
from ...outcomes import Answer, Outcome
from ...shapes import Listed, Number, Record
from ...whole_shapes import Integer
from ...withheld import withheld
from .pictures import draw_mechanism

Joints = list[list[int]]


@withheld
def freedoms(bodies: int, joints: Joints) -> int:
    """Three for each moving body, minus two for each body beyond the first of each pin."""
    return 3 * bodies - sum(2 * (len(held) - 1) for held in joints)


class DegreesOfFreedom(ValueExercise):
    """The number of degrees of freedom of a mechanism of bars and pins."""

    name = "degrees_of_freedom"
    lesson = "05_configuration_spaces"
    kinds = ("loose", "arm", "loop", "shared", "rigid")
    given = Record(bodies=Integer(), joints=Listed(Listed(Integer())))
    answer = Number()
    source = staticmethod(freedoms)
    slips = (
        Slip("ground", lambda bodies, joints: freedoms(bodies + 1, joints)),
        Slip("less_one", lambda bodies, joints: freedoms(bodies - 1, joints)),
        Slip("no_pin", lambda bodies, joints: freedoms(bodies, joints) if joints else 3),
        Slip("shared", lambda bodies, joints: 3 * bodies - 2 * len(joints)),
        Slip(
            "three", lambda bodies, joints: 3 * bodies - 3 * sum(len(held) - 1 for held in joints)
        ),
        Slip("one", lambda bodies, joints: 3 * bodies - sum(len(held) - 1 for held in joints)),
        Slip(
            "points",
            lambda bodies, joints: 2 * bodies - sum(2 * (len(held) - 1) for held in joints),
        ),
        Slip(
            "every_body", lambda bodies, joints: 3 * bodies - sum(2 * len(held) for held in joints)
        ),
        Slip(
            "every_body",
            lambda bodies, joints: 3 * bodies - sum(2 * np.count_nonzero(held) for held in joints),
        ),
        Slip("pins", lambda bodies, joints: len(joints)),
        Slip("no_pins", lambda bodies, joints: 3 * bodies),
        Slip("never_less", lambda bodies, joints: max(0, freedoms(bodies, joints))),
    )
    reference = staticmethod(freedoms)

    changes = (
        Change("moving_ground", lambda count, bodies, joints: count(bodies, joints) + 3),
        Change("slots", lambda count, bodies, joints: (count(bodies, joints) + 3 * bodies) / 2),
    )

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """One body without pins first."""
        for kind, bodies, joints in (
            ("loose", 1, []),
            ("arm", 1, [[0, 1]]),
            ("arm", 2, [[0, 1], [1, 2]]),
            ("loose", 2, [[1, 2]]),
            ("loose", 3, [[1, 2]]),
            ("loose", 4, [[1, 2]]),
            ("loop", 3, [[0, 1], [1, 2], [2, 3], [0, 3]]),
            ("shared", 2, [[0, 1, 2]]),
            ("shared", 3, [[1, 2, 3]]),
            ("rigid", 2, [[0, 1], [1, 2], [0, 2]]),
            ("rigid", 3, [[0, 1], [1, 2], [2, 3], [0, 3], [0, 2]]),
            ("loop", 3, [[1, 2], [2, 3], [1, 3]]),
            ("loose", 2, []),
            ("arm", 2, [[1, 0], [1, 2]]),
            ("shared", 2, [[1, 0, 2]]),
            ("rigid", 2, [[0, 1], [1, 2], [1, 2]]),
        ):
            yield Case(kind, {"bodies": bodies, "joints": joints})
        for bodies in range(2, 8):
            for kind in self.kinds * 2:
                yield Case(
                    kind, {"bodies": bodies + 1, "joints": random_joints(rng, kind, bodies + 1)}
                )

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw bodies, pins and the ground, and both numbers."""
        draw_mechanism(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def random_joints(rng: np.random.Generator, kind: str, bodies: int) -> Joints:
    """Random pins that connect all bodies, and the ground unless the kind is "loose".

    The bodies of a pin come in any order, and two pins may hold the same bodies.
    """
    ground = 1 if kind == "loose" else 0
    joints = [[int(rng.integers(ground, body)), body] for body in range(ground + 1, bodies + 1)]
    while (kind == "loop" and len(joints) < bodies + 1) or (
        kind == "rigid" and freedoms(bodies, joints) > rng.integers(-1, 1)
    ):
        joints.append(sorted(map(int, rng.choice(np.arange(bodies + 1), 2, replace=False))))
    if kind == "shared":
        held = rng.choice(
            np.arange(bodies + 1), int(rng.integers(3, min(bodies, 4) + 1)), replace=False
        )
        joints = [joint for joint in joints if joint[1] not in held] + [sorted(map(int, held))]
    return [list(map(int, rng.permutation(joint))) for joint in joints]
