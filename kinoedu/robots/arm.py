"""Planar arms: bars with rounded ends, joined one after another. Bullo & Smith, chapter 3."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ..compiled import compiled
from ..errors import InvalidPoint, InvalidRobot
from ..geometry.checks import Array, as_array, as_point
from ..geometry.exact import length
from ..geometry.parts import Parts, make_parts
from ..spaces.angles import wrap_angle
from ..support.constructors import Constructor, with_type_names
from ..support.text import distinct_numbers, shortened

RIM = 1e-12  # of the arm's length: a target so near to the rim of the reachable ring is on it


@with_type_names
class ArmRobot(NamedTuple):
    """The record that `TwoLinkArm` and `ArmChain` return.

    lengths : (n,), the lengths of the links.
    base : (2,), the position of the first joint.
    shape : Parts, each link as a bar along the x-axis of its own frame.

    A configuration q has n angles: the angle of the first link from the x-axis, and the angle of
    each other link from the link before it.
    """

    lengths: Array
    base: Array
    shape: Parts

    def joints(self, q: ArrayLike) -> tuple[Array, ...]:
        """The end point of each link: elbow and tip for two links (forward kinematics).

        Returns
        -------
        tuple of n arrays (2,).

        Raises
        ------
        InvalidPoint
            Where q is not n finite angles.

        Examples
        --------
        >>> elbow, tip = TwoLinkArm(2, 1, 0.2).joints((0, np.pi / 2))
        >>> elbow, tip.round(12)
        (array([2., 0.]), array([2., 1.]))
        """
        angles = as_array(q, "q")
        if angles.shape != self.lengths.shape:
            raise InvalidPoint(
                f"q must be {len(self.lengths)} angles, one for each link, got {shortened(q)}"
            )
        ends = np.empty((len(angles) + 1, 2))
        joints_at(self.lengths, self.base, angles, ends)
        return tuple(ends[1:])

    def inverse(self, p: ArrayLike) -> list[Array]:
        """All configurations of a two-link arm that put its tip at p (inverse kinematics).

        Returns
        -------
        list of arrays (2,), angles in [-pi, pi). Inside the reachable ring there are two: first the
        one whose elbow lies to the right of the line from base to tip, then the one whose elbow
        lies to its left. On the rims of the ring there is one; outside there is none, and
        `why_unreachable` gives the reason.

        Raises
        ------
        InvalidPoint
            Where p is the base of an arm with two equal links: there every angle of link 1 is a
            solution.
        InvalidRobot
            Where the arm does not have two links.

        Examples
        --------
        >>> arm = TwoLinkArm(2, 1, 0.2)
        >>> [q.round(6).tolist() for q in arm.inverse((2, 1))]
        [[0.0, 1.570796], [0.927295, -1.570796]]
        >>> arm.inverse((3, 0)), arm.inverse((4, 0))
        ([array([0., 0.])], [])
        """
        l1, l2, x, y, far = two_links(self, p)
        if far == 0.0 and l1 == l2:
            raise InvalidPoint(
                "at its base an arm of two equal links has infinitely many solutions: q = (any "
                "angle, -pi)"
            )
        return list(solve_two_links(l1, l2, x, y))


class TwoLinkArm(ArmRobot, metaclass=Constructor):
    """An arm of two links, with configuration q = (angle of link 1, angle of link 2 from link 1).

    Parameters
    ----------
    l1, l2 : the lengths between the joints, in the world's unit. Angles are in radians.
    width : each link is a bar with rounded ends: all points within width / 2 of the segment between
        its joints. 0 makes it a segment.
    base : the position of the first joint.

    Returns
    -------
    ArmRobot

    Raises
    ------
    InvalidRobot
        Where a length is not positive or the width is negative.
    InvalidPoint
        Where a value is not a finite number.

    Examples
    --------
    >>> TwoLinkArm(1.5, 1.2, 0.2).shape.radius
    array([0.1, 0.1])
    """

    @classmethod
    def _makes(cls, thing: ArmRobot) -> bool:
        """Whether this class could have made the record."""
        return len(thing.lengths) == 2

    def __new__(  # type: ignore[misc]  # returns the record
        cls, l1: float, l2: float, width: float, *, base: ArrayLike = (0.0, 0.0)
    ) -> ArmRobot:
        if any(isinstance(size, bool | np.bool_) for size in (l1, l2, width)):
            raise InvalidRobot(
                f"an arm's sizes must be numbers, got {shortened(l1)}, {shortened(l2)} and "
                f"{shortened(width)}"
            )
        return ArmChain([l1, l2], width, base=base)


class ArmChain(ArmRobot, metaclass=Constructor):
    """An arm with any number of links; otherwise as `TwoLinkArm`.

    Parameters
    ----------
    lengths : (n,), the length of each link. Joint i is at the beginning of link i.
    width, base : as for `TwoLinkArm`.

    Returns
    -------
    ArmRobot

    Raises
    ------
    InvalidRobot, InvalidPoint
        As for `TwoLinkArm`.
    """

    def __new__(cls, lengths: ArrayLike, width: float, *, base: ArrayLike = (0.0, 0.0)) -> ArmRobot:  # type: ignore[misc]  # returns the record
        sizes, across = as_array(lengths, "the links' lengths"), as_array(width, "width")
        if sizes.ndim != 1 or len(sizes) == 0 or (sizes <= 0.0).any():
            raise InvalidRobot(
                f"an arm's links must have positive lengths, got {shortened(lengths)}"
            )
        if across.ndim or across < 0.0:
            raise InvalidRobot(
                f"an arm's width must be one length, zero or more, got {shortened(width)}"
            )
        links = make_parts(
            [np.array([(0.0, 0.0), (size, 0.0)]) for size in sizes],
            [float(across) / 2.0] * len(sizes),
        )
        return ArmRobot(sizes, as_point(base, "base"), links)


IN_REACH, TOO_FAR, TOO_NEAR = range(3)


@compiled
def compare_reach(l1: float, l2: float, far: float) -> int:
    """IN_REACH, TOO_FAR or TOO_NEAR: a place at the distance `far` from the base of two links."""
    if far > (l1 + l2) * (1.0 + RIM):
        return TOO_FAR
    return TOO_NEAR if far < abs(l1 - l2) - RIM * (l1 + l2) else IN_REACH


@compiled
def solve_two_links(l1: float, l2: float, x: float, y: float) -> Array:
    """The solutions of `ArmRobot.inverse` for a tip at (x, y) from the base, (k, 2)."""
    reach, heading, far = l1 + l2, math.atan2(y, x), length(x, y)
    if compare_reach(l1, l2, far) != IN_REACH:
        return np.empty((0, 2))
    if far >= reach * (1.0 - RIM):
        return np.array([wrap_angle(heading), 0.0]).reshape(1, 2)
    if far <= abs(l1 - l2) + RIM * reach and l1 != l2:
        folded = wrap_angle(heading if l1 > l2 else heading + math.pi)
        return np.array([folded, -math.pi]).reshape(1, 2)
    # half-angle formulas of the triangle base, elbow, tip: the tangents are accurate near the rims,
    # where cosines are not
    elbow = 2.0 * math.atan2(
        math.sqrt((reach - far) * (reach + far)), math.sqrt((far - l1 + l2) * (far + l1 - l2))
    )
    lead = 2.0 * math.atan2(
        math.sqrt((reach - far) * (l2 + far - l1)), math.sqrt((far + l1 - l2) * (far + reach))
    )
    angles = (heading - lead, elbow, heading + lead, -elbow)
    return np.array([wrap_angle(angle) for angle in angles]).reshape(2, 2)


WHY_UNREACHABLE = (
    "",
    "it is {far} from the base, and the links together reach only {outer}",
    "it is {far} from the base, and folded up the arm still reaches {inner} away",
)


def why_unreachable(arm: ArmRobot, p: ArrayLike) -> str:
    """Explain why the tip of a two-link arm cannot reach p.

    Returns
    -------
    str, empty where the tip can reach p.

    Raises
    ------
    InvalidPoint
        Where p is not a point.
    InvalidRobot
        Where `arm` is not an arm of two links.

    Examples
    --------
    >>> why_unreachable(TwoLinkArm(2, 1, 0.2), (4, 0))
    'it is 4 from the base, and the links together reach only 3'
    """
    l1, l2, _, _, far = two_links(arm, p)
    distance, inner, outer = distinct_numbers(far, abs(l1 - l2), l1 + l2)
    why = WHY_UNREACHABLE[compare_reach(l1, l2, far)]
    return why.format(far=distance, inner=inner, outer=outer)


def check_arm(arm: object) -> None:
    """Raise InvalidRobot where the argument is not an arm."""
    if not isinstance(arm, ArmRobot):
        raise InvalidRobot(
            f"expected an arm such as TwoLinkArm(1.5, 1.2, 0.2), got {shortened(arm)}"
        )


def two_links(arm: ArmRobot, p: ArrayLike) -> tuple[float, float, float, float, float]:
    """The lengths of both links, and a target relative to the base: x, y and its distance."""
    check_arm(arm)
    if len(arm.lengths) != 2:
        raise InvalidRobot(
            f"inverse kinematics is for an arm of two links, this one has {len(arm.lengths)}"
        )
    (l1, l2), (x, y) = arm.lengths.tolist(), (as_point(p, "p") - arm.base).tolist()
    return l1, l2, x, y, length(x, y)


@compiled
def joints_at(lengths: Array, base: Array, q: Array, ends: Array) -> None:
    """Write the joints into ends, shape (n + 1, 2): the base first, the tip last."""
    ends[0] = base
    angle = 0.0
    for i in range(len(lengths)):
        angle += q[i]
        ends[i + 1, 0] = ends[i, 0] + lengths[i] * math.cos(angle)
        ends[i + 1, 1] = ends[i, 1] + lengths[i] * math.sin(angle)
