"""The exercise `move`. LaValle, section 13.1.2."""

import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike

from ....curves.arcs import drive_arc
from ....geometry.checks import Array
from ...exercise import Axes, Case, Slip
from ...outcomes import Answer, Outcome
from ...shapes import Number, Record, Value
from ..shared.car_pictures import draw_moves
from ..shared.driving import (
    POSE,
    Mover,
    PoseExercise,
    a_pose,
    pose_after,
    with_curvature,
    without_turning,
)


def along_heading(share: float) -> Mover:
    """A wrong program that goes straight all the distance.

    It uses the heading after the given fraction of the turn.
    """

    def mistaken(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Value:
        turn = v * t * math.tan(phi) / wheelbase
        heading = pose[2] + share * turn
        return (
            pose[0] + v * t * math.cos(heading),
            pose[1] + v * t * math.sin(heading),
            pose[2] + turn,
        )

    return mistaken


def steered(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Value:
    """A wrong program whose car moves where its front wheels point, along theta + phi."""
    x, y, heading = pose_after(pose + np.array([0.0, 0.0, phi]), v, phi, t, wheelbase)
    return x, y, heading - phi


def straight_if_small(below: float, kept: float) -> Mover:
    """A wrong program that goes straight where an angle or a turn is small, but not negligible.

    Parameters
    ----------
    below : the least angle and turn that it does not ignore.
    kept : the fraction of a small turn that it adds to the heading all the same.
    """

    def mistaken(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Value:
        turn = v * t * math.tan(phi) / wheelbase
        if min(abs(phi), abs(turn)) >= below:
            return pose_after(pose, v, phi, t, wheelbase)
        x, y, heading = pose_after(pose, v, 0.0, t, wheelbase)
        return x, y, heading + kept * turn

    return mistaken


def turning_one_way(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Value:
    """A wrong program whose heading turns to the same side backwards as forwards."""
    half = abs(v) * t * math.tan(phi) / wheelbase / 2
    chord = v * t * (math.sin(half) / half if half else 1.0)
    heading = pose[2] + half
    return (
        pose[0] + chord * math.cos(heading),
        pose[1] + chord * math.sin(heading),
        heading + half,
    )


def along_the_axis(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Array:
    """A wrong program that adds the motion of a car which starts along the x-axis."""
    origin = np.zeros(3)
    return pose + pose_after(origin, v, phi, t, wheelbase)


def heading_modulo_pi(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Array:
    """A wrong program whose heading has lost half turns."""
    x, y, heading = pose_after(pose, v, phi, t, wheelbase)
    return np.array([x, y, heading % math.pi])


def round_the_other_side(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Array:
    """A wrong program with the opposite sign of the cosines in a turn."""
    right = pose_after(pose, v, phi, t, wheelbase)
    if phi == 0.0:
        return right
    return np.array([right[0], 2.0 * pose[1] - right[1], right[2]])


class Move(PoseExercise):
    """One control, held for a time, in closed form."""

    name = "move"
    kinds = ("straight", "left", "right", "back", "long", "nearly")
    given = Record(pose=POSE, v=Number(), phi=Number(), t=Number(), L=Number())
    answer = POSE
    source = staticmethod(pose_after)
    shown = staticmethod(drive_arc)
    slips = (
        Slip("small_angle", with_curvature(lambda phi, wheelbase: phi / wheelbase)),
        Slip("no_wheelbase", with_curvature(lambda phi, wheelbase: math.tan(phi))),
        Slip("sine", with_curvature(lambda phi, wheelbase: math.sin(phi) / wheelbase)),
        Slip(
            "degrees",
            with_curvature(lambda phi, wheelbase: math.tan(math.radians(phi)) / wheelbase),
        ),
        Slip("clockwise", with_curvature(lambda phi, wheelbase: -math.tan(phi) / wheelbase)),
        Slip("one_step", along_heading(0.0)),
        Slip("new_heading", along_heading(1.0)),
        Slip("arc_for_chord", along_heading(0.5)),
        Slip("no_turn", without_turning),
        Slip("no_heading", along_the_axis),
        Slip(
            "no_heading", lambda *given: along_the_axis(*given) if given[2] else pose_after(*given)
        ),
        Slip("half_turns", heading_modulo_pi),
        Slip("steered", steered),
        Slip("straight_if_small", straight_if_small(0.03, 0.0)),
        Slip("straight_if_small", straight_if_small(0.03, 1.0)),
        Slip("straight_if_small", straight_if_small(1e-4, 0.0)),
        Slip("straight_if_small", straight_if_small(1e-4, 1.0)),
        Slip("straight_if_small", straight_if_small(1e-5, 0.0)),
        Slip("other_side", round_the_other_side),
        Slip("one_way", turning_one_way),
        Slip(
            "forward",
            lambda pose, v, phi, t, wheelbase: pose_after(pose, abs(v), phi, t, wheelbase),
        ),
    )
    reference = staticmethod(pose_after)

    def cases(self, rng: np.random.Generator) -> Iterator[Case]:
        """Integers and quarter circles first."""
        eighth, quarter = math.pi / 4, math.pi / 2
        for kind, first_pose, v, phi, t, size in (
            ("straight", (1, 2, 0), 1, 0, 5, 20),
            ("straight", (0, 0, quarter), 2, 0, 3, 1),
            ("left", (0, 0, 0), 1, eighth, 20 * quarter, 20),
            ("right", (0, 0, 0), 1, -eighth, 20 * quarter, 20),
            ("back", (0, 0, 0), -1, eighth, 20 * quarter, 20),
            ("back", (3, 4, 1), -2, 0, 5, 20),
            ("long", (0, 0, 0), 1, eighth, 50 * quarter, 10),
            ("nearly", (0, 0, 1), 1, 1e-12, 10, 20),
            ("left", (0, 0, 0), 1, 0.01, 30, 20),
            ("right", (0, 0, 0), 1, -0.01, 30, 20),
            ("back", (0, 0, 0), -1, 0.01, 30, 20),
            ("left", (0, 0, 0), 1, 0.01, 0.15, 50),
            ("right", (0, 0, 0), 1, -0.01, 0.15, 50),
            ("back", (0, 0, 0), -1, 0.01, 0.15, 50),
            ("left", (0, 0, 0), 1, 0.01, 0.01, 50),
            ("right", (0, 0, 0), 1, -0.01, 0.01, 50),
            ("back", (0, 0, 0), -1, 0.01, 0.01, 50),
            ("left", (3, 4, 1), 1, eighth, 0, 20),
            ("right", (3, 4, 1), 0, -eighth, 5, 20),
        ):
            yield drive_case(kind, first_pose, v, phi, t, size)
        for _ in range(12):
            pose, size = a_pose(rng), np.round(rng.uniform(2, 30), 1)
            phi, far = np.round(rng.uniform(0.05, 0.78), 2), rng.choice([0.01, 1.0], p=[0.2, 0.8])
            t = np.round(rng.uniform(0.3, 1.5) * far * size, 3)
            speed, side = float(rng.choice([0.5, 1.0, 2.0])), rng.choice([-1, 1])
            yield drive_case("straight", pose, speed, 0, t, size)
            yield drive_case("left", pose, speed, phi, t, size)
            yield drive_case("right", pose, speed, -phi, t, size)
            yield drive_case("back", pose, -speed, side * phi, t, size)
            long = np.round(rng.uniform(25, 60) * size, 1)
            yield drive_case("long", pose, speed, side * max(phi, 0.3), long, size)
            tiny = side * 10.0 ** -int(rng.integers(11, 15))
            yield drive_case("nearly", pose, 1, tiny, np.round(rng.uniform(5, 30), 1), size)

    def draw(self, case: Case, outcome: Outcome, ax: Axes) -> None:
        """Draw the driven arc, and the student's final pose."""
        draw_moves(self, case, outcome.value if isinstance(outcome, Answer) else None, ax)


def drive_case(
    kind: str, pose: ArrayLike, v: float, phi: float, t: float, wheelbase: float
) -> Case:
    """Case of one control."""
    numbers = {"v": float(v), "phi": float(phi), "t": float(t), "L": float(wheelbase)}
    return Case(kind, {"pose": np.array(pose, float), **numbers})
