"""The configuration of a two-link arm after a pull on its elbow or tip."""

import math

import numpy as np

from ..compiled import compiled
from ..geometry.checks import Array
from ..spaces.angles import angle_difference, wrap_angle
from .arm import ArmRobot, joints_at, solve_two_links


@compiled
def pull_elbow(arm: ArmRobot, q: Array, elbow: Array) -> Array:
    """The elbow turns link 1, and link 2 keeps its angle to it."""
    return np.array([heading(arm.base, elbow, q[0]), q[1]])


@compiled
def pull_elbow_and_tip(arm: ArmRobot, q: Array, elbow: Array, tip: Array) -> Array:
    """Both set the headings of the links, whatever the distances are."""
    first = heading(arm.base, elbow, q[0])
    return np.array([first, wrap_angle(heading(elbow, tip, first + q[1]) - first)])


@compiled
def pull_tip(arm: ArmRobot, q: Array, tip: Array) -> Array:
    """The tip goes as near to its place as it can, by the solution nearer to q."""
    x, y = tip[0] - arm.base[0], tip[1] - arm.base[1]
    if arm.lengths[0] == arm.lengths[1] and x == 0.0 and y == 0.0:  # every heading fits
        return np.array([q[0], -math.pi])
    p = nearest_reachable(arm, q, tip)
    solutions = solve_two_links(
        arm.lengths[0], arm.lengths[1], p[0] - arm.base[0], p[1] - arm.base[1]
    )
    best, least = 0, np.inf
    for k in range(len(solutions)):
        a, b = angle_difference(solutions[k, 0], q[0]), angle_difference(solutions[k, 1], q[1])
        apart = math.sqrt(a * a + b * b)
        if apart < least:
            best, least = k, apart
    return solutions[best].copy()


@compiled
def nearest_reachable(arm: ArmRobot, q: Array, p: Array) -> Array:
    """The reachable place of the tip that is nearest to p.

    Ties go to the one in the direction of the tip.
    """
    inner, outer = abs(arm.lengths[0] - arm.lengths[1]), arm.lengths[0] + arm.lengths[1]
    dx, dy = p[0] - arm.base[0], p[1] - arm.base[1]
    far = math.sqrt(dx * dx + dy * dy)
    if inner <= far <= outer:
        return p
    ends = np.empty((3, 2))
    joints_at(arm.lengths, arm.base, q, ends)
    angle = heading(arm.base, p, heading(arm.base, ends[2], q[0]))
    reach = min(max(far, inner), outer)
    return np.array([arm.base[0] + reach * math.cos(angle), arm.base[1] + reach * math.sin(angle)])


@compiled
def heading(a: Array, b: Array, otherwise: float) -> float:
    """The direction from a to b; `otherwise` where they are the same point."""
    if a[0] == b[0] and a[1] == b[1]:
        return wrap_angle(otherwise)
    return wrap_angle(math.atan2(b[1] - a[1], b[0] - a[0]))


def pull_arm(arm: ArmRobot, q: Array, elbow: Array | None, tip: Array | None) -> Array:
    """The configuration after a pull on the elbow, on the tip, or on both; None means no pull."""
    if elbow is not None:
        if tip is not None:
            return np.asarray(pull_elbow_and_tip(arm, q, elbow, tip))
        return np.asarray(pull_elbow(arm, q, elbow))
    return q if tip is None else np.asarray(pull_tip(arm, q, tip))
