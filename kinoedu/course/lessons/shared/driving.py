"""Shared parts of the exercises on the motion of a car. LaValle, section 13.1.2."""

import math
from collections.abc import Callable
from typing import Any

import numpy as np

from ....curves.arcs import drive_arc
from ....geometry.checks import Array
from ....spaces.angles import angle_difference, wrap_angle
from ...exercise import ValueExercise
from ...shapes import Numbers, Value
from ...withheld import withheld

POSE = Numbers((3,))
Mover = Callable[[Array, float, float, float, float], Any]


@withheld
def pose_after(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Array:
    """Pose after a control was held for a time t, shape (3,)."""
    return np.array(drive_arc(pose[0], pose[1], pose[2], v * t, math.tan(phi) / wheelbase))


class PoseExercise(ValueExercise):
    """An exercise whose answers are poses; headings count modulo whole turns."""

    lesson = "12_the_car"

    def same(self, value: Value, truth: Value) -> bool:
        """Compare positions as numbers and headings as directions."""
        found, wanted = np.reshape(value, (-1, 3)), np.reshape(truth, (-1, 3))
        if not np.isfinite(found).all() or not super().same(found[:, :2], wanted[:, :2]):
            return False
        return all(
            abs(angle_difference(wrap_angle(a), wrap_angle(b))) <= self.tolerance
            for a, b in zip(found[:, 2], wanted[:, 2])
        )


def with_curvature(bend: Callable[[float, float], float]) -> Mover:
    """A program that drives a curvature other than tan(phi) / L."""
    return lambda pose, v, phi, t, wheelbase: drive_arc(*pose, v * t, bend(phi, wheelbase))


def without_turning(pose: Array, v: float, phi: float, t: float, wheelbase: float) -> Array:
    """A program whose position is right and whose heading does not change."""
    return np.array([*pose_after(pose, v, phi, t, wheelbase)[:2], pose[2]])


def a_pose(rng: np.random.Generator) -> Array:
    """Random pose with two digits."""
    return np.round([*rng.uniform(-50, 50, 2), rng.uniform(-3.1, 3.1)], 2)
