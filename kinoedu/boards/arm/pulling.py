"""What becomes of an arm of two links when its elbow or its tip is pulled somewhere."""

import math

import numpy as np

from ...geometry.checks import Array
from ...robots.arm import ArmRobot
from ...spaces import torus_distance
from ...spaces.angles import wrapped


def pulled(arm: ArmRobot, q: Array, elbow: Array | None, tip: Array | None) -> Array:
    """The configuration after a pull on the elbow, on the tip, or on both, shape (2,); None is not
    pulled.

    The elbow turns link 1 and takes link 2 along as it is bent. The tip goes as near as it can, by
    the solution nearer to q. Both together give their two headings, whatever their distances are.
    """
    if elbow is not None:
        first = heading(arm.base, elbow, q[0])
        return np.array(
            [first, q[1] if tip is None else wrapped(heading(elbow, tip, first + q[1]) - first)]
        )
    if tip is None:
        return q
    solutions = (
        arm.inverse(nearest_reached(arm, q, tip))
        if not folds_onto_base(arm, tip)
        else [np.array([q[0], -math.pi])]
    )
    return min(solutions, key=lambda solution: float(torus_distance(solution, q)))


def nearest_reached(arm: ArmRobot, q: Array, p: Array) -> Array:
    """The place nearest to p at which a two-link arm can put its tip; of equally near ones, that in
    the tip's own direction.
    """
    inner, outer = abs(arm.lengths[0] - arm.lengths[1]), arm.lengths.sum()
    far = math.dist(arm.base, p)
    if inner <= far <= outer:
        return p
    angle = heading(arm.base, p, heading(arm.base, arm.joints(q)[-1], q[0]))
    return arm.base + min(max(far, inner), outer) * np.array([math.cos(angle), math.sin(angle)])


def folds_onto_base(arm: ArmRobot, p: Array) -> bool:
    """Whether the tip lies on the base at p, where an arm of equal links may have any heading."""
    return bool(arm.lengths[0] == arm.lengths[1] and (p == arm.base).all())


def heading(a: Array, b: Array, otherwise: float) -> float:
    """The angle of the way from a to b; where they are one place, another."""
    return wrapped(math.atan2(b[1] - a[1], b[0] - a[0]) if (a != b).any() else otherwise)
