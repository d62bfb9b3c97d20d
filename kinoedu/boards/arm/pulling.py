"""The configuration of a two-link arm after a pull on its elbow or tip."""

import math

import numpy as np

from ...geometry.checks import Array
from ...robots.arm import ArmRobot
from ...spaces import torus_distance
from ...spaces.angles import wrap_angle


def pull_arm(arm: ArmRobot, q: Array, elbow: Array | None, tip: Array | None) -> Array:
    """The configuration after a pull on the elbow, on the tip, or on both, shape (2,).

    A pull on the elbow turns link 1, and link 2 keeps its angle to it. A pull on the tip moves it
    as near as it can come, by the solution nearer to q. Pulls on both set the two headings,
    whatever the distances are. None means no pull.
    """
    if elbow is not None:
        first = heading(arm.base, elbow, q[0])
        second = q[1] if tip is None else wrap_angle(heading(elbow, tip, first + q[1]) - first)
        return np.array([first, second])
    if tip is None:
        return q
    if folds_onto_base(arm, tip):
        return np.array([q[0], -math.pi])
    solutions = arm.inverse(nearest_reachable(arm, q, tip))
    return min(solutions, key=lambda solution: float(torus_distance(solution, q)))


def nearest_reachable(arm: ArmRobot, q: Array, p: Array) -> Array:
    """The reachable place of the tip that is nearest to p.

    Ties go to the one in the direction of the tip.
    """
    inner, outer = abs(arm.lengths[0] - arm.lengths[1]), arm.lengths.sum()
    far = math.dist(arm.base, p)
    if inner <= far <= outer:
        return p
    angle = heading(arm.base, p, heading(arm.base, arm.joints(q)[-1], q[0]))
    return arm.base + min(max(far, inner), outer) * np.array([math.cos(angle), math.sin(angle)])


def folds_onto_base(arm: ArmRobot, p: Array) -> bool:
    """Whether p is the base and the links are equal, so that any heading reaches p."""
    return bool(arm.lengths[0] == arm.lengths[1] and (p == arm.base).all())


def heading(a: Array, b: Array, otherwise: float) -> float:
    """The direction from a to b; `otherwise` where they are the same point."""
    return wrap_angle(math.atan2(b[1] - a[1], b[0] - a[0]) if (a != b).any() else otherwise)
